#!/usr/bin/env python3
"""A wave of the search for closures, by one command: runs its study, keeps its table, and says what all waves so far leave.

  tools/wave.py PROGRAM K FOLDER [--jobs N] [--next POINTS] [--allowed ROWS] [--match-only] [--at KEY=VALUE ...]

Runs docs/validation/wave-K.toml in FOLDER/wave-K (it goes on from runs that are there, and leaves out points that docs/validation/wave-K.csv
has), then first protrusions of a weak and a strong cell at the same points; adds the results to the kept tables, matches the runs of waves 1
to K with docs/validation/outcomes.toml, and writes the tables of the match to docs/validation/wave-K/, with the checks of the emulators; its
page goes to FOLDER/match-K. --next writes wave-(K+1).toml with so many points where all is plausible. --at says what the waves leave where
parameters have given values (actomyosin.curvature_width_per_um=0.25), and how likely these are; points of --next then have them, too.
--match-only runs nothing: the match of kept tables alone. Needs the Python package, SciPy and matplotlib.
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

import numpy  # noqa: E402
import pandas  # noqa: E402
from matrigrate._study_file import write_points  # noqa: E402
from matrigrate.calibrate import match, read_outcomes  # noqa: E402

KEPT = Path(__file__).parents[1] / "docs" / "validation"
TABLES = ("outcomes.csv", "reach.csv", "rows.csv", "exclusions.csv", "ranges.csv")
FIRST = """
[[conditions]]
label = "first, {force}"
"actomyosin.force" = "{force}"
"protrusion.number" = 1
"adhesion.r_off_0" = 0
"adhesion.r_off_min" = 0
"run.duration" = "22 min"
"""  # a first protrusion, until it has matured
FORCES = ("0.2 nN", "1 nN")  # of one strand


def runs(wave, program, folder, jobs):
    """Runs the points of a wave that the kept table lacks, in FOLDER/wave-K, which may hold some of their runs; keeps all that are done."""
    study = folder / f"wave-{wave}"
    left = study_of_missing_points(wave, program, folder)
    if left is None:
        return
    subprocess.run([program, "study", "run", left, "-o", study, "--jobs", str(jobs), "--quiet"], check=False)
    keep(wave, study / "results.csv")


def written_out(wave, program, folder):
    """The study with all points written out: what stands before its points, and each of them; its scenario goes to the folder."""
    folder.mkdir(parents=True, exist_ok=True)
    with tempfile.TemporaryDirectory(dir=folder) as plan:
        # `submit` writes all points out, and finds no Slurm on a path without folders
        subprocess.run([program, "study", "submit", KEPT / f"wave-{wave}.toml", "-o", plan], check=False, capture_output=True,
                       env=os.environ | {"PATH": ""})
        head, *points = (Path(plan) / "study.resolved.toml").read_text(encoding="utf-8").split("[[points]]")
        shutil.copy(Path(plan) / "scenario.resolved.toml", folder)
    return head, points


def study_of_missing_points(wave, program, folder):
    """The study with the points of which the kept table lacks a condition; none if it has all."""
    head, points = written_out(wave, program, folder)
    conditions = [one["label"] for one in tomllib.loads(head).get("conditions", [])]
    done = set(pandas.read_csv(KEPT / f"wave-{wave}.csv")["label"]) if (KEPT / f"wave-{wave}.csv").exists() else set()
    names = [tomllib.loads(point)["label"] for point in points]
    left = [point for name, point in zip(names, points) if not done.issuperset(f"{one}: {name}" for one in conditions)]
    print(f"wave {wave}: {len(points) - len(left)} of {len(points)} points are kept, {len(left)} are left", flush=True)
    if not left:
        return None
    file = folder / f"wave-{wave}-left.toml"
    file.write_text("[[points]]".join([head, *left]), encoding="utf-8")
    return file


def study_of_first_protrusions(wave, program, folder):
    """The study of first protrusions at the points of a wave."""
    head, points = written_out(wave, program, folder)
    conditions = "".join(FIRST.format(force=force) for force in FORCES)
    file = folder / f"wave-{wave}-first.toml"
    file.write_text("[[points]]".join([head.split("[[conditions]]")[0] + conditions + "\n", *points]), encoding="utf-8")
    return file


def first_protrusions(wave, program, folder, jobs):
    """Runs first protrusions at the points of a wave, and keeps their f_mat and length, where they are not kept yet."""
    table = KEPT / f"wave-{wave}-first.csv"
    if table.exists():
        return
    study = folder / f"wave-{wave}-first"
    subprocess.run([program, "study", "run", study_of_first_protrusions(wave, program, folder), "-o", study, "--jobs", str(jobs), "--quiet"], check=True)
    pandas.read_csv(study / "results.csv")[["label", "f_mat", "l_prot_um"]].to_csv(table, index=False, float_format="%.4g")


def keep(wave, results):
    """Adds the runs that are done to the kept table; a run that is there already stays as it is."""
    table = pandas.read_csv(results)
    table = table[table["status"].isin(["done", "failed"])]
    wanted = {"label", "replicate", "cause", "trajectory_hash", *first_wave()["readouts"],
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
    lost = int((table["cause"] == "rim").sum()) if "cause" in table else 0
    if lost:
        print(f"wave {wave}: {lost} of {len(table)} runs ended at the rim and are left out")
    points = table[["label", *ranges_of(table)]].assign(label=point_of(table)).drop_duplicates()
    table = table[table["tau_prot_min"].notna() | table["n_protrusions"].notna()]
    file = KEPT / f"wave-{wave}-first.csv"
    if file.exists():
        first = pandas.read_csv(file)
        first = first.assign(point=point_of(first)).merge(points, left_on="point", right_on="label", suffixes=("", "_of_point"))
        table = pandas.concat([table, first])
    table["condition"] = [label.rsplit(": ", 1)[0] for label in table["label"]]
    return table


def point_of(table):
    return table["label"].str.rsplit(": ", n=1).str[1]


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


def slice_of(found, held):
    """Points of the unit cube where parameters are held at values."""
    if unknown := [name for name in held if name not in found.prior.names]:
        raise SystemExit("\n".join(f"{name}: is none of {', '.join(found.prior.names)}" for name in unknown))
    cube = found._judge.cube.copy()
    place = found.prior.to_cube([[held.get(name, low) for name, low in zip(found.prior.names, found.prior.low)]])[0]
    for k, name in enumerate(found.prior.names):
        if name in held:
            cube[:, k] = place[k]
    return cube


def at(found, held):
    """What the waves say where parameters are held: the likelihood of their values over that of the whole space, and the mean of the others.

    The likelihood of a point is exp(-I^2/2), I^2 being the summed squares of the implausibilities of rows.
    """
    judge, names, cube = found._judge, found.prior.names, slice_of(found, held)
    rows = judge.rows(cube)
    weights, whole = (numpy.exp(-0.5 * (one**2).sum(axis=1)) for one in (rows, judge.known))
    likelihood = weights.mean() / whole.mean()
    mean = numpy.average(cube, axis=0, weights=weights)
    spread = numpy.sqrt(numpy.average((cube - mean)**2, axis=0, weights=weights))
    ends = [found.prior.from_cube(numpy.clip(one, 0, 1)[None])[0] for one in (mean, mean - spread, mean + spread)]
    print(f"likelihood over that of the whole space: {likelihood:.2g} "
          f"(from {weights.sum()**2 / (weights**2).sum():.0f} points); plausible: {(judge.deep(rows) < found.cutoff).mean():.3g} of it")
    print(pandas.DataFrame(dict(zip(("mean", "low", "high"), ends)), index=names).to_string(float_format="%.3g"))
    print(pandas.DataFrame({"implausibility at the mean": judge.rows(mean[None])[0]}, index=judge.names).to_string(float_format="%.2f"))
    predicted = found.predict(pandas.DataFrame([ends[0]], columns=names, index=["predicted at the mean"]))
    print(predicted.T.to_string(float_format="%.3g"))
    return likelihood


def write_next(found, study, points, held):
    """The next wave: points that fill what is plausible; where parameters are held, the first plausible ones of a Sobol sequence."""
    if not held:
        found.write_study(study, points, KEPT / "wave-1.toml")
        text = study.read_text(encoding="utf-8")
    else:
        cube = slice_of(found, held)
        plausible = cube[found._judge.deep(found._judge.rows(cube)) < found.cutoff][:points]
        table = pandas.DataFrame(found.prior.from_cube(plausible), columns=found.prior.names).assign(**held)
        write_points(study, table, KEPT / "wave-1.toml", {})
        text = study.read_text(encoding="utf-8")
    study.write_text(text.replace(": first wave\"", f": {study.stem.replace('-', ' ')}\"", 1), encoding="utf-8")
    print(f"next: {study}")


def value_of(text):
    """A parameter, named as in the tables, and its value: KEY=NUMBER."""
    key, _, value = text.partition("=")
    try:
        return key, float(value)
    except ValueError:
        raise argparse.ArgumentTypeError(f"{text} is not KEY=NUMBER, as adhesion.spread=1") from None


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("program", type=Path)
    parser.add_argument("wave", type=int)
    parser.add_argument("folder", type=Path)
    parser.add_argument("--jobs", type=int, default=2)
    parser.add_argument("--next", type=int, default=0, dest="points")
    parser.add_argument("--allowed", type=int, default=2)
    parser.add_argument("--match-only", action="store_true")
    parser.add_argument("--at", action="append", default=[], metavar="KEY=VALUE", type=value_of)
    options = parser.parse_args()
    study = KEPT / f"wave-{options.wave + 1}.toml"
    if options.points and study.exists():
        parser.error(f"{study} exists already; leave out --next, or move it away")
    os.environ["MATRIGRATE"] = str(options.program.resolve())  # checks the next wave
    if not options.match_only:
        runs(options.wave, options.program.resolve(), options.folder, options.jobs)
        first_protrusions(options.wave, options.program.resolve(), options.folder, options.jobs)
    waves = [kept(wave) for wave in range(1, options.wave + 1)]
    found = match(waves, read_outcomes(KEPT / "outcomes.toml"), prior=prior_of(waves[0]), allowed=options.allowed)
    print(found, found.best.to_string(float_format="%.3g"), found.exclusions.head(15).to_string(float_format="%.3g"),
          found.reach.to_string(float_format="%.3g"), sep="\n\n")
    page = found.write(options.folder / f"match-{options.wave}", overwrite=True)
    tables = KEPT / f"wave-{options.wave}"
    tables.mkdir(exist_ok=True)
    for name in TABLES:
        shutil.copy(page.parent / name, tables / name)
    print(f"page: {page}; tables: {tables}")
    held = dict(options.at)
    if held:
        at(found, held)
    if options.points:
        write_next(found, study, options.points, held)


if __name__ == "__main__":
    main()
