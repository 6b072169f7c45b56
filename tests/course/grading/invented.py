"""A class of invented students: right answers to lesson 12, and the mistakes that are made in it, shared out by a fixed seed."""

from __future__ import annotations

import random
from pathlib import Path

from armproof.course.feedback import open_lesson
from armproof.course.tasks.scara_jacobian import JACOBIAN
from tests.course.grading.conftest import notebook

NAMES = """Ana Pérez;Bilal Haddad;Chloé Martin;Dmitri Orlov;Elif Kaya;Farid Benali;Grace Okafor;Hana Sato;Inès Dubois;Jonas Weber;
Kavya Rao;Léo Bernard;Mei Lin;Nadia Rossi;Omar Farouk;Paula Gómez;Quentin Roux;Rania Saïdi;Sven Larsen;Tomás Silva;Ugo Ricci;
Vera Novak;Wassim Trabelsi;Xavier Petit;Yara Mansour;Zoé Lambert;Amine Cherif;Britta Holm;Camille Noël;Diego Torres"""
STUDENTS = [name.strip() for name in NAMES.split(";")]
OPEN = "import numpy as np\nfrom armproof import open_lesson\nlesson = open_lesson('scara_jacobian')"
LOST_SIGN = JACOBIAN.replace("1 & 1 & 0 & -1", "1 & 1 & 0 & 1")  # of z_3: the hand of joint 4 points down
SAME_LEVER = JACOBIAN.replace("-a_2 S_{12} & 0 & 0 ", "-a_1 S_1 - a_2 S_{12} & 0 & 0 ").replace(
    "& a_2 C_{12} &", "& a_1 C_1 + a_2 C_{12} &"
)
ROTATION = '''def rotation(q):
    """Return R^0_2, 3×3."""
    s, c = np.sin(q[0] + q[1]), np.cos(q[0] + q[1])
    return np.array([[c, s, 0], [s, -c, 0], [0, 0, -1]])'''
WITHOUT_TURN = ROTATION.replace("[[c, s, 0], [s, -c, 0], [0, 0, -1]]", "[[c, -s, 0], [s, c, 0], [0, 0, 1]]")


def answers() -> dict[str, list[str]]:
    """Return the answers to each task as Python: a right one, then wrong ones."""
    found = {}
    for task in open_lesson("scara_jacobian").tasks:
        right, wrong = (
            [repr(each) for each in some if isinstance(each, str | int | list)]
            for some in (task.right, [wrong.answer for wrong in task.wrong])
        )
        found[task.name] = [right[0], *wrong[:3]]
    found["jacobian"] = [repr(JACOBIAN), repr(LOST_SIGN), repr(SAME_LEVER)]
    found["null_motion"] += [
        found["null_motion"][0].replace(*change) for change in (("-a_1 ", " a_1 "), ("-(a_1", " (a_1"))
    ]
    found["rotation"] = [f"{ROTATION}\n\n\n!rotation", f"{WITHOUT_TURN}\n\n\n!rotation"]
    return found


def write_class(folder: Path, number: int = 30) -> None:
    """Write the notebooks of so many students."""
    folder.mkdir(parents=True, exist_ok=True)
    known, chance = answers(), random.Random(12)
    for student in STUDENTS[:number]:
        care = chance.uniform(0.35, 1)
        cells = [OPEN]
        for task, (right, *wrong) in known.items():
            if chance.random() > 0.5 + care / 2:
                continue
            given = [] if not wrong or chance.random() < care else chance.choices(wrong, range(len(wrong), 0, -1))
            given += [right] if not given or chance.random() < 0.25 else []
            cells += [_cell(task, answer) for answer in given]
        (folder / f"{student}.ipynb").write_bytes(notebook(*cells))


def _cell(task: str, answer: str) -> str:
    before, mark, name = answer.partition("!")
    return f"{before if mark else ''}lesson.{task}.check({name if mark else answer})"
