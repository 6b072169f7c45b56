"""What a finding can say: each kind by its name in the JSON report, and its sentence, an English template.

A template is the message id of a translation. Its fields are the finding's terms, and {row} and {column}; what stands in
`backticks` is a name or formula as the models spell it (theta_1), what stands in $dollars$ is LaTeX. A student is told the
same as a report tells, or the second template; an empty one tells nothing: it would give the right term away, or concerns our
proof and not the answer.
"""

from __future__ import annotations

from enum import StrEnum, unique

# Terms that are words of the language, not names: they are translated as the templates are.
WORDS = frozenset(
    "classic modified left right linear angular revolute prismatic fixed low high proved confirmed degrees radians millimetres kilometres".split()
)


@unique
class Kind(StrEnum):
    """The kind of a finding."""

    template: str
    student: str | None

    def __new__(cls, name: str, template: str, student: str | None = None) -> Kind:
        """Return the member of a name, with its sentences."""
        kind = str.__new__(cls, name)
        kind._value_, kind.template, kind.student = name, template, student
        return kind

    # -- what became of a display ---------------------------------------------------------------------------------------
    PROBLEM = "problem", "{reason}"
    INTERNAL_ERROR = "internal_error", "internal error, please report it: {type}: {reason}"
    NEVER_ENDS = "never_ends", "the display opened by {opening} never ends"
    UNREADABLE = "unreadable", "line {line}, column {at} of the display: {problem}"
    UNREADABLE_IN_CELL = "unreadable_in_cell", "cell {cell}, line {line}, column {at} of the display: {problem}"
    TOO_LARGE = "too_large", "too large to decide: {problem}"
    NESTED_TOO_DEEPLY = "nested_too_deeply", "too large to decide: nested too deeply"
    TOO_LARGE_TO_TELL = "too_large_to_tell", "the two sides differ; what is wrong is too large to tell", ""
    NO_EQUATION = "no_equation", "states no equation"
    CONDITION = "condition", "a condition, not a claim"
    CONFIGURATION = "configuration", "a configuration, not a claim"
    PATTERN = "pattern", "an ellipsis stands for terms: a pattern, not a claim"
    SIGN = "sign", "`{name}` is a sign, either one"
    SLASH_OVER_ALL = "slash_over_all", "'{text}' read with all that follows the slash taken as the denominator"
    SLASH_OVER_NEXT = "slash_over_next", "'{text}' read with the slash dividing by the next factor alone"
    SLASH_UNCLEAR = "slash_unclear", "neither reading of '{text}' holds"

    # -- names and values -----------------------------------------------------------------------------------------------
    NOT_BOUND = "not_bound", "'{name}' is not bound"
    NOT_BOUND_BECAUSE = "not_bound_because", "'{name}' is not bound: {reason}"
    NOT_EVALUATED = "not_evaluated", "{reason}"
    NO_VALUE = "no_value", "{reason}"
    SIZES_DO_NOT_FIT = "sizes_do_not_fit", "{reason}"
    MORE_THAN_IS_COMPUTED = "more_than_is_computed", "{reason}"
    OUTSIDE_THE_ALGEBRA = "outside_the_algebra", "{reason}"
    UNDECIDED = "undecided", "{reason}"
    NOT_READ = "not_read", "{reason}"
    DOCUMENT_AT_FAULT = "document_at_fault", "{reason}"
    DEFINES = "defines", "gives `{name}` its meaning"
    DEFINES_ENTRIES = "defines_entries", "gives `{names}` their meaning"
    DEFINES_WITHOUT_VALUE = "defines_without_value", "gives `{name}` its meaning in terms of names without a value"
    NEVER_USED = (
        "never_used",
        "no claim that is decided uses {names}: bind it in the front matter (quantities) to have it checked",
    )
    BEYOND = "beyond", "nothing of the arm's or the document's kinematics is in it"
    LEFT_OUT = "left_out", "an expression stands beside the equation and in none: what it says is not decided"
    NUMBER_HERE = "number_here", "`{name}` is a number here, not the arm's vector"
    VECTOR_HERE = "vector_here", "`{name}` is a vector here, a component elsewhere"
    NO_SUCH_LENGTH = "no_such_length", "the arm has no `{name}`; with `{length}` the equation holds"

    # -- formulas that cannot be read -----------------------------------------------------------------------------------
    CANNOT_READ = "cannot_read", "cannot read '{text}'"
    TOO_MANY_TOKENS = "too_many_tokens", "the display is too long: more than {most:,} tokens"
    UNKNOWN_ENVIRONMENT = "unknown_environment", "environment '{name}' is not read; those that are: {known}"
    NESTED_DEEPER = "nested_deeper", "nested more than {most} deep"
    NO_SCRIPT_AT_END = "no_script_at_end", "'{text}' at the end of the display has no script"
    NO_SCRIPT = "no_script", "'{text}' has no script"
    BRACE_OPEN = "brace_open", "'{{' is never closed"
    NO_DELIMITER = "no_delimiter", "\\{name} needs a delimiter such as ( [ | or ."
    UNKNOWN_COMMAND = "unknown_command", "'{command}' is not a command of kinematic LaTeX"
    NO_VALUES_SAID = "no_values_said", "'{text}' does not say at which values"
    PRIME_ON_EXPRESSION = "prime_on_expression", "a prime on an expression"
    SUBSCRIPT_ON_EXPRESSION = "subscript_on_expression", "subscript '{script}' on an expression"
    LARGE_EXPONENT = "large_exponent", "the exponent {exponent} is larger than {most}"
    SEVERAL_EQUATIONS = "several_equations", "several equations stand where one value is expected"
    TWO_RELATIONS = "two_relations", "two relations in a row at '{text}'"
    LINE_CONTINUES_NOTHING = "line_continues_nothing", "a line begins with a sign but continues nothing"
    NO_CELLS = "no_cells", "a matrix without cells"
    EMPTY_CELL = "empty_cell", "a cell of a matrix is empty: write 0 where a zero is meant"
    SEVERAL_IN_CELL = "several_in_cell", "a cell of a matrix holds more than one expression"
    CASE_WITHOUT_VALUE = "case_without_value", "a case without a value"
    DERIVATIVE_OF_NOTHING = "derivative_of_nothing", "a derivative of nothing"
    TOO_LONG = "too_long", "the display is too long: {length:,} characters, at most {most:,}"
    NOT_ONE_EXPRESSION = "not_one_expression", "'{text}' is not one expression"
    NESTED = "nested", "nested too deeply"
    NO_ANGLE = "no_angle", "'{text}' has no angle"
    NO_ARGUMENT = "no_argument", "'{text}' has no argument"
    DERIVATIVE_BY_NOTHING = "derivative_by_nothing", "a derivative with respect to nothing"
    HIGHER_DERIVATIVE = (
        "higher_derivative",
        "a higher derivative is with respect to one variable, such as $\\partial t^2$",
    )
    WRONG_END = "wrong_end", "'\\begin{{{begin}}}' is closed by '\\end{{{end}}}'"
    OPERAND_MISSING = "operand_missing", "an operand is missing"
    LONG_NUMBER = "long_number", "a number of more than 40 digits"
    ARGUMENT_EMPTY = "argument_empty", "an argument is empty"
    NO_SQUARE_ROOT = "no_square_root", "only square roots are read"
    UNEXPECTED = "unexpected", "unexpected '{text}'"
    UNEXPECTED_BUT = "unexpected_but", "unexpected '{text}'; expected {expected}"
    ENDS_TOO_EARLY = "ends_too_early", "the display ends too early"
    ENDS_TOO_EARLY_BUT = "ends_too_early_but", "the display ends too early; expected {expected}"

    # -- formulas without a value ---------------------------------------------------------------------------------------
    DIVISION_BY_ZERO = "division_by_zero", "a division by zero"
    COSINE_OF_QUOTIENT = "cosine_of_quotient", "the cosine of a quotient"
    COSINE_OF_NO_ANGLE = "cosine_of_no_angle", "the cosine of something that is not a sum of angles"
    FRACTION_OF_ARC = "fraction_of_arc", "a fraction of an arc function", ""
    TIMES_AN_ANGLE = "times_an_angle", "{times} times an angle"
    IDENTITY_OF_NO_SIZE = "identity_of_no_size", "an identity matrix whose size cannot be told"
    MATRICES_FOR_VALUE = "matrices_for_value", "a list of matrices stands where one value is expected"
    DERIVATIVE_BY_NO_VARIABLE = (
        "derivative_by_no_variable",
        "a derivative with respect to something that is not a variable",
    )
    ROOT_OF_NEGATIVE = "root_of_negative", "the square root of a negative number", ""
    ATAN2_OF_ZEROS = "atan2_of_zeros", "atan2(0, 0) has no value"
    SUM_OF_SIZES = "sum_of_sizes", "a sum of a {one} and a {other} matrix"
    NO_DETERMINANT = "no_determinant", "a {size} matrix has no determinant"
    LARGE_DETERMINANT = "large_determinant", "the determinant of a {size} matrix is more than is computed"
    NO_COFACTORS = "no_cofactors", "a {size} matrix has no inverse and no cofactors"
    LARGE_COFACTORS = "large_cofactors", "the cofactors of a {size} matrix are more than is computed"
    OUT_OF_TIME = "out_of_time", "more time than a display may take"
    TOO_MANY_SYMBOLS = "too_many_symbols", "more than {most} symbols in one document"
    LARGE_PRODUCT = "large_product", "a product of {one:,} by {other:,} terms"
    LARGE_EXPRESSION = "large_expression", "an expression of {terms:,} terms"
    LONE_DIFFERENTIAL = "lone_differential", "a differential stands outside a derivative"
    MATRIX_FOR_SCALAR = "matrix_for_scalar", "a scalar is expected where a matrix stands"
    SIZE_OF_LABEL = "size_of_label", "the matrix is {size}, the label says {label}"
    NO_CONFIGURATION = "no_configuration", "the configuration must give joint variables or lengths values"
    BEYOND_MATRIX = "beyond_matrix", "row {last_row} or column {last_column} of a {size} matrix"
    SUM_WITH_SCALAR = "sum_with_scalar", "a sum of a scalar and a {size} matrix"
    TWO_READINGS = "two_readings", "'{text}' has two readings: write \\frac{{…}}{{…}}, or parentheses"
    BROKEN_EXPONENT = "broken_exponent", "a power whose exponent is not an integer"
    RATE_WITHOUT_ARM = "rate_without_arm", "a time derivative in a document with no arm"
    ABSOLUTE_VALUE = "absolute_value", "an absolute value"
    FUNCTION_OF_SCALAR = "function_of_scalar", "{function} of a scalar"
    THE_FUNCTION = "the_function", "the function {function}"
    WRONG_NUMBER_OF_VALUES = "wrong_number_of_values", "`{name}` is given {given} values; the arm has {joints} joints"
    AXIS_AND_AMOUNT = "axis_and_amount", "{function} takes an axis (x, y or z) and an amount"
    RAGGED_ROWS = "ragged_rows", "the rows of a matrix have {widths} cells"
    RAGGED_BLOCKS = "ragged_blocks", "blocks of {sizes} stand in one row"
    RAGGED_BLOCK_ROWS = "ragged_block_rows", "the rows of a block matrix have {widths} columns"
    SCALAR_FOR_BLOCK = "scalar_for_block", "a scalar stands where a {size} block is expected"
    OPERATOR_ON_SCALAR = "operator_on_scalar", "'{operator}' on a scalar"
    NO_INVERSE_OF_SIZE = "no_inverse_of_size", "a {size} matrix has no inverse"
    SINGULAR = "singular", "the {size} matrix has no inverse: its determinant is 0 for every configuration"
    NO_SUCH_ANGLE = "no_such_angle", "the arm has no joint angle {index}"
    NO_SUCH_FRAME = "no_such_frame", "no frame '{frame}' on arm '{arm}'; its frames are {frames}"
    WORDS_FOR_VALUE = "words_for_value", "words stand for a value"
    TERMS_LEFT_OUT = "terms_left_out", "an ellipsis leaves terms to the reader"
    CASES_IN_WORDS = "cases_in_words", "a value that depends on words"
    ENTRY_OF_SCALAR = "entry_of_scalar", "an entry of a scalar"
    NO_CONDITION = "no_condition", "no equation stands where a condition is expected"
    CONDITION_IS_EQUATION = "condition_is_equation", "a condition is an equation"
    CHAIN_FOR_CONDITION = "chain_for_condition", "a chain stands where one condition is expected"
    RELATION_IS_NONE = "relation_is_none", "'{relation}' is not an equation"
    MATRIX_FOR_CONDITION = "matrix_for_condition", "a matrix stands where a scalar condition is expected"
    RANK_OF_NO_MATRIX = "rank_of_no_matrix", "the rank of something that is no matrix"
    RANK_IS_NO_NUMBER = "rank_is_no_number", "a rank that is not one number"
    MULTIPLE_OF_NO_FRACTION = "multiple_of_no_fraction", "an integer multiple of something that is no fraction of π"
    MULTIPLE_OF_NO_PART = "multiple_of_no_part", "an integer multiple of an angle that is no part of a turn"
    CONDITION_NEVER_MET = "condition_never_met", "a condition that no configuration meets"
    BEYOND_REACH = "beyond_reach", "beyond exact reach: {problem}"
    NOT_SHOWN = "not_shown", "not shown, and no configuration was found that refutes it"
    DEFINED_BY_ITSELF = "defined_by_itself", "'{name}' is defined by itself"
    JOINT_IS_SCALAR = "joint_is_scalar", "a joint is a scalar"
    MATRIX_OF_OTHER_SIZE = "matrix_of_other_size", "the matrix in which '{name}' stands has another size"
    NOT_IN_TARGET = "not_in_target", "it uses a part of the pose of frame {frame} that is not in the target"
    PRODUCT_OF_SIZES = "product_of_sizes", "a product of a {one} and a {other} matrix"
    PRODUCT_OF_POSE = (
        "product_of_pose",
        "a product of a {one} and a {other} matrix; write the vector in homogeneous coordinates",
    )
    NO_VECTOR = "no_vector", "a vector is expected, a {size} matrix is given"
    NO_VECTOR_OF_LENGTH = "no_vector_of_length", "a {length}-vector is expected, a {size} matrix is given"
    TAKES_ONE_ARGUMENT = "takes_one_argument", "{function} takes 1 argument, {given} are given"
    TAKES_TWO_ARGUMENTS = "takes_two_arguments", "{function} takes 2 arguments, {given} are given"

    # -- sizes and readings ---------------------------------------------------------------------------------------------
    WRONG_SIZE = "wrong_size", "the printed matrix is {printed}, it should be {correct}"
    WRONG_SIZE_OF_VALUE = "wrong_size_of_value", "the printed value is {printed}, it should be {correct}"
    NOT_IN_SPACE = "not_in_space", "the matrix is {size}, not {space}"
    IN_SPACE = "in_space", "the size"
    IDENTITY_FOR_SCALAR = "identity_for_scalar", "an identity matrix stands where a scalar is expected"
    LIST_OF_MATRICES = "list_of_matrices", "a list of matrices cannot be compared"
    AS_ROW = "as_row", "the vector is printed as a row"
    HOMOGENEOUS = "homogeneous", "homogeneous coordinates"
    ROTATION_ALONE = "rotation_alone", "the rotation"
    UPPER_ROWS = "upper_rows", "the rows above 0 0 0 1"
    PLANAR_TRANSFORM = "planar_transform", "the planar transform, without its z row and column"
    PLANAR_ROTATION = "planar_rotation", "the planar rotation, without its z row and column"
    PLANAR_VECTOR = "planar_vector", "the plane's two components"
    PLANAR_ROWS = "planar_rows", "the plane's two rows"
    JACOBIAN_ROWS = "jacobian_rows", "rows {rows} of the geometric Jacobian"
    READ_AS_ROWS = "read_as_rows", "J is read as its rows {rows}"
    TABLE_ANGLES = "table_angles", "with the joint angles read as those of the DH table, offsets included"
    LINK_MATRIX = "link_matrix", "the {convention} link matrix"

    # -- samples, relations, conditions ---------------------------------------------------------------------------------
    TO_DECIMALS = "to_decimals", "to the {decimals} decimals printed"
    TO_DECIMALS_ON_A_BRANCH = (
        "to_decimals_on_a_branch",
        "to the {decimals} decimals printed, on one branch of its arc functions",
    )
    TO_DECIMALS_THERE = "to_decimals_there", "to the decimals printed, at the configuration given before"
    WRONG_THERE = "wrong_there", "at the configuration given before", ""
    NUMBERS_OF_NOWHERE = (
        "numbers_of_nowhere",
        "numbers at a configuration, or for lengths, that no display before states",
    )
    NOT_EXACT = "not_exact", "{what} is not exact", ""
    FEW_VALUES = "few_values", "fewer than 10 configurations have a value"
    ON_A_BRANCH = (
        "on_a_branch",
        "on one branch of its square roots and arc functions: at {holding} of {configurations} random configurations; "
        "at the others another sign or half-turn is meant",
    )
    UP_TO_A_SIGN = (
        "up_to_a_sign",
        "holds up to the sign of a square root or the branch of an arc function only",
        "",
    )
    FOR_THESE_LENGTHS = (
        "for_these_lengths",
        "the sign of a square root is right for the lengths of this arm only",
        "",
    )
    ROOTS_POSITIVE = "roots_positive", "the two sides differ, square roots being taken as positive", ""
    PROOFS_DISAGREE = "proofs_disagree", "the proof and the double plant disagree"
    ALWAYS_EQUAL = "always_equal", "the two sides are equal for every configuration", ""
    INEQUALITY_HOLDS = "inequality_holds", "an inequality holds at every sample"
    INEQUALITY_FAILS = "inequality_fails", "the inequality fails at some configurations"
    APPROXIMATION = "approximation", "an approximation, to about a hundredth"
    DOES_NOT_FOLLOW = (
        "does_not_follow",
        "the {holds} side holds and the {fails} does not at the configuration given",
    )

    # -- wrong entries and what mends them ------------------------------------------------------------------------------
    WRONG_ENTRY = "wrong_entry", "is ${printed}$, should be ${correct}$", ""
    WRONG_ENTRIES = "wrong_entries", "{count} entries are wrong"
    WRONG_ENTRIES_AT = "wrong_entries_at", "{count} entries are wrong: {places}"
    WRONG_BLOCK = "wrong_block", "a block differs"
    ONE_WRONG_ENTRY = "one_wrong_entry", "entry ({row}, {column}) is wrong"
    ONLY_WRONG_ENTRY = "only_wrong_entry", "entry ({row}, {column}) is wrong, the others are right"
    FEW_WRONG_ENTRIES = "few_wrong_entries", "the entries {places} are wrong"
    WRONG_VALUE = "wrong_value", "the value is wrong"
    UNEQUAL = "unequal", "the formula is not equal to what is asked"
    IN_EACH = "in_each", "{change}, in each of the wrong entries, {places}"
    ALL_IN_COLUMN = "all_in_column", "all in column {number}"
    ALL_IN_ROW = "all_in_row", "all in row {number}"
    PLACES = "places", "{places}"
    MORE_PLACES = "more_places", "{places}, …"
    PLACE = "place", "({row}, {column})"
    SWAPPED_ENTRIES = "swapped_entries", "entries ({row}, {column}) and ({other_row}, {other_column}) are swapped"
    OF_ANOTHER_ENTRY = "of_another_entry", "what is printed belongs in entry ({other_row}, {other_column})"
    SAME_ERROR = "same_error", "the same error as in line {line}"
    FOLLOWS = "follows", "follows from line {line}"
    WRONG_SIGN = "wrong_sign", "wrong sign"
    WRONG_SIGN_OF_TERM = "wrong_sign_of_term", "wrong sign of term {term}"
    WRONG_SIGN_OF_ANGLE = "wrong_sign_of_angle", "wrong sign of angle {index}"
    SINE_FOR_COSINE = "sine_for_cosine", "sine for cosine"
    COSINE_FOR_SINE = "cosine_for_sine", "cosine for sine"
    EXCHANGED_THROUGHOUT = "exchanged_throughout", "sine and cosine are exchanged throughout"
    PRODUCT_OF_COSINES = (
        "product_of_cosines",
        "a product of cosines where the cosine of the sum of angles belongs",
    )
    PRODUCT_OF_SINES = "product_of_sines", "a product of sines where the sine of the sum of angles belongs"
    WRONG_INDEX = "wrong_index", "index {printed} where {correct} belongs"
    EXTRA_INDEX = "extra_index", "index {index} does not belong"
    MISSING_INDEX = "missing_index", "index {index} is missing"
    WRONG_ANGLE = "wrong_angle", "angle `{printed}` where `{correct}` belongs"
    MISSING_ANGLE = "missing_angle", "angle `{angle}` is missing"
    ABSOLUTE_ANGLE = (
        "absolute_angle",
        "{change}: an angle is taken as absolute where the sum of relative angles belongs",
    )
    WRONG_LENGTH = "wrong_length", "length `{printed}` where `{correct}` belongs"
    SWAPPED_LENGTHS = "swapped_lengths", "lengths `{one}` and `{other}` are swapped"
    THROUGHOUT = "throughout", "{change} throughout"
    EXTRA_FACTOR = "extra_factor", "the {factor:nth} factor does not belong"
    MISSING_FACTOR = "missing_factor", "a factor `{factor}` is missing"
    MISSING_FUNCTION = "missing_function", "a factor {function} {index} is missing"
    MISSING_FUNCTION_OF = "missing_function_of", "a factor {function} of `{angle}` is missing"
    EXTRA_TERM = "extra_term", "the {term:nth} term does not belong"
    MISSING_TERM = "missing_term", "the term ${term}$ is missing"
    WRONG_NUMBER = "wrong_number", "the number {number}"
    WRONG_POWER = "wrong_power", "the power"
    MISSING_SQUARE = "missing_square", "a square is missing"

    # -- a matrix as a whole: what was printed or computed instead ------------------------------------------------------
    ALONE = "alone", "{cause}, in {place} alone"
    TRANSPOSED = "transposed", "the matrix is transposed"
    SIGN_OF_WHOLE = "sign_of_whole", "wrong sign of the whole"
    DOUBLED = "doubled", "the whole is doubled"
    INVERTED = "inverted", "the inverse is printed"
    INVERSE_PRINTED = (
        "inverse_printed",
        "the inverse is printed: the pose of frame {reference} in frame {frame}",
    )
    INVERSE_COMPUTED = (
        "inverse_computed",
        "the inverse is computed: the pose of frame {reference} in frame {frame}",
    )
    OTHER_DIRECTION = (
        "other_direction",
        "if the {index} index of `{name}` names the reference frame, say 'transforms: {index}' in the front matter",
    )
    ROTATION_TRANSPOSED = "rotation_transposed", "the rotation is transposed"
    ROTATION_MISSING = "rotation_missing", "the rotation is missing: an identity stands in its place"
    ORIGIN_MISSING = "origin_missing", "the origin is missing: zeros stand in its place"
    ORIGIN_IN_OTHER_UNIT = "origin_in_other_unit", "the origin is in {unit}: lengths are in metres"
    OTHER_AXIS = "other_axis", "this is the {axis} axis"
    ROW_FOR_COLUMN = "row_for_column", "this is the third row of the rotation, not its column {number}"
    ROWS_SWAPPED = "rows_swapped", "rows {one} and {other} are swapped: {axis} and {other_axis}, or sine and cosine"
    COLUMNS_SWAPPED = "columns_swapped", "columns {one} and {other} are swapped"
    SIGN_OF_ROW = "sign_of_row", "the sign of row {number} is wrong"
    SIGN_OF_COLUMN = "sign_of_column", "the sign of column {number}, the {axis} axis, is wrong"
    POSE_OF_OTHER_FRAME = (
        "pose_of_other_frame",
        "this is the pose of frame {other}, not {frame}",
        "this is that of frame {other}, not {frame}",
    )
    POSE_IN_OTHER_FRAME = (
        "pose_in_other_frame",
        "this is the pose in frame {other}, not {reference}",
        "it is expressed in frame {other}, not {reference}",
    )
    OF_OTHER_FRAME = "of_other_frame", "this is that of frame {other}, not {frame}"
    IN_OTHER_FRAME = "in_other_frame", "it is expressed in frame {other}, not {reference}"
    IN_OTHER_AXES = "in_other_axes", "it is expressed in the axes of frame {other}, not {reference}"
    CONSTANT_OFFSET = (
        "constant_offset",
        "the origin is off by the constant ({values}): an offset of the base is missing or wrong",
    )
    OTHER_BASE = (
        "other_base",
        "the base frame is another: a constant transform before the first joint is missing or wrong",
    )
    OTHER_TOOL = (
        "other_tool",
        "the tool frame is another: a constant transform after the last joint is missing or wrong",
    )
    OTHER_ORDER_OF_ROWS = "other_order_of_rows", "the rows stand in the wrong order: {order}"
    OTHER_ORDER_OF_COLUMNS = "other_order_of_columns", "the columns stand in the wrong order: {order}"

    # -- another shape --------------------------------------------------------------------------------------------------
    IN_ONE_ROW = "in_one_row", "its entries are in one row"
    IS_TRANSPOSED = "is_transposed", "it is transposed"
    AND_TRANSPOSED = "and_transposed", "{cause}, transposed"
    LINEAR_PART_ALONE = "linear_part_alone", "it is the linear part alone, without the rows of ω"
    ANGULAR_PART_ALONE = "angular_part_alone", "it is the angular part alone, without the rows of v"
    PLANE_PART_OF_V = "plane_part_of_v", "it is the plane part of v alone"
    PLANE_PART = "plane_part", "it is the plane part: `v_x`, `v_y`, `ω_z`"
    WHOLE_TWIST = "whole_twist", "it is the whole of [v; ω]"
    ZERO_ROWS_LEFT_OUT = "zero_rows_left_out", "its rows of zeros are left out"
    IS_ROTATION = "is_rotation", "it is the rotation alone"
    IS_ORIGIN = "is_origin", "it is the origin alone"
    IS_HOMOGENEOUS_ORIGIN = "is_homogeneous_origin", "it is the origin alone, in homogeneous coordinates"
    LAST_ROW_MISSING = "last_row_missing", "the last row 0 0 0 1 is missing"
    IS_POSE = "is_pose", "it is the whole pose"
    Z_MISSING = "z_missing", "the z coordinate is missing"
    IS_PLANE_POSE = "is_plane_pose", "it is the pose in the plane"

    # -- a Jacobian -----------------------------------------------------------------------------------------------------
    BLOCKS_SWAPPED = "blocks_swapped", "the blocks are swapped: the rows are [ω; v], [v; ω] is meant"
    SOME_BLOCKS_SWAPPED = (
        "some_blocks_swapped",
        "the blocks are swapped: the rows of ω stand before those of v",
    )
    JACOBIAN_TRANSPOSED = "jacobian_transposed", "the Jacobian is transposed: its rows stand as columns"
    PART_TRANSPOSED = "part_transposed", "the Jacobian is transposed, and is its {part} part alone"
    IN_TOOL_FRAME = "in_tool_frame", "it is expressed in frame {other}, the tool's own, not {reference}"
    TURNED = "turned", "it is turned by the rotation of frame {other} where it should not be"
    LINEAR_PART_OF_OTHER_FRAME = (
        "linear_part_of_other_frame",
        "its linear part is that of the origin of frame {other}, not {frame}",
    )
    JACOBIAN_OF_OTHER_FRAME = "jacobian_of_other_frame", "this is the Jacobian of frame {other}, not {frame}"
    OTHER_POINT = (
        "other_point",
        "its linear part is that of the body's point at the origin of frame {other}, not {frame}: "
        "z × `(p_n - p)` takes the wrong `p_n`",
    )
    COLUMN_THE_OTHER_WAY = (
        "column_the_other_way",
        "column {number}: joint `{joint}` is taken the other way",
        "column {number}: joint `{joint}` is taken the other way, the sign of its column is wrong",
    )
    COLUMN_MISSING = "column_missing", "column {number} is missing: zeros stand in its place"
    COLUMNS_REVERSED = "columns_reversed", "the columns stand in the wrong order, from tool to base"
    COLUMNS_SHIFTED = "columns_shifted", "the columns stand in the wrong order: they are shifted"
    ABSOLUTE_DERIVATIVES = (
        "absolute_derivatives",
        "the chain rule is missing: the columns are derivatives with respect to absolute angles, "
        "`θ_1 + θ_2` depends on both `θ_1` and `θ_2`",
    )
    CHAIN_RULE_IN_COLUMN = (
        "chain_rule_in_column",
        "column {number}: the chain rule is missing, `{joint}` moves the links after joint `{other}` too",
    )
    COLUMNS_SUMMED_TWICE = (
        "columns_summed_twice",
        "the columns are summed up twice: those of relative angles are sums already",
    )
    PER_DEGREE = "per_degree", "it is per degree: the columns of revolute joints are per radian"
    IN_DEGREES = (
        "in_degrees",
        "it is in degrees: the columns of revolute joints are multiplied by 180/π",
    )
    LENGTHS_IN_OTHER_UNIT = "lengths_in_other_unit", "the lengths are in {unit}: they are in metres"
    LINEAR_PART_IN_OTHER_UNIT = "linear_part_in_other_unit", "the linear part is in {unit}: lengths are in metres"
    PART_MISSING = "part_missing", "the {part} part is missing: zeros stand in its place"
    SIGN_OF_PART = "sign_of_part", "the sign of the {part} part is wrong"
    ROWS_OF_PART_SWAPPED = (
        "rows_of_part_swapped",
        "rows {one} and {other}, {axis} and {other_axis} of {part}, are swapped",
    )
    SIGN_OF_CROSS_PRODUCT = (
        "sign_of_cross_product",
        "the sign of the cross product is wrong: it is z × `(p_n - p_i)`, not z × `(p_i - p_n)` or `(p_n - p_i)` × z",
    )
    CROSS_OF_ORIGIN = "cross_of_origin", "z × `p_i` stands where z × `(p_n - p_i)` belongs"
    CROSS_OF_END = (
        "cross_of_end",
        "z × `p_n` stands where z × `(p_n - p_i)` belongs: the origin on the axis is not subtracted",
    )
    NO_CROSS_PRODUCT = (
        "no_cross_product",
        "`p_n - p_i` stands without its cross product with z: v is z × `(p_n - p_i)`",
    )
    PRISMATIC_AS_REVOLUTE = (
        "prismatic_as_revolute",
        "prismatic joints are treated as revolute ones: their columns are [z; 0]",
    )
    PRISMATIC_TURNING = (
        "prismatic_turning",
        "prismatic joints have no angular velocity: zeros belong in place of z",
    )
    REVOLUTE_AS_PRISMATIC = (
        "revolute_as_prismatic",
        "revolute joints are treated as prismatic ones: their columns are [z × `(p_n - p_i)`; z]",
    )
    NEIGHBOURING_AXIS = "neighbouring_axis", "`{other}` stands where `{own}` is the joint's axis{where}"
    NEIGHBOURING_ORIGIN = (
        "neighbouring_origin",
        "`{other}` stands where `{own}` is the origin on the joint's axis{where}",
    )
    OF_THE_NEIGHBOUR = "of_the_neighbour", ", of the neighbouring frame"
    OF_THE_CONVENTION = "of_the_convention", " ({convention} DH)"
    FIRST_AXIS_FOR_ALL = "first_axis_for_all", "`z_0` stands for the axis of every joint"
    Z_FOR_ALL = (
        "z_for_all",
        "z of the frame is taken for the axis of every joint; on this arm some joints have another axis, or its opposite",
    )
    COLUMN_AS_PRISMATIC = (
        "column_as_prismatic",
        "column {number}: the revolute joint `{joint}` is treated as a prismatic one",
    )
    COLUMN_TURNING = (
        "column_turning",
        "column {number}: the prismatic joint `{joint}` has no angular velocity: zeros belong in place of z",
    )
    COLUMN_AS_REVOLUTE = (
        "column_as_revolute",
        "column {number}: the prismatic joint `{joint}` is treated as a revolute one: its column is [z; 0]",
    )

    # -- joint variables ------------------------------------------------------------------------------------------------
    ANGLES_AS_DEGREES = "angles_as_degrees", "the angles are taken as degrees: q is in radians already"
    ANGLES_TO_DEGREES = (
        "angles_to_degrees",
        "the angles are converted to degrees before sine and cosine, which take radians",
    )
    EVERY_JOINT_THE_OTHER_WAY = (
        "every_joint_the_other_way",
        "every joint is taken the other way: the sign of all angles is wrong",
    )
    ANGLES_ABSOLUTE = (
        "angles_absolute",
        "each angle is taken as absolute, from the base; it is relative to the link before: sums of angles are missing",
    )
    ANGLES_SUMMED_TWICE = (
        "angles_summed_twice",
        "the angles are summed up twice: each is relative to the link before already",
    )
    JOINT_THE_OTHER_WAY = (
        "joint_the_other_way",
        "joint `{joint}` is taken the other way",
        "joint `{joint}` is taken the other way: the sign of `{joint}` is wrong",
    )
    SINE_COSINE_OF_JOINT = "sine_cosine_of_joint", "sine and cosine of `{joint}` are exchanged"
    JOINT_AS_DEGREES = "joint_as_degrees", "`{joint}` is taken as degrees: it is in radians already"
    JOINT_MISSING = "joint_missing", "`{joint}` is missing: it stands nowhere in the result"
    OTHER_ZERO = "other_zero", "`{joint}` is counted from another zero: off by {turn}"
    OTHER_ZERO_OR_DERIVATIVE = (
        "other_zero_or_derivative",
        "`{joint}` is counted from another zero: off by {turn}, or the derivatives of its sine and cosine are not taken",
    )
    JOINT_TWICE = "joint_twice", "`{joint}` is counted twice"
    JOINT_ABSOLUTE = (
        "joint_absolute",
        "`{joint}` is taken as an absolute angle, from the base; it is relative to the link before: "
        "`{joint}` stands where `{before} + {joint}` belongs",
    )
    JOINT_SUMMED = (
        "joint_summed",
        "`{before} + {joint}` stands where `{joint}` belongs: the angle is relative to the link before already",
    )
    JOINTS_SWAPPED = "joints_swapped", "`{one}` and `{other}` are swapped"
    JOINT_FOR_JOINT = "joint_for_joint", "`{printed}` stands where `{correct}` belongs"

    # -- lengths --------------------------------------------------------------------------------------------------------
    LENGTHS_SWAPPED = "lengths_swapped", "the lengths `{one}` and `{other}` are swapped"
    LENGTHS_INTERCHANGED = "lengths_interchanged", "the lengths `{lengths}` are interchanged"
    LENGTH_MISSING = "length_missing", "the length `{length}` is missing"
    SIGN_OF_LENGTH = "sign_of_length", "the sign of the length `{length}` is wrong"
    LENGTH_FOR_LENGTH = "length_for_length", "the length `{printed}` stands where `{correct}` belongs"
    LENGTH_TWICE = "length_twice", "the length `{length}` is counted twice"
    OTHER_NUMBER = "other_number", "the length `{length}` is taken as {printed:.6g}, the arm's is {correct:g}"
    EITHER_LENGTH = "either_length", "{one}; or {other}"
    SEVERAL_LENGTHS = "several_lengths", "{one}; {other}"

    # -- link matrices --------------------------------------------------------------------------------------------------
    OTHER_GENERAL_LINK = (
        "other_general_link",
        "this is the {other} link matrix, the {convention} one is meant",
    )
    OTHER_CONVENTION = (
        "other_convention",
        "this is the {other} link matrix, the arm's frames are those of the {convention} convention",
    )
    LINKS_OF_OTHER_CONVENTION = (
        "links_of_other_convention",
        "the link matrices are those of the {other} Denavit–Hartenberg convention, the arm's frames are {convention}",
    )
    LINKS_REVERSED = (
        "links_reversed",
        "the link matrices are multiplied in the wrong order, from the last to the first",
    )
    LINKS_SWAPPED = (
        "links_swapped",
        "the link matrices `{one}` and `{other}` are multiplied in the wrong order",
    )
    LINK_LEFT_OUT = "link_left_out", "the link matrix `{link}` is missing from the product"
    LINK_TWICE = "link_twice", "the link matrix `{link}` stands in the product twice"
    WRONG_LINK = "wrong_link", "the link matrix `{link}` is wrong: {slip}"
    FIRST_WRONG_LINK = (
        "first_wrong_link",
        "the link matrix `{link}` is wrong: {slip}; frame {frame} is the first that departs from the arm's",
    )
    LINK_SIGN_OF_ENTRY = "link_sign_of_entry", "the sign of its entry ({row}, {column})"
    LINK_ENTRY = "link_entry", "its entry ({row}, {column})"
    LINK_ENTRIES = "link_entries", "its entries {places}"
    LINK_MOST_ENTRIES = "link_most_entries", "most of its entries"
    LINK_INVERTED = "link_inverted", "it is inverted"
    LINK_TRANSPOSED = "link_transposed", "its rotation is transposed, the sign of its sines is wrong"
    LINK_CONVENTION = (
        "link_convention",
        "it is that of the {other} Denavit–Hartenberg convention, the arm's frames are {convention}",
    )
    LINK_SIGN_OF_TWIST = "link_sign_of_twist", "the sign of its twist α"
    LINK_TWIST = "link_twist", "its twist α is missing"
    LINK_SIGN_OF_ANGLE = "link_sign_of_angle", "the sign of its angle θ"
    LINK_SIGN_OF_LENGTH = "link_sign_of_length", "the sign of its length a"
    LINK_LENGTH = "link_length", "its length a is missing"
    LINK_SIGN_OF_OFFSET = "link_sign_of_offset", "the sign of its offset d"
    LINK_OFFSET = "link_offset", "its offset d is missing"
    LINK_A_AND_D = "link_a_and_d", "its a and d are swapped"
    LINK_ALPHA_AND_THETA = "link_alpha_and_theta", "its angles α and θ are swapped"
    LINK_ANGLE_OFF = "link_angle_off", "its angle θ is off by {turn}"
    LINK_SINE_COSINE = "link_sine_cosine", "sine and cosine of its angle θ are exchanged"
    LINK_NOT_TURNED = "link_not_turned", "its translation is not turned: Trans and Rot stand in the wrong order"

    # -- tables ---------------------------------------------------------------------------------------------------------
    TABLE_ENTRY = "table_entry", "row {row}: {parameter} is ${printed}$, should be ${correct}$"
    TABLE_ENTRY_BECAUSE = (
        "table_entry_because",
        "row {row}: {parameter} is ${printed}$, should be ${correct}$: {change}",
    )
    WRONG_VARIABLE = "wrong_variable", "row {row}: the variable is ${printed}$, should be ${correct}$"
    WRONG_ORIGIN = "wrong_origin", "row {row}: ${printed}$ should be ${correct}$: {change}"
    JOINT_IS_NOT = "joint_is_not", "row {row}: the joint is {joint_kind}, not {printed}"
    JOINT_IS = "joint_is", "the joint is {joint_kind}"
    OTHER_VARIABLE = "other_variable", "the variable of another joint"
    PARAMETERS_SWAPPED = "parameters_swapped", "{one} and {other} are swapped"
    INDEX_NOT_ON_ARM = "index_not_on_arm", "the index: the arm has no ${name}$"
    THE_SIGN = "the_sign", "the sign"
    A_SIGN = "a_sign", "a sign"
    A_FACTOR = "a_factor", "a factor"
    THE_INDEX = "the_index", "the index"
    THE_OFFSET = "the_offset", "the constant offset"
    THE_HEADER = "the_header", "the header"
    THE_AXIS = "the_axis", "the axis"
    THE_NAME = "the_name", "the joint's name"
    THE_PARENT = "the_parent", "the parent link"
    THE_CHILD = "the_child", "the child link"
    THE_ANGLE = "the_angle", "the angle"
    ANOTHER_ANGLE = "another_angle", "another angle"
    ANOTHER_LENGTH = "another_length", "another length"
    DEGREES_FOR_RADIANS = "degrees_for_radians", "it is in degrees, the header says radians"
    ROUNDED = "rounded", "a rounded number, which no equation can match"
    IS_MISSING = "is_missing", "it is missing"
    SHOULD_VANISH = "should_vanish", "it should vanish"
    LETTER_FOR_LETTER = "letter_for_letter", "${printed}$ for ${correct}$"
    LETTER_MISSING = "letter_missing", "${letter}$ is missing"
    LETTER_EXTRA = "letter_extra", "${letter}$ does not belong"
    OTHER_FRAMES = (
        "other_frames",
        "the table gives `{pose}` of the arm, but by other frames from row {number} on: "
        "a {convention} DH table whose frames between are not the arm's",
    )
    HEADERS_OF_OTHER_CONVENTION = (
        "headers_of_other_convention",
        "the rows hold in the {convention} convention, the headers say {stated}",
    )
    FRAMES_OF_OTHER_CONVENTION = (
        "frames_of_other_convention",
        "the arm's frames are {convention} DH frames, the headers say {stated}",
    )
    HEADERS_SWAPPED = "headers_swapped", "columns {one} and {other} swapped: the headers"
    ROWS_SHIFTED = (
        "rows_shifted",
        "a and α stand one row too {direction}, as in a table of the {convention} convention",
    )
    ROW_WITHOUT_DH_FRAMES = (
        "row_without_dh_frames",
        "row {number}: frames {reference} and {frame} of the arm are not {convention} DH frames",
    )
    AND_MORE = "and_more", "and {count} more"
    NO_DH_FRAMES = (
        "no_dh_frames",
        "the frames of arm '{arm}' are DH frames of neither convention: the rows cannot be checked one by one",
    )
    MOVES_WITH = "moves_with", "the last row's frame moves with frame {frame} for every configuration"
    MOVES_WITH_BUT_AT = (
        "moves_with_but_at",
        "the last row's frame moves with frame {frame} for every configuration, with its origin in that of frame {origin}",
    )
    SO_MENDED = "so_mended", "so mended, the last row's frame moves with frame {frame}"
    AT_NO_LAST_FRAME = "at_no_last_frame", "and the last row's frame lies at none of the arm's last frames"
    GENERAL_LINK = "general_link", "names the parameters of a general link"
    NO_ARM_FOR_TABLE = "no_arm_for_table", "the front matter names no arm to check the table against"
    DH_CONVENTION = "dh_convention", "{convention} DH"
    HEADERS_OPEN = "headers_open", "the headers leave the convention open"
    HEADERS_CONTRADICT = "headers_contradict", "the headers contradict each other"
    HOLDS_IN_BOTH = "holds_in_both", "the rows hold in both conventions"
    HOLDS_IN_CONVENTION = "holds_in_convention", "the rows hold in the {convention} one"
    LENGTH_ALONG_X = "length_along_x", "{holds}, {letter} the length along x"
    ROW_OPEN = "row_open", "row {number}: {parameter}: {problem}"
    ROW_OPEN_BUT = (
        "row_open_but",
        "row {number}: {parameter}: {problem}; the entry holds if it means ${meaning}$: bind it under 'symbols'",
    )
    ROW_WITHOUT_FRAME = "row_without_frame", "row {number} has no frame on the arm to be checked against"
    JOINTS_WITHOUT_ROW = "joints_without_row", "{rows} rows for an arm of {joints} joints: none for `{without}`"
    ROWS_BEYOND_ARM = (
        "rows_beyond_arm",
        "{rows} rows for an arm of {joints} joints, which has no frame for row {beyond}",
    )
    ROWS_IN_ORDER = "rows_in_order", "the labels name no frames of the arm: the rows are taken in order"
    LENGTHS_IN_NUMBERS = "lengths_in_numbers", "lengths in numbers are compared with those of the model"
    EMPTY_AS_ZERO = "empty_as_zero", "an empty entry is read as 0"
    READ_IN_DEGREES = "read_in_degrees", "the angle {angle} is read in degrees"
    VARIABLE_WITHOUT_JOINT = "variable_without_joint", "'{cell}' names the variable of a row that has no joint"
    UNREADABLE_CELL = "unreadable_cell", "row {row}, column {column}: '{cell}' cannot be read: {problem}"
    ROW_LENGTH = "row_length", "row {number} has {count} entries, the header has {width}"
    NO_TABLE = "no_table", "the rows are no Denavit–Hartenberg table"
    NO_COORDINATE = "no_coordinate", "row {row}, column {column}: '{cell}' is no coordinate"
    NO_AXIS = "no_axis", "'{cell}' is no axis; write x, -z or 0 0 1"
    ORIGINS = "origins", "the origins of {count} joints of the model"
    NO_SUCH_JOINT = "no_such_joint", "row {number}: no joint '{name}' in the model; its joints are {joints}"
    NO_ROW_FOR = "no_row_for", "no row for {joints}"

    # -- inverse kinematics ---------------------------------------------------------------------------------------------
    NO_DERIVATION = "no_derivation", "{reason}"
    RETURNS = "returns", "FK(IK(x)) = x {how} on its one branch"
    RETURNS_ON_BRANCHES = "returns_on_branches", "FK(IK(x)) = x {how} on each of {count} branches (`{signs}`)"
    ALL_ON_IT = "all_on_it", "every configuration is on it: there is no other solution"
    SAMPLES_ON_IT = "samples_on_it", "every configuration of the samples is on it: there is no other solution"
    ALL_ON_BRANCHES = "all_on_branches", "every configuration is on one of them: there are no other solutions"
    SAMPLES_ON_BRANCHES = (
        "samples_on_branches",
        "every configuration of the samples is on one of them: there are no other solutions",
    )
    FEWER_WHERE = "fewer_where", "fewer where {places}, none where that is negative"
    DEGENERATE_WHERE = "degenerate_where", "no value, or a joint free, where {places}"
    VANISHES = "vanishes", "${formula} = 0$"
    HOLDS = "holds", "${formula}$"
    EITHER = "either", "{one} or {other}"
    NOT_PROVED_EXACTLY = "not_proved_exactly", "FK(IK(x)) = x is not proved exactly: {problem}"
    NOT_PROVED_EXACTLY_FOR = "not_proved_exactly_for", "FK(IK(x)) = x is not proved exactly for {labels}"
    MAYBE_INCOMPLETE = (
        "maybe_incomplete",
        "that there are no other solutions is not proved exactly: {problem}",
    )
    MISSES_TARGET = (
        "misses_target",
        "FK(IK(x)) is not x {where}: {slot} is off by {error:.3g} at the first example",
    )
    ON_ANY_BRANCH = "on_any_branch", "on any branch"
    ON_THE_BRANCH = "on_the_branch", "on the branch {signs}"
    SIGNED = "signed", "`{name}` {sign}"
    ON_ITS_BRANCH = "on_its_branch", ""
    LOSES_JOINT = (
        "loses_joint",
        "no branch gives back `{joint}` (line {line}) at {lost} of {configurations} random configurations, "
        "though the joints before it are right",
    )
    INVERSE_FOR_THESE_LENGTHS = (
        "inverse_for_these_lengths",
        "right for the lengths of this arm only; for others {others}",
    )

    # -- functions ------------------------------------------------------------------------------------------------------
    PROVED_FOR_JOINTS = "proved_for_joints", "proved for all joint values"
    PROVED_FOR_LENGTHS = "proved_for_lengths", "proved for all joint values and all lengths"
    PROVED_AT_LENGTHS = "proved_at_lengths", "proved for all joint values, at the arm's lengths {values}"
    VALUE = "value", "`{name}` = {value:g}"
    EQUAL_AT = "equal_at", "equal at {count:,} configurations"
    NOT_THE_FORMULA = (
        "not_the_formula",
        "not exactly the arm's formula: a rounded constant or a difference quotient",
    )
    OF_QUANTITY = "of_quantity", "{label}: {what}"
    RESULT_SIZE = "result_size", "the result is {printed}, it should be {correct}"
    RESULT_SIZE_BECAUSE = "result_size_because", "{mismatch}: {cause}"
    RESULT_DIFFERS = "result_differs", "the result differs from the arm's"
    ANOTHER_SHAPE = "another_shape", "the result has another shape at some configurations"
    SHAPES_DIFFER = "shapes_differ", "the function returns results of different shapes at different q"
    NOT_FINITE = "not_finite", "the result holds entries that are not finite (NaN or infinity)"
    WRONG_SOMEWHERE = (
        "wrong_somewhere",
        "the result is wrong at {wrong} of {configurations} configurations, such as the one given, and right elsewhere",
    )
    NOT_FINITE_SOMEWHERE = (
        "not_finite_somewhere",
        "the result is not finite at {wrong} of {configurations} configurations, such as the one given, "
        "and right elsewhere",
    )
    CUT_TO_INTEGERS = (
        "cut_to_integers",
        "every entry is cut to a whole number: an array made of integers cuts what is assigned to it; make it of floats",
    )
    WRONG_DEFAULT = "wrong_default", "the formula is right, but the default value of {lengths}"
    DEFAULT = "default", "`{length}` is {printed}, the arm's is {correct:g}"
    AND_THAT_OF = "and_that_of", "{one}; that of {other}"
    ROUNDED_ENTRIES = "rounded_entries", "the entries are rounded to {digits} decimals"
    RIGHT_TO_DECIMALS = (
        "right_to_decimals",
        "right to about {digits} decimals only: a rounded constant (3.14 for π), "
        "or a difference quotient with too large a step",
    )
    UNSTEADY = (
        "unsteady",
        "two calls at the same q give different results: random numbers, or values kept between calls",
    )
    NO_NUMBERS = "no_numbers", "{reason}"
    NOT_ATTEMPTED = "not_attempted", "{reason}"
    NOT_IMPLEMENTED = "not_implemented", "the function raises NotImplementedError"
    DID_NOT_END = (
        "did_not_end",
        "the function did not end within {seconds:g} s{where}: a loop that never ends? "
        "A function that is slow is given more time with 'seconds'",
    )
    CALLS_ITSELF = "calls_itself", "the function calls itself without end{where}"
    RAISED = "raised", "{type}{where}: {reason}"
    IN_LINE = "in_line", " in line {line}"
    AT_VALUES = "at_values", "{what} (at {values})"

    # -- documents that cannot be checked -------------------------------------------------------------------------------
    OUR_FAULT = "our_fault", "internal error of Armproof, please report it: {reason}"
    PROCESS_ENDED = "process_ended", "the process that checked it ended; Drake may have aborted on its arm"
    TOO_MANY_FRACTIONS = "too_many_fractions", "fractions of angles with too many denominators"
    NO_INVERSE = "no_inverse", "no 'inverse' in the front matter, as inverse: {{target: [X, Y]}}"
    NO_SUCH_FILE = "no_such_file", "no such file"
    NO_FILE_OR_FOLDER = "no_file_or_folder", "no such file or folder"
    NO_DOCUMENT = "no_document", "no document in this folder; a document is a {suffixes} file with displays"
    NOT_A_FILE = "not_a_file", "not a file"
    NOT_ONE_FILE = "not_one_file", "not a file; one document is corrected at a time"
    UNKNOWN_SUFFIX = "unknown_suffix", "'{suffix}' files are not read; those that are: {suffixes}"
    UNKNOWN_FORMAT = "unknown_format", "no format '{format}'; the formats are {formats}"
    FILE_GONE = "file_gone", "it is gone"
    FILE_UNREADABLE = "file_unreadable", "cannot be read: {reason}"
    FILE_TOO_LARGE = "file_too_large", "larger than {megabytes} MB"
    FILE_CHANGES = "file_changes", "it changes while it is read; save it and verify it again"
    HAS_CHANGED = "has_changed", "it has changed since it was read; correct it again"
    NOT_UTF8 = "not_utf8", "not a text file in UTF-8 (byte {byte})"
    NOT_JSON = "not_json", "not a notebook: {reason} (a notebook is JSON)"
    NOT_A_NOTEBOOK = "not_a_notebook", "not a notebook: {reason}"
    FRONT_MATTER_OPEN = "front_matter_open", "the front matter opened by '---' is never closed by '---'"
    FRONT_MATTER_ALIAS = (
        "front_matter_alias",
        "the front matter may not repeat a part by '*{anchor}'; write it out",
    )
    FRONT_MATTER_NOT_YAML = "front_matter_not_yaml", "the front matter is not YAML: {reason}"
    FRONT_MATTER_NO_MAPPING = (
        "front_matter_no_mapping",
        "the front matter must be a mapping of keys such as 'arm: scara'",
    )
    KEY_TWICE = "key_twice", "the front-matter key '{key}' stands twice, first in line {first}"
    UNKNOWN_KEY = "unknown_key", "unknown front-matter key '{key}'; the keys are {keys}"
    KEY_NOT_TEXT = "key_not_text", "'{key}' must be text, not {value}"
    ARM_EMPTY = "arm_empty", "'arm' is empty; name an arm, a model file or a DH table, or leave the key out"

    # -- what the front matter says -------------------------------------------------------------------------------------
    NO_MAPPING = "no_mapping", "'{key}' must be a mapping from names to meanings, not {value}"
    UNKNOWN_TRANSFORMS = "unknown_transforms", "'transforms' must be upper or lower, not {value}"
    SYMBOL_OF_NOTHING = "symbol_of_nothing", "symbol '{symbol}' must be bound to a symbol of the arm, not {value}"
    UNKNOWN_SYMBOL = (
        "unknown_symbol",
        "symbol '{symbol}': the arm '{arm}' has no '{value}'; it has {known} ('{free}' binds a letter that is none of the arm's)",
    )
    SYMBOL_NOT_FREE = "symbol_not_free", "symbol '{symbol}' is one of the arm '{arm}': it cannot be free"
    NO_NAME_BECAUSE = "no_name_because", "'{name}' is not a name: {problem}"
    NO_NAME = (
        "no_name",
        "'{name}' is not a name; write it as in the displays, such as P_x, J(q) or {{}}^0T_4",
    )
    QUANTITY_OF_NO_KIND = (
        "quantity_of_no_kind",
        "quantity '{quantity}' must name one of {kinds}, such as {{origin: 3}}; it is {value}",
    )
    UNKNOWN_OPTION = (
        "unknown_option",
        "quantity '{quantity}': unknown option {options}; valid with '{kind_name}': {valid}",
    )
    UNKNOWN_LINK = "unknown_link", "quantity '{quantity}': link must be classic or modified, not {value}"
    IN_QUANTITY = "in_quantity", "quantity '{quantity}': {problem}"
    QUANTITY_WITHOUT_ARM = (
        "quantity_without_arm",
        "quantity '{quantity}' is of an arm, but the front matter names no arm",
    )
    UNKNOWN_JOINT = "unknown_joint", "quantity '{quantity}': no joint '{joint}'; the arm's are {joints}"
    NOT_TWO_FRAMES = (
        "not_two_frames",
        "quantity '{quantity}': difference takes two frames, [to, from], not {value}",
    )
    NO_SUCH_ROW = (
        "no_such_row",
        "quantity '{quantity}': a {kind_name} has {most} rows, there is no row {index}",
    )
    UNKNOWN_AXIS = "unknown_axis", "quantity '{quantity}': along must be x, y or z, not {value}"
    NO_ROW_AND_COLUMN = (
        "no_row_and_column",
        "quantity '{quantity}': component of a pose is [row, column], not {value}",
    )
    UNKNOWN_COMPONENT = "unknown_component", "quantity '{quantity}': component must be x, y or z, not {value}"
    NO_INDICES = (
        "no_indices",
        "quantity '{quantity}': {option} must be a list of indices counted from 1, not {value}",
    )
    NO_SUCH_COLUMN = (
        "no_such_column",
        "quantity '{quantity}': a {kind_name} has {most} columns, there is no column {index}",
    )
    INVERSE_WITHOUT_ARM = (
        "inverse_without_arm",
        "'inverse' solves for the joints of an arm, but the front matter names no arm",
    )
    INVERSE_OF_NOTHING = "inverse_of_nothing", "'inverse' must say what is given, as {example}; it is {value}"
    UNKNOWN_INVERSE_OPTION = "unknown_inverse_option", "'inverse': unknown option {unknown}; the options are {options}"
    UNKNOWN_TARGET = "unknown_target", "'inverse': a target is one of {targets}, or a list of names"
    NO_TARGET = "no_target", "'inverse': a target is a list of names, as {example}; it is {value}"
    NAME_TWICE = "name_twice", "'inverse': a name stands twice in the target {target}"
    NO_JOINTS_TO_SOLVE = "no_joints_to_solve", "'inverse': solve is a list of joints, of {joints}; it is {value}"
    NOT_EACH_JOINT = (
        "not_each_joint",
        "'inverse': solve must name each joint of the arm '{arm}' once; they are {joints}, it is {given}",
    )
    OF_INVERSE = "of_inverse", "'inverse': {problem}"
    TOO_MANY_SIGNS = "too_many_signs", "'inverse': {count} independent signs; at most {most} are read"
    NO_PART_OF_TARGET = (
        "no_part_of_target",
        "'inverse': '{name}' is a {kind_name}; a target is made of {shapes} or their components",
    )

    # -- the parts of a matrix ------------------------------------------------------------------------------------------
    EMPTY = "empty", "empty"
    THE_MATRIX = "the_matrix", "the matrix"
    THE_ROTATION = "the_rotation", "the rotation"
    THE_ORIGIN = "the_origin", "the origin"
    THE_LAST_ROW = "the_last_row", "the last row"
    THE_PART = "the_part", "the {part} part"
    THE_PART_OF_COLUMN = "the_part_of_column", "the {part} part of column {number}"
    THE_COLUMN = "the_column", "column {number}"
    THE_COLUMNS = "the_columns", "columns {numbers}"
    BOTH = "both", "{one} and {other}"
