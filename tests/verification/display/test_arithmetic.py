"""What numbers alone tell of: nothing that a document says of letters, however right they are calculated."""

from __future__ import annotations

from pathlib import Path

from armproof.verification.check import check_document
from armproof.verification.document.formats import parse_document
from armproof.verification.verdict import Verdict


def test_numbers_beside_a_letter_use_no_definition_of_it() -> None:
    for formula in (r"h + L_1\sin\varphi_1", r"h - L_1\cos\varphi_1"):
        text = f"# Arm\n$$ y_D = {formula} $$\n\nThen the height is\n\n$$ y_D = 5\\sin 30^\\circ - 4\\sin 60^\\circ \\approx -0.96 $$\n"
        definition, _ = check_document(parse_document(Path("arm.md"), text)).equations
        assert definition.verdict is Verdict.UNCHECKED
