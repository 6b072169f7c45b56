"""Where an implication stands among the statements of a display: its premises, its arrow, its conclusions."""

from __future__ import annotations

from dataclasses import dataclass

from verification.latex import nodes as n


@dataclass(frozen=True)
class Implication:
    """Premises and conclusions, alternatives joined by "or" on either side, with the arrow between them."""

    kind: str  # ⇒, ⇔, ⇐ or if
    premises: list[n.Chain]
    conclusions: list[n.Chain]
    after: int  # the statement at which to go on

    @property
    def arrow(self) -> str:
        """The arrow; "if" points from what follows it."""
        return "⇐" if self.kind == "if" else self.kind

    @property
    def chains(self) -> list[n.Chain]:
        """All equations of it."""
        return [*self.premises, *self.conclusions]


def find_implication(statements: list[n.Statement], index: int) -> Implication | None:
    """Return the implication that starts at a statement, or None."""
    premises, at = _alternatives(statements, index)
    if at >= len(statements):
        return None
    connective = statements[at]
    if not isinstance(connective, n.Connective) or connective.kind not in ("⇒", "⇔", "⇐", "if"):
        return None
    conclusions, after = _alternatives(statements, at + 1)
    if not conclusions or any(not chain.relations for chain in (*premises, *conclusions)):
        return None
    return Implication(connective.kind, premises, conclusions, after)


def _alternatives(statements: list[n.Statement], index: int) -> tuple[list[n.Chain], int]:
    """Return the chains joined by "or" (or a mere comma between equations of one variable) from here on."""
    chains: list[n.Chain] = []
    while index < len(statements):
        statement = statements[index]
        if isinstance(statement, n.Chain):
            if chains and not (isinstance(statements[index - 1], n.Connective)):
                break
            chains.append(statement)
            index += 1
        elif statement.kind == "or" and chains:
            index += 1
        else:
            break
    return chains, index


def connectives_among(statements: list[n.Statement], index: int, chains: int) -> int:
    """How many connectives stand among the next `chains` chains."""
    seen = words = 0
    while seen < chains:
        if isinstance(statements[index + seen + words], n.Chain):
            seen += 1
        else:
            words += 1
    return words
