"""placeholder"""


def check_table(checker, table):
    return None
