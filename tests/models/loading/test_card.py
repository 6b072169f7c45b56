"""Convention cards: what they bind, and what is wrong in them, by file and line."""

from pathlib import Path

import pytest

from armproof.models.arm import Arm
from armproof.models.catalogue import arm_names, load_arm
from armproof.models.errors import ModelError
from armproof.models.exact.polynomial import generators
from armproof.models.exact.trace import trace_of
from tests.models.conftest import joint, link

URDF = (
    link("base", "l1", "l2", "tool")
    + joint("j1", "base", "l1", xyz="0 0 0.5")
    + joint("j2", "l1", "l2", xyz="0.4 0 -0.1", rpy="1.5707963267948966 0 0")
    + joint("t", "l2", "tool", "fixed", "0.4 0 0", extra="")
)
CARD = """\
title: A small arm
joints: {j1: theta_1, j2: theta_2}
lengths:
  d_1: j1.z
  a: [j2.x, t.x]
  h: -j2.z
frames: {0: base, 1: j2.parent, 2: l2, E: tool}
"""


@pytest.fixture
def folder(tmp_path: Path) -> Path:
    folder = tmp_path / "small"
    folder.mkdir()
    (folder / "small.urdf").write_text(f'<robot name="small">{URDF}</robot>')
    (folder / "arm.yaml").write_text(CARD)
    return folder


def load_with(folder: Path, *changes: tuple[str, str]) -> Arm:
    text = CARD
    for old, new in changes:
        assert old in text
        text = text.replace(old, new)
    (folder / "arm.yaml").write_text(text)
    return load_arm(folder)


def test_a_card_names_joints_lengths_and_frames(folder: Path) -> None:
    arm = load_arm(folder)
    assert (arm.name, arm.title, arm.source, arm.zero) == ("small", "A small arm", "", "")
    assert [joint.symbol for joint in arm.joints] == ["theta_1", "theta_2"]
    assert arm.lengths == {"d_1": 0.5, "a": 0.4, "h": 0.1}
    assert arm.frames == ("0", "1", "2", "E")
    assert generators(entry for row in trace_of(arm).pose("E") for entry in row) == {
        ("cos", "theta_1"), ("sin", "theta_1"), ("cos", "theta_2"), ("sin", "theta_2"),
        ("symbol", "d_1"), ("symbol", "a"), ("symbol", "h"),
    }  # fmt: skip


def test_a_card_is_found_from_its_folder_and_from_its_model(folder: Path) -> None:
    assert load_arm(folder / "small.urdf") is load_arm("small", folder.parent) is load_arm("small.urdf", folder)


def test_every_length_of_the_catalogue_is_positive_and_different(arm: Arm) -> None:
    assert all(value > 0 for value in arm.lengths.values())
    assert len(set(arm.lengths.values())) == len(arm.lengths)


@pytest.mark.parametrize("name", arm_names())
def test_no_length_of_the_catalogue_stays_a_number(name: str) -> None:
    """Every coefficient of a traced origin is an integer unless the arm has no symbol for it."""
    arm = load_arm(name)
    for frame in arm.frames:
        for entry in (row[3] for row in trace_of(arm).pose(frame)[:3]):
            for monomial, coefficient in entry.items():
                assert abs(coefficient) == 1, (name, frame, monomial, coefficient)
                assert any(kind == "symbol" for (kind, _), _ in monomial)


@pytest.mark.parametrize(
    ("old", "new", "line", "message"),
    [
        ("title:", "titel:", 1, "unknown key 'titel'; the keys are title, source, model, joints, lengths, frames, zero"),
        ("title: A small arm\n", "", 1, "'title' is missing; a card needs title, joints, frames"),
        ("title: A small arm", "title: [a]", 1, "'title' must be a text, not a list"),
        ("title: A small arm", "title:", 1, "'title' must be a text, not empty"),
        ("joints: {j1: theta_1, j2: theta_2}", "joints: theta_1", 2, "'joints' must be a mapping, not 'theta_1'"),
        ("j2: theta_2}", "j1: theta_2}", 2, "'j1' stands twice in 'joints'"),
        ("j2: theta_2}", "j3: theta_2}", 2, "joints are j1, j3; the model has, base to tool, j1, j2"),
        ("{j1: theta_1, j2: theta_2}", "{j2: theta_2, j1: theta_1}", 2, "joints are j2, j1; the model has, base to tool, j1, j2"),
        ("j2: theta_2}", "j2: 2*q}", 2, r"joint 'j2' has the symbol '2\*q'; a symbol reads like theta_1"),
        ("d_1: j1.z", "d_1: j9.z", 4, "'d_1' is bound to j9.z; the joints of the model are j1, j2, t"),
        ("d_1: j1.z", "d_1: j1.w", 4, r"'d_1' is bound to 'j1\.w'; a place reads joint\.x, joint\.y or joint\.z, or -joint\.z"),
        ("d_1: j1.z", "d_1: 0.5", 4, r"'d_1' is bound to '0\.5'; a place reads joint\.x"),
        ("d_1: j1.z", "d_1: []", 4, r"'d_1' is bound to no place"),
        ("d_1: j1.z", "d_1: j1.x", 4, r"'d_1' is bound to j1\.x, which is 0 in small\.urdf"),
        ("h: -j2.z", "h: j2.x", 6, r"'h' and 'a' are both bound to j2\.x; a place has one symbol"),
        ("a: [j2.x, t.x]", "a: [j2.x, j2.z]", 5, r"'a' is 0\.4 at its first place and -0\.1 at j2\.z"),
        ("E: tool}", "E: hand}", 7, r"frame E is put at 'hand'; a place is a link \(.*base, l1, l2, tool\) or <joint>\.parent"),
        ("E: tool}", "E: j7.parent}", 7, r"frame E is put at 'j7\.parent'; a place is a link"),
        ("{0: base, 1: j2.parent, 2: l2, E: tool}", "{}", 7, "'frames' is empty"),
        ("title: A small arm", "title: 'A", 8, "not readable as YAML: found unexpected end of stream"),
        ("title: A small arm\n", "- 1\n---\n", 2, "not readable as YAML: but found another document"),
    ],
)  # fmt: skip
def test_a_slip_in_a_card_is_told_with_its_line(folder: Path, old: str, new: str, line: int, message: str) -> None:
    with pytest.raises(ModelError, match=rf"arm\.yaml:{line}: {message}"):
        load_with(folder, (old, new))


def test_an_empty_card_and_a_list_are_refused(folder: Path) -> None:
    (folder / "arm.yaml").write_text("")
    with pytest.raises(ModelError, match=r"arm\.yaml:1: the card is empty; its keys are title, "):
        load_arm(folder)
    (folder / "arm.yaml").write_text("- 1\n")
    with pytest.raises(ModelError, match=r"arm\.yaml:1: the card must be a mapping, not a list"):
        load_arm(folder)


def test_one_symbol_for_two_things_is_refused(folder: Path) -> None:
    with pytest.raises(ModelError, match=r"arm\.yaml: arm 'small': the symbol 'a' stands for two things"):
        load_with(folder, ("j2: theta_2}", "j2: a}"))


def test_a_card_without_its_model_is_refused(folder: Path) -> None:
    with pytest.raises(ModelError, match=r"big\.urdf: no such model file"):
        load_with(folder, ("title:", "model: big.urdf\ntitle:"))
    with pytest.raises(ModelError, match=r"small\.txt: a model file ends in \.urdf, \.sdf, \.dmd\.yaml"):
        load_with(folder, ("title:", "model: small.txt\ntitle:"))


def test_the_model_need_not_be_named_after_the_folder(folder: Path) -> None:
    (folder / "small.urdf").rename(folder / "other.urdf")
    arm = load_with(folder, ("title:", "model: other.urdf\ntitle:"))
    assert arm.path is not None and arm.path.name == "other.urdf"
