"""From Markdown to a sheet: nothing without a verdict, nothing but the author's words, no network, no file from elsewhere."""

from __future__ import annotations

import json
from dataclasses import replace
from pathlib import Path

import pytest

from armproof.course.errors import PrintError
from armproof.course.printing.document import Edition, make_sheet
from armproof.course.printing.printing import render
from armproof.course.sheet.model import Display, Link, Listing, Paragraph, Picture, Table, plain, walk
from armproof.models.errors import ArmproofError
from armproof.verification.check import check_document
from armproof.verification.document import read_document

PIXEL = bytes.fromhex(
    "89504e470d0a1a0a0000000d49484452000000010000000108060000001f15c4890000000d49444154789c6360606060000000050001a5f64540"
    "0000000049454e44ae426082"
)
PROVED = r"$$ \cos^2\theta_1 + \sin^2\theta_1 = 1 $$" + "\n\n"


def test_a_display_without_a_verdict_is_not_printed(document, tmp_path):
    path = document(PROVED + PROVED)
    read = read_document(path)
    result = check_document(read, confirm=False)
    fewer = replace(result, equations=result.equations[:1])
    with pytest.raises(PrintError, match="has no verdict, so it is not printed"):
        make_sheet(read, fewer, Edition(), tmp_path)
    other = replace(result, equations=(result.equations[0], replace(result.equations[1], latex="a = b")))
    with pytest.raises(PrintError, match="has no verdict, so it is not printed"):
        make_sheet(read, other, Edition(), tmp_path)
    more = replace(result, equations=(*result.equations, result.equations[0]))
    with pytest.raises(PrintError, match="would not be on the sheet"):
        make_sheet(read, more, Edition(), tmp_path)


@pytest.mark.parametrize(
    "body",
    [
        PROVED,
        "Within words $$ x = x $$ and on.\n\n",
        "```{math}\n:label: a\nx = x\n```\n\n",
        ":::{note} Title\nwords\n\n$$ x = x $$\n:::\n\n",
        "> quoted\n> $$ x = x $$\n\n",
        "- item\n\n  $$ x = x $$\n\n",
        "$$ x = x $$ {#eq-label}\n\n",
        "$$ x = x $$ $$ y = y $$\n\n",
        "```{admonition} Erratum\n$$ 1 = 2 $$\n```\n\n",
    ],
)
def test_each_display_is_printed_with_its_own_record(body: str, document, make):
    path = document(body + PROVED)
    found = [block.record for block in walk(make(path, solutions=True).blocks) if isinstance(block, Display)]
    assert [record.latex.strip() for record in found] == [
        display.latex.strip() for display in read_document(path).displays
    ]


def test_a_display_that_never_ends_is_printed_as_it_stands_in_a_draft(document, pdf_text):
    assert "never closed" in pdf_text(document("Words\n\n$$ x = never closed"), draft=True)


HOSTILE = [
    '#panic("x")', "#import \"@preview/cetz:0.3.0\"", "@reference", "<label>", "$ #read(\"/etc/passwd\") $", "= heading", "*bold_ `raw",
    "https://example.org/a", "// comment", "/* comment", "\\u{41}", "]]) #[", "~tilde---dots...", "\\#set page(width: 1pt)",
]  # fmt: skip


@pytest.mark.parametrize("words", HOSTILE)
def test_words_that_are_code_elsewhere_are_words(words: str, document, pdf_text):
    text = pdf_text(
        document(
            f"Before {words} after\n\n- {words}\n\n| {words.replace('|', '')} |\n|---|\n| x |\n",
            front="---\ntitle: x\n---\n\n",
        )
    )
    assert "Before" in text and "after" in text
    assert "root:" not in text


@pytest.mark.parametrize(
    "latex",
    [r"\input{/etc/passwd}", r"x = \text{#panic(1)}", r"x = \mathrm{\"a\"}", "x = @y", r"\href{http://a}{x} = x"],
)
def test_mathematics_that_is_code_elsewhere_is_typeset_or_shown(latex: str, document, pdf_text):
    text = pdf_text(document(f"$$ {latex} $$\n\nInline ${latex}$ end", front="---\ntitle: x\n---\n\n"), draft=True)
    assert "end" in text and "root:" not in text


def test_html_is_not_printed_and_the_line_is_named(document, make):
    sheet = make(document("<script>alert(1)</script>\n\nText <b>bold</b><!-- x --> on\n\n<!-- a comment -->\n"))
    assert len(sheet.warnings) == 1 and "sheet.md:8: HTML is not printed" in sheet.warnings[0]
    page = render(sheet, "html").decode()
    assert "<script" not in page and "alert" not in page and "Text bold on" in page


@pytest.mark.parametrize(
    ("target", "reason"),
    [
        ("http://example.org/a.png", "without the network"),
        ("//example.org/a.png", "without the network"),
        ("data:image/png;base64,AAAA", "without the network"),
        ("/etc/hostname.png", "by its path from the document's folder"),
        ("../outside.png", "does not stand in the document's folder"),
        ("%2e%2e/outside.png", "does not stand in the document's folder"),
        ("sheet.md", "pictures are"),
        ("none.png", "no such file"),
    ],
)
def test_a_picture_from_elsewhere_is_not_printed(target: str, reason: str, document, make, tmp_path):
    (tmp_path.parent / "outside.png").write_bytes(PIXEL)
    sheet = make(document(f"![the caption]({target})\n"))
    assert not any(isinstance(block, Picture) for block in walk(sheet.blocks))
    assert len(sheet.warnings) == 1 and reason in sheet.warnings[0]


def test_a_link_in_the_folder_that_leads_out_of_it_is_not_followed(document, make, tmp_path):
    (tmp_path.parent / "outside.png").write_bytes(PIXEL)
    (tmp_path / "inside.png").symlink_to(tmp_path.parent / "outside.png")
    assert "does not stand in" in make(document("![x](inside.png)\n")).warnings[0]


def test_a_picture_beside_the_document_is_printed(document, make, tmp_path):
    (tmp_path / "pixel.png").write_bytes(PIXEL)
    sheet = make(document("![the caption $x^2$](pixel.png)\n"))
    assert [block.path.name for block in walk(sheet.blocks) if isinstance(block, Picture)] == ["pixel.png"]
    assert "data:image/png;base64," in render(sheet, "html").decode()


def test_a_picture_that_is_none_is_an_error_with_a_message(document, make, tmp_path):
    pytest.importorskip("typst", reason="the extra 'print' is not installed")
    (tmp_path / "broken.png").write_bytes(b"no picture")
    with pytest.raises(PrintError, match="cannot be typeset"):
        render(make(document("![x](broken.png)\n")), "pdf")


@pytest.mark.parametrize("target", ["javascript:alert(1)", "file:///etc/passwd", "/etc/passwd", "other.txt"])
def test_only_the_network_is_linked_to(target: str, document, make):
    sheet = make(document(f"[words]({target})\n"))
    parts = [part for block in sheet.blocks if isinstance(block, Paragraph) for part in block.parts]
    assert not any(isinstance(part, Link) for part in parts)
    assert "words" in render(sheet, "html").decode()


def test_a_link_to_another_document_prints_as_its_title(document, pdf_text):
    document("", name="other.md", front="---\ntitle: The other sheet\n---\n\n")
    text = pdf_text(document("See [other.md](other.md) and `other.md`, not `none.md`."))
    assert text.count("The other sheet") == 2 and "none.md" in text


def test_lists_and_tables_keep_their_form(document, make, pdf_text):
    path = document("3. three\n4. four\n   - inner $\\theta_1$\n\n| a | $b$ |\n|:--|--:|\n| 1 | 2 |\n")
    sheet = make(path)
    lists = [block for block in walk(sheet.blocks) if isinstance(block, Listing)]
    assert [each.start for each in lists] == [3, None]
    table = next(block for block in walk(sheet.blocks) if isinstance(block, Table))
    assert table.columns == ("left", "right") and len(table.rows) == 1
    assert "inner" in pdf_text(path)


def test_a_notebook_is_printed_without_its_code(document, pdf_text, tmp_path):
    cells = [
        {
            "cell_type": "markdown",
            "source": "---\ntitle: A lesson\narm: planar_2r\nfigures: []\n---\n\nWords.",
            "metadata": {},
        },
        {"cell_type": "code", "source": "print('never')", "metadata": {}, "outputs": []},
        {"cell_type": "markdown", "source": ["## Part\n", "\n", PROVED], "metadata": {}},
        {"cell_type": "markdown", "source": "---\n\nBelow a rule.", "metadata": {}},
    ]
    path = tmp_path / "lesson.ipynb"
    path.write_text(json.dumps({"cells": cells, "metadata": {}, "nbformat": 4, "nbformat_minor": 5}), encoding="utf-8")
    text = pdf_text(path)
    assert "A lesson" in text and "Part" in text and "never" not in text and "1 equation proved" in text
    assert "Below a rule." in text


def test_a_format_that_is_not_printed_is_named(tmp_path, make):
    path = tmp_path / "sheet.py"
    path.write_text("# %% [markdown]\n# $$ x = x $$\n", encoding="utf-8")
    with pytest.raises(
        PrintError, match=r"'\.py' files are not printed; those that are: \.md, \.qmd, \.ipynb, \.tex, \.rst"
    ):
        make(path)


@pytest.mark.parametrize(
    ("value", "message"),
    [
        ("3", "is a list of names"),
        ("[1, 2]", "is a list of names"),
        ("[{solutions: 1}]", "is a list of names"),
        ("[{answers: sketch}]", "is a list of names"),
        ("[{solutions: none_such}]", "no figure 'none_such'; the figures are"),
        ("[none_such]", "no figure 'none_such'; the figures are"),
    ],
)
def test_a_wrong_list_of_figures_is_refused(value: str, message: str, document, make):
    path = document(PROVED, front=f"---\ntitle: x\narm: planar_2r\nfigures: {value}\n---\n\n")
    with pytest.raises(ArmproofError, match=message):
        make(path)


def test_figures_need_an_arm(document, make):
    with pytest.raises(PrintError, match="this document names none"):
        make(document(PROVED, front="---\ntitle: x\nfigures: [sketch]\n---\n\n"))


@pytest.mark.parametrize(
    ("figures", "expected"), [("", ["sketch"]), ("figures: []\n", []), ("figures: sketch\n", ["sketch"])]
)
def test_a_document_has_the_figures_it_names_or_its_arms_sketch(figures: str, expected: list[str], document, make):
    path = document("Introduction.\n\n## Part\n\n" + PROVED, front=f"---\ntitle: x\narm: planar_2r\n{figures}---\n\n")
    pictures = [block for block in make(path).blocks if isinstance(block, Picture)]
    assert [Path(picture.path).stem for picture in pictures] == expected


def test_a_figure_may_be_of_another_arm_or_of_none(document, make):
    """A sheet without an arm explains a word, or shows the curves of an arm that it names; a kind that shows an arm needs one."""
    path = document(PROVED, front="---\ntitle: x\nfigures: [link, {quintic: scara}]\n---\n\n")
    pictures = [block for block in make(path, draft=True).blocks if isinstance(block, Picture)]
    assert [Path(picture.path).stem for picture in pictures] == ["link", "quintic"]
    assert "SCARA" not in plain(pictures[0].caption) and "SCARA" in plain(pictures[1].caption)
