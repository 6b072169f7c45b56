"""Hold the documents against their record, or search for more: `python -m tests.reached [--update] [--minutes N [--seed S]]`."""

from __future__ import annotations

import argparse
import sys


def main() -> int:
    """Return 1 if of a document another thing is said than is on record."""
    parser = argparse.ArgumentParser(prog="python -m tests.reached", description=(__doc__ or "").splitlines()[0])
    parser.add_argument("--minutes", type=float, default=0, help="search for so long, and put what is found on record")
    parser.add_argument("--seed", type=int, default=2026)
    parser.add_argument("--update", action="store_true", help="write the record anew")
    options = parser.parse_args()
    return search(options.seed, options.minutes) if options.minutes else compare(options.update)


def search(seed: int, minutes: float) -> int:
    """Search, put what is found on record, and print how many there are and what failed."""
    from tests.reached import outcomes

    outcomes.note()  # before anything of the trusted base is imported
    from tests.reached.documents import Reached, load, write
    from tests.reached.search import Search, fewest

    begun = Search.begun(seed)
    known = begun.counts.copy()
    begun.run(60 * minutes)
    chosen = fewest(begun.found, known)
    write([*load(), *(Reached(document, document.said()) for document in chosen)])
    print(f"{len(chosen)} documents more; outcomes: {len(begun.counts)}")
    for failure, document in begun.failed:
        print(f"{failure}\n{document.text}")
    return 1 if begun.failed else 0


def compare(update: bool) -> int:
    """Print the documents of which another thing is said than is on record; write the record anew if asked."""
    from tests.reached import derived, heard, in_full, kinds
    from tests.reached.documents import Reached, load, write

    known = (*load(), *derived.load().values())
    changed = [each for each in known if not each.is_said_as_ever]
    otherwise = [sentence for sentence in heard.known_sentences() if not heard.is_heard_as_ever(sentence)]
    for each in changed:
        print(f"===== {each.name}\n{each.document.text}said: {each.document.said()}on record: {each.said}")
    print(f"of {len(changed)} of {len(known)} documents another thing is said than is on record")
    for sentence in otherwise:
        print(f"heard otherwise: {sentence}\n    {heard.heard(sentence)}\n    {heard.read_record().get(sentence)}")
    of_kinds = [kind for kind in kinds.words() if not kinds.is_heard_as_ever(kind)]
    print("".join(f"heard otherwise beside a word of the class {kind}\n" for kind in of_kinds), end="")
    fully = [name for name in in_full.load() if not in_full.is_said_as_ever(name)]
    for name in fully:
        print(
            f"===== in full {name}\n{in_full.said_in_full(in_full.load()[name])}on record: {in_full.read_record().get(name)}"
        )
    if update:
        in_full.write_record()
        heard.write_record()
        kinds.write_record()
        write([Reached(each.document, each.document.said()) for each in load()])
        derived.write_record()
    return 1 if (changed or otherwise or of_kinds or fully) and not update else 0


if __name__ == "__main__":
    sys.exit(main())
