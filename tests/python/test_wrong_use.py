"""Wrong types, missing files and damaged ones: each is an exception that says what is wrong, and names the file."""
import doctest
import json
import os
import shutil
import unittest

import common
import h5py
import matrigrate
import numpy as np
from matrigrate import Scenario

_run, _study = matrigrate.load(common.runs / "run"), matrigrate.load_study(common.runs / "study")


class WrongTypes(common.InTemporaryFolder):
    def test_of_arguments(self):
        file = str(common.runs / "cell.toml")
        for use, words in (
                (matrigrate.load, "folder is a number; the path of a run is expected"),
                (matrigrate.load_study, "folder is a number; the path of a study is expected"),
                (matrigrate.Runs, "folder is a number"), (matrigrate.Fields, "file is a number"),
                (matrigrate.Readouts, "values is a number; a dictionary of read-outs"),
                (lambda v: _study.table(v), "name is a number; the name of a table"),
                (lambda v: _run.fields.nearest(str(v)), r"t is a string; a number \[s\] is expected"),
                (Scenario, "values is a number; a dictionary of parameters"), (Scenario.load, "file is a number"),
                (Scenario.preset, "name is a number; the name of a preset"), (Scenario().save, "file is a number"),
                (lambda v: Scenario(name=v), "name is a number"), (lambda v: Scenario().copy(v), "name is a number"),
                (lambda v: Scenario()[v], 'path is a number; a name such as "ecm.youngs_modulus" is expected'),
                (lambda v: Scenario().help(v), "path is a number"), (lambda v: Scenario().unit(v), "path is a number"),
                (lambda v: Scenario({v: v}), "path is a number"),
                (lambda v: matrigrate.run(v, out="x"), "scenario is a number; a Scenario or the path of a file"),
                (lambda v: matrigrate.run(file, out=v), "out is a number"),
                (lambda v: matrigrate.run(file, out="x", overrides=v), "overrides is a number; a dictionary"),
                (lambda v: matrigrate.run(file, out="x", progress=v), "progress is a number; a function"),
                (matrigrate.run_study, "file is a number; the path of a study file"),
                (lambda v: matrigrate.run_study("x.toml", out=v), "out is a number"),
                (matrigrate.plot.path, "run is a number; a Run is expected"), (matrigrate.plot.frame, "run is a number"),
                (matrigrate.plot.boxes, "study is a number; a Study"), (matrigrate.plot.msd, "a Run or a Study is expected")):
            with self.subTest(words), self.assertRaisesRegex(TypeError, words):
                use(3)
        with self.assertRaisesRegex(IndexError, "frame 99: there are 7 frames"):
            _run.fields.frame(99)
        self.assertEqual(list(self.folder.iterdir()), [], "nothing was written")

    def test_of_options_of_the_program(self):
        for options, error, words in (({"seed": "x"}, matrigrate.ConfigurationError, "--seed"),
                                      ({"hours": -1}, matrigrate.ConfigurationError, "--hours: run.duration"),
                                      ({"hours": float("nan")}, matrigrate.ConfigurationError, "--hours: run.duration"),
                                      ({"threads": "x"}, matrigrate.UsageError, "--threads"),
                                      ({"wall_time": "soon"}, matrigrate.UsageError, '"soon" is not a time'),
                                      ({"overrides": {"ecm.radius": None}}, matrigrate.ConfigurationError, "ecm.radius"),
                                      ({"overrides": {3: 4}}, matrigrate.ConfigurationError, "3: there is no such parameter")):
            with self.subTest(words), self.assertRaisesRegex(error, words):
                matrigrate.run(common.runs / "cell.toml", out="x", **options)
        with self.assertRaisesRegex(matrigrate.UsageError, "--jobs"):
            matrigrate.run_study("none.toml", jobs="x")
        with self.assertRaisesRegex(matrigrate.InputOutputError, "none.toml: cannot be read"):
            matrigrate.run_study("none.toml")
        self.assertEqual(list(self.folder.iterdir()), [], "nothing was written")


class Damage(common.InTemporaryFolder):
    def setUp(self):
        super().setUp()
        shutil.copytree(common.runs / "run", "run")
        self.run_ = self.folder / "run"

    def refused(self, words, action):
        with self.subTest(words), self.assertRaises(matrigrate.InputOutputError) as caught:
            action()
        self.assertIn(words, str(caught.exception))

    def everything(self):
        """All that a run holds, read; the exceptions."""
        run, met = matrigrate.load("run"), []
        for read in (lambda: run.tracks, lambda: run.protrusions, lambda: run.health, lambda: run.msd,
                     lambda: repr(run.readouts), lambda: run.scenario, lambda: repr(run), lambda: run.status,
                     lambda: [run.fields[name][...] for name in run.fields], lambda: run.fields.anchors,
                     lambda: run.fields.protrusions, lambda: run.fields.frame(-1)):
            try:
                read()
            except matrigrate.MatrigrateError as error:
                met.append(str(error))
        return met

    def test_missing_files(self):
        self.assertEqual(self.everything(), [])
        for name in ("tracks.csv", "protrusions.csv", "health.csv", "msd.csv", "summary.json", "scenario.resolved.toml"):
            (self.run_ / name).rename("kept")
            self.assertEqual(self.everything(), [f"run: has no {name} (the run is done)"])
            os.rename("kept", self.run_ / name)
        (self.run_ / "fields.h5").unlink()
        self.assertTrue(all("run: has no fields.h5" in words for words in self.everything()))

    def test_truncation_anywhere(self):
        for name in ("tracks.csv", "protrusions.csv", "health.csv", "summary.json", "scenario.resolved.toml", "run.json", "fields.h5"):
            whole = (self.run_ / name).read_bytes()
            for share in (0.0, 0.1, 0.5, 0.95):
                (self.run_ / name).write_bytes(whole[:int(share * len(whole))].rstrip(b"\n"))
                with self.subTest(name, share=share):
                    try:
                        met = self.everything()
                    except matrigrate.InputOutputError as error:
                        met = [str(error)]
                    if name != "scenario.resolved.toml":  # the beginning of one may be whole
                        self.assertTrue(met)
                    self.assertTrue(all(name in words and "is damaged" in words for words in met), met)
            (self.run_ / name).write_bytes(whole)

    def test_bytes_of_fields_changed(self):
        whole, draw = (self.run_ / "fields.h5").read_bytes(), np.random.default_rng(1)
        for _ in range(12):
            damaged = bytearray(whole)
            for at in draw.integers(0, len(whole), 50):
                damaged[at] ^= 0xff
            (self.run_ / "fields.h5").write_bytes(damaged)
            self.assertTrue(all("fields.h5" in words for words in self.everything()))

    def test_contents_that_do_not_fit(self):
        record = json.loads((self.run_ / "run.json").read_text())
        (self.run_ / "run.json").write_text(json.dumps(record | {"seed": "one"}))
        self.refused("its seed is no whole number", lambda: matrigrate.load("run"))
        (self.run_ / "run.json").write_text(json.dumps(record))
        (self.run_ / "summary.json").write_text('{"f_mat": "much"}')
        self.refused("f_mat is no number", lambda: matrigrate.load("run").readouts)
        for cells, words in ((3, "no list of read-outs"), ([], "no list of read-outs"), ([1], "no list of read-outs"),
                             ([{"cell": 1, "f_mat": "x"}], "f_mat is no number"), ([{"f_mat": 1}], "not numbered from 1"),
                             ([{"cell": 1, "a": 1}, {"cell": 2, "b": 1}], "the same read-outs")):
            (self.run_ / "summary.json").write_text(json.dumps({"cells": cells}))
            self.refused(words, lambda: matrigrate.load("run").readouts)
        with h5py.File(self.run_ / "fields.h5", "r+") as file:
            file["anchors/frame"][0] = 99
        self.refused("anchors do not fit its frames", lambda: matrigrate.load("run").fields.anchors)
        for time in (3.0, None):
            with h5py.File(self.run_ / "fields.h5", "r+") as file:
                del file["time"]
                file.create_group("time") if time is None else file.create_dataset("time", data=time)
            self.refused("no file of frames", lambda: matrigrate.load("run").fields)

    def test_studies(self):
        shutil.copytree(common.runs / "study", "study")
        whole = (self.folder / "study" / "results.csv").read_text()
        for text, words in (("", "is empty"), (whole[:-5], "is cut short"), ("a,b\n1,2\n", "lacks columns")):
            (self.folder / "study" / "results.csv").write_text(text)
            for read in (lambda study: study.results, lambda study: study.points, lambda study: study.tracks(),
                         lambda study: study.parameters, matrigrate.plot.boxes):
                self.refused(words, lambda read=read: read(matrigrate.load_study("study")))
        (self.folder / "study" / "results.csv").write_text(whole)
        study = matrigrate.load_study("study")
        name = next(iter(study.runs))
        with self.assertRaisesRegex(KeyError, "there is no such run"):
            study.runs["none"]
        (self.folder / "study" / "runs" / name / "run.json").write_text("{")
        self.refused("is damaged: it is no JSON", lambda: study.runs[name])
        self.refused("is damaged: it is no JSON", study.tracks)


def load_tests(_, tests, __):
    tests.addTests(doctest.DocTestSuite(matrigrate.base.arguments))
    return tests


if __name__ == "__main__":
    unittest.main()
