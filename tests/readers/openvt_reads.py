"""OpenVT's table and records against what readers of OpenVT demand.

Its workshop of 2026 (jmosborne/OpenVt2026Workshop) has two readers of tables, both of cell sorting: there is none for
models 1 and 2. morpheus-ai/code/validate_portal_csv_calibrated.py demands exactly these columns, finite numbers, type 0 or 1
(or A or B), one simID, the same cells, each once, at all times, and 101 evenly spaced times. CC3D_1/code/visualize_results.py
wants times that are written as integers, and 101 of them. OPENVT_WORKSHOP names a checkout: its validator is then run.
tjsego/PersistentCell, which compares persistent random walks, reads any columns by name or number (celltrackR).
Its records (OpenVT/OpenVTschema): a simulator has name, category and description, and lists of objects and processes with
ids; a simulation has what its "required" names.
OPENVT_SCHEMA names a checkout of OpenVTschema: its global schema is then applied as well.
"""
import csv
import importlib
import json
import math
import os
import pathlib
import sys

folder = sys.argv[1]


def table(path):
    """The rows, after all that the workshop's readers ask of a simulation of one cell."""
    with open(path, newline="", encoding="utf-8") as text:
        reader = csv.DictReader(text)
        assert reader.fieldnames == ["simID", "time", "cellID", "cellType", "x", "y"], reader.fieldnames
        rows = list(reader)
    assert all(math.isfinite(float(row[key])) for row in rows for key in ("time", "x", "y"))
    assert {(row["simID"], row["cellID"], row["cellType"]) for row in rows} == {("0", "1", "0")}
    times = [int(row["time"]) for row in rows]
    steps = {after - before for before, after in zip(times, times[1:])}
    assert len(set(times)) == len(rows) and len(steps) == 1 and steps.pop() > 0, times
    return rows


rows = table(f"{folder}/export/openvt.csv")
with open(f"{folder}/tracks.csv", newline="") as text:
    ours = {float(row["t_s"]): row for row in csv.DictReader(text)}
assert [float(row["time"]) for row in rows] == [0.0, 36.0, 72.0, 108.0, 144.0, 180.0]
for row in rows:
    there = ours[float(row["time"])]
    assert float(row["x"]) == float(there["x_um"]) and float(row["y"]) == float(there["y_um"])
hundred_and_one = f"{folder}-openvt/export/openvt.csv"
assert len(table(hundred_and_one)) == 101
if "OPENVT_WORKSHOP" in os.environ:
    sys.path.insert(0, f"{os.environ['OPENVT_WORKSHOP']}/morpheus-ai/code")
    validate = importlib.import_module("validate_portal_csv_calibrated").validate
    read = validate(pathlib.Path(hundred_and_one), expected_cells=1, expected_a=1, expected_b=0)
    assert (read["status"], read["time_points"], read["sample_interval"]) == ("valid", 101, 2.0), read
    print("the workshop's validator takes the table")

with open(f"{folder}/export/openvt.json") as text:
    record = json.load(text)
assert not [key for key in record["required"] if key not in record["properties"]]
assert record["properties"]["simulator"] == "Matrigrate" and record["properties"]["units"]["time"] == "s"
assert record["properties"]["parameters"]["ecm.radius"] == "60 um", record["properties"]["parameters"]
assert len(record["properties"]["simulations"]) == 1

with open(f"{folder}/export/openvt_simulator.json") as text:
    simulator = json.load(text)
processes = {process["process_id"] for process in simulator["processes"]}
objects = {thing["object_id"] for thing in simulator["objects"]}
assert all(isinstance(simulator[key], str) for key in ("name", "category", "description"))
assert all(set(thing["processes"]) <= processes for thing in simulator["objects"])
assert all({inside["outer_object_id"], inside["inner_object_id"]} <= objects for inside in simulator["containment"])
if "OPENVT_SCHEMA" in os.environ:
    import jsonschema

    with open(f"{os.environ['OPENVT_SCHEMA']}/global_schema.json") as text:
        jsonschema.validate(simulator, json.load(text))
    print("the simulator fits OpenVT's global schema")
print(f"{len(rows)} positions, 2 records")
