"""Which definitions count in the end: those that a decided claim uses, and that do not make several lines wrong."""

from __future__ import annotations

from collections import Counter
from collections.abc import Callable, Iterable, Mapping, Sequence, Set
from dataclasses import replace

from armproof.verification.findings import Finding, Kind, say
from armproof.verification.findings.kinds import MISPRINTS, OTHER_ANGLES
from armproof.verification.verdict import (
    HOLDS,
    EquationResult,
    Record,
    Role,
    SlipBefore,
    Verdict,
    WrongEntry,
    worst,
)

Tells = Callable[[Record, SlipBefore], bool]
Key = tuple[str, int]  # a name and the line of the display that defines it
SEVERAL = 2
OPEN = (Verdict.UNCHECKED, Verdict.DEFINED)  # what says a name anew


def settle_definitions(records: Iterable[Record], tells: Tells = lambda *_: True) -> tuple[Record, ...]:
    """Return the records of a document; where a line and a definition contradict each other, nobody may know which is wrong.

    Where more displays are wrong with a definition than right, and several are, or one is that holds if it has a slip, it may be the
    mistake: neither is decided. A display clears it that `tells` a slip: it holds without it alone. A definition that nothing
    clears refutes a line only where one slip in that line explains it, and none in the definition, if that may slip.
    """
    records = tuple(records)
    claims = [record for record in records if not record.erratum]
    wrong = contradicted(claims, tells)
    mistaken = _mistaken(claims, wrong)
    explained = {record.line for record in claims if any(_is_due_to(each, mistaken) for each in record.outcomes)}
    wrong = {key: lines for key, lines in wrong.items() if key in mistaken or not set(lines) <= explained}
    against = unsupported(claims) | wrong  # these are not to pass
    settled = [record if record.erratum else _unless_doubted(record, wrong, against) for record in records]
    doubtful = {key: lines for key, lines in against.items() if len(lines) > SEVERAL}
    settled = [record if record.erratum else _unless_it_rests_on(record, doubtful) for record in settled]
    return tuple(_with_mistake(record, mistaken) for record in settled)


def settle_used(records: Iterable[Record]) -> tuple[Record, ...]:
    """Return the records of a document; a definition that no decided claim uses is unchecked."""
    records = tuple(records)
    used = used_names([each for record in records if not record.erratum for each in record.outcomes])
    return tuple(_settled(record, used) for record in records)


def used_names(results: Iterable[EquationResult]) -> frozenset[Key]:
    """Return the names that decided equations rest on, those of the definitions between included: a law of any Jacobian rests on no matrix of J."""
    results = list(results)
    through = [each for each in results if each.defines]
    used: set[Key] = set()
    new = {key for each in results if each.is_decided for key in _used(each)}
    while new:
        used |= new
        new = {key for each in through if each.defines & new for key in _used(each)} - used
    return frozenset(used)


def rests_through(key: Key, results: Iterable[EquationResult]) -> tuple[set[Key], list[EquationResult]]:
    """Return a definition with those that rest on it, and the equations that rest on any of them."""
    results = list(results)
    through = {key}
    while new := {k for each in results if _used(each) & through for k in each.defines} - through:
        through |= new
    return through, [each for each in results if _used(each) & through]


def _used(result: EquationResult) -> frozenset[Key]:
    """Return what an equation rests on, without the matrix of J where it holds of any."""
    is_any = any(each.kind is Kind.OF_ANY_JACOBIAN for each in result.findings)
    return frozenset(key for key in result.uses if not (is_any and "J" in key[0]))


def contradicted(records: Sequence[Record], tells: Tells = lambda *_: True) -> dict[Key, list[int]]:
    """Return the definitions that displays contradict, more than agree with them, and the lines of those.

    One is enough where nothing agrees, and not only a slip in that line explains it: which of the two has the slip, nothing tells.
    Of those that a slip of their own mends as well, two are, if the same slip mends both.
    """
    defined = _definitions(records)
    wrong: dict[Key, list[int]] = {}
    right: Counter[Key] = Counter()
    for record in records:
        used = {v: {key for o in record.outcomes if o.verdict is v for key in _rested_on(o)} for v in Verdict}
        refuted = used[Verdict.REFUTED] & defined
        right.update(key for verdict in HOLDS for key in used[verdict] - refuted)
        for key in refuted:
            wrong.setdefault(key, []).append(record.line)
    slips = [o.slip_before for r in records for o in r.outcomes if o.slip_before]
    mends = _mends(slips)
    for key, slip in {(slip.name, slip.line): slip for slip in slips}.items():
        agreeing = (each for each in records if any(o.verdict in HOLDS and key in o.uses for o in each.outcomes))
        right[key] = sum(tells(each, mends.get(key, slip)) for each in agreeing)
    again = {key for r in records for o in r.outcomes for key in o.defines if key[1] != r.line}  # it is said again
    least = {key: 1 if key in mends else SEVERAL for key in wrong}
    doubted = {key: lines for key, lines in wrong.items() if len(lines) >= max(least[key], right[key] + 1)}
    open_ = {key for key in defined if not right[key]}
    anew = {
        (each.slip_before.name, each.slip_before.line): [record.line]
        for record in records
        for each in record.outcomes
        if each.verdict in OPEN and each.slip_before is not None
    }
    return {**anew, **_said_anew(records, defined - again, right), **_unexplained(records, open_, again), **doubted}


def _mistaken(records: Sequence[Record], wrong: Mapping[Key, list[int]]) -> dict[Key, SlipBefore]:
    """Return the contradicted definitions with which nothing holds, and all that does not would with the same slip mended there, and with no other alone.

    Of several lines, or of one that nothing else mends.
    """
    found: dict[Key, dict[str, SlipBefore]] = {}
    told: dict[Key, set[str]] = {}
    cleared: set[Key] = set()
    alone: set[Key] = set()
    for record in records:
        anew = (each.slip_before for each in record.outcomes if each.verdict in OPEN)
        said_anew = {(slip.name, slip.line) for slip in anew if slip is not None}  # R = R_z(θ_1) and R = […] […] = […]
        for each in record.outcomes:
            slip = each.slip_before
            if each.verdict in HOLDS:
                twice = {key for key in each.uses if any(one[0] == key[0] and one != key for one in each.uses)}
                cleared |= _rested_on(each) - said_anew - twice
            if slip is None or each.verdict not in (Verdict.REFUTED, *OPEN):
                continue
            key = (slip.name, slip.line)
            cleared |= {key} if slip.has_rival or slip.change.kind not in MISPRINTS - OTHER_ANGLES else set()
            found.setdefault(key, {})[slip.correct] = slip
            told.setdefault(key, set()).add(record.latex)
            alone |= {key} if slip.is_only else set()
            told[key] |= (
                {f"{record.latex} of itself"} if key in said_anew and any(map(_holds, record.outcomes)) else set()
            )
    return {
        key: next(iter(slips.values()))
        for key, slips in found.items()
        if key in wrong and key not in cleared and len(slips) == 1 and (len(told[key]) >= SEVERAL or key in alone)
    }


def _holds(result: EquationResult) -> bool:
    return result.verdict in HOLDS


def _is_due_to(result: EquationResult, mistaken: Mapping[Key, SlipBefore]) -> bool:
    slip = result.slip_before
    return result.verdict is Verdict.REFUTED and slip is not None and (slip.name, slip.line) in mistaken


def _with_mistake(record: Record, mistaken: Mapping[Key, SlipBefore]) -> Record:
    """Return the record of a definition refuted where it is what is wrong."""
    own = {
        each.index: mistaken[key]
        for each in record.outcomes
        for key in each.defines & mistaken.keys()
        if len(each.defines) == 1
    }
    if not own or record.erratum:
        return record
    outcomes = tuple(
        replace(each, verdict=Verdict.REFUTED, findings=(own[each.index].change.at(each.index), *each.findings))
        if each.index in own and each.verdict is Verdict.UNCHECKED
        else each
        for each in record.outcomes
    )
    entries = tuple(
        WrongEntry(index, None, None, slip.printed, slip.correct, slip.change) for index, slip in own.items()
    )
    findings = tuple(finding for each in outcomes if each.verdict is Verdict.REFUTED for finding in each.findings)
    verdict = worst([each.verdict for each in outcomes])
    return replace(record, verdict=verdict, outcomes=outcomes, entries=entries, findings=findings, corrections=None)


def _unexplained(records: Sequence[Record], open_: Set[Key], again: Set[Key]) -> dict[Key, list[int]]:
    """Return the definitions that nothing clears, of those with which a line does not hold that no slip of its own alone explains.

    What is said `again` goes before what one line alone says the name to be, and clears nothing else: a slip is copied, too.
    """
    found: dict[Key, list[int]] = {}
    for record in records:
        own = frozenset[Key]().union(*(each.defines for each in record.outcomes))  # k = a = b is wrong whatever k is
        for each in (outcome for outcome in record.outcomes if outcome.verdict is Verdict.REFUTED):
            if each.slip_before is not None or not _has_own_slip(record, each):
                for key in (each.may_slip & open_) - own - {key for key in again if key[0] in each.alone}:
                    found.setdefault(key, []).append(record.line)
    return found


def _has_own_slip(record: Record, result: EquationResult) -> bool:
    """Whether one small change of one entry mends an equation."""
    changes = [entry.finding for entry in record.entries if entry.equation == result.index]
    return len(changes) == 1 and changes[0] is not None


def _definitions(records: Sequence[Record]) -> set[Key]:
    """Return what displays define, and what the text between them does; not what a display shows to hold: J = ∂p/∂θ."""
    outcomes = [outcome for each in records for outcome in each.outcomes]
    claimed = {key for each in outcomes if each.role is not Role.DEFINITION for key in each.defines}
    named = {key for each in outcomes for key in (each.defines if each.role is Role.DEFINITION else each.uses)}
    shown = {each.line for each in records if all(o.role is Role.CLAIM and o.verdict in HOLDS for o in each.outcomes)}
    return {key for key in named - claimed if key[1] not in shown}


def _said_anew(records: Sequence[Record], defined: Set[Key], right: Mapping[Key, int]) -> dict[Key, list[int]]:
    """Return the definitions with which nothing agrees, and of which several lines say otherwise, or one by another definition."""
    found: dict[Key, list[int]] = {}
    by_other: set[Key] = set()
    rests = {
        key: frozenset[Key]().union(*(o.uses for each in records for o in each.outcomes if key in o.defines))
        for key in defined
    }
    for record in records:
        beside = frozenset[Key]().union(*(each.defines for each in record.outcomes))  # τ of τ = J^T F = (3, 4)
        for outcome in (each for each in record.outcomes if each.verdict is Verdict.REFUTED):
            met = outcome.uses & defined - beside
            own = {key for key in met if key[0] in outcome.alone and not right.get(key)}
            for key in own:
                found.setdefault(key, []).append(record.line)
            by_other |= {key for key in own if met - own - rests[key]}
    return {key: lines for key, lines in found.items() if len(lines) >= SEVERAL or key in by_other}


def _mends(slips: Sequence[SlipBefore]) -> dict[Key, SlipBefore]:
    """Return the slips in definitions that explain what is refuted: better than slips there do, or each for several."""
    times = Counter((slip.name, slip.line, str(slip.change)) for slip in slips)
    several = {slip for slip, count in times.items() if count >= SEVERAL}
    telling = (s for s in slips if not s.has_rival or (s.name, s.line, str(s.change)) in several)
    return {(slip.name, slip.line): slip for slip in telling}


def unsupported(records: Sequence[Record]) -> dict[Key, list[int]]:
    """Return the definitions with which more claims do not hold than do, without an arm that would tell; and their lines."""
    results = [(record.line, each) for record in records for each in record.outcomes]
    held = Counter(key for _, each in results if each.verdict in HOLDS for key in _rested_on(each))
    open_: dict[Key, list[int]] = {}
    for line, key in ((line, key) for line, each in results if _differs(each) for key in _rested_on(each)):
        open_.setdefault(key, []).append(line)
    return {key: lines for key, lines in open_.items() if len(lines) > held[key]}


def _differs(result: EquationResult) -> bool:
    """Whether the sides of a claim that is left open differ."""
    differs = any(each.kind in (Kind.NO_ARM_TO_COMPARE, Kind.OTHER_SCREWS) for each in result.findings)
    return result.role is Role.CLAIM and result.verdict is Verdict.UNCHECKED and differs


def _rested_on(result: EquationResult) -> frozenset[Key]:
    return frozenset(key for key in result.uses if key[0] not in result.alone)


def _unless_doubted(record: Record, wrong: Mapping[Key, list[int]], against: Mapping[Key, list[int]]) -> Record:
    """Leave open the definitions that something speaks against, and what is refuted by those that are contradicted."""
    doubts = [_doubt(each, wrong, against) for each in record.outcomes]
    if not any(doubts):
        return record
    outcomes = tuple(
        replace(each, verdict=Verdict.UNCHECKED, findings=(doubt.at(each.index),)) if doubt is not None else each
        for each, doubt in zip(record.outcomes, doubts, strict=True)
    )
    found = record.with_outcomes(outcomes)
    if found.verdict is not Verdict.UNCHECKED:
        return found
    return replace(found, findings=tuple(each for o in outcomes if o.verdict is found.verdict for each in o.findings))


def _unless_it_rests_on(record: Record, against: Mapping[Key, list[int]]) -> Record:
    """Leave open what holds with a definition with which nearly all else does not: k_2 = r cos γ, with the arguments of γ = atan2(k_1, k_2) exchanged."""
    rests = [min(_rested_on(each) & against.keys(), default=None) for each in record.outcomes]
    doubts = [
        say(Kind.RESTS_ON_DOUBT, name=key[0], line=key[1]).at(each.index)
        if key is not None and each.verdict in HOLDS and each.role is Role.CLAIM
        else None
        for key, each in zip(rests, record.outcomes, strict=True)
    ]
    if not any(doubts):
        return record
    outcomes = tuple(
        replace(each, verdict=Verdict.UNCHECKED, findings=(doubt,)) if doubt is not None else each
        for each, doubt in zip(record.outcomes, doubts, strict=True)
    )
    return record.with_outcomes(outcomes)


def _doubt(result: EquationResult, wrong: Mapping[Key, list[int]], against: Mapping[Key, list[int]]) -> Finding | None:
    own = sorted(result.defines & against.keys())
    if own and result.verdict is Verdict.DEFINED and (result.role is Role.DEFINITION or own[0] in wrong):
        return say(Kind.CONTRADICTED, name=own[0][0], lines=against[own[0]])
    slip = result.slip_before
    is_open = result.verdict in (Verdict.REFUTED, *OPEN)
    if slip is not None and is_open and (slip.name, slip.line) in wrong:
        return say(Kind.SLIP_BEFORE, name=slip.name, line=slip.line, change=slip.change)
    used = sorted(result.uses & wrong.keys())
    if used and result.verdict is Verdict.REFUTED:
        return say(Kind.RESTS_ON_DOUBT, name=used[0][0], line=used[0][1])
    return None


def _settled(record: Record, used: frozenset[Key]) -> Record:
    if not any(_rests(each, used) for each in record.outcomes):
        return record
    return record.with_outcomes(tuple(_unused(each) if _rests(each, used) else each for each in record.outcomes))


def _rests(result: EquationResult, used: frozenset[Key]) -> bool:
    """Whether a definition rests on its use, and there is none; what the arm was taken from is used by all."""
    gives_arm = any(finding.kind is Kind.GIVES_ARM for finding in result.findings)
    return result.verdict is Verdict.DEFINED and not gives_arm and not result.defines & used


def _unused(result: EquationResult) -> EquationResult:
    names = sorted(name for name, _ in result.defines if result.role is not Role.DATA)
    found = (say(Kind.NEVER_USED, names=names).at(result.index),) if names else ()
    return replace(result, verdict=Verdict.UNCHECKED, findings=(*result.findings, *found))
