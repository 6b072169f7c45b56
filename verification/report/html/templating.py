"""The shell of every page: its templates, its style and script, and a policy that forbids the network."""

from __future__ import annotations

import base64
import hashlib
import platform
from collections.abc import Iterable
from functools import cached_property, lru_cache
from importlib.metadata import PackageNotFoundError, version
from typing import Any

from jinja2 import ChoiceLoader, Environment, PackageLoader, StrictUndefined
from markupsafe import Markup

from armproof.models.language import look_up, number_text, spoken
from armproof.verification.report.html.sketch import sketch_style

GENERATOR = "Armproof"
_HERE = "armproof.verification.report.html"


class Shell:
    """Writes pages of one kind: they extend shell.html, and what a package has not is the report's.

    Attributes:
        package: where the templates are, and the files of the style and the script.
        styles: the files of the style; with `drawn`, that of the drawings of an arm stands before them.
        scripts: the files of the script; without one, none runs.
        allowed: what a page may load beside them, as a policy says it.
    """

    def __init__(
        self,
        package: str = _HERE,
        styles: tuple[str, ...] = ("shell.css", "style.css"),
        scripts: tuple[str, ...] = ("script.js",),
        *,
        allowed: str = "",
        drawn: bool = True,
    ) -> None:
        self._package, self._styles, self._scripts, self._allowed, self._drawn = (
            package,
            styles,
            scripts,
            allowed,
            drawn,
        )

    def render(self, template: str, styles: Iterable[str] = (), **values: Any) -> str:
        """Return a page; every value is escaped unless it is Markup.

        Args:
            template: its file.
            styles: what its content brings along.
            values: what the template shows.
        """
        sheets = [Markup(sheet) for sheet in dict.fromkeys((self._style, *styles))]
        shell = {
            "sheets": sheets,
            "script": Markup(self._program),
            "policy": self._policy(sheets),
            "generator": GENERATOR,
        }
        return self._environment.get_template(template).render(**values, **shell)

    def _policy(self, sheets: Iterable[str]) -> str:
        """Return a policy under which a page shows itself, and asks for nothing but what is allowed."""
        style = f"style-src {' '.join(map(_digest, sheets))}"
        script = f"; script-src {_digest(self._program)}" if self._program else ""
        return f"default-src 'none'; {self._allowed}{style}{script}; base-uri 'none'; form-action 'none'"

    @cached_property
    def _style(self) -> str:
        return (sketch_style() if self._drawn else "") + "".join(map(self._resource, self._styles))

    @cached_property
    def _program(self) -> str:
        return "".join(map(self._resource, self._scripts))

    @cached_property
    def _environment(self) -> Environment:
        environment = Environment(
            loader=ChoiceLoader([PackageLoader(package) for package in dict.fromkeys((self._package, _HERE))]),
            autoescape=True,
            undefined=StrictUndefined,
            trim_blocks=True,
            lstrip_blocks=True,
        )
        environment.globals |= {"_": said, "spoken": spoken, "number_text": number_text}
        return environment

    def _resource(self, name: str) -> str:
        assert self._environment.loader is not None
        return self._environment.loader.get_source(self._environment, name)[0]


REPORT = Shell()


def said(template: str, /, **terms: object) -> Markup:
    """Return a sentence of the look-up as HTML: its terms are escaped, but where they are Markup."""
    return Markup(look_up(template)).format(**terms)


def heading(text: str) -> str:
    """Return words with a capital at their beginning."""
    return text[:1].upper() + text[1:]


@lru_cache(maxsize=1)
def versions() -> tuple[tuple[str, str], ...]:
    """Return what the verdicts were computed with."""
    packages = (("Armproof", "armproof"), ("Drake", "drake"), ("python-flint", "python-flint"))
    return (*((name, version_of(package)) for name, package in packages), ("Python", platform.python_version()))


def version_of(package: str) -> str:
    """Return the version of a package that is installed."""
    try:
        return version(package)
    except PackageNotFoundError:
        return look_up("not installed")


def _digest(text: str) -> str:
    return f"'sha256-{base64.b64encode(hashlib.sha256(text.encode()).digest()).decode()}'"
