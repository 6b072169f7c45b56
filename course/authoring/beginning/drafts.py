"""A task in the making: what is asked, its right answers from the exact trace, and slips as its wrong ones."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import dataclass, replace
from typing import TYPE_CHECKING, Any

from armproof.course.authoring.beginning.exact_text import ExactText, write_quantity
from armproof.course.authoring.beginning.python_text import written
from armproof.course.authoring.beginning.slips import slips
from armproof.course.authoring.checking.answers import progress_left_alone
from armproof.models.arm import Arm
from armproof.models.errors import written as sentence
from armproof.verification.naming.quantities import numbered_frames

if TYPE_CHECKING:
    from armproof.course.feedback import Feedback, Formula, Quantity, Task

WRONG = 4
TRIED = 24  # slips, until there are enough that get words of their own
LONGEST_FORM = 600  # characters: a form beside others is longer than that for nobody's good
LONGEST_POSE = 260  # characters: a longer one is asked for its origin alone


@dataclass(frozen=True)
class Draft:
    """A task before it is written into a module.

    Attributes:
        name, title, text: as in the task.
        asks: what it asks, and `asks_text`, the Python that says so.
        latex: the right answer as it is shown; `others` in other forms.
        exact: the same as Python, where it can be written.
        wrong: wrong answers in LaTeX, and what the feedback says of each.
    """

    name: str
    title: str
    text: str
    asks: Quantity | Formula
    asks_text: str
    latex: str
    others: tuple[str, ...] = ()
    exact: ExactText | None = None
    wrong: tuple[tuple[str, str], ...] = ()

    @property
    def topic(self) -> str:
        """The title within a sentence."""
        return f"{self.title[0].lower()}{self.title[1:]}"

    @property
    def has_function(self) -> bool:
        """Whether the answer is also written as a Python function of q."""
        return self.exact is not None and self.exact.python is not None


def drafts_of_arm(arm: Arm, spec: Any) -> list[Draft]:
    """Return a task on the forward kinematics and one on the Jacobian of an arm; `spec` is how it is named."""
    name = numbered_frames(arm)[-1]
    last = int(name) if name.isdigit() else name
    pose = write_quantity(arm, {"pose": last})
    if pose is not None and len(pose.latex) <= LONGEST_POSE:
        title, asked = sentence("Forward kinematics"), {"pose": last}
        text = sentence(
            "Give the pose {pose} of frame {frame} in frame 0, a 4 × 4 matrix.", pose=f"${{}}^0T_{last}$", frame=last
        )
    else:
        title, asked = sentence("The position of the tool"), {"origin": last}
        text = sentence("Give the origin {origin} of frame {frame} in frame 0.", origin=f"$p_{last}$", frame=last)
    forward = draft_of_quantity(arm, spec, asked, next(iter(asked)), title, text)
    text = sentence(
        "Give the geometric Jacobian of frame {frame} in frame 0, rows {rows}.", frame=last, rows="$[v;\\ \\omega]$"
    )
    jacobian = draft_of_quantity(arm, spec, {"jacobian": last}, "jacobian", sentence("The geometric Jacobian"), text)
    return [draft for draft in (forward, jacobian) if draft is not None]


def draft_of_quantity(
    arm: Arm, spec: Any, asked: Mapping[str, Any], name: str, title: str, text: str, printed: str = "", **front: Any
) -> Draft | None:
    """Return a task that asks for a quantity of an arm; None where it is too long to be typed.

    Args:
        printed: the right answer as a document prints it.
        front: `symbols` and `transforms` of the document.
    """
    from armproof.course.feedback import Quantity

    exact = write_quantity(arm, asked)
    if exact is None:
        return None
    said = "".join(f", {key}={written(value)}" for key, value in front.items() if value)
    question = Quantity(spec, dict(asked), **front)
    long = exact.expanded_latex if len(exact.expanded_latex) <= LONGEST_FORM or exact.python is None else ""
    forms = dict.fromkeys(form for form in (printed, exact.latex, long) if form)
    first, *others = forms
    draft = Draft(name, title, text, question, f"Quantity(ARM, {written(asked)}{said})", first, tuple(others), exact)
    return completed(draft, arm)


def completed(draft: Draft, arm: Arm) -> Draft | None:
    """Return a draft with those of its other forms that are accepted and with wrong answers; None if it is not proved itself."""
    from armproof.course.feedback import Outcome

    task = as_task(draft)
    with progress_left_alone():
        if task.check(draft.latex).outcome is not Outcome.PROVED:
            return None
        others = tuple(form for form in draft.others if task.check(form).outcome is Outcome.PROVED)
        return replace(draft, others=others, wrong=tuple(_wrong_answers(task, draft, arm)))


def as_task(draft: Draft) -> Task:
    """Return the task that a draft stands for, without hints and answers."""
    from armproof.course.feedback import Task

    return Task(draft.name, draft.title, draft.text, draft.asks, (), (draft.latex, *draft.others))


def _wrong_answers(task: Task, draft: Draft, arm: Arm) -> Iterator[tuple[str, str]]:
    """Yield slips in the right answer and what is said of them, those with a sentence of their own first."""
    from armproof.course.feedback import Outcome

    found: dict[str, Feedback] = {}
    for number, latex in enumerate(slips(draft.latex, arm)):
        if number >= TRIED or sum(not feedback.is_general for feedback in found.values()) >= WRONG:
            break
        feedback = task.check(latex)
        said = {feedback.message for feedback in found.values()}
        if feedback.outcome is Outcome.WRONG and feedback.message and feedback.message not in said:
            found[latex] = feedback
    own_first = sorted(found.items(), key=lambda item: item[1].is_general)
    yield from ((latex, feedback.message) for latex, feedback in own_first[:WRONG])
