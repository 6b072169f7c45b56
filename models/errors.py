"""The errors of Armproof: one base class, so that a caller can catch them all; and what those of the models can say.

An error is raised with the kind of its message and the terms that the message names: both are data, and the sentence is
written when it is asked for, so that it can be translated.
"""

from __future__ import annotations

from collections.abc import Iterable
from enum import StrEnum, unique
from functools import reduce
from string import Formatter
from typing import Any

from armproof.models.language import (
    ENGLISH,
    known_language,
    languages,
    look_up,
    look_up_plural,
    number_text,
    separator,
    spoken,
    use,
)


class MessageKind(StrEnum):
    """A kind of message: its name, a part of the contract, and its sentence, an English template."""

    template: str
    student: str | None

    def __new__(cls, name: str, template: str, student: str | None = None) -> MessageKind:
        """Return the member of a name, with its sentences."""
        kind = str.__new__(cls, name)
        kind._value_, kind.template, kind.student = name, template, student
        return kind


class ArmproofError(Exception):
    """Base of every error that Armproof raises for a user's input.

    Attributes:
        kind: the kind of the message, where it has one; else the error is raised with a template.
        terms: what the message names: texts, numbers, lists of such, or an error within this one.
    """

    kind: MessageKind | None = None

    def __init__(self, message: object, /, **terms: object) -> None:
        super().__init__(message)
        self.terms: dict[str, Any] = {name: _plain(term) for name, term in terms.items()}
        if isinstance(message, MessageKind):
            self.kind = message

    def __str__(self) -> str:
        said = self.args[0].template if isinstance(self.args[0], MessageKind) else self.args[0]
        return written(said, **self.terms) if isinstance(said, str) else str(said)


class LanguageError(ArmproofError):
    """There is no catalogue of a language."""


def existing_language(name: str) -> str:
    """Return the language of a name, "fr" of "fr-FR"; that which is spoken where none is named.

    Raises:
        LanguageError: a language that has no catalogue.
    """
    if not (known := known_language(name.strip()) if name else spoken()):
        raise LanguageError("no language '{lang}'; the languages are {languages}", lang=name, languages=list(languages()))  # fmt: skip
    return known


class _Writer(Formatter):
    def format_field(self, value: Any, format_spec: str) -> str:
        """Return a term in words: the items of a list one after the other."""
        if isinstance(value, list):
            texts = [number_text(item) for item in value]
            return separator(texts).join(texts)
        return value.said() if isinstance(value, Sentence) else number_text(value, format_spec)


_WRITER = _Writer()


def written(template: str, /, **terms: Any) -> str:
    """Return a sentence of the look-up with its terms; one without terms is no template, but stands as it is."""
    return _WRITER.vformat(look_up(template), (), terms) if terms else look_up(template)


class Sentence(str):
    """English text that keeps its template and terms: data, as any text, and said in the language spoken where it is written."""

    template: str
    terms: dict[str, Any]

    def __new__(cls, template: str, /, **terms: Any) -> Sentence:
        """Return the text of a template in English."""
        with use(ENGLISH):
            made = super().__new__(cls, _WRITER.vformat(template, (), terms) if terms else template)
        made.template, made.terms = template, terms
        return made

    def __getnewargs_ex__(self) -> tuple[tuple[str], dict[str, Any]]:
        return (self.template,), self.terms

    def said(self) -> str:
        """Return it in the language that is spoken."""
        return written(self.template, **self.terms)


def together(sentences: Iterable[str]) -> str:
    """Return sentences as one, with semicolons between; "" of none."""
    several = list(sentences)
    return reduce(lambda one, other: Sentence("{one}; {other}", one=one, other=other), several) if several else ""


def counted(one: str, many: str, number: int, /, **terms: Any) -> str:
    """Return the sentence for a number of things, which both templates may name as {number}."""
    return _WRITER.vformat(look_up_plural(one, many, number), (), {"number": number, **terms})


def _plain(term: object) -> object:
    return term if isinstance(term, str | int | float | list | ArmproofError) else str(term)


@unique
class Fault(MessageKind):
    """What an error of the models says."""

    # fmt: off
    # -- arms ----------------------------------------------------------------------------------------------------------
    NO_JOINT_VARIABLE = "no_joint_variable", "no joint variable '{symbol}' on arm '{arm}'; its joint variables are {symbols}"
    SYMBOL_TWICE = "symbol_twice", "arm '{arm}': the symbol '{symbol}' stands for two things; each needs its own"
    NO_FRAME = "no_frame", "no frame '{frame}' on arm '{arm}'; its frames are {frames}"
    NO_LENGTH_OR_ANGLE = "no_length_or_angle", "no length or angle '{name}' on arm '{arm}'; it has {known}"
    VALUE_NOT_FINITE = "value_not_finite", "'{name}' of arm '{arm}' is a finite number, not {value}"
    NOT_DIFFERENT_NUMBERS = "not_different_numbers", "{what} are different whole numbers from 1 to {most}, not {given}"
    NO_ARM = "no_arm", "no arm '{arm}'; an arm is one of {arms}, a path to a {suffixes} or a DH table"
    NOT_AN_ARM = "not_an_arm", "an arm is a name, a path or a DH table, not {given}; the arms are {arms}"
    ARM_TOO_LONG = "arm_too_long", "an arm is a name, a path or a DH table, not a text of {count} characters"
    LOCKED_NO_URDF = "locked_no_urdf", "'tip' and 'lock' are for an arm that is a .urdf file, not {path}"
    LOCK_FORM = "lock_form", "'lock' is a list of joints, or a mapping of joints to values in rad or m, not {given}"
    TIP_FORM = "tip_form", "'tip' is the name of a link, not {given}"
    NO_JOINT_TO_LOCK = "no_joint_to_lock", "{source}: no joint '{joint}' to lock; its joints are {joints}"
    NO_TIP = "no_tip", "{source}: no link '{link}' for a tip; its links are {links}"
    NO_MODEL_FILE = "no_model_file", "{path}: no such model file"
    TABLE_OF_OBJECTS = "table_of_objects", "a DH table holds numbers and texts only: {reason}"
    TRACE_NOT_EXACT = "trace_not_exact", "arm '{arm}': {value} in the symbolic trace is not exact"
    COORDINATE_NOT_FINITE = "coordinate_not_finite", "a coordinate is {value}; coordinates are finite numbers of metres"
    ROOT_OF_LARGE_NUMBER = "root_of_large_number", "the square root of a number of {digits} digits"
    TOO_MANY_ANGLES = "too_many_angles", "arm '{arm}': too many symbolic angles between frames {frames} to multiply out; choose frames nearer to each other, or make constant angles multiples of pi/2"
    NOT_A_VALUE = "not_a_value", "not an arm that write_value wrote: {type}: {reason}"

    # -- DH tables -----------------------------------------------------------------------------------------------------
    ENTRY_NOT_FINITE = "entry_not_finite", "{value} is not a finite number or a text; an entry reads {forms}"
    ENTRY_UNREADABLE = "entry_unreadable", "'{text}' is unreadable: {reason}; an entry reads {forms}"
    NO_CONVENTION = "no_convention", "DH table: dh is classic or modified, not {given}"
    NO_FIRST_FRAME = "no_first_frame", "DH table: first is the number of the base's frame, 0 or more, not {given}"
    POSE_KEYS = "pose_keys", "DH table: {key} is a pose with {keys}, three entries each, not {given}"
    POSE_ENTRY = "pose_entry", "DH table: {key}: {entry} does not fit: xyz holds lengths, rpy angles that take each symbol a whole number of times"
    FRAME_NAMES = "frame_names", "DH table: frames is a list of {count} different names of letters and digits, base to tool, not {given}"
    NO_ROWS = "no_rows", "DH table: rows is a list of rows, base to tool, not {given}"
    ROWS_AND_JOINTS = "rows_and_joints", "DH table: {rows} rows but {count} joints ({joints}); each stands in a row, in this order, and a row without one has none in theta"
    LENGTH_AND_ANGLE = "length_and_angle", "DH table: '{symbol}' stands in a length and in an angle; a symbol is one or the other"
    ROW_KEYS = "row_keys", "DH table, row {number}: a row has the keys {keys}, not {given}"
    MORE_THAN_A_TURN = "more_than_a_turn", "DH table, row {number}, {column}: '{text}' is more than a turn in radians; write {degrees}deg or a multiple of pi"
    NEARLY = "nearly", "DH table, row {number}, {column}: '{text}' is nearly {multiple}, which no equation can match; write {multiple}"
    JOINT_UNCLEAR = "joint_unclear", "DH table, row {number}: the joint variable could be {joints}; list them: joints: [theta_1, ...]"
    JOINT_FACTOR = "joint_factor", "DH table, row {number}: '{joint}' has the factor {factor}; a joint variable enters as {joint} or -{joint}"
    JOINT_TAKEN = "joint_taken", "DH table, row {number}: '{joint}' is the joint variable of row {other} already"
    JOINT_ELSEWHERE = "joint_elsewhere", "DH table, row {number}: its joint variable '{joint}' stands in {columns}; it stands in theta or in d"
    UNKNOWN_TABLE_KEY = "unknown_table_key", "DH table: unknown key '{key}'; the keys are {keys}"
    NO_JOINTS = "no_joints", "DH table: 'joints' is a list of joint variables, not {given}"
    ANGLE_AS_LENGTH = "angle_as_length", "DH table, row {number}, {column}: '{text}' is an angle; {column} is a length and reads 0, 0.75, 3/4, l_1, d_1 + d_4"
    JOINT_OF_ANOTHER_ROW = "joint_of_another_row", "DH table, row {number}: {column} holds '{symbol}', the joint variable of row {other}; a joint variable stands in one row"
    IN_TABLE = "in_table", "DH table, row {number}, {column}: {reason}"
    ANGLE_FACTOR = "angle_factor", "DH table, row {number}, {column}: '{symbol}' has the factor {factor}; an angle takes each symbol a whole number of times, at most {most}; an entry reads {forms}"
    NO_CHARACTER = "no_character", "'{found}' is not understood"
    ENTRY_EMPTY = "entry_empty", "it is empty"
    UNEXPECTED_HERE = "unexpected_here", "'{found}' is not expected here"
    NO_DIVISOR = "no_divisor", "only a number other than 0 divides"
    PRODUCT = "product", "a product of two symbols is not linear"
    TOO_DEEP = "too_deep", "it is nested too deeply"
    NOT_CLOSED = "not_closed", "a ')' is missing"
    TERM_EXPECTED = "term_expected", "a number or a symbol is expected, not '{found}'"
    BREAKS_OFF = "breaks_off", "it ends too early"
    NO_DEGREES = "no_degrees", "degrees follow a number"
    OUT_OF_RANGE = "out_of_range", "a number is too large or too small"
    JOINT_NOWHERE = "joint_nowhere", "DH table, row {number}: the joint variable is neither in theta (theta_i, q_i) nor in d; list them: joints: [theta_1, ...]"
    JOINT_NOT_IN_ROW = "joint_not_in_row", "DH table, row {number}: its joint variable '{joint}' stands nowhere; it stands in theta or in d"

    # -- cards and model files -----------------------------------------------------------------------------------------
    CARD_EMPTY = "card_empty", "{path}:1: the card is empty; its keys are {keys}"
    CARD_NOT_YAML = "card_not_yaml", "{path}{line}: not readable as YAML: {reason}"
    CARD_UNREADABLE = "card_unreadable", "{path}: not readable: {reason}"
    COUPLED_JOINTS = "coupled_joints", "{source}: joints coupled by <mimic> or constraints are not supported; each joint moves freely: `lock` those of a gripper, or name the `tip`"
    SEVERAL_BASES = "several_bases", "{source}: an arm has one base; bodies without a joint to a parent: {names}"
    NO_MOVING_JOINT = "no_moving_joint", "{source}: no moving joint; an arm has at least one revolute or prismatic joint"
    IN_MODEL = "in_model", "{source}: {reason}"
    JOINT_TYPE = "joint_type", "{source}: joint '{joint}' is {type}; an arm has revolute, continuous, prismatic and fixed joints"
    CLOSED_LOOP = "closed_loop", "{source}: joints '{joint}' and '{other}' both carry '{body}'; an arm is a serial chain without closed loops"
    BRANCHES = "branches", "{source}: more than one moving branch: {trunk} and, off it, {branch}; an arm is one serial chain (make a gripper's joints fixed: `lock` them, or name the `tip`)"
    LOOP = "loop", "{source}: joint '{joint}' closes a loop; an arm is a serial chain"
    MODEL_SUFFIX = "model_suffix", "{path}: a model file ends in {suffixes}"
    LIMITS_REVERSED = "limits_reversed", "{path}:{line}: the lower limit of a joint is above its upper limit"
    MACRO = "macro", "{path}:{line}: <{tag}> is a macro; expand the file with xacro first"
    NOT_XML = "not_xml", "{path}:{line}: not well-formed XML: {reason}"
    IN_CARD = "in_card", "{path}:{line}: {reason}"
    UNKNOWN_CARD_KEY = "unknown_card_key", "unknown key '{key}'; the keys are {keys}"
    CARD_KEY_MISSING = "card_key_missing", "'{key}' is missing; a card needs {keys}"
    NO_FRAMES = "no_frames", "'frames' is empty; it names the base frame, usually 0, first"
    NO_MAPPING_IN_CARD = "no_mapping_in_card", "{what} must be a mapping, not {found}"
    KEY_NO_NAME = "key_no_name", "a key of {what} must be a name, not {found}"
    CARD_KEY_TWICE = "card_key_twice", "'{key}' stands twice in {what}"
    NO_TEXT = "no_text", "'{key}' must be a text, not {found}"
    NO_SYMBOL = "no_symbol", "{what} has the symbol '{symbol}'; a symbol reads like theta_1, d_3, a_2 or l"
    NO_PLACES = "no_places", "'{symbol}' is bound to no place; write joint.x, joint.y or joint.z"
    NO_PLACE = "no_place", "'{symbol}' is bound to '{text}'; a place reads joint.x, joint.y or joint.z, or -joint.z"
    JOINTS_OF_CARD = "joints_of_card", "joints are {joints}; the model has, base to tool, {names}"
    BOUND_TO_NO_JOINT = "bound_to_no_joint", "'{symbol}' is bound to {place}; the joints of the model are {joints}"
    BOUND_TWICE = "bound_twice", "'{symbol}' and '{other}' are both bound to {place}; a place has one symbol"
    BOUND_TO_ZERO = "bound_to_zero", "'{symbol}' is bound to {place}, which is 0 in {model}"
    BOUND_DIFFERENTLY = "bound_differently", "'{symbol}' is {first} at its first place and {value} at {place}"
    FRAME_NOWHERE = "frame_nowhere", "frame {frame} is put at '{place}'; a place is a link ({links}) or <joint>.parent ({joints})"
    IN_MODEL_LINE = "in_model_line", "{path}:{line}: {reason}"
    DRAKE = "drake", "{reason}"

    # -- joint values and pictures -------------------------------------------------------------------------------------
    NO_PLANT = "no_plant", "arm '{arm}' was read from a value and has no plant; load it from its model"
    CONFIGURATION_SHAPE = "configuration_shape", "a configuration of arm '{arm}' has the shape ({n},), not {shape}; the {n} joint values are {joints}"
    MASKED_VALUES = "masked_values", "joint values of arm '{arm}' are real numbers; {count} of those given are masked"
    NOT_REAL = "not_real", "joint values of arm '{arm}' are real numbers (rad, m), not {what} ({dtype})"
    NOT_FINITE_VALUE = "not_finite_value", "joint values are finite numbers; q[{place}], {joint} of arm '{arm}', is {value}"
    UNEQUAL_LENGTHS = "unequal_lengths", "configurations of arm '{arm}' have equal lengths: {n} joint values, {joints}"
    PICTURE_SIZE = "picture_size", "a picture is from 1 to {most} pixels wide and high, not {width} × {height}"
    JOINT_COUNT = "joint_count", "a configuration of arm '{arm}' has {n} values, not {shape}"
    NO_SHAPE = "no_shape", "arm '{arm}' was given by a DH table and has no shape; name an arm that has a model file"
    CONFIGURATIONS_SHAPE = "configurations_shape", "configurations of arm '{arm}' have the shape (N, {n}), not {shape}; the {n} joint values are {joints}"
    ONE_CONFIGURATION_AS_LIST = "one_configuration_as_list", "configurations of arm '{arm}' have the shape (N, {n}), not {shape}; the {n} joint values are {joints}; write one configuration as [q]"
    NO_RENDERER = "no_renderer", "3D pictures need Mesa's EGL library and a driver for it ({problem}); on Debian and Ubuntu: apt install libegl1 libgl1-mesa-dri. Everything else works without them"
    NO_MESHCAT = "no_meshcat", "arm '{arm}' cannot be shown in Meshcat: {reason}. The picture beside the sliders needs no server"
    NO_DRIVER = "no_driver", "EGL finds no driver"

    # -- motion --------------------------------------------------------------------------------------------------------
    SINGULAR_MASS = "singular_mass", "arm '{arm}' cannot be simulated: its mass matrix is singular (least eigenvalue {smallest:.1e}); give the last links of the model file an <inertial>"
    SOLVER_ENDS_AWAY = "solver_ends_away", "{steps} steps end {distance:.2g} (m, rad) from the pose"
    TASK_ROWS = "task_rows", "the rows of a task are some of 1 … 6, each once: 1–3 for v, 4–6 for ω; not {given}"
    VECTOR_SHAPE = "vector_shape", "{name}: a vector of the shape {expected} is needed, not {shape}"
    VECTOR_NOT_FINITE = "vector_not_finite", "{name}: every number is finite; number {number} is not"
    ONE_CONFIGURATION = "one_configuration", "a motion goes through at least 2 configurations; {count} given"
    DURATION = "duration", "{name}: a motion takes a positive time between {shortest:g} and {longest:g} s, not {duration:g}"
    NOT_A_VECTOR = "not_a_vector", "{name}: {value} is no vector of numbers"
    DAMPING_SHAPE = "damping_shape", "a damping factor is one number, or one a Jacobian; the shape {shape} is neither"
    DAMPING = "damping", "a damping factor is positive and finite, not {damping}; for none, take pseudo_inverse"
    TWIST_SHAPE = "twist_shape", "for Jacobians of shape {jacobians} twists have the shape {expected}, not {shape}"
    TWIST_NOT_FINITE = "twist_not_finite", "a twist has finite numbers only; one is NaN or infinite"
    JACOBIAN_SHAPE = "jacobian_shape", "a Jacobian has the shape (m, n), a batch of them (N, m, n), not {shape}"
    JACOBIAN_NOT_FINITE = "jacobian_not_finite", "a Jacobian has finite numbers only; one is NaN or infinite"
    JACOBIAN_NO_NUMBERS = "jacobian_no_numbers", "a Jacobian is an array of numbers: {reason}"
    SAME_POINTS = "same_points", "points {first} and {second} of the path are the same configuration; a path moves on"
    SAME_ENDS = "same_ends", "q_0 and q_f are the same configuration; to stay there, give a duration"
    NO_LIMITS = "no_limits", "{name}: {value} is no vector of limits"
    BEYOND_LIMITS = "beyond_limits", "{joint} of arm '{arm}' goes to {reached:.4g} {unit} in this motion; its limits are [{lower:g}, {upper:g}]"
    POSE_SHAPE = "pose_shape", "{name}: a pose is a (4, 4) array of finite numbers; the shape is {shape}"
    POSE_FORM = "pose_form", "{name}: a pose has a rotation above left, and the last row 0 0 0 1"
    NO_ARRAY = "no_array", "{name}: {value} is no array of numbers"
    OUT_OF_PRECISION = "out_of_precision", "the numbers of this motion are too large, or too far apart, for double precision"
    NO_JOINT_LIMIT = "no_joint_limit", "a joint that moves has neither a velocity nor an acceleration limit: any duration will do"
    NO_TRAJECTORY = "no_trajectory", "a motion is a trajectory of pydrake.trajectories, not a {type}"
    TRAJECTORY_SHAPE = "trajectory_shape", "a motion has values of the shape ({size}, 1), not {shape}"
    TRAJECTORY_ENDS = "trajectory_ends", "a motion has a start and a later end, not [{start:g}, {end:g}]"
    NO_DERIVATIVE = "no_derivative", "the trajectory has no velocity or acceleration: {reason}"
    TRAJECTORY_EMPTY = "trajectory_empty", "the trajectory is empty: {reason}"
    LINE_SAMPLES = "line_samples", "samples: from 4 to 100000 poses on the line, not {samples}"
    LINE_OF_NO_LENGTH = "line_of_no_length", "the straight line ends where it starts; the tool has nowhere to go"
    SOLVER_SHAPE = "solver_shape", "the solver returns joint values of the shape {shape}, not {expected}"
    LIMIT_PASSED = "limit_passed", "the motion along this path passes the {worst} limit of arm '{arm}' by a factor of {factor:.3g}; take more than {points} grid points, or a smoother path"
    PATH_INTERVAL = "path_interval", "a path has s between {least:g} and {most:g}, over at least {shortest:g}"
    PATH_POINTS = "path_points", "grid_points: from 10 to 100000 points on the path, not {points}"
    NO_RATE_LIMIT = "no_rate_limit", "{joint} of arm '{arm}' has neither an acceleration nor an effort limit in its model file; give acceleration= or effort="
    PATH_NOT_FINITE = "path_not_finite", "the path has values that are not finite"
    PATH_STANDS = "path_stands", "the path stands still at s = {at:.4g}; a path has dq/ds other than 0 (see joint_path)"
    NO_MOTION = "no_motion", "no motion of arm '{arm}' along this path respects the limits"
    BEYOND_LIMITS_AT = "beyond_limits_at", "{joint} of arm '{arm}' is {value:.4g} at s = {at:.4g}; its limits are [{lower:g}, {upper:g}]"
    TOO_MANY_PERIODS = "too_many_periods", "a motion of {seconds:g} s has {steps} periods of {period:g} s; at most {most} are simulated"
    TRAJECTORY_NOT_FINITE = "trajectory_not_finite", "the trajectory has values that are not finite"
    NEGATIVE_GAINS = "negative_gains", "{name}: gains are not negative; the least is {least:g}"
    SIMULATION_ENDED = "simulation_ended", "the simulation of arm '{arm}' ended at {at:.3g} s: {reason}"
    SINGULAR_JACOBIAN = "singular_jacobian", "a {form} needs full {of} rank {rank}; the Jacobian has rank {least}: the arm is singular there; take damped_inverse"
    SINGULAR_IN_BATCH = "singular_in_batch", "a {form} needs full {of} rank {rank}; the Jacobian number {number} of the batch has rank {least}: the arm is singular there; take damped_inverse"
    LIMIT_SHAPE = "limit_shape", "{name}: one positive limit, or one for each of the {size} joints, from {least:g} to {greatest:g}, is needed; not {value}"
    LIMIT_SHAPE_OF_MODEL = "limit_shape_of_model", "{name}: one positive limit, or one for each of the {size} joints, from {least:g} to {greatest:g}, is needed; the model file has {value}"
    ON_LINE = "on_line", "at s = {s:.4g}, p = ({x:.4g}, {y:.4g}, {z:.4g}) m"
    LINE_BEYOND_LIMITS = "line_beyond_limits", "{note} on the straight line, first {where}"
    LEAVES_LINE = "leaves_line", "the joint path leaves the straight line by {distance:.2g} m and {angle:.2g} rad {where}, where the least singular value of the Jacobian is {least:.2g}: near a singular configuration the joints would have to jump; or the solver changes branch, or {count} samples are too few"
    NO_SOLUTION_BECAUSE = "no_solution_because", "no joint values {where} on the straight line: {reason}; just before, the least singular value of the Jacobian is {least:.2g}"
    NO_SOLUTION = "no_solution", "no joint values {where} on the straight line: the solver finds none"
    # fmt: on


class ModelError(ArmproofError):
    """An arm cannot be loaded or asked for what it does not have."""
