"""Errors as data: a kind and its terms, from which the sentence is made."""

import ast
import copy
from collections.abc import Iterable, Iterator, Sequence, Set
from functools import cache
from pathlib import Path
from string import Formatter

import pytest

import armproof.course
import armproof.models
import armproof.verification
from armproof.models.catalogue import load_arm
from armproof.models.errors import ArmproofError, Fault, ModelError, written
from armproof.models.language import use
from tests.sources import nodes_in

ROOMS = [Path(room.__path__[0]) for room in (armproof.course, armproof.models, armproof.verification)]
FILES = [file for room in ROOMS for file in room.rglob("*.py") if not {"lessons", "tasks"} & set(file.parts)]


@cache
def trees() -> list[ast.Module]:
    """Return the modules of models/."""
    return [ast.parse(file.read_text()) for file in Path(armproof.models.__path__[0]).rglob("*.py")]


@cache
def nodes() -> list[ast.AST]:
    """Return the calls and the classes of all rooms."""
    found = (node for file in FILES for node in nodes_in(file.read_text(encoding="utf-8")))
    return [node for node in found if isinstance(node, ast.Call | ast.ClassDef)]


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


def errors_of(nodes: Sequence[ast.AST]) -> set[str]:
    """Return the names of all classes below ArmproofError."""
    classes = [node for node in nodes if isinstance(node, ast.ClassDef)]
    found = {"ArmproofError"}
    while more := {each.name for each in classes if {ast.unparse(base) for base in each.bases} & found} - found:
        found |= more
    return found


def calls(nodes: Iterable[ast.AST], names: Set[str]) -> Iterator[ast.Call]:
    for call in nodes:
        if isinstance(call, ast.Call) and getattr(call.func, "id", "") in names:
            yield call


def in_words(nodes: Iterable[ast.AST], names: Set[str], kinds: tuple[type[ast.expr], ...]) -> Iterator[str]:
    """Yield each error, or sentence of a command, that is an expression of one of the kinds."""
    yield from (ast.unparse(call) for call in calls(nodes, names) for arg in call.args if isinstance(arg, kinds))


def without_terms(nodes: Iterable[ast.AST], names: Set[str]) -> Iterator[str]:
    """Yield each field of a template that the call does not give."""
    for call in calls(nodes, names):
        given = {keyword.arg for keyword in call.keywords}
        texts = [arg.value for arg in call.args if isinstance(arg, ast.Constant) and isinstance(arg.value, str)]
        for text in texts if given - {None} else ():
            yield from (f"{name}: {text}" for _, name, _, _ in Formatter().parse(text) if name and name not in given)


def test_every_kind_is_said_with_its_terms() -> None:
    assert [name for tree in trees() for name in lacking(tree)] == []
    assert set(Fault) == {kind for tree in trees() for kind in said(tree)}
    assert list(lacking(ast.parse("ModelError(Fault.NO_FRAME, arm=a, frames=f)"))) == ["no_frame: frame"]


def test_no_error_is_made_of_a_text() -> None:
    texts = (ast.JoinedStr, ast.BinOp, ast.Constant)
    assert [text for tree in trees() for text in in_words(ast.walk(tree), {"ModelError"}, texts)] == []


def test_no_sentence_is_put_together_where_it_is_said() -> None:
    """An f-string cannot be translated; elsewhere than in the models a template stands where it is said."""
    names = errors_of(nodes()) | {"tell", "written"}
    assert {"ModelError", "SourceError", "OutsideAlgebra"} <= names
    assert list(in_words(nodes(), names, (ast.JoinedStr,))) == []
    wrong = ast.parse('raise SourceError(path, 1, f"no frame {name}")')
    assert list(in_words(ast.walk(wrong), names, (ast.JoinedStr,))) == ["SourceError(path, 1, f'no frame {name}')"]


def test_every_template_is_given_its_terms() -> None:
    names = errors_of(nodes()) | {"tell", "written"}
    assert list(without_terms(nodes(), names)) == []
    wrong = ast.parse('tell("{path}: gone {at}", path=path)')
    assert list(without_terms(ast.walk(wrong), names)) == ["at: {path}: gone {at}"]


def test_an_error_carries_its_kind_and_terms() -> None:
    with pytest.raises(ModelError, match=r"no frame '9' on arm 'scara'; its frames are 0, 1, 2, 3, 4$") as caught:
        load_arm("scara").frame_names(9)
    assert caught.value.kind is Fault.NO_FRAME
    assert caught.value.terms == {"frame": "9", "arm": "scara", "frames": ["0", "1", "2", "3", "4"]}


def test_an_error_comes_out_of_a_process_whole() -> None:
    error = ModelError(Fault.IN_TABLE, number=1, column="a", reason=ModelError(Fault.NO_CHARACTER, found="w"))
    again = copy.deepcopy(error)  # as pickle makes it
    assert str(again) == str(error) == "DH table, row 1, a: 'w' is not understood"
    assert again.kind is Fault.IN_TABLE
    assert ArmproofError("a text").kind is None


def test_a_number_is_written_as_the_language_writes_it_and_a_path_as_it_is():
    with use("fr"):
        assert written("{path}: {number}", path=Path("a.tex"), number=1 / 4) == "a.tex: 0,25"
    assert written("{path}: {number}", path=Path("a.tex"), number=1 / 4) == "a.tex: 0.25"
