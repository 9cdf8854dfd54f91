"""Scenarios in Python: the schema, defaults, words and files are those of the program."""
import ast
import doctest
import importlib
import json
import os
import pathlib
import subprocess
import sys
import tempfile
import tomllib
import unittest

import common
import matrigrate
import numpy as np
from matrigrate import Scenario
from matrigrate.scenario import schema
from matrigrate.scenario import sections

wrong = [  # what the program and Python must say the same of
    ("ecm", "youngs_modulus", value) for value in
    (-1, 0, 2e7, "50 s", "50 kg", "50", "0,2 kPa", "fifty Pa", "50 Pascals", "20 MPa", "10.0001 MPa", "1e999 Pa", "5 Pa^x",
     "50 Pa^2", "50 /", "50 Pa*", True, [1], 1e300, "-3 Pa", "", "7 Pa s/m", "3 um^0.5", "x" * 90,
     "3 Pa^1.2345", "a\tb", "1e400 h 3 min", "1e999999999 Pa")
] + [
    ("ecm", "lattice", "sqare"), ("ecm", "lattice", "round"), ("ecm", "lattice", 3), ("ecm", "cell_hole", "yes"),
    ("ecm", "cell_hole", 1), ("ecm", "poissons_ratio", 0.5), ("ecm", "poissons_ratio", "0.4"), ("run", "seed", 1.5),
    ("run", "seed", "1"), ("run", "seed", -1), ("run", "seed", True), ("run", "duration", "6 h 30 Pa"),
    ("run", "duration", "366 d"), ("run", "duration", "9000"), ("fibres", "direction_deg", 270),
    ("fibres", "direction_deg", "4 rad"), ("fibres", "direction_deg", "3 Pa"), ("fibres", "direction_deg", "3"),
    ("protrusion", "deflection_cone", "190 deg"), ("protrusion", "deflection_cone", 4), ("cell", "crowding", 1),
    ("solver", "max_iterations", 0), ("ecm", "youngs_modulu", 1), ("ecm", "E", 1), ("ecm", "force", 1), ("run", "zzzzzz", 1),
    ("cell", "repulsion_stiffness", "3 N/m^1.5 s"), ("adhesion", "zeta_diss", "20 nN"), ("run", "threads", 1025),
    ("ecm", "stiffness", 1), ("ecm", "elasticity", 1), ("ecm", "elastic_modulus", 1), ("ecm", "modulus", 1), ("ecm", "rigidity", 1),
    ("ecm", "domain_radius", 1), ("ecm", "poisson_ratio", 1), ("ecm", "resolution", 1), ("run", "hours", 1), ("run", "time", 1),
    ("run", "end_time", 1), ("run", "dt", 1), ("run", "step", 1), ("cell", "contraction", 1), ("actomyosin", "contractility", 1),
    ("cell", "diameter", 1), ("fibres", "orientation", 1), ("fibres", "modulus", 1),
    *(("ecm", "youngs_modulus", f"1 {unit}") for unit in ("kpa", "KPA", "pa", "PASCALS", "Kilopascal", "Bar")),
    *(("run", "duration", f"1 {unit}") for unit in ("Hrs", "HOURS", "sec", "S", "Weeks")),
    ("ecm", "radius", "1 micron"), ("ecm", "radius", "1 UM"),
]
right = [
    ("ecm", "youngs_modulus", "0.05 kPa"), ("degradation", "threshold", "1 MPa"), ("degradation", "threshold", 1e6),
    ("ecm", "youngs_modulus", ".5e2 Pa"), ("ecm", "youngs_modulus", "50 nN/um^2 "), ("run", "duration", "6 h 30 min"),
    ("run", "duration", "90 minutes"), ("run", "duration", "365 d"), ("fibres", "direction_deg", "30°"),
    ("fibres", "direction_deg", "0.5 rad"), ("cell", "repulsion_stiffness", "1.4 N/m^1.5"), ("cell", "start_x", "-1 µm"),
    ("adhesion", "zeta_diss", "20 1/nN"), ("ecm", "viscosity", "1 kPa s"), ("cell", "dashpot", "0.0025 N·s/m"),
    ("fibres", "half_angle_deg", 90), ("solver", "tolerance", 1e-3), ("ecm", "radius", 100),
]


class LikeTheProgram(common.InTemporaryFolder):
    def check(self, cases):
        files = []
        for k, (section, key, value) in enumerate(cases):
            text = ("true" if value else "false") if isinstance(value, bool) else json.dumps(value, ensure_ascii=False)
            files.append(f"{k}.toml")
            (self.folder / files[-1]).write_text(f'run.integrator = "adaptive"\n{section}.{key} = {text}\n')
        done = subprocess.run([common.program, "check", "--json", *files], capture_output=True, text=True)
        return [file["faults"] for file in json.loads(done.stdout)["files"]]

    def test_words(self):
        for (section, key, value), faults in zip(wrong, self.check(wrong), strict=True):
            with self.subTest(f"{section}.{key} = {value!r}"), self.assertRaises(matrigrate.ConfigurationError) as caught:
                setattr(getattr(Scenario(), section), key, value)
            ours = caught.exception.faults
            self.assertEqual([(f.key, f.message) for f in ours], [(f["key"], f["message"]) for f in faults], repr(value))

    def test_what_is_right(self):
        for (section, key, value), faults in zip(right, self.check(right), strict=True):
            with self.subTest(f"{section}.{key} = {value!r}"):
                self.assertEqual(faults, [])
                setattr(getattr(Scenario(), section), key, value)

    def test_checks_need_the_compiled_module(self):
        script = "import matrigrate as m\ntry: m.Scenario({'ecm.radius': '1 kg'})\nexcept m.CoreNotFound as error: print(error)"
        done = subprocess.run([sys.executable, "-c", script], capture_output=True, text=True, env=os.environ | {"MATRIGRATE_CORE": "/nowhere"})
        self.assertIn("./demo builds the module", done.stdout, done.stderr)

    def test_cells(self):
        scenario = Scenario({"cells": [{"x": "-0.02 mm", "y": 0}, {"x": 20, "y": "1 um"}], "ecm": {"radius": 90}})
        self.assertEqual(scenario.cells, [(-20.0, 0.0), (20.0, 1.0)])
        (self.folder / "pair.toml").write_text(scenario.toml())
        matrigrate.base.program.check(self.folder / "pair.toml")
        self.assertEqual(Scenario.load(self.folder / "pair.toml"), scenario)
        self.assertEqual(scenario.copy(), scenario)
        moved = scenario.copy()
        moved.cells = [(0, 0)]
        self.assertNotEqual(moved, scenario)
        (self.folder / "bad.toml").write_text('[[cells]]\nx = "1 Pa"\ny = 4000\n[[cells]]\nx = 0\n')
        with self.assertRaises(matrigrate.ConfigurationError) as ours:
            Scenario.load(self.folder / "bad.toml")
        with self.assertRaises(matrigrate.ConfigurationError) as theirs:
            matrigrate.base.program.check(self.folder / "bad.toml")
        self.assertEqual({(f.key, f.message) for f in ours.exception.faults},
                         {(f.key, f.message) for f in theirs.exception.faults})

    def test_changes(self):
        scenario = Scenario({"actomyosin.force": 0.5, "changes": [{"at": "4 h", "actomyosin": {"force": 0.5}, "laws.growth_force": 1},
                                                                  {"at": 2, "actomyosin.force": "200 pN"}]})
        self.assertEqual(scenario.changes[1], {"at": 2, "actomyosin.force": "200 pN"})
        (self.folder / "washout.toml").write_text(scenario.toml())
        matrigrate.base.program.check(self.folder / "washout.toml")
        loaded = Scenario.load(self.folder / "washout.toml")
        self.assertEqual(loaded, scenario)
        self.assertEqual(scenario.copy(), scenario)
        loaded.changes = reversed_changes = list(reversed(scenario.changes))
        self.assertEqual(loaded, scenario, "sorted by their times")
        loaded.changes = reversed_changes[:1]
        self.assertNotEqual(loaded, scenario)
        law = Scenario({"laws.growth_force": "g/u", "laws.constants": "g = 1, u = 2",
                        "changes": [{"at": "2 h", "laws.constants.g": 3}]})
        (self.folder / "law.toml").write_text(law.toml())
        matrigrate.base.program.check(self.folder / "law.toml")
        self.assertEqual(Scenario.load(self.folder / "law.toml"), law)
        bad = {"changes": [{"at": "0 h", "cell.radius": 3, "cell": {"dashpt": 3}}, {"cell.dashpot": "1 Pa"}, {"at": "1 h"},
                           {"at": 1, "run": {"seed": 2}, "ecm.fields.ligand": "1"}]}
        (self.folder / "bad.toml").write_text('[[changes]]\nat = "0 h"\ncell.radius = 3\ncell.dashpt = 3\n[[changes]]\n'
                                              'cell.dashpot = "1 Pa"\n[[changes]]\nat = "1 h"\n[[changes]]\nat = 1\n'
                                              'run.seed = 2\necm.fields.ligand = "1"\n')
        with self.assertRaises(matrigrate.ConfigurationError) as ours:
            Scenario(bad)
        with self.assertRaises(matrigrate.ConfigurationError) as theirs:
            matrigrate.base.program.check(self.folder / "bad.toml")
        self.assertEqual({(f.key, f.message) for f in ours.exception.faults},
                         {(f.key, f.message) for f in theirs.exception.faults})
        for wrong in ("3 h", [3], {"at": 3}):
            with self.assertRaises(TypeError):
                scenario.changes = wrong

    def test_many_faults_at_once(self):
        table = {"ecm": {"radius": -1, "a": 2}, "emc": {"x": 1}, "typo": 3}
        (self.folder / "bad.toml").write_text("typo = 3\n[ecm]\nradius = -1\na = 2\n[emc]\nx = 1\n")
        with self.assertRaises(matrigrate.ConfigurationError) as ours:
            Scenario(table)
        with self.assertRaises(matrigrate.ConfigurationError) as theirs:
            matrigrate.base.program.check(self.folder / "bad.toml")
        self.assertEqual({str(f) for f in ours.exception.faults}, {str(f) for f in theirs.exception.faults})

    def test_a_file_of_the_program_means_what_was_done_before_by_a_key_that_it_lacks(self):
        self.assertEqual(Scenario({"version": "0.2.0"}).adhesion.rest_speed, 0)
        self.assertEqual(Scenario({"version": "0.2.0", "adhesion.rest_speed": 3}).adhesion.rest_speed, 3)
        self.assertEqual(Scenario({"adhesion.spread": 2}).adhesion.rest_speed, 2.7, "written by hand: today's default")

    def test_a_parameter_that_has_gone_may_have_the_value_that_is_left(self):
        self.assertEqual(Scenario({"adhesion": {"hold": "matter", "rupture_strands": 2}}), Scenario())
        (self.folder / "gone.toml").write_text('[adhesion]\nhold = "place"\nrupture_strands = 1\n')
        with self.assertRaises(matrigrate.ConfigurationError) as ours:
            Scenario({"adhesion": {"hold": "place", "rupture_strands": 1}})
        with self.assertRaises(matrigrate.ConfigurationError) as theirs:
            matrigrate.base.program.check(self.folder / "gone.toml")
        self.assertEqual({(f.key, f.message) for f in ours.exception.faults},
                         {(f.key, f.message) for f in theirs.exception.faults})

    def test_defaults_and_units(self):
        resolved = matrigrate.load(common.runs / "run").scenario
        scenario = Scenario(resolved)
        named = {f"{section}.{key}" if isinstance(value, dict) else section
                 for section, table in resolved.items() if section != "version" for key, value in table.items()}
        self.assertEqual(named - {"laws.constants"}, set(schema.sections()))
        self.assertEqual(set(scenario), set(scenario.given()), "the program writes every parameter")
        for path in set(scenario) - {"ecm.radius", "protrusion.initiation_rate", "run.duration", "run.integrator",
                                     "run.time_step", "output.report"}:
            self.assertEqual(Scenario()[path], scenario[path], path)
        adaptive = Scenario({"run.integrator": "adaptive"})
        self.assertEqual(adaptive.run.time_step, scenario.run.time_step)
        for parameter in schema.parameters().values():
            if parameter.kind in ("quantity", "angle"):
                self.assertEqual(parameter.fault(f"1e999 {parameter.unit}").count("is out of range"), 1)

    def test_presets(self):
        soft = Scenario.preset("soft")
        self.assertEqual(soft.changed(), {"run.integrator": "adaptive", "ecm.youngs_modulus": "50 Pa"})
        self.assertEqual(Scenario.preset("baseline"), Scenario.load(common.source / "scenarios" / "baseline.toml"))
        with self.assertRaisesRegex(matrigrate.ConfigurationError, 'no preset "sotf"; did you mean soft'):
            Scenario.preset("sotf")

    def test_saved_files_are_good(self):
        scenario = Scenario.preset("two-protrusions-fibres")
        scenario.ecm.youngs_modulus = "0.1 kPa"
        scenario.ecm.radius = np.float32(80)
        scenario.protrusion.number = np.int64(3)
        path = scenario.save("mine.toml")
        done = subprocess.run([common.program, "check", path], capture_output=True, text=True)
        self.assertEqual((done.returncode, done.stdout), (0, "mine.toml: good\n"), done.stderr)
        self.assertEqual(Scenario.load(path), scenario)
        self.assertEqual(tomllib.loads(path.read_text())["ecm"]["youngs_modulus"], "0.1 kPa")
        with self.assertRaisesRegex(matrigrate.InputOutputError, "exists and is not overwritten"):
            scenario.save("mine.toml")
        scenario.save("mine.toml", overwrite=True)

    def test_the_program_has_the_final_say(self):
        scenario = Scenario()
        scenario.ecm.radius = 20  # in range, but too small for the cell
        with self.assertRaisesRegex(matrigrate.ConfigurationError, "the cell and its margin reach") as caught:
            scenario.save("small.toml")
        self.assertEqual(caught.exception.faults[0].key, "ecm.radius")
        self.assertFalse((self.folder / "small.toml").exists())

    def test_files_that_are_none(self):
        for text, words in (("[", "cannot be read as TOML"), ("replicates = 3\n", "there is no such parameter")):
            (self.folder / "x.toml").write_text(text)
            with self.assertRaisesRegex(matrigrate.ConfigurationError, words):
                Scenario.load("x.toml")
        with self.assertRaisesRegex(matrigrate.InputOutputError, "cannot be read: No such file"):
            Scenario.load("none.toml")


class Objects(unittest.TestCase):
    def test_schema_is_that_of_the_documentation(self):
        printed = subprocess.run([common.program, "list", "--schema-json"], capture_output=True, text=True).stdout
        self.assertEqual((common.source / "docs" / "scenario.schema.json").read_text(), printed)
        printed = subprocess.run([common.program, "list", "--readouts-json"], capture_output=True, text=True).stdout
        self.assertEqual((common.source / "docs" / "readouts.json").read_text(), printed)

    def test_names(self):
        scenario = Scenario()
        with self.assertRaisesRegex(matrigrate.UnknownParameter, "^emc: there is no such section; did you mean ecm"):
            scenario.emc
        with self.assertRaises(matrigrate.ConfigurationError):
            scenario.ecm = 3
        with self.assertRaises(matrigrate.ConfigurationError):
            scenario.foo = 3
        self.assertFalse(hasattr(scenario, "emc"))
        self.assertIn("youngs_modulus", dir(scenario.ecm))
        self.assertIn("ecm", dir(scenario))
        self.assertIn("A bare number is in Pa.", type(scenario.ecm).youngs_modulus.__doc__)
        self.assertEqual(scenario.unit("actomyosin.force"), "nN")
        self.assertIn("youngs_modulus", repr(scenario.ecm))

    def test_copies_and_defaults(self):
        scenario = Scenario({"ecm": {"radius": "60 um"}}, name="a")
        other = scenario.copy("b")
        other.ecm.radius = "0.07 mm"
        self.assertEqual((scenario.ecm.radius, other.ecm.radius, other.name), (60.0, 70.0, "b"))
        del other["ecm.radius"]
        self.assertEqual(other, Scenario())
        self.assertEqual(repr(scenario), 'Scenario(a: ecm.radius="60 um")')


class Laws(common.InTemporaryFolder):
    def test_are_texts_that_the_program_checks(self):
        scenario = Scenario({"ecm.radius": "60 um"})
        self.assertEqual(scenario.laws.polarization_rate, "r_pol")
        self.assertEqual(schema.parameters()["laws.polarization_rate"].kind, "law")
        self.assertEqual(schema.parameters()["laws.constants"].kind, "constants")
        scenario.laws.polarization_rate = "r_pol*min(1, angle_s/angle)"
        scenario.laws.constants = "angle_s = 0.5"
        self.assertEqual(scenario.changed()["laws.polarization_rate"], "r_pol*min(1, angle_s/angle)")
        file = self.folder / "law.toml"
        scenario.save(file)
        self.assertEqual(Scenario.load(file), scenario)
        matrigrate.base.program.check(file)
        scenario.laws.polarization_rate = "r_pool"
        with self.assertRaisesRegex(matrigrate.ConfigurationError, "there is no r_pool; did you mean r_pol"):
            scenario.save(file, overwrite=True)
        with self.assertRaisesRegex(matrigrate.ConfigurationError, "write a formula in angle"):
            scenario.laws.polarization_rate = True

    def test_of_files_may_have_a_table_of_constants(self):
        file = self.folder / "law.toml"
        file.write_text('[laws]\ngrowth_force = "max(0, 1 - l/l_s)"\n[laws.constants]\nl_s = "15 um"\n')
        self.assertEqual(Scenario.load(file).laws.constants, "l_s = 15 um")

    def test_have_constants_that_are_parameters(self):
        scenario = Scenario({"ecm.radius": "60 um", "laws.disassembly_rate": "n*r_off_min*exp(min(20, F/F_s))"})
        scenario.laws.constants.F_s = "400 pN"
        scenario["laws.constants.n"] = np.float64(2.0)
        self.assertEqual((scenario.laws.constants.F_s, scenario["laws.constants.n"]), (0.4, 2.0))
        self.assertEqual(scenario.unit("laws.constants.F_s"), "nN")
        self.assertEqual(str(scenario.laws.constants), "F_s = 0.4 nN, n = 2")
        self.assertEqual((list(scenario.laws.constants), dict(scenario.laws.constants)), (["F_s", "n"], {"F_s": 0.4, "n": 2.0}))
        file = self.folder / "law.toml"
        scenario.save(file)
        loaded = Scenario.load(file)
        self.assertEqual(loaded, scenario)
        old = Scenario(scenario.given() | {"laws.constants": "n = 2, F_s = 0.4 nN"})
        self.assertEqual(old, scenario)
        old.laws.constants.F_s = 1  # nN; the other one stays
        self.assertEqual(str(old.laws.constants), "F_s = 1 nN, n = 2")
        self.assertNotEqual(old, scenario)
        self.assertEqual(loaded, scenario.copy())
        del loaded.laws.constants.n
        self.assertEqual(str(loaded.laws.constants), "F_s = 0.4 nN")
        with self.assertRaisesRegex(matrigrate.ConfigurationError, "there is no n"):
            loaded.check()

    def test_have_constants_that_are_judged_by_the_program(self):
        scenario = Scenario()
        scenario.laws.constants = {"F_s": {"value": "0.4 nN", "range": ("0.1 nN", 1)}, "n": 2}
        wrong = [("F_s", "2 nN", 'F_s: "2 nN" is out of range; allowed is >= 0.1 and <= 1 nN'), ("F_s", "1 Pa", "is a stress, but a force is expected"),
                 ("n", "2 nN", "is a string"), ("n", True, "is a flag"), ("n", None, "is no number"), ("kappa", 1, "kappa is taken"),
                 ("F s", 1, "is no name"), ("F_c", "1 parsec", "is not a unit"),
                 ("F_s", {"value": "1 nN", "range": ["2 nN", "1 nN"]}, "begins at 2 nN and ends at 1 nN")]
        for name, value, words in wrong:
            with self.subTest(name=name, value=value), self.assertRaisesRegex(matrigrate.ConfigurationError, words):
                scenario.laws.constants[name] = value
        with self.assertRaisesRegex(AttributeError, "laws.constants.F_z: there is no such constant; there are F_s, n"):
            scenario.laws.constants.F_z
        self.assertEqual(str(scenario.laws.constants), "F_s = 0.4 nN, n = 2")
        scenario.laws.constants.F_s = "0.2 nN"
        self.assertIn('F_s = { value = "0.2 nN", range = ["0.1 nN", 1] }', scenario.toml())


class Stub(unittest.TestCase):
    def test_names_are_those_at_run_time(self):
        with tempfile.TemporaryDirectory() as folder:
            stub = pathlib.Path(folder) / "sections.pyi"
            subprocess.run([sys.executable, "-B", common.source / "tools" / "stubs.py", stub], check=True)
            module = ast.parse(stub.read_text(encoding="utf-8")).body
        classes = {node.name: node for node in module if isinstance(node, ast.ClassDef) and not node.name.startswith("_")}
        functions = {node.name for node in module if isinstance(node, ast.FunctionDef)}
        ours = {name: thing for name, thing in vars(sections).items()
                if getattr(thing, "__module__", "") == sections.__name__ and not name.startswith("_")}
        self.assertEqual(set(classes) | functions, set(ours))
        for name, node in classes.items():
            members = {member.name if isinstance(member, ast.FunctionDef) else member.target.id for member in node.body
                       if isinstance(member, (ast.FunctionDef, ast.AnnAssign))} - {"__init__"}
            with self.subTest(name):
                self.assertEqual(members, {key for key in vars(ours[name]) if not key.startswith("_")})
        section = Scenario().ecm.fields
        self.assertEqual((type(section).__name__, type(section).__module__), ("EcmFields", "matrigrate.scenario.sections"))
        self.assertIn("fields", dir(Scenario().ecm))


def load_tests(_, tests, __):
    tests.addTests(doctest.DocTestSuite(importlib.import_module("matrigrate.scenario")))
    tests.addTests(doctest.DocTestSuite(schema))
    tests.addTests(doctest.DocTestSuite(sections))
    return tests


if __name__ == "__main__":
    unittest.main()
