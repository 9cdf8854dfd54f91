"""Files of tracks as people have them, whole and wrong; read-outs against closed forms; the same on both sides."""
import math
import subprocess
import unittest

import common
import matrigrate
import numpy as np
import pandas
from matrigrate import tracks

trackmate = """LABEL,ID,TRACK_ID,QUALITY,POSITION_X,POSITION_Y,POSITION_Z,POSITION_T,FRAME
Label,Spot ID,Track ID,Quality,X,Y,Z,T,Frame
Label,Spot ID,Track ID,Quality,X,Y,Z,T,Frame
,,,(quality),{length},{length},{length},{time},
"""


def walks(cells=3, steps=8, seed=1):
    return np.cumsum(np.random.default_rng(seed).normal(0, 2, (cells, steps, 2)), axis=1).round(3)


def walk_of_persistence(P, dt, steps, random):
    """A persistent random walk of persistence time P with speed 1: Ornstein-Uhlenbeck, in 20 steps an interval."""
    h, v, x = dt / 20, random.normal(0, math.sqrt(0.5), 2), np.zeros(2)
    decay = math.exp(-h / P)
    rows = [x]
    for _ in range(steps):
        for _ in range(20):
            x = x + v * h
            v = v * decay + random.normal(0, math.sqrt(0.5 * (1 - decay**2)), 2)
        rows.append(x)
    return np.array(rows)


class Files(common.InTemporaryFolder):
    def spots(self, length="(pixel)", time="(frame)", drop=()):
        text = trackmate.format(length=length, time=time)
        for k, walk in enumerate(walks()):
            for frame, (x, y) in enumerate(walk):
                if (k, frame) not in drop:
                    text += f"ID{frame},{frame},{k},5,{x},{y},0,{frame},{frame}\n"
        (self.folder / "spots.csv").write_text(text)

    def plain(self, header, row, name="plain.csv", cells=3, extra=""):
        lines = [row.format(k=k, n=n, x=x, y=y, t=120 * n) for k, walk in enumerate(walks(cells))
                 for n, (x, y) in enumerate(walk)]
        (self.folder / name).write_text("\n".join([header, *lines]) + "\n" + extra)
        return name

    def same(self, found, scale=1.0, interval=120):
        self.assertEqual((len(found), found.interval), (3, interval))
        for track, walk in zip(found.values(), walks(), strict=True):
            np.testing.assert_allclose(track, walk * scale, rtol=1e-12)

    def test_trackmate(self):
        self.spots()
        self.same(tracks.read("spots.csv", pixel=0.65, interval=120), 0.65)
        self.spots("(micron)", "(sec)")
        self.same(tracks.read("spots.csv"), 1.0, 1)
        self.spots("(micron)", "(min)")
        self.same(tracks.read("spots.csv"), 1.0, 60)

    def test_other_formats(self):
        self.same(tracks.read(self.plain("id,t,x,y", "{k},{t},{x},{y}"), pixel=1, time_unit="s"))
        self.same(tracks.read(self.plain("index,track_id,t,y,x", "0,{k},{n},{y},{x}"), pixel=0.5, interval=120), 0.5)
        self.same(tracks.read(self.plain("y;x;frame;particle", "{y};{x};{n};{k}"), pixel=1, interval=120))
        self.same(tracks.read(self.plain("track,t_s,x_um,y_um", "{k},{t},{x},{y}")))
        body = "".join("<particle nSpots='8'>" + "".join(
            f'<detection t="{n}" x="{x}" y="{y}" z="0"/>' for n, (x, y) in enumerate(walk)) + "</particle>"
            for walk in walks())
        (self.folder / "t.xml").write_text('<Tracks nTracks="3" spaceUnits="pixel" frameInterval="2.0" '
                                           f'timeUnits="min">{body}</Tracks>')
        self.same(tracks.read("t.xml", pixel=0.65), 0.65)

    def test_gaps_and_short_tracks_are_said(self):
        self.spots(drop=[(0, 3), (2, 4), (2, 5), (2, 6), (2, 7), (2, 3)])
        found = tracks.read("spots.csv", pixel=1, interval=60)
        self.assertEqual(len(found), 2)
        self.assertTrue(np.isnan(found["0"][3]).all())
        self.assertEqual(found.notes, ["1 track of fewer than 4 positions is left out",
                                       "1 position is missing within tracks; gaps are not filled"])
        self.assertEqual(len(found.table()), 15)

    def refused(self, words, file, line=None, **options):
        before = sorted(self.folder.iterdir())
        with self.assertRaises(matrigrate.ConfigurationError) as caught:
            tracks.read(file, **options)
        self.assertIn(words, str(caught.exception))
        self.assertIn(file, str(caught.exception))
        if line is not None:
            self.assertIn(line, [fault.line for fault in caught.exception.faults])
        self.assertEqual(sorted(self.folder.iterdir()), before, "nothing is written")
        return caught.exception.faults

    def test_units(self):
        self.spots()
        faults = self.refused("POSITION_X and POSITION_Y are in pixel: give pixel=UM", "spots.csv")
        self.assertEqual(len(faults), 2, "length and time, at once")
        self.spots("(micron)", "(sec)")
        self.assertIn("the file says that POSITION_X is in micron; it is taken as 0.65 um per unit, as given",
                      tracks.read("spots.csv", pixel=0.65).notes)
        self.plain("id,t,x,y", "{k},{t},{x},{y}")
        self.refused("does not state the unit of x and y", "plain.csv", time_unit="s")
        self.refused("its unit is not stated: give time_unit=", "plain.csv", pixel=1, interval=1)

    def test_wrong_files(self):
        units = {"pixel": 1, "time_unit": "s"}
        row = "{k},{t},{x},{y}"
        self.refused("has no column for x", self.plain("id,t,east,y", row), 1, **units)
        for text in ("?", "1_000", "\uff11", "1e999", "inf"):
            self.refused(f'x: "{text}" is no finite number', self.plain("id,t,x,y", row, extra=f"0,9600,{text},2\n"), 26, **units)
        self.refused("has 3 fields, the header 4", self.plain("id,t,x,y", row, extra="0,9600,2\n"), 26, **units)
        self.refused("step of 60 s, most have 120 s", self.plain("id,t,x,y", row, extra="2,900,1,2\n"), 26, **units)
        self.refused("two positions at 840 s", self.plain("id,t,x,y", row, extra="2,840,1,2\n"), 26, **units)
        self.refused("spans", self.plain("id,t,x,y", row, extra="2,1200000000,1,2\n"), 26, **units)
        slow = "".join(f"9,{240 * n},{n},0\n" for n in range(12))
        self.refused("has steps of 240 s and more", self.plain("id,t,x,y", row, extra=slow), 27, **units)
        self.refused("has 1 track of at least 4 positions", self.plain("id,t,x,y", row, cells=1), **units)
        self.refused("no track moves", self.plain("id,t,x,y", "{k},{t},1,2"), **units)
        (self.folder / "empty.csv").touch()
        self.refused("is empty", "empty.csv", **units)
        (self.folder / "model.xml").write_text("<TrackMate/>")
        self.refused("Export tracks to XML file", "model.xml", **units)
        with self.assertRaises(matrigrate.InputOutputError):
            tracks.read("nowhere.csv")

    def test_drift(self):
        random, steps = np.random.default_rng(3), np.arange(50)[:, None] * [0.5, -0.25]
        rows = [f"{k},{n},{x},{y}" for k in range(40)
                for n, (x, y) in enumerate(np.cumsum(random.normal(0, 0.2, (50, 2)), axis=0) + steps)]
        (self.folder / "d.csv").write_text("\n".join(["track,t_s,x_um,y_um", *rows]) + "\n")
        np.testing.assert_allclose(tracks.read("d.csv").drift()[-1], steps[-1], atol=1.0)
        still = tracks.read("d.csv", drift=True)
        np.testing.assert_allclose(still.drift()[-1], 0, atol=1e-9)
        self.assertIn("is taken away", still.notes[-1])

    def test_drift_of_few_tracks_is_none(self):
        walk = np.cumsum(np.random.default_rng(5).normal(0.5, 1, (60, 2)), axis=0)
        cells = tracks.Tracks({"long": walk, **{str(k): walk[:8] for k in range(5)}}, 120.0, [])
        np.testing.assert_allclose(cells.drift(), np.vstack([walk[:8], np.tile(walk[7], (52, 1))]) - walk[0], atol=1e-12)
        still = cells.without_drift()
        np.testing.assert_allclose(np.diff(still["long"][7:], axis=0), np.diff(walk[7:], axis=0), atol=1e-9)
        self.assertIn("6 tracks from 0 to 840 s; none from 840 to 7080 s", still.notes[-1])
        gaps = {name: np.vstack([track, np.full((3, 2), np.nan)]) for name, track in cells.items()}
        np.testing.assert_allclose(tracks.Tracks(gaps, 120.0, []).without_drift()["long"][:60], still["long"])
        with self.assertRaisesRegex(matrigrate.ConfigurationError, "at no time 5 of 4 tracks"):
            tracks.Tracks({str(k): walk for k in range(4)}, 120.0, []).without_drift()
        np.testing.assert_array_equal(tracks.Tracks({}, 120.0, []).drift(), [[0, 0]])
        with self.assertRaisesRegex(ValueError, r"positions must have the shape \(n, 2\)"):
            tracks.Tracks({"x alone": walk[:, :1]}, 120.0, []).drift()


class Frames(unittest.TestCase):
    def spots(self):
        rows = [(k, 300.0 * frame, x, y) for k, walk in enumerate(walks()) for frame, (x, y) in enumerate(walk)]
        return pandas.DataFrame(rows, columns=["who", "t_s", "x_um", "y_um"])

    def test_are_read_as_files_are(self):
        cells = tracks.from_frame(self.spots(), columns={"track": "who"})
        self.assertEqual((len(cells), cells.interval), (3, 300.0))
        for track, walk in zip(cells.values(), walks(), strict=True):
            np.testing.assert_allclose(track, walk, rtol=1e-12)

    def test_index_and_clock(self):
        spots = self.spots().rename(columns={"who": "cell"})
        plain = tracks.from_frame(spots)
        for indexed in (spots.set_index("cell"), spots.set_index(["cell", "t_s"]), spots.set_index("cell", drop=False),
                        spots.iloc[::-1]):
            np.testing.assert_array_equal(tracks.from_frame(indexed)["0"], plain["0"])
        clock = pandas.to_timedelta(spots["t_s"], unit="s")
        for times in (clock, pandas.Timestamp("2024-05-03 23:50") + clock, pandas.Timestamp("2024-05-03 23:50", tz="UTC") + clock):
            cells = tracks.from_frame(spots.drop(columns="t_s").assign(time=times))
            self.assertEqual(cells.interval, 300.0)
            np.testing.assert_array_equal(cells["0"], plain["0"])

    def test_wrong_ones_are_refused_in_words(self):
        with self.assertRaises(matrigrate.ConfigurationError) as caught:
            tracks.from_frame(self.spots())
        self.assertIn("the data frame", str(caught.exception))
        self.assertNotIn("frame.csv", str(caught.exception))
        with self.assertRaisesRegex(TypeError, "a data frame is expected"):
            tracks.from_frame("spots.csv")


class Suspects(unittest.TestCase):
    def cells(self, **changed):
        random = np.random.default_rng(3)
        found = {str(k): np.cumsum(random.normal(0, 1, (30, 2)), axis=0) + 100 * k for k in range(4)}
        return tracks.Tracks(found | changed, 120.0, [])

    def test_there_are_none_among_random_walks(self):
        self.assertEqual(len(self.cells().suspects()), 0)
        self.assertEqual(len(self.cells().pairs()), 6)

    def test_a_wrong_link_is_a_leap(self):
        torn = self.cells()["2"].copy()
        torn[10:] += 60.0
        found = self.cells(**{"2": torn}).suspects()
        self.assertEqual(list(found[["kind", "track", "t_s"]].itertuples(index=False, name=None)), [("leap", "2", 9 * 120.0)])
        self.assertAlmostEqual(found["value"][0], 60 * math.sqrt(2), delta=5)

    def test_a_cell_that_was_found_twice_is_a_double(self):
        again = self.cells()["1"][5:] + np.random.default_rng(1).normal(0, 0.2, (25, 2)) + 3
        found = self.cells(again=again).suspects()
        self.assertEqual(len(found), 0, "it begins at another time: the steps are others")
        late = tracks.Tracks(dict(self.cells()) | {"again": again}, 120.0, [], {"0": 0, "1": 0, "2": 0, "3": 0, "again": 600.0})
        found = late.suspects()
        self.assertEqual(list(found[["kind", "track", "other"]].itertuples(index=False, name=None)), [("double", "1", "again")])
        self.assertGreater(found["value"][0], 0.8)


class Readouts(unittest.TestCase):
    def of(self, walks, dt=60.0, **options):
        return tracks.Tracks({str(k): walk for k, walk in enumerate(walks)}, dt, []).readouts(**options)["value"]

    def test_the_speed_from_start_to_end_is_the_read_out_of_the_run(self):
        run = matrigrate.load(common.runs / "run")
        of_tracks = tracks.of(run).readouts(resamples=0)["value"]
        self.assertAlmostEqual(of_tracks.v_migr_abs_um_per_h, run.readouts.v_migr_abs_um_per_h, places=9)

    def test_straight_and_right_angled(self):
        line = np.column_stack([np.arange(41.0), np.zeros(41)])
        straight = self.of([line])
        self.assertAlmostEqual(straight.speed_um_per_h, 60)
        self.assertAlmostEqual(straight.v_migr_abs_um_per_h, 60)
        self.assertAlmostEqual(straight.straightness, 1)
        self.assertAlmostEqual(straight.msd_slope_long, 2)
        self.assertAlmostEqual(straight.turning_cosine, 1)
        self.assertTrue(math.isnan(straight.persistence_min), "a straight path cannot tell it")
        square = np.array([[0, 0], [1, 0], [1, 1], [0, 1], [0, 0]], float)
        around = self.of([square])
        self.assertAlmostEqual(around.turning_angle_deg, 90)
        self.assertAlmostEqual(around.straightness, 0)

    def test_persistence_of_a_walk_of_known_persistence(self):
        random = np.random.default_rng(5)
        found = self.of([walk_of_persistence(600.0, 120.0, 120, random) for _ in range(60)], 120.0, resamples=0)
        self.assertAlmostEqual(found.persistence_min, 10, delta=1.5)
        self.assertAlmostEqual(found.anisotropy, 1.4, delta=0.5)
        self.assertGreater(found.msd_slope_short, found.msd_slope_long)

    def test_diffusion(self):
        random = np.random.default_rng(6)
        walks = [np.cumsum(random.normal(0, 1, (200, 2)), axis=0) for _ in range(40)]
        found = self.of(walks, resamples=0)
        self.assertAlmostEqual(found.msd_slope_short, 1, delta=0.05)
        self.assertAlmostEqual(found.turning_angle_deg, 90, delta=2)
        self.assertTrue(math.isnan(found.persistence_min), "diffusion has none")
        stretched = self.of([walk * [3, 1] for walk in walks], resamples=0)
        self.assertAlmostEqual(stretched.anisotropy, 9, delta=1)

    def test_error_of_localisation(self):
        random = np.random.default_rng(7)
        walks = [np.cumsum(random.normal(0, 1, (200, 2)), axis=0) for _ in range(40)]
        seen = [walk + random.normal(0, 0.7, walk.shape) for walk in walks]
        self.assertLess(self.of(seen, resamples=0).msd_slope_short, 0.8)
        self.assertAlmostEqual(self.of(seen, resamples=0, error=0.7).msd_slope_short, 1, delta=0.05)

    def test_an_error_larger_than_the_steps_defines_nothing(self):
        random = np.random.default_rng(2)
        walks = np.cumsum(random.normal(0, 1.4, (12, 60, 2)), axis=1)
        cells = tracks.Tracks({str(k): walk for k, walk in enumerate(walks)}, 60.0, [])
        self.assertTrue(np.isfinite(cells.readouts()["value"]["msd_slope_long"]))
        found = cells.readouts(error=1.05)["value"]
        self.assertTrue(found[["persistence_min", "msd_slope_short", "msd_slope_long"]].isna().all())
        self.assertTrue(np.isfinite(found["speed_um_per_h"]))
        cells.readouts(error=1.05)
        self.assertEqual(len(cells.notes), 1, "said once")
        self.assertRegex(cells.notes[0], r"^MSD at one interval, 4.09 um2, is below 4 error\^2 = 4.41 um2: the error is larger than the "
                                         "cells move")

    def test_positions_too_far_apart_and_wrong_errors(self):
        walks = {"a": np.array([[0.0, 0], [1, 1], [1e308, 2], [3, 3]]), "b": np.cumsum(np.ones((4, 2)), axis=0)}
        cells = tracks.Tracks(walks, 60.0, [])
        for call in (cells.readouts, cells.msd, lambda: cells.covariance(["straightness"])):
            with self.assertRaisesRegex(matrigrate.ConfigurationError, "track a: positions reach 1e\\+308 um; read-outs are defined up to"):
                call()
        near = tracks.Tracks({"b": walks["b"]}, 60.0, [])
        with self.assertRaisesRegex(TypeError, "error is a string; a number of um is expected"):
            near.readouts(error="x")
        with self.assertRaisesRegex(matrigrate.ConfigurationError, "error: -1 um is no localisation error"):
            near.readouts(error=-1)

    def test_standard_errors_cover(self):
        """Of 100 samples of 20 cells the mean lies within two standard errors of the truth in about 95."""
        inside = 0
        for seed in range(100):
            random = np.random.default_rng(seed)
            lines = [np.outer(np.arange(5.0), [random.normal(10, 2), 0]) for _ in range(20)]
            found = tracks.Tracks(dict(enumerate(lines)), 3600.0, []).readouts(resamples=100).loc["speed_um_per_h"]
            inside += abs(found["value"] - 10) < 2 * found["standard_error"]
        self.assertGreaterEqual(inside, 85)
        self.assertLess(inside, 100)


class BothSides(common.InTemporaryFolder):
    def test_exported_and_own_tables_agree(self):
        for name in ("run", "pair"):
            out = self.folder / name
            subprocess.run([common.program, "export", common.runs / name, "--tracks", "--output", out], check=True,
                           capture_output=True)
            own = tracks.of(matrigrate.load(common.runs / name), interval=120).readouts(resamples=0)["value"]
            self.assertTrue(math.isfinite(own["speed_um_per_h"]))
            for file in ("tracks_celltrackr.csv", "tracks_trackmate.csv", "tracks_trackmate.xml"):
                read = tracks.read(out / file, fewest=1).readouts(120, resamples=0)["value"]
                np.testing.assert_allclose(read.to_numpy(), own.to_numpy(), rtol=1e-9, err_msg=f"{name} {file}")

    def test_study(self):
        study = tracks.of(matrigrate.load_study(common.runs / "study"))
        self.assertEqual(len(study), 4)
        found = study.readouts()
        self.assertTrue((found["standard_error"].dropna() >= 0).all())
        self.assertFalse(found["meaning"].isna().any())

    def test_wrong_use(self):
        run = matrigrate.load(common.runs / "run")
        with self.assertRaisesRegex(matrigrate.ConfigurationError, "90 s is no whole multiple of its interval, 60 s"):
            tracks.of(run, interval=90)
        with self.assertRaises(TypeError):
            tracks.of("run")


if __name__ == "__main__":
    unittest.main()
