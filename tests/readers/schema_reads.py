"""docs/scenario.schema.json by Python's jsonschema: it takes every scenario that is written, and refuses what is wrong.

schema_reads.py PROGRAM SOURCE_FOLDER
"""

import json
import pathlib
import subprocess
import sys
import tempfile

try:
    import jsonschema
    import tomllib
except ImportError as missing:
    print(f"not here: {missing}")
    sys.exit(77)

program, source = sys.argv[1], pathlib.Path(sys.argv[2])
count = 0


def schema_named_by(scenario):
    """The schema of the first line, which is looked for from the folder of the scenario."""
    first = scenario.read_text().splitlines()[0]
    assert first.startswith("#:schema "), f"{scenario}: its first line names no schema: {first}"
    return json.loads((scenario.parent / first.removeprefix("#:schema ")).read_text())


def faults(schema, table):
    return [error.message for error in jsonschema.Draft7Validator(schema).iter_errors(table)]


def expect_valid(scenario):
    global count
    schema = schema_named_by(scenario)
    jsonschema.Draft7Validator.check_schema(schema)
    found = faults(schema, tomllib.loads(scenario.read_text()))
    assert not found, f"{scenario}: {found}"
    count += 1


expect_valid(source / "scenarios" / "baseline.toml")
listed = subprocess.run([program, "list"], check=True, capture_output=True, text=True).stdout.split("\n\n")[0]
presets = [line.split()[0] for line in listed.splitlines()[1:]]
assert len(presets) >= 19, presets
with tempfile.TemporaryDirectory() as folder:
    for preset in presets:
        new = pathlib.Path(folder) / f"{preset}.toml"
        subprocess.run([program, "new", new, "--preset", preset], check=True, stdout=subprocess.DEVNULL)
        expect_valid(new)

schema = json.loads((source / "docs" / "scenario.schema.json").read_text())
good = {"run": {"duration": "6 h 30 min"}, "fibres": {"direction_deg": "30 deg"}, "adhesion": {"zeta_diss": "20 1/nN"}}
assert not faults(schema, good), faults(schema, good)
for bad in (
    {"emc": {}},
    {"ecm": {"youngs_modulu": 1}},
    {"ecm": {"youngs_modulus": "200"}},
    {"ecm": {"youngs_modulus": "0,2 kPa"}},
    {"ecm": {"youngs_modulus": -1}},
    {"ecm": {"lattice": "round"}},
    {"run": {"seed": 1.5}},
):
    assert faults(schema, bad), bad
print(f"{count} scenarios are valid")
