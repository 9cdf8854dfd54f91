#!/usr/bin/env python3
"""The displacement around a point force in a graded gel, by finite elements: makes docs/validation/graded-point-force.csv.

A disc of plane strain, clamped at its rim, with E = 200 (1 + 0.6 tanh(x/20 um)) Pa and nu = 0.45, under a force of 0.06 nN
per um of thickness at its centre, along x and along y. Quadratic triangles on rings that get finer towards the force; solved by
CalculiX (Debian package calculix-ccx), which takes E at each node as a temperature. tests/physics/graded_test.cpp compares the
particles with the table.

    tools/graded_reference.py [FILE.csv] [--coarse]    # --coarse: a mesh twice as coarse, to see what the mesh does
"""

import subprocess
import sys
import tempfile
from pathlib import Path

import numpy as np
from scipy.spatial import Delaunay

RADIUS = 75.8  # um: that of the particles' disc of 80 um, less the clamped rim of 2h, plus half a spacing
NU = 0.45
FORCE = 0.06  # nN
PLACES = [(sx * d, sy * d) for d in (12.0, 16.0, 20.0, 24.0, 30.0, 36.0) for sx, sy in ((1, 0), (0, 1), (-1, 0), (0, -1))] + [
    (sx * d, sy * d) for d in (8.0, 12.0, 16.0, 20.0, 26.0) for sx in (1, -1) for sy in (1, -1)
]  # um; all are particles of the square lattice


def modulus(x):
    """Young's modulus [kPa]."""
    return 0.2 * (1.0 + 0.6 * np.tanh(x / 20.0))


def triangles(coarse):
    """Corners of the mesh [um] and its triangles."""
    factor = 2.0 if coarse else 1.0
    radii, r = [], 0.0
    while r < RADIUS:
        r += factor * (0.25 + 0.03 * r)
        radii.append(min(r, RADIUS))
    if radii[-1] - radii[-2] < 0.3 * (radii[-2] - radii[-3]):
        del radii[-2]
    points = [(0.0, 0.0)]
    for k, radius in enumerate(radii):
        n = max(6, int(round(2 * np.pi * radius / (factor * (0.25 + 0.03 * radius)))))
        angles = 2 * np.pi * (np.arange(n) + 0.5 * (k % 2)) / n
        points += [(radius * np.cos(a), radius * np.sin(a)) for a in angles]
    points = np.array(points)
    far = np.min(np.hypot(points[:, None, 0] - np.array(PLACES)[:, 0], points[:, None, 1] - np.array(PLACES)[:, 1]), axis=1)
    points = np.vstack([points[far > 0.2 * factor], PLACES])  # none closer to a place than a node should be
    return points, Delaunay(points).simplices


def quadratic(points, corners):
    """Adds the middles of all edges. Returns nodes, and elements of six nodes with corners counter-clockwise."""
    nodes, middle, elements = [tuple(p) for p in points], {}, []
    for a, b, c in corners:
        (x1, y1), (x2, y2), (x3, y3) = points[a], points[b], points[c]
        area = (x2 - x1) * (y3 - y1) - (x3 - x1) * (y2 - y1)
        if abs(area) < 1e-9:
            continue
        if area < 0:
            b, c = c, b
        element = [a, b, c]
        for i, j in ((a, b), (b, c), (c, a)):
            key = (min(i, j), max(i, j))
            if key not in middle:
                middle[key] = len(nodes)
                nodes.append(tuple(0.5 * (points[i] + points[j])))
            element.append(middle[key])
        elements.append(element)
    return np.array(nodes), elements


def deck(nodes, elements, direction):
    """The input of CalculiX. Units um, nN, kPa."""
    lines = ["*NODE, NSET=ALL"]
    lines += [f"{i + 1}, {x:.9g}, {y:.9g}, 0." for i, (x, y) in enumerate(nodes)]
    lines.append("*ELEMENT, TYPE=CPE6, ELSET=GEL")
    lines += [", ".join(str(v) for v in [k + 1] + [n + 1 for n in e]) for k, e in enumerate(elements)]
    lines.append("*NSET, NSET=RIM")
    lines += [f"{i + 1}," for i in np.flatnonzero(np.hypot(*nodes.T) > RADIUS * 0.998)]
    lines += ["*MATERIAL, NAME=GRADED", "*ELASTIC"]
    lines += [f"{E:.9g}, {NU}, {1000 * E:.9g}" for E in np.linspace(0.02, 0.4, 20)]  # temperature: E [Pa]
    lines += ["*SOLID SECTION, ELSET=GEL, MATERIAL=GRADED", "1."]
    lines += ["*INITIAL CONDITIONS, TYPE=TEMPERATURE"]
    lines += [f"{i + 1}, {1000 * modulus(x):.9g}" for i, (x, _) in enumerate(nodes)]
    lines += ["*BOUNDARY", "RIM, 1, 2", "*STEP", "*STATIC", "*CLOAD", f"1, {direction + 1}, {FORCE}"]
    lines += ["*NODE PRINT, NSET=ALL", "U", "*END STEP", ""]
    return "\n".join(lines)


def displacements(nodes, elements, direction):
    with tempfile.TemporaryDirectory() as folder:
        (Path(folder) / "gel.inp").write_text(deck(nodes, elements, direction))
        subprocess.run(["ccx", "gel"], cwd=folder, check=True, stdout=subprocess.DEVNULL)
        u = np.zeros((len(nodes), 2))
        for line in (Path(folder) / "gel.dat").read_text().splitlines():
            words = line.split()
            if len(words) == 4 and words[0].isdigit() and int(words[0]) <= len(nodes):
                u[int(words[0]) - 1] = [float(words[1]), float(words[2])]
        return u


def main():
    arguments = [a for a in sys.argv[1:] if a != "--coarse"]
    target = Path(arguments[0]) if arguments else Path(__file__).parents[1] / "docs/validation/graded-point-force.csv"
    points, corners = triangles("--coarse" in sys.argv)
    nodes, elements = quadratic(points, corners)
    rows = ["force,x_um,y_um,u_x_um,u_y_um"]
    for direction, name in enumerate("xy"):
        u = displacements(nodes, elements, direction)
        for x, y in PLACES:
            i = int(np.argmin(np.hypot(nodes[:, 0] - x, nodes[:, 1] - y)))
            rows.append(f"{name},{x:g},{y:g},{u[i, 0]:.6g},{u[i, 1]:.6g}")
    target.write_text("\n".join(rows) + "\n")
    print(f"{len(nodes)} nodes, {len(elements)} elements: {target}")


if __name__ == "__main__":
    main()
