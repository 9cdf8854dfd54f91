#!/usr/bin/env python3
"""What matrigrate.Simulation costs: forces and a cue of NumPy over steps of the baseline, and memory over many simulations.

    MATRIGRATE_CORE=build/release/python/_core.<...>.so PYTHONPATH=python tests/long/python_costs.py [--steps 400] [--simulations 1000]

Steps of two simulations, one without functions and one with, are taken in turns of ten and timed by the CPU time of the process, so that
other work on the machine matters little. Fails where a force costs 20 % of a step or more, or where memory grows.
"""
import argparse
import gc
import os
import statistics
import sys
import time

import matrigrate
import numpy as np

TURN = 10
FULL = {"run.integrator": "reference", "run.threads": 1}  # the paper's baseline: radius 150 um, steps of 0.4 s
SHORT = {"ecm.radius": "40 um", "run.integrator": "adaptive"}


class Trap:
    """An optical trap on the matrix: a spring to the reference positions that fades over 20 um around (30, 0) um [nN]."""

    stiffness = None

    def __call__(self, simulation):
        matrix = simulation.matrix
        if self.stiffness is None:  # does not change
            self.stiffness = 1e-4 * np.exp(-((matrix.X - (30.0, 0.0))**2).sum(axis=1, keepdims=True) / 800.0)
        return self.stiffness * (matrix.X - matrix.x)


def moving_trap(simulation):
    """The same trap, on its way at 1 um/min, so that all of it is computed in each step."""
    matrix, centre = simulation.matrix, 30.0 + simulation.t / 60.0
    dx, dy = matrix.X[:, 0] - centre, matrix.X[:, 1]
    return (1e-4 * np.exp(-(dx * dx + dy * dy) / 800.0))[:, None] * (matrix.X - matrix.x)


def wind(simulation):
    """A constant force on the cortex [nN]."""
    return np.tile([1e-4, 0.0], (len(simulation.cell.x), 1))


def source(simulation, cell):
    """A source of an attractant at (60, 0) um."""
    to_source = np.array([60.0, 0.0]) - cell.x
    return np.exp((cell.normals * to_source).sum(axis=1) / np.linalg.norm(to_source, axis=1))


def turn(simulation):
    """CPU time of a few steps [s]."""
    start = time.process_time()
    for _ in range(TURN):
        simulation.step()
    return time.process_time() - start


def cost(steps, **functions):
    """CPU time of a step without and with functions [s]: medians over turns."""
    plain = matrigrate.Simulation(overrides=FULL, seed=1)
    with_functions = matrigrate.Simulation(overrides=FULL, seed=1, **functions)
    for simulation in (plain, with_functions):
        turn(simulation)
    turns = [(turn(plain), turn(with_functions)) for _ in range(steps // TURN)]
    return [statistics.median(column) / TURN for column in zip(*turns, strict=True)], len(plain.matrix)


def resident():
    """Resident memory [MB]."""
    gc.collect()
    with open("/proc/self/statm", encoding="ascii") as file:
        return int(file.read().split()[1]) * os.sysconf("SC_PAGE_SIZE") / 1e6


def short_simulation(k):
    """A minute with a force, a cue, views that outlive the simulation, and in every tenth an exception."""
    def force(simulation):
        if k % 10 == 0 and simulation.t > 20:
            raise ZeroDivisionError
        return moving_trap(simulation)

    simulation = matrigrate.Simulation(overrides=SHORT, seed=k, force=force, cell_force=wind, cue=source)
    try:
        simulation.advance(until=60)
    except ZeroDivisionError:
        pass
    return simulation.cell.x, simulation.matrix.deviatoric_stress, simulation.cell.protrusions, simulation.trajectory_hash


def main():
    options = argparse.ArgumentParser()
    options.add_argument("--steps", type=int, default=400)
    options.add_argument("--simulations", type=int, default=1000)
    chosen, failed = options.parse_args(), False
    for name, functions in (("force on the matrix", {"force": Trap()}), ("force that moves", {"force": moving_trap}),
                            ("force on the cortex", {"cell_force": wind}), ("cue", {"cue": source}),
                            ("all", {"force": Trap(), "cell_force": wind, "cue": source})):
        (without, with_functions), particles = cost(chosen.steps, **functions)
        share = with_functions / without - 1.0
        failed |= name.startswith("force") and share >= 0.2
        print(f"{name}: {1e3 * without:.2f} ms a step without, {1e3 * with_functions:.2f} ms with: {share:+.1%} "
              f"({particles} particles of matrix, {chosen.steps} steps)", flush=True)
    kept = []
    for k in range(chosen.simulations):
        kept = [short_simulation(k)]
        if k + 1 == chosen.simulations // 10:
            early = resident()
    late = resident()
    failed |= late - early > 10.0
    print(f"resident memory after {chosen.simulations // 10} simulations {early:.1f} MB, after {chosen.simulations} {late:.1f} MB")
    return 1 if failed or not kept else 0


if __name__ == "__main__":
    sys.exit(main())
