"""The arm that a document shows where its front matter names none: read from its DH table or from its link matrices."""

from armproof.verification.tables.arms.against import lengths_against
from armproof.verification.tables.arms.armless import with_armless
from armproof.verification.tables.arms.catalogue import difference, table_of_named
from armproof.verification.tables.arms.disputed import unless_disputed
from armproof.verification.tables.arms.ends import tells_other_tool
from armproof.verification.tables.arms.inference import infer_arm, joints_used
from armproof.verification.tables.arms.rivals import unless_rivalled
from armproof.verification.tables.arms.scopes import scopes
from armproof.verification.tables.arms.settling import Inference, settle_data
from armproof.verification.tables.arms.support import OF_TOOL, is_of_no_arm, links_of, links_that_explain
from armproof.verification.tables.arms.values import entries_by_place, letters_of_numbers, stated_lengths

__all__ = [
    "OF_TOOL",
    "Inference",
    "difference",
    "entries_by_place",
    "infer_arm",
    "is_of_no_arm",
    "joints_used",
    "lengths_against",
    "letters_of_numbers",
    "links_of",
    "links_that_explain",
    "scopes",
    "settle_data",
    "stated_lengths",
    "table_of_named",
    "tells_other_tool",
    "unless_disputed",
    "unless_rivalled",
    "with_armless",
]
