"""An arm as a value: written as JSON, read without NumPy or Drake, with the same exact trace."""

import json
import subprocess
import sys

import pytest

from armproof.models.arm import Arm
from armproof.models.catalogue import load_arm
from armproof.models.errors import ModelError
from armproof.models.exact.trace import Trace, trace_of
from armproof.models.exact.value import read_value, write_value
from armproof.models.numeric.drake_arm import plant_of

SLANTED = {
    "dh": "classic",
    "rows": [
        {"a": "l_1", "alpha": "alpha_1", "d": "3/4", "theta": "theta_1 - pi/2"},
        {"a": 0, "alpha": "30deg", "d": "-d_2 - 2 l_1", "theta": "beta"},
        {"a": 0.1, "alpha": 0.3, "d": 0, "theta": "-theta_3"},
    ],
    "joints": ["theta_1", "d_2", "theta_3"],
}
ALONE = """
import sys
sys.modules.update(numpy=None, pydrake=None)
from armproof.models.exact.trace import trace_of
from armproof.models.exact.value import read_value, write_value
arm = read_value(sys.stdin.read())
trace_of(arm).jacobian("6", "3", "1")
assert trace_of(arm).pose("6") and arm.joint("theta_4").kind == "revolute"
print(write_value(arm))
"""


def assert_same_trace(trace: Trace, other: Trace, frames: tuple[str, ...]) -> None:
    first, middle, last = frames[0], frames[len(frames) // 2], frames[-1]
    for frame in frames:
        assert trace.depth(frame) == other.depth(frame)
        assert trace.pose(frame) == other.pose(frame)
    assert trace.pose(first, middle) == other.pose(first, middle)
    for asked in ((last, first, first), (last, middle, first), (middle, last, last), (first, first, middle)):
        assert trace.jacobian(*asked) == other.jacobian(*asked)
    assert trace.constants == other.constants


def assert_same(arm: Arm, other: Arm) -> None:
    for key in ("name", "title", "source", "zero", "joints", "lengths", "angles", "frames", "dh", "digest", "warnings"):
        assert getattr(arm, key) == getattr(other, key)
    assert_same_trace(trace_of(arm), trace_of(other), arm.frames)


def test_what_is_read_is_the_arm_that_was_written(arm: Arm) -> None:
    assert_same(read_value(write_value(arm)), arm)


def test_an_arm_of_a_table_keeps_its_table_and_its_symbolic_angles() -> None:
    arm = load_arm(SLANTED)
    read = read_value(write_value(arm))
    assert_same(read, arm)
    assert read.dh is not None and set(trace_of(read).constants) == {"alpha_1", "beta", "0.3"}


def test_another_arm_is_another_value() -> None:
    scara = trace_of(read_value(write_value(load_arm("scara"))))
    assert scara.pose("4") != trace_of(load_arm("scara_modified")).pose("4")
    moved = write_value(load_arm("scara")).replace('"a_1",1', '"a_2",1')
    assert trace_of(read_value(moved)).pose("4") != scara.pose("4")


def test_a_value_is_read_and_traced_without_numpy_and_drake() -> None:
    text = write_value(load_arm("rx90"))
    done = subprocess.run([sys.executable, "-c", ALONE], input=text, capture_output=True, text=True, check=False)
    assert done.returncode == 0, done.stderr
    assert done.stdout == f"{text}\n"


def test_what_needs_the_plant_says_so() -> None:
    with pytest.raises(
        ModelError, match=r"^arm 'scara' was read from a value and has no plant; load it from its model$"
    ):
        plant_of(read_value(write_value(load_arm("scara"))))


def test_too_many_symbolic_angles_are_refused_as_on_the_plant() -> None:
    rows = [{"a": f"a_{i}", "alpha": f"alpha_{i}", "d": 0, "theta": f"theta_{i}"} for i in range(1, 9)]
    trace = trace_of(read_value(write_value(load_arm({"dh": "classic", "rows": rows}))))
    with pytest.raises(ModelError, match="too many symbolic angles between frames 8, 0 to multiply out"):
        trace.pose("8")
    assert trace.pose("8", "6")


@pytest.mark.parametrize(
    "text",
    ["", "{}", "[]", '{"armproof arm": 2}', '{"armproof arm": 1}', "[" * 100_000, '{"armproof arm": 1, "joints": 3}'],
)
def test_what_is_no_value_is_refused(text: str) -> None:
    with pytest.raises(ModelError, match="not an arm that write_value wrote"):
        read_value(text)


def test_a_coefficient_is_a_whole_number_or_a_quotient() -> None:
    value = json.loads(write_value(load_arm("planar_2r")))
    value["links"][0][4][0][0] = [["1e999999999", []]]
    with pytest.raises(ModelError, match="not an arm that write_value wrote"):
        read_value(json.dumps(value))
