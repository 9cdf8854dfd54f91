#!/usr/bin/env python3
"""Does a comparison find the parameter that a treatment changed, and name "nothing differs" where nothing does? Control cells are simulated at points that
are drawn, treated ones with one parameter doubled or halved, and compared like measured ones; all comparisons share one design.

treatment_recovery.py PROGRAM FOLDER [--points N] [--cases N] [--cells N] [--jobs N] [--seed N] [--results FILE]

A run is a cell in a small disc for half an hour, 0.9 s of CPU time. The studies in FOLDER resume where they were stopped.
"""
import argparse
import os
import pathlib
import sys
import time

source = pathlib.Path(__file__).resolve().parents[2]
sys.path.insert(0, str(source / "python"))

import matrigrate  # noqa: E402
import numpy as np  # noqa: E402
import pandas  # noqa: E402
from matrigrate import calibrate, tracks  # noqa: E402
from recovery import small_disc  # noqa: E402

ranges = {"ecm.youngs_modulus": (50.0, 400.0, "Pa"), "protrusion.force": (0.16, 0.64, "nN"), "actomyosin.force": (0.3, 2.0, "nN"),
          "protrusion.initiation_rate": (2.5e-4, 1.5e-3, "1/s")}
treated_ones = list(ranges)[:3]  # twice the rate makes 0.3 more protrusions of 4.4, which 15 cells do not tell
of_tracks = ["speed_um_per_h", "v_migr_abs_um_per_h", "straightness"]
of_protrusions = ["l_prot_um", "f_mat", "n_protrusions"]
interval = 60.0
factor = 2.0


def design(points: int) -> str:
    rows = "".join(f'{key} = ["{low:g} {unit}", "{high:g} {unit}", "log"]\n' for key, (low, high, unit) in ranges.items())
    return f'title = "Design"\nreplicates = 1\n{disc()}\n[latin_hypercube]\nsamples = {points}\n{rows}'


def disc() -> str:
    """Without the rate, which is varied."""
    return "".join(line for line in small_disc.splitlines(keepends=True) if "initiation_rate" not in line)


def cases(many: int, seed: int) -> list[tuple[dict[str, float], str, float]]:
    """Of each: the parameters of control, the one that the treatment changes, and by which factor: each is as often doubled as halved."""
    random, found = np.random.default_rng(seed), []
    for k in range(many):
        name, times = treated_ones[k % len(treated_ones)], factor if k // len(treated_ones) % 2 else 1 / factor
        point = {}
        for key, (low, high, _) in ranges.items():
            ends = (low / min(1.0, times), high / max(1.0, times)) if key == name else (low, high)  # the treated value is inside, too
            point[key] = float(np.exp(random.uniform(*np.log(ends))))
        found.append((point, name, times))
    return found


def cells_of(chosen: list[tuple[dict[str, float], str, float]], treated: bool, replicates: int) -> str:
    text = f'title = "Cells"\nreplicates = {replicates}\n{disc()}'
    for k, (point, name, times) in enumerate(chosen, 1):
        text += f'\n[[points]]\nlabel = "case {k}"\n'
        text += "".join(f'{key} = "{value * (times if treated and key == name else 1.0):.6g} {ranges[key][2]}"\n' for key, value in point.items())
    return text


def simulated(options: argparse.Namespace) -> list[matrigrate.Study]:
    options.folder.mkdir(parents=True, exist_ok=True)
    chosen, studies = cases(options.cases, options.seed), []
    for name, text in (("design", design(options.points)), ("control", cells_of(chosen, False, 2 * options.cells)),
                       ("treated", cells_of(chosen, True, options.cells))):
        file = options.folder / f"{name}.toml"
        file.write_text(text)
        studies.append(matrigrate.run_study(file, options.folder / name, jobs=options.jobs))
    return studies


def group(study: matrigrate.Study, runs: pandas.DataFrame) -> tuple[tracks.Tracks, dict[str, tuple[float, float]]]:
    """Tracks, and numbers of protrusions with their standard errors over cells, measured to a thousandth: f_mat can be the same in all cells."""
    cells = tracks.Tracks({name: next(iter(tracks.of(study.runs[name], interval).values())) for name in runs["run"]}, interval, [])
    means, errors = runs[of_protrusions].mean(), runs[of_protrusions].sem()
    return cells, {name: (float(means[name]), float(max(errors[name], 1e-3 * means[name]))) for name in of_protrusions}


def compared(emulators: calibrate.Emulators, first: tuple, second: tuple, name: str, times: float) -> dict[str, object]:
    """A row of the table. :param name: the parameter that the treatment changed; "" of none"""
    begin = time.process_time()
    found = calibrate.compare(emulators, first[0], second[0], besides={"control": first[1], "treated": second[1]}, pairs=False, scores=False)
    seconds, table = time.process_time() - begin, found.table.set_index("differs")
    true = next((column for column in table.index if name and column.startswith(name)), "")
    ratio = [table.loc[true, f"ratio_{q}"] for q in (5, 50, 95)] if true else [np.nan] * 3
    named = table.index[table["candidate"]]
    return {"true": true, "factor": times, "control": len(first[0]), "treated": len(second[0]), "something": found.something["treated"],
            "first": table["probability"].idxmax(), "named": " ".join(named) if len(named) else "nothing",
            "found": int(true in named if name else not len(named)), "probability": table.loc[true, "probability"] if true else np.nan,
            "ratio_5": ratio[0], "ratio_50": ratio[1], "ratio_95": ratio[2], "inside": int(ratio[0] <= times <= ratio[2]) if true else "",
            "p_first": table.loc[table["probability"].idxmax(), "p"], "seconds": seconds}


def recovered(design: matrigrate.Study, control: matrigrate.Study, treated: matrigrate.Study, options: argparse.Namespace) -> pandas.DataFrame:
    """Two rows a case: control beside treated cells, and beside as many other cells of control."""
    emulators = calibrate.emulate(design, [*of_tracks, *of_protrusions], interval=interval)
    print(emulators, flush=True)
    rows = []
    for k, (_, name, times) in enumerate(cases(options.cases, options.seed), 1):
        runs = [one.results[(one.results["label"] == f"case {k}") & (one.results["status"] == "done")] for one in (control, treated)]
        first, again = (group(control, part) for part in (runs[0].iloc[:options.cells], runs[0].iloc[options.cells:]))
        for kind, other in (("treated", group(treated, runs[1])), ("alike", again)):
            true = (name, times) if kind == "treated" else ("", 1.0)
            rows.append({"case": k, "kind": kind, **compared(emulators, first, other, *true)})
            print(rows[-1], flush=True)
    return pandas.DataFrame(rows).sort_values(["kind", "case"], ascending=[False, True])


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("program")
    parser.add_argument("folder", type=pathlib.Path)
    parser.add_argument("--points", type=int, default=240)
    parser.add_argument("--cases", type=int, default=20)
    parser.add_argument("--cells", type=int, default=15)
    parser.add_argument("--jobs", type=int, default=1)
    parser.add_argument("--seed", type=int, default=2026)
    parser.add_argument("--results", type=pathlib.Path, default=source / "docs/how-to/treatment-recovery.csv")
    options = parser.parse_args()
    os.environ["MATRIGRATE"] = options.program
    table = recovered(*simulated(options), options)
    table.to_csv(options.results, index=False, float_format="%.4g")
    found = table.groupby("kind")["found"].sum()
    print(f"treatments: the parameter is named in {found['treated']} of {options.cases}; nothing: {found['alike']} of {options.cases}")
    sys.exit(0 if found["treated"] >= 0.8 * options.cases and found["alike"] >= 0.9 * options.cases else 1)


if __name__ == "__main__":
    main()
