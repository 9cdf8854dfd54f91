"""fields.ome.tif in tifffile: times and channels, scale, and at some pixels the numbers of fields.h5."""
import sys

try:
    import h5py
    import numpy as np
    import tifffile

    import field_pixels
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

for frame, name, row, column, value in field_pixels.pixels(folder):
    assert stack[frame, names.index(name), row, column] == np.float32(value), (frame, name, row, column)

with h5py.File(f"{folder}/fields.h5") as fields:
    outline = fields["outline/position"][5].astype(float)[:, :2]
cell = stack[5, names.index("cell")]
following = np.roll(outline, -1, axis=0)
area = 0.5 * np.sum(outline[:, 0] * following[:, 1] - following[:, 0] * outline[:, 1])
assert abs(4.0 * cell.sum() / area - 1.0) < 0.05, (cell.sum(), area)
assert np.isnan(stack[0, 0, 0, 0]) and set(np.unique(cell)) == {0.0, 1.0}
print(f"{stack.shape[0]} times, {', '.join(names)}")
