/**
 * A layer interpolated between the particles, so that it is seen as the field it is:
 *   value(x) = sum_i w_i v_i / sum_i w_i,   w_i = B(x - x_i) B(y - y_i),
 * B the quadratic B-spline as wide as the spacing of the particles (support 1.5 spacings to each side). It needs no lattice,
 * so it also holds where degraded matrix flows. The sums are formed at the nodes of a grid over what is seen; between
 * nodes they are bilinear. Where a layer has values in the solid alone, only the solid adds to the value. Where a layer
 * jumps, as from fluid to solid, the jump is a contour of value(x); on each side of it only particles of that side add.
 */
import { between, solidFrom, type Film, type Place } from "../frames";
import type { Camera } from "../camera";
import type { Layer } from "./layers";

/**
 * Per node: sum of w v, sum of w, both over particles that have a value and are above the contour, where the layer has
 * one; sum of w over all; sum of w v over all of a layer with a contour.
 */
export const channels = 4;

export interface Patch {
  columns: number;
  rows: number;
  /** Place of the first node, and distance of nodes [um]. */
  left: number;
  bottom: number;
  step: number;
  sums: Float32Array;
  /** See Layer. */
  contour?: number;
}

/** Sum of w below which there is no matrix (an intact lattice has 1), and from which there is. */
export const coverage = [0.05, 0.12] as const;
/** Share of particles with a value below which an area is drawn as fluid, and from which as solid. */
export const solidShare = [0.4, 0.6] as const;
/** Values between which one side of a contour goes over into the other. */
export const contourEnds = (contour: number): [number, number] => [contour - 0.1, contour + 0.1];
/** Share of the particles at a point that a side needs to have a value of its own there. */
export const leastShare = 1e-4;

const support = 1.5;
const weight = (r: number): number => {
  const a = Math.abs(r);
  return a < 0.5 ? 0.75 - a * a : a < support ? 0.5 * (support - a) ** 2 : 0;
};

/** The weight of a particle at nodes `first` and on, into `out`; returns how many. `at`: in steps from the first node. */
function weigh(out: Float64Array, at: number, first: number, last: number, stepsPerSpacing: number): number {
  for (let i = first; i <= last; ++i) out[i - first] = weight((i - at) / stepsPerSpacing);
  return last - first + 1;
}

/** Value of a layer at a particle that is at (x, y). */
export function particleValue(film: Film, layer: Layer, place: Place, i: number, x: number, y: number): number {
  if (layer.field) return between(layer.field, place, i);
  const { q, scale, offset } = film.reference;
  return Math.hypot(x - offset - scale * q[2 * i], y - offset - scale * q[2 * i + 1]);
}

/** Value at the particle that covers a point [um]; null and NaN as `valueOn`. */
export function valueOfNearest(film: Film, layer: Layer, place: Place, x: number, y: number, spacing: number): number | null {
  let [found, least] = [-1, spacing];
  for (let i = 0; i < film.particles; ++i) {
    const away = Math.hypot(between(film.x, place, 2 * i) - x, between(film.x, place, 2 * i + 1) - y);
    if (away < least) [found, least] = [i, away];
  }
  if (found < 0) return null;
  if (layer.solidOnly && between(film.f, place, found) < solidFrom) return NaN;
  return particleValue(film, layer, place, found, between(film.x, place, 2 * found), between(film.x, place, 2 * found + 1));
}

/** So many zeros, in the memory of `spare` where it is large enough; a little more than needed, since views change by a node. */
function zeros(count: number, spare?: Float32Array): Float32Array {
  const bytes = 4 * count;
  const memory = spare && spare.buffer.byteLength >= bytes ? spare.buffer : new ArrayBuffer(Math.ceil(1.1 * count) * 4);
  return new Float32Array(memory, 0, count).fill(0);
}

const [wx, wy] = [new Float64Array(8), new Float64Array(8)];

/** @param spare  the sums of a patch that is no longer needed: their memory is used again where it is large enough */
export function resample(film: Film, layer: Layer, place: Place, camera: Camera, spacing: number, spare?: Float32Array): Patch {
  // Far out, nodes as far apart as particles are close enough on the screen.
  const step = spacing * camera.scale < 5 ? spacing : 0.5 * spacing;
  const [halfWidth, halfHeight] = [(0.5 * camera.width) / camera.scale, (0.5 * camera.height) / camera.scale];
  // At multiples of the step, so that the picture does not shimmer when the camera moves.
  const left = step * (Math.floor((camera.x - halfWidth) / step) - 1);
  const bottom = step * (Math.floor((camera.y - halfHeight) / step) - 1);
  const columns = Math.ceil((camera.x + halfWidth - left) / step) + 2;
  const rows = Math.ceil((camera.y + halfHeight - bottom) / step) + 2;
  const sums = zeros(channels * columns * rows, spare);
  const stepsPerSpacing = spacing / step;
  const reach = support * stepsPerSpacing;
  const { q, scale, offset, stride } = film.x;
  const contour = layer.contour ?? -Infinity;
  const [base, ahead] = [place.frame * stride, place.next * stride];
  for (let i = 0; i < film.particles; ++i) {
    const a = base + 2 * i;
    const b = ahead + 2 * i;
    const x = offset + scale * (q[a] + place.fraction * (q[b] - q[a]));
    const atX = (x - left) / step;
    if (atX < -reach || atX > columns - 1 + reach) continue;
    const y = offset + scale * (q[a + 1] + place.fraction * (q[b + 1] - q[a + 1]));
    const atY = (y - bottom) / step;
    if (atY < -reach || atY > rows - 1 + reach) continue;
    const known = !layer.solidOnly || between(film.f, place, i) >= solidFrom;
    const value = known ? particleValue(film, layer, place, i, x, y) : 0;
    const has = known && value >= contour;
    const i0 = Math.max(0, Math.ceil(atX - reach));
    const j0 = Math.max(0, Math.ceil(atY - reach));
    const nx = weigh(wx, atX, i0, Math.min(columns - 1, Math.floor(atX + reach)), stepsPerSpacing);
    const ny = weigh(wy, atY, j0, Math.min(rows - 1, Math.floor(atY + reach)), stepsPerSpacing);
    for (let j = 0; j < ny; ++j) {
      let k = channels * ((j0 + j) * columns + i0);
      for (let n = 0; n < nx; ++n, k += channels) {
        const w = wx[n] * wy[j];
        sums[k + 2] += w;
        sums[k + 3] += w * value;
        if (!has) continue;
        sums[k] += w * value;
        sums[k + 1] += w;
      }
    }
  }
  return { columns, rows, left, bottom, step, sums, contour: layer.contour };
}

/** The value of a patch at a point [um]: null without matrix, NaN in fluid that has no value. */
export function valueOn(patch: Patch, x: number, y: number): number | null {
  const [gx, gy] = [(x - patch.left) / patch.step, (y - patch.bottom) / patch.step];
  const [i, j] = [Math.floor(gx), Math.floor(gy)];
  if (i < 0 || j < 0 || i >= patch.columns - 1 || j >= patch.rows - 1) return null;
  const [fx, fy] = [gx - i, gy - j];
  const sum = (channel: number): number => {
    const k = channels * (j * patch.columns + i) + channel;
    const up = k + channels * patch.columns;
    const { sums } = patch;
    const below = sums[k] + fx * (sums[k + channels] - sums[k]);
    return below + fy * (sums[up] + fx * (sums[up + channels] - sums[up]) - below);
  };
  const all = sum(2);
  if (all < coverage[0]) return null;
  const solid = sum(1);
  if (patch.contour !== undefined) {
    const value = sum(3) / all;
    const [own, part] = value < patch.contour ? [sum(3) - sum(0), all - solid] : [sum(0), solid];
    return part < leastShare * all ? value : own / part;
  }
  return solid < 0.5 * (solidShare[0] + solidShare[1]) * all ? NaN : sum(0) / solid;
}
