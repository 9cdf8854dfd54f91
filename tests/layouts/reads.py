"""`matrigrate tracks` over the layouts of other programs: what it reads is right to 1e-9, what it refuses it refuses with the
way out. Usage: reads.py PROGRAM"""
import json
import pathlib
import re
import subprocess
import sys
import tempfile

from layouts import Layout, layouts


def words_of(told: dict) -> list[str]:
    """The options of the program of the same names."""
    words = []
    for name, value in told.items():
        for one in [f"{key}={column}" for key, column in value.items()] if isinstance(value, dict) else [str(value)]:
            words += [f"--{name.replace('_', '-')}", one]
    return words


def faults(program: str, layout: Layout) -> list[str]:
    """What differs from the manifest."""
    call = subprocess.run([program, "tracks", layout.file, "--json", *words_of(layout.told)], capture_output=True,
                          encoding="utf-8")
    if layout.refused:
        if call.returncode != 3:
            return [f"exit code {call.returncode}, not 3: {call.stderr}"]
        lines = call.stderr.splitlines()
        return [] if any(re.search(layout.refused, line) for line in lines) else [f"no line says {layout.refused!r}: {call.stderr}"]
    if call.returncode != 0:
        return [f"exit code {call.returncode}: {call.stderr}"]
    found = json.loads(call.stdout)
    numbers = {"tracks": layout.tracks, "positions": layout.positions, "missing": layout.missing, "interval_s": layout.interval}
    wrong = [f"{name}: {found[name]}, not {value}" for name, value in numbers.items()
             if abs(found[name] - value) > 1e-9 * abs(value)]
    speed = found["readouts"]["speed_um_per_h"]["value"]
    if abs(speed - layout.speed) > 1e-9 * layout.speed:
        wrong.append(f"speed {speed}, not {layout.speed} um/h")
    if len(found["rows"]) != found["positions"]:
        wrong.append(f"{len(found['rows'])} rows of {found['positions']} positions")
    if layout.said and not any(re.search(layout.said, note) for note in found["notes"]):
        wrong.append(f"no note says {layout.said!r}: {found['notes']}")
    return wrong


def main(program: str) -> int:
    with tempfile.TemporaryDirectory() as folder:
        bad = 0
        for layout in layouts:
            pathlib.Path(folder, layout.file).write_bytes(layout.bytes)
        for layout in layouts:
            for fault in faults(program, Layout(**{**vars(layout), "file": str(pathlib.Path(folder, layout.file))})):
                bad += 1
                print(f"{layout.file}: {fault}")
    print(f"{len(layouts)} files, {bad} faults")
    return 1 if bad else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1]))
