"""How long a display may take: to be decided, to be explained, and to be asked for slips in what is said before it."""

SECONDS_TO_DECIDE = 1.1  # a display is bounded by two seconds in all: so long to decide it,
SECONDS_TO_EXPLAIN = 0.9  # and so long to say what is wrong in it
WORK_ON_SLIPS = 30_000  # questions of the budget about slips in what is said before: counted, a verdict may rest on one
SECONDS_ON_SLIPS = 3.0  # for where a question takes longer than anywhere
