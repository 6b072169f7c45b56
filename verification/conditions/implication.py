"""Where an implication stands among the statements of a display: its premises, its arrow, its conclusions."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, replace

from armproof.verification.latex import nodes as n
from armproof.verification.latex.statements import ARROWS
from armproof.verification.latex.units import size_of

WHOLE_NUMBERS = ("k", "n", "m")
Alternatives = list[list[n.Chain]]  # "and" binds closer than "or"
# what a comma between values of one subject says
_JOINED_VALUES: dict[tuple[str, ...], str] = {("=",): "or", ("≠",): "and"}


@dataclass(frozen=True)
class Implication:
    """Premises and conclusions, each some alternatives of equations that hold together, with the arrow between them."""

    kind: str  # ⇒, ⇔, ⇐ or if
    before: Alternatives
    behind: Alternatives
    after: int = 0  # the statement at which to go on
    behind_at: int = 0  # the statement behind the arrow

    @property
    def arrow(self) -> str:
        """The arrow; "if" points from what follows it."""
        return "⇐" if self.kind == "if" else self.kind

    def with_each(self, change: Callable[[n.Chain], n.Chain]) -> Implication:
        """Return the implication with each of its equations changed."""
        before, behind = (
            [[change(chain) for chain in chains] for chains in side] for side in (self.before, self.behind)
        )
        return replace(self, before=before, behind=behind)

    @property
    def premises(self) -> list[n.Chain]:
        """The equations before the arrow."""
        return [chain for chains in self.before for chain in chains]

    @property
    def conclusions(self) -> list[n.Chain]:
        """The equations behind the arrow."""
        return [chain for chains in self.behind for chain in chains]

    @property
    def chains(self) -> list[n.Chain]:
        """All equations of it."""
        return [*self.premises, *self.conclusions]


def find_implication(statements: list[n.Statement], index: int) -> Implication | None:
    """Return the implication that starts at a statement, or None."""
    if isinstance(statements[index], n.Connective):
        return _if_then(statements, index)
    premises, at = _alternatives(statements, index, given=True)
    if at >= len(statements):
        return None
    connective = statements[at]
    if not isinstance(connective, n.Connective) or connective.kind not in ("⇒", "⇔", "⇐", "if"):
        return None
    conclusions, after = _alternatives(statements, at + 1, given=connective.kind in ("⇐", "if"))
    found = Implication(connective.kind, premises, conclusions, after, at + 1)
    return found if conclusions and all(chain.relations for chain in found.chains) else None


def _if_then(statements: list[n.Statement], index: int) -> Implication | None:
    """Return what "if A, then B" says, or None."""
    if statements[index].kind != "if":  # type: ignore[union-attr]
        return None
    conditions, at = _alternatives(statements, index + 1, given=True)
    then = statements[at] if at < len(statements) else None
    at += isinstance(then, n.Connective) and then.text.strip(" ,:").lower() in ("then", "alors")
    claims, after = _alternatives(statements, at, given=False)
    found = Implication("if", claims, conditions, after, index + 1)
    return found if claims and conditions and all(chain.relations for chain in found.chains) else None


def _alternatives(statements: list[n.Statement], index: int, *, given: bool) -> tuple[Alternatives, int]:
    """Return the chains joined by "or" and "and" from here on; "θ_2 = 0 or π" repeats its subject.

    A comma between values that one subject has is "or"; between those that it has not, and conditions that are `given`, "and".
    """
    found: Alternatives = []
    joined = "or"
    while index < len(statements):
        statement = statements[index]
        if isinstance(statement, n.Chain):
            before = found[-1][-1] if found else None
            joined = joined or _comma(before, statement, given)
            if not joined:
                break
            chain = _with_subject(statement, before, joined)
            if joined == "and":
                found[-1].append(chain)
            else:
                found.append([chain])
            joined = ""
        elif statement.kind in ("or", "and") and found:
            joined = statement.kind
        else:
            break
        index += 1
    return found, index


def _comma(before: n.Chain | None, chain: n.Chain, given: bool) -> str:
    """How a comma joins two chains: θ_2 = 0, π are alternatives, θ_2 ≠ 0, π hold together; "" where they are not joined."""
    if before is None or not (is_condition(before) or _equates_names(before)):
        return ""
    again = not chain.relations or (chain.relations == before.relations and chain.members[0] == before.members[0])
    if again and before.relations in _JOINED_VALUES and _is_constant(chain.members[-1]):
        return _JOINED_VALUES[before.relations]
    return "and" if given and chain.relations and (is_condition(chain) or _equates_names(chain)) else ""


def _equates_names(chain: n.Chain) -> bool:
    """Whether a chain relates names of one letter alone: l_1 = l_2, l_1 = √2 l_2, θ_2 = −2 θ_1, θ_1 + θ_2 = θ_3."""
    below = [each for side in chain.members for each in n.walk(side)]
    letters = {each.base for each in below if isinstance(each, n.Name) and each.key != "pi"}
    plain = n.Number | n.Sum | n.Product | n.Quotient | n.Group | n.Name
    are_plain = all(isinstance(each, plain) or (isinstance(each, n.Call) and _is_constant(each)) for each in below)
    return len(chain.members) > 1 and len(letters) == 1 and are_plain


def _with_subject(chain: n.Chain, before: n.Chain | None, joined: str) -> n.Chain:
    """Return the π of "θ_2 = 0 or π" as θ_2 = π, that of "θ_2 ≠ 0, π" as θ_2 ≠ π; what "θ_2 ≠ 0 or π" means is not known."""
    if chain.relations or before is None or before.relations not in _JOINED_VALUES:
        return chain
    if before.relations == ("≠",) and joined == "or":
        return chain
    return replace(chain, members=(before.members[0], *chain.members), relations=before.relations)


def is_signed(chain: n.Chain) -> bool:
    """Whether a chain has a sign ± that may be chosen together with those of others; θ ≠ ±α leaves both out."""
    return n.has_branches(chain) and chain.relations != ("≠",)


def is_rank_condition(chain: n.Chain) -> bool:
    """Whether a chain says what a rank is: among conditions, it is one, and not that of the generic configuration."""
    return n.is_rank(chain.members[0])


def with_rank_first(statement: n.Statement) -> n.Statement:
    """1 = rank J as rank J = 1."""
    if not isinstance(statement, n.Chain) or statement.relations != ("=",) or is_rank_condition(statement):
        return statement
    turned = replace(statement, members=statement.members[::-1])
    return turned if is_rank_condition(turned) else statement


def has_rank_within(chain: n.Chain) -> bool:
    """Whether a rank stands in an expression, 2 - rank J = 1: its value there would be that of the generic configuration."""
    others = chain.members[1:] if is_rank_condition(chain) else chain.members
    return any(n.is_rank(below) for member in others for below in n.walk(member))


def is_condition(chain: n.Chain) -> bool:
    """Whether an equation before an arrow reads as a condition (det J = 0) and not as a step of a derivation."""
    return any(relation != "=" for relation in chain.relations) or any(map(_is_constant, chain.members))


def _is_constant(node: n.Node) -> bool:
    return all(
        isinstance(b, n.Number | n.Sum | n.Product | n.Quotient | n.Group)
        or (isinstance(b, n.Postfix) and size_of(b.operator))
        or n.is_call(b, "sqrt")
        or (isinstance(b, n.Name) and b.key in ("pi", *WHOLE_NUMBERS))
        for b in n.walk(node)
    )


def connectives_among(statements: list[n.Statement], index: int, chains: int) -> int:
    """How many connectives stand among the next `chains` chains."""
    places = [place for place, each in enumerate(statements[index:]) if isinstance(each, n.Chain)]
    return places[chains - 1] - (chains - 1)


def is_under_words(statements: list[n.Statement], index: int) -> bool:
    """Whether "if" or "for" stands somewhere before a statement."""
    return any(isinstance(each, n.Connective) and each.kind == "if" for each in statements[:index])


def goes_on(statements: list[n.Statement], implication: Implication) -> bool:
    """Whether another arrow follows what an implication concludes: A ⇒ B ⇒ C."""
    behind = statements[implication.after] if implication.after < len(statements) else None
    return isinstance(behind, n.Connective) and behind.kind in ARROWS
