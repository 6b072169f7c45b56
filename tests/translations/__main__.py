"""Brings the catalogues of every language up to date, and lists what is to translate: exit code 1 where anything is.

Names of languages and of documents (fr, 01_frames, kr210-001, messages) say which; by default all.
"""

import sys

from armproof.models.language import languages
from tests.translations.catalogues import update
from tests.translations.documents import DOCUMENTS, catalogue_of, said_in
from tests.translations.extraction import catalogue_of_messages, said
from tests.translations.terms import misused_in

if __name__ == "__main__":
    names = [name for name in sys.argv[1:] if name not in languages()]
    found: list[str] = []
    for lang in [lang for lang in sys.argv[1:] if lang in languages()] or languages()[1:]:
        if not names or "messages" in names:
            found += update(catalogue_of_messages(lang), lang, said())
            found += misused_in(catalogue_of_messages(lang), lang)
        for document in DOCUMENTS:
            if not names or document.stem in names:
                found += update(catalogue_of(document, lang), lang, said_in(document))
                found += misused_in(catalogue_of(document, lang), lang)
    print(*found, f"{len(found)} to translate or to correct", sep="\n")
    sys.exit(bool(found))
