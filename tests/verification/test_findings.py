"""Findings: what is said, in words for each audience and as data."""

import json
import re
from pathlib import Path
from string import Formatter

import pytest

import armproof.course
import armproof.verification
from armproof.models.catalogue import load_arm
from armproof.models.errors import Fault, ModelError
from armproof.verification.errors import EvaluationError, UnboundName
from armproof.verification.findings import Finding, Kind, finding_of, say
from armproof.verification.findings.finding import Audience, Piece, pieces, write, write_all


def test_every_template_can_be_written() -> None:
    """Marks come in pairs, fields are names of terms, and a kind's name is that of the report."""
    for kind in Kind:
        for template in (kind.template, kind.student or ""):
            assert template.count("`") % 2 == 0 and template.count("$") % 2 == 0
            assert all(name is None or name.isidentifier() for _, name, _, _ in Formatter().parse(template))
        assert kind.value == kind.name.lower()


def test_a_finding_in_an_entry_says_where() -> None:
    wrong = say(Kind.WRONG_ENTRY, printed="S_1", correct="-S_1").at(1, 2, 3)
    assert str(wrong) == "entry (2, 3): is S_1, should be -S_1"
    assert list(pieces(wrong))[2] == ("S_1", Piece.LATEX)
    assert write(wrong, Audience.STUDENT) == "" and not wrong.is_told


def test_a_finding_within_a_finding_is_written_and_kept_as_data() -> None:
    both = say(Kind.ALONE, cause=say(Kind.SWAPPED_LENGTHS, one="l_1", other="l_2"), place=say(Kind.THE_ORIGIN))
    assert str(both) == "lengths l_1 and l_2 are swapped, in the origin alone"
    assert ("l_1", Piece.NAME) in pieces(both)
    assert json.loads(json.dumps(both.as_json()))["terms"]["cause"]["kind"] == "swapped_lengths"


def test_what_is_said_twice_is_written_once() -> None:
    one, other = say(Kind.NOT_BOUND, name="a").at(1), say(Kind.NOT_BOUND, name="a").at(2)
    assert write_all([one, other, say(Kind.WRONG_SIGN)]) == "'a' is not bound; wrong sign"
    assert one.holds(other) and one != other and not one.holds(say(Kind.NOT_BOUND, name="b"))


def test_an_error_carries_its_finding() -> None:
    assert finding_of(UnboundName("x")) == say(Kind.NOT_BOUND, name="x")
    assert finding_of(EvaluationError("no value")) == Finding(Kind.NOT_EVALUATED, {"reason": "no value"})
    assert str(UnboundName("x", "why")) == "'x' is not bound: why"


def test_an_error_of_the_models_becomes_a_finding() -> None:
    with pytest.raises(ModelError) as caught:
        load_arm({"dh": "classic", "rows": [{"theta": "q_1 +", "d": 0, "a": "l_1", "alpha": 0}], "joints": ["q_1"]})
    finding = finding_of(caught.value)
    assert finding.kind is Fault.IN_TABLE and finding.terms["reason"].kind is Fault.ENTRY_UNREADABLE
    assert str(finding) == str(caught.value)
    assert json.loads(json.dumps(finding.as_json()))["terms"]["reason"]["terms"]["text"] == "q_1 +"
    assert not {kind.value for kind in Kind} & {fault.value for fault in Fault}


def test_braces_and_marks_in_terms_are_left_alone() -> None:
    assert str(say(Kind.NOT_BOUND, name="{}^0T_{4}`$")) == "'{}^0T_{4}`$' is not bound"


def test_every_kind_is_said_somewhere() -> None:
    """A kind that nothing says is dead; the check itself sees one that is missing."""
    rooms = [Path(room.__path__[0]) for room in (armproof.course, armproof.verification)]
    texts = [file.read_text() for room in rooms for file in room.rglob("*.py") if file.name != "kinds.py"]
    said = {name for text in texts for name in re.findall(r"\bKind\.([A-Z][A-Z0-9_]*)", text)}
    assert not {kind.name for kind in Kind} - said
    assert "NO_SUCH_KIND_AT_ALL" not in said
