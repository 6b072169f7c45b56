"""Catalogues: what the sources say and a translation has not is found, and what is translated is said."""

import re
import subprocess
import sys
from pathlib import Path

import pytest

from armproof.models import language
from armproof.models.errors import ModelError, counted, written
from armproof.verification.findings import Kind, say
from tests.translations.catalogues import Message, problems, update

SAID = [Message("no frame {frame}", "a.py"), Message("{number} frame", "b.py", "{number} frames")]


@pytest.fixture
def catalogue(tmp_path: Path) -> Path:
    """A catalogue in which all is translated."""
    path = tmp_path / "fr" / "messages.po"
    update(path, "fr", SAID)
    text = path.read_text()
    text = text.replace('"no frame {frame}"\nmsgstr ""', '"no frame {frame}"\nmsgstr "pas de repère {frame}"')
    text = text.replace('msgstr[0] ""', 'msgstr[0] "{number} repère"')
    text = re.sub(
        r'(msgstr\[\d\]) ""', r'\1 "{number} repères"', text
    )  # two forms or, with the millions, three: as Babel has it
    path.write_text(text)
    return path


def test_a_catalogue_is_complete_until_the_sources_say_something_else(catalogue: Path) -> None:
    assert problems(catalogue, "fr", SAID) == []
    more = [*SAID, Message("no joint", "c.py")]
    assert problems(catalogue, "fr", more) == ["missing: messages.po: 'no joint' (c.py)"]
    assert problems(catalogue, "fr", SAID[:1]) == ["no longer said: messages.po: '{number} frame'"]
    changed = [Message("no frame '{frame}'", "a.py"), SAID[1]]
    assert update(catalogue, "fr", changed) == ["outdated (fuzzy): messages.po: \"no frame '{frame}'\" (a.py)"]
    assert language.catalogue(catalogue).gettext("no frame '{frame}'") == "no frame '{frame}'"


@pytest.mark.parametrize(
    "wrong", ["pas de repère", "pas de repère {name}", "pas de repère {frame} {frame}", "`{frame}`"]
)
def test_a_translation_that_drops_a_field_is_found(catalogue: Path, wrong: str) -> None:
    catalogue.write_text(catalogue.read_text().replace('"pas de repère {frame}"', f'"{wrong}"'))
    (found,) = problems(catalogue, "fr", SAID)
    assert found.startswith("other fields or marks")


def test_writing_a_catalogue_again_changes_nothing(catalogue: Path) -> None:
    before = catalogue.read_bytes()
    assert update(catalogue, "fr", SAID) == []
    assert catalogue.read_bytes() == before


def test_a_sentence_is_said_in_the_language_that_is_spoken(catalogue: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(language, "FOLDER", catalogue.parents[1])
    language._messages.cache_clear()
    with language.use("fr"):
        assert written("no frame {frame}", frame=0.5) == "pas de repère 0,5"
        assert written("no frame {frame}", frame=[1, 2]) == "pas de repère 1, 2"
        assert written("no frame {frame}", frame=[0.05, 0.55]) == "pas de repère 0,05\u00a0; 0,55"
        assert str(ModelError("no frame {frame}", frame="9")) == "pas de repère 9"
        assert [counted("{number} frame", "{number} frames", n) for n in (0, 1, 2)] == [
            "0 repère",
            "1 repère",
            "2 repères",
        ]
        assert written("no joint") == "no joint", "what is not translated stays English"
        assert str(say(Kind.VALUE, name="q", value=0.5)) == "`q` = 0,5".replace("`", "")
    assert written("no frame {frame}", frame=0.5) == "no frame 0.5"
    language._messages.cache_clear()


def test_the_language_is_that_of_the_environment(monkeypatch: pytest.MonkeyPatch) -> None:
    for name in ("LANGUAGE", "LC_ALL", "LC_MESSAGES"):
        monkeypatch.delenv(name, raising=False)
    for text, lang in {"C": "en", "fr_FR.UTF-8": "fr", "fr": "fr", "de_DE.UTF-8": "en", "": "en"}.items():
        monkeypatch.setenv("LANG", text)
        assert language.language_of_environment() == lang
    monkeypatch.setenv("LC_ALL", "en_GB.UTF-8")
    assert language.language_of_environment() == "en"


def test_english_needs_no_catalogue() -> None:
    program = (
        "import sys; from armproof.models.errors import written; written('a {b}', b=0.5); print('babel' in sys.modules)"
    )
    assert subprocess.run([sys.executable, "-c", program], capture_output=True, text=True).stdout == "False\n"
