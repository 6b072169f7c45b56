"""What a formula's tree looks like: its brackets, its branches, its ellipses."""

from __future__ import annotations

from armproof.verification.latex import nodes as n


def bare(node: n.Node) -> n.Node:
    """Return a tree without the brackets and braces around it."""
    while isinstance(node, n.Group | n.Labelled):
        node = node.inner
    return node


def bare_key(node: n.Node) -> str | None:
    """Return the key of a node that is one name, whatever brackets stand around it."""
    node = bare(node)
    if isinstance(node, n.Name):
        return node.key if node.base not in ("words", "=") else None
    if isinstance(node, n.Call) and node.function == "name" and all(isinstance(a, n.Name) for a in node.arguments):
        return call_key(node)
    return None


def squared_name(node: n.Node) -> str | None:
    """The r of r² = x² + y², which is a length and positive."""
    if isinstance(node, n.Power) and isinstance(node.exponent, n.Number) and node.exponent.value == 2:
        return bare_key(node.base)
    return None


def has_dots(node: n.Node) -> bool:
    """Whether an ellipsis stands in a tree."""
    return any(isinstance(below, n.Dots) for below in n.walk(node))


def is_arc(node: n.Node) -> bool:
    """Whether an arc function stands in a tree outside of cosines and other functions."""
    if isinstance(node, n.Call):
        return node.function in ("acos", "asin", "atan", "atan2")
    return any(is_arc(below) for below in n.children(node))


def has_branches(node: n.Node) -> bool:
    """Whether ± or ∓ stands in a tree."""
    return any(sign in "±∓" for below in n.walk(node) if isinstance(below, n.Sum) for sign, _ in below.terms)


def call_key(node: n.Call) -> str:
    """Return the key of a name with arguments: J(q)."""
    name, *arguments = node.arguments
    head = name.key if isinstance(name, n.Name) else "?"
    return f"{head}({','.join(a.key for a in arguments if isinstance(a, n.Name))})"
