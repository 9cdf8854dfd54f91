"""Files of tracks as people have them: cases from laboratories, the layouts of other programs (tests/layouts), read-outs beside
those of the program."""
import csv
import decimal
import json
import math
import pathlib
import re
import subprocess
import sys
import tarfile
import tempfile
import unittest

import common
import matrigrate
import motility
import numpy as np
from matrigrate import tracks

unpacked = tempfile.TemporaryDirectory()
folder = pathlib.Path(unpacked.name)
with tarfile.open(common.source / "tests" / "unit" / "tracks" / "files.tar") as archive:
    archive.extractall(folder)
sys.path.insert(0, str(common.source / "tests" / "layouts"))
import layouts  # noqa: E402
import reads  # noqa: E402


def speed(rows, interval, pixel=1.0):
    """[um/h] mean over tracks of the mean speed from position to position; rows of track, frame, x, y."""
    steps = {}
    for track, frame, x, y in sorted((row[0], *map(float, row[1:])) for row in rows):
        steps.setdefault(track, []).append((frame, x, y))
    means = [np.mean([math.dist(a[1:], b[1:]) for a, b in zip(at, at[1:]) if b[0] == a[0] + 1]) for at in steps.values()]
    return np.mean(means) * pixel / interval * 3600


def values(readouts):
    return [math.nan if one["value"] is None else one["value"] for one in readouts.values()]


def columns(file, names, separator=",", skip=0):
    lines = pathlib.Path(file).read_text(encoding="utf-8-sig").splitlines()[skip:]
    return [[row[name] for name in names] for row in csv.DictReader(lines, delimiter=separator)]


class Cases(common.InTemporaryFolder):
    """Files that people had, with what a reader must make of them."""

    def read(self, name, many, positions, value, every=120, missing=0, **told):
        cells = tracks.read(folder / name, **told)
        there = [np.isfinite(track[:, 0]) for track in cells.values()]
        self.assertEqual((len(cells), sum(map(np.count_nonzero, there))), (many, positions), name)
        self.assertEqual(sum(np.count_nonzero(~one) for one in there), missing, name)
        self.assertAlmostEqual(cells.interval, every, delta=1e-9 * every)
        found = cells.readouts(resamples=0)["value"]
        self.assertAlmostEqual(found["speed_um_per_h"], value, delta=1e-9 * value, msg=name)
        for note in cells.notes:
            self.assertIn(note, repr(cells))
        return cells

    def refused(self, words, name, **told):
        with self.assertRaises(matrigrate.ConfigurationError) as caught:
            tracks.read(folder / name, **told)
        self.assertRegex(str(caught.exception), words)
        self.assertNotIn("--", str(caught.exception), "arguments of Python are named, not options")
        return caught.exception

    def test_a_byte_order_mark(self):
        file = "bom.csv"
        rows = [[track, float(t) / 120, x, y] for track, t, x, y in columns(folder / file, ["track", "t_s", "x_um", "y_um"])]
        self.read(file, len({row[0] for row in rows}), len(rows), speed(rows, 120))
        study = self.folder / "study.toml"
        study.write_text('preset = "baseline"\nreplicates = 1\n[set]\nrun.duration = "3 min"\n[[targets]]\n'
                         f'readout = "v_migr_path_600s_um_per_h"\ntracks = "{folder / file}"\n')
        check = subprocess.run([common.program, "check", study], capture_output=True, encoding="utf-8")
        self.assertEqual(check.returncode, 0, check.stderr)

    def test_decimal_commas(self):
        rows = [[track, frame, x.replace(",", "."), y.replace(",", ".")] for track, x, y, frame in columns(
            folder / "comma_semicolons.csv", ["TRACK_ID", "POSITION_X", "POSITION_Y", "FRAME"], ";")]
        many = len({row[0] for row in rows})
        self.read("comma_semicolons.csv", many, len(rows), speed(rows, 120), pixel=1, interval=120)
        self.read("comma_tabs.csv", many, len(rows), speed(rows, 120))

    def test_made_up_positions(self):
        seen = columns(folder / "btrack_seen.csv", ["ID", "t", "x", "y"])
        value = speed(seen, 120)
        self.assertAlmostEqual(value, 54.25, delta=0.005)
        for name in ("btrack.csv", "btrack_blanks.txt", "btrack_seen.csv"):
            whole = name != "btrack_blanks.txt"
            if not whole:  # fewer tracks
                rows = [line.split() for line in (folder / "btrack_blanks.txt").read_text().splitlines()[1:]]
                made_up = sum(row[9] == "True" for row in rows)
                rows = [row[:4] for row in rows if row[9] == "False"]
                value, many, missing = speed(rows, 120), len({row[0] for row in rows}), made_up
            else:
                rows, value, many, missing = seen, speed(seen, 120), len({row[0] for row in seen}), 84
            cells = self.read(name, many, len(rows), value, missing=missing, pixel=1, interval=120)
            if whole:
                self.assertAlmostEqual(cells.readouts(resamples=0)["value"]["turning_cosine"], -0.136, delta=0.0005)
            if name == "btrack.csv":
                self.assertTrue(any("84" in note and "dummy" in note for note in cells.notes), cells.notes)

    def test_numbers_that_repeat_in_each_movie(self):
        rows = columns(folder / "celltrackscolab.csv", ["Unique_ID", "FRAME", "POSITION_X", "POSITION_Y"])
        self.read("celltrackscolab.csv", 12, len(rows), speed(rows, 120), pixel=1, interval=120)

    def test_other_encodings(self):
        utf8 = tracks.read(folder / "trackmate.csv")
        for name in ("trackmate_windows.csv", "trackmate_utf16.csv"):
            other = tracks.read(folder / name)
            self.assertEqual((list(other), other.interval), (list(utf8), utf8.interval))
            for track in utf8:
                np.testing.assert_array_equal(other[track], utf8[track])

    def test_a_division(self):
        error = self.refused("splits=\"cut\"", "dividing.csv")
        self.assertEqual(len(error.faults), 1, "one line for the track, not one for each time")
        rows = columns(folder / "dividing.csv", ["track", "t_s", "x_um", "y_um"])
        rows = [[track, float(t) / 120, x, y] for track, t, x, y in rows]
        times = [(row[0], row[1]) for row in rows]
        splits = {track for track, t in times if times.count((track, t)) > 1}
        self.assertEqual(len(splits), 1)
        whole = [row for row in rows if row[0] not in splits]
        dropped = self.read("dividing.csv", 5, len(whole), speed(whole, 120), splits="drop")
        self.assertTrue(any(re.search("1 ", note) for note in dropped.notes), dropped.notes)
        first = min(t for track, t in times if times.count((track, t)) > 1)
        before = [row for row in rows if row[0] not in splits or row[1] < first]
        self.read("dividing.csv", 6, len(before), speed(before, 120), splits="cut")

    def test_other_trackers(self):
        at = folder
        imaris = columns(at / "imaris.csv", ["TrackID", "Time", "Position X", "Position Y"], skip=3)
        manual = columns(at / "manual_tracking.txt", ["Track n\u00b0", "Slice n\u00b0", "X", "Y"], "\t")
        mosaic = columns(at / "mosaic.csv", ["Trajectory", "Frame", "x", "y"], "\t")
        blanks = [line.split() for line in (at / "spaces.txt").read_text().splitlines()]
        for name, rows in (("imaris.csv", imaris), ("manual_tracking.txt", manual), ("mosaic.csv", mosaic)):
            told = {"interval": 120} if name.startswith("imaris") else {"pixel": 0.5, "interval": 120}
            self.read(f"{name}", len({row[0] for row in rows}), len(rows),
                      speed(rows, 120, told.get("pixel", 1)), **told)
        self.refused("columns", "spaces.txt", pixel=1, time_unit="s")
        rows = [[row[1], float(row[2]) / 24, row[3], row[4]] for row in blanks]
        self.read("spaces.txt", len({row[0] for row in rows}), len(rows), speed(rows, 24), 24, pixel=1,
                  time_unit="s", columns={"track": 2, "t": 3, "x": 4, "y": 5})

    def test_seconds_are_no_frames(self):
        file = "celltrackr.csv"
        self.refused("time_unit", file, pixel=1, interval=24)
        rows = [[track, float(t) / 24, x, y] for track, t, x, y in columns(folder / file, ["id", "t", "x", "y"])]
        self.assertAlmostEqual(speed(rows, 24), 254.18, delta=0.005)
        self.read(file, len({row[0] for row in rows}), len(rows), speed(rows, 24), 24, pixel=1, time_unit="s")

    def test_time_stamps_scatter(self):
        rows = columns(folder / "jitter.csv", ["track", "frame", "x_um", "y_um"])
        cells = tracks.read(folder / "jitter.csv")
        self.assertEqual(len(cells), len({row[0] for row in rows}))
        self.assertAlmostEqual(cells.interval, 120, delta=1)
        self.assertAlmostEqual(cells.readouts(resamples=0)["value"]["speed_um_per_h"], speed(rows, cells.interval), delta=1e-6)
        self.assertTrue(cells.notes, "the scatter is said")
        self.refused("jitter", "jitter.csv", jitter=0.005)
        self.read("jitter.csv", len({row[0] for row in rows}), len(rows), speed(rows, 120), frame_interval=120)

    def test_an_uncalibrated_movie(self):
        rows = columns(folder / "uncalibrated.csv", ["TRACK_ID", "FRAME", "POSITION_X", "POSITION_Y"])[3:]
        value = speed(rows, 120, 0.65)
        self.assertAlmostEqual(value, 33.04, delta=0.005)
        self.read("uncalibrated.csv", len({row[0] for row in rows}), len(rows), value, pixel=0.65, interval=120)
        text = str(self.refused("frame_interval", "uncalibrated.csv", pixel=0.65))
        self.assertNotIn("leave it out", text)


class Layouts(common.InTemporaryFolder):
    """Each layout of the manifest: the reader of the package finds what the program finds, and what is right."""

    def setUp(self):
        super().setUp()
        for layout in layouts.layouts:
            (self.folder / layout.file).write_bytes(layout.bytes)

    def test_read(self):
        for layout in layouts.layouts:
            with self.subTest(layout.file):
                if layout.refused:
                    with self.assertRaises(matrigrate.ConfigurationError) as caught:
                        tracks.read(layout.file, **layout.told)
                    self.assertNotIn("--", str(caught.exception).replace("----", ""))
                    continue
                cells = tracks.read(layout.file, **layout.told)
                self.assertAlmostEqual(cells.interval, layout.interval)
                self.assertEqual(len(cells), layout.tracks)
                self.assertEqual(len(cells.table()), layout.positions)
                call = subprocess.run([common.program, "tracks", layout.file, "--json", "--resamples", "0",
                                       *reads.words_of(layout.told)], capture_output=True, encoding="utf-8")
                found = json.loads(call.stdout)
                self.assertEqual(cells.notes, found["notes"])
                own = cells.readouts(resamples=0)
                self.assertEqual(list(own.index), list(found["readouts"]))
                np.testing.assert_allclose(own["value"], values(found["readouts"]), rtol=1e-9, atol=1e-12)
                self.assertEqual(list(own["unit"]), [one["unit"] or "1" for one in found["readouts"].values()])
                self.assertEqual(list(own["meaning"]), [one["meaning"] for one in found["readouts"].values()])
                self.assertAlmostEqual(own["value"]["speed_um_per_h"], layout.speed, delta=1e-9 * layout.speed)

    def test_gaps_and_drift_as_the_program(self):
        random = np.random.default_rng(4)
        rows = ["track,t_s,x_um,y_um"]
        for cell in range(12):
            walk = np.cumsum(random.normal(0.3, 1, (40, 2)), axis=0)
            late = 30 if cell % 4 == 3 else 0  # out of step
            rows += [f"{cell},{60 * (frame + cell) + late},{x!r},{y!r}" for frame, (x, y) in enumerate(walk.tolist()) if random.random() > 0.05]
        (self.folder / "walks.csv").write_text("\n".join(rows) + "\n")
        for told, words in (({}, []), ({"drift": True}, ["--drift"])):
            call = subprocess.run([common.program, "tracks", "walks.csv", "--json", *words], capture_output=True, encoding="utf-8", check=True)
            found = json.loads(call.stdout)["readouts"]
            own = tracks.read("walks.csv", **told).readouts(resamples=0)["value"]
            np.testing.assert_allclose(own, values(found), rtol=1e-9, err_msg=str(told))

    def test_tracks_of_few_positions_and_of_none_define_little(self):
        walk = np.array([[0.0, 0], [1, 0], [1, 1], [3, 1]])
        late = np.vstack([np.full((2, 2), np.nan), walk])
        cells = tracks.Tracks({"walk": walk, "late": late, "one": walk[:1], "none": np.full((3, 2), np.nan)}, 60.0, [])
        alone = tracks.Tracks({"walk": walk}, 60.0, [])
        np.testing.assert_array_equal(cells.readouts(resamples=0)["value"], alone.readouts(resamples=0)["value"])
        self.assertEqual(cells.readouts()["value"]["speed_um_per_h"], 80.0)

    def test_read_outs_are_those_of_plain_numpy(self):
        random = np.random.default_rng(6)
        walks = {str(cell): np.cumsum(random.normal(0.2, 1, (25 + cell, 2)), axis=0) for cell in range(9)}
        for walk in walks.values():
            walk[1:-1][random.random(len(walk) - 2) < 0.1] = np.nan
        cells = tracks.Tracks(walks, 90.0, [])
        plain = motility.Parts(list(walks.values()), 90.0)
        for error in (0.0, 0.3, 5.0):
            np.testing.assert_allclose(cells.readouts(error=error, resamples=0)["value"], list(plain.readouts(error=error).values()), rtol=1e-9)
        np.testing.assert_allclose(cells.msd()["msd_um2"], plain.msd(), rtol=1e-12)
        drawn = [plain.readouts(random.integers(9, size=9)) for _ in range(400)]
        errors = cells.readouts(resamples=400)["standard_error"]
        for name in ("speed_um_per_h", "straightness", "msd_slope_short", "turning_cosine"):
            np.testing.assert_allclose(errors[name], np.std([one[name] for one in drawn]), rtol=0.3, err_msg=name)


class Arguments(common.InTemporaryFolder):
    def test_wrong_ones_get_words(self):
        (self.folder / "plain.csv").write_text(layouts.plain())
        for words, kind, told in (
                ("shortest is a string; a whole number is expected", TypeError, {"shortest": "x"}),
                ("fewest: 1.5 is no whole number of at least 1", matrigrate.ConfigurationError, {"fewest": 1.5}),
                ("pixel is a string; a number is expected", TypeError, {"pixel": "0.65"}),
                ("pixel: -1 is no positive number", matrigrate.ConfigurationError, {"pixel": -1}),
                ("pixel: inf is no positive number", matrigrate.ConfigurationError, {"pixel": math.inf}),
                ("jitter is an array; a number is expected", TypeError, {"jitter": [1]}),
                ("columns is a string; a dictionary of columns is expected", TypeError, {"columns": "track"}),
                ("columns['x'] is a number; the name of a column", TypeError, {"columns": {"x": 1.5}}),
                ("splits is a flag; a text is expected", TypeError, {"splits": True}),
                ("interval: is the older name of frame_interval", matrigrate.ConfigurationError, {"interval": 1, "frame_interval": 1})):
            with self.subTest(words), self.assertRaisesRegex(kind, re.escape(words)):
                tracks.read("plain.csv", **told)
        for told in ({"splits": "keep"}, {"layout": "trackmade"}, {"time_unit": "fortnight"}, {"columns": {"w": "x_um"}}):
            with self.subTest(told), self.assertRaises(matrigrate.ConfigurationError) as caught:
                tracks.read("plain.csv", **told)
            self.assertNotIn("--", str(caught.exception))
        half = tracks.read("plain.csv", pixel=0.5)
        for other in (np.array([[0.5]]), decimal.Decimal("0.5")):  # as files of other programs give it
            self.assertEqual(tracks.read("plain.csv", pixel=other).notes, half.notes)
        with self.assertRaisesRegex(TypeError, "pixel is of the type ndarray; a number is expected"):
            tracks.read("plain.csv", pixel=np.array([0.5, 1.0]))

    def test_a_calibration_can_be_overruled(self):
        (self.folder / "spots.csv").write_text(layouts.trackmate("(micron)", "(sec)", 1.0))
        cells = tracks.read("spots.csv", pixel=0.65, frame_interval=300)
        self.assertEqual(cells.interval, 300)
        self.assertAlmostEqual(cells.readouts(resamples=0)["value"]["speed_um_per_h"], layouts.speed * 0.65 * 120 / 300)
        self.assertEqual(cells.notes[:2], ["the file says that POSITION_X is in micron; it is taken as 0.65 um per unit, as given",
                                           "POSITION_T says 1 s from frame to frame; it is taken as 300 s, as given"])

    def test_tracks_out_of_step_keep_their_times(self):
        late = [f"{s.cell},{s.frame * 120 + (60 if s.cell == 2 else 0)},{s.x},{s.y}" for s in layouts.spots()]
        (self.folder / "late.csv").write_text("\n".join(["track,t_s,x_um,y_um", *late]) + "\n")
        cells = tracks.read("late.csv")
        table = cells.table()
        self.assertEqual(list(table[table["track"] == "2"]["t_s"]), [60.0 + 120 * k for k in range(layouts.pictures)])
        self.assertEqual(list(table[table["track"] == "1"]["t_s"]), [120.0 * k for k in range(layouts.pictures)])
        self.assertEqual(list(cells.every(240).table().groupby("track")["t_s"].first()), [0, 0, 60, 0])
        self.assertAlmostEqual(cells.readouts(resamples=0)["value"]["speed_um_per_h"], layouts.speed)


if __name__ == "__main__":
    unittest.main()
