"""fields.ome.tif in ImageJ, the core of Fiji, without Bio-Formats: reads.py FOLDER OF_THE_RUN, MACRO, EMPTY FOLDER

A drag gives a plain stack with the scale of the pixels; Image > Hyperstacks > Stack to Hyperstack makes channels and frames
of it. ImageJ reads a number of channels only from a description that is its own, and this one is OME's.
"""
import os
import pathlib
import shutil
import subprocess
import sys

jar = "/usr/share/java/ij.jar"
try:
    import numpy as np

    sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent))
    import field_pixels
except ImportError:
    sys.exit(77)
if not (os.path.exists(jar) and shutil.which("java") and shutil.which("xvfb-run")):
    sys.exit(77)

run, macro, folder = (pathlib.Path(argument).resolve() for argument in sys.argv[1:4])
shutil.rmtree(folder, ignore_errors=True)
folder.mkdir(parents=True)
channels = ["displacement_x [um]", "displacement_y [um]", "velocity_x [um/s]", "velocity_y [um/s]", "f_degr", "pressure [Pa]",
            "von_mises [Pa]", "cell"]
frames = 6
pixels = field_pixels.pixels(run)
pixels.append([0, channels[0], 0, 0, float("nan")])  # beyond the disc
(folder / "pixels.txt").write_text("\n".join(f"{t} {channels.index(c)} {y} {x}" for t, c, y, x, _ in pixels))
told = f"{run}/export/fields.ome.tif|{len(channels)}|{frames}|{folder}/pixels.txt"
said = subprocess.run(["timeout", "90", "xvfb-run", "-a", "java", f"-Duser.home={folder}", "-cp", jar, "ij.ImageJ", "-batch", macro, told],
                      capture_output=True, text=True)
lines = said.stdout.splitlines()


def after(words):
    return [line[len(words) + 1:] for line in lines if line.startswith(words + " ")]


seen = {"plain": ("1", "48", "1", "0"), "hyperstack": ("8", "1", "6", "1")}
for what, (c, z, t, is_hyperstack) in seen.items():
    sizes = [line for line in after(what) if not line.startswith(("unit", "pixel"))]
    assert sizes == [f"60 60 {c} {z} {t} 32 2 2 {is_hyperstack} 0"], (what, sizes, said.stdout, said.stderr)
    assert after(f"{what} unit") == ["181 m"], lines  # \u00b5m
    values = np.array(after(f"{what} pixel"), dtype=float).astype(np.float32)
    assert len(values) == len(pixels), lines
    for value, (*place, wanted) in zip(values, pixels, strict=True):
        assert value == np.float32(wanted) or (np.isnan(value) and np.isnan(wanted)), (what, place, value, wanted)
print(f"ImageJ {after('version')[0]}: {len(pixels)} pixels of a plain stack and of a hyperstack")
