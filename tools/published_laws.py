#!/usr/bin/env python3
"""Runs each published law, and its scenario without it, for six hours with eight seeds:
    published_laws.py PROGRAM FOLDER [RUNS AT A TIME]

Runs stand in FOLDER; one that is there is not computed again. Writes docs/validation/published-laws.csv, a row a run.
Then, and alone without arguments, it writes what stands between the two marks of docs/how-to/published-laws.md: the laws
of scenarios/laws, and the table of that file."""
import concurrent.futures
import csv
import json
import pathlib
import statistics
import subprocess
import sys

root = pathlib.Path(__file__).resolve().parent.parent
results = root / "docs/validation/published-laws.csv"
page = root / "docs/how-to/published-laws.md"
readouts = {"v_migr_path_600s_um_per_h": "speed over 10 min, um/h", "v_migr_abs_um_per_h": "from start to end, um/h",
            "n_protrusions": "protrusions in 6 h", "tau_prot_min": "adhesions live, min", "f_mat": "maturation",
            "migration_index_x": "index along x"}
bases = {"ligand": "default, ligand", "isotropic": "default, fibres", "uniaxial": "default, uniaxial", "": "default"}
intervals = """Six hours, the same seeds for all. Median of the runs, in brackets smallest to largest. Each law stands under its own
scenario without it: *default* is the baseline, the others the baseline with the gel that the law needs.
Each run is a row of [published-laws.csv](../validation/published-laws.csv); `tools/published_laws.py PROGRAM FOLDER` computes
them again."""
quiet = ["output.report=false", "output.field_interval=0 s", "output.kept_checkpoint_interval=0 s"]


def scenarios():
    """The texts by name, and the name of what each law stands beside."""
    texts, beside = {}, {}
    for file in sorted((root / "scenarios/laws").glob("*.toml")):
        text = file.read_text(encoding="utf-8")
        without = text[text.index("[run]"):text.index("[laws]")]
        base = next(name for word, name in bases.items() if word in without)
        texts |= {base: without, file.stem: text}
        beside |= {base: base, file.stem: base}
    return texts, beside


def folder_of(folder, name, seed):
    return folder / f"{name.replace(', ', '-')}-{seed}"


def is_done(run):
    record = run / "run.json"
    return record.exists() and json.loads(record.read_text(encoding="utf-8"))["status"] == "done"


def compute(program, folder, jobs):
    folder.mkdir(parents=True, exist_ok=True)
    settings = [word for setting in quiet for word in ("--set", setting)]

    def one(seed, name, text):
        run = folder_of(folder, name, seed)
        if is_done(run):
            return
        file = run.with_suffix(".toml")
        file.write_text(text, encoding="utf-8")
        fresh = ["run", file, "--seed", str(seed), "-o", run, *settings]
        subprocess.run([program, *(["resume", run] if run.exists() else fresh), "--quiet"], check=False)

    with concurrent.futures.ThreadPoolExecutor(jobs) as pool:
        for seed in range(1, 9):
            for name, text in scenarios()[0].items():
                pool.submit(one, seed, name, text)


def collect(folder):
    texts, beside = scenarios()
    rows = []
    for name in sorted(texts, key=lambda name: (beside[name], beside[name] != name, name)):
        for seed in range(1, 9):
            run = folder_of(folder, name, seed)
            if is_done(run):
                read = json.loads((run / "summary.json").read_text(encoding="utf-8"))
                rows.append({"law": name, "beside": beside[name], "seed": seed} | {key: read[key] for key in readouts})
    with results.open("w", newline="", encoding="utf-8") as file:
        writer = csv.DictWriter(file, rows[0].keys(), lineterminator="\n")
        writer.writeheader()
        writer.writerows(rows)


def cell(rows, readout):
    values = [float(row[readout]) for row in rows if row[readout] not in ("", "None")]
    if not values:
        return "-"
    return f"{statistics.median(values):.3g} ({min(values):.3g} to {max(values):.3g})"


def table():
    with results.open(encoding="utf-8") as file:
        rows = list(csv.DictReader(file))
    lines = ["| law | " + " | ".join(readouts.values()) + " | runs |", "|---" * (len(readouts) + 2) + "|"]
    for name in dict.fromkeys(row["law"] for row in rows):
        own = [row for row in rows if row["law"] == name]
        shown = f"*{name}*" if name in bases.values() else f"`{name}`"
        lines.append(f"| {shown} | " + " | ".join(cell(own, readout) for readout in readouts) + f" | {len(own)} |")
    return "\n".join(lines)


def section(file):
    """A law as its file has it: title, reference, formula, constants with their sources."""
    text = file.read_text(encoding="utf-8")
    comments = [line[2:] for line in text[:text.index("# Above each number")].splitlines()[1:] if len(line) > 2]
    title, reference, why = comments[0].removesuffix(" (law)."), comments[1], " ".join(comments[2:])
    doi = reference[reference.index("doi:") + 4:].rstrip(".")
    reference = f"[{reference[:reference.index(', doi:')]}](https://doi.org/{doi})"
    return f"### {file.stem}\n\n{title}. {reference}. {why}\n\n```toml title=\"{file.name}\"\n{text[text.index('[laws]'):]}```\n"


def page_text():
    text = page.read_text(encoding="utf-8")
    begin, end = "<!-- tools/published_laws.py -->\n", "<!-- end -->"
    sections = "\n".join(section(file) for file in sorted((root / "scenarios/laws").glob("*.toml")))
    parts = ["## The laws", sections.rstrip()] + (["## What they do", intervals, table()] if results.exists() else [])
    return text.split(begin)[0] + begin + "\n" + "\n\n".join(parts) + "\n\n" + end + text.split(end)[1]


if __name__ == "__main__":
    if len(sys.argv) >= 3:
        compute(sys.argv[1], pathlib.Path(sys.argv[2]), int(sys.argv[3]) if len(sys.argv) > 3 else 1)
        collect(pathlib.Path(sys.argv[2]))
    page.write_text(page_text(), encoding="utf-8")
