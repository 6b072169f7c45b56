"""Documents as tests: one an equation, named by its place, failing with the report's words."""

from __future__ import annotations

import json
import subprocess
import sys
import xml.etree.ElementTree as ElementTree
from importlib.metadata import entry_points

import pytest

pytest_plugins = ["pytester"]

FRONT = "---\narm: planar_2r\nquantities:\n  J_v: {jacobian: 2, rows: [1, 2]}\n---\n\n"
RIGHT = r"$$ p_2 = \begin{bmatrix} l_1 C_1 + l_2 C_{12} \\ l_1 S_1 + l_2 S_{12} \\ 0 \end{bmatrix} $$" + "\n\n"
WRONG = r"$$ \det J_v = l_1 l_2 \cos\theta_2 $$" + "\n\n"
ERRATUM = "> **Erratum**\n> $$ C_{12} = S_{12} $$\n\n"
UNBOUND = "$$ C_{12} = k_9 + k_8 $$\n\n"
TABLE = "| i | a | alpha | d | theta |\n|---|---|---|---|---|\n| 1 | $l_1$ | 0 | 0 | $\\theta_1$ |\n| 2 | 0 | 0 | 0 | $\\theta_2$ |\n\n"
OTHER = "| name | price |\n|---|---|\n| a | 3 |\n\n"
INSTALLED = any(entry.value == "armproof.verification.pytest_plugin" for entry in entry_points(group="pytest11"))


@pytest.fixture
def run(pytester: pytest.Pytester):
    """Run pytest in the folder of the documents."""

    def in_process(*arguments: str) -> pytest.RunResult:
        plugin = () if INSTALLED else ("-p", "armproof.verification.pytest_plugin")
        return pytester.runpytest_inprocess(*plugin, "-p", "no:cacheprovider", *arguments)

    return in_process


def write(pytester: pytest.Pytester, **documents: str) -> None:
    for name, text in documents.items():
        stem, _, suffix = name.rpartition("_")
        (pytester.path / f"{stem}.{suffix}").write_text(text, encoding="utf-8")


def test_every_equation_is_one_test_named_by_its_place(pytester: pytest.Pytester, run) -> None:
    notebook = {
        "cells": [{"cell_type": "markdown", "source": FRONT}, {"cell_type": "markdown", "source": RIGHT + RIGHT}]
    }
    tex = "% arm: planar_2r\n\\[ C_1 = C_1 \\] \\[ S_1 = S_1 \\]\n"
    write(pytester, page_md=FRONT + RIGHT + ERRATUM, lesson_ipynb=json.dumps(notebook), sheet_tex=tex)
    result = run("--collect-only", "-q")
    assert [line for line in result.outlines if "::" in line] == [
        "lesson.ipynb::lesson.ipynb:1:1",
        "lesson.ipynb::lesson.ipynb:1:3",
        "page.md::page.md:7",
        "page.md::page.md:10",
        "sheet.tex::sheet.tex:2",
        "sheet.tex::sheet.tex:2#2",
    ]
    run().assert_outcomes(passed=6)


def test_a_wrong_equation_fails_with_the_words_of_the_report(pytester: pytest.Pytester, run) -> None:
    write(pytester, page_md=FRONT + RIGHT + WRONG)
    result = run("-v")
    result.assert_outcomes(passed=1, failed=1)
    result.stdout.fnmatch_lines(["page.md::page.md:7 PASSED*", "page.md::page.md:9 FAILED*"])
    result.stdout.fnmatch_lines(
        ["line 9  refuted", "    cosine for sine", "    printed  l_1 l_2 \\cos*theta_2", "    correct  l_1 l_2 \\sin*theta_2", "    for example at *"]
    )  # fmt: skip
    assert "Traceback" not in result.stdout.str() and "def runtest" not in result.stdout.str()


def test_a_table_is_a_test_and_one_of_other_things_is_skipped(pytester: pytest.Pytester, run) -> None:
    write(pytester, page_md=FRONT + TABLE + OTHER)
    result = run()
    result.assert_outcomes(failed=1, skipped=1)
    result.stdout.fnmatch_lines(["line 7  table refuted", "    row 2: a is 0, should be l_2*"])


def test_only_documents_with_our_front_matter_are_collected_unless_they_are_named(
    pytester: pytest.Pytester, run
) -> None:
    foreign = "---\ntitle: A page\nauthor: me\n---\n\n$$ 1 = 2 $$\n"
    write(
        pytester,
        README_md="# Read me\n\n$$ 1 = 2 $$\n",
        page_md=foreign,
        code_py="x = {'arm:': 1}\n",
        paper_tex="\\[ 1 = 2 \\]",
    )
    run().assert_outcomes()
    run("README.md", "paper.tex").assert_outcomes(failed=2)


def test_a_lesson_is_collected_by_its_front_matter(pytester: pytest.Pytester, run) -> None:
    lesson = "# %% [markdown]\n" + "".join(f"# {line}".rstrip() + "\n" for line in (FRONT + RIGHT).splitlines())
    write(pytester, lesson_py=lesson)
    run().assert_outcomes(passed=1)


def test_the_settings_switch_it_off_and_make_it_strict(pytester: pytest.Pytester, run) -> None:
    write(pytester, page_md=FRONT + RIGHT + UNBOUND)
    run().assert_outcomes(passed=2)
    run("-o", "armproof_strict=true").assert_outcomes(passed=1, failed=1)
    run("-o", "armproof=false").assert_outcomes()


def test_a_document_that_cannot_be_checked_fails_with_its_message(pytester: pytest.Pytester, run) -> None:
    write(
        pytester,
        arm_md="---\narm: skara\n---\n$$ 1 = 1 $$\n",
        key_md="---\narm: scara\ntransforms: up\n---\n$$ 1 = 1 $$\n",
    )
    result = run()
    result.assert_outcomes(failed=2)
    result.stdout.fnmatch_lines(["*arm.md:2: no arm 'skara'*", "*key.md:3: 'transforms' must be upper or lower*"])
    assert "Traceback" not in result.stdout.str()


def test_a_document_is_verified_once(pytester: pytest.Pytester, run, monkeypatch: pytest.MonkeyPatch) -> None:
    import armproof.verification.check

    verified = []
    check = armproof.verification.check.check_document
    spy = lambda document: verified.append(document.path.name) or check(document)  # noqa: E731
    monkeypatch.setattr(armproof.verification.check, "check_document", spy)
    write(pytester, a_md=FRONT + RIGHT + RIGHT + WRONG, b_md=FRONT + RIGHT)
    run().assert_outcomes(passed=3, failed=1)
    assert verified == ["a.md", "b.md"]


def test_the_choice_of_tests_and_the_junit_report_are_those_of_pytest(pytester: pytest.Pytester, run) -> None:
    write(pytester, a_md=FRONT + RIGHT + WRONG + WRONG)
    run("-k", "a.md:7").assert_outcomes(passed=1, deselected=2)
    run("-x").assert_outcomes(passed=1, failed=1)
    run("a.md::a.md:9", "--junitxml=out.xml").assert_outcomes(failed=1)
    [case] = ElementTree.parse(pytester.path / "out.xml").iter("testcase")
    assert (case.get("classname"), case.get("name")) == ("a.md", "a.md:9")
    failure = case.find("failure")
    assert failure is not None and "cosine for sine" in str(failure.text)
    assert [(p.get("name"), p.get("value")) for p in case.iter("property")] == [("verdict", "refuted")]


def test_the_plugin_loads_nothing_heavy_before_there_is_a_document() -> None:
    heavy = "{'pydrake', 'numpy', 'lark', 'yaml', 'flint', 'markdown_it'}"
    program = f"import sys, armproof.verification.pytest_plugin; print(sorted({heavy} & set(sys.modules)))"
    run = subprocess.run([sys.executable, "-c", program], capture_output=True, text=True, timeout=60)
    assert run.stdout == "[]\n", run.stderr


def test_the_suffixes_are_those_of_the_documents() -> None:
    from armproof.verification.document import SUFFIXES
    from armproof.verification.pytest_plugin import SUFFIXES as OURS

    assert set(OURS) == set(SUFFIXES)
