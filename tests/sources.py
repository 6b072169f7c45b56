"""Source code as syntax trees: several tests read all of ours, and each file is parsed once for them."""

import ast
from functools import cache


@cache
def nodes_in(source: str) -> tuple[ast.AST, ...]:
    """Return the nodes of a module, each before those within it."""
    return tuple(ast.walk(ast.parse(source)))
