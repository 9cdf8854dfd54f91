"""What several pages say, they say alike: python3 numbers_agree.py ROOT

README.md and docs/limits.md have the bottom line of docs/validation.md word for word, README.md the counts of the other edition of
the rules and of the other set of closures as the kept tables have them, and phrases that several pages say stand in all of them.
"""
import collections
import csv
import re
import sys
from pathlib import Path

PHRASES = {
    "7 to 9 times slower": ["README.md", "docs/performance.md", "apps/reproduce/reproduce.cpp"],
}


def counts(table, column):
    """How many claims of a kept table have each verdict."""
    with table.open(newline="") as file:
        return collections.Counter(row[column] for row in csv.DictReader(file))


def other_counts(kept):
    """What README.md says of the first edition, and of the first set by the second edition."""
    first_set = counts(kept / "first/claims.csv", "verdict_second_edition")
    return [f"by the first, {counts(kept / 'claims.csv', 'verdict')['holds']} hold",
            "the first set had " + " / ".join(str(first_set[verdict]) for verdict in ("holds", "in direction", "does not hold"))]


def main():
    root = Path(sys.argv[1])
    faults = [f"{page}: does not say '{phrase}'" for phrase, pages in PHRASES.items() for page in pages
              if phrase not in (root / page).read_text()]
    bottom_line = re.search(r"<!-- generated: bottom line -->\n(.*?)\n", (root / "docs/validation.md").read_text())
    if not bottom_line or not bottom_line[1].strip("*.;").split("**")[0]:
        faults.append("docs/validation.md: has no bottom line")
    else:
        first = bottom_line[1].split("**")[1]
        faults += [f"{page}: does not say '{first}'" for page in ("README.md", "docs/limits.md")
                   if first not in " ".join((root / page).read_text().split())]
    readme = " ".join((root / "README.md").read_text().split())
    faults += [f"README.md: does not say '{text}'" for text in other_counts(root / "docs/validation") if text not in readme]
    print("\n".join(faults) or "the pages agree")
    return 1 if faults else 0


sys.exit(main())
