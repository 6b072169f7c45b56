"""Every sentence is replaced by the name of its kind, as a translation would: nothing but the words may change."""

from __future__ import annotations

import re
from dataclasses import replace
from pathlib import Path
from typing import Any

import pytest

import armproof.course
from armproof.course.feedback.lesson import lessons
from armproof.course.feedback.outcome import Feedback
from armproof.verification.check import verify
from armproof.verification.findings import Kind, finding
from tests.laws import SWEEP

DOCUMENTS = sorted(
    path for path in (Path(armproof.course.__path__[0]) / "handouts").glob("*.md") if "Erratum" in path.read_text()
)
ANSWERED = ("scara_jacobian", *(["dh_conventions"] if SWEEP else []))  # lessons whose wrong answers are judged
NAMES = {kind.template: f"<{kind.value}>" for kind in Kind} | {kind.student: "" for kind in Kind if kind.student == ""}
ENGLISH = re.compile(r"\b(?:wrong|should|missing|swapped|printed)\b")


def replaced(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(finding, "look_up", lambda sentence: NAMES.get(sentence, ""))


def checked(path: Path) -> dict[str, Any]:
    """Return the JSON of a document, its sentences apart."""
    written = verify(path, confirm=False).as_json()
    said = []
    inverse = [written["inverse"]] if "inverse" in written else []
    for record in [*written["equations"], *written.get("tables", []), *inverse]:
        said.append(record.pop("message"))
        said += [entry.pop("change") for entry in record["entries"] if "change" in entry]
    return {"said": said, "decided": written}


@pytest.mark.parametrize("path", DOCUMENTS, ids=[path.stem for path in DOCUMENTS])
def test_no_verdict_rests_on_words(path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    before = checked(path)
    replaced(monkeypatch)
    after = checked(path)
    assert after["decided"] == before["decided"]
    assert any(ENGLISH.search(text) for text in before["said"])
    assert all(text == "" or text.startswith("<") for text in after["said"])


def judged(name: str) -> list[Feedback]:
    """Return the feedback on the right and the known wrong answers of a lesson's tasks."""
    (lesson,) = (lesson for lesson in lessons() if lesson.name == name)
    answers = [(task, answer) for task in lesson.tasks for answer in task.right]
    answers += [(task, wrong.answer) for task in lesson.tasks for wrong in task.wrong]
    return [replace(task.check(answer), message="", seconds=0.0) for task, answer in answers]


@pytest.mark.parametrize("name", ANSWERED)
def test_no_feedback_rests_on_words(name: str, monkeypatch: pytest.MonkeyPatch) -> None:
    before = [each.as_json() | {"findings": each.findings} for each in judged(name)]
    replaced(monkeypatch)
    assert [each.as_json() | {"findings": each.findings} for each in judged(name)] == before
    assert {each["outcome"] for each in before} >= {"correct (proved)", "wrong"}


def test_what_rests_on_words_is_found(monkeypatch: pytest.MonkeyPatch) -> None:
    """The negative control: a reader of sentences sees the difference."""
    wrong = finding.say(Kind.WRONG_SIGN)
    assert "sign" in str(wrong)
    replaced(monkeypatch)
    assert str(wrong) == "<wrong_sign>" and "wrong sign" not in str(wrong)
