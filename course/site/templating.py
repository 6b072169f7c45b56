"""The templates of the site, and what every page has: its style, and a policy that forbids the network."""

from __future__ import annotations

import base64
import hashlib
from collections.abc import Iterable
from functools import lru_cache
from importlib import resources
from typing import Any

from jinja2 import Environment, PackageLoader, StrictUndefined
from markupsafe import Markup

from armproof.verification.report.html.sketch import sketch_style
from armproof.verification.report.html.templating import GENERATOR, versions


def render(template: str, styles: Iterable[str] = (), **values: Any) -> str:
    """Return a page; every value is escaped unless it is Markup.

    Args:
        template: its file.
        styles: what the outputs on the page bring along.
        values: what the template shows.
    """
    sheets = [Markup(sheet) for sheet in dict.fromkeys((_style(), *styles))]
    return (
        _environment()
        .get_template(template)
        .render(
            **values,
            sheets=sheets,
            script=Markup(_resource("site.js")),
            policy=_policy(sheets),
            generator=GENERATOR,
            versions=versions(),
        )
    )


def _policy(sheets: Iterable[str]) -> str:
    """Return a policy under which a page shows itself, its pictures and the 3D views beside it, and asks for nothing else."""
    allowed = " ".join(f"'{_digest(sheet)}'" for sheet in sheets)
    return (
        f"default-src 'none'; img-src data:; style-src {allowed}; script-src '{_digest(_resource('site.js'))}'; "
        "frame-src 'self'; base-uri 'none'; form-action 'none'"
    )


@lru_cache(maxsize=1)
def _style() -> str:
    return sketch_style() + _resource("site.css")


@lru_cache(maxsize=1)
def _environment() -> Environment:
    return Environment(
        loader=PackageLoader("armproof.course.site"),
        autoescape=True,
        undefined=StrictUndefined,
        trim_blocks=True,
        lstrip_blocks=True,
    )


@lru_cache(maxsize=8)
def _resource(name: str) -> str:
    return resources.files("armproof.course.site").joinpath("templates", name).read_text(encoding="utf-8")


def _digest(text: str) -> str:
    return f"sha256-{base64.b64encode(hashlib.sha256(text.encode()).digest()).decode()}"
