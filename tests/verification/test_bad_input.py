"""Bad input: one clear message with file and line, exit code 2 or an `unreadable` verdict, nothing executed, no hang."""

import ast
import json
import os
import re
import time
from collections.abc import Callable, Iterator
from dataclasses import dataclass
from pathlib import Path

import pytest
from hypothesis import example, given
from hypothesis import strategies as st

from armproof.models.catalogue import arm_names
from armproof.verification.cli import app
from armproof.verification.errors import ReadError
from armproof.verification.latex.reader import Reader
from tests.forked import armproof
from tests.laws import SWEEP, examples
from tests.sources import nodes_in

ROOT = Path(__file__).resolve().parents[2]
ARMS = ", ".join(arm_names())
SECONDS = 4.0  # of the processor: the bound of 2 s a display, and some air for what stands around it
WORK = 0.10  # seconds of the processor that `work` takes where the bound was set
FINE = "$$ 1 = 1 $$\n\n"


@dataclass(frozen=True)
class Run:
    """What the command did with a document."""

    code: int
    stdout: str
    stderr: str
    seconds: float


def work() -> float:
    """Return the seconds of the processor that a fixed piece of work takes now: the measure of a slow machine."""
    started = time.process_time()
    assert len({re.sub(r"\d\b", "", f"{number} {number % 97}") for number in range(50_000)}) > 1_000
    return time.process_time() - started


def is_in_time(seconds: float) -> bool:
    """Whether what was done keeps the bound; on a machine that works more slowly, by so much more."""
    return seconds < SECONDS or seconds < SECONDS * sorted(work() for _ in range(5))[2] / WORK


@pytest.fixture(scope="module", autouse=True)
def loaded(tmp_path_factory: pytest.TempPathFactory) -> None:
    """Load what verifies before any time is taken."""
    with pytest.raises(SystemExit):
        app(["verify", str(write(tmp_path_factory.mktemp("loaded"), "arm: scara"))], prog_name="armproof")


@pytest.fixture
def verify(capsys: pytest.CaptureFixture[str]) -> Callable[..., Run]:
    """Verify a path in this process."""

    def run(path: Path, *options: str) -> Run:
        started = time.process_time()
        with pytest.raises(SystemExit) as end:
            app(["verify", str(path), *options], prog_name="armproof")
        captured = capsys.readouterr()
        return Run(int(end.value.code or 0), captured.out, captured.err, time.process_time() - started)

    return run


def write(folder: Path, front: str, body: str = FINE, name: str = "page.md") -> Path:
    path = folder / name
    path.write_text(f"---\n{front}\n---\n\n{body}", encoding="utf-8")
    return path


def assert_refused(run: Run, path: Path, message: str) -> None:
    """The law of a document that cannot be checked: exit code 2 and this one line."""
    assert run.stderr.splitlines() and re.fullmatch(rf"armproof: {re.escape(str(path))}{message}\n", run.stderr), (
        run.stderr
    )
    assert run.code == 2
    assert run.stdout == "1 could not be checked\n"
    assert is_in_time(run.seconds), run.seconds


def judge(verify: Callable[..., Run], path: Path) -> list[dict[str, object]]:
    """Return the records of a document that can be checked, with the law that it is neither slow nor noisy."""
    run = verify(path, "--format", "json")
    assert run.stderr == ""
    assert is_in_time(run.seconds), run.seconds
    return json.loads(run.stdout)["documents"][0]["equations"]


# -- model files -------------------------------------------------------------------------------------------------------

LINK = (
    '<link name="{}"><inertial><mass value="1"/>'
    '<inertia ixx="1" iyy="1" izz="1" ixy="0" ixz="0" iyz="0"/></inertial></link>\n'
)


def joint(name: str, parent: str, child: str, kind: str = "revolute", inside: str = "") -> str:
    limits = '<limit lower="-1" upper="1" effort="1" velocity="1"/>'
    ends = f'<parent link="{parent}"/><child link="{child}"/>'
    return f'<joint name="{name}" type="{kind}">{ends}<axis xyz="0 0 1"/>{limits}{inside}</joint>\n'


def urdf(*joints: str, links: str = "abc") -> str:
    return '<robot name="r">\n' + "".join(LINK.format(link) for link in links) + "".join(joints) + "</robot>"


CHAIN = urdf(joint("j", "a", "b"), joint("k", "b", "c"))
MODELS = {
    "broken": ('<robot name="r">\n<link', r"2: not well-formed XML: unclosed token"),
    "empty": ("", r"1: not well-formed XML: no element found"),
    "not a robot": ("<model/>", r"1: error: URDF does not contain a robot tag\."),
    "not text": ("\x00\x01", r"1: not well-formed XML: not well-formed \(invalid token\)"),
    "planar joint": (
        urdf(joint("j", "a", "b", "planar"), joint("k", "b", "c")),
        r" joint 'j' is planar; an arm has revolute, continuous, prismatic and fixed joints",
    ),
    "ball joint": (urdf(joint("j", "a", "b", "ball"), joint("k", "b", "c")), r"5: error: Joint j of type ball .*"),
    "unknown joint": (
        urdf(joint("j", "a", "b", "bent"), joint("k", "b", "c")),
        r"5: error: .*unrecognized type: 'bent'",
    ),
    "closed loop": (
        urdf(joint("j", "a", "b"), joint("k", "b", "c"), joint("m", "c", "a")),
        r" joint 'm' closes a loop; an arm is a serial chain",
    ),
    "two ways to a link": (
        urdf(joint("j", "a", "c"), joint("k", "a", "b"), joint("m", "b", "c")),
        r" joints 'j' and 'm' both carry 'c'; an arm is a serial chain without closed loops",
    ),
    "branch": (urdf(joint("j", "a", "b"), joint("k", "a", "c")), r" more than one moving branch: j and, off it, k; .*"),
    "mimic": (
        urdf(joint("j", "a", "b"), joint("k", "b", "c", inside='<mimic joint="j"/>')),
        r" joints coupled by <mimic> or constraints are not supported; .*",
    ),
    "nothing moves": (
        urdf(joint("j", "a", "b", "fixed"), joint("k", "b", "c", "fixed")),
        r" no moving joint; an arm has at least one revolute or prismatic joint",
    ),
    "missing link": (urdf(joint("j", "a", "z")), r"\d: error: Could not find link named 'z' .*"),
    "limits reversed": (
        CHAIN.replace('lower="-1"', 'lower="2"'),
        r"5: the lower limit of a joint is above its upper limit",
    ),
    "entity bomb": (
        '<!DOCTYPE r [<!ENTITY a0 "ha">'
        + "".join(f'<!ENTITY a{k} "{f"&a{k - 1};" * 10}">' for k in range(1, 10))
        + ']><robot name="&a9;"/>',
        r"1: not well-formed XML: limit on input amplification factor.*",
    ),
}


@pytest.mark.parametrize("fault", MODELS)
def test_a_model_file_at_fault_is_named_with_the_line_of_the_document(verify, tmp_path: Path, fault: str):
    text, message = MODELS[fault]
    (tmp_path / "arm.urdf").write_text(text, encoding="utf-8")
    path = write(tmp_path, "title: x\narm: arm.urdf")
    assert_refused(verify(path), path, rf":3: {re.escape(str(tmp_path / 'arm.urdf'))}:{message}")


def test_the_model_file_of_these_tests_is_fine_without_its_faults(verify, tmp_path: Path):
    (tmp_path / "arm.urdf").write_text(CHAIN, encoding="utf-8")
    assert verify(write(tmp_path, "arm: arm.urdf")).code == 0


@pytest.mark.parametrize("suffix", ["urdf", "sdf", "dmd.yaml"])
def test_a_missing_model_file_is_named(verify, tmp_path: Path, suffix: str):
    path = write(tmp_path, f"arm: nowhere.{suffix}")
    assert_refused(verify(path), path, rf":2: {re.escape(str(tmp_path / f'nowhere.{suffix}'))}: no such model file")


CARD = "title: t\nmodel: arm.urdf\njoints: {j: theta_1, k: theta_2}\nframes: {0: a, 1: b}\n"
CARDS = {
    "unknown joint": ("lengths: {l_1: m.x}", r"5: 'l_1' is bound to m\.x; the joints of the model are j, k, .*"),
    "no offset there": ("lengths: {l_1: k.x}", r"5: 'l_1' is bound to k\.x, which is 0 in arm\.urdf"),
    "no coordinate": (
        "lengths: {l_1: k}",
        r"5: 'l_1' is bound to 'k'; a place reads joint\.x, joint\.y or joint\.z, .*",
    ),
    "no place": ("lengths: {l_1: []}", r"5: 'l_1' is bound to no place; write joint\.x, joint\.y or joint\.z"),
    "unknown key": ("length: {l_1: k.x}", r"5: unknown key 'length'; the keys are title, source, model, joints, .*"),
}


@pytest.mark.parametrize("fault", CARDS)
def test_a_length_that_is_bound_to_no_place_is_refused(verify, tmp_path: Path, fault: str):
    line, message = CARDS[fault]
    (tmp_path / "arm.urdf").write_text(CHAIN, encoding="utf-8")
    (tmp_path / "arm.yaml").write_text(CARD + line, encoding="utf-8")
    path = write(tmp_path, "arm: .")
    assert_refused(verify(path), path, rf":2: {re.escape(str(tmp_path / 'arm.yaml'))}:{message}")


# -- front matter ------------------------------------------------------------------------------------------------------

KINDS = "pose, rotation, origin, axis, jacobian, .*"
FRONTS = {
    "unknown arm": ("arm: skara", rf"2: no arm 'skara'; an arm is one of {ARMS}, a path to a \.urdf, .* or a DH table"),
    "number for arm": ("arm: 3", rf"2: an arm is a name, a path or a DH table, not 3; the arms are {ARMS}"),
    "list for arm": ("arm: [scara]", r"2: an arm is a name, a path or a DH table, not (a list|\['scara'\]); the arms are .*"),
    "text for symbols": ("arm: scara\nsymbols: x", r"\d: 'symbols' must be a mapping from names to meanings, not 'x'"),
    "unknown symbol": ("arm: scara\nsymbols: {l_1: b_1}", r"\d: symbol 'l_1': the arm 'scara' has no 'b_1'; it has .*a_1, a_2, d_4 \('free' .*\)"),
    "list for quantities": ("arm: scara\nquantities: [x]", r"3: 'quantities' must be a mapping .*, not \['x'\]"),
    "number for a quantity": ("arm: scara\nquantities: {J: 4}", rf"3: quantity 'J' must name one of {KINDS}; it is 4"),
    "unknown quantity": ("arm: scara\nquantities: {J: {jacobina: 4}}", rf"3: quantity 'J' must name one of {KINDS}"),
    "unknown frame": (
        "arm: scara\nquantities: {J: {jacobian: 7}}",
        r"3: quantity 'J': no frame '7' on arm 'scara'; its frames are 0, 1, 2, 3, 4",
    ),
    "unknown reference": (
        "arm: scara\nquantities: {T: {pose: 4, in: G}}",
        r"3: quantity 'T': no frame 'G' on arm 'scara'; its frames are 0, 1, 2, 3, 4",
    ),
    "unknown component": ("arm: scara\nquantities: {P: {origin: 4, component: w}}", r"3: quantity 'P': 'component' must be x, y or z, not 'w'"),
    "rows not a list": ("arm: scara\nquantities: {J: {jacobian: 4, rows: all}}", r"3: quantity 'J': rows must be a list .*, not 'all'"),
    "code for a name": ("arm: scara\nquantities: {\"__import__('os')\": {pose: 4}}", r"3: '__import__\('os'\)' is not a name: .*"),
    "quantity of no arm": ("quantities: {T: {pose: 4}}", r"2: quantity 'T' is of an arm, but the front matter names no arm"),
    "unknown transforms": ("arm: scara\ntransforms: left", r"\d: 'transforms' must be upper or lower, not 'left'"),
    "not a mapping": ("- arm: scara", r"2: the front matter must be a mapping of keys such as 'arm: scara'"),
    "not YAML": ("title: x\narm: [scara", r"3: the front matter is not YAML: did not find expected ',' or '\]'"),
    "unknown convention": ("arm: {dh: modern, rows: []}", r"2: DH table: dh is classic or modified, not 'modern'"),
    "no rows": ("arm: {dh: classic}", r"2: DH table: rows is a list of rows, base to tool, not None"),
    "row without keys": ("arm: {dh: classic, rows: [{a: 1}]}", r"2: DH table, row 1: a row has the keys a, alpha, d, theta, not a"),
    "code in a row": (
        "arm: {dh: classic, rows: [{a: \"__import__('os')\", alpha: 0, d: 0, theta: theta_1}]}",
        r"2: DH table, row 1, a: '__import__\('os'\)' is unreadable: .*; an entry reads 0, 0\.75, 3/4, pi/2, .*",
    ),
    "power in a row": (
        "arm: {dh: classic, rows: [{a: 9**9**9, alpha: 0, d: 0, theta: theta_1}]}",
        r"2: DH table, row 1, a: '9\*\*9\*\*9' is unreadable: .*",
    ),
    "number out of range": (
        "arm: {dh: classic, rows: [{a: 1e999999999, alpha: 0, d: 0, theta: theta_1}]}",
        r"2: DH table, row 1, a: '1e999999999' is unreadable: a number is too large or too small; .*",
    ),
    "no joint variable": (
        "arm: {dh: classic, rows: [{a: l_1, alpha: 0, d: 0, theta: 0}]}",
        r"2: DH table, row 1: the joint variable is neither in theta .*",
    ),
}  # fmt: skip


@pytest.mark.parametrize("fault", FRONTS)
def test_front_matter_at_fault_is_refused_at_its_line(verify, tmp_path: Path, fault: str):
    front, message = FRONTS[fault]
    path = write(tmp_path, front)
    assert_refused(verify(path), path, f":{message}")


@pytest.mark.parametrize("blank", [0, 1, 3])
def test_the_head_of_a_comment_is_counted_from_its_first_line(verify, tmp_path: Path, blank: int):
    path = tmp_path / "page.rst"
    path.write_text("..\n" + "\n" * blank + "   arm: [\n\nText.\n", encoding="utf-8")
    assert_refused(verify(path), path, f":{blank + 2}: .*")


def test_front_matter_that_never_ends_is_refused(verify, tmp_path: Path):
    path = tmp_path / "page.md"
    path.write_text("---\narm: scara\n\n$$ 1 = 1 $$\n", encoding="utf-8")
    assert_refused(verify(path), path, r":1: the front matter opened by '---' is never closed by '---'")


def test_front_matter_executes_nothing(verify, tmp_path: Path):
    path = write(tmp_path, f'arm: !!python/object/apply:os.system ["touch {tmp_path}/touched"]')
    assert_refused(
        verify(path), path, ":2: the front matter is not YAML: could not determine a constructor for the tag .*"
    )
    assert not (tmp_path / "touched").exists()


BOMB = "\n".join(
    ["  a0: &a0 [x, x, x, x, x, x, x, x, x]"]
    + [f"  a{k}: &a{k} [{', '.join([f'*a{k - 1}'] * 9)}]" for k in range(1, 9)]
)


@pytest.mark.parametrize("front", [f"arm:\n{BOMB}", f"symbols:\n{BOMB}\narm: {{dh: classic, rows: *a8}}"])
def test_front_matter_that_repeats_itself_without_end_is_refused(tmp_path: Path, front: str):
    path = write(tmp_path, front)
    run = armproof("verify", path, folder=tmp_path, environment=os.environ)
    assert run.returncode == 2
    assert re.fullmatch(rf"armproof: {re.escape(str(path))}:\d+: .+\n", run.stderr)


def test_front_matter_nested_without_end_is_refused(verify, tmp_path: Path):
    path = write(tmp_path, "arm: " + "[" * 5_000 + "]" * 5_000)
    assert_refused(verify(path), path, r".*")


# -- displays ----------------------------------------------------------------------------------------------------------

UNREADABLE = {
    "file": (r"\input{/etc/passwd} = 1", r"'\\input' is not a command of kinematic LaTeX"),
    "shell": (r"\immediate\write18{touch touched} = 1", r"'\\immediate' is not a command of kinematic LaTeX"),
    "macro": (r"\def\a{\a\a}\a = 1", r"'\\a' is not a command of kinematic LaTeX"),
    "code": ("__import__('os').system('touch touched') = 1", "unexpected '''; expected .*"),
    "right code": ("C_{12} = __import__('os')", "unexpected '''; expected .*"),
    "1 MB": ("a + " * 250_000 + "a = 1", r"the display is too long: 1,000,0\d\d characters, at most 100,000"),
    "many tokens": ("a + " * 20_000 + "a = 1", r"the display is too long: more than 20,000 tokens"),
    "braces": ("{" * 10_000 + "1" + "}" * 10_000 + " = 1", r"nested more than 60 deep"),
    "open braces": ("{" * 10_000 + " = 1", r"nested more than 60 deep"),
    "closing braces": ("1 = 1" + "}" * 10_000, r"unexpected '}'; expected .*"),
    "fractions": (r"\frac{1}{" * 5_000 + "1" + "}" * 5_000 + " = 1", r"nested more than 60 deep"),
    "indices": (r"a_{" * 5_000 + "1" + "}" * 5_000 + " = 1", r"nested more than 60 deep"),
    "matrices": (r"\begin{bmatrix}" * 2_000 + "1" + r"\end{bmatrix}" * 2_000 + " = 1", r"nested more than 60 deep"),
    "brackets": (r"\left(" * 5_000 + "1" + r"\right)" * 5_000 + " = 1", r"nested (too deeply|more than 60 deep)"),
    "bars": ("|" * 10_000 + "1 = 1", r"unexpected '\|\|?'; expected .*"),
    "power": (r"(\cos\theta_1 + a_1)^{999999999} = 1", r"the exponent 999999999 is larger than \d+"),
    "digits": ("9" * 50_000 + " = 1", r"a number of more than 40 digits"),
    "unknown environment": (r"\begin{tikzpicture} \end{tikzpicture} = 1", r"environment 'tikzpicture' is not read; those that are: .*"),
    "wrong end": (r"\begin{bmatrix} 1 \end{pmatrix} = 1", r"'\\begin{bmatrix}' is closed by '\\end{pmatrix}'"),
    "not a character": ("a \x00 = 1", r"cannot read '.*'"),
    "not of this field": ("☃ = 1", r"cannot read '☃'"),
    "nothing after =": ("1 = = 1", r"two relations one after the other at '='"),
}  # fmt: skip


@pytest.mark.parametrize("fault", UNREADABLE)
def test_a_display_that_cannot_be_read_says_where_and_leaves_the_rest_to_be_checked(
    verify, tmp_path: Path, monkeypatch, fault: str
):
    latex, message = UNREADABLE[fault]
    monkeypatch.chdir(tmp_path)
    bad, fine = judge(verify, write(tmp_path, "arm: scara", f"$$ {latex} $$\n\n{FINE}"))
    assert bad["verdict"] == "unreadable"
    assert re.fullmatch(rf"line 5, column \d+ of the display: {message}", bad["message"])
    assert (fine["verdict"], fine["line"]) == ("proved", 7)
    assert not (tmp_path / "touched").exists()


@pytest.mark.parametrize("rest", ["p_4 = 1\n\nMore text.\n", "", "a + " * 50_000])
def test_a_display_that_never_ends_is_unreadable(verify, tmp_path: Path, rest: str):
    fine, bad = judge(verify, write(tmp_path, "arm: scara", f"{FINE}$$ {rest}"))
    assert (fine["verdict"], bad["verdict"], bad["line"]) == ("proved", "unreadable", 7)
    assert bad["message"] == "the display opened by $$ never ends"


MATRIX = r" \\ ".join(" & ".join(rf"\cos({i}\theta_1 + {j}\theta_2) + a_1" for j in range(6)) for i in range(6))
LABORIOUS = {
    "powers of sums": r"({}^0T_4 + {}^0T_4^T)" * 30 + "_{14} = 1",
    "derivatives": r"\frac{d}{dt}" * 30 + "({}^0T_4) = 0",
    "multiples of an angle": r"\cos(99999\theta_1) = 1",
    "fractions of angles": r"\cos\frac{\theta_1}{997} \cos\frac{\theta_1}{991} = 1",
    "determinant": rf"\det\begin{{bmatrix}} {MATRIX} \end{{bmatrix}} = a_1",
    "large determinant": r"\det\begin{bmatrix} " + r" \\ ".join(["a_1" + " & a_2" * 11] * 12) + r" \end{bmatrix} = 1",
    "long product": r"\cos\theta_1 " * 3_000 + "= 1",
    "long chain": "1 = " * 3_000 + "1",
    "many equations": r"C_{12} = \cos(\theta_1 + \theta_2) \\ " * 400,
    "nested roots": r"\sqrt{" * 40 + "2" + "}" * 40 + " = 1",
    "nested fractions": r"\frac{1}{a_1 + \frac{1}{\cos\theta_1 + " * 12 + "1" + "}}" * 12 + " = 1",
}


@pytest.mark.parametrize("labour", LABORIOUS)
def test_no_display_takes_more_than_its_time(verify, tmp_path: Path, monkeypatch, labour: str):
    if labour != "derivatives" and not SWEEP:  # one uses up the whole time, the others a part of it
        monkeypatch.setattr("armproof.verification.check.display.SECONDS_TO_DECIDE", 0.3)
    slow, fine = judge(verify, write(tmp_path, "arm: scara", f"$$ {LABORIOUS[labour]} $$\n\n{FINE}"))
    assert slow["verdict"] in ("refuted", "unchecked", "unreadable", "proved", "confirmed")
    assert fine["verdict"] == "proved"


REPEATED = {
    "images in Markdown": ("page.md", "![" * 15_000),
    "links": ("page.md", "[[" * 15_000),
    "comments": ("page.md", "<!--" * 15_000),
    "sections of HTML": ("page.md", "<![CDATA[" * 6_000),
    "columns": ("page.md", f"$$\n{'&' * 15_000}\n$$"),
    "rows": ("page.md", "$$\n" + r"a&b\\" * 2_000 + "\n$$"),
    "images in LaTeX": ("page.tex", "![" * 15_000),
    "displays": ("page.tex", r"\begin{align}" * 2_000),
    "displays in brackets": ("page.tex", "\\[" * 5_000),
    "dollars": ("page.tex", "$ " * 5_000),
    "sections": ("page.tex", r"\section{" * 2_000),
    "definitions": ("page.tex", r"\newcommand{\a}{" * 2_000),
    "macros": ("page.tex", r"\def\a{\a\a}\a" * 1_500),
    "pictures": ("page.tex", r"\includegraphics{" * 2_000),
}


@pytest.mark.parametrize("what", REPEATED)
def test_what_opens_again_and_again_is_read_in_time(verify, tmp_path: Path, what: str):
    name, text = REPEATED[what]
    path = tmp_path / name
    path.write_text(f"{FINE}{text}\n", encoding="utf-8")
    assert judge(verify, path)[0]["verdict"] == "proved"


@pytest.mark.parametrize("opening", ["::: note\n", "```{note}\n"])
def test_a_document_that_is_nested_without_end_is_refused(verify, tmp_path: Path, opening: str):
    path = write(tmp_path, "arm: scara", f"{FINE}{opening * (40_000 // len(opening))}")
    assert_refused(verify(path), path, ": nested too deeply")


@pytest.mark.parametrize(
    ("depth", "text"),
    [(5_000, ">"), (5_000, "[" * 5_000), (1, "*a **b " * 5_000), (1, "$a " * 20_001), (1, "| a " * 5_000 + "\n")],
)
def test_markdown_without_end_is_read_in_time(verify, tmp_path: Path, depth: int, text: str):
    *_, fine = judge(verify, write(tmp_path, "arm: scara", f"{text * (depth if len(text) == 1 else 1)}\n\n{FINE}"))
    assert fine["verdict"] == "proved"


@pytest.mark.parametrize(
    "text",
    ["horizontal\n" + " \n" * 40_000, "horizontal" + f"\n{' ' * 50}" * 8_000, "horizontal \\begin{equation}" * 8_000, "as seen by not " * 9_000,
     "$a$, " * 40 + "$b$ are lengths and", r"\(a\) \(b\) " * 20 + "are lengths and"],
    ids=["blank lines", "indented blank lines", "environments that never end", "words", "formulas", "formulas of LaTeX"],
)  # fmt: skip
def test_what_text_says_is_heard_in_time(verify, tmp_path: Path, text: str):
    *_, fine = judge(verify, write(tmp_path, "arm: scara", f"{text}\n\n{FINE}"))
    assert fine["verdict"] in ("proved", "unreadable", "unchecked")  # what never ends, or denies, takes it along


# -- files -------------------------------------------------------------------------------------------------------------

NOTEBOOKS = {
    "not JSON": ("# A notebook", r":1: not a notebook: Expecting value \(a notebook is JSON\)"),
    "cut short": ('{"cells": [\n{"cell_type":\n', r":3: not a notebook: Expecting value \(a notebook is JSON\)"),
    "a list": ("[1, 2]", r":1: not a notebook: it has no list of cells with a type and a source"),
    "no cells": ("{}", r":1: not a notebook: it has no list of cells with a type and a source"),
    "cells of numbers": ('{"cells": [3]}', r":1: not a notebook: it has no list of cells with a type and a source"),
    "no type": ('{"cells": [{"source": "x"}]}', r":1: not a notebook: it has no list of cells .*"),
    "nested": ("[" * 100_000, r":1: not a notebook: .*"),
}


@pytest.mark.parametrize("fault", NOTEBOOKS)
def test_a_notebook_that_is_none_is_refused(verify, tmp_path: Path, fault: str):
    text, message = NOTEBOOKS[fault]
    path = tmp_path / "lesson.ipynb"
    path.write_text(text, encoding="utf-8")
    assert_refused(verify(path), path, message)


@pytest.mark.parametrize("data", [b"\x89PNG\r\n\x1a\n\xff", bytes(range(256)) * 1000])
@pytest.mark.parametrize("name", ["page.md", "lesson.ipynb", "lesson.py"])
def test_a_file_that_is_not_text_is_refused(verify, tmp_path: Path, name: str, data: bytes):
    path = tmp_path / name
    path.write_bytes(data)
    assert_refused(verify(path), path, r":\d+: not a text file in UTF-8 \(byte \d+\)")


def test_an_empty_folder_is_refused(verify, tmp_path: Path):
    message = r": no document in this folder; a document is a \.md, \.ipynb, \.py, .* file with displays"
    assert_refused(verify(tmp_path), tmp_path, message)
    (tmp_path / "notes.md").write_text("No formulas here.", encoding="utf-8")
    (tmp_path / "data.csv").write_text("$$ 1 = 2 $$", encoding="utf-8")
    assert_refused(verify(tmp_path), tmp_path, message)


def test_paths_that_are_no_documents_are_refused(verify, tmp_path: Path):
    (tmp_path / "page.txt").write_text("$$ 1 = 1 $$", encoding="utf-8")
    (tmp_path / "circle.md").symlink_to(tmp_path / "circle.md")
    (tmp_path / "endless.md").symlink_to("/dev/zero")
    for name, message in {
        "missing.md": ": no such file or folder",
        "page.txt": r": '\.txt' files are not read; those that are: \.md, \.ipynb, \.py, .*",
        "circle.md": ": (no such file or folder|cannot be read: .*)",
        "endless.md": ": not a file",
        "a" * 5_000 + ".md": ": (no such file or folder|cannot be read: File name too long)",
    }.items():
        assert_refused(verify(tmp_path / name), tmp_path / name, message)


def test_one_bad_document_of_a_folder_leaves_the_others_to_be_checked(verify, tmp_path: Path):
    write(tmp_path, "arm: scara", name="good.md")
    (tmp_path / "bad.md").write_bytes(b"$$ \0\xff $$")
    run = verify(tmp_path)
    assert run.code == 2
    assert f"passes {tmp_path / 'good.md'} (scara)  1 display: 1 proved" in run.stdout
    assert run.stderr == f"armproof: {tmp_path / 'bad.md'}:1: not a text file in UTF-8 (byte 4)\n"


# -- any input ---------------------------------------------------------------------------------------------------------

TOKENS = r"""
    { } { } ( ) [ ] | _ ^ ' = = + - * / , ; . : & \\ ! ? < > \{ \} \| \left( \right) \left[ \right. \big( \lvert \rvert
    \le \neq \approx \Rightarrow \iff \quad \, ~ % # $ @ " ` \ \% \$ \_ \$$ -- ... \cdot \times \pm \circ \dots \top \prime
    \frac \dfrac \frac12 \sqrt \sqrt[3] \begin{bmatrix} \end{bmatrix} \begin{array}{cc} \end{array} \begin{cases} \end{cases}
    \begin{aligned} \end{aligned} \begin{vmatrix} \end{vmatrix} \begin \end {bmatrix} \hline \\[2pt] \tag{1} \label{a} \hspace{1cm}
    \cos \sin \arccos \operatorname{atan2} \operatorname \mathbf \mathrm \text{if} \text \vec \hat \dot \ddot \underbrace \boxed
    \theta \alpha \omega \pi \Delta \partial \det \int \sum \lim \in \mathbb{R} \overset \stackrel \input \def \relax
    a b c s C S x T A R J p q l d i n 0 1 2 12 123 3.14 .5 0. 1e9 c_1 s_{12} C_{123} \theta_1 {}^0T_4 ^0_1T T^0_4 \dot{q} \theta_1^*
    J(q) J'_P P_x q_{i-1} \frac{d}{dt} \frac{\partial} if and or Rot Trans rank diag θ α ₁ ² × · − ° … ☃ é 𝛉
""".split()


def read(latex: str, bound: bool) -> None:
    """Read a display; the only exception it may raise says what is wrong."""
    started = time.process_time()
    try:
        Reader(lambda key: bound).read(latex)
    except ReadError as error:
        assert str(error)
        assert error.offset >= 0
    assert time.process_time() - started < 2.0


@examples(400)
@given(st.lists(st.sampled_from(TOKENS), max_size=40), st.sampled_from(["", " "]), st.booleans())
def test_any_soup_of_tokens_is_read_or_refused(tokens: list[str], separator: str, bound: bool):
    read(separator.join(tokens), bound)


@examples(100)
@given(st.text(max_size=60), st.booleans())
@example("\ud800", False)
def test_any_text_is_read_or_refused(text: str, bound: bool):
    read(text, bound)


@examples(30)
@given(st.sampled_from(TOKENS), st.sampled_from(TOKENS), st.integers(1, 1_500))
@example(r"\cos", "a", 1_500)
@example(r"\cos", " ", 1_500)
def test_any_repetition_is_read_or_refused_in_time(first: str, second: str, times: int):
    read((first + " " + second + " ") * times, False)


FORMULAS = re.findall(
    r"\$\$(.+?)\$\$", "".join(p.read_text() for p in sorted(ROOT.glob("course/handouts/*.md"))), re.DOTALL
)
PIECES = re.compile(r"\\[A-Za-z]+|\\.|[A-Za-z]|\d+|\s+|.", re.DOTALL)


@examples(200)
@given(st.sampled_from(FORMULAS), st.data())
def test_any_slip_in_a_formula_of_the_handouts_is_read_or_refused(formula: str, data: st.DataObject):
    pieces = PIECES.findall(formula)
    for _ in range(data.draw(st.integers(1, 4))):
        place = data.draw(st.integers(0, len(pieces)))
        removed = data.draw(st.integers(0, 3))
        pieces[place : place + removed] = data.draw(st.lists(st.sampled_from(TOKENS), max_size=2))
    read("".join(pieces), data.draw(st.booleans()))


# -- the sources -------------------------------------------------------------------------------------------------------


ALONE = ("eval", "exec", "compile", "__import__")  # and not as methods: re.compile makes no code
ANYWHERE = (
    *("parse_expr", "sympify", "literal_eval"),
    *("popen", "Popen", "check_output", "unsafe_load", "full_load"),
)


def executing_calls(source: str) -> Iterator[str]:
    """Yield the calls of a module that turn text into code."""
    for node in nodes_in(source):
        if isinstance(node, ast.Call) and isinstance(node.func, ast.Name | ast.Attribute):
            last = node.func.id if isinstance(node.func, ast.Name) else node.func.attr
            if last in (*ALONE, *ANYWHERE, "system"):
                name = ast.unparse(node.func)
                if name in (*ALONE, "os.system") or last in ANYWHERE:
                    yield name


# Grading runs what students wrote, in a process of its own that is shut off from everything else.
SANDBOX = {
    "course/grading/running/client.py": ["subprocess.Popen"],
    "course/grading/running/runner.py": ["exec", "compile"],
    "course/grading/sandbox/bubblewrap.py": ["subprocess.Popen"],
    "verification/running/servant.py": ["subprocess.Popen"],  # Armproof's own process beside a worker
}


def test_no_module_turns_text_into_code():
    modules = [path for room in ("models", "verification", "course") for path in (ROOT / room).rglob("*.py")]
    assert len(modules) > 20
    calls = {
        path.relative_to(ROOT).as_posix(): [*executing_calls(path.read_text(encoding="utf-8"))] for path in modules
    }
    assert {name: found for name, found in calls.items() if found} == SANDBOX


@pytest.mark.parametrize(
    "source", ["eval('1')", "sympy.sympify(text)", "x = parse_expr(t)", "os.system(c)", "yaml.unsafe_load(t)"]
)
def test_a_call_that_turns_text_into_code_is_noticed(source: str):
    assert list(executing_calls(source))
