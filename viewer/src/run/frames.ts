/** The stored frames, unpacked, and the place of a time among them. */
import type { FibreData, FrameProtrusion, LayerWords, RunPage } from "../contract";
import { type Field, unpack, valueAt } from "../embedded";
import type { Box } from "./camera";
import { cellParts, type CellPart } from "./cells";

export interface Film {
  times: number[];
  reference: Field;
  x: Field;
  f: Field;
  pressure: Field;
  vonMises: Field;
  fibreVonMises: Field | null;
  attractant: Field | null;
  /** Properties that vary from place to place and not in time. */
  layers: (LayerWords & { field: Field })[];
  /** null: none, or a page of an earlier version. */
  fibres: Fibres | null;
  /** Places of the particles of rigid obstacles [um]. */
  obstacles: [number, number][];
  outline: { x: Field; front: Field; protrusion: Field; fMat: Field; force: Field };
  /** Particles of the nuclei, as many of each cell; null: cells have none. */
  nucleus: Field | null;
  protrusions: FrameProtrusion[][];
  /** Frames are replaced while it is looked at. */
  growing?: boolean;
  particles: number;
  outlinePoints: number;
  /** Which of them belong to which cell. */
  cells: CellPart[];
}

/** Below this f_degr a particle counts as fluid where only the solid has a value. */
export const solidFrom = 0.05;

/** Between frame `frame` and the next one, `fraction` of the way. */
export interface Place {
  frame: number;
  next: number;
  fraction: number;
}

/** What all of them promise. */
const all = async <T extends object>(of: T): Promise<{ [K in keyof T]: Awaited<T[K]> }> =>
  Object.fromEntries(await Promise.all(Object.entries(of).map(async ([name, one]) => [name, await one])));

export async function film(run: RunPage): Promise<Film | null> {
  const { frames } = run;
  if (!frames || frames.times_s.length === 0) return null;
  const n = frames.times_s.length;
  const { particles: p, outline: o, protrusions } = frames;
  const layer = async ({ values, ...words }: NonNullable<typeof p.layers>[number]) => ({ ...words, field: await unpack(values, words.title, n) });
  const particles = await all({
    reference: unpack(frames.reference, "reference positions", 1),
    x: unpack(p.x, "particle positions", n),
    f: unpack(p.f, "intact matrix", n),
    pressure: unpack(p.pressure, "pressure", n),
    vonMises: unpack(p.von_mises, "von Mises stress", n),
    fibreVonMises: p.fibre_von_mises ? unpack(p.fibre_von_mises, "von Mises stress of the fibres", n) : null,
    attractant: p.attractant ? unpack(p.attractant, "attractant", n) : null,
    nucleus: o.nucleus ? unpack(o.nucleus, "nucleus", n) : null,
    layers: Promise.all((p.layers ?? []).map(layer)),
  });
  const outline = await all({
    x: unpack(o.x, "outline", n),
    front: unpack(o.front, "front", n),
    protrusion: unpack(o.protrusion, "protrusion of the outline", n),
    fMat: unpack(o.f_mat, "maturation of the outline", n),
    force: unpack(o.force, "force on the outline", n),
  });
  if (protrusions.length !== n) throw new Error(`protrusions of ${protrusions.length} frames instead of ${n}`);
  return {
    ...particles,
    times: frames.times_s,
    fibres: frames.fibres && frames.fibres.bonds_um.length > 0 ? fibresOf(frames.fibres, particles.reference) : null,
    obstacles: frames.obstacles_um ?? [],
    outline,
    protrusions,
    particles: frames.reference.per_frame,
    outlinePoints: o.x.per_frame,
    cells: cellParts(o.x.per_frame, o.cell),
  };
}

export function placeAt(times: number[], t: number): Place {
  const last = times.length - 1;
  let low = 0;
  let high = last;
  while (high - low > 1) {
    const middle = (low + high) >> 1;
    if (times[middle] <= t) low = middle;
    else high = middle;
  }
  if (last === 0 || t <= times[0]) return { frame: 0, next: 0, fraction: 0 };
  if (t >= times[last]) return { frame: last, next: last, fraction: 0 };
  return { frame: low, next: high, fraction: (t - times[low]) / (times[high] - times[low]) };
}

/** A number of an entry at a place, linear between the frames. */
export function between(field: Field, place: Place, index: number): number {
  const a = valueAt(field, place.frame, index);
  return place.fraction === 0 ? a : a + place.fraction * (valueAt(field, place.next, index) - a);
}

/** Outline at a place, as x0, y0, x1, y1, ... [um]. */
export function outlineAt(film: Film, place: Place): Float32Array {
  const out = new Float32Array(2 * film.outlinePoints);
  for (let i = 0; i < out.length; ++i) out[i] = between(film.outline.x, place, i);
  return out;
}

/** Four frames, or fewer of a short film, by which a whole film is judged. */
export const fewFrames = ({ times }: Film): Set<number> =>
  new Set([0.25, 0.5, 0.75, 1].map((share) => Math.round(share * (times.length - 1))));

/** Displacement that all but one in a thousand stay under, so that a few particles do not take the whole colour bar [um]. */
export function usualDisplacement(film: Film): number {
  const sizes: number[] = [];
  for (const frame of fewFrames(film))
    for (let i = 0; i < film.particles; ++i) {
      if (valueAt(film.f, frame, i) < 0.5) continue;
      const dx = valueAt(film.x, frame, 2 * i) - valueAt(film.reference, 0, 2 * i);
      const dy = valueAt(film.x, frame, 2 * i + 1) - valueAt(film.reference, 0, 2 * i + 1);
      sizes.push(Math.hypot(dx, dy));
    }
  sizes.sort((a, b) => a - b);
  const usual = sizes[Math.floor((sizes.length - 1) * 0.999)] ?? 0;
  return usual > 0 ? Number(usual.toPrecision(2)) : 1;
}

/** Where the cell is at any stored time, with a margin: the first view. */
export function visitedBox(film: Film): Box {
  const margin = 12;
  let [left, right, bottom, top] = [Infinity, -Infinity, Infinity, -Infinity];
  for (let frame = 0; frame < film.times.length; ++frame)
    for (let i = 0; i < film.outlinePoints; ++i) {
      const [x, y] = [valueAt(film.outline.x, frame, 2 * i), valueAt(film.outline.x, frame, 2 * i + 1)];
      [left, right] = [Math.min(left, x - margin), Math.max(right, x + margin)];
      [bottom, top] = [Math.min(bottom, y - margin), Math.max(top, y + margin)];
    }
  return { left, right, bottom, top };
}

// Fibres from the bonds of the lattice: which particles each of them joins. They are the same at all times.

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
function distinct(bonds: [number, number][]): [number, number][] {
  const along = (a: readonly number[], b: readonly number[]) =>
    Math.abs(a[0] * b[1] - a[1] * b[0]) < 1e-3 * Math.hypot(...a) * Math.hypot(...b);
  return bonds.filter((b) => !bonds.some((a) => along(a, b) && Math.hypot(...a) < Math.hypot(...b) - 1e-3));
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
