"""Runs in formats of other programs: what their readers find in them."""
import json
import unittest

import common

common.skip_without("tifffile")

import matrigrate  # noqa: E402
import numpy as np  # noqa: E402
import tifffile  # noqa: E402
from matrigrate import exchange  # noqa: E402
from matrigrate.results import fields  # noqa: E402


def agents(data):
    """Kind, id, type and points of each agent of a frame, as the viewer takes its numbers apart."""
    found, at = [], 0
    while at < len(data):
        end = at + 11 + int(data[at + 10])
        found.append((data[at], data[at + 1], data[at + 2], data[at + 11:end] or data[at + 3:at + 6]))
        at = end
    return found


class Exchange(common.InTemporaryFolder):
    pair = matrigrate.load(common.runs / "pair")

    def test_a_stack_has_the_value_of_the_nearest_particle_and_the_cells(self):
        exchange.ome_tiff(self.pair, "pair.ome.tif", pixel=3.0)
        exchange.ome_tiff(self.pair, "again.ome.tif", pixel=3.0)
        self.assertTrue((self.folder / "pair.ome.tif").read_bytes() == (self.folder / "again.ome.tif").read_bytes(), "the same bytes")
        fields = self.pair.fields
        with tifffile.TiffFile("pair.ome.tif") as file:
            stack, told = file.series[0].asarray(), tifffile.xml2dict(file.ome_metadata)["OME"]["Image"]
        names = [channel["Name"] for channel in told["Pixels"]["Channel"]]
        self.assertEqual(names[:5] + names[-1:], ["displacement_x [um]", "displacement_y [um]", "velocity_x [um/s]", "velocity_y [um/s]", "f_degr", "cell"])
        self.assertEqual((told["Name"], told["Pixels"]["PhysicalSizeX"], told["Pixels"]["PhysicalSizeXUnit"]), ("pair", 3, "µm"))
        self.assertEqual([plane["DeltaT"] for plane in told["Pixels"]["Plane"]][::len(names)], list(fields.times))
        self.assertNotIn("TimeIncrement", told["Pixels"], "the last frame, at 24 min, comes sooner than the others")
        self.assertEqual(stack.shape, (len(fields.times), len(names), 50, 50))  # of a disc of 75 um
        places, pressure = fields["matrix/position"][-1][:, :2].astype(float), fields["matrix/pressure"][-1]
        seen = 0
        for row in range(0, 50, 7):
            for column in range(0, 50, 7):
                x, y = (column + 0.5) * 3 - 75, 75 - (row + 0.5) * 3
                found = stack[-1, names.index("pressure [Pa]"), row, column]
                if np.hypot(x, y) > 75:
                    self.assertTrue(np.isnan(found))
                    continue
                distance = np.hypot(*(places - (x, y)).T)
                self.assertIn(found, pressure[distance < distance.min() + 1e-6].astype(np.float32))
                seen += 1
        self.assertGreater(seen, 30)
        for number, outline in fields.outlines(-1).items():
            x, y = outline.astype(float).T
            area = 0.5 * abs(np.sum(x * np.roll(y, -1) - np.roll(x, -1) * y))
            self.assertAlmostEqual(9 * np.sum(stack[-1, -1] == number) / area, 1, delta=0.05)

    def test_a_pixel_too_small_or_none_is_refused(self):
        for pixel in (0.01, 1e9, -1.0, 0.0):
            with self.subTest(pixel=pixel), self.assertRaisesRegex(ValueError, "pixel"):
                exchange.ome_tiff(self.pair, "none.ome.tif", pixel=pixel)
        self.assertFalse((self.folder / "none.ome.tif").exists())

    def test_simularium_has_each_cell_nucleus_adhesion_and_particle(self):
        exchange.simularium(self.pair, "pair.simularium")
        made = json.loads((self.folder / "pair.simularium").read_text(encoding="utf-8"))
        kinds = {int(k): one["name"] for k, one in made["trajectoryInfo"]["typeMapping"].items()}
        frames = made["spatialData"]["bundleData"]
        fields = self.pair.fields
        self.assertEqual((made["trajectoryInfo"]["totalSteps"], made["trajectoryInfo"]["timeStepSize"], len(frames)), (5, 300.0, 5))
        self.assertEqual(len(fields.times), 6, "the last one is left out")
        for k, frame in enumerate(frames):
            of = [kinds[kind] for _, _, kind, _ in agents(frame["data"])]
            adhered = np.isfinite(fields.protrusions.loc[fields.protrusions["frame"] == k, "anchor_x"]).sum()
            self.assertEqual([of.count(name) for name in ("cell 1", "cell 2", "nucleus", "adhesion")], [1, 1, 2, adhered])
            self.assertEqual(of.count("matrix#solid") + of.count("matrix#degraded"), len(fields["matrix/reference"]))
        ring = np.reshape(agents(frames[-1]["data"])[0][3], (-1, 3))
        np.testing.assert_array_equal(ring[0], ring[-1])
        np.testing.assert_allclose(ring[:-1, :2], fields.outlines(len(frames) - 1)[1], atol=1e-3)
        one, other = made["plotData"]["data"][0]["data"]
        self.assertEqual((one["name"], other["name"], one["y"][0]), ("cell 1", "cell 2", 0))

    def test_frames_of_one_interval_and_a_last_one_that_comes_sooner(self):
        self.assertEqual(fields.evenly(np.array([0.0, 3.0, 6.0, 8.0])), (3, 3.0))
        self.assertEqual(fields.evenly(np.array([0.0, 3.0, 5.0, 8.0])), (2, 3.0))
        self.assertEqual(fields.evenly(np.array([4.0])), (1, 0.0))
        uneven = matrigrate.run(common.runs / "cell.toml", out="uneven", hours=0.02, overrides={"run.integrator": "reference", "output.report": False, "run.time_step": "0.4 s", "output.field_interval": "11.5 s"})
        with self.assertRaisesRegex(ValueError, "are not of one interval"):
            exchange.simularium(uneven, "none.simularium")
        self.assertFalse((self.folder / "none.simularium").exists())


if __name__ == "__main__":
    unittest.main()
