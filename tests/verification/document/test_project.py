"""LaTeX documents of several files, their own commands and environments: each display is read once, and told by its file and line."""

import os
from pathlib import Path

import pytest

from armproof.verification.check import verify, verify_text
from armproof.verification.document import parse_document, read_document
from armproof.verification.report.github import github_report
from armproof.verification.report.text import text_report
from armproof.verification.running.corrected_copy import correct_file

FRONT = """\
% ---
% arm: {dh: classic, rows: [{a: l_1, alpha: 0, d: 0, theta: theta_1}, {a: l_2, alpha: 0, d: 0, theta: theta_2}]}
% quantities: {p_x: {origin: 2, component: x}, p_y: {origin: 2, component: y}}
% ---
"""
MAIN = (
    FRONT
    + r"""\documentclass{article}
\usepackage{amsmath, mine}
\begin{document}
% \input{parts/hidden}
\[ p_x = l_1 \C{1} + l_2 \C{12} \]
\input{parts/one} and \[ p_x = l_1 c_1 - l_2 c_{12} \]
\include{parts/two}
\end{document}
"""
)
FILES = {
    "main.tex": MAIN,
    "mine.sty": r"\newcommand{\C}[1]{c_{#1}}",
    "parts/hidden.tex": r"\[ 1 = 2 \]",
    "parts/one.tex": "Words.\n\n\\[ p_y = l_1 s_1 - l_2 s_{12} \\]\n\\input parts/deep\n",
    "parts/deep.tex": "\n\\[ p_x = ( \\]\n\\input{parts/one}",
    "parts/two.tex": "\\documentclass{subfiles}\n\\begin{document}\n\\[ p_y = l_1 s_1 + l_2 s_{12} \\]\n\\end{document}\n\\[ 3 = 4 \\]\n",
}


@pytest.fixture
def main(tmp_path: Path) -> Path:
    for name, text in FILES.items():
        (tmp_path / "handout" / name).parent.mkdir(parents=True, exist_ok=True)
        (tmp_path / "handout" / name).write_text(text, encoding="utf-8")
    return tmp_path / "handout" / "main.tex"


def test_a_document_of_several_files_is_read_in_its_order_with_files_and_lines(main: Path):
    result = verify(main)
    assert [(each.file, each.line, each.verdict.value) for each in result.equations] == [
        ("main.tex", 9, "proved"),
        ("parts/one.tex", 3, "refuted"),
        ("parts/deep.tex", 2, "unreadable"),
        ("main.tex", 10, "refuted"),
        ("parts/two.tex", 3, "proved"),
    ]
    assert result.as_json()["equations"][1]["file"] == "parts/one.tex"
    assert [str(remark).split(",")[0] for remark in result.remarks] == ["'parts/one'"]  # which inputs itself


def test_reports_name_the_file_and_its_line(main: Path):
    result = verify(main)
    text = "\n".join("".join(piece for piece, _ in line) for line in text_report([result]))
    assert "parts/one.tex, line 3  refuted" in text and "main.tex, line 10  refuted" in text
    assert "parts/deep.tex, line 2  unreadable" in text and "line 2, column 8 of the display" in text
    commands = list(github_report([result]))
    assert any(f"{main.parent.name}/parts/one.tex,line=3" in command for command in commands)


def test_a_correction_changes_the_main_file_alone(main: Path):
    copy = correct_file(main)
    assert copy.after == MAIN.replace("c_1 - l_2", "c_1 + l_2")


def test_a_document_of_one_file_names_none(tmp_path: Path):
    (tmp_path / "page.tex").write_text(FRONT + r"\[ p_x = 1 \]", encoding="utf-8")
    (record,) = verify(tmp_path / "page.tex").equations
    assert record.file == "" and "file" not in record.as_json()


OUTSIDE = [
    "../secret",
    "../secret.tex",
    "/etc/passwd",
    "parts/../../secret",
    "out/secret",
    "link",
    "~/secret",
    "|ls",
    "secret.txt",
    "folder",
    "pipe",
    "page",
]


@pytest.mark.parametrize("name", OUTSIDE)
@pytest.mark.parametrize(
    "command", [r"\input{%s}", r"\include{%s}", r"\subfile{%s}", r"\import{./}{%s}", r"\usepackage{%s}"]
)
def test_nothing_outside_the_folder_is_read(tmp_path: Path, name: str, command: str):
    folder = tmp_path / "handout"
    (folder / "folder.tex").mkdir(parents=True)
    for file in ("secret.tex", "secret.sty", "secret", "handout/secret.txt"):
        (tmp_path / file).write_text(r"\newcommand{\known}{1}\[ 1 = 1 \]", encoding="utf-8")
    (folder / "link.tex").symlink_to(tmp_path / "secret.tex")
    (folder / "link.sty").symlink_to(tmp_path / "secret.sty")
    (folder / "out").symlink_to(tmp_path)
    os.mkfifo(folder / "pipe.tex")
    (folder / "page.tex").write_text(command % name + "\n" + r"\[ \known = 2 \]", encoding="utf-8")
    (display,) = read_document(folder / "page.tex").displays
    assert display.latex.strip() == r"\known = 2"


def test_files_that_input_each_other_without_end_are_read_once_a_branch(tmp_path: Path):
    for k in range(30):
        (tmp_path / f"f{k}.tex").write_text(
            "".join(rf"\input{{f{j}}}" for j in range(30)) + r"\[ 1 = 1 \]", encoding="utf-8"
        )
    assert 1 <= len(read_document(tmp_path / "f0.tex").displays) <= 201


DEFINED = {
    "empheq": r"\begin{empheq}[left=\empheqlbrace]{align} p_x &= <> \\ p_y &= l_1 s_1 + l_2 s_{12} \end{empheq}",
    "empheq in a box": r"\begin{empheq}[box={\fboxsep=6pt\fbox}]{equation*} p_x = <> \end{empheq}",
    "subequations": r"\begin{subequations}\begin{align} p_x &= <> \end{align}\end{subequations}",
    "an environment": r"\newenvironment{eq}{\begin{equation}}{\end{equation}}\begin{eq} p_x = <> \end{eq}",
    "an environment within": r"\newenvironment{col}[1]{#1\left[\begin{matrix}}{\end{matrix}\right]}\[ \begin{col}{1} p_x \\ p_y \end{col} = \begin{col}{} <> \\ l_1 s_1 + l_2 s_{12} \end{col} \]",
    "a command with arguments": r"\NewDocumentCommand{\of}{m m}{#1_{#2}}\[ \of{p}{x} = <> \]",
    "a delimiter": r"\DeclarePairedDelimiter{\pa}{(}{)}\[ p_x = \pa{<>} \]",
    "a primitive": r"\def\co#1{\cos\theta_{#1}}\def\C(#1){\cos(#1)}\[ p_x - (<>) + \co1 = \C(\theta_1) \]",
    "another name": r"\let\angle=\theta\[ p_x = <> + \angle_1 - \theta_1 \]",
    "a frame": r"\begin{frame}<2->[fragile]{Title}\begin{block}{Note}\only<2>{\[ p_x = <> \]}\end{block}\pause\end{frame}",
}  # fmt: skip


@pytest.mark.parametrize("name", DEFINED)
def test_what_an_author_defines_is_read_and_a_false_twin_refuted(name: str):
    for right, verdict in (("l_1 c_1 + l_2 c_{12}", "proved"), ("l_1 c_1 - l_2 c_{12}", "refuted")):
        text = f"{FRONT}\\begin{{document}}\n{DEFINED[name].replace('<>', right)}\n\\end{{document}}\n"
        assert [each.verdict.value for each in verify_text(text, "tex").equations] == [verdict]


def test_the_title_of_a_frame_is_a_section():
    document = parse_document(Path("a.tex"), "\\begin{frame}\\frametitle{Arms}\\[ 1 = 1 \\]\\end{frame}")
    assert [display.section for display in document.displays] == ["Arms"]
