"""Rooms of the Python package: no private name is used outside of its room, and few arrows go between rooms: python_rooms.py SOURCE [--show]

A room is a folder of python/matrigrate, or the package itself. An arrow is a module that imports something of another room; all may import errors and the compiled module."""
import ast
import pathlib
import sys

most_arrows = 65
public = {"_version", "_core", "__version__"}
for_all = {"errors", "_version", "_core"}


def imports(file, package):
    """(room, name) of all that a module imports from the package."""
    here = file.parent.relative_to(package).parts
    for node in ast.walk(ast.parse(file.read_text(encoding="utf-8"))):
        if not isinstance(node, ast.ImportFrom) or node.level == 0:
            continue
        base = here[:len(here) - node.level + 1]
        path = (*base, *(node.module.split(".") if node.module else ()))
        for name in (alias.name for alias in node.names):
            whole = (*path, name)
            if whole[0] in for_all:
                continue
            room = whole[0] if (package / whole[0]).is_dir() else ""
            yield room, [part for part in whole if part.startswith("_") and part not in public]


def main():
    package = pathlib.Path(sys.argv[1]) / "python" / "matrigrate"
    arrows, faults = set(), []
    for file in sorted(package.rglob("*.py")):
        own = file.parent.name if file.parent != package else ""
        for room, private in imports(file, package):
            if room == own:
                continue
            arrows.add((file.relative_to(package).as_posix(), room))
            faults += [f"{file}: uses {name}, which is private to {room or 'the package'}" for name in private]
    if "--show" in sys.argv:
        print("\n".join(f"{file} -> {room or 'the package'}" for file, room in sorted(arrows)), len(arrows), sep="\n")
    if len(arrows) > most_arrows:
        faults.append(f"{len(arrows)} arrows between rooms; at most {most_arrows}")
    print("\n".join(faults))
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main())
