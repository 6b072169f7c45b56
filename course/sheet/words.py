"""The words that a sheet adds to its document, in English and French."""

from __future__ import annotations

from armproof.course.sheet.errors import PrintError

LANGUAGES = ("en", "fr")

_WORDS: dict[str, tuple[str, str]] = {
    "draft": ("DRAFT", "BROUILLON"),
    "figures": ("Figures", "Figures"),
    "erratum": ("the source is wrong here", "la source se trompe ici"),
    "edition": ("Teacher’s edition: solutions and errata", "Édition de l’enseignant : solutions et errata"),
    "one_proved": ("1 equation proved", "1 équation démontrée"),
    "proved": ("{count} equations proved", "{count} équations démontrées"),
    "confirmed": ("{count} confirmed by computation", "{count} confirmées par le calcul"),
    "unchecked": ("{count} not checked", "{count} non vérifiées"),
    "failed": ("{count} not proved", "{count} non démontrées"),
    "against": (" against Drake", " avec Drake"),
    "by": (" by Armproof {version}", " par Armproof {version}"),
    "no_equation": ("no equation proved", "aucune équation démontrée"),
    "refuted": ("refuted", "réfutée"),
    "unreadable": ("not read", "non lue"),
    "unchecked_one": ("not checked", "non vérifiée"),
    "erratum_holds": ("erratum not refuted", "erratum non réfuté"),
}


def check_language(lang: str) -> str:
    """Return the language of a sheet: fr-FR is fr.

    Raises:
        PrintError: another language than English and French.
    """
    short = lang.strip().lower().replace("_", "-").partition("-")[0]
    if short not in LANGUAGES:
        raise PrintError("no language '{lang}'; a sheet is printed in {languages}", lang=lang, languages=list(LANGUAGES))  # fmt: skip
    return short


def say(key: str, lang: str, **values: object) -> str:
    """Return the words of a key in a language."""
    return _WORDS[key][LANGUAGES.index(lang)].format(**values)
