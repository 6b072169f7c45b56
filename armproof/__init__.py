"""Robot-arm kinematics checked against Drake: documents, Python functions and students' answers, proved or refuted.

    from armproof import verify

    result = verify("sheet.md")  # a DocumentResult
    result.passed, [record.verdict for record in result.equations]

| name | gives |
|---|---|
| `verify(path)` | the verdict of every equation of a document, a `DocumentResult` |
| `verify_text(text)` | the same of a document that is no file |
| `check_function(arm, function, quantities)` | the verdict on a Python function of the joint values, a `FunctionCheck` |
| `load_arm(spec)` | an `Arm` of the catalogue, of a model file or of a DH table |
| `NumericKinematics(arm, q)` | Drake's poses and Jacobians of an arm at some configurations |
| `bulk_of(arm)` | the same of millions, a `BulkKinematics` |
| `trace_of(arm)` | the exact ones, a `Trace` |
| `plant_of(arm)` | the `MultibodyPlant` of an arm |
| `inverse_of(arm)` | the proved closed-form inverse of an arm, an `InverseKinematics` |
| `analyse_singularities(arm)` | where its Jacobian loses rank, a `SingularityAnalysis` |
| `open_lesson(name)` | a `Lesson`, whose tasks give `Feedback` on answers |

The other names are those of the values that these return and of the errors that they raise. Each is loaded when it is
first asked for: `import armproof` imports neither Drake nor NumPy.
"""

from importlib import import_module
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from armproof.course.feedback import AnswerError, Feedback, Lesson, LessonError, Outcome, Row, open_lesson
    from armproof.course.inverse import inverse_of
    from armproof.models.arm import Arm
    from armproof.models.bulk.bulk import BulkKinematics, bulk_of
    from armproof.models.catalogue import load_arm
    from armproof.models.errors import ArmproofError, ModelError
    from armproof.models.exact.trace import Trace, trace_of
    from armproof.models.numeric.drake_arm import plant_of
    from armproof.models.numeric.plant import NumericKinematics
    from armproof.verification.check import verify, verify_text
    from armproof.verification.errors import DocumentError
    from armproof.verification.functions import FunctionCheck, FunctionVerdict, TableRow, check_function
    from armproof.verification.inverse import InverseError, InverseKinematics, Mark, Solutions
    from armproof.verification.singularities.analysis import analyse_singularities
    from armproof.verification.singularities.families import Family, Position, SingularityAnalysis
    from armproof.verification.verdict import Correction, DocumentResult, Record, Verdict, WrongEntry

__all__ = [
    "AnswerError",
    "Arm",
    "ArmproofError",
    "BulkKinematics",
    "Correction",
    "DocumentError",
    "DocumentResult",
    "Family",
    "Feedback",
    "FunctionCheck",
    "FunctionVerdict",
    "InverseError",
    "InverseKinematics",
    "Lesson",
    "LessonError",
    "Mark",
    "ModelError",
    "NumericKinematics",
    "Outcome",
    "Position",
    "Record",
    "Row",
    "SingularityAnalysis",
    "Solutions",
    "TableRow",
    "Trace",
    "Verdict",
    "WrongEntry",
    "analyse_singularities",
    "bulk_of",
    "check_function",
    "inverse_of",
    "load_arm",
    "open_lesson",
    "plant_of",
    "trace_of",
    "verify",
    "verify_text",
]

# Where each name stands: what the imports above tell a reader and a type checker. A test holds the three lists together.
_HOMES = {
    "armproof.course.feedback": ("AnswerError", "Feedback", "Lesson", "LessonError", "Outcome", "Row", "open_lesson"),
    "armproof.course.inverse": ("inverse_of",),
    "armproof.models.arm": ("Arm",),
    "armproof.models.bulk.bulk": ("BulkKinematics", "bulk_of"),
    "armproof.models.catalogue": ("load_arm",),
    "armproof.models.errors": ("ArmproofError", "ModelError"),
    "armproof.models.exact.trace": ("Trace", "trace_of"),
    "armproof.models.numeric.drake_arm": ("plant_of",),
    "armproof.models.numeric.plant": ("NumericKinematics",),
    "armproof.verification.check": ("verify", "verify_text"),
    "armproof.verification.errors": ("DocumentError",),
    "armproof.verification.functions": ("FunctionCheck", "FunctionVerdict", "TableRow", "check_function"),
    "armproof.verification.inverse": ("InverseError", "InverseKinematics", "Mark", "Solutions"),
    "armproof.verification.singularities.analysis": ("analyse_singularities",),
    "armproof.verification.singularities.families": ("Family", "Position", "SingularityAnalysis"),
    "armproof.verification.verdict": ("Correction", "DocumentResult", "Record", "Verdict", "WrongEntry"),
}

if not TYPE_CHECKING:

    def __getattr__(name: str) -> object:
        """Return a name of the face, loaded from where it stands (PEP 562)."""
        home = next((home for home, names in _HOMES.items() if name in names), None)
        if home is None:
            raise AttributeError(f"module 'armproof' has no attribute '{name}'")
        return globals().setdefault(name, getattr(import_module(home), name))

    def __dir__() -> list[str]:
        return sorted({*globals(), *__all__})
