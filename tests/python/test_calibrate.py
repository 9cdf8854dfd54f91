"""Posteriors against a model whose parameters are known; what is refused and what is said."""
import unittest
import unittest.mock

import common
import matrigrate
import numpy as np
import pandas
from matrigrate import calibrate, tracks


def simulated(points, random):
    """Two read-outs that tell a and b, with scatter; no read-out tells c."""
    a, b = points["a"].to_numpy(), points["b"].to_numpy()
    return pandas.DataFrame({"speed": 10 * a + 3 * b + random.normal(0, 0.5, len(points)),
                             "ratio": b - 0.2 * a + random.normal(0, 0.05, len(points))})


def measured_at(truth, random):
    values = simulated(pandas.DataFrame([truth]), random).iloc[0]
    return pandas.DataFrame({"value": values, "standard_error": [0.5, 0.05]})


class Recovery(unittest.TestCase):
    def test_intervals_contain_the_truth_as_often_as_they_say(self):
        random = np.random.default_rng(4)
        points = pandas.DataFrame(random.uniform(0, 1, (2000, 3)), columns=["a", "b", "c"])
        found = simulated(points, random)
        inside, told = 0, []
        for _ in range(100):
            truth = dict(zip("abc", random.uniform(0.0, 1.0, 3), strict=True))
            posterior = calibrate.weigh(points, found, measured_at(truth, random))
            table = posterior.table
            inside += sum(table.loc[k, "posterior_5"] <= truth[k] <= table.loc[k, "posterior_95"] for k in "abc")
            told.append(list(table["width"] < 0.8))
            self.assertFalse((table["constrained"] & (table["at_bound"] != "")).any())
        self.assertGreater(inside, 0.85 * 300)
        self.assertLess(inside, 300, "intervals are not the whole prior")
        share = np.mean(told, axis=0)
        self.assertGreater(min(share[:2]), 0.95)
        self.assertLess(share[2], 0.3, "nothing tells c")
        self.assertLess(table.loc["a", "width"], 0.5)

    def test_what_is_said(self):
        random = np.random.default_rng(5)
        points = pandas.DataFrame(random.uniform(0, 1, (200, 3)), columns=["a", "b", "c"])
        found = simulated(points, random)
        far = pandas.DataFrame({"value": [40.0, 0.5], "standard_error": [0.5, 0.05]}, index=["speed", "ratio"])
        posterior = calibrate.weigh(points, found, far)
        self.assertIn("no simulation reaches the measured speed", posterior.notes)
        self.assertGreater(posterior.widened, 1)
        found.loc[:9, "speed"] = np.nan
        self.assertIn("10 simulations without all read-outs are left out", calibrate.weigh(points, found, far).notes)

    def test_refused_with_all_faults(self):
        points = pandas.DataFrame({"a": np.linspace(0, 1, 100)})
        found = pandas.DataFrame({"same": np.ones(100), "x": np.linspace(0, 1, 100)})
        measured = pandas.DataFrame({"value": [1, 1, np.nan], "standard_error": [1, 1, 1]}, index=["same", "none", "x"])
        with self.assertRaises(matrigrate.ConfigurationError) as caught:
            calibrate.weigh(points, found, measured)
        for words in ("same: is the same in all simulations", "none: the simulations do not have it", "x: has no value"):
            self.assertIn(words, str(caught.exception))
        with self.assertRaisesRegex(matrigrate.ConfigurationError, "10 simulations have all read-outs; 40 are needed"):
            calibrate.weigh(points[:10], found[:10], pandas.DataFrame({"value": [1], "standard_error": [1]}, index=["x"]))


    def test_values_and_errors_that_tell_nothing(self):
        points = pandas.DataFrame({"a": np.linspace(0, 1, 100), "fixed": 0.3})
        found = pandas.DataFrame({"x": np.linspace(0, 1, 100)})
        for value, error, words in ((0.5, 1e-300, "the standard error is 1e-300"), (1e160, 0.1, "the measured value is 1e\\+160"),
                                    (0.5, np.inf, "has no standard error above 0"), (0.5, 1e200, "nothing can be told")):
            with self.assertRaisesRegex(matrigrate.ConfigurationError, words):
                calibrate.weigh(points, found, pandas.DataFrame({"value": [value], "standard_error": [error]}, index=["x"]))
        measured = pandas.DataFrame({"value": [0.98], "standard_error": [0.2]}, index=["x"])
        posterior = calibrate.weigh(points, found, measured)
        self.assertEqual(list(posterior.table.index), ["a"])
        self.assertEqual(posterior.notes, ["fixed: is 0.3 in all simulations, so it is left out: nothing can be said of it",
                                           "a: the posterior ends at the upper bound of the prior, 1: widen the range"])
        self.assertFalse(posterior.table.isna().any().any())
        found.loc[:9, "x"] = np.inf
        self.assertIn("10 simulations without all read-outs are left out", calibrate.weigh(points, found, measured).notes)
        with self.assertRaisesRegex(matrigrate.ConfigurationError, "no parameter varies"):
            calibrate.weigh(points[["fixed"]], found, measured)


class OfAStudy(unittest.TestCase):
    study = matrigrate.load_study(common.runs / "study")

    def test_cells_like_those_of_a_point_weigh_that_point_most(self):
        done = self.study.results
        with unittest.mock.patch.object(calibrate, "_least_sample", 1.0):
            for k, label in enumerate(done["label"].unique()):
                cells = {}
                for name in done.loc[done["label"] == label, "run"]:
                    cells[name] = next(iter(tracks.of(self.study.runs[name]).values()))
                posterior = calibrate.by_tracks(self.study, tracks.Tracks(cells, 60.0, []), ["speed_um_per_h", "turning_cosine"])
                self.assertEqual(int(np.argmax(posterior.weights)), k)
                self.assertEqual(list(posterior.table.index), ["ecm.youngs_modulus_Pa"])
                np.testing.assert_array_less(posterior.weights[1 - k], 0.5)

    def test_unknown_readouts_and_small_studies(self):
        cells = tracks.of(self.study)
        with self.assertRaisesRegex(matrigrate.ConfigurationError, "sped: has no measured value; tracks have speed_um_per_h"):
            calibrate.by_tracks(self.study, cells, ["sped"])
        with self.assertRaisesRegex(matrigrate.ConfigurationError, "2 simulations have all read-outs; 40 are needed"):
            calibrate.by_tracks(self.study, cells, ["speed_um_per_h"])


if __name__ == "__main__":
    unittest.main()
