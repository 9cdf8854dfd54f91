"""Figures: they are drawn, with labels and units, from what the files hold."""
import os
import unittest
import warnings

import common

os.environ["MPLBACKEND"] = "agg"
common.skip_without("matplotlib")

import matrigrate  # noqa: E402
import numpy as np  # noqa: E402
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
        self.assertEqual((axes.get_xlabel(), axes.get_ylabel()), ("x (µm)", "y (µm)"))
        self.assertEqual(list(axes.lines[0].get_xdata()), list(self.run_.tracks["x_um"]))
        self.drawn(axes)
        self.drawn(matrigrate.plot.path(self.study.runs))

    def test_measured_tracks(self):
        random = np.random.default_rng(2)
        cells = matrigrate.tracks.Tracks({str(k): np.cumsum(random.normal(0, 1, (20, 2)), axis=0) for k in range(5)}, 60.0, [])
        axes = matrigrate.plot.path(cells)
        np.testing.assert_array_equal(axes.lines[0].get_xdata(), cells["0"][:, 0])
        self.drawn(axes)
        axes = matrigrate.plot.path(cells, together=True)
        self.assertEqual((axes.lines[0].get_xdata()[0], axes.lines[0].get_ydata()[0]), (0.0, 0.0))
        self.drawn(axes)
        axes = matrigrate.plot.msd(cells)
        np.testing.assert_allclose(axes.lines[0].get_ydata(), cells.msd()["msd_um2"].dropna())
        self.drawn(axes)
        figure = matrigrate.plot.quality(cells)
        self.assertEqual([one.get_title() for one in figure.axes], ["leaps: 0", "doubles: 0", "drift: sum of mean steps"])
        self.drawn(figure.axes[0])

    def test_a_run_in_a_notebook_shows_its_pictures(self):
        shown = self.run_._repr_html_()
        self.assertIn("seed", shown)
        self.assertIn('<img src="data:image/png;base64,', shown)
        self.assertEqual(pyplot.get_fignums(), [])

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
        together = matrigrate.plot.path(self.pair, together=True)
        for number, line in zip((1, 2), together.lines[::3], strict=True):
            x = tracks.loc[tracks["track"] == number, "x_um"]
            self.assertEqual(list(line.get_xdata()), list(x - x.iloc[0]))
        self.addCleanup(pyplot.close, together.figure)

    def test_each_cell_has_its_outline(self):
        axes = matrigrate.plot.frame(self.pair)
        bodies = {patch.get_gid(): patch.get_xy()[:-1] for patch in axes.patches if patch.get_gid()}
        self.assertEqual(sorted(bodies), ["cell 1", "cell 2", "nucleus 1", "nucleus 2"])
        for number, cell in self.pair.cells.items():
            np.testing.assert_array_equal(bodies[f"cell {number}"], cell.outline())
            np.testing.assert_array_equal(bodies[f"nucleus {number}"], cell.nucleus())
        fills = {patch.get_facecolor() for patch in axes.patches}
        self.assertGreaterEqual(len(fills), 5, "rear and front of both cells, and nuclei")
        words = [text.get_text() for text in axes.get_legend().get_texts()]
        self.assertEqual(words[:3], ["cell 1: rear, front", "cell 2", "nucleus"])
        self.assertEqual([text.get_text() for text in axes.texts if text.get_text() in "12"], ["1", "2"])
        self.drawn(axes)

    def test_the_window_is_what_was_asked_for(self):
        def seen(**options):
            axes = matrigrate.plot.frame(self.pair, hide=("legend",), **options)
            self.addCleanup(pyplot.close, axes.figure)
            return (*axes.get_xlim(), *axes.get_ylim())

        whole = seen(window="all")
        self.assertGreater(whole[1], 75)
        self.assertEqual(seen(window=(-10, 30, 0, 20)), (-10, 30, 0, 20))
        middle = self.pair.cells[2].outline().mean(axis=0)
        followed = seen(window=50, follow=2)
        np.testing.assert_allclose(followed, (middle[0] - 25, middle[0] + 25, middle[1] - 25, middle[1] + 25), rtol=1e-5)
        own = seen()
        for k in range(len(self.pair.fields.times)):
            for outline in self.pair.fields.outlines(k).values():
                self.assertTrue(own[0] < outline[:, 0].min() and outline[:, 0].max() < own[1])
        self.assertEqual(own, seen(t=0), "the same at all times")
        size = lambda limits: limits[1] - limits[0]  # noqa: E731
        self.assertAlmostEqual(size(seen(follow=1)), size(seen(follow=1, t=0)), places=4)
        self.assertGreater(size(seen(follow=True)), size(seen(follow=1)))
        for options, words in (({"window": 0}, "window: 0 is neither a width"), ({"window": (0, 1, 2)}, "no left, right"),
                               ({"window": (5, 1, 0, 2)}, "no left, right"), ({"follow": 3}, "no cell 3; the cells are 1, 2"),
                               ({"window": (0, 1, 0, 1), "follow": 1}, "it is the width"), ({"hide": ("bar",)}, "there is no bar")):
            with self.assertRaisesRegex(ValueError, words):
                matrigrate.plot.frame(self.pair, **options)

    def test_the_colour_bar_says_which_end_is_intact(self):
        for field in ("f_degr", "degradation"):
            axes = matrigrate.plot.frame(self.pair, field=field)
            words = [other.get_ylabel() for other in axes.figure.axes]
            self.assertIn("intact matrix, $f_{\\mathrm{degr}}$: 0 fluid, 1 intact", words)
            self.drawn(axes)

    def test_parts_can_be_hidden(self):
        every = matrigrate.plot.frame(self.pair)
        bar = [artist for artist in every.artists if artist.get_gid() == "scale bar"]
        self.assertEqual((len(bar), every.get_xlabel(), len(every.figure.axes)), (1, "", 2))
        self.assertIn("20 µm", [text.get_text() for text in bar[0].findobj(pyplot.Text)])
        bare = matrigrate.plot.frame(self.pair, hide=matrigrate.draw.drawing.overlays)
        self.assertEqual((list(bare.patches), list(bare.lines), list(bare.texts)), ([], [], []))
        self.assertEqual((bare.get_xlabel(), bare.get_legend(), len(bare.figure.axes)), ("x (µm)", None, 1))
        self.drawn(every)
        self.drawn(bare)

    def test_fibres_are_the_bonds_of_the_lattice(self):
        fields = self.run_.fields
        reference, spacing = fields["matrix/reference"][:, :2].astype(float), float(fields["matrix/spacing"][0])
        scenario = {"ecm": self.run_.scenario["ecm"],
                    "fibres": {"arrangement": "uniaxial", "direction_deg": 0, "half_angle_deg": 30}}
        bonds = matrigrate.draw.fibres.bonds_of(fields, scenario)
        self.assertGreater(len(bonds), 0)
        self.assertLess(np.abs(bonds[:, 1] / bonds[:, 0]).max(), np.tan(np.radians(30.1)))
        pairs = matrigrate.draw.fibres.pairs_of(reference, bonds)
        self.assertGreater(len(pairs), 0.9 * len(bonds) * len(reference) * (1 - 8 * spacing / 60))
        ways = reference[pairs[:, 1]] - reference[pairs[:, 0]]
        self.assertLess(max(np.hypot(*(bonds - way).T).min() for way in ways[::50]), 1e-3)
        isotropic = matrigrate.draw.fibres.bonds_of(fields, scenario | {"fibres": {"arrangement": "isotropic"}})
        self.assertGreater(len(isotropic), len(bonds))
        axes = matrigrate.plot.frame(self.run_)
        self.addCleanup(pyplot.close, axes.figure)
        self.assertIsNone(matrigrate.draw.fibres.paint(axes, fields, self.run_.scenario, 0), "a run without fibres")
        self.assertIsNotNone(matrigrate.draw.fibres.paint(axes, fields, scenario, -1))
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
        self.assertEqual(axes.figure.axes[1].get_ylabel(), "von Mises stress (Pa)")
        for wrong in ("colour", "reference", "spacing"):
            with self.assertRaisesRegex(KeyError, f"{wrong}; the fields of the matrix are .*f_degr"):
                matrigrate.plot.frame(self.run_, field=wrong)

    def test_what_the_scenario_gives_the_matrix(self):
        scenario = matrigrate.Scenario.load(common.runs / "cell.toml")
        scenario.ecm.fields.youngs_modulus = "x < 20 ? 100 : 300"
        scenario.ecm.fields.obstacle = "x > 40 && abs(y) < 6"
        run = matrigrate.run(scenario, out="given", hours=0.02, overrides={"output.report": False})
        axes = matrigrate.plot.frame(run, field="youngs_modulus", window="all")
        self.assertEqual(axes.figure.axes[1].get_ylabel(), "Young's modulus (Pa)")
        self.assertEqual(axes.figure.axes[1].get_ylim(), (100, 300))
        solid = run.fields["matrix/obstacle"][...] == 1
        drawn = [len(part.get_paths()) for part in axes.collections if len(part.get_paths())]
        self.assertIn(int(solid.sum()), drawn)
        self.assertGreater(solid.sum(), 3)
        self.drawn(axes)

    def test_boxes(self):
        axes = matrigrate.plot.boxes(self.study)
        self.assertEqual([label.get_text() for label in axes.get_xticklabels()], ["=soft", "NA"])
        self.assertEqual(axes.get_ylabel(), "speed, start to end, $v_{\\mathrm{migr,abs}}$ (µm/h)")
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
