"""From rows and cells to statements: chains of relations, and what connects them."""

from __future__ import annotations

from dataclasses import replace

from lark import Token

from armproof.verification.errors import ReadError
from armproof.verification.findings import Kind, say
from armproof.verification.latex import nodes as n
from armproof.verification.latex.nodes import bare
from armproof.verification.latex.tokens import span_of_token
from armproof.verification.latex.vocabulary import JOINING, LAYOUTS, MATRICES, SPOKEN
from armproof.verification.patterns import regex

ARROWS = ("⇒", "⇔", "⇐")
_TRANSFORMS = frozenset("TRAH")
_BLANK_CELL = regex(r"&(?:[ \t]|\\[,;:! ])+&")
UNREAD = "unread"  # the kind of a relation of which a side cannot be read: "= constant"
Cell = list  # of Node and Token, in the order of the line
PREVIOUS = n.Name("=", text="")  # stands for the subject of the display before: a display may begin with "="


class _Statements:
    """Collects chains as the parts of a display go by."""

    def __init__(self) -> None:
        self.done: list[n.Statement] = []
        self.members: list[n.Node] = []
        self.relations: list[str] = []

    def close(self) -> None:
        """End the chain that is open, if any."""
        if not self.members:
            return
        unread = self.relations[len(self.members) - 1 :]
        self.relations = self.relations[: len(self.members) - 1]
        for member in self.members[:-1]:
            if isinstance(member, n.Layout):
                raise ReadError(say(Kind.SEVERAL_EQUATIONS), member.span[0])
        if len(self.members) == 1 and isinstance(self.members[0], n.Layout):
            self.done.extend(self.members[0].statements)
        else:
            span = (self.members[0].span[0], self.members[-1].span[1])
            self.done.append(n.Chain(tuple(self.members), tuple(self.relations), span=span))
            self._follow_from_condition()
        if unread:
            self.done.append(n.Connective(UNREAD, unread[0], span=(self.members[-1].span[1],) * 2))
        self.members, self.relations = [], []

    def _follow_from_condition(self) -> None:
        """Let each equation in the brace of "if s_5 < 0 { θ_4 = …, θ_6 = …" follow from what stands before the brace."""
        said, chain = self.done[-2] if len(self.done) > 1 else None, self.done[-1]
        if not (isinstance(said, n.Connective) and said.kind == "if" and isinstance(chain, n.Chain)):
            return
        if not isinstance(last := chain.members[-1], n.Product):
            return
        *bound, layout = last.factors
        if not isinstance(layout, n.Layout) or not all(isinstance(each, n.Chain) for each in layout.statements):
            return
        rest = replace(last, factors=tuple(bound), operators=last.operators[:-1]) if len(bound) > 1 else bound[0]
        condition = replace(chain, members=(*chain.members[:-1], rest))
        implied = ((condition, n.Connective("⇒", "⇒"), each) for each in layout.statements)
        self.done[-2:] = [part for each in implied for part in each]

    def reopen(self) -> None:
        """Take up the last chain again: a line or a display that begins with a relation continues it."""
        spoken = len(self.done)  # "x = a, thus = b": what is said between is passed over
        while spoken and isinstance(said := self.done[spoken - 1], n.Connective) and said.kind in ("words", UNREAD):
            spoken -= 1
        if spoken and isinstance(last := self.done[spoken - 1], n.Chain):
            del self.done[spoken - 1]
            self.members, self.relations = list(last.members), list(last.relations)
        else:
            self.members = [PREVIOUS]

    def expression(self, node: n.Node) -> None:
        if len(self.members) > len(self.relations):
            self.close()
        self.members.append(node)

    def relation(self, token: Token) -> None:
        if not self.members:
            is_first = not any(isinstance(each, n.Chain) for each in self.done)
            last = self.done[-1] if self.done else None
            said = (
                {word.strip(".,:").lower() for word in last.text.split()} if isinstance(last, n.Connective) else set()
            )
            if is_first and isinstance(last, n.Connective) and last.kind == "words" and not said & JOINING:
                self.done.append(n.Connective(UNREAD, f"{last.text} {token.value}", span=span_of_token(token)))
            self.reopen()
        if len(self.relations) >= len(self.members):
            raise ReadError(say(Kind.TWO_RELATIONS, text=str(token.value)), span_of_token(token)[0])
        self.relations.append(token.value)

    def connective(self, kind: str, token: Token) -> None:
        self.close()
        if kind == "words" and self.done and isinstance(last := self.done[-1], n.Connective) and last.kind == UNREAD:
            self.done[-1] = replace(last, text=f"{last.text} {token.value}")
        self.done.append(n.Connective(kind, token.value, span=span_of_token(token)))

    def together(self, place: int) -> None:
        """Let what follows hold together with the equation before it."""
        self.close()
        self.done.append(n.Connective("and", "", span=(place, place)))


def build_statements(rows: list[list[Cell]]) -> list[n.Statement]:
    """Read the lines of a display, or of a layout environment, as statements."""
    found = _Statements()
    for row in rows:
        parts = [part for cell in row for part in cell]
        first = next((p for p in parts if not (isinstance(p, Token) and p.type == "SEP")), None)
        has_relation = any(isinstance(p, Token) and p.type in ("REL", "CONN") for p in parts)
        if isinstance(first, n.Sum) and not has_relation and _starts_with_sign(first) and (found.members or found.done):
            _continue_sum(found, first)
            parts = parts[parts.index(first) + 1 :]
        elif not (found.members and len(found.relations) == len(found.members)):
            found.close()
        parts = _with_spaced_factors(parts)
        joined = _joined_cells(row)
        for part in parts:
            if isinstance(part, n.Node):
                if any(part is first for first in joined):
                    found.together(part.span[0])
                found.expression(part)
            elif part.type == "REL":
                found.relation(part)
            elif part.type == "CONN":
                found.connective(part.value, part)
            elif part.type == "UNREAD":
                found.connective(UNREAD, part)
            elif part.type == "TEXT":
                found.connective(_word_kind(part.value), part)
            elif not (found.members and len(found.relations) == len(found.members)):  # SEP, COMMA
                found.close()
    found.close()
    return found.done


def _with_spaced_factors(parts: list) -> list:
    """Return the parts of a line with transforms that only wide spaces part as one product: {}^0_2T = \\quad {}^0_1T \\quad {}^1_2T."""
    found: list = []
    for place, part in enumerate(parts):
        behind = next((each for each in parts[place + 1 :] if not _is_space(each)), None)
        before = next((k for k in reversed(range(len(found))) if not _is_space(found[k])), None)
        if before is None or not _is_space(found[-1]) or not _goes_on(found[before], part):
            found.append(part)
            continue
        is_left = isinstance(behind, Token) and behind.type == "REL"
        stated = _holds(found[:before], "REL")
        if stated == is_left or (is_left and isinstance(found[before], n.Name)):
            found.append(part)
            continue
        factors = (*_factors(found[before]), *_factors(part))
        span = (found[before].span[0], part.span[1])
        found[before:] = [n.Product(factors, ("",) * (len(factors) - 1), span=span)]
    return found


def _is_space(part: n.Node | Token) -> bool:
    return isinstance(part, Token) and part.type == "SEP" and part.value != ";"


def _factors(node: n.Node) -> tuple[n.Node, ...]:
    return node.factors if isinstance(node, n.Product) and not any(node.operators) else (node,)


def _goes_on(before: n.Node | Token, behind: n.Node | Token) -> bool:
    """Whether two expressions are transforms of which the second begins in a frame of the first."""
    if isinstance(before, Token) or isinstance(behind, Token):
        return False
    last, first = _factors(before)[-1], _factors(behind)[0]
    names = [each for each in (*_factors(before), *_factors(behind)) if not isinstance(bare(each), n.Matrix)]
    return all(map(_frames, names)) and (isinstance(bare(first), n.Matrix) or bool(_frames(last) & _frames(first)))


def _frames(node: n.Node) -> set[str]:
    """Return the two frames in the scripts of a transform's name, or of its inverse."""
    node = bare(node.base) if isinstance(node, n.Power | n.Postfix) else bare(node)
    if not isinstance(node, n.Name) or node.base not in _TRANSFORMS:
        return set()
    found = [script for script in (node.pre_sup, node.pre_sub, node.sup, node.sub) if script]
    return set(found) if len(found) == 2 else set()


def _joined_cells(row: list[Cell]) -> list[n.Node]:
    """Return the first nodes of equations that fill a cell each, one after the other before an arrow: they hold together."""
    arrow = next((k for k, cell in enumerate(row) if _arrow_in(cell)), 0)
    cells = [cell for cell in row[:arrow] if cell]
    filled = [isinstance(cell[0], n.Node) and _holds(cell, "REL") for cell in cells]
    return [cells[k][0] for k in range(1, len(cells)) if filled[k - 1] and filled[k]]


def _holds(cell: Cell, kind: str) -> bool:
    return any(isinstance(part, Token) and part.type == kind for part in cell)


def _arrow_in(cell: Cell) -> bool:
    return any(isinstance(part, Token) and part.type == "CONN" and part.value in ARROWS for part in cell)


def _word_kind(text: str) -> str:
    words = text.strip(" .,;:").lower()
    return next((kind for kind, spoken in SPOKEN.items() if words in spoken), "words")


def _starts_with_sign(node: n.Sum) -> bool:
    first = node.terms[0][1]
    return node.span[0] < first.span[0]


def _continue_sum(found: _Statements, more: n.Sum) -> None:
    """A line that begins with a sign and states no relation goes on with the sum of the line before."""
    if not found.members:
        found.reopen()
    if not found.members or found.members[-1] is PREVIOUS:
        raise ReadError(say(Kind.LINE_CONTINUES_NOTHING), more.span[0])
    last = found.members[-1]
    terms = last.terms if isinstance(last, n.Sum) else (("+", last),)
    found.members[-1] = n.Sum((*terms, *more.terms), span=(last.span[0], more.span[1]))


def environment_node(name: str, rows: list[list[Cell]], span: tuple[int, int], text: str) -> n.Node:
    """A matrix, lines of equations, or a brace of cases, by what the cells hold."""
    if name in MATRICES - {"array"}:
        _check_blank(rows, span, text)
    rows = _without_empty(rows)
    relations = [
        any(isinstance(part, Token) and part.type == "REL" for part in cell) for row in rows for cell in row[:1]
    ]
    anywhere = any(
        isinstance(part, Token) and part.type in ("REL", "CONN") for row in rows for cell in row for part in cell
    )
    if name in ("cases", "dcases", "rcases") and not any(relations) and not _are_aligned(rows):
        return _cases(rows, span, text)
    if name in LAYOUTS or anywhere:
        if len(rows) == 1 and len(rows[0]) == 1 and len(rows[0][0]) == 1 and isinstance(rows[0][0][0], n.Node):
            return rows[0][0][0]  # an alignment that holds one expression
        return n.Layout(tuple(build_statements(rows)), span=span)
    rows = [_among_dots(row) for row in _checked(rows, span)]
    return n.Matrix(tuple(tuple(_matrix_cell(cell, span) for cell in row) for row in rows), name, span=span)


def _are_aligned(rows: list[list[Cell]]) -> bool:
    """Whether each row is an equation that is aligned at its sign, x &= …: what a case holds for begins with no sign."""
    seconds = [row[1][:1] if len(row) > 1 else [] for row in rows]
    return all(isinstance(part, Token) and part.type == "REL" for second in seconds for part in second or [None])


def _checked(rows: list[list[Cell]], span: tuple[int, int]) -> list[list[Cell]]:
    if not rows:
        raise ReadError(say(Kind.NO_CELLS), span[0])
    return rows


def _check_blank(rows: list[list[Cell]], span: tuple[int, int], text: str) -> None:
    """Refuse a matrix with a blank column or a blank row between others: it may stand for zeros. `&&` sets columns off widely."""
    width = max((len(row) for row in rows), default=0)
    empty = [all(len(row) <= column or not row[column] for row in rows) for column in range(width)]
    blank = [len(row) > 1 and not any(row) for row in rows]
    if (any(empty[:-1]) and _BLANK_CELL.search(text, *span)) or any(blank[:-1]):
        raise ReadError(say(Kind.EMPTY_CELL), span[0])


def _without_empty(rows: list[list[Cell]]) -> list[list[Cell]]:
    """Drop empty lines, and the empty columns that `&&` leaves."""
    rows = [row for row in rows if any(cell for cell in row)]
    width = max((len(row) for row in rows), default=0)
    empty = [all(len(row) <= column or not row[column] for row in rows) for column in range(width)]
    return [[cell for column, cell in enumerate(row) if not empty[column]] for row in rows]


def _among_dots(row: list[Cell]) -> list[Cell]:
    r"""Return a row whose cells are dots or empty, \vdots & & \vdots, with dots for those that are empty."""
    dots = next((cell for cell in row if len(cell) == 1 and isinstance(cell[0], n.Dots)), None)
    are_all = all(len(cell) == 1 and isinstance(cell[0], n.Dots) for cell in row if cell)
    return [cell or dots for cell in row] if dots is not None and are_all else row


def _matrix_cell(cell: Cell, span: tuple[int, int]) -> n.Node:
    parts = [part for part in cell if not (isinstance(part, Token) and part.type in ("SEP", "COMMA"))]
    if len(parts) == 1 and isinstance(parts[0], n.Node):
        return parts[0]
    words = [part for part in parts if isinstance(part, Token) and part.type == "TEXT"]
    if words:
        return _in_words(words)
    if not parts:
        raise ReadError(say(Kind.EMPTY_CELL), span[0])
    if all(isinstance(part, n.Number) for part in parts):  # 0 \\quad 0 \\quad 0: a row of a block of three columns
        return n.Matrix((tuple(parts),), "matrix", span=(parts[0].span[0], parts[-1].span[1]))
    second = parts[1]
    where = span_of_token(second)[0] if isinstance(second, Token) else second.span[0]
    raise ReadError(say(Kind.SEVERAL_IN_CELL), where)


def _in_words(words: list[Token]) -> n.Node:
    """Return words where a value belongs."""
    text = " ".join(str(word.value) for word in words)
    return n.Name("words", text=text, span=(span_of_token(words[0])[0], span_of_token(words[-1])[1]))


def _cases(rows: list[list[Cell]], span: tuple[int, int], text: str) -> n.Node:
    branches: list[tuple[n.Node, str]] = []
    for row in rows:
        value = next((part for part in row[0] if isinstance(part, n.Node)), None)
        words = [part for part in row[0] if isinstance(part, Token) and part.type == "TEXT"] if value is None else []
        if words:  # \text{geometric} \\ \text{algebraic}: a list
            value = _in_words(words)
        if value is None:
            raise ReadError(say(Kind.CASE_WITHOUT_VALUE), span[0])
        rest = [part for cell in row for part in cell if part is not value and part not in words]
        ends = [span_of_token(p) if isinstance(p, Token) else p.span for p in rest]
        condition = text[min(e[0] for e in ends) : max(e[1] for e in ends)] if ends else ""
        branches.append((value, condition.strip(" ,&")))
    return n.Cases(tuple(branches), span=span)
