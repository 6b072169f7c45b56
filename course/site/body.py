"""The body of a lesson's page, cell by cell."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from markupsafe import Markup

from armproof.course.feedback import Lesson, Outcome, Quantity, Task
from armproof.course.sheet import model as s
from armproof.course.site.cells import Cell, Output
from armproof.course.site.moving import moving_figure
from armproof.course.site.outputs import show_outputs
from armproof.course.site.reading import LessonReader
from armproof.course.site.writer import Entry, PageWriter, python
from armproof.models.errors import written
from armproof.models.language import look_up

NOTHING = Markup("")


class BodyWriter:
    """Writes the cells of one lesson.

    `contents` collects the headings, `styles` what the outputs bring along; `says_objectives` tells that the text before
    the lesson is opened lists the objectives, so that the page need not.
    """

    def __init__(self, lesson: Lesson, reader: LessonReader, *, solutions: bool) -> None:
        self.lesson = lesson
        self.reader = reader
        self.solutions = solutions
        self.styles: list[str] = []
        self._writer = PageWriter()
        self._tasks = {task.name: (number, task) for number, task in enumerate(lesson.tasks, 1)}
        self._asked: set[str] = set()
        self._titled = self._opened = False
        self._heading = ""
        self.says_objectives = False

    @property
    def contents(self) -> list[Entry]:
        """The headings of the page, in their order."""
        return self._writer.contents

    def write(self, cells: Sequence[Cell]) -> Markup:
        """Return the cells as HTML."""
        parts = [self._cell(cell) for cell in cells if cell.kind in ("markdown", "code")]
        return Markup("\n").join(part for part in parts if part)

    def inline(self, text: str) -> Markup:
        """Return a line of Markdown as HTML, without a paragraph around it."""
        blocks = self.reader.text(text)
        parts = [part for block in blocks if isinstance(block, s.Paragraph) for part in block.parts]
        return self._writer.words(tuple(parts))

    def _cell(self, cell: Cell) -> Markup:
        if cell.kind == "markdown":
            return self._writer.body(tuple(self._without_title(self.reader.cell(cell))))
        checked = [self._tasks[name] for name in cell.calls("check") if name in self._tasks]
        new = [(number, task) for number, task in checked if task.name not in self._asked]
        self._asked.update(task.name for _, task in new)
        if not new:
            return self._code(cell)
        hints = Markup("").join(self._hints(task) for _, task in new)
        questions = Markup("").join(self._question(number, task) for number, task in new)
        label = ", ".join(written("Task {number}", number=number) for number, _ in new)
        title = Markup("{} – {}").format(label, Markup(", ").join(self.inline(task.title) for _, task in new))
        anchor = self._writer.section(f"task-{new[0][0]}", title)
        return Markup('<section class="task" id="{}" aria-label="{}">{}{}</section>').format(
            anchor, label, questions, self._code(cell, hints)
        )

    def _without_title(self, blocks: Sequence[s.Block]) -> Iterator[s.Block]:
        """Yield blocks without the first heading of level 1, which the page has at its head."""
        for block in blocks:
            if isinstance(block, s.Listing) and not self._opened and len(block.items) == len(self.lesson.objectives):
                self.says_objectives = True
            if isinstance(block, s.Heading):
                self._heading = s.plain(block.parts)
                if block.level == 1 and not self._titled:
                    self._titled = True
                    continue
            yield block

    # -- code -------------------------------------------------------------------------------------------------------

    def _code(self, cell: Cell, hints: Markup = NOTHING) -> Markup:
        """Return a code cell and what running it gave; the solution, and what it gave, folded behind the hints."""
        shown = self._outputs(cell)
        solved = python(cell.solved, look_up("Solution")) if self.solutions and cell.has_solution else Markup("")
        if (solved or shown) and self.solutions and (solved or cell.calls("check") or cell.calls("show")):
            label = look_up("Solution") if solved else look_up("With the solution")
            shown = Markup('{}<details class="solution"><summary>{}</summary>{}{}</details>').format(
                hints, label, solved, shown
            )
        else:
            shown += hints
        return Markup('<div class="cell">{}{}</div>').format(python(cell.source), shown)

    def _outputs(self, cell: Cell) -> Markup:
        if cell.opens():  # the page says at its head what this cell shows
            self._opened = True
            return Markup("")
        if asked := [self._tasks[name][1].asks for name in cell.calls("move") if name in self._tasks]:
            moved = [each for each in asked if isinstance(each, Quantity)]
            return Markup("").join(moving_figure(each, f"c{cell.number}-{k}-") for k, each in enumerate(moved))
        outputs = [output for output in cell.outputs if self.solutions or not _is_waiting(cell, output)]
        shown = show_outputs(outputs, f"c{cell.number}-", self._words(), self._markdown)
        self.styles += [style for style in shown.styles if style not in self.styles]
        return Markup('<div class="output">{}</div>').format(shown.html) if shown.html else Markup("")

    def _words(self) -> str:
        """Return what a picture without words of its own is called."""
        return written("Figure: {heading}", heading=self._heading) if self._heading else look_up("Figure")

    def _markdown(self, text: str) -> Markup:
        return self._writer.body(self.reader.text(text))

    # -- tasks ------------------------------------------------------------------------------------------------------

    def _question(self, number: int, task: Task) -> Markup:
        place = written("Task {number} of {count}", number=number, count=len(self.lesson.tasks))
        head = Markup('<p class="task-head"><span>{}</span> <strong>{}</strong></p>').format(
            place, self.inline(task.title)
        )
        return head + Markup('<div class="question">{}</div>').format(self._markdown(task.text))

    def _hints(self, task: Task) -> Markup:
        """Return the ladder of hints, each folded into the one before it."""
        inside = Markup("")
        total = len(task.hints)
        for number in range(total, 0, -1):
            label = written("Hint {number} of {count}", number=number, count=total) if total > 1 else look_up("Hint")
            inside = Markup('<details class="hint"><summary>{}</summary>{}{}</details>').format(
                label, self._markdown(task.hints[number - 1]), inside
            )
        return inside


def _is_waiting(cell: Cell, output: Output) -> bool:
    """Whether an output only says that there is no answer yet: a check that does, or the words of a picture not drawn."""
    data = output.get("data", {})
    if cell.calls("show") and "text/markdown" in data:
        return True
    text = data.get("text/plain", "")
    return bool(cell.calls("check")) and Outcome.NOT_ATTEMPTED.words in (
        text if isinstance(text, str) else "".join(text)
    )
