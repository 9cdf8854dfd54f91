#!/usr/bin/env python3
"""A wave of the search for closures, by one command: runs its study, keeps its table, and says what all waves so far leave.

  tools/wave.py PROGRAM K FOLDER [--jobs N] [--next POINTS] [--allowed ROWS] [--match-only]

Runs docs/validation/wave-K.toml in FOLDER/wave-K (it goes on from runs that are there, and leaves out points that docs/validation/wave-K.csv
has), adds its results to that table, matches the runs of waves 1 to K with docs/validation/outcomes.toml, and writes the tables of the match
to docs/validation/wave-K/, with the checks of the emulators; its page goes to FOLDER/match-K. --next writes wave-(K+1).toml with so many points where all is plausible.
--match-only runs nothing: the match of kept tables alone. Needs the Python package, scikit-learn and matplotlib.
"""

import argparse
import os
import shutil
import subprocess
import sys
import tempfile
import tomllib
from pathlib import Path

sys.path.insert(0, str(Path(__file__).parents[1] / "python"))

import pandas  # noqa: E402
from matrigrate.calibrate import match, read_outcomes  # noqa: E402

KEPT = Path(__file__).parents[1] / "docs" / "validation"
TABLES = ("outcomes.csv", "rows.csv", "exclusions.csv", "ranges.csv")


def runs(wave, program, folder, jobs):
    """Runs the points of a wave that the kept table lacks, in FOLDER/wave-K, which may hold some of their runs; keeps all that are done."""
    study = folder / f"wave-{wave}"
    left = study_of_missing_points(wave, program, folder)
    if left is None:
        return
    subprocess.run([program, "study", "run", left, "-o", study, "--jobs", str(jobs), "--quiet"], check=False)
    keep(wave, study / "results.csv")


def study_of_missing_points(wave, program, folder):
    """The study with the points of which the kept table lacks a condition, each written out; none if it has all."""
    folder.mkdir(parents=True, exist_ok=True)
    with tempfile.TemporaryDirectory(dir=folder) as plan:
        # `submit` writes all points out, and finds no Slurm on a path without folders
        subprocess.run([program, "study", "submit", KEPT / f"wave-{wave}.toml", "-o", plan], check=False, capture_output=True,
                       env=os.environ | {"PATH": ""})
        text = (Path(plan) / "study.resolved.toml").read_text(encoding="utf-8")
        scenario = (Path(plan) / "scenario.resolved.toml").read_text(encoding="utf-8")
    conditions = [one["label"] for one in tomllib.loads(text).get("conditions", [])]
    head, *points = text.split("[[points]]")
    done = set(pandas.read_csv(KEPT / f"wave-{wave}.csv")["label"]) if (KEPT / f"wave-{wave}.csv").exists() else set()
    names = [tomllib.loads(point)["label"] for point in points]
    left = [point for name, point in zip(names, points) if not done.issuperset(f"{one}: {name}" for one in conditions)]
    print(f"wave {wave}: {len(points) - len(left)} of {len(points)} points are kept, {len(left)} are left")
    if not left:
        return None
    (folder / "scenario.resolved.toml").write_text(scenario, encoding="utf-8")
    file = folder / f"wave-{wave}-left.toml"
    file.write_text("[[points]]".join([head, *left]), encoding="utf-8")
    return file


def keep(wave, results):
    """Adds the runs that are done to the kept table; a run that is there already stays as it is."""
    table = pandas.read_csv(results)
    table = table[table["status"].isin(["done", "failed"])]
    wanted = {"label", "replicate", "seed", "cause", "trajectory_hash", *first_wave()["readouts"],
              *(one.readout for one in read_outcomes(KEPT / "outcomes.toml")), *ranges_of(table)}
    table = table[[name for name in table if name in wanted]]
    file = KEPT / f"wave-{wave}.csv"
    if file.exists():
        before = pandas.read_csv(file)
        table = pandas.concat([before[[name for name in before if name in wanted]], table]).drop_duplicates(["label", "replicate"])
    number = table["label"].str.extract(r"(\d+)$")[0].astype(int)
    table = table.iloc[number.argsort(kind="stable")]
    table.to_csv(file, index=False, float_format="%.4g")


def kept(wave):
    """The runs of a kept table, with the name of their condition."""
    table = pandas.read_csv(KEPT / f"wave-{wave}.csv")
    table["condition"] = [label.rsplit(": ", 1)[0] for label in table["label"]]
    lost = int((table["cause"] == "rim").sum()) if "cause" in table else 0
    if lost:
        print(f"wave {wave}: {lost} of {len(table)} runs ended at the rim and are left out")
    return table[table["tau_prot_min"].notna() | table["n_protrusions"].notna()]


def first_wave():
    return tomllib.loads((KEPT / "wave-1.toml").read_text(encoding="utf-8"))


def ranges_of(table):
    """The ranges of the first wave, by the columns of the table, as they are written."""
    found = {}
    for section, keys in first_wave()["latin_hypercube"].items():
        for key, ends in keys.items() if isinstance(keys, dict) else []:
            column = next(name for name in table if name == f"{section}.{key}" or name.startswith(f"{section}.{key}_"))
            found[column] = ends
    return found


def prior_of(table):
    """The same in numbers, as ``match`` takes them."""
    return {column: (float(str(low).split()[0]), float(str(high).split()[0]), *scale) for column, (low, high, *scale) in ranges_of(table).items()}


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("program", type=Path)
    parser.add_argument("wave", type=int)
    parser.add_argument("folder", type=Path)
    parser.add_argument("--jobs", type=int, default=2)
    parser.add_argument("--next", type=int, default=0, dest="points")
    parser.add_argument("--allowed", type=int, default=2)
    parser.add_argument("--match-only", action="store_true")
    options = parser.parse_args()
    os.environ["MATRIGRATE"] = str(options.program.resolve())  # checks the next wave
    if not options.match_only:
        runs(options.wave, options.program.resolve(), options.folder, options.jobs)
    waves = [kept(wave) for wave in range(1, options.wave + 1)]
    found = match(waves, read_outcomes(KEPT / "outcomes.toml"), prior=prior_of(waves[0]), allowed=options.allowed)
    print(found, found.best.to_string(float_format="%.3g"), found.exclusions.head(15).to_string(float_format="%.3g"), sep="\n\n")
    page = found.write(options.folder / f"match-{options.wave}", overwrite=True)
    tables = KEPT / f"wave-{options.wave}"
    tables.mkdir(exist_ok=True)
    for name in TABLES:
        shutil.copy(page.parent / name, tables / name)
    print(f"page: {page}; tables: {tables}")
    if options.points:
        study = KEPT / f"wave-{options.wave + 1}.toml"
        found.write_study(study, options.points, KEPT / "wave-1.toml")
        text = study.read_text(encoding="utf-8")
        study.write_text(text.replace(": first wave\"", f": wave {options.wave + 1}\"", 1), encoding="utf-8")
        print(f"next: {study}")


if __name__ == "__main__":
    main()
