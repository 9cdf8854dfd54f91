#!/usr/bin/env python3
"""Draws docs/images/architecture.svg from the build files: the wings of src/ in the order of src/CMakeLists.txt, last on
top, and in each its libraries, which name by DEPENDS only what is to their right or below, with the line `# Caption:` above.

    tools/architecture.py [--check]    # with --check: exit code 1 if the picture is not that of the build files
"""
import argparse
import pathlib
import re
import sys
from xml.sax.saxutils import escape

ROOT = pathlib.Path(__file__).resolve().parent.parent
PICTURE = ROOT / "docs/images/architecture.svg"
TITLES = {"base": "Base", "fields": "Fields", "statistics": "Statistics", "parameters": "Parameters", "tracks": "Measured tracks",
          "model": "Model",
          "run": "One run", "validation": "Validation", "study": "Many runs"}
ON_TOP = [("apps/", "the command line: one file per verb"), ("python/, R/", "read the files, start the program"),
          ("viewer/, web/", "the pages; the model in a browser")]
WIDTH, LEFT, GAP, BOX = 900, 12, 12, 46
STYLE = """
    text { font-family: system-ui, "Segoe UI", Helvetica, Arial, sans-serif; fill: #1c2530; }
    .l { font-size: 13px; font-weight: 600; }
    .n { font-family: ui-monospace, Consolas, "DejaVu Sans Mono", monospace; font-size: 13px; font-weight: 600; }
    .c { font-size: 11px; fill: #44505e; }
    .page { fill: #ffffff; } .box { fill: #ffffff; stroke: #8a95a3; }
    .w0 { fill: #e9ecf1; } .w1 { fill: #f3e8f5; } .w2 { fill: #fdf0dc; } .w3 { fill: #dcf1ee; } .w4 { fill: #e3ecf9; }
    @media (prefers-color-scheme: dark) {
      text { fill: #e8edf3; } .c { fill: #b3bdc9; } .page { fill: #12171d; } .box { fill: #1b222b; stroke: #6a7685; }
      .w0 { fill: #262d37; } .w1 { fill: #36273a; } .w2 { fill: #3b3020; } .w3 { fill: #17383a; } .w4 { fill: #1f2f47; }
    }
  """


def libraries() -> dict[str, tuple[str, str, set[str]]]:
    """For each library its wing, its caption and the libraries that it names."""
    found = {}
    for path in sorted((ROOT / "src").glob("*/CMakeLists.txt")):
        text = path.read_text(encoding="utf-8")
        for caption, line, name, named in re.findall(r"^(# Caption: (.*)\n)?matrigrate_folder\((\w+)([^)]*)\)", text, re.MULTILINE):
            if not caption or len(line) > 32:
                sys.exit(f"{path.relative_to(ROOT)}: {name} has no line '# Caption: ...' of at most 32 characters above it")
            found[name] = path.parent.name, line, set(re.findall(r"\bmatrigrate_(\w+)", named))
    return found


def rows(wing: str, known: dict[str, tuple[str, str, set[str]]]) -> list[list[tuple[str, str]]]:
    """The libraries of a wing with their captions, at most four to a row: each names only what is to its right or below."""
    left = {name: {other for other in named if other in known and known[other][0] == wing}
            for name, (of, _, named) in known.items() if of == wing}
    order: list[str] = []
    while left:
        level = [name for name, named in left.items() if not named & left.keys()]
        order = level + order
        left = {name: named for name, named in left.items() if name not in level}
    count = -(-len(order) // 4)
    size = -(-len(order) // count)
    return [[(name, known[name][1]) for name in order[k:k + size]] for k in range(0, len(order), size)]


def box(x: float, y: float, width: float, name: str, caption: str) -> list[str]:
    return [f'  <rect class="box" x="{x:g}" y="{y:g}" width="{width:g}" height="{BOX}" rx="5"/>',
            f'  <text class="n" x="{x + 9:g}" y="{y + 19:g}">{escape(name)}</text>',
            f'  <text class="c" x="{x + 9:g}" y="{y + 35:g}">{escape(caption)}</text>']


def band(y: float, colour: int, title: str, boxes: list[list[tuple[str, str]]]) -> tuple[list[str], float]:
    """A band with its rows of boxes, top row first; returns its lines and its height."""
    height = 28 + len(boxes) * (BOX + GAP)
    lines = [f'  <rect class="w{colour}" x="{LEFT}" y="{y:g}" width="{WIDTH - 2 * LEFT}" height="{height}" rx="8"/>',
             f'  <text class="l" x="{LEFT + 12}" y="{y + 19:g}">{escape(title)}</text>']
    inside = WIDTH - 2 * LEFT - 24
    for k, row in enumerate(boxes):
        width = (inside - GAP * (len(row) - 1)) / len(row)
        for i, (name, caption) in enumerate(row):
            lines += box(LEFT + 12 + i * (width + GAP), y + 28 + k * (BOX + GAP), width, name, caption)
    return lines, height


def picture() -> str:
    known = libraries()
    order = re.findall(r"^add_subdirectory\((\w+)\)", (ROOT / "src/CMakeLists.txt").read_text(encoding="utf-8"), re.MULTILINE)
    parts = [("Program", [ON_TOP])]
    single = [wing for wing in order if sum(of == wing for of, _, _ in known.values()) == 1]
    foundation = [wing for wing in single if order.index(wing) < order.index("model")]
    for wing in reversed(order):
        if wing in foundation:
            continue
        parts.append((f"{TITLES.get(wing, wing)}: src/{wing}/", rows(wing, known)))
    parts.append(("Foundations: src/" + "/, src/".join(reversed(foundation)) + "/",
                  [[(name, known[name][1]) for name in reversed(foundation)]]))
    y, lines = LEFT, []
    for k, (title, boxes) in enumerate(parts):
        drawn, height = band(y, k % 5, title, boxes)
        lines += drawn
        y += height + GAP
    says = "The wings of Matrigrate: program, many runs, validation, one run, model, foundations; each includes only what is to its right or below"
    return (f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {WIDTH} {y:g}" width="{WIDTH}" height="{y:g}" role="img" '
            f'aria-labelledby="title">\n  <title id="title">{says}</title>\n  <style>{STYLE}</style>\n'
            f'  <rect class="page" width="{WIDTH}" height="{y:g}" rx="10"/>\n' + "\n".join(lines) + "\n</svg>\n")


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--check", action="store_true", help="write nothing; fail if the picture is stale")
    check = parser.parse_args().check
    made = picture()
    if not check:
        PICTURE.write_text(made, encoding="utf-8")
    elif PICTURE.read_text(encoding="utf-8") != made:
        sys.exit("docs/images/architecture.svg is not that of the build files; tools/architecture.py draws it anew")


if __name__ == "__main__":
    main()
