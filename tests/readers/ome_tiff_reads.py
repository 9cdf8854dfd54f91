"""fields.ome.tif in tifffile: times and channels, scale, and at some pixels the numbers of fields.h5."""
import sys

try:
    import h5py
    import numpy as np
    import tifffile
except ImportError:
    sys.exit(77)

folder = sys.argv[1]
with tifffile.TiffFile(f"{folder}/export/fields.ome.tif") as file:
    assert file.is_ome and len(file.series) == 1
    series = file.series[0]
    assert series.axes == "TCYX" and series.dtype == np.float32, (series.axes, series.dtype)
    stack = series.asarray()
    pixels = tifffile.xml2dict(file.ome_metadata)["OME"]["Image"]["Pixels"]
    resolution = file.pages[0].tags["XResolution"].value
    assert file.pages[0].tags["ResolutionUnit"].value == 3 and 1e4 * resolution[1] / resolution[0] == 2.0  # centimetres
assert pixels["PhysicalSizeX"] == pixels["PhysicalSizeY"] == 2 and pixels["PhysicalSizeXUnit"] == "\u00b5m"
assert pixels["TimeIncrement"] == 36 and pixels["TimeIncrementUnit"] == "s"
names = [channel["Name"] for channel in pixels["Channel"]]
assert stack.shape == (6, len(names), 60, 60), stack.shape

with h5py.File(f"{folder}/fields.h5") as fields:
    x = fields["matrix/position"][:, :, :2].astype(float)
    column = np.arange(60) * 2.0 - 59.0
    for frame in (0, 3, 5):
        for row, of in ((30, 30), (12, 40), (45, 22), (30, 48)):
            place = np.array([column[of], -column[row]])  # the first row is the upper one
            near = np.argsort(np.hypot(*(x[frame] - place).T))[:2]
            if np.diff(np.hypot(*(x[frame, near] - place).T)) < 1e-4:
                continue  # as near to two particles
            for name, values in (("pressure [Pa]", fields["matrix/pressure"][frame]),
                                 ("f_degr", fields["matrix/f_degr"][frame]),
                                 ("displacement_y [um]", fields["matrix/displacement"][frame][:, 1])):
                assert stack[frame, names.index(name), row, of] == np.float32(values[near[0]]), (frame, name, row, of)
    outline = fields["outline/position"][5].astype(float)[:, :2]
cell = stack[5, names.index("cell")]
following = np.roll(outline, -1, axis=0)
area = 0.5 * np.sum(outline[:, 0] * following[:, 1] - following[:, 0] * outline[:, 1])
assert abs(4.0 * cell.sum() / area - 1.0) < 0.05, (cell.sum(), area)
assert np.isnan(stack[0, 0, 0, 0]) and set(np.unique(cell)) == {0.0, 1.0}
print(f"{stack.shape[0]} times, {', '.join(names)}")
