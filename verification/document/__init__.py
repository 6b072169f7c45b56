"""Read documents: front matter, displays and DH tables of every format that is read."""

from armproof.verification.document.formats import SUFFIXES, find_documents, parse_document, read_document
from armproof.verification.document.front_matter import FRONT_MATTER_KEYS, parse_front_matter
from armproof.verification.document.model import Display, Document, Piece, Table

__all__ = [
    "FRONT_MATTER_KEYS",
    "SUFFIXES",
    "Display",
    "Document",
    "Piece",
    "Table",
    "find_documents",
    "parse_document",
    "parse_front_matter",
    "read_document",
]
