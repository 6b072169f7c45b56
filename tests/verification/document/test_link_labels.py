"""Labels of links are found as markdown-it finds them, however many are open."""

import random

import pytest
from markdown_it import MarkdownIt
from mdit_py_plugins.dollarmath import dollarmath_plugin

from armproof.verification.document.link_labels import with_quick_labels

PIECES = ("[", "![", "]", "](", "](u)", "][r]", "[r]", "a", "`", "$x$", "$", "*", "_", "<a>", "\\", "\\[", "\n", "(", ")", '"t"', "<http://a>")  # fmt: skip


def reader() -> MarkdownIt:
    return MarkdownIt("commonmark").use(dollarmath_plugin)


def tokens(markdown: MarkdownIt, text: str) -> list[dict[str, object]]:
    return [token.as_dict() for token in markdown.parse(text)]


def test_every_text_has_the_tokens_that_markdown_it_gives_it() -> None:
    drawn, quick, plain = random.Random(20261128), with_quick_labels(reader()), reader()
    links = 0
    for _ in range(2_000):
        text = "".join(drawn.choices(PIECES, k=drawn.randint(1, 30))) + "\n\n[r]: /x\n"
        assert tokens(quick, text) == tokens(plain, text), text
        links += "link_open" in str(tokens(quick, text))
    assert links > 100


@pytest.mark.parametrize(
    "text", ["[a [b](u) c](v)", "[a ![b](u) c](v)", "![a [b](u) c](v)", "[[[[a]]]](u)", "[a]b](u)"]
)
def test_a_link_holds_no_link(text: str) -> None:
    assert tokens(with_quick_labels(reader()), text) == tokens(reader(), text)
