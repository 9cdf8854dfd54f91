"""Lines of code of each wing, and files of the project, are within their budget: budget.py SOURCE [--count]

A wing may grow where CONTRIBUTING.md, "Budget", names who uses what was added. Lines that fall by longer lines do not count:
clang-format keeps the widths of C++, and of other wings the lines of more than 120 columns are counted, which may not be more."""
import pathlib
import subprocess
import sys

budget = {
    "src/base": 1492,
    "src/fields": 2631,
    "src/statistics": 690,
    "src/tracks": 3810,
    "src/parameters": 5677,
    "src/model": 11279,
    "src/run": 9702,
    "src/validation": 2586,
    "src/study": 7128,
    "apps": 5259,
    "python": 7782,
    "R": 826,
    "web": 1179,
    "viewer/src": 9500,
}
wide = {"python": 333, "R": 43, "web": 43, "viewer/src": 222}  # lines of more than 120 columns
most_files = 1110
endings = (".cpp", ".hpp", ".h", ".py", ".ts", ".css", ".mjs", ".R")


def files_of(source):
    """The tracked files below a folder; without git, none."""
    listed = subprocess.run(["git", "-C", source, "ls-files", "-z"], capture_output=True, text=True)
    return [name for name in listed.stdout.split("\0") if name and (source / name).is_file()] if listed.returncode == 0 else []


def lines_of(source, names):
    lines = dict.fromkeys(budget, 0)
    for name in names:
        wing = next((wing for wing in budget if name.startswith(wing + "/")), None)
        if wing and name.endswith(endings):
            lines[wing] += (source / name).read_bytes().count(b"\n")
    return lines


def wide_lines_of(source, names):
    lines = dict.fromkeys(wide, 0)
    for name in names:
        wing = next((wing for wing in wide if name.startswith(wing + "/")), None)
        if wing and name.endswith(endings):
            lines[wing] += sum(len(line) > 120 for line in (source / name).read_text(encoding="utf-8").splitlines())
    return lines


def main():
    source = pathlib.Path(sys.argv[1])
    names = files_of(source)
    if not names:
        print("skipped: this is no clone")
        return 0
    lines, wider = lines_of(source, names), wide_lines_of(source, names)
    if "--count" in sys.argv:
        for wing, count in lines.items():
            print(f"{wing:16} {count:6} of {budget[wing]}")
        print("wide:", ", ".join(f"{wing} {count} of {wide[wing]}" for wing, count in wider.items()))
        print(f"{'all':16} {sum(lines.values()):6} of {sum(budget.values())}; {len(names)} files of {most_files}")
    faults = [f"{wing}: {count} lines, the budget is {budget[wing]}" for wing, count in lines.items() if count > budget[wing]]
    faults += [f"{wing}: {count} lines have more than 120 columns, {wide[wing]} may" for wing, count in wider.items() if count > wide[wing]]
    faults += [f"{len(names)} tracked files, the budget is {most_files}"] * (len(names) > most_files)
    print("\n".join(faults))
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main())
