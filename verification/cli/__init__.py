"""The command `armproof`: verify documents, correct them, list the arms, analyse one, view one.

Exit codes: 0 everything passes, 1 something does not, 2 the command cannot run (or not on one of the documents).
Nothing heavy is imported before it is needed: `armproof --help` loads neither Drake nor NumPy.
"""

from armproof.verification.cli import arms, correct, singularities, start, verify
from armproof.verification.cli.application import app, main

__all__ = ["app", "main"]

for command in (
    verify.verify,
    start.start,
    correct.correct,
    arms.arms,
    singularities.singularities,
    arms.view,
):  # in the order of the help
    app.command()(command)
