"""What fields.h5 of run.sh's run has for some pixels of fields.ome.tif; as a program, field_pixels.py FOLDER, it writes them as JSON.

A pixel is [frame, channel, row, column, value], counted from 0 at the upper left; its value is that of the nearest particle.
"""
import json
import sys

try:
    import h5py
    import numpy as np
except ImportError:
    sys.exit(77)

side, width = 60, 2.0  # pixels, um


def pixels(folder):
    found = []
    with h5py.File(f"{folder}/fields.h5") as fields:
        x = fields["matrix/position"][:, :, :2].astype(float)
        values = {
            "displacement_y [um]": fields["matrix/displacement"][:, :, 1],
            "f_degr": fields["matrix/f_degr"][:],
            "pressure [Pa]": fields["matrix/pressure"][:],
        }
    for frame in (1, 3, 5):
        for row, column in ((30, 30), (12, 40), (45, 22), (30, 48), (8, 30), (20, 31)):
            middle = np.array([(column + 0.5) * width, -(row + 0.5) * width]) + np.array([-1, 1]) * side * width / 2
            distance = np.hypot(*(x[frame] - middle).T)
            near = np.argsort(distance)[:2]
            if np.diff(distance[near]) < 1e-4:
                continue  # as near to two particles
            found += [[frame, name, row, column, float(field[frame, near[0]])] for name, field in values.items()]
    assert len(found) >= 30 and len({value for *_, value in found}) >= 15, found
    return found


if __name__ == "__main__":
    print(json.dumps(pixels(sys.argv[1])))
