#!/usr/bin/env python3
"""Do the intervals of a calibration hold the truth as often as they say? Parameters are drawn, cells of them simulated, and
fitted like measured ones; all fits share one design.

recovery.py PROGRAM FOLDER [--points N] [--draws N] [--cells N] [--jobs N] [--results FILE]

A run is a cell in a small disc for half an hour, 0.7 s of CPU time. The studies in FOLDER resume where they were stopped.
"""
import argparse
import os
import pathlib
import sys

source = pathlib.Path(__file__).resolve().parents[2]
sys.path.insert(0, str(source / "python"))

import matrigrate  # noqa: E402
import numpy as np  # noqa: E402
import pandas  # noqa: E402
from matrigrate import calibrate, tracks  # noqa: E402

ranges = {"ecm.youngs_modulus": (50.0, 400.0, "Pa"), "protrusion.force": (0.16, 0.64, "nN"),
          "polarization.rate": (3e-4, 4e-3, "1/s")}  # the last acts only on cells that run for longer
readouts = ["speed_um_per_h", "v_migr_abs_um_per_h", "straightness", "l_prot_um"]  # the last is measured beside the tracks
interval = 60.0
small_disc = """preset = "baseline"

[set]
run.duration = "30 min"
run.integrator = "adaptive"
ecm.radius = "60 um"
protrusion.initiation_rate = "5e-4 1/s"
protrusion.growth_time = "100 s"
protrusion.finishing_time = "60 s"
adhesion.maturation_time = "150 s"
output.report = false
output.checkpoint_interval = 0
output.field_interval = 0
"""


def design(points: int) -> str:
    rows = "".join(f'{key} = ["{low:g} {unit}", "{high:g} {unit}", "log"]\n' for key, (low, high, unit) in ranges.items())
    return f'title = "Design"\nreplicates = 1\n{small_disc}\n[latin_hypercube]\nsamples = {points}\n{rows}'


def truths(draws: int, cells: int) -> str:
    random = np.random.default_rng(2026)
    text = f'title = "Truths"\nreplicates = {cells}\n{small_disc}'
    for k in range(draws):
        text += f'\n[[points]]\nlabel = "draw {k + 1}"\n'
        for key, (low, high, unit) in ranges.items():
            text += f'{key} = "{np.exp(random.uniform(np.log(low), np.log(high))):.6g} {unit}"\n'
    return text


def simulated(options: argparse.Namespace) -> tuple[matrigrate.Study, matrigrate.Study]:
    options.folder.mkdir(parents=True, exist_ok=True)
    studies = []
    for name, text in (("design", design(options.points)), ("truths", truths(options.draws, options.cells))):
        file = options.folder / f"{name}.toml"
        file.write_text(text)
        studies.append(matrigrate.run_study(file, options.folder / name, jobs=options.jobs))
    return studies[0], studies[1]


def recovered(design: matrigrate.Study, truths: matrigrate.Study) -> pandas.DataFrame:
    """A row for each draw and parameter."""
    emulators = calibrate.emulate(design, readouts, interval=interval, seed=1)
    print(emulators)
    done = truths.results[truths.results["status"] == "done"]
    rows = []
    for label, runs in done.groupby("label", sort=False):
        cells = tracks.Tracks({name: next(iter(tracks.of(truths.runs[name], interval).values())) for name in runs["run"]},
                              interval, [])
        length = runs["l_prot_um"].dropna()
        fit = emulators.fit(cells, besides={"l_prot_um": (length.mean(), length.sem())})
        for name, row in fit.table.iterrows():
            truth = float(runs[name].iloc[0])
            rows.append({"draw": label, "cells": len(cells), "parameter": name, "truth": truth,
                         **{k: row[f"posterior_{k}"] for k in (5, 50, 95)},
                         "inside": int(row["posterior_5"] <= truth <= row["posterior_95"]), "width": row["width"],
                         "narrow": int(row["width"] < 0.8)})
    return pandas.DataFrame(rows)


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("program")
    parser.add_argument("folder", type=pathlib.Path)
    parser.add_argument("--points", type=int, default=400)
    parser.add_argument("--draws", type=int, default=20)
    parser.add_argument("--cells", type=int, default=12)
    parser.add_argument("--jobs", type=int, default=1)
    parser.add_argument("--results", type=pathlib.Path, default=source / "docs/how-to/recovery.csv")
    options = parser.parse_args()
    os.environ["MATRIGRATE"] = options.program
    table = recovered(*simulated(options))
    table.to_csv(options.results, index=False, float_format="%.4g")
    summary = table.groupby("parameter", sort=False).agg(draws=("inside", "size"), inside=("inside", "sum"),
                                                         width=("width", "mean"), narrow=("narrow", "sum"))
    print(summary)
    share = table["inside"].mean()
    print(f"{share:.1%} of {len(table)} intervals of 90 % hold the truth")
    sys.exit(0 if 0.75 <= share <= 1.0 else 1)


if __name__ == "__main__":
    main()
