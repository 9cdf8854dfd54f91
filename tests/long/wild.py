#!/usr/bin/env python3
"""Runs with one to ten parameters drawn over their whole documented ranges, at full size, and how each ended.

    tests/long/wild.py PROGRAM FOLDER [--runs 60] [--hours 0.3] [--radius UM] [--jobs 2] [--limit 1200]

Each run must end by itself with 0 (done), 3 (configuration) or 4 (numerical failure), the last two with a reason, within
LIMIT seconds of CPU time and 9 GB of address space. What sets the size or the length of a run stays as it is: the matrix
and its spacing, the place of the cell, the duration, the intervals of output; steps are drawn from 0.05 s on. The draws are the same every time.
"""
import argparse
import collections
import concurrent.futures
import json
import pathlib
import random
import re
import resource
import subprocess
import sys

HELD = {"run.duration", "run.seed", "run.threads", "ecm.radius", "ecm.particle_spacing", "ecm.smoothing_length",
        "cell.start_x", "cell.start_y"}
PRESETS = ["baseline", "fibrillar", "two-protrusions-fibres", "one-protrusion", "four-protrusions"]


def parameters(program):
    """(key, allowed, whether it is a whole number) of every parameter that has a range, from the table and the schema that the
    program prints; [[cells]] and fields, whose values are formulas, are left out."""
    table, schema = (subprocess.run([program, "list", form], capture_output=True, text=True, check=True).stdout
                     for form in ("--parameters", "--schema-json"))
    sections = json.loads(schema)["properties"]
    section, rows = "", []
    for line in table.splitlines():
        if heading := re.match(r"## (\[\[?[\w.]+\]?\])", line):
            section = heading.group(1).strip("[]")
        elif row := re.match(r"\| `(\w+)` \| .*? \| (.*?) \|", line):
            if section != "cells" and not row.group(2).startswith("a formula"):
                entry = sections
                for name in section.split("."):
                    entry = entry[name]["properties"]
                rows.append((f"{section}.{row.group(1)}", row.group(2), entry[row.group(1)].get("type") == "integer"))
    return [row for row in rows if row[0] not in HELD and not row[0].startswith("output.")]


def draw(key, allowed, whole, rng):
    """A value over the allowed range, as text for --set."""
    if names := re.findall(r'"(\w+)"', allowed):
        return rng.choice(names)
    if "true" in allowed:
        return rng.choice(["true", "false"])
    bound = r"(-?[\d.]+(?:e[+-]?\d+)?)"
    low = re.search(rf">=? {bound}", allowed)
    high = re.search(rf"<=? {bound}", allowed)
    unit = allowed[high.end():].strip() if high else ""
    low, high = float(low.group(1)), float(high.group(1)) if high else 1e6
    if key == "run.time_step":
        low = 0.05
    if low < 0.0:
        value = rng.uniform(low, high)
    else:
        floor = max(low, high * 1e-9)
        value = floor * (high / floor) ** rng.random()
        if low == 0.0 and ">=" in allowed and rng.random() < 0.1:
            value = 0.0
    if whole:
        return str(round(value))
    return f"{value:.6g} {unit}".strip()


def settings(rows, seed):
    rng = random.Random(seed)
    chosen = rng.sample(rows, rng.randint(1, 10))
    sets = [f"{key}={draw(key, allowed, whole, rng)}" for key, allowed, whole in chosen]
    if rng.random() < 0.5 and not any(s.startswith(("run.integrator", "run.time_step")) for s in sets):
        sets += ["run.integrator=adaptive", "run.time_step=5 s"]
    return rng.choice(PRESETS), sets


def run(options, rows, seed):
    preset, sets = settings(rows, seed)
    scenario = options.folder / f"{preset}.toml"
    if not scenario.exists():
        subprocess.run([options.program, "new", scenario, "--preset", preset], check=True, stdout=subprocess.DEVNULL)
    command = [options.program, "run", str(scenario), "-o", str(options.folder / f"run-{seed}"), "--quiet",
               "--hours", str(options.hours), "--seed", str(seed)]
    for setting in sets + ([f"ecm.radius={options.radius} um"] if options.radius else []):
        command += ["--set", setting]

    def limits():
        resource.setrlimit(resource.RLIMIT_CPU, (options.limit, options.limit + 5))
        resource.setrlimit(resource.RLIMIT_AS, (9 << 30, 9 << 30))

    ended = subprocess.run(command, capture_output=True, text=True, preexec_fn=limits)
    (options.folder / f"run-{seed}.log").write_text(" ".join(command) + "\n" + ended.stderr)
    reason = next((l for l in ended.stderr.splitlines() if " was written by " not in l), "")
    fine = ended.returncode == 0 or (ended.returncode in (3, 4) and reason)
    return seed, ended.returncode, bool(fine), reason, sets


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("program", type=lambda p: str(pathlib.Path(p).resolve()))
    parser.add_argument("folder", type=lambda p: pathlib.Path(p).resolve())
    parser.add_argument("--runs", type=int, default=60)
    parser.add_argument("--hours", type=float, default=0.3)
    parser.add_argument("--radius", help="um, of the disc of matrix in place of that of the preset")
    parser.add_argument("--jobs", type=int, default=2)
    parser.add_argument("--limit", type=int, default=1200, help="CPU seconds of a run")
    options = parser.parse_args()
    options.folder.mkdir(parents=True)
    rows = parameters(options.program)
    codes, bad = collections.Counter(), 0
    with concurrent.futures.ThreadPoolExecutor(options.jobs) as pool:
        for seed, code, fine, reason, sets in pool.map(lambda s: run(options, rows, s), range(1, options.runs + 1)):
            codes[code] += 1
            bad += not fine
            print(f"{seed:4} {code:4} {'' if fine else 'NOT AS IT SHOULD BE '}{reason[:150]}", flush=True)
            if not fine:
                print("          " + "  ".join(sets))
    cpu = resource.getrusage(resource.RUSAGE_CHILDREN)
    print(f"{options.runs} runs: " + ", ".join(f"{n} with {code}" for code, n in sorted(codes.items()))
          + f"; {cpu.ru_utime + cpu.ru_stime:.0f} s of CPU in all; {bad} not as they should be")
    return 1 if bad else 0


if __name__ == "__main__":
    sys.exit(main())
