"""Errors as data: a kind and its terms, from which the sentence is made."""

import ast
import copy
from collections.abc import Iterator
from pathlib import Path
from string import Formatter

import pytest

import armproof.models
from armproof.models.catalogue import load_arm
from armproof.models.errors import ArmproofError, Fault, ModelError

TREES = [ast.parse(file.read_text()) for file in Path(armproof.models.__path__[0]).rglob("*.py")]


def fields(kind: Fault) -> set[str]:
    return {name for _, name, _, _ in Formatter().parse(kind.template) if name is not None}


def said(node: ast.AST) -> list[Fault]:
    """Return the kinds that an expression names."""
    return [Fault[name.attr] for name in ast.walk(node) if isinstance(name, ast.Attribute) and named_fault(name.value)]


def named_fault(node: ast.AST) -> bool:
    return isinstance(node, ast.Name) and node.id == "Fault"


def lacking(tree: ast.AST) -> Iterator[str]:
    """Yield each term of a template that the call that names the kind does not give."""
    for call in ast.walk(tree):
        if isinstance(call, ast.Call) and not any(keyword.arg is None for keyword in call.keywords):
            given = {keyword.arg for keyword in call.keywords}
            yield from (f"{kind}: {name}" for arg in call.args for kind in said(arg) for name in fields(kind) - given)


def in_words(tree: ast.AST) -> Iterator[str]:
    """Yield each error of ours that is made of a text."""
    for call in ast.walk(tree):
        if isinstance(call, ast.Call) and getattr(call.func, "id", "") == "ModelError":
            yield from (
                ast.unparse(call) for arg in call.args if isinstance(arg, ast.Constant | ast.JoinedStr | ast.BinOp)
            )


def test_every_kind_is_said_with_its_terms() -> None:
    assert [name for tree in TREES for name in lacking(tree)] == []
    assert set(Fault) == {kind for tree in TREES for kind in said(tree)}
    assert list(lacking(ast.parse("ModelError(Fault.NO_FRAME, arm=a, frames=f)"))) == ["no_frame: frame"]


def test_no_error_is_made_of_a_text() -> None:
    assert [text for tree in TREES for text in in_words(tree)] == []
    assert list(in_words(ast.parse('raise ModelError(f"no frame {name}")'))) == ["ModelError(f'no frame {name}')"]


def test_an_error_carries_its_kind_and_terms() -> None:
    with pytest.raises(ModelError, match=r"no frame '9' on arm 'scara'; its frames are 0, 1, 2, 3, 4$") as caught:
        load_arm("scara").frame_names(9)
    assert caught.value.kind is Fault.NO_FRAME
    assert caught.value.terms == {"frame": "9", "arm": "scara", "frames": ["0", "1", "2", "3", "4"]}


def test_an_error_comes_out_of_a_process_whole() -> None:
    error = ModelError(Fault.IN_TABLE, number=1, column="a", reason=ModelError(Fault.NO_SUCH_AXIS, axis="w"))
    again = copy.deepcopy(error)  # as pickle makes it
    assert str(again) == str(error) == "DH table, row 1, a: no axis 'w'; a frame has the axes x, y, z"
    assert again.kind is Fault.IN_TABLE
    assert ArmproofError("a text").kind is None
