"""What several pages say, they say alike: python3 numbers_agree.py ROOT

README.md has the bottom line of docs/validation.md word for word, and phrases that several pages say stand in all of them.
"""
import re
import sys
from pathlib import Path

PHRASES = {
    "7 to 9 times slower": ["README.md", "docs/performance.md", "apps/reproduce.cpp"],
}


def main():
    root = Path(sys.argv[1])
    faults = [f"{page}: does not say '{phrase}'" for phrase, pages in PHRASES.items() for page in pages
              if phrase not in (root / page).read_text()]
    bottom_line = re.search(r"<!-- generated: bottom line -->\n(.*?)\n", (root / "docs/validation.md").read_text())
    if not bottom_line or not bottom_line[1].strip("*.;").split("**")[0]:
        faults.append("docs/validation.md: has no bottom line")
    else:
        first = bottom_line[1].split("**")[1]
        faults += [f"{page}: does not say '{first}'" for page in ("README.md",)
                   if first not in " ".join((root / page).read_text().split())]
    print("\n".join(faults) or "the pages agree")
    return 1 if faults else 0


sys.exit(main())
