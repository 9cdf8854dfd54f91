"""History matching against a model whose parameters are known: the space that is left, rows that exclude each other, the next wave."""
import math
import pathlib
import tempfile
import tomllib
import unittest

import common

common.skip_without("matplotlib", "scipy")

import matrigrate  # noqa: E402
import numpy as np  # noqa: E402
import pandas  # noqa: E402
from matrigrate import _outcomes, _space, calibrate  # noqa: E402
from matrigrate._study_file import key_of  # noqa: E402
from matrigrate.calibrate import Outcome, match  # noqa: E402
from matrigrate.errors import ConfigurationError  # noqa: E402
from scipy.stats import qmc  # noqa: E402

prior = {"a": (0.0, 1.0), "b": (1.0, 10.0, "log"), "c": (0.0, 1.0)}


def model(points, random, noise=0.3):
    """Runs under two conditions: speed and length tell a and b; c does nothing; ``seeds`` is scatter alone."""
    a, b = points["a"].to_numpy(), np.log10(points["b"].to_numpy())
    frames = []
    for condition, slope in (("soft", 10.0), ("stiff", 2.0)):
        found = points.copy()
        found["condition"] = condition
        found["speed"] = 5 + slope * a + 3 * b + random.normal(0, noise, len(points))
        found["length"] = 20 - 6 * b + (4 * a if condition == "soft" else 0) + random.normal(0, noise, len(points))
        found["seeds"] = random.normal(3, 1, len(points))
        frames.append(found)
    return pandas.concat(frames, ignore_index=True)


def drawn(many, random, low=0.0, high=1.0):
    return pandas.DataFrame({"a": random.uniform(low, high, many), "b": 10**random.uniform(low, high, many), "c": random.uniform(0, 1, many)})


def outcomes(a=0.4, b=0.5, error=0.3):
    """What is measured at a and log10 b."""
    return [Outcome("speed", 5 + 10 * a + 3 * b, error=error, at="soft", row="A"), Outcome("length", 20 - 6 * b, error=error, at="stiff", row="B"),
            Outcome("speed", 8 * a, error=error, at="soft", minus="stiff", row="C"), Outcome("length", (20, math.inf), error=error, at="soft", row="D"),
            Outcome("length", 20 - 6 * b + 4 * a, error=error, at="soft", name="kept", held_back=True)]


class AFileOfOutcomes(unittest.TestCase):
    def read(self, text):
        with tempfile.TemporaryDirectory() as folder:
            file = pathlib.Path(folder) / "outcomes.toml"
            file.write_text(text, encoding="utf-8")
            return calibrate.read_outcomes(file)

    def test_has_values_and_ranges(self):
        found = self.read('[[outcomes]]\nreadout = "speed"\nvalue = 3.5\nat = "soft"\nrow = "A"\nruns = 12\nheld_back = true\n'
                          '[[outcomes]]\nreadout = "length"\nhigh = -0.5\nat = "stiff"\nminus = "soft"\nerror = 0.1\n'
                          '[[outcomes]]\nreadout = "length"\nlow = 25\nhigh = 30\nerror = 0.1\n')
        self.assertEqual(found, [Outcome("speed", 3.5, at="soft", row="A", runs=12, held_back=True),
                                 Outcome("length", (-math.inf, -0.5), at="stiff", minus="soft", error=0.1), Outcome("length", (25, 30), error=0.1)])

    def test_tells_all_that_is_wrong(self):
        with self.assertRaises(matrigrate.ConfigurationError) as caught:
            self.read('[[outcomes]]\nreadot = "speed"\nvalue = 1\n[[outcomes]]\nreadout = "speed"\nvalue = 1\nlow = 0\n[[outcomes]]\nreadout = "speed"\n')
        said = str(caught.exception).splitlines()
        self.assertEqual(len(said), 4, said)
        self.assertIn("outcome 1: readot: there is no such key; did you mean readout?", said[0])
        self.assertIn("outcome 2: either value, or low, high or both", said[2])
        for text in ("", "outcomes = 3", "[[outcomes]"):
            with self.subTest(text), self.assertRaises(matrigrate.ConfigurationError):
                self.read(text)


class OfAKnownModel(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        random = np.random.default_rng(5)
        cls.waves = [model(drawn(30, random), random), model(drawn(40, random, 0.2, 0.7), random)]
        cls.outcomes = [*outcomes()[:3], Outcome("length", (-math.inf, 20), error=0.3, at="soft", row="D"), outcomes()[4]]
        cls.match = calibrate.match(cls.waves, cls.outcomes, prior=prior, discrepancy=0.0)

    def test_the_truth_is_left_and_little_else(self):
        first, last = self.match.waves
        self.assertEqual((first.points, last.points), (30, 70))
        self.assertLess(last.share, first.share)
        self.assertGreater(last.share, 0.005)
        self.assertLess(last.share, 0.2)
        for name, truth in (("a", 0.4), ("b", 10**0.5)):
            low, high = last.ranges.loc[name, ["low", "high"]]
            self.assertLess(low, truth)
            self.assertGreater(high, truth)
            self.assertLess(abs(self.match.prior.to_cube(self.match.best.to_numpy()[None])[0]["abc".index(name)] - {"a": 0.4, "b": 0.5}[name]), 0.12)
        low, high = last.ranges.loc["c", ["low", "high"]]
        self.assertLess(low, 0.1, "nothing tells c")
        self.assertGreater(high, 0.9)

    def test_a_held_back_outcome_is_predicted(self):
        row = self.match.outcomes.loc["kept"]
        self.assertTrue(row["held_back"])
        self.assertLess(row["5"], row["low"])
        self.assertGreater(row["95"], row["low"])
        self.assertNotIn("kept", self.match.rows.index)
        self.assertLess(row["95"] - row["5"], 5.0, "of 10 over the prior")

    def test_quality_of_emulators_and_predictions(self):
        self.assertGreater(self.match.outcomes.loc["speed at soft", "predicted"], 0.9)
        self.assertTrue(self.match.outcomes["told"].all())
        found = self.match.predict(pandas.DataFrame({"a": [0.4], "b": [10**0.5], "c": [0.5]}))
        self.assertAlmostEqual(found["speed at soft"][0], 10.5, delta=4 * found["speed at soft_error"][0] + 0.1)
        self.assertAlmostEqual(found["speed at soft less stiff"][0], 3.2, delta=0.5)
        with self.assertRaisesRegex(matrigrate.ConfigurationError, "c: the points have no such column"):
            self.match.predict(pandas.DataFrame({"a": [1], "b": [2]}))

    def test_the_next_wave_fills_what_is_plausible(self):
        points = self.match.next_points(12)
        cube = self.match.prior.to_cube(points.to_numpy())
        self.assertLess(self.match._judge.depth(cube).max(), 3.0)
        apart = np.sqrt(((cube[:, None] - cube[None])**2).sum(axis=2)) + np.eye(12)
        self.assertGreater(apart.min(), 0.1)
        self.assertGreater(np.ptp(cube[:, 2]), 0.8, "over the whole range of c")
        pandas.testing.assert_frame_equal(points, self.match.next_points(12))

    def test_a_page_that_needs_no_other_file(self):
        with common.tempfile.TemporaryDirectory() as folder:
            page = self.match.write(pathlib.Path(folder) / "match")
            text = page.read_text()
            self.assertEqual(text.count("<svg"), 5)
            self.assertNotIn("http", text)
            for name in ("outcomes", "reach", "rows", "exclusions", "ranges", "plausible"):
                self.assertGreater(len(pandas.read_csv(page.parent / f"{name}.csv")), 1)
            with self.assertRaisesRegex(matrigrate.InputOutputError, "exists already; give a new folder, or overwrite=True"):
                self.match.write(page.parent)
            self.assertEqual(self.match.write(page.parent, overwrite=True), page)
        self.assertIn("share of the prior that is plausible, wave by wave: ", repr(self.match))


class Rows(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        random = np.random.default_rng(6)
        cls.runs = model(drawn(60, random), random)

    def matched(self, wanted, **options):
        return calibrate.match(self.runs, wanted, prior=prior, discrepancy=0.0, **options)

    def test_rows_that_exclude_each_other(self):
        slow, fast = Outcome("speed", 0.5 * 8, error=0.2, at="soft", minus="stiff", row="half"), Outcome("speed", 8 * 0.9, error=0.2, at="soft", minus="stiff", row="most", name="x")
        other = Outcome("length", 17, error=0.5, at="stiff", row="long")
        match = self.matched([slow, fast, other])
        self.assertEqual(match.waves[-1].share, 0.0)
        self.assertIn("no parameters within the prior are plausible: even at the best point 1 or more rows are off", match.notes[-1])
        first = match.exclusions.iloc[0]
        self.assertEqual({first["a"], first["b"]}, {"half", "most"})
        self.assertFalse(first["both"])
        from matrigrate._match_report import page

        self.assertIn("No point within the prior satisfies both.", page(match), "the page of nothing plausible")
        self.assertGreater(first["least"], 3)
        self.assertLess(max(first["alone_a"], first["alone_b"]), 1)
        self.assertTrue(match.exclusions["both"][1:].all())
        groups = match.excluding({"ends": ["half", "most"], "length": ["long"]})
        self.assertFalse(groups["both"][0])
        self.assertGreater(groups["alone_a"][0], 3)
        with self.assertRaisesRegex(matrigrate.ConfigurationError, "short: there is no such row"):
            match.excluding({"x": ["short"]})
        with self.assertRaisesRegex(matrigrate.ConfigurationError, "nothing within the prior is plausible"):
            match.next_points(3)
        allowed = self.matched([slow, fast, other], allowed=1)
        self.assertGreater(allowed.waves[-1].share, 0.0)

    def test_what_meeting_an_outcome_would_take(self):
        low = Outcome("speed", 0.3 * 8, error=0.4, at="soft", minus="stiff", row="a is low")
        high = Outcome("speed", 0.9 * 8, error=0.4, at="soft", minus="stiff", row="a is high", name="high")
        free = Outcome("length", 17, error=0.6, at="stiff", row="b", name="free")
        off = Outcome("length", 24, error=1, at="stiff", row="b is off everywhere", name="off")  # it is 14 to 20
        far = Outcome("length", 30, error=0.5, at="stiff", name="far", held_back=True)
        seeds = Outcome("seeds", 3, error=1, at="soft", name="scatter")
        reach = self.matched([free, off, low, high, far, seeds]).reach
        self.assertEqual(set(reach.index), {"free", "off", low.label, "high", "far"}, "those that an emulator tells")
        self.assertEqual(set(reach.index[:2]), {"far", "off"}, "met nowhere")
        self.assertEqual(reach["met"]["far"], 0)
        self.assertAlmostEqual(reach["nearest"]["far"], 20, delta=0.6)
        self.assertEqual(reach["against"]["far"], "")
        self.assertAlmostEqual(reach["met"]["high"], 0.1, delta=0.03)  # |8 a - 7.2| < 0.4
        self.assertEqual(reach["against"]["high"], "a is low", "though another row is further off, there as elsewhere")
        self.assertEqual(reach["against"][low.label], "a is high")

        def others(*fitted):
            return self.matched(list(fitted)).reach["others"]

        one = others(free, high)
        self.assertAlmostEqual(one["free"], 1, delta=0.15, msg="each has a parameter of its own")
        soft = Outcome("speed", 0.6 * 8, error=1.2, at="soft", minus="stiff", row="a is middling")
        a = np.linspace(0, 1, 10001)
        likely = np.exp(-0.5 * ((8 * a - 4.8) / 1.2)**2)
        expected = likely[abs(8 * a - 7.2) < 0.4].mean() / likely.mean()
        self.assertAlmostEqual(others(soft, high)["high"], expected, delta=0.15 * expected)
        own = Outcome("speed", 0.5 * 8, error=0.4, at="soft", minus="stiff", row="a is high", name="too")
        self.assertAlmostEqual(others(soft, high, own)["high"], others(soft, high)["high"], msg="outcomes of its own row do not count")
        ranged = Outcome("speed", (4, math.inf), error=0.01, at="soft", minus="stiff", row="more than half", name="half")
        found = self.matched([ranged, free]).reach
        self.assertAlmostEqual(found["met"]["half"], 0.5, delta=0.03)
        rough = Outcome("speed", 0.9 * 8, error=0.4, at="soft", minus="stiff", name="high", relative=0.1)
        self.assertAlmostEqual(self.matched([rough, free]).reach["met"]["high"], 0.2, delta=0.04, msg="0.82 with the model's own error")

    def test_a_row_is_its_worst_outcome_or_the_mean_square(self):
        pair = [Outcome("speed", 3.2, error=0.1, at="soft", minus="stiff", row="A"), Outcome("length", (0, 100), error=1, at="soft", row="A")]
        worst, mean = self.matched(pair), self.matched(pair, row="mean")
        np.testing.assert_allclose(mean._judge.known, worst._judge.known / math.sqrt(2))
        self.assertGreater(mean.waves[-1].share, worst.waves[-1].share)

    def test_errors_of_all_kinds_widen_what_is_plausible(self):
        def share(**more):
            return self.matched([Outcome("speed", 3.2, at="soft", minus="stiff", **more)]).waves[-1].share
        narrow = share(error=0.1)
        for wider in ({"error": 0.1, "discrepancy": 0.5}, {"error": 0.1, "relative": 0.2}, {"error": 0.1, "runs": 1}):
            self.assertGreater(share(**wider), 1.2 * narrow, wider)

    def test_an_outcome_of_seeds_alone_excludes_nothing(self):
        match = self.matched([Outcome("seeds", 4, error=0.1, at="soft"), outcomes()[0]])
        self.assertNotIn("seeds at soft", match.rows.index)
        self.assertFalse(match.outcomes.loc["seeds at soft", "told"])
        self.assertIn("seeds at soft: depends on no parameter, as far as the points can tell: it excludes nothing", match.notes)

    def test_several_seeds_a_point_are_one_point(self):
        twice = pandas.concat([self.runs, self.runs.assign(speed=self.runs["speed"] + 1)])
        match = calibrate.match(twice, [outcomes()[0]], prior=prior)
        self.assertEqual(match.waves[0].points, 60)
        self.assertEqual(match.outcomes["points"].iloc[0], 60)

    def test_refused_with_all_faults(self):
        def refused(words, design=None, wanted=None, **options):
            with self.assertRaises(matrigrate.ConfigurationError) as caught:
                calibrate.match(self.runs if design is None else design, outcomes() if wanted is None else wanted, **({"prior": prior} | options))
            for one in words:
                self.assertIn(one, str(caught.exception))

        refused(["speed at hard: the design has no condition \"hard\"; it has soft, stiff", "sped at soft: the design has no read-out sped",
                 "length at soft: has neither error, runs nor discrepancy", "seeds at soft: (2, 1) is no number and no range"],
                wanted=[Outcome("speed", 1, at="hard", error=1), Outcome("sped", 1, at="soft", error=1), Outcome("length", 1, at="soft"),
                        Outcome("seeds", (2, 1), at="soft", error=1)], discrepancy=0.0)
        refused(["speed at soft: is there twice", "error: -1 is no number from 0 to 1e+100"],
                wanted=[Outcome("speed", 1, at="soft", error=1), Outcome("speed", 2, at="soft", error=-1)])
        refused(["one outcome is needed that is not held back"], wanted=[])
        refused(["5 is no Outcome"], wanted=[5])
        refused(["discrepancy: -1", "row: 'best' is neither", "allowed: -2", "cutoff: 0"], discrepancy=-1, row="best", allowed=-2, cutoff=0)
        refused(["prior: is needed for a data frame"], prior=None)
        refused(["d: design 1 has no such column"], prior=prior | {"d": (0, 1)})
        refused(["no outcome is told by an emulator", "speed at soft: 4 points have it; 9 are needed"],
                design=model(drawn(4, np.random.default_rng(1)), np.random.default_rng(1)))
        with self.assertRaisesRegex(TypeError, "design is 'folder'; a study"):
            calibrate.match("folder", outcomes())


class Spaces(unittest.TestCase):
    def test_a_region_of_a_millionth_is_found_with_its_share(self):
        def off(cube):
            return np.abs(cube - 0.3).max(axis=1)
        cube = _space.whole(6, 1)
        region = _space.below(off, 0.05, cube, off(cube))
        self.assertLess(abs(math.log(region.share / 1e-6)), math.log(1.8))
        np.testing.assert_allclose(region.sample.mean(axis=0), 0.3, atol=0.006)
        np.testing.assert_allclose(region.sample.std(axis=0), 0.1 / math.sqrt(12), rtol=0.15)
        self.assertLess(region.least, 0.05)

    def test_what_is_not_there_is_not_found(self):
        def off(cube):
            return 1 + np.abs(cube - 0.3).max(axis=1)
        cube = _space.whole(3, 1)
        region = _space.below(off, 0.9, cube, off(cube))
        self.assertEqual((len(region.sample), region.share), (0, 0.0))
        self.assertLess(region.least, 1.02)
        place, value = _space.least(off, cube, off(cube))
        self.assertLess(value, 1.002)
        np.testing.assert_allclose(place, 0.3, atol=0.002)


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

[latin_hypercube]
samples = 10
protrusion.force = ["0.2 nN", "0.6 nN"]
"""

    def test_waves_through_the_program(self):
        (self.folder / "wave-1.toml").write_text(self.text)
        first = matrigrate.run_study("wave-1.toml", "wave-1")
        speed = first.results.loc[first.results["label"].str.startswith("stiff: "), "v_migr_abs_um_per_h"]
        wanted = [Outcome("v_migr_abs_um_per_h", float(speed.median()), error=0.05 * float(np.ptp(speed)), at="stiff"),
                  Outcome("v_migr_abs_um_per_h", 0, error=100, at="soft", minus="stiff", held_back=True)]
        match = calibrate.match(first, wanted, discrepancy=0)
        self.assertEqual(match.prior.names, ["protrusion.force_nN"], "the modulus is what the conditions set")
        self.assertEqual(match.waves[0].points, 10)
        self.assertLess(match.waves[0].share, 0.9)
        (self.folder / "next").mkdir()
        points = match.write_study("next/wave-2.toml", 4, first)
        text = (self.folder / "next" / "wave-2.toml").read_text()
        self.assertIn('label = "wave 2, point 4"', text)
        self.assertNotIn("sample 1", text)
        second = matrigrate.run_study("next/wave-2.toml", "wave-2")
        np.testing.assert_allclose(second.results["protrusion.force_nN"].unique(), points["protrusion.force_nN"], rtol=1e-5)
        both = calibrate.match([first, second], wanted, discrepancy=0)
        self.assertEqual([wave.points for wave in both.waves], [10, 14])
        with self.assertRaisesRegex(matrigrate.InputOutputError, "exists already"):
            both.write_study("next/wave-2.toml", 4, first)
        third = both.write_study("wave-3.toml", 2, "next/wave-2.toml")
        self.assertEqual(len(third), 2)
        self.assertIn('label = "wave 3, point 2"', (self.folder / "wave-3.toml").read_text())

    def test_names_of_a_data_frame_need_keys(self):
        (self.folder / "wave-1.toml").write_text(self.text)
        random = np.random.default_rng(1)
        runs = model(drawn(40, random), random)
        match = calibrate.match(runs, outcomes()[:1], prior=prior)
        with self.assertRaisesRegex(matrigrate.ConfigurationError, 'a: is no parameter; keys={"a": "ecm.youngs_modulus"} names the one'):
            match.write_study("next.toml", 3, "wave-1.toml")
        keys = {"a": "contact.fluid_share", "b": "degradation.threshold", "c": "protrusion.least_facing"}
        match.write_study("next.toml", 3, "wave-1.toml", keys=keys)
        text = (self.folder / "next.toml").read_text()
        self.assertRegex(text, r'degradation.threshold = "[0-9.]+ Pa"')
        with self.assertRaises(matrigrate.ConfigurationError):
            match.write_study("bad.toml", 3, "wave-1.toml", keys=keys | {"b": "ecm.poissons_ratio"})
        self.assertFalse((self.folder / "bad.toml").exists(), "what the program refuses is not kept")

    def test_columns_of_parameters(self):
        for column, key in (("contact.cells.adhesion_range_um", "contact.cells.adhesion_range"), ("ecm.youngs_modulus_Pa", "ecm.youngs_modulus"),
                            ("contact.cells.adhesion_Pa", "contact.cells.adhesion"), ("protrusion.number", "protrusion.number"), ("zeta", "")):
            self.assertEqual(key_of(column), key)

    def test_a_design_over_choices_is_refused(self):
        study = matrigrate.load_study(common.runs / "study")
        study.results["ecm.youngs_modulus_Pa"] = ["tied", "free", "tied", "free"]
        with self.assertRaisesRegex(matrigrate.ConfigurationError, "ecm.youngs_modulus_Pa: only numbers can be matched"):
            calibrate.match(study, [Outcome("n_protrusions", 3, error=1)])

    def test_studies_by_condition(self):
        study = matrigrate.load_study(common.runs / "study")
        frame, parameters, _ = _outcomes.runs_of({"one": study, "two": study})
        self.assertEqual(parameters, ["ecm.youngs_modulus_Pa"])
        self.assertEqual(sorted(frame["condition"].unique()), ["one", "two"])
        self.assertEqual(len(frame), 8)


class Limits(unittest.TestCase):
    """What can be run, what is known, what is met nowhere."""

    @staticmethod
    def runs(many=40):
        random = np.random.default_rng(0)
        points = qmc.LatinHypercube(2, seed=1).random(many)
        return pandas.DataFrame([{"a": a, "b": b, "condition": "", "v": 10 * a + random.normal(0, 0.2), "w": 3 + random.normal(0, 0.2), "u": 3.0}
                                 for a, b in points for _ in range(2)])

    prior = {"a": (0, 1), "b": (0, 1)}

    def test_whole_numbers_are_judged_where_they_can_be_run(self):
        random = np.random.default_rng(0)
        frame = pandas.DataFrame([{"protrusion.number": 1 + k % 4, "actomyosin.force_nN": force, "condition": "",
                                   "l_prot_um": 10 * (1 + k % 4) + random.normal(0, 0.3)}
                                  for k, force in enumerate(random.uniform(0.3, 0.6, 40)) for _ in range(2)])
        prior = {"protrusion.number": (1, 4), "actomyosin.force_nN": (0.3, 0.6)}
        between = match(frame, [Outcome("l_prot_um", 25, error=0.5, relative=0.0)], prior=prior)
        self.assertEqual(between.waves[-1].share, 0.0, "2 and 3 are ten errors off")
        self.assertIn(between.best["protrusion.number"], (2, 3))
        three = match(frame, [Outcome("l_prot_um", 30, error=0.5, relative=0.0)], prior=prior)
        self.assertEqual(set(three.next_points(5)["protrusion.number"]), {3})
        self.assertAlmostEqual(three.waves[-1].share, 0.25, delta=0.02, msg="one of four")

    def test_what_points_lack_is_told_for_each_outcome(self):
        runs = self.runs()
        found = match(runs.assign(v=runs["v"].where(runs["a"] <= 0.6)), [Outcome("v", 8, error=0.3)], prior=self.prior)
        self.assertTrue(any(note.startswith("v: 16 of 40 points have no run") for note in found.notes), found.notes)
        self.assertTrue(any("a: 0 to 1 goes above the points that have v" in note for note in found.notes), found.notes)

    def test_what_is_met_nowhere_excludes_everything(self):
        for readout in ("w", "u"):
            found = match(self.runs(), [Outcome(readout, 30, error=0.3), Outcome("v", 5, error=0.3)], prior=self.prior)
            self.assertEqual(found.waves[-1].share, 0.0)
            self.assertTrue(any("at all points, measured is 30: it is met nowhere" in note for note in found.notes), found.notes)
        met = match(self.runs(), [Outcome("w", 3, error=0.3), Outcome("v", 5, error=0.3)], prior=self.prior)
        self.assertTrue(any(note.startswith("w: depends on no parameter") for note in met.notes), met.notes)
        self.assertGreater(met.waves[-1].share, 0.0)

    def test_numbers_that_are_none(self):
        for outcome, said in ((Outcome("v", 1e200, error=1), "is no number and no range"), (Outcome("v", True, error=1), "is no number"),
                              (Outcome("v", 5, error=1e200), "error: 1e+200 is no number from 0 to 1e+100")):
            with self.assertRaises(ConfigurationError) as raised:
                match(self.runs(), [outcome], prior=self.prior)
            self.assertIn(said, str(raised.exception))
        twice = self.runs()
        twice.columns = ["a", "b", "condition", "v", "v", "u"]
        with self.assertRaisesRegex(ConfigurationError, "v: two columns have this name"):
            match(twice, [Outcome("v", 5, error=1)], prior=self.prior)


if __name__ == "__main__":
    unittest.main()
