"""Runs and studies as Python reads them, whole, unfinished and damaged."""
import doctest
import fcntl
import importlib
import json
import math
import shutil
import unittest

import common
import h5py
import matrigrate
import numpy as np
import pandas


class Runs(unittest.TestCase):
    run_ = matrigrate.load(common.runs / "run")

    def test_tracks_are_those_of_the_file(self):
        lines = (common.runs / "run" / "tracks.csv").read_text().splitlines()
        tracks = self.run_.tracks
        self.assertEqual(list(tracks.columns), lines[0].split(","))
        self.assertEqual(len(tracks), len(lines) - 1)
        self.assertEqual(tracks["x_um"].iloc[-1], float(lines[-1].split(",")[2]), "to the last bit")
        self.assertEqual(str(tracks["n_growing"].dtype), "int64")
        self.assertTrue(math.isnan(tracks["polarization_rad"].iloc[0]))
        self.assertEqual(tracks.attrs["units"]["area_um2"], "um^2")

    def test_other_tables(self):
        self.assertEqual(list(self.run_.protrusions["id"]), list(range(1, len(self.run_.protrusions) + 1)))
        self.assertIn("fastest_um_per_s", self.run_.health)
        self.assertEqual(list(self.run_.msd.columns), ["lag_s", "msd_um2", "samples"])

    def test_readouts(self):
        written = json.loads((common.runs / "run" / "summary.json").read_text())
        self.assertEqual(set(self.run_.readouts), set(written))
        self.assertEqual(self.run_.readouts.v_migr_abs_um_per_h, written["v_migr_abs_um_per_h"])
        self.assertTrue(math.isnan(self.run_.readouts["path_angle_deg"]))
        self.assertEqual(self.run_.readouts.unit("v_migr_path_60s_um_per_h"), "um/h")
        self.assertNotIn("nothing", self.run_.readouts)
        with self.assertRaises(AttributeError):
            self.run_.readouts.nothing
        of_groups = {"parting_index", "share_in_contact", "nearest_um", "order"}
        for name in written:
            self.assertNotEqual(matrigrate.meaning(name), name, "a read-out without a meaning")
            there_is_none = "uniaxial fibres" in matrigrate.meaning(name) or name in of_groups
            self.assertEqual(f"{name} " in repr(self.run_.readouts), not there_is_none, name)

    def test_readouts_of_several_cells(self):
        pair = matrigrate.load(common.runs / "pair")
        table = pandas.read_csv(common.runs / "pair" / "summary.csv")
        readouts = pair.readouts
        self.assertEqual((list(readouts), readouts.names), ([1, 2], list(self.run_.readouts)))
        self.assertEqual(readouts[2].v_migr_abs_um_per_h, readouts.v_migr_abs_um_per_h[1])
        for name in readouts.names:
            np.testing.assert_allclose(readouts[name], table[name].to_numpy(float), rtol=1e-12)
        self.assertEqual((readouts.unit("l_prot_um"), readouts.meaning("f_mat")), ("um", "maturation of protrusions, mean"))
        self.assertIn("speed, start to end", repr(readouts).splitlines()[2])
        self.assertNotIn("uniaxial", repr(readouts))
        for wrong, error in ((lambda: readouts[3], KeyError), (lambda: readouts.speed, AttributeError),
                             (lambda: readouts["speed"], KeyError)):
            with self.assertRaises(error):
                wrong()

    def test_cells_of_a_run(self):
        pair = matrigrate.load(common.runs / "pair")
        self.assertEqual(list(pair.cells), [1, 2])
        self.assertEqual(sum(len(cell.tracks) for cell in pair.cells.values()), len(pair.tracks))
        second = pair.cells[2]
        self.assertEqual(set(second.tracks["track"]), {2})
        self.assertEqual(list(second.tracks["x_um"]), list(pair.tracks["x_um"][pair.tracks["track"] == 2]))
        self.assertEqual(list(second.protrusions["id"]),
                         list(pair.protrusions["id"][pair.protrusions["cell"] == 2]))
        self.assertGreater(len(second.protrusions), 0)
        self.assertEqual(list(second.msd["msd_um2"]), list(pair.msd["msd_um2"][pair.msd["cell"] == 2]))
        self.assertEqual(second.tracks.attrs["units"], pair.tracks.attrs["units"])
        self.assertEqual(dict(second.readouts), dict(pair.readouts[2]))
        self.assertGreater(second.outline()[:, 0].mean(), 0)
        self.assertLess(pair.cells[1].nucleus(0)[:, 0].mean(), 0)
        self.assertIn("cell 2 of Run(", repr(second))
        with self.assertRaisesRegex(KeyError, "3; the cells are 1, 2"):
            pair.cells[3]
        only, = self.run_.cells.values()
        self.assertEqual((len(only.tracks), len(only.msd)), (len(self.run_.tracks), len(self.run_.msd)))
        self.assertEqual(only.readouts.f_mat, self.run_.readouts.f_mat)
        with self.assertRaises(KeyError):
            only.nucleus()

    def test_readouts_of_a_group_are_those_of_the_study(self):
        study = matrigrate.load_study(common.runs / "pairs")
        for row in study.results.to_dict("records"):
            readouts = study.runs[row["run"]].group_readouts
            self.assertEqual(set(readouts), {"parting_index", "share_in_contact", "nearest_um", "order"})
            for name, value in readouts.items():
                np.testing.assert_allclose(value, row[name], rtol=1e-9, err_msg=name)
        self.assertIn("cosine", readouts.meaning("parting_index"))
        with self.assertRaisesRegex(matrigrate.InputOutputError, "it is a run of one"):
            self.run_.group_readouts

    def test_group(self):
        group = matrigrate.load(common.runs / "pair").group
        self.assertEqual(list(group["t_s"]), list(self.run_.tracks["t_s"][:len(group)]))
        self.assertEqual(group.attrs["units"]["speed_um_per_h"], "um/h")
        with self.assertRaisesRegex(matrigrate.InputOutputError, "has no group.csv, which runs of several cells have"):
            self.run_.group

    def test_record_scenario_status(self):
        self.assertEqual(self.run_.status, "done")
        self.assertEqual(self.run_.seed, 1)
        self.assertEqual(self.run_.scenario["ecm"]["radius"], "60 um")
        self.assertEqual(matrigrate.Scenario(self.run_.scenario).ecm.radius, 60.0)
        self.assertEqual(len(self.run_.trajectory_hash), 16)
        self.assertIn("done, 0.5 h, seed 1", repr(self.run_))

    def test_failed_run(self):
        failed = matrigrate.load(common.runs / "failed")
        self.assertEqual(failed.status, "failed")
        self.assertIn("clamped rim", failed.reason)
        self.assertEqual(failed.cause, "rim")
        self.assertGreater(len(failed.tracks), 0)
        self.assertGreater(len(failed.fields.times), 0)


class FieldsOfARun(unittest.TestCase):
    fields = matrigrate.load(common.runs / "run").fields

    def test_displacement_and_stress_are_there_at_all_times(self):  # as in S1 to S4 Videos of the paper
        np.testing.assert_allclose(self.fields.times, np.arange(0, 1801, self.fields.times[1]))
        solid = self.fields["matrix/f_degr"][...] > 0
        for name in ("displacement", "von_mises"):
            values = np.abs(self.fields[f"matrix/{name}"][...])
            self.assertTrue(np.isfinite(values[solid]).all(), name)
            self.assertTrue((values[1:].max(axis=tuple(range(1, values.ndim))) > 0).all(), name)

    def test_are_those_of_h5py(self):
        with h5py.File(common.runs / "run" / "fields.h5") as file:
            self.assertTrue(np.array_equal(self.fields.times, file["time"][:]))
            for name in self.fields:
                field = self.fields[name]
                self.assertTrue(np.array_equal(field[...], file[name][()], equal_nan=True), name)
                self.assertEqual(field.units, file[name].attrs["units"].decode())
            self.assertTrue(np.array_equal(np.asarray(self.fields["matrix/pressure"]), file["matrix/pressure"][()]))

    def test_frames(self):
        frame = self.fields.frame(-1)
        self.assertEqual(frame["outline/position"].shape, (235, 3))
        self.assertNotIn("matrix/reference", frame)
        self.assertEqual(self.fields.nearest(460.0), 2)
        self.assertEqual(len(self.fields["matrix/pressure"][:, 0]), len(self.fields.times))
        with self.assertRaises(KeyError):
            self.fields["matrix/pressur"]
        with self.assertRaises(IndexError):
            self.fields["matrix/pressure"][99]

    def test_nucleus_and_names_of_the_command_line(self):
        pair = matrigrate.load(common.runs / "pair").fields
        with h5py.File(pair.file) as file:
            np.testing.assert_array_equal(pair["nucleus/position"][...], file["nucleus/position"][()])
        self.assertEqual(pair["nucleus/position"].units, "um")
        self.assertEqual(pair.frame(0)["nucleus/position"].shape[1], 3)
        np.testing.assert_array_equal(pair["matrix/degradation"][-1], pair["matrix/f_degr"][-1])
        self.assertNotIn("matrix/degradation", list(pair))
        try:
            import xarray  # noqa: F401
        except ImportError:
            return
        self.assertEqual(pair.xarray()["nucleus_position"].dims, ("time", "nucleus", "axis"))

    def test_anchors_and_protrusions(self):
        self.assertGreater(len(self.fields.anchors), 0)
        self.assertEqual(list(self.fields.anchors.columns[:2]), ["frame", "t_s"])
        self.assertIn("position_x", self.fields.anchors)
        self.assertEqual(self.fields.protrusions.attrs["units"]["force"], "nN")

    def test_xarray(self):
        try:
            import xarray  # noqa: F401
        except ImportError:
            with self.assertRaisesRegex(ImportError, "python3-xarray"):
                self.fields.xarray()
            return
        data = self.fields.xarray()
        self.assertEqual(data["matrix_pressure"].dims, ("time", "matrix"))
        self.assertEqual(data["matrix_position"].attrs["units"], "um")
        self.assertEqual(float(data["time"][1]), 300.0)


class Studies(unittest.TestCase):
    study = matrigrate.load_study(common.runs / "study")

    def test_results(self):
        results = self.study.results
        self.assertEqual(list(results["label"]), ["=soft", "=soft", "NA", "NA"], "as in the study, not as guarded")
        self.assertEqual(self.study.parameters, ["ecm.youngs_modulus_Pa"])
        self.assertTrue(all(isinstance(value, str) for value in results["trajectory_hash"]))
        self.assertEqual(results.attrs["units"]["v_migr_abs_um_per_h"], "um/h")

    def test_points_and_statistics(self):
        self.assertEqual(self.study.points.to_dict("list"),
                         {"label": ["=soft", "NA"], "ecm.youngs_modulus_Pa": [50, 200], "runs": [2, 2], "done": [2, 2]})
        self.assertEqual(set(self.study.statistics["point_a"]), {"=soft"})
        self.assertEqual(set(self.study.groups["point"]), {"=soft", "NA"})
        self.assertEqual(set(self.study.table("paths")["point"]), {"=soft", "NA"})
        self.assertEqual(list(self.study.table("correlations")), ["readout_x", "readout_y", "n", "r", "p", "p_holm"])
        with self.assertRaisesRegex(matrigrate.InputOutputError, "has no effects.csv"):
            self.study.table("effects")

    def test_runs(self):
        self.assertEqual(set(self.study.runs), set(self.study.results["run"]))
        row = self.study.results.iloc[0]
        self.assertEqual(self.study.runs[row["run"]].trajectory_hash, row["trajectory_hash"])
        self.assertEqual(self.study.runs[row["run"]].readouts.n_protrusions, row["n_protrusions"])

    def test_all_tracks(self):
        tracks = self.study.tracks()
        self.assertEqual(list(tracks.columns[:6]),
                         ["run", "label", "ecm.youngs_modulus_Pa", "replicate", "seed", "track"])
        self.assertEqual(len(tracks), sum(len(run.tracks) for run in self.study.runs.values()))
        self.assertEqual(tracks["run"].nunique(), 4)
        self.assertEqual(tracks.attrs["units"]["x_um"], "um")
        exported = pandas.read_csv(common.runs / "exported" / "tracks.csv", keep_default_na=False, na_values=[""],
                                   float_precision="round_trip")
        exported["label"] = exported["label"].str.removeprefix("'")  # the guard against spreadsheets
        self.assertEqual(list(exported.columns), list(tracks.columns))
        pandas.testing.assert_frame_equal(exported, tracks, check_dtype=False, check_exact=True)
        self.assertEqual(len(self.study.protrusions()), int(self.study.results["n_protrusions"].sum()))


class WhatIsMissingOrDamaged(common.InTemporaryFolder):
    def setUp(self):
        super().setUp()
        shutil.copytree(common.runs / "run", "run")

    def refused(self, words, action):
        with self.assertRaises(matrigrate.InputOutputError) as caught:
            action()
        self.assertIn(words, str(caught.exception))
        self.assertIsNone(caught.exception.__cause__)

    def test_folders(self):
        (self.folder / "file").write_text("x")
        (self.folder / "empty").mkdir()
        for loads in (matrigrate.load, matrigrate.load_study):
            self.refused("no such folder", lambda loads=loads: loads("nowhere"))
        self.refused("is a file", lambda: matrigrate.load("file"))
        self.refused("no folder of a run", lambda: matrigrate.load("empty"))
        self.refused("no folder of a study", lambda: matrigrate.load_study("empty"))
        self.refused("matrigrate.load_study reads it", lambda: matrigrate.load(common.runs / "study"))
        self.refused("matrigrate.load reads it", lambda: matrigrate.load_study("run"))
        self.refused("study collect", lambda: setattr(self, "x", self.bare_study().results))

    def bare_study(self):
        (self.folder / "bare").mkdir(exist_ok=True)
        (self.folder / "bare" / "study.resolved.toml").touch()
        return matrigrate.load_study("bare")

    def test_damaged_files(self):
        run = self.folder / "run"
        whole = (run / "tracks.csv").read_bytes()
        for damage, words in ((b"", "is empty"), (whole[:-40], "is cut short"), (b"\xff\xfe", "no text"),
                              (whole + b"1,2\n", "has 2 fields"), (whole.replace(b"\n1,0,", b"\n1,x0,"), "column t_s")):
            (run / "tracks.csv").write_bytes(damage)
            self.refused(words, lambda: matrigrate.load("run").tracks)
        lines = whole.splitlines(keepends=True)
        for damage in (b"".join(lines[:-2]), b"".join(lines[:9]) + b"1," + lines[9].split(b",", 1)[1].replace(b",-", b",", 1) + b"".join(lines[10:])):
            self.assertFalse(damage == whole)
            (run / "tracks.csv").write_bytes(damage)
            self.refused("cut or changed since the run ended", lambda: matrigrate.load("run").tracks)
        summary = (run / "summary.json").read_text()
        (run / "summary.json").write_text(summary.replace("1", "2", 1))
        self.refused("cut or changed since the run ended", lambda: matrigrate.load("run").readouts)
        (run / "summary.json").write_text("{")
        self.refused("no JSON", lambda: matrigrate.load("run").readouts)
        (run / "scenario.resolved.toml").write_text("[")
        self.refused("no TOML", lambda: matrigrate.load("run").scenario)
        fields = (run / "fields.h5").read_bytes()
        for damage in (fields[:len(fields) // 2], b"", b"junk" * 999):
            (run / "fields.h5").write_bytes(damage)
            self.refused("is damaged", lambda: matrigrate.load("run").fields)
        with h5py.File(run / "fields.h5", "w") as file:
            file["other"] = 1
        self.refused("no file of frames", lambda: matrigrate.load("run").fields)
        (run / "run.json").write_text("[]")
        self.refused("holds no object", lambda: matrigrate.load("run"))
        (run / "run.json").write_text("{}")
        self.refused("no status", lambda: matrigrate.load("run"))

    def test_unfinished_run(self):
        run = self.folder / "run"
        record = json.loads((run / "run.json").read_text())
        (run / "run.json").write_text(json.dumps(record | {"status": "running", "exit_code": None}))
        (run / "fields.h5").rename(run / "fields.part")
        for name in ("msd.csv", "summary.json"):
            (run / name).unlink()
        whole = (run / "tracks.csv").read_text()
        (run / "tracks.csv").write_text(whole + "1,1860,3.2")  # a row that is being written
        loaded = matrigrate.load("run")
        self.assertEqual(loaded.status, "unfinished")
        self.assertEqual(len(loaded.tracks), whole.count("\n") - 1)
        self.refused("--fields writes the frames so far", lambda: loaded.fields)
        self.refused("has no summary.json (the run is unfinished)", lambda: loaded.readouts)
        with open(run / ".lock") as lock:
            fcntl.flock(lock, fcntl.LOCK_EX)
            self.assertEqual(loaded.status, "running")


def load_tests(_, tests, __):
    for name in ("results.results", "base.files", "errors"):
        tests.addTests(doctest.DocTestSuite(importlib.import_module(f"matrigrate.{name}")))
    return tests


if __name__ == "__main__":
    unittest.main()
