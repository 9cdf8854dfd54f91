/** A made-up run of several cells: copies of one, each moved elsewhere. */
import type { Packed, RunPage, Tracks } from "../src/contract";
import { unpack, valueAt } from "../src/embedded";
import { pack } from "./pack";

/** The frames of a packed array, each as many times one after the other as there are shifts, moved by them. */
async function repeated(packed: Packed, frames: number, shifts: [number, number][]): Promise<Packed> {
  const field = await unpack(packed, "outline", frames);
  const all = Array.from({ length: frames }, (_, k) =>
    Float64Array.from({ length: shifts.length * field.stride }, (_unused, i) => {
      const shift = packed.components === 2 ? shifts[Math.floor(i / field.stride)][i % 2] : 0;
      return valueAt(field, k, i % field.stride) + shift;
    }),
  );
  return pack(all, packed);
}

/** @param shifts  of the cells [um] */
export async function groupOf(run: RunPage, shifts: [number, number][]): Promise<RunPage> {
  const numbers = shifts.map((_, k) => k + 1);
  const { tracks, protrusions, readouts } = run;
  const moved = shifts.map(([x, y], k) => ({
    ...tracks,
    cell: tracks.t_s.map(() => k + 1),
    x_um: tracks.x_um.map((v) => v + x),
    y_um: tracks.y_um.map((v) => v + y),
  }));
  const joined = Object.fromEntries(
    Object.keys(moved[0]).map((name) => [name, moved.flatMap((one) => one[name as keyof Tracks] as number[])]),
  ) as unknown as Tracks;
  const frames = run.frames ?? null;
  const n = run.geometry.n_outline;
  if (frames) {
    const count = frames.times_s.length;
    const { outline } = frames;
    frames.outline = {
      cell: numbers.flatMap((number) => Array.from({ length: n }, () => number)),
      x: await repeated(outline.x, count, shifts),
      front: await repeated(outline.front, count, shifts),
      protrusion: await repeated(outline.protrusion, count, shifts),
      f_mat: await repeated(outline.f_mat, count, shifts),
      force: await repeated(outline.force, count, shifts),
    };
    // Protrusions of the first cell alone: indices on the outline count over all cells.
    frames.protrusions = frames.protrusions.map((alive) => alive.map((p) => ({ ...p, cell: 1 })));
  }
  return {
    ...run,
    frames,
    geometry: { ...run.geometry, n_outline: n * shifts.length },
    tracks: joined,
    protrusions: numbers.flatMap((cell) => protrusions.map((row) => ({ ...row, cell }))),
    readouts: numbers.flatMap((cell) => readouts.map((value) => ({ ...value, cell }))),
  };
}
