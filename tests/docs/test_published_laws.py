"""docs/how-to/published-laws.md shows the laws that ship, and the table of its runs."""
import pathlib
import sys

source = pathlib.Path(__file__).resolve().parents[2]
sys.path.insert(0, str(source / "tools"))
import published_laws  # noqa: E402


def main() -> int:
    stale = published_laws.page_text() != published_laws.page.read_text(encoding="utf-8")
    if stale:
        print("docs/how-to/published-laws.md is not what tools/published_laws.py writes; run it without arguments")
    return int(stale)


if __name__ == "__main__":
    sys.exit(main())
