"""Figures: they are drawn, with labels and units, from what the files hold."""
import os
import unittest

import common

os.environ["MPLBACKEND"] = "agg"
common.skip_without("matplotlib")

import matrigrate  # noqa: E402
from matplotlib import pyplot  # noqa: E402


class Figures(common.InTemporaryFolder):
    run_ = matrigrate.load(common.runs / "run")
    study = matrigrate.load_study(common.runs / "study")

    def drawn(self, axes):
        self.addCleanup(pyplot.close, axes.figure)
        axes.figure.savefig("figure.png", dpi=60)
        picture = pyplot.imread("figure.png")[..., :3]
        self.assertGreater(len({tuple(pixel) for pixel in picture[::3, ::3].reshape(-1, 3)}), 10, "a blank picture")

    def test_path(self):
        axes = matrigrate.plot.path(self.run_)
        self.assertEqual((axes.get_xlabel(), axes.get_ylabel()), ("x [µm]", "y [µm]"))
        self.assertEqual(list(axes.lines[0].get_xdata()), list(self.run_.tracks["x_um"]))
        self.drawn(axes)
        self.drawn(matrigrate.plot.path(self.study.runs))

    def test_frame(self):
        for field in ("displacement", "pressure", "f_degr", "von_mises"):
            axes = matrigrate.plot.frame(self.run_, t=600, field=field)
            self.assertEqual(axes.get_title(), "10 min")
            self.drawn(axes)
        self.assertEqual(matrigrate.plot.frame(self.run_, fluid=True).get_title(), "30 min")
        with self.assertRaises(KeyError):
            matrigrate.plot.frame(self.run_, field="colour")

    def test_boxes(self):
        axes = matrigrate.plot.boxes(self.study)
        self.assertEqual([label.get_text() for label in axes.get_xticklabels()], ["=soft", "NA"])
        self.assertEqual(axes.get_ylabel(), "speed, start to end [µm/h]")
        self.drawn(axes)
        self.drawn(matrigrate.plot.boxes(self.study, "tau_prot_min"))  # defined in no run
        with self.assertRaisesRegex(KeyError, "the read-outs are"):
            matrigrate.plot.boxes(self.study, "speed")

    def test_msd(self):
        self.drawn(matrigrate.plot.msd(self.run_))
        self.drawn(matrigrate.plot.msd(self.study))  # too short for any lag

    def test_axes_can_be_given(self):
        figure, (left, right) = pyplot.subplots(1, 2)
        self.assertIs(matrigrate.plot.path(self.run_, axes=left), left)
        self.assertIs(matrigrate.plot.msd(self.run_, axes=right), right)
        self.drawn(left)


if __name__ == "__main__":
    unittest.main()
