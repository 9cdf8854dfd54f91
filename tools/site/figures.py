#!/usr/bin/python3
"""Draws the figures of the kept results (docs/validation) as SVG, by the Python package: figures.py FOLDER

Of each study whose tables are kept: box plots, paths, shapes, mean square displacements, forces of adhesions (Figs 5, 7, 9, 11
and 12 of the paper), and the stress of fibres around a cell (Fig 13). tools/site/build.py puts them into the site.

    figures.py --fibre-stress RUN    prints the table of Fig 13, made of the last frame of a run among fibres
"""
import os
import pathlib
import shutil
import sys
import tempfile

root = pathlib.Path(__file__).resolve().parents[2]
sys.path.insert(0, str(root / "python"))
os.environ["MPLBACKEND"] = "agg"

import matrigrate  # noqa: E402
import numpy as np  # noqa: E402
import pandas  # noqa: E402
from matplotlib import pyplot  # noqa: E402

kept = root / "docs/validation"
readouts = ("v_migr_abs_um_per_h", "v_migr_path_60s_um_per_h", "n_protrusions", "tau_prot_min", "l_prot_um", "f_mat")


def study_of(name, folder):
    """The kept tables of a study, as the package reads them."""
    for table in ("results", "msd"):
        if (kept / f"{name}-{table}.csv").exists():
            shutil.copy(kept / f"{name}-{table}.csv", pathlib.Path(folder) / f"{table}.csv")
    (pathlib.Path(folder) / "study.resolved.toml").touch()
    return matrigrate.load_study(folder)


def boxes(name):
    with tempfile.TemporaryDirectory() as folder:
        figure, axes = pyplot.subplots(2, 3, figsize=(12, 7), layout="constrained")
        for one, readout in zip(axes.flat, readouts, strict=True):
            matrigrate.plot.boxes(study_of(name, folder), readout, one)
    return figure


def msd(name):
    with tempfile.TemporaryDirectory() as folder:
        return matrigrate.plot.msd(study_of(name, folder)).figure


def by_point(table, draw, **labels):
    """A panel a point, titled by its label. draw(axes, rows of the point)"""
    points = list(table.groupby("point", sort=False))
    figure, axes = pyplot.subplots(1, len(points), figsize=(3.2 * len(points), 3.2), sharex=True, sharey=True, layout="constrained", squeeze=False)
    for one, (label, rows) in zip(axes[0], points, strict=True):
        draw(one, rows)
        one.set(title=label.replace("_", " "), **{key: value for key, value in labels.items() if key != "ylabel" or one is axes[0][0]})
    return figure


def paths(name):
    def draw(axes, rows):
        for _, run in rows.groupby("replicate"):
            axes.plot(run["x_um"], run["y_um"], linewidth=1)
    return by_point(pandas.read_csv(kept / f"{name}-paths.csv"), draw, xlabel="x (µm)", ylabel="y (µm)", aspect="equal")


def shapes(name):
    """Where three cells ended, below each other."""
    def draw(axes, rows):
        for k, (_, run) in enumerate(rows.groupby("replicate")):
            axes.fill(run["x_um"] - run["x_um"].mean(), run["y_um"] - run["y_um"].mean() - 80 * k)
    return by_point(pandas.read_csv(kept / f"{name}-shapes.csv"), draw, xlabel="x (µm)", yticks=[], aspect="equal")


def adhesions(name):
    table = pandas.read_csv(kept / f"{name}-adhesions.csv").dropna(subset="f_adh_rel")
    return by_point(table, lambda axes, rows: axes.hist(rows["f_adh_rel"], bins=20, range=(0, 1)),
                    xlabel="force at the end / (2 f_mat F_am)", ylabel="adhesions")


def fibre_stress():
    table = pandas.read_csv(kept / "fibre-stress.csv")
    matrix, outline = (table[table["what"] == what] for what in ("matrix", "outline"))
    figure, axes = pyplot.subplots(figsize=(7, 6), layout="constrained")
    axes.scatter(matrix["x_um"], matrix["y_um"], s=9, color="#dddddd", rasterized=True)  # fluid has no stress
    stress = matrix["von_mises_Pa"]
    shown = axes.scatter(matrix["x_um"], matrix["y_um"], s=9, c=stress, vmin=0, vmax=stress.quantile(0.99), rasterized=True)
    axes.fill(outline["x_um"], outline["y_um"], fill=False, edgecolor="black")
    axes.set(xlabel="x (µm)", ylabel="y (µm)", aspect="equal")
    figure.colorbar(shown, label="von Mises stress of the fibres (Pa)")
    return figure


drawn = {"paths": (boxes, ""), "shapes": (shapes, "-shapes"), "msd": (msd, "-msd"), "adhesions": (adhesions, "-adhesions")}  # by the table that is kept


def draw_all(to):
    """Draws all figures into a folder.   @return the names of the files, by study"""
    to = pathlib.Path(to)
    to.mkdir(parents=True, exist_ok=True)
    pyplot.rcParams["svg.hashsalt"] = "kept"  # the same file each time
    made = {}

    def save(figure, study, file):
        figure.savefig(to / file, metadata={"Date": None})
        pyplot.close("all")
        made.setdefault(study, []).append(file)

    for table in sorted(kept.glob("*-results.csv")):
        study = table.name.removesuffix("-results.csv")
        for kind, (draw, ending) in drawn.items():
            if not study.endswith("-larger-disc") and (kept / f"{study}-{kind}.csv").exists():
                save(draw(study), study, f"{study}{ending}.svg")
                if kind == "paths":
                    save(paths(study), study, f"{study}-paths.svg")
    save(fibre_stress(), "kept-protrusions-fibres", "fibre-stress.svg")
    return made


def fibre_stress_table(run):
    """What (matrix, or outline of the cell), x_um, y_um, von_mises_Pa of the fibres (Eq. 11) as far as 60 um from the cell's centre."""
    fields = matrigrate.load(run).fields
    last = len(fields.times) - 1
    outline = fields.outlines(last)[1]
    places = (fields["matrix/reference"][...] + fields["matrix/displacement"][last])[:, :2]
    near = np.hypot(*(places - outline.mean(axis=0)).T) <= 60
    of_matrix = zip(places[near], fields["matrix/fibre_von_mises"][last][near], fields["matrix/f_degr"][last][near], strict=True)
    return "\n".join(["what,x_um,y_um,von_mises_Pa", *(f"matrix,{x:.2f},{y:.2f},{f'{stress:.1f}' if f > 0 else ''}" for (x, y), stress, f in of_matrix),
                      *(f"outline,{x:.2f},{y:.2f}," for x, y in outline)])


if __name__ == "__main__":
    if len(sys.argv) == 3 and sys.argv[1] == "--fibre-stress":
        print(fibre_stress_table(sys.argv[2]))
    elif len(sys.argv) == 2 and not sys.argv[1].startswith("-"):
        for study, files in draw_all(sys.argv[1]).items():
            print(f"{study}: {', '.join(files)}")
    else:
        sys.exit(__doc__)
