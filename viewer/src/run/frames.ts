/** The stored frames, unpacked, and the place of a time among them. */
import type { FrameProtrusion, Frames, LayerWords, RunPage } from "../contract";
import { type Field, unpack, valueAt } from "../embedded";
import { fibresOf, type Fibres } from "./bonds";
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

export async function film(run: RunPage): Promise<Film | null> {
  const frames: Frames | null | undefined = run.frames;
  if (!frames || frames.times_s.length === 0) return null;
  const n = frames.times_s.length;
  const { particles: p, outline: o } = frames;
  const [reference, x, f, pressure, vonMises, fibreVonMises, attractant, layers] = await Promise.all([
    unpack(frames.reference, "reference positions", 1),
    unpack(p.x, "particle positions", n),
    unpack(p.f, "intact matrix", n),
    unpack(p.pressure, "pressure", n),
    unpack(p.von_mises, "von Mises stress", n),
    p.fibre_von_mises ? unpack(p.fibre_von_mises, "von Mises stress of the fibres", n) : null,
    p.attractant ? unpack(p.attractant, "attractant", n) : null,
    Promise.all((p.layers ?? []).map(async ({ values, ...words }) => ({ ...words, field: await unpack(values, words.title, n) }))),
  ]);
  const [ox, front, protrusion, fMat, force, nucleus] = await Promise.all([
    unpack(o.x, "outline", n),
    unpack(o.front, "front", n),
    unpack(o.protrusion, "protrusion of the outline", n),
    unpack(o.f_mat, "maturation of the outline", n),
    unpack(o.force, "force on the outline", n),
    o.nucleus ? unpack(o.nucleus, "nucleus", n) : null,
  ]);
  if (frames.protrusions.length !== n)
    throw new Error(`protrusions of ${frames.protrusions.length} frames instead of ${n}`);
  return {
    times: frames.times_s,
    reference,
    x,
    f,
    pressure,
    vonMises,
    fibreVonMises,
    attractant,
    layers,
    fibres: frames.fibres && frames.fibres.bonds_um.length > 0 ? fibresOf(frames.fibres, reference) : null,
    obstacles: frames.obstacles_um ?? [],
    outline: { x: ox, front, protrusion, fMat, force },
    nucleus,
    protrusions: frames.protrusions,
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

/** Displacement that all but one in a thousand stay under, so that a few particles do not take the whole colour bar [um]. */
export function usualDisplacement(film: Film): number {
  const sizes: number[] = [];
  const frames = [...new Set([0.25, 0.5, 0.75, 1].map((share) => Math.round(share * (film.times.length - 1))))];
  for (const frame of frames)
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
  const box = { left: Infinity, right: -Infinity, bottom: Infinity, top: -Infinity };
  for (let frame = 0; frame < film.times.length; ++frame)
    for (let i = 0; i < film.outlinePoints; ++i) {
      const [x, y] = [valueAt(film.outline.x, frame, 2 * i), valueAt(film.outline.x, frame, 2 * i + 1)];
      box.left = Math.min(box.left, x);
      box.right = Math.max(box.right, x);
      box.bottom = Math.min(box.bottom, y);
      box.top = Math.max(box.top, y);
    }
  const margin = 12;
  return { left: box.left - margin, right: box.right + margin, bottom: box.bottom - margin, top: box.top + margin };
}
