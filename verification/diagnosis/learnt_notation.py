"""The document's own notation, learnt from its displays: how it writes cosines, sums of angles, joints and lengths."""

from __future__ import annotations

import re
from dataclasses import replace

from armproof.verification.diagnosis.slips import Letters
from armproof.verification.equations.outcome import Outcome
from armproof.verification.latex import nodes as n
from armproof.verification.latex.greek import ANGLES
from armproof.verification.latex.writer import Notation, symbol_as_latex
from armproof.verification.naming.names import Names


class LearntNotation:
    """The notation of the displays met so far; what a display does not show is as in those before it."""

    def __init__(self, names: Names) -> None:
        self.names = names

    def learn(self, latex: str, outcome: Outcome) -> Notation:
        """Return the notation of the display, falling back on what earlier displays of the document used."""
        before = self.names.state.notation
        notation = Notation(symbols=dict(before.symbols))
        assert outcome.printed is not None and outcome.true is not None
        for node in (outcome.printed.node, outcome.true.node):
            for below in n.walk(node):
                if isinstance(below, n.Call):
                    notation.learn(below, latex[below.span[0] : below.span[1]])
                elif isinstance(below, n.Name) and below.text and below.key not in self.names.quantities:
                    symbol = self.names.known_symbol(below.key)
                    if symbol is not None and not below.dots:
                        notation.symbols.setdefault(symbol, below.text)
                    elif self.names.is_free(below):
                        notation.symbols.setdefault(below.key, below.text)
        if not notation.learnt:
            notation.style, notation.cosine = before.style, before.cosine
            notation.underscore, notation.braces = before.underscore, before.braces
        for letter, symbol in self.names.symbols.items():
            notation.symbols.setdefault(symbol, symbol_as_latex(letter))
        self.names.state.notation = replace(notation, symbols=dict(notation.symbols), learnt=False)
        return notation

    def current(self) -> Notation:
        """Return the notation of the displays met so far."""
        notation = self.names.state.notation
        return replace(notation, symbols=dict(notation.symbols))

    def letters(self, cell: n.Node) -> Letters:
        """The joints and lengths that a slip may have confused, in the document's letters."""
        symbols, arm = self.names.state.notation.symbols, self.names.arm
        if arm is None:
            free = [symbol for symbol in symbols if not symbol.startswith("dot ")]
            names = {key: n.Name(*_base_and_index(key), text=symbols[key]) for key in free}
            angles = tuple(name for name in names.values() if name.base in ANGLES)
            lengths = tuple(name for name in names.values() if name not in angles)[:12]
            joints = sorted(
                {index for below in n.walk(cell) if isinstance(below, n.JointAngles) for _, index in below.terms}
            )
            return Letters(tuple(joints), angles, lengths)
        read = self.names.reader.read_expression

        def names_of(keys: list[str]) -> tuple[n.Name, ...]:
            nodes = [read(symbols.get(key) or symbol_as_latex(key)) for key in keys]
            return tuple(node for node in nodes if isinstance(node, n.Name))

        revolute = [joint.symbol for joint in arm.joints if joint.kind == "revolute"]
        prismatic = [joint.symbol for joint in arm.joints if joint.kind == "prismatic"]
        joints = [int(found.group(1)) for symbol in revolute if (found := re.search(r"_(\d)$", symbol))]
        return Letters(tuple(joints), names_of(revolute), names_of([*arm.lengths, *prismatic]))


def _base_and_index(key: str) -> tuple[str, str]:
    base, _, index = key.partition("_")
    return base, index
