"""fields.h5 in h5py: the cell of each frame is the cell of tracks.csv at that time, and views equal the arrays they show."""
import csv
import json
import sys

try:
    import h5py
    import numpy as np
except ImportError:
    sys.exit(77)

folder = sys.argv[1]
with open(f"{folder}/tracks.csv", newline="") as text:
    tracks = {float(row["t_s"]): row for row in csv.DictReader(text)}


def centre_and_area(x):
    following = np.roll(x, -1, axis=0)
    cross = x[:, 0] * following[:, 1] - following[:, 0] * x[:, 1]
    return x.mean(axis=0), 0.5 * cross.sum()


with h5py.File(f"{folder}/fields.h5") as file:
    times = file["time"][:]
    assert file["time"].attrs["units"] in (b"s", "s")
    assert len(times) == 6, times
    for k, t in enumerate(times):
        centre, area = centre_and_area(file["outline/position"][k].astype(float)[:, :2])
        row = tracks[t]
        assert abs(centre[0] - float(row["x_um"])) < 1e-5 and abs(centre[1] - float(row["y_um"])) < 1e-5, (t, centre, row)
        assert abs(area / float(row["area_um2"]) - 1.0) < 1e-5, (t, area, row)
        alive = int((file["protrusions/frame"][:] == k).sum())
        assert alive == int(row["n_simultaneous"]), (t, alive, row)
        for body in ("matrix", "outline"):
            for name, array in file[body].items():
                if array.ndim > 1 and array.shape[0] == len(times):
                    assert np.array_equal(file[f"frames/{k}/{body}/{name}"][()], array[k], equal_nan=True), name
    for name in ("program", "version", "trajectory_hash", "scenario"):
        assert isinstance(file.attrs[name], str) and file.attrs[name], name
    assert file.attrs["program"] == "matrigrate" and int(file.attrs["seed"]) == 1
    assert "youngs_modulus" in file.attrs["scenario"]
    with open(f"{folder}/run.json") as text:
        assert json.load(text)["trajectory_hash"] == file.attrs["trajectory_hash"]
    without = []
    file.visititems(lambda name, item: without.append(name) if isinstance(item, h5py.Dataset) and "units" not in item.attrs else None)
    assert not without, f"no units: {without}"
    for name in ("protrusions/frame", "protrusions/id", "protrusions/centre", "anchors/frame", "anchors/id"):
        assert file[name].dtype.kind == "u", (name, file[name].dtype)
    adheres = ~np.isnan(file["protrusions/anchor"][:, 0])
    assert adheres.any()
    assert np.array_equal(file["anchors/position"][:], file["protrusions/anchor"][:][adheres])
    assert np.array_equal(file["anchors/force"][:], file["protrusions/force"][:][adheres])
    for k in set(file["anchors/frame"][:].tolist()):
        rows = file["anchors/frame"][:] == k
        assert np.array_equal(file[f"frames/{k}/anchors/position"][:], file["anchors/position"][:][rows])
    moved = file["matrix/position"][-1] - file["matrix/reference"][:]
    assert np.abs(moved - file["matrix/displacement"][-1]).max() < 1e-4
    print(f"h5py {h5py.__version__}: {len(times)} frames, {file['matrix/position'].shape[1]} particles")
