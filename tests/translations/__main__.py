"""Brings the catalogues of every language up to date, and lists what is to translate: exit code 1 where anything is."""

import sys

from armproof.models.language import languages
from tests.translations.catalogues import update
from tests.translations.extraction import catalogue_of_messages, said

if __name__ == "__main__":
    asked = sys.argv[1:] or languages()[1:]
    found = [line for lang in asked for line in update(catalogue_of_messages(lang), lang, said())]
    print(*found, f"{len(found)} to translate or to correct", sep="\n")
    sys.exit(bool(found))
