"""The pages as files: whole, valid, escaped, of a modest size, and saying what the record says."""

import json
import re
from collections import Counter
from html.parser import HTMLParser
from pathlib import Path

import pytest

from armproof.verification.check import check_document
from armproof.verification.cli.documents import check_paths
from armproof.verification.document import parse_document
from armproof.verification.findings import Kind, say
from armproof.verification.report.html.page import render_page
from armproof.verification.report.html.site import INDEX, VERDICTS, page_names, render_index
from armproof.verification.report.html.templating import versions
from armproof.verification.verdict import DocumentResult, Failure

LARGEST = 400_000  # bytes
VOID = frozenset("area br col hr img input link meta".split())


class Outline(HTMLParser):
    """Reads a page strictly: every element is closed where it should be."""

    def __init__(self, page: str) -> None:
        super().__init__()
        self.open: list[str] = []
        self.ids: Counter[str] = Counter()
        self.references: set[str] = set()
        self.headings: list[int] = []
        self.attributes: list[tuple[str, str]] = []
        self.feed(page)
        self.close()
        assert not self.open, self.open

    def handle_starttag(self, tag: str, attributes: list[tuple[str, str | None]]) -> None:
        if tag not in VOID:
            self.open.append(tag)
        if re.fullmatch("h[1-6]", tag):
            self.headings.append(int(tag[1]))
        names = [name for name, _ in attributes]
        assert len(names) == len(set(names)), f"an attribute twice on {tag}"
        for name, value in attributes:
            self.attributes.append((name, value or ""))
            if name == "id":
                self.ids[value or ""] += 1
            if (name == "href" and (value or "").startswith("#")) or name == "aria-labelledby":
                self.references.add((value or "").lstrip("#"))

    def handle_startendtag(self, tag: str, attributes: list[tuple[str, str | None]]) -> None:
        self.handle_starttag(tag, attributes)
        if tag not in VOID:
            self.open.pop()

    def handle_endtag(self, tag: str) -> None:
        assert self.open and self.open[-1] == tag, f"</{tag}> closes {self.open[-1:]}"
        self.open.pop()


def pages(folder: Path) -> list[Path]:
    found = sorted(folder.glob("*.html"))
    assert len(found) > 1
    return found


@pytest.mark.parametrize("report", ["course_report", "wrong_report", "hostile_report"])
def test_every_page_is_valid(report: str, request: pytest.FixtureRequest) -> None:
    for page in pages(request.getfixturevalue(report)):
        outline = Outline(page.read_text(encoding="utf-8"))
        assert max(outline.ids.values()) == 1, page
        assert outline.references <= set(outline.ids), page
        assert outline.headings[0] == 1 and outline.headings.count(1) == 1, page
        assert all(
            after - before <= 1 for before, after in zip(outline.headings, outline.headings[1:], strict=False)
        ), page
        assert not any(name == "style" or name.startswith("on") for name, _ in outline.attributes), page


@pytest.mark.parametrize("page", ["<p><b></p>", "<ul><li></ul>", "<p"])
def test_a_page_that_is_not_valid_is_noticed(page: str) -> None:
    if page == "<p":
        assert not Outline(page).ids  # nothing of it is there
        return
    with pytest.raises(AssertionError):
        Outline(page)


def test_no_page_is_large_or_refers_to_the_network(course_report: Path) -> None:
    for page in pages(course_report):
        assert page.stat().st_size <= LARGEST
        text = page.read_text(encoding="utf-8")
        assert "default-src &#39;none&#39;" in text and not re.search(r"\b(?:src|href|action)=\"(?:https?:)?//", text)


def test_there_is_a_page_a_document_and_the_index_leads_to_each(course_report: Path) -> None:
    index = (course_report / INDEX).read_text(encoding="utf-8")
    verdicts = json.loads((course_report / VERDICTS).read_text(encoding="ascii"))
    links = set(re.findall(r'href="([^"#]+\.html)"', index))
    assert links == {page.name for page in pages(course_report)} - {INDEX}
    assert len(links) == len(verdicts["documents"])
    assert all(f"<code>{document['path']}</code>" in index for document in verdicts["documents"])


def test_a_page_begins_with_the_answer_then_the_errata_sheet(wrong_report: Path) -> None:
    page = (wrong_report / "planar-2r.html").read_text(encoding="utf-8")
    parts = [page.index(words) for words in ("This document does not pass", "What to correct", "Errata sheet</h2>",
             "Errata of the source</h2>", "Every equation</h2>", "Coverage by section", "The arm:", "How it was computed</h2>")]  # fmt: skip
    assert parts == sorted(parts)
    assert "1 document, 5 displays: 1 proved, 3 refuted, 1 erratum refuted; 1 table: 1 refuted" in page
    assert all(name in page and number in page for name, number in versions())
    assert "seed 2019" in page


def test_a_refuted_equation_stands_beside_the_right_one(wrong_report: Path) -> None:
    page = (wrong_report / "planar-2r.html").read_text(encoding="utf-8")
    sheet = page[page.index('id="sheet-line-20"') : page.index('id="sheet-line-22"')]
    assert sheet.index("As printed") < sheet.index("As it should be")
    assert sheet.count('<mtd class="wrong" aria-label="wrong entry">') == 1
    assert sheet.count('<mtd class="right" aria-label="corrected entry">') == 1
    assert "wrong sign" in sheet and "row 1, column 2" in sheet and "Line 20" in sheet
    assert re.search(r'<svg class="sketch" role="img" aria-label="[^"]*as it is and as printed"', sheet)
    corrected = re.search(
        r'<code>([^<]*)</code></pre><button type="button" class="copy" data-copy="([^"]*)" hidden>',
        sheet[sheet.index("Corrected LaTeX") :],
    )
    assert corrected and corrected[1] == corrected[2] and "&amp; -l_2 S_{12}" in corrected[1]


def test_a_wrong_row_of_a_table_is_marked_in_the_table(wrong_report: Path) -> None:
    page = (wrong_report / "planar-2r.html").read_text(encoding="utf-8")
    assert len(re.findall(r'<td class="wrong">', page)) == 2  # in the sheet, and in its place
    assert len(re.findall(r'<td class="right">', page)) == 1


def test_a_passing_document_has_nothing_to_correct(course_report: Path) -> None:
    page = (course_report / "planar-2r-002.html").read_text(encoding="utf-8")
    assert "This document passes" in page and "22 displays: 22 proved" in page
    assert "What to correct" not in page and 'class="wrong"' not in page


def test_every_erratum_of_the_course_is_in_a_sheet_with_a_marked_entry_or_a_reason(course_report: Path) -> None:
    verdicts = json.loads((course_report / VERDICTS).read_text(encoding="ascii"))
    for document in verdicts["documents"]:
        errata = [equation for equation in document["equations"] if equation["erratum"]]
        page = (course_report / f"{Path(document['path']).stem}.html").read_text(encoding="utf-8")
        assert page.count('<article class="correction ') == len(errata)
        for equation in errata:
            start = page.index(f'id="sheet-line-{equation["line"]}"')
            sheet = page[start : page.index("</article>", start)]
            assert re.search(r'<p class="cause">\S', sheet)
            assert ("wrong entry" in sheet) or not equation["entries"]


def test_the_counts_of_the_pages_are_those_of_the_verdicts(course_report: Path) -> None:
    verdicts = json.loads((course_report / VERDICTS).read_text(encoding="ascii"))
    for document in verdicts["documents"]:
        page = (course_report / f"{Path(document['path']).stem}.html").read_text(encoding="utf-8")
        states = Counter(re.findall(r'data-state="(\w+)"', page))
        records = document["equations"] + document.get("tables", [])
        records += [document["inverse"]] if "inverse" in document else []
        expected = Counter("erratum" if r["erratum"] and r["verdict"] == "refuted" else r["verdict"] for r in records)
        assert states == expected


def test_the_names_of_pages_are_plain_and_each_its_own() -> None:
    paths = [
        Path(p)
        for p in (
            "a/été à.md",
            "b/été à.md",
            "a/<script>.md",
            "index.md",
            "a/Index.md",
            "x/" + "l" * 300 + ".md",
            "…/✗.md",
        )
    ]
    names = page_names(paths)
    assert len({name.casefold() for name in names.values()}) == len(paths) and INDEX not in names.values()
    assert all(re.fullmatch(r"[A-Za-z0-9._-]{1,90}\.html", name) for name in names.values())
    assert names[str(paths[0])] == "ete-a.html"


def test_a_document_that_cannot_be_checked_is_named_in_the_index() -> None:
    failure = Failure("a <b>.md", say(Kind.PROBLEM, reason="no arm 'x'"), 3)
    page = render_index({}, [failure])
    assert "could not be checked" in page and "a &lt;b&gt;.md" in page and "no arm" in page and "(line 3)" in page


def test_unreadable_displays_are_shown_as_source(tmp_path: Path) -> None:
    (tmp_path / "page.md").write_text("$$ \\foo{<i>} = 1 $$\n", encoding="utf-8")
    from armproof.verification.cli.documents import check_and_report

    (result,) = check_and_report([tmp_path / "page.md"], tmp_path / "report")
    assert isinstance(result, DocumentResult) and not result.passed
    page = (tmp_path / "report" / "page.html").read_text(encoding="utf-8")
    assert '<pre class="raw"><code> \\foo{&lt;i&gt;} = 1 </code></pre>' in page and "What to correct" in page


def test_the_same_documents_give_the_same_report(wrong_report: Path, tmp_path: Path) -> None:
    from armproof.verification.cli.documents import check_and_report

    source = wrong_report.parent / "planar-2r.md"
    check_and_report([source], tmp_path / "again")
    for page in pages(wrong_report):
        again = (tmp_path / "again" / page.name).read_text(encoding="utf-8")
        assert re.sub(r'"max_error": \S+', "", again) == re.sub(
            r'"max_error": \S+', "", page.read_text(encoding="utf-8")
        )


def test_what_no_page_was_asked_for_is_checked_as_before(tmp_path: Path) -> None:
    (tmp_path / "page.md").write_text("$$ (a + b)^2 = a^2 + 2ab + b^2 $$\n", encoding="utf-8")
    (result,) = check_paths([tmp_path])
    assert isinstance(result, DocumentResult) and result.passed
    assert [path.name for path in tmp_path.iterdir()] == ["page.md"]


def test_a_page_shows_the_remarks_on_its_document() -> None:
    text = "---\nlayout: post\narm: planar_2r\n---\n\n$$ \\det J = l_1 l_2 s_2 $$\n"
    for written, told in ((text, True), (text.replace("layout: post\n", ""), False)):
        document = parse_document(Path("page.md"), written)
        page = render_page(document, check_document(document))
        assert ("front-matter keys of other tools are left alone: layout" in page) is told


def test_the_index_says_what_an_arm_was_taken_from() -> None:
    text = "$$ x = l_1 c_1 + l_2 c_{12} $$\n\n$$ y = l_1 s_1 + l_2 s_{12} $$\n\n$$ \\det J = l_1 l_2 s_2 $$\n"
    result = check_document(parse_document(Path("handout.md"), text))
    index = render_index({result.path: "handout.html"}, [result])
    assert "<td>arm of the closed form at line 1, classic DH</td>" in index and "DH table" not in index
