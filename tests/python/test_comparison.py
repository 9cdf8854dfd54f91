"""Comparisons of groups of cells against models whose parameters are known; what is refused, said and written."""
import contextlib
import io
import math
import pathlib
import unittest
import unittest.mock

import common

common.skip_without("scipy", "matplotlib")

import numpy as np  # noqa: E402
import pandas  # noqa: E402
from matrigrate import calibrate, compare, tracks  # noqa: E402
from matrigrate.errors import ConfigurationError  # noqa: E402
from matrigrate.fit import fit as _fit, hypotheses, report  # noqa: E402
from scipy.stats import qmc  # noqa: E402

prior = {"a": (0.0, 1.0), "b": (1.0, 10.0, "log")}


def runs(many=24, seed=1):
    """Speed rises with both parameters, length falls with b alone."""
    random = np.random.default_rng(seed)
    cube = qmc.LatinHypercube(2, seed=seed).random(many)
    return pandas.DataFrame({"a": cube[:, 0], "b": 10**cube[:, 1], "speed": 5 + 10 * cube[:, 0] + 3 * cube[:, 1] + random.normal(0, 0.2, many),
                             "length": 20 - 6 * cube[:, 1] + random.normal(0, 0.2, many)})


def walks(speed, turning, n, random, start=0, interval=60.0):
    """Of a speed [um/min] and a spread of turning angles [rad]."""
    angles = np.cumsum(random.normal(0, turning, (n, 40)), axis=1)
    steps = speed * random.gamma(4, 0.25, (n, 40, 1)) * np.stack([np.cos(angles), np.sin(angles)], axis=2)
    return tracks.Tracks({str(start + k): np.cumsum(one, axis=0) for k, one in enumerate(steps)}, interval, [])


class OfNumbers(unittest.TestCase):
    measured = {"speed": (10.5, 0.2), "length": (17.0, 0.2)}  # at a = 0.4 and log10 b = 0.5

    @classmethod
    def setUpClass(cls):
        cls.found = calibrate.compare(runs(), cls.measured, {"drug": {"speed": (14.5, 0.2), "length": (17.02, 0.2)},
                                                             "washout": {"speed": (10.6, 0.2), "length": (16.95, 0.2)}}, prior=prior)

    def test_the_parameter_that_a_treatment_changed_is_named(self):
        rows = self.found.table.query("group == 'drug'").set_index("differs")
        self.assertEqual(list(rows.index), ["nothing", "a", "b", "everything"])
        self.assertEqual(list(rows.index[rows["candidate"]]), ["a"])
        self.assertTrue(rows.loc["a", "ratio_5"] < 2.0 < rows.loc["a", "ratio_95"])
        self.assertGreater(rows.loc["a", "over_nothing"], rows.loc["a", "over_nothing_error"])
        self.assertGreater(rows.loc["a", "p"], 0.1)
        self.assertLess(max(rows.loc["nothing", "p"], rows.loc["b", "p"]), 0.01)
        self.assertIn("drug: if one parameter differs, it is a (1 of the probability)", self.found.words)

    def test_nothing_differs(self):
        self.assertLess(self.found.something["washout"], 1)
        self.assertFalse(self.found.table.query("group == 'washout'")["candidate"].any())
        own = [word for word in self.found.words if word.startswith("washout: ")]
        self.assertTrue(own[0].startswith("washout: nothing differs, as far as these data tell"), own)
        self.assertRegex(own[1], r"washout: a may still differ by a factor of 1 \(0\.\d+ to 1\.\d+\)")

    def test_the_page(self):
        with common.tempfile.TemporaryDirectory() as folder:
            page = self.found.write(pathlib.Path(folder) / "page")
            text = page.read_text()
            self.assertEqual(text.count("<svg"), 2)
            self.assertIn("<h2>washout beside control</h2>", text)
            self.assertNotIn("http", text)
            self.assertEqual(len(pandas.read_csv(page.parent / "comparison.csv")), 8)
        pair = report.named("ecm.youngs_modulus_Pa + protrusion.force_nN")
        self.assertRegex(pair, r"^Young.* E \(Pa\) \+ growth force of a protrusion, F.*\(nN\)$")

    def test_the_probability_of_the_data_is_that_of_a_model_in_closed_form(self):
        """Of v = 10 a, nothing but a may differ: control 5, treated 6, errors 0.3."""
        frame = pandas.DataFrame({"a": np.linspace(0, 1, 30)}).assign(v=lambda one: 10 * one["a"] + np.random.default_rng(1).normal(0, 0.01, 30))
        with unittest.mock.patch.multiple(hypotheses, _tries=40000, _enough=10000, _few=2000):
            found = calibrate.compare(frame, {"v": (5, 0.3)}, {"v": (6, 0.3)}, prior={"a": (0, 1)})
        same = math.exp(-0.5 / (2 * 0.3**2)) / (0.3 * math.sqrt(4 * math.pi))  # density of the difference
        self.assertAlmostEqual(found.something["treated"] / (0.1 / same), 1, delta=0.05)
        score = found.table.set_index("differs").loc["a", "over_nothing"]
        self.assertAlmostEqual(score, 2 * math.log(0.1 / same), delta=0.1, msg="if a differs, the one tells nothing of the other")

    def test_what_cannot_be_told(self):
        found = calibrate.compare(runs(), {"speed": (10.0, 0.2)}, {"speed": (12.0, 0.2)}, prior=prior)
        self.assertTrue(any(word.startswith("treated: these data cannot tell ") and " from " in word for word in found.words), found.words)

    def test_what_is_known_explains(self):
        found = calibrate.compare(runs(), self.measured, {"speed": (14.5, 0.2), "length": (17.02, 0.2)}, prior=prior, known={"a": (0.4, 0.8)})
        self.assertEqual(list(found.table["differs"]), ["nothing", "b"])
        self.assertLess(found.something["treated"], 1)
        self.assertEqual(found.source["known a"], "0.4, 0.8")

    def refused(self, words, *arguments, **options):
        with self.assertRaises(ConfigurationError) as caught:
            calibrate.compare(runs(), *arguments, **({"prior": prior} | options))
        for one in words:
            self.assertIn(one, str(caught.exception))

    def test_refused(self):
        other = {"speed": (14.5, 0.2), "length": (17.0, 0.2)}
        self.refused(["treated: has the numbers of control: give each group its own"], self.measured, dict(reversed(self.measured.items())))
        self.refused(["no read-out was measured in all groups: control has speed; treated has length"], {"speed": (1, 1)}, {"length": (1, 1)})
        self.refused(["known: c: is no parameter of the study, which varies a, b", "parameters: ecm.youngs_modulus: has no range in the study"],
                     self.measured, other, known={"c": (1, 2)}, parameters=["a", "ecm.youngs_modulus"])
        self.refused(["known: a: (1, 2, 3) are no 2 numbers: one for control, one for treated"], self.measured, other, known={"a": (1, 2, 3)})
        self.refused(["known: a: 3 lies outside of 0 to 1, the range of the study"], self.measured, other, known={"a": (0.5, 3)})
        self.refused(["parameters: none is left that may differ"], self.measured, other, known={"a": (0.5, 0.6)}, parameters=["a"])
        self.refused(["besides: drug: there is no such group; there are control, treated"], self.measured, other, besides={"drug": {}})
        self.refused(["treated: speed: is a range"], self.measured, {"speed": ((1, 2), 1), "length": (17, 1)})
        self.refused(["drug: speed: has no standard error above 0"], self.measured, {"drug": other | {"speed": (1, 0)}})
        self.refused(["control: is one group"], {"first": self.measured}, other)
        self.refused(["treated: control: is the name of the first group"], self.measured, {"control": other})


class OfTracks(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.random = random = np.random.default_rng(2)
        parameters = pandas.DataFrame(random.uniform([0.5, 0.1], [3.0, 1.0], (40, 2)), columns=["speed", "turning"])
        seen = [walks(row.speed, row.turning, 1, random, k) for k, row in enumerate(parameters.itertuples())]
        names = ["speed_um_per_h", "turning_cosine"]
        values = pandas.DataFrame([one.readouts(resamples=0)["value"][names] for one in seen]).reset_index(drop=True)
        cls.emulators = _fit.of_points(common.points_of(parameters, values, 40, seen))
        cls.control = walks(1.4, 0.6, 10, random)

    def test_cells_that_turn_less(self):
        found = calibrate.compare(self.emulators, self.control, walks(1.4, 0.3, 10, self.random))
        rows = found.table.set_index("differs")
        self.assertEqual(list(rows.index[rows["candidate"]]), ["turning"])
        self.assertTrue(rows.loc["turning", "ratio_5"] < 0.5 < rows.loc["turning", "ratio_95"], rows)
        self.assertGreater(rows.loc["turning", "over_nothing"], 2 * rows.loc["turning", "over_nothing_error"])

    def test_cells_of_the_same_parameters(self):
        found = calibrate.compare(self.emulators, self.control, walks(1.4, 0.6, 10, self.random))
        self.assertLess(found.something["treated"], 3)
        self.assertIn("nothing differs", found.words[0])

    def test_refused(self):
        for words, treated in ((["treated: has one cell; 2 read-outs of tracks need 4"], walks(1.4, 0.6, 1, self.random)),
                               (["treated: has a position every 120 s, control every 60 s", "every(120), or `matrigrate tracks FILE --every 120"], walks(1.4, 0.6, 9, self.random, 0, 120.0)),
                               (["treated: 10 of 10 tracks are tracks of control: give each group its own"],
                                tracks.Tracks({f"x{name}": track + 5.0 for name, track in self.control.items()}, 60.0, []))):
            with self.assertRaises(ConfigurationError) as caught:
                calibrate.compare(self.emulators, self.control, treated)
            for one in words:
                self.assertIn(one, str(caught.exception))


class OfFiles(common.InTemporaryFolder):
    """The command line."""

    def setUp(self):
        super().setUp()
        random = np.random.default_rng(2)
        for name, start, n in (("control", 0, 6), ("drug", 10, 6), ("one", 20, 1)):
            walks(1.4, 0.3, n, random, start).table().to_csv(f"{name}.csv", index=False)
        walks(1.4, 0.3, 6, random, 0, 120.0).table().to_csv("slow.csv", index=False)
        runs().rename(columns={"speed": "speed_um_per_h"}).assign(speed_um_per_h=lambda one: 8 * one["speed_um_per_h"]).to_csv("design.csv", index=False)
        pathlib.Path("numbers.csv").write_text("group,readout,mean,error\ncontrol,length,17,0.2\ndrug,length,15,0.2\n")

    def called(self, *words, design="design.csv", prior=("a=0:1", "b=1:10:log")):
        out, err = io.StringIO(), io.StringIO()
        ranges = [word for one in prior for word in ("--prior", one)]
        with contextlib.redirect_stdout(out), contextlib.redirect_stderr(err):
            code = compare.main([design, "control.csv", "--readouts", "speed_um_per_h", "-o", "out", *ranges, *words])
        return code, out.getvalue(), err.getvalue()

    def test_sentences_and_page(self):
        pathlib.Path("out").mkdir()
        words = ["drug=drug.csv", "--besides", "numbers.csv", "--known", "a=0.4:0.4", "--no-scores"]
        self.assertEqual(self.called(*words), (5, "", "out: exists already; give a new folder, or force\n"))
        code, out, err = self.called(*words, "--error", "0.1", "--force")
        self.assertEqual(code, 0, err)
        self.assertEqual(err, "error: 0.1 um is not added: no read-out is computed from simulated tracks\n")
        self.assertTrue(pathlib.Path("out/report.html").is_file())
        found = calibrate.compare(pandas.read_csv("design.csv"), tracks.read("control.csv"), {"drug": tracks.read("drug.csv")},
                                  ["speed_um_per_h"], besides={"control": {"length": (17, 0.2)}, "drug": {"length": (15, 0.2)}},
                                  prior=prior, known={"a": (0.4, 0.4)}, scores=False)
        self.assertEqual(out.splitlines(), found.words)
        self.assertIn("drug: b may still differ by a factor of ", out)
        self.assertEqual(list(found.table["differs"]), ["nothing", "b"])
        pandas.testing.assert_frame_equal(pandas.read_csv("out/comparison.csv"), found.table, check_dtype=False)

    def test_refused(self):
        pathlib.Path("twice.csv").write_text("group,readout,mean,error\n" + 2 * "control,length,17,0.2\n")
        pathlib.Path("other.csv").write_text("group;mean\n")
        for code, fault, words, more in (
            (5, "no.csv: cannot be read: No such file or directory\nnone.csv: cannot be read: No such file or directory\n",
             ["no.csv", "--besides", "none.csv"], {}),
            (5, "none: there is no such folder\n", ["drug.csv"], {"design": "none"}),
            (3, "prior: is needed for a table: it names the parameters and their ranges\n", ["drug.csv"], {"prior": ()}),
            (3, "prior: b: (1.0, 'ten') is no range (low, high)", ["drug.csv"], {"prior": ("a=0:1", "b=1:ten")}),
            (3, "control: sped: has no measured value; tracks have speed_um_per_h, ", ["drug.csv", "--readouts", "sped"], {}),
            (3, "one.csv: has 1 track of at least 4 positions; 2 are needed", ["one.csv"], {}),
            (3, "treated: has a position every 120 s, control every 60 s", ["slow.csv"], {}),
            (3, "treated: 6 of 6 tracks are tracks of control: give each group its own\n", ["control.csv"], {}),
            (3, "treated: two groups have this name; give LABEL=FILE\n", ["drug.csv", "slow.csv"], {}),
            (3, "known: c: is no parameter of the study, which varies a, b\nknown: a: (0.5, 'x') are no 2 numbers: one for control, "
             "one for treated\n", ["drug.csv", "--known", "c=1:2", "--known", "a=0.5:x"], {}),
            (3, "parameters: c: is no parameter of the study", ["drug.csv", "--parameters", "a,c"], {}),
            (3, "error: -1 um is no localisation error\n", ["drug.csv", "--error", "-1"], {}),
            (3, "twice.csv: has two rows of control, length\n", ["drug.csv", "--besides", "twice.csv"], {}),
            (3, "other.csv: has no column group, readout, mean, error, but group;mean\n", ["drug.csv", "--besides", "other.csv"], {}),
            (3, "besides: drug: there is no such group; there are control, treated\n", ["drug.csv", "--besides", "numbers.csv"], {}),
        ):
            with self.subTest(fault):
                own, out, err = self.called(*words, **more)
                self.assertEqual((own, out), (code, ""))
                self.assertTrue(err.startswith(fault), err)
                self.assertFalse(pathlib.Path("out").exists())


if __name__ == "__main__":
    unittest.main()
