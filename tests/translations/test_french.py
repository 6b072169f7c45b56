"""What a French reader gets: the command, its pages, and a catalogue in which nothing is missing."""

import html
import os
import re
import subprocess
from collections import Counter
from pathlib import Path

import pytest

from armproof.models.language import languages, use
from armproof.verification.check import verify_text
from tests.forked import armproof
from tests.translations.catalogues import problems
from tests.translations.extraction import catalogue_of_messages, said
from tests.translations.terms import misused_in

ENGLISH = """the of and is are was it this that these those which what with without where when from into than then not no
only other another each every all both one for by at as be been has have does do must should would its their there""".split()
SAME = {"entre", "est", "on", "a", "an", "or", "as", "no", "son", "sera"}  # words of both languages are no evidence
DOCUMENT = r"""---
title: Bras plan 2R
arm: planar_2r
lang: fr
---

# Modèle géométrique direct

$$ p_x = l_1 \cos\theta_1 + l_2 \cos(\theta_1 + \theta_2) $$

$$ p_y = l_1 \sin\theta_1 - l_2 \sin(\theta_1 + \theta_2) $$

$$ J = \begin{bmatrix} -l_1 S_1 - l_2 S_{12} & -l_2 S_{12} \\ l_1 C_1 + l_2 C_{12} & l_2 C_2 \end{bmatrix} $$

$$ w = \mu + \frac{1}{2 $$

| i | $a_i$ | $\alpha_i$ | $d_i$ | $\theta_i$ |
|---|---|---|---|---|
| 1 | $l_1$ | 0 | 0 | $\theta_1$ |
| 2 | $l_1$ | 0 | 0 | $\theta_2$ |
"""


def run(folder: Path, *arguments: str, lang: str = "C") -> subprocess.CompletedProcess[str]:
    environment = {
        name: value for name, value in os.environ.items() if name not in ("LANGUAGE", "LC_ALL", "LC_MESSAGES")
    }
    return armproof(*arguments, folder=folder, environment=environment | {"LANG": lang})


def visible(page: str) -> str:
    """Return the words of a page that a reader sees: no formulas, no code."""
    for tag in ("style", "script", "math", "code", "pre", "svg", "title"):
        page = re.sub(rf"<{tag}\b.*?</{tag}>", " ", page, flags=re.DOTALL)
    return html.unescape(re.sub(r"<[^>]+>", " ", page))


def english_in(text: str) -> tuple[float, Counter[str]]:
    """Return the share of English function words in a text, and which they are."""
    words = re.findall(r"[a-zà-ÿœ]+", text.lower())
    found = Counter(word for word in words if word in set(ENGLISH) - SAME)
    return found.total() / max(len(words), 1), found


@pytest.fixture(scope="module")
def folder(tmp_path_factory: pytest.TempPathFactory) -> Path:
    folder = tmp_path_factory.mktemp("french")
    (folder / "bras.md").write_text(DOCUMENT, encoding="utf-8")
    return folder


@pytest.fixture(scope="module", autouse=True)
def loaded() -> None:
    """Load once what each copy of this process would load anew: the catalogue, and what checks a document."""
    with use("fr"):
        assert not verify_text(DOCUMENT).passed


def test_pages_of_a_french_document_are_french(folder: Path) -> None:
    result = run(folder, "verify", "bras.md", "--report", "rapport", lang="fr_FR.UTF-8")
    assert result.returncode == 1, result.stderr
    assert "1 document n'est pas accepté" in result.stdout and "réfutée" in result.stdout
    for name in ("bras.html", "index.html"):
        page = (folder / "rapport" / name).read_text(encoding="utf-8")
        assert '<html lang="fr">' in page
        share, found = english_in(visible(page))
        assert share < 0.005, found


def test_headings_of_a_document_with_a_catalogue_are_french(tmp_path: Path) -> None:
    document = str(Path(__file__).parents[2] / "course/handouts/dh-classic-001.md")
    asked = ("--report", "rapport", "--errata", "errata.md")
    said = run(tmp_path, "verify", document, *asked, "--verbose", "--lang", "fr").stdout
    for page in (tmp_path / "rapport").glob("*.html"):
        share, found = english_in(visible(page.read_text(encoding="utf-8")))
        assert share < 0.005, found
    sheet = (tmp_path / "errata.md").read_text(encoding="utf-8")
    assert "ligne 63\u00a0: L'inverse" in sheet and "telle qu'imprimée" in sheet and "$a_i = 0{,}49$\u00a0; $" in sheet
    assert english_in(said + sheet)[0] < 0.005
    run(tmp_path, "verify", document, *asked, "--lang", "en")
    assert "line 63: The inverse" in (tmp_path / "errata.md").read_text(encoding="utf-8")


def test_an_english_page_is_found_english(folder: Path) -> None:
    assert run(folder, "verify", "bras.md", "--report", "report", "--lang", "en").returncode == 1
    page = (folder / "report/bras.html").read_text(encoding="utf-8")
    assert '<html lang="en">' in page
    assert english_in(visible(page))[0] > 0.05


def test_the_document_says_its_language_and_lang_goes_before_it(folder: Path) -> None:
    assert "réfutée" in run(folder, "verify", "bras.md").stdout
    assert "réfutée" not in run(folder, "verify", "bras.md", "--lang", "en", lang="fr_FR.UTF-8").stdout
    wrong = run(folder, "verify", "bras.md", "--lang", "xx")
    assert wrong.returncode == 2 and "no language 'xx'" in wrong.stderr


def test_json_is_english_whatever_the_environment(folder: Path) -> None:
    texts = [run(folder, "verify", "bras.md", "--format", "json", lang=lang).stdout for lang in ("C", "fr_FR.UTF-8")]
    timeless = [re.sub(r'"seconds": [\d.e-]+', "", text) for text in texts]
    assert timeless[0] == timeless[1] and "should be" in timeless[0]


def test_the_help_is_french() -> None:
    help_text = run(Path.cwd(), "verify", "--help", "--lang", "fr").stdout
    assert "Donne le verdict de chaque équation" in help_text


@pytest.mark.parametrize(
    ("arguments", "said"),
    [
        (("verify", "--nope", "--lang=fr"), "L'option --nope n'existe pas."),
        (
            ("verify", "--lang", "fr", "--jobs", "aa"),
            "Valeur incorrecte pour '--jobs' / '-j'\u00a0: ce n'est pas un nombre entier",
        ),
        (
            ("verify", "--lang", "fr", "--format", "zz"),
            "Valeur incorrecte pour '--format'\u00a0: 'zz' n'est pas parmi 'text', 'json', 'github'.",
        ),
        (("lesson", "sit", "--lang", "fr"), "La commande 'sit' n'existe pas. Vouliez-vous dire 'site'\u202f?"),
    ],
)
def test_a_wrong_use_is_told_in_french(arguments: tuple[str, ...], said: str) -> None:
    wrong = run(Path.cwd(), *arguments)
    assert wrong.returncode == 2 and f"Erreur\u00a0: {said}\n" in wrong.stderr and english_in(wrong.stderr)[0] == 0
    assert "Error: " in run(Path.cwd(), *(word for word in arguments if "lang" not in word and word != "fr")).stderr


def test_a_command_asked_for_english_opens_english_lessons() -> None:
    assert "Frames and" in run(Path.cwd(), "lesson", "list", "--lang", "en", lang="fr_FR.UTF-8").stdout
    assert "Repères et" in run(Path.cwd(), "lesson", "list", lang="fr_FR.UTF-8").stdout


@pytest.mark.parametrize("lang", languages()[1:])
def test_nothing_that_is_said_lacks_its_translation(lang: str) -> None:
    """Run `make translations` and fill in what it lists; what is no longer said goes with it, and harms nobody before."""
    found = problems(catalogue_of_messages(lang), lang, said())
    assert [each for each in found if not each.startswith("no longer said")] == []
    assert misused_in(catalogue_of_messages(lang), lang) == []
