"""Posteriors on emulators against a model whose parameters are known; what is refused, said and written."""
import math
import pathlib
import re
import sys
import unittest
import unittest.mock

import common

common.skip_without("scipy", "matplotlib")

import matrigrate  # noqa: E402
import numpy as np  # noqa: E402
import pandas  # noqa: E402
from matrigrate import calibrate, tracks  # noqa: E402
from matrigrate.fit import fit as _fit  # noqa: E402
from matrigrate.fit import conditions, measurement  # noqa: E402
from matrigrate.fit.emulator import Emulator  # noqa: E402
from matrigrate.fit.process import Process  # noqa: E402
from scipy.stats import qmc  # noqa: E402

cells = 12


def simulated(points, random, runs=1):
    """Speed and ratio tell a and b, with scatter that grows with a; no read-out tells c."""
    a, b = points["a"].to_numpy(), np.log(points["b"].to_numpy()) / 2
    scatter = random.normal(0, 1, (2, len(points))) / math.sqrt(runs)
    return pandas.DataFrame({"speed": 10 * a + 3 * b + (0.5 + 2 * a) * scatter[0], "ratio": b - 0.2 * a + 0.1 * scatter[1]})


def drawn(n, random):
    return pandas.DataFrame({"a": random.uniform(0, 1, n), "b": np.exp(random.uniform(0, 2, n)), "c": random.uniform(0, 1, n)})


def measured_at(truth, random):
    values = simulated(truth, random, cells).iloc[0]
    return {"speed": (values["speed"], (0.5 + 2 * truth["a"].iloc[0]) / math.sqrt(cells)),
            "ratio": (values["ratio"], 0.1 / math.sqrt(cells))}


def emulators(n=100, seed=3):
    random = np.random.default_rng(seed)
    parameters = drawn(n, random)
    return _fit.of_points(common.points_of(parameters, simulated(parameters, random)))


class OfAKnownModel(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.emulators = emulators()
        cls.random = np.random.default_rng(8)

    def test_intervals_contain_the_truth_as_often_as_they_say(self):
        inside, narrow = np.zeros(3), np.zeros(3)
        for _ in range(10):
            truth = drawn(1, self.random)
            table = self.emulators.fit(measured_at(truth, self.random)).table
            inside += [table.loc[k, "posterior_5"] <= truth[k].iloc[0] <= table.loc[k, "posterior_95"] for k in "abc"]
            narrow += (table["width"] < 0.8).to_numpy()
        self.assertGreaterEqual(inside.sum(), 0.7 * 30)
        self.assertGreaterEqual(min(narrow[:2]), 9, "a and b are constrained")
        self.assertEqual(narrow[2], 0, "nothing tells c")

    def test_what_the_data_cannot_tell_is_said(self):
        fit = self.emulators.fit({"speed": (7.0, 0.5), "ratio": (0.4, 0.03)})
        said = [note for note in fit.notes if note.startswith("the data cannot tell c: its 90 % interval is ")]
        self.assertEqual(len(said), 1)
        self.assertIn("no read-out depends on it", said[0])
        self.assertGreater(fit.plausible, 0.0)
        self.assertLess(fit.plausible, 0.3)

    def test_sobol_indices_are_those_of_the_model(self):
        """Of 10 a + 3 b with a and b uniform: 100 and 9 parts of 109."""
        rows = self.emulators.sensitivity.set_index(["readout", "parameter"])
        for parameter, share in (("a", 100 / 109), ("b", 9 / 109), ("c", 0.0)):
            for kind in ("first", "total"):
                self.assertAlmostEqual(rows.loc[("speed", parameter), kind], share, delta=0.08)
                self.assertLessEqual(rows.loc[("speed", parameter), f"{kind}_5"], rows.loc[("speed", parameter), f"{kind}_95"])

    def test_scatter_and_quality_of_emulators(self):
        speed = self.emulators.processes[0]
        low, high = np.sqrt(speed._process.of_run(np.array([[0.1, 0.5, 0.5], [0.9, 0.5, 0.5]])))
        self.assertGreater(high / low, 1.5, "0.7 and 2.3 in the model")
        for process in self.emulators.processes:
            self.assertGreater(process.explained, 0.6)
            self.assertGreater(process.coverage, 0.8)
        self.assertIn("speed: predicts ", repr(self.emulators))

    def test_the_prior_is_read_off_the_points(self):
        self.assertEqual(self.emulators.prior.is_log, [False, True, False])

    def test_cells_that_no_parameters_give(self):
        fit = self.emulators.fit({"speed": (60.0, 0.5), "ratio": (0.5, 0.03)})
        self.assertEqual(fit.plausible, 0.0)
        self.assertIn("no parameters within the ranges give such cells: speed is off by", "\n".join(fit.notes))
        wide = self.emulators.fit({"speed": (60.0, 0.5), "ratio": (0.5, 0.03)}, discrepancy={"speed": 100.0})
        self.assertGreater(wide.plausible, 0.0)

    def test_a_page_that_needs_no_other_file(self):
        with common.tempfile.TemporaryDirectory() as folder:
            fit = self.emulators.fit({"speed": (7.0, 0.5), "ratio": (0.4, 0.03)})
            page = fit.write(pathlib.Path(folder) / "fit")
            text = page.read_text()
            self.assertEqual(text.count("<svg"), 4)
            self.assertNotIn("http", text)
            for name in ("posterior", "readouts", "sensitivity", "sample"):
                self.assertGreater(len(pandas.read_csv(page.parent / f"{name}.csv")), 1)
            (page.parent / "mine.txt").write_text("kept")
            with self.assertRaisesRegex(matrigrate.InputOutputError, "exists already; give a new folder, or overwrite=True"):
                fit.write(page.parent)
            page.write_text("old")
            self.assertEqual(fit.write(page.parent, overwrite=True).read_text(), text)
            self.assertEqual((page.parent / "mine.txt").read_text(), "kept")
            with self.assertRaisesRegex(matrigrate.InputOutputError, "is no folder"):
                fit.write(page, overwrite=True)


class Honesty(unittest.TestCase):
    """Shares and intervals of emulators against fresh runs of functions that are known."""

    @staticmethod
    def known(signal, many, parameters, seed):
        """Points with values of a function with scatter 1, and fresh ones."""
        random = np.random.default_rng(seed)
        cube, fresh = qmc.LatinHypercube(parameters, seed=seed).random(many), random.random((400, parameters))
        runs = [signal * (at[:, 0] + np.sin(3 * at[:, 1])) + random.normal(0, 1, len(at)) for at in (cube, fresh)]
        return cube, runs[0], fresh, runs[1]

    def emulated(self, *known, seed):
        cube, values, fresh, runs = self.known(*known, seed)
        return Emulator(cube, values, np.ones(len(cube)), seed, linear=known[2] > 6), fresh, runs

    def inside(self, *known, seed):
        """Share of fresh runs in the intervals of 90 %."""
        cube, values, fresh, runs = self.known(*known, seed)
        mean, variance, of_run = Process(cube, (values - values.mean()) / values.std(), np.ones(len(cube)), seed, known[2] > 6)(fresh)
        return np.mean(np.abs((runs - values.mean()) / values.std() - mean) <= 1.645 * np.sqrt(variance + of_run))

    def test_noise_is_not_predicted(self):
        for many, parameters in ((40, 4), (64, 12)):
            found = [self.emulated(0.0, many, parameters, seed=seed) for seed in range(1, 6)]
            self.assertLess(np.mean([one[0].explained for one in found]), 0.05)
            self.assertLessEqual(sum(one[0].tells for one in found), 1)

    def test_a_signal_is_stated_as_fresh_runs_show_it(self):
        found = [self.emulated(3.0, 64, 4, seed=seed) for seed in range(1, 6)]
        stated = [one[0].explained for one in found]
        honest = [1 - np.mean((runs - emulator(fresh)[0])**2) / np.var(runs) for emulator, fresh, runs in found]
        self.assertTrue(all(one[0].tells for one in found))
        self.assertAlmostEqual(np.mean(stated), np.mean(honest), delta=0.1)

    def test_intervals_hold_nine_tenths_of_fresh_runs(self):
        for many, parameters, signal in ((40, 4, 0.0), (40, 4, 3.0), (64, 12, 0.0), (64, 12, 3.0), (128, 4, 1.0), (128, 12, 3.0)):
            with self.subTest(points=many, parameters=parameters, signal=signal):
                share = np.mean([self.inside(signal, many, parameters, seed=seed) for seed in range(1, 13)])
                self.assertTrue(0.87 <= share <= 0.93, share)


class Priors(unittest.TestCase):
    """One read-out that rises with a; b, where it is there, changes nothing."""

    @staticmethod
    def fitted(low, high, measured, prior=None, design=None, **more):
        random = np.random.default_rng(4)
        parameters = pandas.DataFrame({"a": np.linspace(low, high, 40), **more})
        values = pandas.DataFrame({"speed": 10 * parameters["a"] + random.normal(0, 0.2, 40)})
        process = _fit.of_points(common.points_of(parameters, values, design=design), prior)
        return process.fit({"speed": measured})

    def test_a_posterior_that_ends_at_a_bound_is_not_constrained_there(self):
        for measured, side, end in (((19.9, 1.0), "upper", "2"), ((10.1, 1.0), "lower", "1")):
            fit = self.fitted(1.0, 2.0, measured)
            self.assertIn(f"a: the posterior ends at the {side} bound of the prior, {end}: widen the range", fit.notes)
            self.assertEqual(fit.table.loc["a", "at_bound"], side)
            self.assertLess(fit.table.loc["a", "width"], 0.8)
            self.assertFalse(fit.table.loc["a", "constrained"])
        fit = self.fitted(1.0, 2.0, (15.0, 1.0))
        self.assertEqual(fit.notes, [])
        self.assertTrue(fit.table.loc["a", "constrained"])

    def test_ranges_are_those_of_the_design_whatever_became_of_its_runs(self):
        design = pandas.DataFrame({"a": np.linspace(1.0, 3.0, 60)})
        fit = self.fitted(1.0, 2.0, (15.0, 1.0), design=design)
        self.assertEqual(fit.prior.high[0], 3.0)
        self.assertIn("prior: a: 1 to 3 goes above the points with read-outs, 1 to 2: nothing is known there", "\n".join(fit.notes))

    def test_ranges_beyond_the_points_are_noted_or_refused(self):
        notes = "\n".join(self.fitted(1.0, 2.0, (15.0, 1.0), {"a": (0.5, 100)}).notes)
        self.assertIn("prior: a: 0.5 to 100 goes below and above the points with read-outs, 1 to 2: nothing is known there, and the "
                      "emulators extrapolate", notes)
        self.assertNotIn("extrapolate", "\n".join(self.fitted(1.0, 2.0, (15.0, 1.0), {"a": (0.98, 2.02)}).notes))
        for wrong in ((1, math.inf), (1, math.nan), "ab", 5, (2, 1), (0, 1, "log"), (1, 2, "lin"), ("1", "2"), None):
            with self.assertRaisesRegex(matrigrate.ConfigurationError, "prior: a: .* is no range .* of finite numbers"):
                self.fitted(1.0, 2.0, (15.0, 1.0), {"a": wrong})
        with self.assertRaisesRegex(matrigrate.ConfigurationError, "points reach down to -1, which has no logarithm"):
            self.fitted(-1.0, 2.0, (15.0, 1.0), {"a": (0.5, 2, "log")})
        with self.assertRaisesRegex(TypeError, "prior is a number; a dictionary of ranges is expected"):
            self.fitted(1.0, 2.0, (15.0, 1.0), 5)

    def test_a_parameter_that_does_not_vary_is_left_out(self):
        fit = self.fitted(1.0, 2.0, (15.0, 1.0), b=0.3)
        self.assertEqual(list(fit.table.index), ["a"])
        self.assertEqual(list(fit.sample.columns), ["a"])
        self.assertEqual(fit.notes, ["b: is 0.3 at all points with read-outs, so it is left out: nothing can be said of it"])
        with self.assertRaisesRegex(matrigrate.ConfigurationError, "prior: b: is 0.3 at all points, so no range can be fitted"):
            self.fitted(1.0, 2.0, (15.0, 1.0), {"b": (0, 1)}, b=0.3)


class OfTracks(unittest.TestCase):
    """Walks of a speed [um/min] and a spread of turning angles [rad]; no track tells the third."""

    @staticmethod
    def walks(speed, turning, n, random, start=0):
        angles = np.cumsum(random.normal(0, turning, (n, 40)), axis=1)
        steps = speed * random.gamma(4, 0.25, (n, 40, 1)) * np.stack([np.cos(angles), np.sin(angles)], axis=2)
        return tracks.Tracks({str(start + k): np.cumsum(one, axis=0) for k, one in enumerate(steps)}, 60.0, [])

    def test_tracks_tell_what_made_them(self):
        random = np.random.default_rng(2)
        parameters = pandas.DataFrame(random.uniform([0.5, 0.1, 0.0], [3.0, 1.0, 1.0], (60, 3)), columns=["speed", "turning", "idle"])
        seen = [self.walks(row.speed, row.turning, 1, random, k) for k, row in enumerate(parameters.itertuples())]
        names = ["speed_um_per_h", "turning_cosine"]
        values = pandas.DataFrame([one.readouts(resamples=0)["value"][names] for one in seen]).reset_index(drop=True)
        process = _fit.of_points(common.points_of(parameters, values, 40, seen))
        measured = self.walks(1.4, 0.6, 20, random)
        fit = process.fit(measured)
        self.assertEqual(list(fit.table["constrained"]), [True, True, False])
        self.assertLess(abs(fit.table.loc["speed", "posterior_50"] - 1.4), 0.2)
        self.assertLess(abs(fit.table.loc["turning", "posterior_50"] - 0.6), 0.15)
        self.assertEqual(len(fit.simulated), 20)
        speeds = [60 * np.nanmean(np.hypot(*np.diff(one, axis=0).T)) for one in fit.simulated.values()]
        self.assertLess(abs(np.mean(speeds) - 84), 40, "those like the measured ones, of speeds from 30 to 180")
        with common.tempfile.TemporaryDirectory() as folder:
            self.assertEqual(fit.write(pathlib.Path(folder) / "fit").read_text().count("<svg"), 5)
        short = tracks.Tracks({name: one[:20] for name, one in measured.items()}, 60.0, [])
        self.assertIn("measured tracks have 20 positions, simulated ones 40: ratios and slopes depend on it", process.fit(short).notes)


class Refused(unittest.TestCase):
    def refused(self, words, call):
        with self.assertRaises(matrigrate.ConfigurationError) as caught:
            call()
        for one in words:
            self.assertIn(one, str(caught.exception))

    def test_points_with_all_faults(self):
        random = np.random.default_rng(1)
        parameters = drawn(20, random)
        values = pandas.DataFrame({"same": np.ones(20), "x": np.arange(20.0)})
        self.refused(["same: is the same in all simulations", "20 points have all read-outs; 30 are needed",
                      "prior: the study does not vary d", "prior: a: (2, 1) is no range"],
                     lambda: _fit.of_points(common.points_of(parameters, values), {"d": (0, 1), "a": (2, 1)}))

    def test_points_that_lack_read_outs_are_named(self):
        random = np.random.default_rng(1)
        parameters = drawn(40, random)
        values = simulated(parameters, random).rename(columns={"ratio": "directionality_ratio"})
        values.loc[:, "directionality_ratio"] = np.nan
        values.loc[:2, "speed"] = np.inf
        self.refused(["0 points have all read-outs; 30 are needed", "speed: 3 of 40 points lack it: it is not defined in their runs, or no number",
                      "directionality_ratio: 40 of 40 points lack it: it needs tracks of more than ten intervals; simulated ones have 6"],
                     lambda: _fit.of_points(common.points_of(parameters, values, 7)))
        values = values[["speed"]]
        notes = _fit.of_points(common.points_of(parameters, values)).notes
        self.assertIn("3 points without all read-outs are left out: speed: 3 of 40 points lack it: it is not defined in their runs, or no number", notes)

    def test_measured_values_with_all_faults(self):
        process = emulators(40)
        self.refused(["speed: has no value", "ratio: has no standard error above 0"],
                     lambda: process.fit({"speed": (math.nan, 1), "ratio": (1, 0)}))
        self.refused(["ratio: has no measured value"], lambda: process.fit({"speed": (1, 1)}))
        self.refused(["len: is measured, but not among the read-outs speed, ratio"],
                     lambda: process.fit({"speed": (1, 1), "ratio": (1, 1)}, besides={"len": (1, 1)}))
        for wrong in (14, "ab", (1, 2, 3), ("1", 2), None):
            self.refused(["ratio: ", " is no mean with its standard error"], lambda wrong=wrong: process.fit({"speed": (1, 1), "ratio": wrong}))
        self.refused(["ratio: has no standard error above 0"], lambda: process.fit({"speed": (1, 1), "ratio": (1, math.inf)}))
        self.refused(["speed: the standard error is 1e+200", "ratio: the measured value is 1e+200", "is the unit right?"],
                     lambda: process.fit({"speed": (1, 1e200), "ratio": (1e200, 1)}))
        self.refused(["speed: the standard error is 1e-300"], lambda: process.fit({"speed": (1, 1e-300), "ratio": (1, 1)}))
        for wrong in (1e200, math.inf, "a"):
            self.refused(["discrepancy: speed: "], lambda wrong=wrong: process.fit({"speed": (1, 1), "ratio": (1, 1)}, discrepancy={"speed": wrong}))
        with self.assertRaisesRegex(TypeError, r"measured is the text 'tm4.csv'; tracks are expected, as matrigrate.tracks.read"):
            process.fit("tm4.csv")
        with self.assertRaisesRegex(TypeError, "measured is a number"):
            process.fit(5)
        self.refused(["discrepancy: sped: is no read-out", "discrepancy: ratio: -1 is no standard error"],
                     lambda: process.fit({"speed": (1, 1), "ratio": (1, 1)}, discrepancy={"sped": 1, "ratio": -1}))

    def test_without_scipy(self):
        with unittest.mock.patch.dict(sys.modules, {"scipy": None}), self.assertRaisesRegex(ImportError, "python3-scipy"):
            calibrate.emulate(None, ["speed_um_per_h"])


class OfAStudy(unittest.TestCase):
    study = matrigrate.load_study(common.runs / "study")

    def refused(self, words, **arguments):
        with self.assertRaisesRegex(matrigrate.ConfigurationError, words):
            calibrate.fit(self.study, **arguments)

    def test_refused(self):
        self.refused("2 points have all read-outs; 10 are needed", measured={"n_protrusions": (5, 1)})
        self.refused("there is no read-out l_prot; there are speed_um_per_h", measured={"l_prot": (5, 1)})
        self.refused("interval: that of the measured tracks is needed", measured={"speed_um_per_h": (5, 1)})
        self.refused("one read-out is needed, such as readouts=", measured=tracks.of(self.study))
        self.refused("sped: has no measured value; tracks have speed_um_per_h", measured=tracks.of(self.study), readouts=["sped"])

    def test_a_read_out_of_runs_and_tracks_needs_no_interval(self):
        runs = conditions.runs_of(self.study, [], [])[""]
        of_runs = measurement.simulated(runs, ["v_migr_abs_um_per_h"], None).values
        of_tracks = measurement.simulated(runs, ["v_migr_abs_um_per_h"], 60.0).values
        np.testing.assert_allclose(of_runs, of_tracks)

    def test_what_people_write(self):
        with self.assertRaisesRegex(TypeError, r"study is the text 'design'; a study is expected, as matrigrate.load_study\('design'\)"):
            calibrate.fit("design", {"n_protrusions": (5, 1)})
        with self.assertRaisesRegex(TypeError, "study is a number"):
            calibrate.fit(3, tracks.of(self.study), ["speed_um_per_h"])
        with self.assertRaisesRegex(TypeError, "measured is the text 'tm4.csv'"):
            calibrate.fit(self.study, "tm4.csv", ["speed_um_per_h"])
        with self.assertRaisesRegex(TypeError, "readouts is a string; a list of read-outs is expected"):
            calibrate.fit(self.study, tracks.of(self.study), "speed_um_per_h")
        with self.assertRaisesRegex(TypeError, "besides is a number"):
            calibrate.fit(self.study, tracks.of(self.study), ["speed_um_per_h"], besides=3)
        self.refused("speed_um_per_h: 14 is no mean with its standard error", measured={"speed_um_per_h": 14})

    def test_the_bootstrap_is_drawn_once(self):
        measured = tracks.of(self.study)
        with unittest.mock.patch.object(tracks, "_resampled", unittest.mock.Mock(wraps=tracks._resampled)) as drawn:
            wanted = _fit.measurement(measured, ["speed_um_per_h", "straightness"])
        self.assertEqual(drawn.call_count, 1)
        self.assertEqual(wanted.covariance.shape, (2, 2))
        with unittest.mock.patch.object(_fit, "measurement", unittest.mock.Mock(wraps=_fit.measurement)) as called, \
                self.assertRaises(matrigrate.ConfigurationError):
            calibrate.fit(self.study, measured, ["speed_um_per_h"])
        self.assertEqual(called.call_count, 1)

    def test_runs_lost_at_the_rim_are_a_bias(self):
        from matrigrate.fit.measurement import lost

        results = pandas.DataFrame({"status": ["done", "failed", "failed", "interrupted"], "cause": ["", "rim", "crossing", ""]})
        self.assertEqual(lost(results), ["3 runs of the study are not done, and left out",
                                         "1 of 4 runs ended at the rim of the matrix: what is left are the slower cells, and the fit leans "
                                         "to parameters of faster ones; run the study in a larger ecm.radius"])

    def test_read_outs_of_tracks_and_of_runs(self):
        points = measurement.simulated(conditions.runs_of(self.study, [], [])[""], ["speed_um_per_h", "n_protrusions"], 120.0)
        self.assertEqual((points.runs, points.counts.to_numpy().tolist()), (2, [[2, 2], [2, 2]]))
        first = self.study.results[self.study.results["label"] == "=soft"]
        self.assertEqual(points.values["n_protrusions"][0], first["n_protrusions"].mean())
        own = [tracks.of(self.study.runs[name], 120.0).readouts(resamples=0).loc["speed_um_per_h", "value"] for name in first["run"]]
        self.assertAlmostEqual(points.values["speed_um_per_h"][0], np.mean(own))


if __name__ == "__main__":
    unittest.main()
