"""The terms of the field in English and another language, of the list that translations are held to."""

from __future__ import annotations

import csv

from armproof.course.site.order import Order, switches
from armproof.course.site.page import INDEX, SITE
from armproof.models.language import ENGLISH
from armproof.verification.report.html.templating import versions

GLOSSARY = "glossary"


def glossary_page(order: Order) -> str:
    """Return the file of the glossary; empty where the site has one language."""
    return f"{GLOSSARY}{order.suffix}.html" if _other(order) else ""


def write_glossary(order: Order) -> str:
    """Return the page of the terms, in the alphabet of the page's language; empty where there is no other language."""
    if not (other := _other(order)):
        return ""
    file = order.place.root / "translations" / other / "terms.csv"
    with file.open(encoding="utf-8", newline="") as rows:
        terms = [(row["english"], row["translation"].replace("|", ", ")) for row in csv.DictReader(rows)]
    own = 0 if order.lang == ENGLISH else 1
    return SITE.render(
        "glossary.html",
        terms=sorted(terms, key=lambda term: term[own].lower()),
        index=f"{INDEX}{order.suffix}.html",
        switches=switches(order.langs, order.lang, GLOSSARY),
        other=other,
        versions=versions(),
    )


def _other(order: Order) -> str:
    """Return the language beside English, with a list of terms."""
    found = [lang for lang in order.langs if (order.place.root / "translations" / lang / "terms.csv").is_file()]
    return found[0] if found else ""
