"""Random claims about random arms, judged by us and by the plant: `python -m tests.sweeps.claims [COUNT] [SEED]`.

Arms of 2 to 7 joints by DH tables and URDFs, several notations, every role, half of the claims with one slip. What is true
is asked of a plant that is built here and of an evaluator of its own. A false verdict is a false claim that passes or a
true one that is refuted; there may be none outside of the roles in NOT_YET.
"""

from __future__ import annotations

import os
import sys
from collections import Counter
from concurrent.futures import ProcessPoolExecutor
from dataclasses import dataclass
from pathlib import Path
from random import Random
from tempfile import TemporaryDirectory

from armproof.verification.check import check_document
from armproof.verification.document.formats import parse_document
from tests.labelled.cases import DECIDED, FALSE_PASS, FALSE_REFUTATION, PASSES, UNDECIDED
from tests.sweeps.generated.arms import random_arm
from tests.sweeps.generated.claims import Claim, Claims

COUNT, SEED, OF_AN_ARM = 20_000, 2019, 10
NOT_YET: frozenset[str] = frozenset()  # roles with false verdicts; a test takes out what is mended


@dataclass(frozen=True)
class Trial:
    """A claim, our verdict and what is wrong with it."""

    seed: int
    claim: Claim
    verdict: str
    message: str

    @property
    def fault(self) -> str:
        """What is wrong with the verdict, or ""."""
        if self.verdict == "error":
            return "error"
        if self.claim.true:
            refuted = self.verdict == "refuted"
            return FALSE_REFUTATION if refuted else "" if self.verdict in DECIDED else UNDECIDED
        return FALSE_PASS if self.verdict in PASSES else ""


def main() -> int:
    """Sweep, print the counts by role and the first false verdicts; 0 if there is none but where one is known."""
    count, seed = (int(given) for given in (*sys.argv[1:3], *(str(n) for n in (COUNT, SEED)[len(sys.argv[1:3]) :])))
    seeds = range(seed, seed + -(-count // OF_AN_ARM))
    with ProcessPoolExecutor(os.cpu_count()) as pool:
        trials = [trial for found in pool.map(trials_of, seeds, chunksize=8) for trial in found]
    return report(trials)


def trials_of(seed: int) -> list[Trial]:
    """Return our verdicts on the claims about one random arm."""
    rng = Random(seed)
    arm = random_arm(rng)
    claims = Claims(arm, rng)
    drawn = list(claims.draw(OF_AN_ARM))
    displays = [latex for claim in drawn for latex in (*claim.before, claim.latex)]
    text = "\n\n".join([f"---\n{claims.front}---", *(f"$$ {latex} $$" for latex in displays)]) + "\n"
    with TemporaryDirectory() as folder:
        (Path(folder) / "arm.urdf").write_text(arm.urdf, "utf-8")
        try:
            records = check_document(parse_document(Path(folder) / "page.md", text)).equations
        except Exception as error:
            return [Trial(seed, claim, "error", f"{type(error).__name__}: {error}") for claim in drawn]
    verdicts = iter(records)
    found = []
    for claim in drawn:
        record = [next(verdicts) for _ in (*claim.before, claim.latex)][-1]
        found.append(Trial(seed, claim, record.verdict.value, record.message))
    return found


def false_verdicts(trials: list[Trial]) -> list[Trial]:
    """Return the trials whose verdict is wrong; undecided is not wrong."""
    return [trial for trial in trials if trial.fault not in ("", UNDECIDED)]


def report(trials: list[Trial]) -> int:
    """Print the counts; return 1 where a role has a false verdict that is not known to have some."""
    print(f"{'role':18}{'claims':>8}{'true':>7}{FALSE_PASS:>12}{FALSE_REFUTATION:>18}{UNDECIDED:>11}{'error':>7}")
    for role in sorted({trial.claim.role for trial in trials}):
        of_role = [trial for trial in trials if trial.claim.role == role]
        kinds = Counter(trial.fault for trial in of_role)
        true = sum(trial.claim.true for trial in of_role)
        counts = (kinds[FALSE_PASS], kinds[FALSE_REFUTATION], kinds[UNDECIDED], kinds["error"])
        print(f"{role:18}{len(of_role):8}{true:7}{counts[0]:12}{counts[1]:18}{counts[2]:11}{counts[3]:7}")
    false = false_verdicts(trials)
    new = [trial for trial in false if trial.claim.role not in NOT_YET]
    print(f"{len(trials)} claims, {len(false)} false verdicts, {len(new)} of them in roles that are done")
    for trial in new[:20]:
        print(
            f"  seed {trial.seed}, {trial.claim.role}, {trial.fault}: {trial.claim.latex} ({trial.verdict}: {trial.message})"
        )
    return 1 if new else 0


if __name__ == "__main__":
    sys.exit(main())
