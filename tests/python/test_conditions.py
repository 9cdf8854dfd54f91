"""Fits of several conditions against a model whose parameters are known: posterior, space that is left, numbers that exclude each other, next wave."""
import math
import tomllib
import unittest
import unittest.mock

import common

common.skip_without("matplotlib", "scipy")

import matrigrate  # noqa: E402
import numpy as np  # noqa: E402
import pandas  # noqa: E402
from matrigrate import calibrate, tracks  # noqa: E402
from matrigrate.fit import space  # noqa: E402
from matrigrate.draw import words  # noqa: E402
from matrigrate.errors import ConfigurationError  # noqa: E402
from scipy.stats import qmc  # noqa: E402

prior = {"a": (0.0, 1.0), "b": (1.0, 10.0, "log")}


def runs(many=30, seed=1, low=0.0, high=1.0):
    """Under two conditions: speed and length depend on a and b; ``seeds`` is scatter alone."""
    random = np.random.default_rng(seed)
    cube = low + (high - low) * qmc.LatinHypercube(2, seed=seed).random(many)
    points = pandas.DataFrame({"a": cube[:, 0], "b": 10**cube[:, 1]})
    return pandas.concat([points.assign(condition=condition, speed=5 + slope * cube[:, 0] + 3 * cube[:, 1] + random.normal(0, 0.3, many),
                                        length=20 - 6 * cube[:, 1] + random.normal(0, 0.3, many), seeds=random.normal(3, 1, many))
                          for condition, slope in (("soft", 10.0), ("stiff", 2.0))], ignore_index=True)


def fitted(measured, design=None, **options):
    return calibrate.fit(runs() if design is None else design, measured, **({"prior": prior} | options))


class OfAKnownModel(unittest.TestCase):
    """Measured at a = 0.4 and log10 b = 0.5."""

    @classmethod
    def setUpClass(cls):
        cls.measured = {"soft": {"speed": (10.5, 0.3), "length": ((16, math.inf), 0.3)}, "stiff": {"length": (17.0, 0.3), "speed": (7.3, 0.3)}}
        cls.fit = fitted(cls.measured, held_back=["speed at stiff"])

    def test_the_posterior_has_the_truth(self):
        for name, truth in (("a", 0.4), ("b", 10**0.5)):
            row = self.fit.table.loc[name]
            self.assertTrue(row["posterior_5"] <= truth <= row["posterior_95"] and row["constrained"], row)

    def test_all_conditions_bear_on_it(self):
        alone = fitted({"soft": {"speed": (10.5, 0.3)}})
        self.assertLess(self.fit.table.loc["b", "width"], 0.6 * alone.table.loc["b", "width"])
        self.assertTrue(0 < self.fit.plausible < 0.5 * alone.plausible)

    def test_what_was_held_back_is_predicted_and_not_fitted(self):
        row = self.fit.readouts.loc["speed at stiff"]
        self.assertTrue(row["held_back"])
        self.assertLess(abs(row["posterior_mean"] - 7.3), 0.3)
        self.assertNotIn("speed at stiff", set(self.fit.alone["readout"]))
        other = fitted(self.measured | {"stiff": {"length": (17.0, 0.3), "speed": (9.0, 0.3)}}, held_back=["speed at stiff"])
        pandas.testing.assert_frame_equal(other.table, self.fit.table)
        self.assertGreater(other.readouts.loc["speed at stiff", "implausibility"], 3)

    def test_what_each_number_leaves_and_explains(self):
        alone = self.fit.alone.set_index(["readout", "parameter"])
        self.assertGreater(alone.loc[("length at stiff", "b"), "low"], 1.5)
        self.assertLess(alone.loc[("length at stiff", "a"), "low"], 0.05, "the length tells nothing of a")
        total = self.fit.sensitivity.set_index(["readout", "parameter"])["total"]
        self.assertGreater(total["speed at soft", "a"], 0.8)
        self.assertLess(total["length at stiff", "a"], 0.05)

    def test_a_range_is_as_good_everywhere_inside(self):
        fit = fitted({"stiff": {"length": ((16.0, 18.0), 0.05)}})
        row = fit.table.loc["b"]
        self.assertLess(abs(math.log10(row["posterior_5"]) - 1 / 3), 0.07, "lengths from 18 to 16 are log10 b from 1/3 to 2/3")
        self.assertLess(abs(math.log10(row["posterior_95"]) - 2 / 3), 0.07)
        places = np.log10(fit.sample["b"])
        inside = np.histogram(places, np.linspace(0.37, 0.63, 6))[0]
        self.assertLess(inside.max(), 1.3 * inside.min())

    def test_numbers_that_exclude_each_other(self):
        fit = fitted({"soft": {"length": (15.0, 0.3)}, "stiff": {"length": (19.0, 0.3), "speed": (8.0, 0.5)}})
        first = fit.exclusions.iloc[0]
        self.assertEqual({first["a"], first["b"]}, {"length at soft", "length at stiff"})
        self.assertEqual(first["both"], 0.0)
        self.assertGreater(min(first["plausible_a"], first["plausible_b"]), 0.1)
        self.assertGreater(first["least"], 3)
        self.assertEqual(fit.plausible, 0.0)
        self.assertIn("no parameters within the ranges give such cells: length at s", "\n".join(fit.notes))
        with self.assertRaisesRegex(ConfigurationError, "nothing within the prior is plausible: widen the ranges, or give a discrepancy"):
            fit.next(3)
        wide = fitted({"soft": {"length": (15.0, 0.3)}, "stiff": {"length": (19.0, 0.3)}}, discrepancy={"length": 1.5})
        self.assertGreater(wide.plausible, 0.0)

    def test_the_next_wave_fills_what_is_plausible(self):
        points = self.fit.next(8)
        self.assertEqual(list(points), ["a", "b"])
        cube = self.fit.prior.to_cube(points.to_numpy())
        self.assertLess(np.abs(cube - [0.4, 0.5]).max(), 0.25)
        apart = np.linalg.norm(cube[:, None] - cube, axis=2) + np.eye(8)
        self.assertGreater(apart.min(), 0.02)
        for wrong in (0, 2.5, True, "3"):
            with self.assertRaisesRegex(ConfigurationError, "is no number of points"):
                self.fit.next(wrong)
        with self.assertRaisesRegex(ConfigurationError, "like: is needed"):
            self.fit.next(3, "next.toml")

    def test_waves_together(self):
        both = calibrate.fit([runs(), runs(20, 2, 0.3, 0.6)], self.measured, prior=prior)
        self.assertLess(both.table.loc["a", "width"], 1.1 * self.fit.table.loc["a", "width"])
        twice = calibrate.fit([runs(), runs()], {"soft": {"speed": (10.5, 0.3)}}, prior=prior)
        once = fitted({"soft": {"speed": (10.5, 0.3)}})
        pandas.testing.assert_frame_equal(twice.table, once.table)

    def test_frames_by_condition(self):
        parts = dict(list(runs().groupby("condition")))
        fit = fitted({"soft": {"speed": (10.5, 0.3)}, "stiff": {"length": (17.0, 0.3)}}, parts)
        whole = fitted({"soft": {"speed": (10.5, 0.3)}, "stiff": {"length": (17.0, 0.3)}})
        pandas.testing.assert_frame_equal(fit.table, whole.table)

    def test_the_page_and_its_tables(self):
        with common.tempfile.TemporaryDirectory() as folder:
            page = self.fit.write(common.pathlib.Path(folder) / "fit")
            text = page.read_text()
            for part in ("speed at soft", "16 to inf", "(held back)", "Which number excludes what", "Each pair of numbers is met somewhere"):
                self.assertIn(part, text)
            for name in ("posterior", "readouts", "sensitivity", "sample", "alone", "exclusions"):
                self.assertGreater(len(pandas.read_csv(page.parent / f"{name}.csv")), 1)


class Limits(unittest.TestCase):
    """What can be run, what is known, what is met nowhere."""

    @staticmethod
    def runs():
        random = np.random.default_rng(0)
        points = qmc.LatinHypercube(2, seed=1).random(40)
        return pandas.DataFrame([{"a": a, "b": b, "v": 10 * a + random.normal(0, 0.2), "w": 3 + random.normal(0, 0.2), "u": 3.0}
                                 for a, b in points for _ in range(2)])

    prior = {"a": (0, 1), "b": (0, 1)}

    def test_whole_numbers_are_judged_where_they_can_be_run(self):
        random = np.random.default_rng(0)
        frame = pandas.DataFrame([{"protrusion.number": 1 + k % 4, "actomyosin.force_nN": force, "l_prot_um": 10 * (1 + k % 4) + random.normal(0, 0.3)}
                                  for k, force in enumerate(random.uniform(0.3, 0.6, 24)) for _ in range(2)])
        own = {"protrusion.number": (1, 4), "actomyosin.force_nN": (0.3, 0.6)}
        between = calibrate.fit(frame, {"l_prot_um": (25, 0.5)}, prior=own)
        self.assertEqual(between.plausible, 0.0, "2 and 3 are ten errors off")
        three = calibrate.fit(frame, {"l_prot_um": (30, 0.5)}, prior=own)
        self.assertEqual(set(three.next(5)["protrusion.number"]), {3})
        self.assertEqual(set(three.sample["protrusion.number"]), {3})
        self.assertAlmostEqual(three.plausible, 0.25, delta=0.02, msg="one of four")

    def test_what_runs_lack_is_told(self):
        found = self.runs()
        for lacking in (found.assign(v=found["v"].where(found["a"] <= 0.6)), found.assign(v=found["v"].where(found["a"] <= 0.6, np.inf))):
            fit = calibrate.fit(lacking, {"v": (4, 0.3)}, prior=self.prior)
            notes = "\n".join(fit.notes)
            self.assertIn("v: 32 of 80 runs that are done do not have it", notes)
            self.assertIn("16 points without all read-outs are left out: v: 16 of 40 points lack it", notes)
            self.assertIn("prior: a: 0 to 1 goes above the points with read-outs", notes)
        half = found.assign(v=found["v"].where(found.index % 2 == 0))
        self.assertIn("v: 40 of 80 runs that are done do not have it", "\n".join(calibrate.fit(half, {"v": (4, 0.3)}, prior=self.prior).notes))

    def test_what_is_met_nowhere_excludes_everything(self):
        fit = calibrate.fit(self.runs(), {"w": (30, 0.3), "v": (5, 0.3)}, prior=self.prior)
        self.assertEqual(fit.plausible, 0.0)
        self.assertRegex("\n".join(fit.notes), r"w: is 3\.0\d+ \(2\.\d+ to 3\.\d+\) at all points, measured is 30: it is met nowhere")
        with self.assertRaisesRegex(ConfigurationError, "u: is the same in all simulations, 3: no parameter changes it; leave it out"):
            calibrate.fit(self.runs(), {"u": (30, 0.3), "v": (5, 0.3)}, prior=self.prior)
        met = calibrate.fit(self.runs(), {"w": (3, 0.3), "v": (5, 0.3)}, prior=self.prior)
        self.assertIn("w: depends on no parameter", "\n".join(met.notes))
        alone = met.alone.groupby("readout")["plausible"].first()
        self.assertEqual(alone["w"], 1.0, "what predicts nothing excludes nothing")
        self.assertAlmostEqual(met.plausible, alone["v"])

    def test_a_region_of_a_millionth_is_found_with_its_share(self):
        def off(cube):
            return np.abs(cube - 0.3).max(axis=1)
        cube = np.random.default_rng(1).random((12000, 6))
        region = space.below(off, 0.05, cube, off(cube), 1)
        self.assertLess(abs(math.log(region.share / 1e-6)), math.log(1.8))
        np.testing.assert_allclose(region.sample.mean(axis=0), 0.3, atol=0.006)
        np.testing.assert_allclose(region.sample.std(axis=0), 0.1 / math.sqrt(12), rtol=0.15)
        nothing = space.below(lambda at: 1 + off(at), 0.9, cube, 1 + off(cube), 1)
        self.assertEqual((len(nothing.sample), nothing.share), (0, 0.0))


class Refused(unittest.TestCase):
    def refused(self, said, measured, design=None, **options):
        with self.assertRaises(ConfigurationError) as caught:
            fitted(measured, design, **options)
        for part in said if isinstance(said, list) else [said]:
            self.assertIn(part, str(caught.exception))

    def test_conditions(self):
        good = {"soft": {"speed": (10.5, 0.3)}}
        self.refused("hard: the data frame has no such condition; it has soft, stiff", {"hard": {"speed": (1, 1)}})
        self.refused("measured: speed: is neither tracks nor a dictionary of numbers", {"soft": {"speed": (1, 1)}, "speed": (1, 1)})
        self.refused("hard: there is no study of this condition; there are soft, stiff", {"hard": {"speed": (1, 1)}}, dict(list(runs().groupby("condition"))))
        self.refused("measured: studies by condition need what was measured by condition", {"speed": (1, 1)}, {"soft": runs()})
        self.refused("held_back: sped: was not measured; there are speed at soft", good, held_back=["sped"])
        self.refused("held_back: one number is needed that is not held back", good, held_back=["speed"])
        self.refused("besides: stiff: nothing was measured under such a condition", good, besides={"stiff": {"length": (1, 1)}})
        self.refused("discrepancy: sped: is no read-out", good, discrepancy={"sped": 1})
        self.refused("soft: speed: 3 of 3", good, runs().groupby("condition").head(3).assign(speed=np.nan))
        both = {"soft": {"sped": (1, 1)}, "stiff": {"lenth": (1, 1)}}
        self.refused(["soft: there is no read-out sped", "stiff: there is no read-out lenth"], both)
        self.refused(["soft: speed: has no standard error", "stiff: length: has no value"], {"soft": {"speed": (1, 0)}, "stiff": {"length": (math.nan, 1)}})
        with self.assertRaisesRegex(TypeError, "held_back is a string; a list of numbers is expected"):
            fitted(good, held_back="speed")

    def test_data_frames(self):
        self.refused("prior: is needed for a table", {"speed": (1, 1)}, prior=None)
        self.refused("c: the table has no such column", {"speed": (1, 1)}, prior=prior | {"c": (0, 1)})
        self.refused("condition: the table has no such column", {"soft": {"speed": (1, 1)}}, runs().drop(columns="condition"))
        self.refused("speed: two columns have this name", {"speed": (1, 1)}, runs().rename(columns={"length": "speed"}))
        self.refused("a: only finite numbers can be fitted", {"speed": (1, 1)}, runs().assign(a="x"))
        self.refused("speed: is no number in the runs", {"speed": (1, 1)}, runs().assign(speed="fast"))
        cells = tracks.Tracks({"1": np.zeros((5, 2)) + np.arange(5)[:, None], "2": np.ones((5, 2)) * np.arange(5)[:, None]**1.1}, 60.0, [])
        self.refused("speed_um_per_h: the table has no such column, and no tracks", {"soft": cells}, readouts=["speed_um_per_h"])

    def test_numbers_that_are_none(self):
        for wrong, said in ((((2, 1), 0.3), "(2, 1) is no range from a lower to a higher end"), (((-math.inf, math.inf), 1), "has no value"),
                            ((True, 1), "is no mean with"), (((1, "2"), 1), "is no mean with"), ((5, 0), "has no standard error above 0"),
                            ((1e200, 1), "is the unit right?"), (((math.nan, 1), 1), "has no value"), (((1, 2, 3), 1), "is no mean with")):
            self.refused(["speed: ", said], {"soft": {"speed": wrong}})

    def test_studies_by_condition_may_name_their_parameters_in_another_order(self):
        from matrigrate.fit import conditions

        def runs(order):
            frame = pandas.DataFrame({"a": [1.0, 2.0], "b": [3.0, 4.0]})[order]
            return {"": conditions.Runs(frame.assign(point=["1", "2"]), list(order), frame, {})}

        with unittest.mock.patch.object(conditions, "_of_waves", side_effect=[runs(["a", "b"]), runs(["b", "a"])]):
            found = conditions.runs_of({"soft": None, "stiff": None}, ["soft", "stiff"], [])
        self.assertEqual([one.parameters for one in found.values()], [["a", "b"]] * 2)
        self.assertEqual([list(one.design) for one in found.values()], [["a", "b"]] * 2)

    def test_what_has_gone_names_what_replaces_it(self):
        for name in ("match", "Outcome", "read_outcomes"):
            with self.assertRaisesRegex(ConfigurationError, "have gone: calibrate.fit takes numbers and ranges by condition"):
                getattr(calibrate, name)("speed", 3.5)


class OfAStudy(common.InTemporaryFolder):
    """A design of ten points under two conditions, of cells of a minute; its next wave goes through the program."""

    text = """title = "Design"
preset = "baseline"
replicates = 1
common_random_numbers = true
readouts = ["v_migr_abs_um_per_h"]

[set]
run.duration = "1 min"
run.integrator = "adaptive"
ecm.radius = "40 um"
protrusion.initiation_rate = "0.01 1/s"
output.report = false
output.checkpoint_interval = 0
output.field_interval = 0

[[conditions]]
label = "soft"
ecm.youngs_modulus = "50 Pa"

[[conditions]]
label = "stiff"
ecm.youngs_modulus = "400 Pa"

[[targets]]
readout = "v_migr_abs_um_per_h"
value = 20
error = 4
at = "stiff"

[latin_hypercube]
samples = 10
protrusion.force = ["0.2 nN", "0.6 nN"]
"""

    def test_waves_through_the_program(self):
        (self.folder / "wave-1.toml").write_text(self.text)
        first = matrigrate.run_study("wave-1.toml", "wave-1")
        name = "v_migr_abs_um_per_h"
        speed = first.results.loc[first.results["label"].str.startswith("stiff: "), name]
        wanted = {"stiff": {name: (float(speed.median()), 0.05 * float(np.ptp(speed)))}, "soft": {name: ((-math.inf, 100), 1)}}
        fit = calibrate.fit(first, wanted, held_back=[f"{name} at soft"])
        self.assertEqual(fit.prior.names, ["protrusion.force_nN"], "the modulus is what the conditions set")
        self.assertTrue(0 < fit.plausible < 0.9)
        (self.folder / "next").mkdir()
        points = fit.next(4, "next/wave-2.toml")
        text = (self.folder / "next" / "wave-2.toml").read_text()
        self.assertIn('label = "wave 2, point 4"', text)
        self.assertNotIn("sample 1", text)
        second = matrigrate.run_study("next/wave-2.toml", "wave-2")
        np.testing.assert_allclose(second.results["protrusion.force_nN"].unique(), points["protrusion.force_nN"], rtol=1e-5)
        both = calibrate.fit([first, second], wanted, held_back=[f"{name} at soft"])
        self.assertEqual((both.prior.low[0], both.prior.high[0]), (fit.prior.low[0], fit.prior.high[0]), "the prior is that of the first wave")
        self.assertEqual(len(both._there), 14)
        with self.assertRaisesRegex(matrigrate.InputOutputError, "exists already"):
            both.next(4, "next/wave-2.toml")
        both.next(2, "wave-3.toml", like="next/wave-2.toml")
        self.assertIn('label = "wave 3, point 2"', (self.folder / "wave-3.toml").read_text())
        of_targets = calibrate.fit(first)
        self.assertEqual(list(of_targets.readouts.index), [f"{name} at stiff"])
        self.assertEqual(list(of_targets.readouts.loc[f"{name} at stiff", ["measured", "standard_error"]]), [20, 4])
        of_waves = calibrate.fit([first.folder, second])
        self.assertEqual(list(of_waves.readouts.index), [f"{name} at stiff"])
        of_waves.next(1, "wave-4.toml")
        self.assertTrue((self.folder / "wave-4.toml").is_file(), "it is like the first wave")

    def test_files_beside_a_study_are_named_from_the_new_place(self):
        from matrigrate.fit.study_file import write_points

        for folder in ("here", "there"):
            (self.folder / folder).mkdir()
        (self.folder / "here" / "cell.toml").write_text('[run]\nduration = "1 h"\n')
        (self.folder / "here" / "like.toml").write_text(self.text.replace('preset = "baseline"', 'scenario = "cell.toml"'))
        points = pandas.DataFrame({"protrusion.force_nN": [0.3], "protrusion.number": [2.0]})
        write_points(self.folder / "there" / "next.toml", points, "here/like.toml")
        found = tomllib.loads((self.folder / "there" / "next.toml").read_text())
        self.assertEqual(found["scenario"], "../here/cell.toml")
        self.assertEqual(found["points"][0]["protrusion"], {"force": "0.3 nN", "number": 2})
        with self.assertRaisesRegex(ConfigurationError, "zeta: is no parameter of the program"):
            write_points(self.folder / "other.toml", points.assign(zeta=1.0), "here/like.toml")
        with self.assertRaises(ConfigurationError):
            write_points(self.folder / "bad.toml", points.assign(**{"ecm.poissons_ratio": 7.0}), "here/like.toml")
        self.assertFalse((self.folder / "bad.toml").exists(), "what the program refuses is not kept")

    def test_columns_of_parameters(self):
        for column, key in (("contact.cells.adhesion_range_um", "contact.cells.adhesion_range"), ("ecm.youngs_modulus_Pa", "ecm.youngs_modulus"),
                            ("contact.cells.adhesion_Pa", "contact.cells.adhesion"), ("protrusion.number", "protrusion.number")):
            self.assertEqual(words.parameter_of(column).path, key)
        self.assertIsNone(words.parameter_of("zeta"))

    def test_studies_by_condition_and_choices(self):
        study = matrigrate.load_study(common.runs / "study")
        with self.assertRaisesRegex(ConfigurationError, "one: 2 points have all read-outs; 10 are needed"):
            calibrate.fit({"one": study, "two": common.runs / "study"}, {"one": {"n_protrusions": (3, 1)}, "two": {"n_protrusions": (3, 1)}})
        with self.assertRaisesRegex(ConfigurationError, "soft: the study has no such condition: it has no conditions"):
            calibrate.fit(study, {"soft": {"n_protrusions": (3, 1)}})
        with self.assertRaisesRegex(ConfigurationError, "measured: the study has no .*targets"):
            calibrate.fit(study)
        study.results["ecm.youngs_modulus_Pa"] = ["tied", "free", "tied", "free"]
        with self.assertRaisesRegex(ConfigurationError, "ecm.youngs_modulus_Pa: only numbers can be fitted"):
            calibrate.fit(study, {"n_protrusions": (3, 1)})


if __name__ == "__main__":
    unittest.main()
