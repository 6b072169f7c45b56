"""From a document, a file or a text to its verdicts: one record a display, one a DH table, with the names that those before define."""

from __future__ import annotations

import time
from collections.abc import Iterator, Sequence
from dataclasses import replace
from functools import cached_property, lru_cache
from pathlib import Path
from typing import TYPE_CHECKING, Any

from armproof.models.arm import Arm
from armproof.models.catalogue import arm_of, load_arm
from armproof.models.errors import ArmproofError
from armproof.verification.algebra.quantity import Quantity
from armproof.verification.algebra.ring import Ring
from armproof.verification.check.as_usual import Bound, bound_as_usual
from armproof.verification.check.beforehand import Beforehand, lacks_base, shown_transforms
from armproof.verification.check.display import DisplayChecker
from armproof.verification.check.identities import resting_on_nothing
from armproof.verification.check.limits import SECONDS_TO_DECIDE
from armproof.verification.check.mended import Judged, Mends, mistakes, told, with_mistakes
from armproof.verification.check.noticed import settle_noticed
from armproof.verification.check.parts import joined, unless_called_another, unless_of_another_arm
from armproof.verification.check.points import Points
from armproof.verification.check.table_values import values_of_tables
from armproof.verification.check.told_quantities import settle_told_quantities
from armproof.verification.conditions.told_otherwise import is_of_other_build
from armproof.verification.diagnosis.accepted import with_accepted
from armproof.verification.display.statements import Statements
from armproof.verification.document import Display, Document, Table, parse_document, read_document
from armproof.verification.equations.chain import ChainChecker, no_samples
from armproof.verification.equations.later_definitions import definitions_behind, names_lacking
from armproof.verification.equations.table_angles import settle_angles
from armproof.verification.errors import DocumentError, ReadError
from armproof.verification.evaluation.exact import ExactAlgebra
from armproof.verification.findings import Finding, Kind, say
from armproof.verification.latex import nodes as n
from armproof.verification.latex.reader import key_as_latex
from armproof.verification.naming.reading import read_names, spelling_of
from armproof.verification.naming.settled import settle_definitions, settle_used
from armproof.verification.naming.shown import settle_used_otherwise, settle_usual
from armproof.verification.tables import check_table
from armproof.verification.tables.arms import (
    OF_TOOL,
    Inference,
    difference,
    infer_arm,
    scopes,
    settle_data,
    table_of_named,
    tells_other_tool,
    unless_disputed,
    unless_rivalled,
    with_armless,
)
from armproof.verification.verdict import DECIDED, DocumentResult, Record, TakenArm, Verdict

if TYPE_CHECKING:
    from armproof.verification.evaluation.sampled import SampledAlgebra


def verify(path: Path | str, *, confirm: bool = True, correct: bool = False) -> DocumentResult:
    """Return the verdicts of a document file; raises DocumentError where the document as a whole cannot be checked."""
    return check_document(read_document(Path(path)), confirm=confirm, correct=correct)


def verify_text(
    text: str, format: str = "", *, path: Path | str = "document.md", confirm: bool = True, correct: bool = False
) -> DocumentResult:
    """Return the verdicts of a document's text, as `verify` does of a file that holds it.

    Args:
        text: the document, front matter and all.
        format: how it is read: md, qmd, ipynb, py, tex or rst; by default as the name of `path` says.
        path: the file that it belongs to, which need not exist: it names the document in the result and in messages, and
            arms that are given by a relative path are sought from its folder.
        confirm, correct: as for `check_document`.

    Raises:
        DocumentError: the document as a whole cannot be checked.
    """
    return check_document(
        parse_document(Path(path), text.removeprefix("\ufeff"), format), confirm=confirm, correct=correct
    )


def check_document(
    document: Document, *, confirm: bool = True, correct: bool = False, arm: Arm | None = None, samples: bool = True
) -> DocumentResult:
    """Return the verdicts of a document.

    Args:
        document: what was read.
        confirm: also evaluate each proved equation on the double plant.
        correct: also seek what mends each refuted one.
        arm: the document's arm, such as one read from a value; by default the one that its front matter names.
        samples: whether samples may be taken. Without them neither NumPy nor Drake is needed, and what they alone
            decide is unchecked.
    """
    seeks = arm is None and ("arms" in document.front or (samples and "arm" not in document.front))
    parts = [infer_arm(part) for part in scopes(document)] if seeks else [Inference(document)]
    options = confirm and samples, correct and samples, samples
    results = [DocumentChecker(p.document, arm or load_arm_of(p.document), *options, p).run() for p in parts]
    if samples and len(parts) > 1:
        results = [unless_of_another_arm(k, parts, result, plainly) for k, result in enumerate(results)]
        results = [unless_called_another(k, parts, result) for k, result in enumerate(results)]
    if seeks and samples:
        results = [unless_disputed(part, result, plainly) for part, result in zip(parts, results, strict=True)]
        results = [unless_rivalled(part, result, plainly) for part, result in zip(parts, results, strict=True)]
        results = [with_armless(part, result, plainly) for part, result in zip(parts, results, strict=True)]
    result = results[0] if len(results) == 1 else joined(document, results)
    return with_accepted(document, result) if document.accepts else result


def plainly(part: Inference) -> DocumentResult:
    """Return the verdicts of a part of a document, and nothing that takes time to find out besides."""
    return DocumentChecker(part.document, load_arm_of(part.document), False, False, True, part).run()


def load_arm_of(document: Document) -> Arm | None:
    """Return the arm that a document's front matter names; raises DocumentError where that cannot be loaded."""
    try:
        return arm_of(document.front, document.path.parent)
    except ArmproofError as error:
        raise document.fault("arm" if "arm" in document.lines else "arms", error) from None


@lru_cache(maxsize=16)
def _difference(name: str, table: Table) -> Finding | None:
    about = DocumentChecker(Document(Path(), {}, (), (table,)), load_arm(name), confirm=False)
    return difference(about.checker, name, table)


class DocumentChecker:
    """Checks the displays of one document in order, each with the names that those before it defined."""

    def __init__(
        self,
        document: Document,
        arm: Arm | None,
        confirm: bool = True,
        correct: bool = False,
        samples: bool = True,
        inferred: Inference | None = None,
        mended: Mends | None = None,
        bound: Bound | None = None,
    ) -> None:
        self.document = document
        self.arm = arm
        self.inferred = inferred or Inference(document)
        try:
            told = document.front.get("quantities") or {}
            front = {**document.front, "quantities": {**told, **bound}} if bound else document.front
            self.names = read_names(arm, front)
        except DocumentError as error:
            raise document.fault(error.key or "quantities", error) from None
        taken = self.inferred.arm
        is_part = (taken is not None and taken.is_part) or tells_other_tool(document, self.names)
        self.names = replace(self.names, is_part=is_part)
        is_of_formulas = self.inferred.arm is not None and self.inferred.arm.source in OF_TOOL
        self.names = replace(
            self.names, lacks_base=lacks_base(document, arm, self.inferred), is_of_formulas=is_of_formulas
        )
        if shown_transforms(self.inferred):  # by what the arm was taken from, and not stated by the author
            self.names = replace(self.names, stated_transforms="")
        self.names.reader.spelling = spelling_of(document, self.names.reader.words)
        self.ring = Ring()
        if arm is not None:  # any numbers, as lengths are, until a display says which
            letters = self.names.reader.spelling.masses | self.names.reader.spelling.moments
            self.names.state.adopted |= {key for key in letters if self._is_unknown(key)}
        self.exact = ExactAlgebra(self.ring, arm)
        self.checker = ChainChecker(self.names, self.exact, self.sampled)
        self.checker.confirm = confirm
        self.statements = Statements(self.checker)
        self.statements.claims.displays = document.displays
        self.correct = correct
        self.samples = samples
        self.beforehand = Beforehand(self.checker, document, self.inferred)
        self.displays = DisplayChecker(self.statements, self.inferred, self.beforehand.direction, correct, samples)
        self._lacked: set[tuple[int, str]] = set()
        self.mended = mended or {}
        for key, slip in self.mended.items():
            if isinstance(slip.formula, n.Node):
                self.names.state.mended[key] = slip.formula, self.checker.members.meaning(slip.formula)

    def go_on_with(self, document: Document, inferred: Inference) -> None:
        """Check displays of a document that has changed: it shows the same beforehand."""
        self.document, self.inferred, self.displays.inferred = document, inferred, inferred
        self.statements.claims.displays = document.displays

    def _is_unknown(self, key: str) -> bool:
        return self.names.known_symbol(key) is None and key not in self.names.quantities

    def sampled(self) -> SampledAlgebra:
        """The double plant at the configurations of the six families; raises NotSampled where none may be taken."""
        if not self.samples:
            no_samples()
        return self._samples

    @cached_property
    def _samples(self) -> SampledAlgebra:
        with self.ring.budget.paused():
            from armproof.verification.evaluation.sampled import plant_samples

            return plant_samples(self.exact)

    def run(self) -> DocumentResult:
        """Return the verdicts of all displays and tables, in the order of the document."""
        started = time.perf_counter()
        return replace(self.result_of(self.check_displays()), seconds=time.perf_counter() - started)

    def check_displays(self) -> tuple[Record, ...]:
        """Return the records of all displays, in the order of the document."""
        return tuple(self.check_display(display) for display in self.document.displays)

    def _usual(self, key: str) -> tuple[Quantity, ...]:
        """Return what a name may stand for by convention."""
        try:
            name = self.names.reader.read_expression(key_as_latex(key))
        except ReadError:
            return ()
        return self.names.usual(name) if isinstance(name, n.Name) else ()

    def result_of(self, equations: tuple[Record, ...]) -> DocumentResult:
        """Return the document's result for the records of its displays, judged with its mistakes mended where it has some."""
        checked: dict[str, tuple[DocumentChecker, tuple[Record, ...]]] = {}

        def bind(bound: Bound) -> tuple[Record, ...]:
            checked[repr(bound)] = self._again(None, bound)
            return checked[repr(bound)][1]

        bound = bound_as_usual(equations, bind, self._usual) if self.arm is not None else {}
        about, records = checked[repr(bound)] if bound else (self, equations)
        return about._with_mistakes(records, bound)

    def _again(self, mended: Mends | None, bound: Bound) -> tuple[DocumentChecker, tuple[Record, ...]]:
        """Return a checker of the document with definitions mended and names bound, and the records of its displays."""
        options = self.checker.confirm, self.correct, self.samples, self.inferred, mended, bound
        again = DocumentChecker(self.document, self.arm, *options)
        return again, again.check_displays()

    def _with_mistakes(self, equations: tuple[Record, ...], bound: Bound) -> DocumentResult:
        """Return the document's result, judged with the definitions mended that are its mistakes."""
        checked = {told(()): (self, equations)}

        def judge(mended: Mends) -> Judged:
            slips = told(mended.values())
            if slips not in checked:
                checked[slips] = self._again(mended, bound)
            about, records = checked[slips]
            return Judged(records, about.names.state.met, about.displays.parts_of)

        found = mistakes(judge({}), judge) if self.names.state.met else {}
        elsewhere = {each.line for each in self.document.displays if is_of_other_build(each.meant)}
        found = {key: slip for key, slip in found.items() if slip.line not in elsewhere}
        about, records = checked[told(found.values())]
        return about._result_of(records)

    def _result_of(self, equations: tuple[Record, ...]) -> DocumentResult:
        """Return the document's result as it is; its tables are checked with the names of all displays."""
        tables = tuple(record for table in self.document.tables if (record := self._table(table)) is not None)
        if any(record.if_shown is not None for record in equations):
            equations = settle_usual(equations)
        equations = settle_used_otherwise(equations, self._usual)
        if any(each.usual for record in equations for each in record.outcomes):
            equations = Points(self.exact, self._usual).settle(equations)
        if any(each.order for record in equations for each in record.outcomes):
            from armproof.verification.equations.argument_order import settle_orders

            equations = settle_orders(equations)
        if any(each.of_table for record in equations for each in record.outcomes):
            equations = settle_angles(equations)
        if self._has_definitions(equations):
            equations = resting_on_nothing(equations, self.statements)
            settled = settle_definitions(equations, self.displays.slips.is_cleared)
            equations = settle_used(with_mistakes(settled, self.mended))
        if self.inferred.arm is not None or self.inferred.problem is not None:
            equations, tables = settle_data(self.inferred, equations, tables)
        if self._has_definitions(equations):  # what was refuted by an arm that nothing confirms may have used them
            equations = settle_noticed(settle_used(equations), self.displays.slips)
            equations = settle_told_quantities(equations, self.document.displays, self.names)
        index = None if self.arm is None else 0
        return DocumentResult(
            str(self.document.path),
            self.arm.name if self.arm is not None else "",
            tuple(replace(record, arm_index=index) for record in equations),
            tuple(replace(record, arm_index=index) for record in tables),
            self.arm.warnings if self.arm is not None else (),
            title=str(self.document.front.get("title", "")),
            inverse=self._inverse(),
            arms=self._arms(),
            front=self.document.front,
            remarks=(*self.document.remarks, *self._named()),
        )

    @staticmethod
    def _has_definitions(records: Sequence[Record]) -> bool:
        outcomes = (each for record in records for each in record.outcomes)
        return any(each.defines or each.uses or each.verdict is Verdict.DEFINED for each in outcomes)

    def _arms(self) -> tuple[TakenArm, ...]:
        if self.inferred.arm is not None or self.arm is None:
            return (self.inferred.arm,) if self.inferred.arm is not None else ()
        spec: dict[str, Any] = {k: v for k, v in self.document.front.items() if k in ("arm", "transforms")}
        convention = self.arm.dh.convention if self.arm.dh is not None else ""
        line = self.document.lines.get("arm") or self.document.lines.get("arms", 1)
        return (TakenArm(self.arm.name, line, "front matter", convention, self.names.transforms, spec),)

    def _named(self) -> Iterator[Finding]:
        """Yield how the document's table differs from an arm of the catalogue that its text names, but its front matter does not."""
        by_author = self.inferred.arm is None and self.arm is not None
        table = table_of_named(self.document) if self.samples and not by_author else None
        if table is not None:
            yield from filter(None, (_difference(name, table) for name in self.document.named))

    def _inverse(self) -> Record | None:
        if "inverse" not in self.document.front:
            return None
        if not self.samples:
            line = self.document.lines.get("inverse", 1)
            left_open = (say(Kind.NOT_SAMPLED),)
            return Record(line, "", Verdict.UNCHECKED, section="Inverse kinematics", findings=left_open)
        from armproof.verification.inverse.document import check_inverse

        return check_inverse(self.document, self.names)

    def _table(self, table: Table) -> Record | None:
        with self.ring.budget.of(SECONDS_TO_DECIDE):
            record = check_table(self.checker, table)
        if record is None or record.verdict is not Verdict.REFUTED or not self.correct:
            return record
        from armproof.verification.correction.tables import correct_table

        with self.ring.budget.of(SECONDS_TO_DECIDE):
            return replace(record, corrections=correct_table(self.checker, table, record))

    @cached_property
    def _given_by_tables(self) -> dict[tuple[int, str], tuple[str, ...]]:
        """The values that tables give before a display, by its line and its text."""
        if not self.samples or len(self.document.tables) < 1 + (self.inferred.arm is not None):
            return {}
        with self.ring.budget.of(SECONDS_TO_DECIDE):
            found = values_of_tables(self.checker, self.document, self.inferred)
            return {(display.line, display.latex): values for display, values in found}

    def check_display(self, display: Display) -> Record:
        """Return the record of one display; what it lacks may be said right behind it."""
        if values := self._given_by_tables.get((display.line, display.latex)):
            above = display.said_above
            display = replace(display, said=(*display.said[:above], *values, *display.said[above:]))
        record = again = self.displays.check(display)
        if record.verdict is not Verdict.UNCHECKED:
            return record
        after, missing = self.names.state.copy() if names_lacking(record) else None, frozenset[str]()
        while new := names_lacking(again) - missing:
            missing |= new
            behind = definitions_behind(self.document.displays, display, missing, self.names.reader)
            if not behind:
                break
            for each in (*behind, display):
                again = self.displays.check(each)
        if after is not None:
            self._lacked.add((display.line, display.latex))
            self.names.state.become(after)
        return again if again.verdict in DECIDED else record

    def lacked(self, display: Display) -> bool:
        """Whether a display lacked names by what stands above it."""
        return (display.line, display.latex) in self._lacked
