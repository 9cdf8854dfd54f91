"""Ground truth of a run: masks, fluorescence and tracks that agree with each other and with the run."""
import copy
import os
import shutil
import subprocess
import unittest

import common

common.skip_without("tifffile")

import matrigrate  # noqa: E402
import numpy as np  # noqa: E402
import tifffile  # noqa: E402

imagej = "/usr/share/java/ij.jar"
opened_by_imagej = """
setBatchMode(true);
open(getArgument());
getDimensions(width, height, channels, slices, frames);
getVoxelSize(x, y, z, unit);
print(width, height, channels, slices, frames, bitDepth(), x, y, unit.length, Stack.getFrameInterval());
for (c = 1; c <= channels; c++) {
  for (t = 1; t <= frames; t++) {
    if (Stack.isHyperstack) { Stack.setDisplayMode("grayscale"); Stack.setPosition(c, 1, t); } else setSlice(t);
    total = 0;
    for (row = 0; row < height; row++) for (column = 0; column < width; column++) total += getPixel(column, row);
    print(total);
  }
}
"""


class GroundTruth(common.InTemporaryFolder):
    pair = matrigrate.load(common.runs / "pair")
    movie = matrigrate.truth.Movie(pair, pixel=0.5)

    def test_masks_have_the_areas_and_places_of_the_cells(self):
        labels, tracks = self.movie.labels(), self.movie.tracks()
        self.assertEqual((str(labels.dtype), len(labels)), ("uint16", len(self.movie.frames)))
        self.assertEqual(set(np.unique(labels)), {0, 1, 2})
        for row in tracks.to_dict("records"):
            rows, columns = np.nonzero(labels[row["t"]] == row["track_id"])
            self.assertAlmostEqual(0.25 * len(rows) / row["area_um2"], 1.0, delta=0.02)
            self.assertAlmostEqual(rows.mean(), row["y"], delta=0.15)
            self.assertAlmostEqual(columns.mean(), row["x"], delta=0.15)

    def test_tracks_are_those_of_the_run(self):
        table = self.movie.tracks()
        for number, cell in self.pair.cells.items():
            own = table[table["track_id"] == number]
            track = cell.tracks.set_index("t_s").loc[own["t_s"]]
            np.testing.assert_allclose(own["area_um2"], track["area_um2"], rtol=1e-3)
            for t, k in zip(own["t_s"], self.movie.frames, strict=True):
                np.testing.assert_allclose(cell.outline(k).mean(axis=0), track.loc[t, ["x_um", "y_um"]].astype(float), atol=1e-3)
        data, properties, graph = self.movie.napari_tracks()
        self.assertEqual((data.shape, graph), ((len(table), 4), {}))
        self.assertTrue((np.diff(data[:, 0]) >= 0).all(), "napari wants them sorted by track")
        self.assertEqual({len(values) for values in properties.values()}, {len(table)})

    def test_fluorescence_is_of_cortex_and_matrix(self):
        pictures, labels = self.movie.fluorescence(seed=5), self.movie.labels()
        self.assertEqual((str(pictures.dtype), pictures.shape), ("uint16", (len(labels), 2, *labels.shape[1:])))
        cell = labels[0] == 1
        rows, columns = np.nonzero(cell)
        inside = (slice(int(rows.mean()) - 5, int(rows.mean()) + 5), slice(int(columns.mean()) - 5, int(columns.mean()) + 5))
        self.assertAlmostEqual(pictures[0, 0][inside].mean(), 10, delta=1.5)   # background alone
        self.assertAlmostEqual(pictures[0, 1][inside].mean(), 10, delta=1.5)
        far = pictures[0, 1][labels[0] == 0]
        self.assertAlmostEqual(np.median(far), 70, delta=5)                    # intact matrix, with the background
        edge = cell & ~(np.roll(cell, 1, 0) & np.roll(cell, -1, 0) & np.roll(cell, 1, 1) & np.roll(cell, -1, 1))
        self.assertGreater(pictures[0, 0][edge].mean(), 100)
        self.assertAlmostEqual(pictures[0, 0].max(), 210, delta=90)
        even = matrigrate.truth.Movie(self.pair, pixel=0.1, window=(-30, 0, -15, 15)).fluorescence(psf=0.4, background=0)
        self.assertAlmostEqual(np.quantile(even[0, 0], 0.999), 200, delta=45)  # a cortex, whatever the pixel

    def test_noise_is_that_of_the_seed(self):
        a, b = (self.movie.fluorescence(seed=3) for _ in range(2))
        np.testing.assert_array_equal(a, b)
        self.assertFalse(np.array_equal(a, self.movie.fluorescence(seed=4)))
        flat = self.movie.fluorescence(cortex=0, matrix=0, background=50).astype(float)
        self.assertAlmostEqual(flat.mean(), 50, delta=0.2)
        self.assertAlmostEqual(flat.var() / flat.mean(), 1.0, delta=0.02)  # of Poisson's distribution

    def test_files(self):
        names = [path.name for path in self.movie.save("truth", seed=2)]
        self.assertEqual(names, ["labels.tif", "fluorescence.tif", "tracks.csv"])
        labels = self.movie.labels()
        pictures = self.movie.fluorescence(seed=2)
        for name, axes, stack in (("labels", "TYX", labels), ("fluorescence", "TCYX", pictures)):
            with tifffile.TiffFile(f"truth/{name}.tif") as tiff:
                self.assertEqual((tiff.series[0].axes, len(tiff.pages)), (axes, np.prod(stack.shape[:-2])))
                np.testing.assert_array_equal(tiff.asarray(), stack)
                self.assertEqual({k: tiff.imagej_metadata[k] for k in ("unit", "finterval")}, {"unit": "um", "finterval": 300})
                ahead, per = tiff.pages[0].tags["XResolution"].value
                self.assertAlmostEqual(ahead / per, 2.0, msg="pixels per um")
                first, number = tiff.pages[0].dataoffsets[0], f"{tiff.byteorder}u2"
            # ImageJ reads one page after the other from where the first begins
            np.testing.assert_array_equal(np.fromfile(f"truth/{name}.tif", number, stack.size, offset=first), stack.ravel())
        read = matrigrate.tracks.read("truth/tracks.csv")
        own = self.movie.tracks()
        np.testing.assert_allclose(read["2"][:, 0] - read["2"][0, 0],
                                   (lambda x: x - x.iloc[0])(own.loc[own["track_id"] == 2, "x_um"]), atol=1e-6)
        with self.assertRaisesRegex(matrigrate.InputOutputError, "has labels.tif, fluorescence.tif, tracks.csv"):
            self.movie.save("truth")
        self.movie.save("truth", overwrite=True)

    @unittest.skipUnless(os.path.exists(imagej) and shutil.which("xvfb-run"), "needs imagej and xvfb")
    def test_files_open_in_imagej(self):
        self.movie.save("truth", seed=2)
        with open("open.ijm", "w") as macro:
            macro.write(opened_by_imagej)
        for name, stack in (("labels", self.movie.labels()[:, None]), ("fluorescence", self.movie.fluorescence(seed=2))):
            said = subprocess.run(["xvfb-run", "-a", "java", "-Duser.home=.", "-cp", imagej, "ij.ImageJ", "-batch", "open.ijm",
                                   os.path.abspath(f"truth/{name}.tif")], capture_output=True, text=True, timeout=120, check=False)
            frames, channels, rows, columns = stack.shape
            seen, *totals = said.stdout.split("\n")
            self.assertEqual(seen, f"{columns} {rows} {channels} 1 {frames} 16 0.5 0.5 2 300", said.stderr)
            np.testing.assert_array_equal([int(total) for total in totals if total], stack.sum(axis=(2, 3)).T.ravel())

    def test_frames_have_one_interval(self):
        def movie(*times):
            fields, run = copy.copy(self.pair.fields), copy.copy(self.pair)
            fields.times = np.array(times)  # the same frames at other times
            run.fields = fields
            return matrigrate.truth.Movie(run)

        even = movie(0.0, 12.5, 25.0, 37.5)
        self.assertEqual((even.interval, even.frames, even.left_out), (12.5, [0, 1, 2, 3], []))
        with self.assertWarnsRegex(UserWarning, "frame 3, the last one, at 180 s, is left out: it comes sooner than 70 s"):
            ended = movie(0.0, 70.0, 140.0, 180.0)
        self.assertEqual((ended.interval, ended.frames, ended.left_out), (70.0, [0, 1, 2], [3]))
        for times in ((0.0, 12.5, 25.0, 37.5, 50.0, 60.0, 72.5, 85.0, 100.0), (0.0, 5.0, 12.5), (0.0, 7.5, 15.0, 21.25, 30.0)):
            with self.assertRaisesRegex(matrigrate.ConfigurationError, "unevenly spaced.*output.field_interval is a multiple of run.time_step"):
                movie(*times)
        with self.assertRaisesRegex(matrigrate.ConfigurationError, "frame 5, at 60 s, where 62.5 s is expected"):
            movie(0.0, 12.5, 25.0, 37.5, 50.0, 60.0, 72.5, 85.0, 100.0)

    def test_wrong_use(self):
        for options, words in (({"pixel": 0.0}, "no width of a pixel"), ({"pixel": 1e-4}, "10\\^8 are the most")):
            with self.assertRaisesRegex(matrigrate.ConfigurationError, words):
                matrigrate.truth.Movie(self.pair, **options)
        with self.assertRaisesRegex(matrigrate.ConfigurationError, "psf: -1 is not 0 or more"):
            self.movie.fluorescence(psf=-1)
        with self.assertRaisesRegex(ValueError, "window"):
            matrigrate.truth.Movie(self.pair, window=3.0 - 4.0)


if __name__ == "__main__":
    unittest.main()
