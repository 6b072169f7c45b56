r"""Make a display plainer before it is read, every character at its place: what prints nothing is blank.

Markdown's escapes (`\_`, `\\theta`) lose their backslash, layout commands and boxes vanish, and of beamer's overlays the
last is read.
"""

from __future__ import annotations

import re

from armproof.verification.latex import greek
from armproof.verification.latex.congruences import with_multiples
from armproof.verification.latex.solids import with_solids
from armproof.verification.patterns import regex

_ARGUMENT = r"\s*\{(?:[^{}]|\{(?:[^{}]|\{[^{}]*\})*\})*\}"
_COMMAND = r"\s*(?:\{\s*\\[A-Za-z]+\s*\}|\\[A-Za-z]+)"
_LENGTH = r"\s*=?\s*[-+]?(?:\d+\.?\d*|\.\d+)\s*(?:pt|em|ex|mu|mm|cm|in|\\[A-Za-z]+)"
_OVERLAY = r"<[\d\s+,.|:a-z-]*>"
_ESCAPES = r"_*^()[]+="  # of Markdown: in a formula their backslash means nothing
_SILENT = regex(
    rf"(?P<kept>\\\\)|(?P<escape>\\[{re.escape(_ESCAPES)}])|(?P<set>\\[NRCQZ](?![A-Za-z]))|(?P<unequal>\\not\s*(?:=|\\in(?![A-Za-z])))"
    r"|(?P<degree>\^\s*\\(?:text)?degree(?![A-Za-z])|\^\s*\{?\\circ\}?\s*/\s*\\(?:text|mathrm|rm)\s*\{\s*s\s*\})|(?P<differential>\\dd?(?![A-Za-z]))|\\(?:d?dot|hat|vec|bar)\s*\{\s*\}"
    rf"|\\bf(?P<bold>[A-Za-z]|{'|'.join(sorted(greek.GREEK))})(?![A-Za-z])"
    rf"|\\(?:setlength|addtolength|settowidth|settoheight|settodepth){_COMMAND}{_ARGUMENT}|\\setcounter{_ARGUMENT}{_ARGUMENT}"
    rf"|\\(?:(?:re)?new|provide)command\*?{_COMMAND}(?:\s*\[[^\]]{{0,200}}\])*{_ARGUMENT}|\\def\s*\\[A-Za-z]+[^{{}}\\]*{_ARGUMENT}"
    rf"|\\(?:arraycolsep|tabcolsep|jot|lineskip|baselineskip|kern|mkern|hskip|mskip|vskip){_LENGTH}|\\arraystretch\s*=?\s*[\d.]*"
    rf"|\\(?:newlength|[hv]?phantom|label|vspace\*?){_ARGUMENT}|\\newlength\s*\\[A-Za-z]+"
    rf"|\\(?:pause|xspace|par|leavevmode|protect|boldmath|unboldmath|numberthis|qedhere|transparent)(?![A-Za-z])"
    rf"|\\(?:onslide|uncover|visible|only)\s*{_OVERLAY}(?!\s*\{{)|(?P<command>\\(?:color|text[a-z]+|math[a-z]+)){_OVERLAY}(?=\s*\{{)"
    r"|(?<=\\sqrt)\s*\[\s*2?\s*\]|[_^]\s*\{\s*\}|\\qty(?=\s*(?:\\left|\\[bB]ig+)?\s*[(\[])"
)
_BOX = regex(
    rf"\\(?:resizebox\*?{_ARGUMENT}{_ARGUMENT}|(?:scalebox|colorbox|adjustbox|raisebox|mathcolor){_ARGUMENT}|fcolorbox{_ARGUMENT}{_ARGUMENT}"
    rf"|makebox(?:\s*\[[^\]]{{0,200}}\])*|bbox(?:\s*\[[^\]]{{0,200}}\])?|math[lrc]lap|[lrc]lap|Aboxed|vcenter|displaylines"
    rf"|(?:alert|structure|invisible|action)(?:\s*{_OVERLAY})?|(?P<shown>only|uncover|visible|onslide|alt)\s*(?P<slides>{_OVERLAY}))\s*(?P<brace>\{{)\s*\$?"
)
_DOUBLED = regex(r"\\\\(?:\\\\|(?=[A-Za-z]{2,}|[{},;:!|]))")
_AT_THE_END = regex(
    r"\\q?quad[\s~]*(?:\\left)?\((?P<stated>[^()&]{0,200}(?:[=<>]|\\n?eq?\b|\\[lg]eq?\b|\\in\b)[^()&]{0,200}?)(?:\\right)?\)(?=[\s.,;]*$)"
)
_WORDS = r"\\(?:text|textrm|textit|mathrm|mbox)\s*\{[^\W\d_][^{}\\$=<>]*\}"
_BETWEEN_WORDS = r"(?:\\[ ,;:!]|\\[pm]{2}(?![A-Za-z])|[\s~,;/+±-])*"
_REMARK = regex(  # x = a + b \, (\text{elbow up} +): words in brackets behind a space are no factor
    rf"(?P<gap>(?:\\[ ,;:!]|\\q?quad|~)\s*)(?:\\left\s*)?\(\s*(?P<said>(?:{_WORDS}{_BETWEEN_WORDS})+)(?:\\right\s*)?\)"
)
_SIGN = regex(rf"(?P<words>{_WORDS})|(?:\\[pm]{{2}}(?![A-Za-z])|[,;/+±-])")
_LOST_BREAK = regex(
    r"(?<=&)(?P<line>[^\n\\&]*(?:\\[^\n&][^\n\\&]*)*)(?<!\\)\\(?P<end>[ \t]*\n)(?=[^\n]*&)"
)  # \ for \\, behind the last & of its line
_BROKEN = regex(  # a sum goes on: a - \\\\ b
    r"(?<=[\w)}])(?P<sign>\s*[-+]\s*)(?P<break>\\\\(?:\[[^\]]{0,20}\])?(?:\s*&(?=[^\\&=]*(?:\\(?!\\)[^\\&=]*)*(?:\\\\|\\end|\Z)))?)(?=\s*(?:[\w({]|\\(?!\\|begin|end|hline)))"
)
_REPEATED = regex(
    r"(?P<sign>\\(?:cdot|times)(?![A-Za-z])|=)(?P<again>\s*\\\\(?:\[[^\]]{0,20}\])?[\s&]*(?P=sign)(?![A-Za-z]))"
)  # A \cdot \\ \cdot B, A = \\ = B
_PRODUCT_BROKEN = regex(  # A \\ &\quad \cdot B and A \cdot \\ B: a product goes on; \cdot alone in a cell are dots
    r"(?<=[\w)}\]])(?P<sign>\s*(?:\\cdot|\\times)(?![A-Za-z]))?(?P<break>\s*\\\\(?:\[[^\]]{0,20}\])?(?:[\s&~]|\\q?quad(?![A-Za-z])|\\[,;:! ])*)"
    r"(?(sign)(?=[\w({]|\\(?!\\|begin|end|hline|cdot|times|[lv]?dots))|(?=(?:\\cdot|\\times)(?![A-Za-z])\s*(?:[\w({]|\\(?!\\|end|hline|cdot|[lv]?dots))))"
)
_FULL_STOP = regex(r"\\ldotp(?![A-Za-z])")
_APPLIED = regex(
    r"(?<![A-Za-z\\])J\{(?P<to>\s*(?:\\theta|\\Theta|[qQ])\s*)\}"
)  # J{\theta}: a macro of one argument, or parentheses
_RATES_BELOW = regex(  # = J(θ) \\ \dot θ: the factor stands in the last line, which states nothing by itself
    r"(?<=J)(?P<of>\s*\(\s*(?:\\theta|\\Theta|[qQ])\s*\))(?P<break>\s*\\\\\s*)(?=\\dot[^=&]*\Z)"
)
_OF_PANDOC = regex(r"(?<=[A-Za-z}])~(?P<below>\d{1,3}|[ijkn])~(?:\^(?P<above>[\dijkn])\^)?")  # H~0~^4^
_NUMBERED = regex(r"\A\s*\d{1,2}\.\s+(?=[\\A-Za-z])")  # 1. θ_1 = 0: an item of a list, and no factor
_DELIMITED = regex(r"\A(\s*)\\(?:\[(?=.*\\\]\s*\Z)|\((?=.*\\\)\s*\Z))(.*)\\[\])](\s*)\Z", re.DOTALL)  # $\[ x = 1 \]$
_DELIMITER_ESCAPED = regex(  # \\left\\\{, as Markdown wants it: nobody sets a new line between \left and what it opens
    r"(?P<size>\\(?:left|right)(?![A-Za-z])\s*)\\\\(?P<delimiter>\\?[{}])"
)
_SPACED_INDEX = regex(r"(?<=\\theta)\s(?P<index>\s*[1-9])(?=\s*[)+-])")  # \cos(\theta 1): nobody writes θ times one
_BARS = regex(r"\\(?:abs|(?P<norm>norm))\*?\s*(?P<brace>\{)")


_BRACKET_WITHIN = regex(
    r"_\{(\w{1,3})\)\}"
)  # \cos(\theta_1 + \theta_{2)}: the bracket closes what is open before the index


def prepared(text: str) -> str:
    """Return a display without what prints nothing, as long as it was and every character at its place."""
    if (
        "\\begin" in text and re.search(r"(?<!\\)\\begin", text) is None
    ):  # \\begin{matrix} a \\\\ b, from a string of Python
        text = _DOUBLED.sub(lambda found: found.group()[: len(found.group()) // 2].rjust(len(found.group())), text)
    text = _DELIMITER_ESCAPED.sub(
        lambda found: found["size"] + f"\\{found['delimiter'][-1]}".rjust(len(found.group()) - len(found["size"])), text
    )
    text = _SPACED_INDEX.sub(lambda found: "_" + found["index"], text)
    text = _DELIMITED.sub(lambda found: f"{found[1]}  {found[2]}  {found[3]}", text)
    text = _NUMBERED.sub(lambda found: _blank(found.group()), text)
    if "&" in text:
        text = _LOST_BREAK.sub(lambda found: found["line"] + "\\\\" + found["end"][1:], text)
    text = _APPLIED.sub(lambda found: f"J({found['to']})", text)
    text = _RATES_BELOW.sub(lambda found: found["of"] + _blank(found["break"]), text)
    text = _BROKEN.sub(lambda found: found["sign"] + _blank(found["break"]), text)
    text = _REPEATED.sub(lambda found: found["sign"] + _blank(found["again"]), text)
    text = _PRODUCT_BROKEN.sub(lambda found: (found["sign"] or "") + _blank(found["break"]), text)
    text = _FULL_STOP.sub(lambda found: ".".ljust(len(found.group())), text)
    text = _REMARK.sub(_said_beside, _OF_PANDOC.sub(_scripts, text)) if "(" in text or "~" in text else text
    text = _without_boxes(text) if _BOX.search(text) or _BARS.search(text) else text
    text = _BRACKET_WITHIN.sub(r"_{\1})", text) if ")}" in text else text
    return with_multiples(with_solids(_SILENT.sub(_plain, _AT_THE_END.sub(_for, text))))


def _for(found: re.Match[str]) -> str:
    """R = I \\quad (θ = 0) says at the end where it holds."""
    start = found.start("stated") - found.start()
    return " for".ljust(start) + found["stated"].ljust(len(found.group()) - start)


def _said_beside(found: re.Match[str]) -> str:
    """Leave of a remark its words alone."""
    said = _SIGN.sub(lambda part: part["words"] or _blank(part.group()), found["said"])
    before, behind = found.group().split(found["said"], 1)
    return found["gap"] + _blank(before[len(found["gap"]) :]) + said + _blank(behind)


def _scripts(found: re.Match[str]) -> str:
    """Write the scripts of Pandoc's Markdown as those of LaTeX."""
    return f"_{found['below']} " + (f"^{found['above']} " if found["above"] else "")


def _plain(found: re.Match[str]) -> str:
    if found["kept"]:
        return found.group()
    if found["unequal"]:
        return ("\\ne" if found.group().endswith("=") else "\\notin").ljust(len(found.group()))
    if found["degree"]:
        return "^\\circ".ljust(len(found.group()))
    if found["differential"]:
        return "d".rjust(len(found.group()))
    if found["escape"] or found["set"]:
        return " " + found.group()[1]
    if found["bold"]:  # \\bfq and \\bfomega: macros for bold letters, wherever they are defined
        letter = found["bold"] if len(found["bold"]) == 1 else f"\\{found['bold']}"
        return letter.rjust(len(found.group()))
    command = found["command"] or ""
    return command + _blank(found.group()[len(command) :])


def _blank(text: str) -> str:
    return re.sub(r"[^\n]", " ", text)


def _without_boxes(text: str) -> str:
    """Take the boxes and overlays off what stands in them; what the last overlay does not show goes with them."""
    closing = _partners(text)
    letters = list(text)
    last = max((_numbers(found["slides"])[-1] for found in _BOX.finditer(text) if found["slides"]), default=0)
    hidden = 0  # up to where
    for found in _BOX.finditer(text):
        if (end := closing.get(found.start("brace"))) is None or found.start() < hidden:
            continue
        other = re.compile(r"\s*\{").match(text, end + 1) if found["shown"] == "alt" else None
        spans = [found.span(), (_before_dollar(text, end), end + 1)]
        shown = not found["slides"] or _shows(found["slides"], last)
        if other and (far := closing.get(other.end() - 1)) is not None:
            spans += [(end + 1, far + 1)] if shown else [(found.start(), end + 1), other.span(), (far, far + 1)]
        elif not shown:
            spans, hidden = [(found.start(), end + 1)], end
        for start, stop in spans:
            letters[start:stop] = _blank("".join(letters[start:stop]))
    for found in _BARS.finditer(text):
        if (end := closing.get(found.start("brace"))) is not None:
            bar = "‖" if found["norm"] else "|"
            letters[found.start() : found.end()] = " " * (found.end() - found.start() - 1) + bar
            letters[end] = bar
    return "".join(letters)


def _before_dollar(text: str, end: int) -> int:
    """Return where the closing brace begins, the dollar of a formula in a box with it."""
    return end - 1 if text[end - 1] == "$" else end


def _numbers(slides: str) -> list[int]:
    """Return the numbers of an overlay's slides, ascending; 0 for <+->."""
    return sorted(int(number) for number in re.findall(r"\d{1,4}", slides)) or [0]


def _shows(slides: str, last: int) -> bool:
    """Whether what stands on these slides is on the last: <3->, or <1-3> where no overlay names a later one."""
    return slides.rstrip("]> ").endswith("-") or _numbers(slides)[-1] == last


def _partners(text: str) -> dict[int, int]:
    """Return where the brace that opens at a place is closed."""
    partners: dict[int, int] = {}
    opened: list[int] = []
    for found in re.finditer(r"\\.|[{}]", text, re.DOTALL):
        if found.group() == "{":
            opened.append(found.start())
        elif found.group() == "}" and opened:
            partners[opened.pop()] = found.start()
    return partners
