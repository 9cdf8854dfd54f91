"""docs/outputs.md names all data sets that fields.h5 has, and no others; the page on pictures names all layers: test_outputs.py"""
import os
import pathlib
import re
import subprocess
import sys
import tempfile
import unittest

try:
    import h5py
except ImportError as missing:
    print(f"not here: {missing}")
    sys.exit(77)

source = pathlib.Path(__file__).resolve().parents[2]
program = pathlib.Path(os.environ["MATRIGRATE"]).resolve()
outputs = (source / "docs" / "outputs.md").read_text(encoding="utf-8")
start = """
[run]
duration = "12 s"
integrator = "adaptive"
[output]
field_interval = "6 s"
[ecm]
"""
plain = 'radius = "60 um"\n'
everything = """radius = "100 um"
[ecm.fields]
youngs_modulus = "200 + x"
ligand = "1"
attractant = "1 + x/1000"
obstacle = "y > 60 ? 1 : 0"
[fibres]
arrangement = "isotropic"
[nucleus]
radius = "5 um"
[[cells]]
x = -25
y = 0
[[cells]]
x = 25
y = 0
"""


def data_sets(text: str, folder: str) -> dict[str, str]:
    """Name and unit of each data set of a run of this scenario; the views in /frames are left out."""
    at = pathlib.Path(folder)
    (at / "s.toml").write_text(start + text)
    subprocess.run([program, "run", at / "s.toml", "-o", at / "run", "--quiet"], check=True, stdout=subprocess.DEVNULL)
    found = {}

    def visit(name: str, thing: object) -> None:
        if isinstance(thing, h5py.Dataset) and not name.startswith("frames/"):
            found[f"/{name}"] = thing.attrs["units"].decode()

    with h5py.File(at / "run" / "fields.h5") as file:
        file.visititems(visit)
    return found


class Outputs(unittest.TestCase):
    def test_data_sets_are_those_of_the_files(self):
        told, always = {}, set()
        for names, units, there in re.findall(r"^\| (`/[^|]*) \| ([^|]*) \| ([^|]*) \|", outputs, re.MULTILINE):
            names, units = re.findall(r"`([^`]*)`", names), units.split(", ")
            told |= dict(zip(names, units * len(names) if len(units) == 1 else units, strict=False))
            always |= set(names) if there == "always" else set()
        with tempfile.TemporaryDirectory() as folder:
            self.assertEqual(data_sets(everything, folder), told)
        with tempfile.TemporaryDirectory() as folder:
            self.assertEqual(set(data_sets(plain, folder)), always)

    def test_layers_are_those_of_the_program(self):
        text = (source / "apps" / "export" / "other_programs.cpp").read_text(encoding="utf-8")
        layers = re.findall(r'"(\w+)"', re.search(r" layers\{([^}]*)\}", text)[1])
        self.assertGreater(len(layers), 3)
        page = (source / "docs" / "how-to" / "pictures-and-movies.md").read_text(encoding="utf-8")
        self.assertEqual(re.findall(r"`(\w+)`", re.search(r"`--layer` is[^.;]*", page)[0]), layers)


if __name__ == "__main__":
    unittest.main()
