"""A simulation that is stepped from Python."""
import gc
import os
import resource
import signal
import threading
import time
import unittest

import numpy as np

import common
import matrigrate

SMALL = {"ecm.radius": "60 um", "run.integrator": "adaptive", "run.time_step": "5 s"}


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
        with self.assertRaises(TypeError):
            matrigrate.Simulation(3.0)
        with self.assertRaises(IndexError):
            simulation._core.cell_x(1)

    def test_wrong_scenarios(self):
        with self.assertRaises(matrigrate.ConfigurationError) as caught:
            self.small(overrides={"ecm.youngs_modulus": "-1 Pa", "ecm.radiu": 3})
        self.assertEqual(sorted(f.key for f in caught.exception.faults), ["ecm.radiu", "ecm.youngs_modulus"])
        with self.assertRaises(FileNotFoundError):
            matrigrate.Simulation("none.toml")
        broken = self.small(overrides={"run.integrator": "reference", "run.time_step": "0.4 s"},
                            force=lambda s: np.full(s.matrix.x.shape, 1e6))
        with self.assertRaises(matrigrate.NumericalError):
            broken.advance(until=10)

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


if __name__ == "__main__":
    try:
        matrigrate.simulation.core()
    except matrigrate.CoreNotFound as error:
        print(f"skipped: {error}")
        raise SystemExit(77)
    unittest.main()
