"""All code blocks of a page run, and what it shows as output is printed: test_page.py PAGE"""
import os
import pathlib
import sys
import tempfile

try:
    import h5py  # noqa: F401
    import matplotlib  # noqa: F401
    import pandas  # noqa: F401
except ImportError as missing:
    print(f"not here: {missing}")
    sys.exit(77)

import blocks

source = pathlib.Path(__file__).resolve().parents[2]
program = pathlib.Path(os.environ["MATRIGRATE"]).resolve()
os.environ["MPLBACKEND"] = "agg"
os.environ["PATH"] = f"{program.parent}:{os.environ['PATH']}"
sys.path.insert(0, str(source / "python"))

page = blocks.Runner(source / sys.argv[1])
with tempfile.TemporaryDirectory() as folder:
    os.chdir(folder)
    for name in ("R", "docs", "python", "scenarios"):  # the pages work at the root of a clone
        (pathlib.Path(folder) / name).symlink_to(source / name)
    page.run()
    os.chdir(source)
for line in page.skipped:
    print("left out:", line)
for line in page.faults:
    print(line, file=sys.stderr)
sys.exit(1 if page.faults else 0)
