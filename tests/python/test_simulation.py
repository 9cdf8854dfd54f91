"""A simulation that is stepped from Python."""
import ast
import doctest
import gc
import os
import pathlib
import resource
import shutil
import signal
import subprocess
import sys
import threading
import time
import unittest

import numpy as np

import common
import matrigrate

SMALL = {"ecm.radius": "60 um", "run.integrator": "adaptive", "run.time_step": "5 s"}


OFTEN = {"protrusion.initiation_rate": "2e-3 1/s", "protrusion.growth_time": "60 s", "adhesion.maturation_time": "30 s"}


class TestSimulation(common.InTemporaryFolder):
    def small(self, **options):
        return matrigrate.Simulation(overrides=SMALL | options.pop("overrides", {}), **options)

    def test_has_the_bits_of_the_program(self):
        run = matrigrate.run(matrigrate.Scenario(), out="run", seed=3, hours=0.1, overrides=SMALL)
        simulation = self.small(seed=3)
        for _ in range(6):
            simulation.advance(hours=1 / 60)
        self.assertEqual(simulation.trajectory_hash, run.record["trajectory_hash"])
        self.assertEqual(simulation.step_count, run.record["steps"])

    def test_views(self):
        simulation = self.small()
        x, shape = simulation.matrix.x, (len(simulation.matrix), 2)
        self.assertEqual((x.shape, simulation.matrix.f_degr.shape), (shape, shape[:1]))
        self.assertEqual(simulation.matrix.deviatoric_stress.shape, (*shape, 2))
        self.assertFalse(x.flags.owndata)
        with self.assertRaises(ValueError):
            x[0] = 0
        before = x.copy()
        np.testing.assert_array_equal(before, simulation.matrix.X)
        ring = simulation.cell.x
        simulation.advance(hours=0.15)
        self.assertGreater(np.abs(x - before).max(), 0.01, "the view is of the simulation's own numbers")
        protrusion = simulation.cell.protrusions[0]
        self.assertEqual((protrusion["id"], protrusion["phase"], len(protrusion["anchor_um"])), (1, "maturing", 2))
        del simulation
        gc.collect()
        self.assertTrue(np.isfinite(ring).all(), "a view keeps its simulation alive")

    def test_step(self):
        simulation = self.small(overrides={"run.integrator": "reference", "run.time_step": "0.4 s"})
        simulation.step()
        simulation.step()
        self.assertEqual((simulation.step_count, round(simulation.t, 9)), (2, 0.8))
        adaptive = self.small()
        for steps in range(1, 120):
            before = adaptive.t
            adaptive.step()
            self.assertEqual(adaptive.step_count, steps, "also where steps are halved")
            self.assertLessEqual(adaptive.t - before, 5 + 1e-9)

    def test_a_force_moves_the_cell(self):
        def pull(simulation):
            return np.tile([0.01, 0.0], (len(simulation.cell.x), 1))

        free, pulled = self.small(), self.small(cell_force=pull)
        for simulation in (free, pulled):
            simulation.advance(until=30)
        shift = (pulled.cell.x - free.cell.x).mean(axis=0)
        self.assertGreater(shift[0], 0.01)
        self.assertLess(abs(shift[1]), 0.1 * shift[0])

    def test_a_force_that_is_zero_changes_no_bit(self):
        free = self.small()
        zero = self.small(force=lambda s: np.zeros(s.matrix.x.shape), cell_force=lambda s: None)
        for simulation in (free, zero):
            simulation.advance(until=60)
        self.assertEqual(free.trajectory_hash, zero.trajectory_hash)

    def test_wrong_forces_and_exceptions(self):
        simulation = self.small(cell_force=lambda s: np.zeros((3, 2)))
        with self.assertRaisesRegex(ValueError, r"cell_force must return an array of shape \(\d+, 2\), or None"):
            simulation.advance(until=10)
        self.assertEqual(simulation.step_count, 0)
        simulation = self.small(force=lambda s: "text")
        with self.assertRaisesRegex(ValueError, "force must return an array"):
            simulation.advance(until=10)

        def fails(s):
            if s.t > 10:
                raise ZeroDivisionError("mine")

        simulation = self.small(force=fails)
        with self.assertRaisesRegex(ZeroDivisionError, "mine"):
            simulation.advance(until=60)
        self.assertGreater(simulation.t, 10)
        with self.assertRaises(IndexError):
            simulation._core.cell_x(1)

    def test_masked_arrays_are_refused(self):
        masked = np.ma.masked_array(np.zeros((235, 2)), mask=np.ones((235, 2)))
        for name, function in (("cell_force", lambda s: masked), ("cue", lambda s, cell: masked[:, 0]),
                               ("force", lambda s: masked)):
            with self.subTest(name), self.assertRaisesRegex(ValueError, f"{name} returned a masked array"):
                self.small(**{name: function}).advance(until=10)

    def test_says_what_it_is(self):
        simulation = self.small(overrides={"cells": "[{x = -16, y = 0}, {x = 16, y = 0}]"})
        simulation.advance(hours=0.01)
        self.assertRegex(repr(simulation), r"Simulation\('scenario': 2 cells, \d+ particles of matrix, 0\.01\d* of 6 h, \d+ steps\)")

    def test_the_interpreter_ends_while_a_daemon_computes(self):
        begin = ("import sys, threading, time, numpy as np, matrigrate\n"
                 "s = matrigrate.Simulation(overrides={'ecm.radius': '60 um', 'run.integrator': 'adaptive'}, %s)\n"
                 "threading.Thread(target=lambda: (s.advance(hours=1000), print('returned')), daemon=True).start()\n"
                 "time.sleep(0.3)\nprint(s.step_count > 0)\n")
        for options in ("", "cell_force=lambda s: None", "force=lambda s: sum(range(200000)) and None",
                        "cue=lambda s, c: time.sleep(0.2) if s.t > 10 else None"):
            for end in ("", "sys.exit(3)"):
                done = subprocess.run([sys.executable, "-c", begin % options + end], capture_output=True, text=True, timeout=60)
                with self.subTest(options, end=end):
                    self.assertEqual((done.returncode, done.stdout, done.stderr), (3 if end else 0, "True\n", ""))

    def test_functions_at_the_end_can_still_compute(self):
        script = ("import atexit, matrigrate\ns = matrigrate.Simulation(overrides={'ecm.radius': '60 um'})\n"
                  "atexit.register(lambda: (s.step(), print(s.step_count)))\n")
        early = "import atexit\natexit.register(lambda: (s.step(), print(s.step_count)))\n" + script.split("atexit.reg")[0]
        for text in (script, early):
            done = subprocess.run([sys.executable, "-c", text], capture_output=True, text=True, timeout=60)
            self.assertEqual((done.returncode, done.stdout, done.stderr), (0, "1\n", ""))

    def test_a_cue_of_ones_changes_no_bit(self):
        free, ones, none = self.small(overrides=OFTEN), self.small(
            overrides=OFTEN, cue=lambda s, cell: np.ones(len(cell.x))), self.small(overrides=OFTEN, cue=lambda s, cell: None)
        for simulation in (free, ones, none):
            simulation.advance(until=120)
        self.assertGreater(len(free.cell.protrusions), 0)
        self.assertEqual({free.trajectory_hash}, {ones.trajectory_hash, none.trajectory_hash})

    def test_protrusions_begin_where_the_cue_lets_them(self):
        x_at_start = {}

        def right_half(simulation, cell):
            self.assertEqual((cell.index, cell.x.shape, cell.normals.shape), (0, (235, 2), (235, 2)))
            self.assertIs(simulation.cells[cell.index], cell)
            self.assertFalse(cell.x.flags.writeable or cell.x.flags.owndata)
            outwards = ((cell.x - cell.x.mean(axis=0)) * cell.normals).sum(axis=1)
            self.assertGreater(outwards.mean(), 0)
            np.testing.assert_allclose(np.hypot(*cell.normals.T), 1.0)
            x_at_start[simulation.step_count] = cell.x[:, 0].copy()
            return cell.x[:, 0] >= 0

        simulation, begun = self.small(overrides=OFTEN, cue=right_half), {}
        while simulation.t < 600:
            simulation.step()
            for protrusion in simulation.cell.protrusions:
                begun.setdefault(protrusion["id"], x_at_start[simulation.step_count - 1][protrusion["centre"]])
        self.assertGreater(len(begun), 2)
        self.assertTrue(all(x >= 0 for x in begun.values()), begun)
        silent = self.small(overrides=OFTEN, cue=lambda s, cell: np.zeros(len(cell.x)))
        silent.advance(until=300)
        self.assertEqual(silent.cell.protrusions, [])

    def test_a_cue_every_few_steps(self):
        asked = []
        simulation = self.small(cue=lambda s, cell: asked.append(s.step_count), cue_every=4)
        simulation.advance(until=30)
        while simulation.step_count < 10:
            simulation.step()
        self.assertEqual(asked, list(range(0, simulation.step_count, 4)))
        for wrong in (0, -1, 1.5, "2", True, 10**30):
            with self.assertRaisesRegex(ValueError, "a whole number of steps from 1 to 10.9 is expected"):
                self.small(cue=lambda s, cell: None, cue_every=wrong)

    def test_wrong_cues(self):
        for returned, words in ((np.ones(3), r"cue must return an array of shape \(235,\), or None"),
                                (np.ones((235, 2)), "of shape"), ("text", "of shape"), ({}, "of shape"),
                                (np.full(235, np.nan), "particle 0 is nan"), (np.full(235, np.inf), "particle 0 is inf"),
                                (np.arange(235) - 3.5 == 0.5, None), (3.0 - np.arange(235), "particle 4 is -1.0")):
            simulation = self.small(cue=lambda s, cell, returned=returned: returned)
            if words is None:
                simulation.step()
                continue
            with self.subTest(words), self.assertRaisesRegex(ValueError, words):
                simulation.advance(until=10)
            self.assertEqual(simulation.step_count, 0, "nothing was computed")

        def fails(simulation, cell):
            if simulation.step_count == 5:
                raise ZeroDivisionError("mine")

        simulation, plain = self.small(cue=fails), self.small()
        with self.assertRaisesRegex(ZeroDivisionError, "mine"):
            simulation.advance(until=60)
        self.assertEqual(simulation.step_count, 5)
        simulation._core.set_cue(None, 1)
        for one in (simulation, plain):
            one.advance(until=60)
        self.assertEqual(simulation.trajectory_hash, plain.trajectory_hash, "it goes on as if nothing had been")

    def test_calls_from_inside(self):
        for name in ("force", "cell_force", "cue", "progress"):
            def again(simulation, cell=None):
                simulation.step()

            simulation = self.small(**({} if name == "progress" else {name: again}))
            with self.subTest(name), self.assertRaisesRegex(RuntimeError, "cannot be called while this simulation computes"):
                simulation.advance(until=10, **({"progress": again} if name == "progress" else {}))
            self.assertIsInstance(simulation.trajectory_hash, str, "at rest again")
        seen = []
        simulation = self.small(force=lambda s: seen.append((s.trajectory_hash, s.cell.protrusions)))
        simulation.advance(until=10)
        self.assertGreater(len(seen), 1, "functions can read all of it")

    def test_calls_from_another_thread(self):
        simulation, met = self.small(overrides={"ecm.radius": "100 um"}), []
        worker = threading.Thread(target=lambda: simulation.advance(until=120))
        worker.start()
        while worker.is_alive():
            for use in (simulation.step, lambda: simulation.cell.protrusions, lambda: simulation.trajectory_hash):
                try:
                    use()
                except RuntimeError as error:
                    met.append(str(error))
            simulation.matrix.x.mean()
            time.sleep(0.001)
        self.assertTrue(any("step cannot be called" in words for words in met), met[:3])
        self.assertTrue(any("this cannot be read" in words for words in met), met[:3])

    def test_views_stay_those_of_the_simulation(self):
        simulation = self.small(overrides=OFTEN)
        views = {(body, name): getattr(getattr(simulation, body), name)
                 for body, names in (("matrix", ("x", "X", "v", "f_degr", "density", "deviatoric_stress")),
                                     ("cell", ("x", "v", "rest_lengths"))) for name in names}
        simulation.advance(until=300)
        for (body, name), view in views.items():
            now = getattr(getattr(simulation, body), name)
            self.assertEqual(view.__array_interface__["data"], now.__array_interface__["data"], (body, name))

    def test_wrong_types(self):
        for arguments, words in (({"force": 3}, "force is a number; a function"), ({"cell_force": "x"}, "cell_force is a string"),
                                 ({"cue": np.ones(3)}, "cue is of the type ndarray"), ({"overrides": 3}, "overrides is a number"),
                                 ({"scenario": 3.0}, "scenario is a number; a Scenario or the path")):
            with self.subTest(words), self.assertRaisesRegex(TypeError, words):
                matrigrate.Simulation(**arguments)
        with self.assertRaisesRegex(matrigrate.ConfigurationError, "run.seed"):
            matrigrate.Simulation(seed=1.5)
        simulation = self.small()
        for arguments, error, words in (({"hours": -1}, ValueError, r"hours is -1; a finite number \[h\] >= 0"),
                                        ({"until": float("nan")}, ValueError, "until is nan"),
                                        ({"until": float("inf")}, ValueError, "until is inf"),
                                        ({"hours": "1"}, TypeError, "hours is a string"),
                                        ({"hours": 1, "until": 1}, ValueError, "not both"),
                                        ({"progress": 3}, TypeError, "progress is a number")):
            with self.subTest(words), self.assertRaisesRegex(error, words):
                simulation.advance(**arguments)
        self.assertEqual(simulation.step_count, 0)
        for value in (np.nan, np.inf):
            broken = self.small(force=lambda s, value=value: np.full(s.matrix.x.shape, value))
            with self.assertRaisesRegex(ValueError, f"force must return finite forces, and that of particle 0 is {value}"):
                broken.advance(until=10)
            self.assertEqual(broken.step_count, 0)
            np.testing.assert_array_equal(broken.matrix.x, broken.matrix.X)

    def test_wrong_scenarios(self):
        with self.assertRaises(matrigrate.ConfigurationError) as caught:
            self.small(overrides={"ecm.youngs_modulus": "-1 Pa", "ecm.radiu": 3})
        self.assertEqual(sorted(f.key for f in caught.exception.faults), ["ecm.radiu", "ecm.youngs_modulus"])
        with self.assertRaisesRegex(matrigrate.InputOutputError, "none.toml: cannot be read: No such file"):
            matrigrate.Simulation("none.toml")
        for read in (matrigrate.Simulation, matrigrate.Scenario.load):
            with self.assertRaisesRegex(matrigrate.InputOutputError, "/dev/zero: cannot be read: it is no regular file"):
                read("/dev/zero")
        for text, error, words in ((b"\xff", matrigrate.InputOutputError, "bad.toml: is damaged: it is no text"),
                                   (b"[ecm", matrigrate.ConfigurationError, "bad.toml:1:"),
                                   (b"replicates = 3", matrigrate.ConfigurationError, "bad.toml: is a study of many runs")):
            (self.folder / "bad.toml").write_bytes(text)
            with self.subTest(words), self.assertRaisesRegex(error, words):
                matrigrate.Simulation("bad.toml")
        broken = self.small(overrides={"run.integrator": "reference", "run.time_step": "0.4 s"},
                            force=lambda s: np.full(s.matrix.x.shape, 1e6))
        with self.assertRaises(matrigrate.NumericalError):
            broken.advance(until=10)

    def test_a_failed_simulation_does_not_go_on(self):
        simulation = self.small(overrides={
            "protrusion.initiation_rate": "3e-3 1/s", "protrusion.growth_time": "10 s", "protrusion.finishing_time": "10 s",
            "adhesion.maturation_time": "10 s", "protrusion.force": "0.6 nN", "run.integrator": "adaptive",
            # out of range between the values that are tried before a run
            "laws.disassembly_rate": "sin(2*3.14159265358979*F/6.25e-5) > 0.5 ? -1 : 0.001"})
        self.assertIsNone(simulation.failure)
        with self.assertRaises(matrigrate.NumericalError):
            simulation.advance(hours=0.5)
        at, trajectory = simulation.t, simulation.trajectory_hash
        self.assertRegex(simulation.failure, f"^failed at {at:.6g} s: .*laws.disassembly_rate")
        self.assertIn(f"failed at {at:.6g} s", repr(simulation))
        for go_on in (simulation.step, simulation.advance, lambda: simulation.advance(until=0)):
            with self.assertRaisesRegex(matrigrate.NumericalError, f"failed at {at:.6g} s and cannot go on; make a new simulation"):
                go_on()
        self.assertEqual((simulation.t, simulation.trajectory_hash), (at, trajectory))

    def test_the_set_of_closures(self):
        self.assertEqual(self.small().closures, "third set")
        self.assertRegex(self.small(overrides={"contact.fluid_share": 0.15}).closures, "^mixed: of the third set .*; of the second contact.fluid_share = 0.15$")
        self.assertEqual(matrigrate.Scenario().closures, "third set")

    def test_interruption_and_progress(self):
        simulation, told = self.small(), []
        threading.Timer(0.5, os.kill, (os.getpid(), signal.SIGINT)).start()
        with self.assertRaises(KeyboardInterrupt):
            simulation.advance(hours=100, progress=lambda s: told.append(s.t))
        self.assertEqual(told, sorted(told))
        self.assertGreater(len(told), 1)
        simulation.advance(until=simulation.t + 5)

    def test_other_threads_run_meanwhile(self):
        counted = 0
        simulation = self.small()
        worker = threading.Thread(target=lambda: simulation.advance(until=120))
        worker.start()
        while worker.is_alive():
            counted += 1
            time.sleep(0.001)
        self.assertGreater(counted, 20)

    def test_another_thread_counts_within_a_step(self):
        simulation = matrigrate.Simulation(overrides={"ecm.radius": "250 um"})
        simulation.step()
        shares = []
        while len(shares) < 50 and min(shares, default=1) >= 0.5:  # one will do: others may take the processor away
            began, times = threading.Event(), []

            def one_step(began=began):
                began.set()
                simulation.step()

            worker = threading.Thread(target=one_step)
            worker.start()
            began.wait()
            start = time.perf_counter()
            while worker.is_alive():
                times.append(time.perf_counter())
            longest_gap = np.diff([start, *times, time.perf_counter()]).max()
            shares.append(longest_gap / (time.perf_counter() - start))
        self.assertLess(min(shares), 0.5, "of a step in which the counting stood still")

    def test_no_leak(self):
        def use():
            simulation = self.small(overrides={"ecm.radius": "40 um"}, force=lambda s: None)
            simulation.advance(until=5)
            return simulation.cell.x

        for _ in range(5):
            use()
        before = resource.getrusage(resource.RUSAGE_SELF).ru_maxrss
        for _ in range(60):
            use()
        grown = resource.getrusage(resource.RUSAGE_SELF).ru_maxrss - before
        self.assertLess(grown, 20_000, "kB")


class Stub(unittest.TestCase):
    def test_names_are_those_of_the_module(self):
        text = (common.source / "python" / "matrigrate" / "_core.pyi").read_text(encoding="utf-8")
        told = {node.name: {member.name for member in node.body} - {"__init__"} for node in ast.parse(text).body if isinstance(node, ast.ClassDef)}
        core = matrigrate.simulation.core()
        self.assertEqual(told, {name: {member for member in vars(kind) if not member.startswith("_")}
                                for name, kind in vars(core).items() if isinstance(kind, type)})


class TestModule(common.InTemporaryFolder):
    def found(self, **named):
        environment = {key: value for key, value in os.environ.items() if key != "MATRIGRATE_CORE"} | named
        script = ("import sys; sys.path.insert(0, 'python'); import matrigrate\n"
                  "try: print(matrigrate.simulation.core().__file__)\nexcept matrigrate.CoreNotFound as error: print(error)")
        return subprocess.run([sys.executable, "-B", "-c", script], env=environment, capture_output=True, text=True, check=True).stdout.strip()

    def test_is_found_where_a_clone_builds_it(self):
        shutil.copytree(common.source / "python" / "matrigrate", "python/matrigrate", ignore=shutil.ignore_patterns("_core*.so", "__pycache__"))
        for tables in ("docs", "viewer"):
            os.symlink(common.source / tables, tables)
        self.assertIn("./demo builds the module", self.found())
        built = pathlib.Path("build/release/python")
        built.mkdir(parents=True)
        module = shutil.copy(matrigrate.simulation.core().__file__, built)
        self.assertEqual(pathlib.Path(self.found()), pathlib.Path(module).resolve())
        self.assertIn("has no compiled module", self.found(MATRIGRATE_CORE="/nowhere"))


def load_tests(_, tests, __):
    tests.addTests(doctest.DocTestSuite(matrigrate.simulation))
    return tests


if __name__ == "__main__":
    try:
        matrigrate.simulation.core()
    except matrigrate.CoreNotFound as error:
        print(f"skipped: {error}")
        raise SystemExit(77)
    unittest.main()
