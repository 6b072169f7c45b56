"""One line against a definition: which of the two is wrong, and where nobody knows."""

from __future__ import annotations

import pytest

from armproof import verify_text
from armproof.verification.check import display_checker, slips

HEAD = "---\narm: planar_2r\nquantities: {P_x: {origin: 2, component: x}}\n---\n\n"
LINE = "$$ P_x = u c_1 - l_2 s_1 s_2 $$\n\n"


def verdicts(*displays: str) -> list[str]:
    return [record.verdict.value for record in verify_text(HEAD + "\n\n".join(displays)).equations]


def test_a_definition_is_refuted_that_one_line_alone_contradicts_where_only_a_slip_in_it_explains_that() -> None:
    assert verdicts("$$ u = l_1 + l_2 s_2 $$", LINE) == ["refuted", "unchecked"]
    [wrong] = verify_text(HEAD + "$$ u = l_1 + l_2 s_2 $$\n\n" + LINE).equations[0].entries
    assert (wrong.printed, wrong.correct) == ("l_1 + l_2 s_2", "l_1 + l_2 c_2")


@pytest.mark.parametrize("line", ["P_x = u c_1 + l_2 s_1 s_2", "P_x = u s_1 - l_2 s_1 s_2", "P_x = u c_1 - l_2 s_1"])
def test_the_line_is_wrong_where_the_definition_is_right(line: str) -> None:
    assert verdicts("$$ u = l_1 + l_2 c_2 $$", f"$$ {line} $$")[0] != "refuted"


def test_a_slip_in_the_line_may_explain_it_as_well() -> None:
    assert verdicts("$$ v = -l_2 s_2 $$", "$$ P_x = (l_1 + l_2 c_2) c_1 - v s_1 $$") == ["unchecked", "unchecked"]


def test_so_may_a_slip_in_another_definition() -> None:
    both = ["$$ u = l_1 c_2 $$", "$$ v = l_2 s_2 $$", "$$ u + v = l_1 c_2 + l_2 c_2 $$"]
    assert "refuted" not in verdicts(*both)[:1]


def test_under_another_heading_it_may_be_another_one() -> None:
    assert verdicts("$$ u = l_1 + l_2 s_2 $$", "## Next", LINE) == ["unchecked", "unchecked"]


def test_a_case_is_no_witness_against_what_holds_in_general() -> None:
    general = "$$ u = l_1 \\cos\\beta + l_2 \\cos(\\beta + \\gamma) $$"
    assert verdicts(general, "$$ u = (l_1 + l_2) \\cos\\beta $$")[0] != "refuted"


def test_how_long_a_slip_is_sought_is_counted_so_that_no_load_changes_a_verdict(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    both = ("$$ u = l_1 + l_2 s_2 $$", LINE)
    for module in (display_checker, slips):
        monkeypatch.setattr(module, "SECONDS_TO_EXPLAIN", -1.0)  # what is said of a wrong entry may take no time
    assert verdicts(*both) == ["refuted", "unchecked"]
    monkeypatch.setattr(slips, "WORK_ON_SLIPS", 20)
    assert verdicts(*both) == ["unchecked", "unchecked"]
