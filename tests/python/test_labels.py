"""What a person reads in figures and on pages of fits is in words: no code name, no "um", no unit in brackets, no two parameters of one name."""
import html
import json
import os
import pathlib
import re
import shutil
import subprocess
import tarfile
import unittest

import common

os.environ["MPLBACKEND"] = "agg"
common.skip_without("matplotlib", "scipy")

import matrigrate  # noqa: E402
import numpy as np  # noqa: E402
import pandas  # noqa: E402
from matplotlib import pyplot  # noqa: E402
from matrigrate import calibrate, tracks  # noqa: E402
from matrigrate.fit import fit as _fit  # noqa: E402
from matrigrate.fit import report  # noqa: E402
from matrigrate.scenario import schema  # noqa: E402
from matrigrate.draw import words as _words  # noqa: E402
from matrigrate.fit.emulator import Prior  # noqa: E402

code = re.compile(r"[a-z]{2,}_[a-z0-9]|[a-z0-9]_[a-z]{2,}|\bum\b|\[[^\]]*\]")
examples = common.tempfile.TemporaryDirectory()
tarfile.open(common.source / "R" / "inst" / "extdata" / "examples.tar.gz").extractall(examples.name)
study = pathlib.Path(examples.name) / "stiffness-study"


def plain(text):
    """Without what sets an index below the line."""
    return re.sub(r"_\{\\mathrm\{([^}]*)\}\}", r" \1", text)


class Words(unittest.TestCase):
    def test_each_parameter_has_words_of_its_own(self):
        words = {path: _words.noun(parameter) for path, parameter in schema.parameters().items()}
        self.assertEqual(len(set(words.values())), len(words), [path for path in words if list(words.values()).count(words[path]) > 1])
        for path, text in words.items():
            self.assertIsNone(code.search(plain(_words.typeset(text))), path)
        self.assertEqual(_words.title("protrusion.force_nN"), "growth force of a protrusion, F_prot (nN)")
        self.assertEqual(_words.title("actomyosin.force_nN"), "actomyosin force of one strand at full maturation, F_am (nN)")
        self.assertEqual(_words.title("protrusion.number"), "target number of simultaneous protrusions, n_prot")

    def test_each_readout_has_words_of_its_own(self):
        titles = [_words.title(row["name"]) for row in schema.table("readouts.json")]
        self.assertEqual(len(set(titles)), len(titles))
        for title in titles:
            self.assertIsNone(code.search(plain(_words.typeset(title))), title)

    def test_pages_python_and_r_have_one_table_of_colours(self):
        page = (common.source / "viewer" / "src" / "colour.ts").read_text()
        for name in ("palette", "phases", "cell", "cells", "nucleus", "gel", "blue_white_orange"):
            self.assertRegex(page, rf"\bcolours\.{name}\b", "the page takes its colours from the file of which Python takes them")
        known = json.dumps(schema.table("colours.json"))
        for module in ("draw/drawing", "plot", "draw/words"):  # greys of lines apart
            own = set(re.findall("#[0-9a-f]{6}", (common.source / "python" / "matrigrate" / f"{module}.py").read_text()))
            self.assertLessEqual(own, {"#999999", "#666666", "#8a8f98"}, module)
        self.assertEqual(matrigrate.draw.drawing.colours_of(2, 3), ("#1b7837", "#7fc78d"))
        self.assertIn('["#1b7837", "#7fc78d"]', known)
        r = (common.source / "R" / "R" / "plot.R").read_text()
        self.assertEqual(re.findall("#[0-9a-f]{6}", r[r.index("known <- c("):].splitlines()[0]), list(_words.colours))
        least = [re.search(pattern, text) for pattern, text in (
            (r"leastForBox = (\d+)", (common.source / "viewer" / "src" / "study" / "boxes.ts").read_text()), (r"least_for_box <- (\d+)", r))]
        self.assertEqual([int(found[1]) for found in least], [_words.least_for_box] * 2)

    def test_labels_in_the_sources_of_the_program(self):
        label = re.compile(r'(?:(?:x|y|value)_label = |(?:checks|claims|remarks)\.push_back\([^;"]*)"([^"]*)"')
        unit = re.compile(r"\bum\b|\[(?:[-1%]|u?m|nN|k?Pa|Pa s|min|s|um/.*|degrees)\]")
        sources = [path for folder in ("validation", "run/draw", "study/study_report") for path in (common.source / "src" / folder).glob("*.cpp")]
        labels = [text for path in sources for text in label.findall(path.read_text(encoding="utf-8"))]
        self.assertGreater(len(labels), 100)
        self.assertEqual([text for text in labels if unit.search(text)], [])

    def test_r_names_the_section_where_the_last_word_is_shared(self):
        last = [path.split(".")[-1] for path in schema.parameters() if not re.search(r"fields?\.", path)]
        r = (common.source / "R" / "R" / "plot.R").read_text()
        shared = re.findall(r'"(\w+)"', re.search(r"\.shared_words <- c\(([^)]*)\)", r)[1])
        self.assertEqual(shared, sorted({word for word in last if last.count(word) > 1}))
        if not shutil.which("Rscript"):
            return
        table = 'data.frame(run = "a", label = c("force 0.2 nN", "force 0.4 nN"), protrusion.force_nN = c(0.2, 0.4), replicate = 1)'
        code_of_r = (f'source("{common.source}/R/matrigrate.R"); f <- get(".points_of", envir = environment(plot_boxes)); t <- {table}; '
                     'cat(f(t, t$label)$title)')
        done = subprocess.run(["Rscript", "--vanilla", "-e", code_of_r], capture_output=True, text=True)
        self.assertEqual((done.stdout, done.returncode), ("protrusion: force (nN)", 0), done.stderr)

    def test_numbers_and_ticks_are_round(self):
        prior = Prior(["a", "b", "c"], np.array([0.1, 3e-4, 20.0]), np.array([0.6, 0.9, 90.0]), [False, True, True], [False] * 3)
        self.assertEqual([report.ticks(prior, k)[1] for k in range(3)], [["0.2", "0.4", "0.6"], ["0.001", "0.01", "0.1"], ["20", "50"]])


class Figures(unittest.TestCase):
    study = matrigrate.load_study(study)

    def read(self, axes):
        self.addCleanup(pyplot.close, axes.figure)
        axes.figure.draw_without_rendering()
        texts = [plain(text.get_text()) for text in axes.figure.findobj(pyplot.Text) if text.get_visible() and text.get_text()]
        self.assertGreater(len(texts), 3)
        for text in texts:
            self.assertIsNone(code.search(text), text)
        return texts

    def test_of_a_study(self):
        axes = matrigrate.plot.boxes(self.study)
        texts = self.read(axes)
        self.assertEqual([label.get_text() for label in axes.get_xticklabels()], ["50", "200"])
        self.assertEqual(axes.get_xlabel(), "Young's modulus of the intact matrix, E (Pa)")
        self.assertIn("speed, start to end, $v migr,abs$ (µm/h)", texts)
        self.assertEqual(len(axes.lines), 2, "dots of four runs, and no box")
        counts = matrigrate.plot.boxes(self.study, "n_protrusions")
        self.assertTrue(all(float(tick).is_integer() for tick in counts.get_yticks()))
        self.read(counts)

    def test_runs_are_named_by_their_points(self):
        axes = matrigrate.plot.path(self.study.runs)
        self.read(axes)
        self.assertEqual([text.get_text() for text in axes.get_legend().get_texts()], ["E = 50 Pa", "E = 200 Pa"])
        curves = matrigrate.plot.msd(self.study)
        self.read(curves)
        self.assertEqual([text.get_text() for text in curves.get_legend().get_texts()], ["E = 50 Pa", "E = 200 Pa"])

    def test_labels_of_the_author_stand_as_they_are(self):
        labels = {"youngs_modulus 50 Pa": "_control, $5 to $10 a_b", "youngs_modulus 200 Pa": "$$f_mat$$ \\alpha & <b>"}
        with common.tempfile.TemporaryDirectory() as folder:
            copy = pathlib.Path(shutil.copytree(study, pathlib.Path(folder) / "study"))
            for name in ("results.csv", "msd.csv"):
                text = (copy / name).read_text()
                for made, own in labels.items():
                    text = text.replace(made, f'"{own}"')
                (copy / name).write_text(text)
            of_own = matrigrate.load_study(copy)
            for axes in (matrigrate.plot.path(of_own.runs), matrigrate.plot.msd(of_own), matrigrate.plot.path({own: run for own, run in zip(labels.values(), of_own.runs.values())}),
                         matrigrate.plot.boxes(of_own)):
                self.addCleanup(pyplot.close, axes.figure)
                axes.figure.draw_without_rendering()
                texts = axes.get_legend().get_texts() if axes.get_legend() else axes.get_xticklabels()
                self.assertEqual([text.get_text() for text in texts], ["\u200b_control, \\$5 to \\$10 a_b", "\\$\\$f_mat\\$\\$ \\alpha & <b>"])
                self.assertEqual([text._preprocess_math(text.get_text()) for text in texts], [(f"\u200b{one}" if one[0] == "_" else one, False) for one in labels.values()])

    def test_words_and_values_of_the_user_in_one_label(self):
        self.assertEqual(_words.setting("protrusion.force_nN", 0.2), "$F_{\\mathrm{prot}}$ = 0.2 nN")
        self.assertEqual(_words.setting("ecm.fields.youngs_modulus", "a_b$.csv"), "ecm fields: youngs modulus a_b\\$.csv")

    def test_the_scale_bar_is_where_no_cell_is(self):
        seen = ((0.0, 100.0), (0.0, 100.0))
        corner = [np.array([[5.0, 5.0], [20.0, 8.0]])]
        self.assertEqual(matrigrate.draw.drawing.free_corners(seen, []), ["lower left", "lower right"])
        self.assertEqual(matrigrate.draw.drawing.free_corners(seen, corner), ["lower right", "upper left"])


class Pages(unittest.TestCase):
    def fitted(self):
        random = np.random.default_rng(2)
        parameters = pandas.DataFrame({"protrusion.force_nN": random.uniform(0.2, 2.0, 60), "actomyosin.force_nN": np.exp(random.uniform(0, 5, 60)),
                                       "adhesion.r_off_min_per_s": random.uniform(0, 1, 60)})
        seen = [self.walks(row, 2, random) for row in parameters["protrusion.force_nN"]]
        values = pandas.DataFrame([one.readouts(resamples=0)["value"][["speed_um_per_h", "turning_cosine"]] for one in seen]).reset_index(drop=True)
        measured = self.walks(1.2, 15, random)
        measured.source = "cells.csv"
        return _fit.of_points(common.points_of(parameters, values, 40, seen)).fit(measured)

    def walks(self, speed, many, random):
        return tracks.Tracks({str(k): np.cumsum(random.normal(0.2, speed, (40, 2)), axis=0) for k in range(many)}, 60.0, [])

    def read(self, page):
        text = re.sub(r"<style>.*?</style>|<defs>.*?</defs>|<h\d>.*?</h\d>", "", page, flags=re.DOTALL)
        text = re.sub(r"<text[^>]*>|<t[dh]>|</t[dh]>|</text>|<figcaption>", "\n", text)
        for line in html.unescape(re.sub(r"<(?!/?sub)[^>]*>", "", text).replace("<sub>", " ").replace("</sub>", "")).splitlines():
            self.assertIsNone(code.search(line), line)

    def test_of_a_fit(self):
        fit = self.fitted()
        with common.tempfile.TemporaryDirectory() as folder:
            page = fit.write(pathlib.Path(folder) / "fit").read_text()
            self.read(page)
            for part in ("cells.csv", "15, every 60 s", "<dt>seed</dt><dd>1</dd>", "<dt>date</dt>", "prefers-color-scheme:dark", "F<sub>prot</sub> (nN)",
                         "F<sub>am</sub> (nN)", "currentColor"):
                self.assertIn(part, page)
            if "MATRIGRATE_KEEP" in os.environ:
                (pathlib.Path(os.environ["MATRIGRATE_KEEP"]) / "fit.html").write_text(page)

    def test_of_a_fit_at_conditions(self):
        random = np.random.default_rng(3)
        points = pandas.DataFrame({"protrusion.force_nN": random.uniform(0.2, 2.0, 40), "ecm.viscosity_Pa_s": 10**random.uniform(1, 4, 40)})
        runs = points.assign(condition="5to10_gel $", l_prot_um=5 * points["protrusion.force_nN"] + np.log10(points["ecm.viscosity_Pa_s"]) + random.normal(0, 0.1, 40))
        fit = calibrate.fit(runs, {"5to10_gel $": {"l_prot_um": ((8.0, 9.0), 0.5)}}, prior={"protrusion.force_nN": (0.2, 2.0), "ecm.viscosity_Pa_s": (10.0, 1e4, "log")})
        with common.tempfile.TemporaryDirectory() as folder:
            page = fit.write(pathlib.Path(folder) / "fit").read_text()
            self.assertIn("at 5to10_gel $", page)
            self.read(page.replace("5to10_gel $", ""))
            self.assertIn("viscosity of the matrix, μ (Pa s)", page)

    def test_a_density_is_even_up_to_the_ends(self):
        at, values = report.density(np.random.default_rng(1).random((20000, 1)))
        self.assertLess(np.abs(values - 1).max(), 0.1)
        self.assertAlmostEqual(values.mean(), 1.0)
        _, both = report.density(np.random.default_rng(1).random((20000, 2)), 40)
        self.assertLess(np.abs(both - 1).max(), 0.3)
        self.assertAlmostEqual(float((both >= report.level_of(0.5, both)).sum() / both.size), 0.5, delta=0.06)


if __name__ == "__main__":
    unittest.main()
