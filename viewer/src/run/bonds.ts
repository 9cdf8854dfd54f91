/** Fibres from the bonds of the lattice: which particles each of them joins. They are the same at all times. */
import type { FibreData } from "../contract";
import { type Field, valueAt } from "../embedded";

export interface Fibres {
  /** Particles at both ends of each fibre. */
  ends: Uint32Array;
  /** At rest [um]. */
  length: Float32Array;
  /** Fibres per particle; each fibre is counted at one of its ends. */
  bonds: number;
  /** Strain from which on they stiffen. */
  onset: number;
}

/** Bonds without those that lie along a shorter one, which would be drawn over it. */
function distinct(bonds: readonly (readonly [number, number])[]): [number, number][] {
  const along = (a: readonly number[], b: readonly number[]) =>
    Math.abs(a[0] * b[1] - a[1] * b[0]) < 1e-3 * Math.hypot(...a) * Math.hypot(...b);
  return bonds
    .filter((b) => !bonds.some((a) => along(a, b) && Math.hypot(...a) < Math.hypot(...b) - 1e-3))
    .map(([x, y]) => [x, y]);
}

/** Finds the particles at both ends of each fibre. */
export function fibresOf(data: FibreData, reference: Field): Fibres {
  const bonds = distinct(data.bonds_um);
  const n = reference.stride / 2;
  const X = (i: number) => valueAt(reference, 0, 2 * i);
  const Y = (i: number) => valueAt(reference, 0, 2 * i + 1);
  // A grid whose cells hold one particle at most.
  const side = 0.5 * Math.min(...bonds.map((b) => Math.hypot(...b)));
  let [left, bottom, right, top] = [Infinity, Infinity, -Infinity, -Infinity];
  for (let i = 0; i < n; ++i) {
    [left, right] = [Math.min(left, X(i)), Math.max(right, X(i))];
    [bottom, top] = [Math.min(bottom, Y(i)), Math.max(top, Y(i))];
  }
  const [columns, rows] = [Math.floor((right - left) / side) + 1, Math.floor((top - bottom) / side) + 1];
  const column = (x: number) => Math.floor((x - left) / side);
  const row = (y: number) => Math.floor((y - bottom) / side);
  const grid = new Int32Array(columns * rows).fill(-1);
  for (let i = 0; i < n; ++i) grid[row(Y(i)) * columns + column(X(i))] = i;
  const at = (x: number, y: number): number => {
    for (let r = Math.max(0, row(y) - 1); r <= Math.min(rows - 1, row(y) + 1); ++r)
      for (let c = Math.max(0, column(x) - 1); c <= Math.min(columns - 1, column(x) + 1); ++c) {
        const i = grid[r * columns + c];
        if (i >= 0 && Math.hypot(X(i) - x, Y(i) - y) < 0.2 * side) return i;
      }
    return -1;
  };
  const [ends, length]: [number[], number[]] = [[], []];
  for (let i = 0; i < n; ++i)
    for (const [dx, dy] of bonds) {
      const j = at(X(i) + dx, Y(i) + dy);
      if (j < 0) continue;
      ends.push(i, j);
      length.push(Math.hypot(dx, dy));
    }
  return { ends: Uint32Array.from(ends), length: Float32Array.from(length), bonds: bonds.length, onset: data.onset };
}
