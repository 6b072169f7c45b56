"""The templates of the pages, and what every page has: its style, its script, and a policy that forbids the network."""

from __future__ import annotations

import base64
import hashlib
import platform
from functools import lru_cache
from importlib import resources
from importlib.metadata import PackageNotFoundError, version
from typing import Any

from jinja2 import Environment, PackageLoader, StrictUndefined
from markupsafe import Markup

from armproof.verification.report.html.sketch import sketch_style

GENERATOR = "Armproof"


def render(template: str, **values: Any) -> str:
    """Return a page; every value is escaped unless it is Markup."""
    return _environment().get_template(template).render(**values, **every_page())


@lru_cache(maxsize=1)
def versions() -> tuple[tuple[str, str], ...]:
    """Return what the verdicts were computed with."""
    return (("Armproof", _version("armproof")), ("Drake", _version("drake")), ("python-flint", _version("python-flint")),
            ("Python", platform.python_version()))  # fmt: skip


@lru_cache(maxsize=1)
def _environment() -> Environment:
    return Environment(
        loader=PackageLoader("armproof.verification.report.html"),
        autoescape=True,
        undefined=StrictUndefined,
        trim_blocks=True,
        lstrip_blocks=True,
    )


@lru_cache(maxsize=1)
def every_page() -> dict[str, Any]:
    """Return the style, the script and the policy that base.html wants."""
    style, script = sketch_style() + _resource("style.css"), _resource("script.js")
    policy = f"default-src 'none'; style-src '{_digest(style)}'; script-src '{_digest(script)}'; base-uri 'none'; form-action 'none'"
    return {"style": Markup(style), "script": Markup(script), "policy": policy, "generator": GENERATOR}


def _resource(name: str) -> str:
    return resources.files("armproof.verification.report.html").joinpath("templates", name).read_text(encoding="utf-8")


def _digest(text: str) -> str:
    return f"sha256-{base64.b64encode(hashlib.sha256(text.encode()).digest()).decode()}"


def _version(package: str) -> str:
    try:
        return version(package)
    except PackageNotFoundError:
        return "not installed"
