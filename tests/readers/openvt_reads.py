"""OpenVT's table and records against what readers of OpenVT demand.

The readers of its workshop of 2026 (jmosborne/OpenVt2026Workshop) demand exactly these columns, finite numbers, type 0
or 1, the same cells at all times, and evenly spaced times. Its records (OpenVT/OpenVTschema): a simulator has name,
category and description, and lists of objects and processes with ids; a simulation has what its "required" names.
OPENVT_SCHEMA names a checkout of OpenVTschema: its global schema is then applied as well.
"""
import csv
import json
import math
import os
import sys

folder = sys.argv[1]
with open(f"{folder}/export/openvt.csv", newline="") as text:
    reader = csv.DictReader(text)
    assert reader.fieldnames == ["simID", "time", "cellID", "cellType", "x", "y"], reader.fieldnames
    rows = list(reader)
with open(f"{folder}/tracks.csv", newline="") as text:
    ours = {float(row["t_s"]): row for row in csv.DictReader(text)}
assert [float(row["time"]) for row in rows] == [0.0, 36.0, 72.0, 108.0, 144.0, 180.0]
for row in rows:
    assert all(math.isfinite(float(row[key])) for key in ("time", "x", "y"))
    assert (row["simID"], row["cellID"], row["cellType"]) == ("0", "1", "0")
    there = ours[float(row["time"])]
    assert float(row["x"]) == float(there["x_um"]) and float(row["y"]) == float(there["y_um"])

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
