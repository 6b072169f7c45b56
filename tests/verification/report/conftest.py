"""The course's report and others, for the tests of the pages."""

import os
from pathlib import Path

import pytest

from armproof.verification.cli.documents import check_and_report

ROOT = Path(__file__).resolve().parents[3]
WRONG = r"""---
title: The planar 2R arm, $p_2$ & its Jacobian
arm:
  dh: classic
  rows:
    - {a: l_1, alpha: 0, d: 0, theta: theta_1}
    - {a: l_2, alpha: 0, d: 0, theta: theta_2}
quantities:
  J_v: {jacobian: 2, rows: [1, 2]}
---

# Position $p_2$ of the *tool*

$$ p_2 = \begin{bmatrix} l_1 C_1 + l_2 C_{12} \\ l_1 S_1 - l_2 S_{12} \\ 0 \end{bmatrix} $$

$$ {}^0T_1 = \begin{bmatrix} C_1 & -S_1 & 0 & l_1 C_1 \\ S_1 & C_1 & 0 & l_1 S_1 \\ 0 & 0 & 1 & 0 \\ 0 & 0 & 0 & 1 \end{bmatrix} $$

# Velocity

$$ J_v = \begin{bmatrix} -l_1 S_1 - l_2 S_{12} & l_2 S_{12} \\ l_1 C_1 + l_2 C_{12} & l_2 C_{12} \end{bmatrix} $$

$$ \det J_v = l_1 l_2 \sin\theta_1 $$

| i | a_i | alpha_i | d_i | theta_i |
|---|---|---|---|---|
| 1 | l_2 | 0 | 0 | $\theta_1$ |
| 2 | l_2 | 0 | 0 | $\theta_2$ |

> **Erratum**
> $$ \cos(\theta_1 + \theta_2) = \cos\theta_1 + \cos\theta_2 $$
"""
ATTACK = "<script>window.attacked=1</script><img src=x onerror=window.attacked=1>"
HOSTILE = rf"""---
title: '{ATTACK} "quoted" & done'
source: "{ATTACK.replace('"', "")}"
---

# Section {ATTACK}

$$ a_{{<b>}} = \text{{{ATTACK}}} $$

$$ x = \text{{</math></code></pre>{ATTACK}}} y \foo $$

$$ </script><script>window.attacked=1</script> $$

$$ (a + b)^2 = a^2 + b^2 $$

| i | a_i | alpha_i | d_i | theta_i |
|---|---|---|---|---|
| {ATTACK} | "><script>window.attacked=1</script> | 0 | 0 | 0 |
"""


@pytest.fixture(scope="session")
def course_report(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """The report of course/: of some of its documents, and of all in a sweep."""
    folder = tmp_path_factory.mktemp("course") / "report"
    handouts = ROOT / "course/handouts"
    some = [handouts / f"{name}.md" for name in ("scara-000", "dh-modified-001", "planar-2r-002")]
    check_and_report([ROOT / "course"] if os.environ.get("ARMPROOF_SWEEP") else some, folder)
    return folder


@pytest.fixture(scope="session")
def wrong_report(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """The report of one document with a handful of slips."""
    folder = tmp_path_factory.mktemp("wrong")
    (folder / "planar-2r.md").write_text(WRONG, encoding="utf-8")
    check_and_report([folder / "planar-2r.md"], folder / "report")
    return folder / "report"


@pytest.fixture(scope="session")
def hostile_report(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """The report of a document that tries to run a script, under names that try it too."""
    folder = tmp_path_factory.mktemp("hostile")
    for name in ("<script>alert(1)<", 'été "quoted" \'n spaced', "a&b;%20"):
        (folder / f"{name}.md").write_text(HOSTILE, encoding="utf-8")
    (folder / f"broken {ATTACK.split('/')[0]}.md").write_text("---\narm: <script>\n---\n", encoding="utf-8")
    check_and_report([folder], folder / "report")
    return folder / "report"
