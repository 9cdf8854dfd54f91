"""All code blocks of a page run, and what it shows as output is what they print, to the last digit.

    test_page.py PAGE            one page; fails where its output differs
    test_page.py --update        rewrites the output shown on all tested pages (or on those named) from real runs

MATRIGRATE is the program; without it, that of build/release.
"""
import argparse
import importlib.util
import os
import pathlib
import sys
import tempfile

import blocks

source = pathlib.Path(__file__).resolve().parents[2]


def tested_pages() -> list[str]:
    how_to = sorted(page.name for page in (source / "docs" / "how-to").glob("*.md") if page.name != "index.md")
    return ["docs/quick-start.md", "docs/tutorial.md", "docs/gallery.md", *(f"docs/how-to/{name}" for name in how_to)]


def ran(page: pathlib.Path) -> blocks.Runner:
    """The page, run in a scratch folder that looks like the root of a clone."""
    here, environment = os.getcwd(), dict(os.environ)
    runner = blocks.Runner(page)
    with tempfile.TemporaryDirectory() as folder:
        os.chdir(folder)
        for name in ("R", "docs", "python", "scenarios", "viewer"):
            (pathlib.Path(folder) / name).symlink_to(source / name)
        runner.run()
        os.chdir(here)
    os.environ.clear()
    os.environ.update(environment)
    return runner


def main() -> int:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("pages", nargs="*", metavar="PAGE")
    parser.add_argument("--update", action="store_true")
    options = parser.parse_args()
    if not options.pages and not options.update:
        parser.error("name a page, or --update")
    program = pathlib.Path(os.environ.get("MATRIGRATE", source / "build" / "release" / "bin" / "matrigrate")).resolve()
    os.environ["MPLBACKEND"] = "agg"
    for core in program.parents[1].glob("python/_core*.so"):
        os.environ.setdefault("MATRIGRATE_CORE", str(core))
    os.environ["PATH"] = f"{program.parent}:{pathlib.Path(sys.executable).parent}:{os.environ['PATH']}"  # python3: this one
    sys.path.insert(0, str(source / "python"))
    bad = False
    for name in options.pages or tested_pages():
        if "python3-scipy" in (source / name).read_text(encoding="utf-8") and not importlib.util.find_spec("scipy"):
            print(f"{name}: needs SciPy, which is not here")
            return 77
        page = ran(source / name)
        for line in page.skipped:
            print("left out:", line)
        faults = page.faults
        if options.update:
            faults = [fault for fault in faults if blocks.other_numbers not in fault]
            text = page.updated()
            changed = text != page.page.read_text(encoding="utf-8")
            page.page.write_text(text, encoding="utf-8")
            print(f"{name}: {page.compared} outputs, {'rewritten' if changed else 'as they were'}")
        for fault in faults:
            print(fault, file=sys.stderr)
        bad = bad or bool(faults)
    return 1 if bad else 0


if __name__ == "__main__":
    try:
        import h5py  # noqa: F401
        import matplotlib  # noqa: F401
        import pandas  # noqa: F401
    except ImportError as missing:
        print(f"not here: {missing}")
        sys.exit(77)
    sys.exit(main())
