"""Outputs as HTML: the richest safe form, with nothing in it that runs or leads away."""

from __future__ import annotations

import pytest
from markupsafe import Markup

from armproof.course.site.cleaning import clean
from armproof.course.site.outputs import show_outputs
from armproof.course.site.writer import highlight


def shown(**data: str) -> str:
    output = {"output_type": "display_data", "data": {key.replace("_", "/"): value for key, value in data.items()}}
    return str(show_outputs([output], "c1-", "Figure", lambda text: Markup("<b>{}</b>").format(text)).html)


def test_the_richest_form_is_shown():
    assert "<i>rich</i>" in shown(text_html="<i>rich</i>", text_plain="plain")
    assert "data:image/png;base64,AAAA" in shown(image_png="AA\nAA", text_plain="plain")
    assert "data:image/svg+xml" in shown(**{"image_svg+xml": "<svg/>", "image_png": "AAAA"})
    assert "<b>words</b>" in shown(text_markdown="words", text_plain="plain")
    assert "<samp>a &lt; b</samp>" in shown(text_plain="a < b")


def test_what_only_says_where_an_object_is_stored_is_left_out():
    assert shown(text_plain="<matplotlib.axes._axes.Axes object at 0x7f12>") == ""
    assert shown(text_plain="<a> <b>") != ""


def test_the_pieces_of_a_stream_are_one_and_errors_of_libraries_are_left_out():
    pieces = [{"output_type": "stream", "name": name, "text": text}
              for name, text in (("stdout", "one "), ("stderr", "a warning"), ("stdout", "\x1b[31mtwo\x1b[0m\n"))]  # fmt: skip
    html = str(show_outputs(pieces, "c1-", "Figure").html)
    assert html.count("<pre") == 1 and "<samp>one two</samp>" in html and "warning" not in html


def test_a_picture_is_called_by_its_title_or_by_the_section():
    assert 'alt="The arm, stretched"' in shown(**{"image_svg+xml": "<svg><title>The arm, stretched</title></svg>"})
    assert 'alt="Figure"' in shown(**{"image_svg+xml": "<svg/>"})


@pytest.mark.parametrize(
    ("given", "kept"),
    [
        ("<p>a<script>b</script>c</p>", "<p>ac</p>"),
        ("<p onclick='x'>a</p>", "<p>a</p>"),
        ("<p style='background:url(http://x/)'>a</p>", "<p>a</p>"),
        ("<img src='http://192.0.2.1/x.png' alt=a>", '<img alt="a">'),
        ("<img src='data:image/png;base64,AAAA'>", '<img src="data:image/png;base64,AAAA" alt="">'),
        ("<img src='data:text/html,<script>'>", '<img alt="">'),
        ("<a href='javascript:x()'>a</a>", "<a>a</a>"),
        ("<iframe src='x'>a</iframe>b", "b"),
        ("<svg><a xlink:href='http://x'><text>t</text></a></svg>", "<svg><a><text>t</text></a></svg>"),
        ("<svg><rect fill='url(http://x/#a)'/></svg>", "<svg><rect></rect></svg>"),
        ("<svg><rect fill='url(#a)'/></svg>", '<svg><rect fill="url(#c-a)"></rect></svg>'),
        ("<pre>a</pre>", '<pre tabindex="0" role="group" aria-label="Output">a</pre>'),
        ("<h1>a</h1>", '<p class="heading">a</p>'),
        ("<div><p>open", "<div><p>open</p></div>"),
        ("</div>a</p>", "a"),
        ("<i id=x aria-labelledby='y z'>a</i>", '<i id="c-x" aria-labelledby="c-y c-z">a</i>'),
        ("<math><mi>x</mi></math>", "<math><mi>x</mi></math>"),
        ("<form><input value=a><button>b</button></form>c", "c"),
        ("a &amp; b &lt;script&gt;", "a &amp; b &lt;script&gt;"),
        ("<table><tr><td colspan=2>a</table>", '<table><tr><td colspan="2">a</td></tr></table>'),
    ],
)  # fmt: skip
def test_only_what_shows_something_is_kept(given, kept):
    assert str(clean(given, "c-").html) == kept


def test_a_style_is_set_apart():
    found = clean("<style>p { color: red }</style><p>a</p>", "c-")
    assert found.styles == ("p { color: red }",) and str(found.html) == "<p>a</p>"


def test_python_is_coloured_by_classes_and_escaped():
    html = str(highlight('def f(x):  # a < b\n    """Words."""\n    return 1 < x\n'))
    assert '<span class="py-keyword">def</span>' in html and '<span class="py-name">f</span>' in html
    assert '<span class="py-comment"># a &lt; b</span>' in html and '<span class="py-number">1</span>' in html
    assert "style=" not in html and not html.endswith("\n")


def test_the_markers_of_a_solution_are_not_shown():
    source = "def f():\n    ### BEGIN SOLUTION\n    return 1\n    ### END SOLUTION\n"
    assert "SOLUTION" not in highlight(source) and "### A HEADING" in highlight("### A HEADING")
