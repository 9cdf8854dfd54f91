"""Figures: they are drawn, with labels and units, from what the files hold."""
import os
import unittest
import warnings

import common

os.environ["MPLBACKEND"] = "agg"
common.skip_without("matplotlib")

import matrigrate  # noqa: E402
from matplotlib import pyplot  # noqa: E402


class Figures(common.InTemporaryFolder):
    run_ = matrigrate.load(common.runs / "run")
    pair = matrigrate.load(common.runs / "pair")
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

    def test_each_cell_has_its_path(self):
        axes = matrigrate.plot.path(self.pair)
        tracks = self.pair.tracks
        for number, line in zip((1, 2), axes.lines[::3], strict=True):
            self.assertEqual(list(line.get_xdata()), list(tracks.loc[tracks["track"] == number, "x_um"]))
        self.assertEqual([text.get_text() for text in axes.get_legend().get_texts()], ["cell 1", "cell 2"])
        self.drawn(axes)
        both = matrigrate.plot.path({"one": self.run_, "pair": self.pair})
        self.assertEqual([text.get_text() for text in both.get_legend().get_texts()], ["one", "pair"])
        self.assertEqual(len(both.lines), 9)

    def test_each_cell_has_its_outline(self):
        axes = matrigrate.plot.frame(self.pair)
        fields = self.pair.fields
        outline, nucleus = fields["outline/position"][-1], fields["nucleus/position"][-1]
        bodies = sorted((patch.get_xy()[:-1] for patch in axes.patches), key=len)
        self.assertEqual([len(body) for body in bodies], [len(nucleus) // 2] * 2 + [len(outline) // 2] * 2)
        centres = [body[:, 0].mean() for body in bodies]
        self.assertTrue(centres[0] < 0 < centres[1] and centres[2] < 0 < centres[3], centres)
        for body in bodies:
            self.assertLess(max(abs(body - body.mean(axis=0)).ravel()), 40, "no polygon joins the cells")
        self.drawn(axes)

    def test_each_cell_has_its_msd(self):
        axes = matrigrate.plot.msd(self.pair)
        msd = self.pair.msd
        for number, line in zip((1, 2), axes.lines, strict=False):
            self.assertEqual(list(line.get_ydata()), list(msd.loc[msd["cell"] == number, "msd_um2"]))
        self.drawn(axes)

    def test_a_run_too_short_for_lags_says_so(self):
        with warnings.catch_warnings():
            warnings.simplefilter("error")
            axes = matrigrate.plot.msd(self.study.runs[self.study.results["run"][0]])
            self.assertIn("a run of 20 min has the first", axes.texts[0].get_text())
            axes.figure.savefig("figure.png")
        pyplot.close(axes.figure)

    def test_frame(self):
        for field in ("displacement", "pressure", "f_degr", "degradation", "von_mises"):
            axes = matrigrate.plot.frame(self.run_, t=600, field=field)
            self.assertEqual(axes.get_title(), "10 min")
            self.drawn(axes)
        self.assertEqual(matrigrate.plot.frame(self.run_, fluid=True).get_title(), "30 min")
        self.assertEqual(axes.figure.axes[1].get_ylabel(), "von Mises stress [Pa]")
        for wrong in ("colour", "reference", "spacing"):
            with self.assertRaisesRegex(KeyError, f"{wrong}; the fields of the matrix are .*f_degr"):
                matrigrate.plot.frame(self.run_, field=wrong)

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
