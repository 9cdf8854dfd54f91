#!/usr/bin/env python3
"""Do results depend on the time step? The same seeds with the reference and the adaptive integrator.

  tests/long/steps.py PROGRAM FOLDER --first [--seeds 16]    first protrusions at 50, 200 and 400 Pa: f_mat, l_prot
  tests/long/steps.py PROGRAM FOLDER --whole [--seeds 24]    runs of six hours: nine read-outs

First protrusions are compared seed by seed, whole runs as two samples: they part company after the first protrusion.
Fails (exit code 1) where the mean f_mat of first protrusions differs by more than 0.01 beyond twice its error, or a
read-out by more than 2.9 errors (nine at 0.05 together). Runs that are there are not made again.
"""

import argparse
import csv
import statistics
import subprocess
import sys
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

READOUTS = ("v_migr_abs_um_per_h", "v_migr_path_60s_um_per_h", "v_migr_path_600s_um_per_h", "n_protrusions",
            "tau_prot_min", "l_prot_um", "f_mat", "f_adh_rel", "msd_slope")
QUIET = ("output.report=false", "output.field_interval=0 s", "output.kept_checkpoint_interval=0 s")
FIRST = ("protrusion.number=1", "adhesion.r_off_0=0 1/s", "adhesion.r_off_min=0 1/s", "run.duration=22 min")


def run(program, scenario, folder, seed, settings):
    if not (folder / "summary.csv").exists():
        sets = [word for setting in settings for word in ("--set", setting)]
        subprocess.run([program, "run", scenario, "--seed", str(seed), "--quiet", "-o", folder, *sets], check=True,
                       stdout=subprocess.DEVNULL)
    with open(folder / "summary.csv", encoding="utf-8") as file:
        row = list(csv.DictReader(file))[-1]
    return {name: float(row[name]) for name in READOUTS if row[name] not in ("", "nan")}


def mean_and_error(values):
    return statistics.fmean(values), statistics.stdev(values) / len(values) ** 0.5


def by_seed(title, samples, names):
    """Both integrators, seed by seed. @return whether f_mat agrees"""
    agrees = True
    for name in names:
        pairs = [(a[name], b[name]) for a, b in zip(*samples) if name in a and name in b]
        difference, error = mean_and_error([b - a for a, b in pairs])
        means = [statistics.fmean(values) for values in zip(*pairs)]
        print(f"{title} {name}: {means[0]:.4f}, adaptive {means[1]:.4f}, difference {difference:+.4f} +- {error:.4f} "
              f"({len(pairs)} seeds)")
        agrees &= name != "f_mat" or abs(difference) <= 0.01 + 2.0 * error
    return agrees


def by_sample(title, samples):
    agrees = True
    for name in READOUTS:
        (a, da), (b, db) = (mean_and_error([run[name] for run in sample if name in run]) for sample in samples)
        errors = (b - a) / (da**2 + db**2) ** 0.5
        print(f"{title} {name}: {a:.4g} +- {da:.2g}, adaptive {b:.4g} +- {db:.2g}, {errors:+.1f} errors")
        agrees &= abs(errors) < 2.9
    return agrees


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("program", type=Path)
    parser.add_argument("folder", type=Path)
    parser.add_argument("--first", action="store_true")
    parser.add_argument("--whole", action="store_true")
    parser.add_argument("--seeds", type=int)
    parser.add_argument("--jobs", type=int, default=2)
    options = parser.parse_args()
    program, folder = options.program.resolve(), options.folder
    folder.mkdir(parents=True, exist_ok=True)
    scenario = folder / "baseline.toml"
    if not scenario.exists():
        subprocess.run([program, "new", scenario], check=True, stdout=subprocess.DEVNULL)

    def both(title, seeds, settings):
        tasks = [(integrator, seed) for integrator in ("reference", "adaptive") for seed in range(1, seeds + 1)]
        with ThreadPoolExecutor(options.jobs) as pool:
            runs = list(pool.map(lambda task: run(program, scenario, folder / f"{title}-{task[0]}-{task[1]}", task[1],
                                                  [*settings, *QUIET, f"run.integrator={task[0]}"]), tasks))
        return runs[:seeds], runs[seeds:]

    agree = True
    if options.first:
        for stiffness in (50, 200, 400):
            samples = both(f"first-{stiffness}", options.seeds or 16, [*FIRST, f"ecm.youngs_modulus={stiffness} Pa"])
            agree &= by_seed(f"{stiffness} Pa", samples, ("f_mat", "l_prot_um"))
    if options.whole:
        agree &= by_sample("6 h", both("whole", options.seeds or 24, []))
    return 0 if agree else 1


if __name__ == "__main__":
    sys.exit(main())
