"""A notebook of examples/notebooks runs from its first cell to its last: test_notebooks.py NOTEBOOK.

Its code cells run in their order in a scratch folder, without Jupyter. It is kept without outputs.
"""
import json
import os
import pathlib
import sys
import tempfile

source = pathlib.Path(__file__).resolve().parents[2]


def faults_of_form(book: dict) -> list[str]:
    """What Jupyter would not open, or what belongs to one execution of it."""
    faults = []
    if (book.get("nbformat"), book.get("nbformat_minor")) != (4, 5):
        faults.append("its format is not 4.5")
    if book.get("metadata", {}).get("kernelspec", {}).get("name") != "python3":
        faults.append("its kernel is not python3")
    ids = [cell.get("id") for cell in book["cells"]]
    if len(set(ids)) < len(ids) or not all(ids):
        faults.append("its cells have no ids of their own")
    for cell in book["cells"]:
        if cell["cell_type"] not in ("code", "markdown") or not "".join(cell["source"]).strip():
            faults.append(f"cell {cell['id']} is neither text nor code, or is empty")
        if cell["cell_type"] == "code" and (cell["outputs"] or cell["execution_count"] is not None):
            faults.append(f"cell {cell['id']} has an output; clear all outputs before you keep it")
    for cell in book["cells"]:
        if cell["cell_type"] == "markdown":
            for target in "".join(cell["source"]).split("](")[1:]:
                link = target.split(")")[0].split("#")[0]
                if "://" not in link and not (source / "examples" / "notebooks" / link).exists():
                    faults.append(f"cell {cell['id']}: {link} is not there")
    return faults


def main() -> int:
    notebook = pathlib.Path(sys.argv[1]).resolve()
    book = json.loads(notebook.read_text(encoding="utf-8"))
    if faults := faults_of_form(book):
        print(*(f"{notebook.name}: {fault}" for fault in faults), sep="\n", file=sys.stderr)
        return 1
    code = ["".join(cell["source"]) for cell in book["cells"] if cell["cell_type"] == "code"]
    if any("calibrate.fit" in text for text in code):
        try:
            import scipy  # noqa: F401
        except ImportError as missing:
            print(f"not here: {missing}")
            return 77
    names: dict[str, object] = {"__name__": "__main__"}
    with tempfile.TemporaryDirectory() as folder:
        os.chdir(folder)
        for number, text in enumerate(code, 1):
            exec(compile(text, f"{notebook.name}, code cell {number}", "exec"), names)
        os.chdir(source)
    print(f"{len(code)} code cells ran")
    return 0


if __name__ == "__main__":
    os.environ["MPLBACKEND"] = "agg"
    try:
        import h5py  # noqa: F401
        import matplotlib  # noqa: F401
        import pandas  # noqa: F401
    except ImportError as missing:
        print(f"not here: {missing}")
        sys.exit(77)
    sys.exit(main())
