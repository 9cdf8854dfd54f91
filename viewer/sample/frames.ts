/** Frames that follow given tracks and protrusions: a plausible film, drawn and not simulated. */
import type { FrameProtrusion, Frames, PhaseNumber, ProtrusionRow, Tracks } from "../src/contract";
import { outlinePoints as n } from "./life";
import { pack, random } from "./pack";

export interface FilmOptions {
  radius: number;
  spacing: number;
  interval: number;
  fibres: boolean;
  /** Random shifts of particles [um], so that the data compress no better than real ones. */
  noise: number;
}

type Point = [number, number];

function lattice(radius: number, spacing: number): Float64Array {
  const out: number[] = [];
  const k = Math.floor(radius / spacing);
  for (let j = -k; j <= k; ++j)
    for (let i = -k; i <= k; ++i) if (Math.hypot(i, j) * spacing <= radius) out.push(i * spacing, j * spacing);
  return Float64Array.from(out);
}

interface Arm {
  row: ProtrusionRow;
  phase: PhaseNumber;
  tip: Point;
  anchored: boolean;
}

const interpolated = (tracks: Tracks, column: number[], t: number): number => {
  const i = Math.min(
    column.length - 2,
    Math.max(
      0,
      tracks.t_s.findLastIndex((v) => v <= t),
    ),
  );
  const share = Math.min(1, (t - tracks.t_s[i]) / (tracks.t_s[i + 1] - tracks.t_s[i]));
  return column[i] + share * (column[i + 1] - column[i]);
};

function arms(rows: ProtrusionRow[], tracks: Tracks, t: number): Arm[] {
  const out: Arm[] = [];
  for (const row of rows) {
    if (t < row.t_initiation_s || t > (row.t_end_s ?? Infinity)) continue;
    const angle = (2 * Math.PI * row.centre_particle) / n + 0.4 * Math.sin(row.id);
    const at = (time: number): Point => [
      interpolated(tracks, tracks.x_um, time),
      interpolated(tracks, tracks.y_um, time),
    ];
    const adhered = row.t_adhesion_s ?? Infinity;
    const gone = row.t_disassembly_s ?? Infinity;
    const full = 15 + (row.length_um ?? 28);
    const from = at(Math.min(t, adhered));
    const grown = Math.min(1, (t - row.t_initiation_s) / 400);
    const reach = 15 + (full - 15) * grown;
    let tip: Point = [from[0] + reach * Math.cos(angle), from[1] + reach * Math.sin(angle)];
    if (t >= gone) {
      const now = at(t);
      const left = Math.max(0, 1 - (t - gone) / 400);
      const base: Point = [now[0] + 15 * Math.cos(angle), now[1] + 15 * Math.sin(angle)];
      tip = [base[0] + left * (tip[0] - base[0]), base[1] + left * (tip[1] - base[1])];
    }
    const phase: PhaseNumber = t >= gone ? 3 : t >= (row.t_mature_s ?? Infinity) ? 2 : t >= adhered ? 1 : 0;
    out.push({ row, phase, tip, anchored: phase === 1 || phase === 2 });
  }
  return out;
}

function toSegment(x: number, y: number, a: Point, b: Point): number {
  const [dx, dy] = [b[0] - a[0], b[1] - a[1]];
  const s = Math.min(1, Math.max(0, ((x - a[0]) * dx + (y - a[1]) * dy) / (dx * dx + dy * dy + 1e-12)));
  return Math.hypot(x - a[0] - s * dx, y - a[1] - s * dy);
}

export function sampleFrames(
  tracks: Tracks,
  rows: ProtrusionRow[],
  end: number,
  options: FilmOptions,
): { frames: Frames; particles: number } {
  const X = lattice(options.radius, options.spacing);
  const particles = X.length / 2;
  const times: number[] = [];
  for (let t = 0; t <= end + 1e-6; t += options.interval) times.push(t);
  const columns = {
    x: [] as Float64Array[],
    f: [] as Float64Array[],
    p: [] as Float64Array[],
    m: [] as Float64Array[],
    o: [] as Float64Array[],
    front: [] as Float64Array[],
    slot: [] as Float64Array[],
    fMat: [] as Float64Array[],
    force: [] as Float64Array[],
  };
  const protrusions: FrameProtrusion[][] = [];
  let f = new Float64Array(particles).fill(1);
  const u = random(5);
  for (const t of times) {
    const centre: Point = [interpolated(tracks, tracks.x_um, t), interpolated(tracks, tracks.y_um, t)];
    const alive = arms(rows, tracks, t);
    const x = Float64Array.from(X);
    const [p, m] = [new Float64Array(particles), new Float64Array(particles)];
    f = Float64Array.from(f);
    for (let i = 0; i < particles; ++i) {
      const [a, b] = [X[2 * i], X[2 * i + 1]];
      for (const arm of alive) {
        if (!arm.anchored) continue;
        const away = Math.hypot(a - arm.tip[0], b - arm.tip[1]);
        const pull = 5 * (arm.row.f_mat ?? 0.3) * (arm.phase === 2 ? 1 : 0.5) * Math.exp(-away / 14);
        const reach = Math.hypot(centre[0] - arm.tip[0], centre[1] - arm.tip[1]) + 1e-9;
        const [dx, dy] = [(centre[0] - arm.tip[0]) / reach, (centre[1] - arm.tip[1]) / reach];
        x[2 * i] += pull * dx;
        x[2 * i + 1] += pull * dy;
        p[i] += (12 * pull * ((a - arm.tip[0]) * dx + (b - arm.tip[1]) * dy)) / (away + 2);
        m[i] += 22 * pull;
      }
      x[2 * i] += options.noise * (u() - 0.5);
      x[2 * i + 1] += options.noise * (u() - 0.5);
      p[i] += 40 * options.noise * (u() - 0.5);
      const deep = Math.min(
        Math.hypot(a - centre[0], b - centre[1]) - 13,
        ...alive.map((arm) => toSegment(a, b, centre, arm.tip)),
      );
      if (deep < 4) f[i] = Math.min(f[i], t === 0 ? 0 : Math.max(0, (deep - 3) * 0.8));
    }
    const o = new Float64Array(2 * n);
    const [front, slot, fMat, force] = [
      new Float64Array(n),
      new Float64Array(n).fill(255),
      new Float64Array(n).fill(0.05),
      new Float64Array(n).fill(0.02),
    ];
    const polar = interpolated(
      tracks,
      tracks.polarization_rad.map((v) => v ?? 0),
      t,
    );
    for (let i = 0; i < n; ++i) {
      const angle = (2 * Math.PI * i) / n;
      const r = 15 * (1 + 0.05 * Math.cos(2 * angle + t / 2000));
      o[2 * i] = centre[0] + r * Math.cos(angle);
      o[2 * i + 1] = centre[1] + r * Math.sin(angle);
      front[i] = t > 0 && Math.cos(angle - polar) < 0 ? 0 : 1;
      alive.forEach((arm, k) => {
        const d = Math.abs(((i - arm.row.centre_particle + 1.5 * n) % n) - 0.5 * n);
        const share = Math.exp(-((d / 8) ** 2));
        const [ox, oy] = [o[2 * i], o[2 * i + 1]];
        o[2 * i] += share * (arm.tip[0] - ox);
        o[2 * i + 1] += share * (arm.tip[1] - oy);
        if (d <= 20) {
          slot[i] = k;
          fMat[i] = arm.phase > 1 ? (arm.row.f_mat ?? 0.2) : 0.1;
          force[i] = 0.3 * fMat[i];
        }
      });
    }
    columns.x.push(x);
    columns.f.push(f);
    columns.p.push(p);
    columns.m.push(m);
    columns.o.push(o);
    columns.front.push(front);
    columns.slot.push(slot);
    columns.fMat.push(fMat);
    columns.force.push(force);
    protrusions.push(
      alive.map((arm) => ({
        id: arm.row.id,
        phase: arm.phase,
        centre: arm.row.centre_particle,
        anchor: arm.anchored ? [arm.tip[0] + 3 * Math.cos(arm.row.id), arm.tip[1] + 3 * Math.sin(arm.row.id)] : null,
        f_mat: arm.phase === 0 ? 0 : (arm.row.f_mat ?? 0.2),
        force_nN: arm.anchored ? 0.3 * (arm.row.f_mat ?? 0.2) : 0,
      })),
    );
  }
  const place = { type: "int16", components: 2, scale: 0.005, offset: 0, delta: true } as const;
  const share = { type: "uint8", components: 1, scale: 1 / 255, offset: 0, delta: true } as const;
  const index = { type: "uint8", components: 1, scale: 1, offset: 0, delta: false } as const;
  const mises = { type: "uint8", components: 1, scale: 120 / 255, offset: 0, delta: true } as const;
  return {
    particles,
    frames: {
      times_s: times,
      reference: pack([X], { ...place, delta: false }),
      particles: {
        x: pack(columns.x, place),
        f: pack(columns.f, share),
        pressure: pack(columns.p, { type: "uint8", components: 1, scale: 120 / 255, offset: -60, delta: true }),
        von_mises: pack(columns.m, mises),
        ...(options.fibres
          ? {
              fibre_von_mises: pack(
                columns.m.map((v) => v.map((w) => 0.7 * w)),
                mises,
              ),
            }
          : {}),
      },
      outline: {
        x: pack(columns.o, place),
        front: pack(columns.front, index),
        protrusion: pack(columns.slot, index),
        f_mat: pack(columns.fMat, share),
        force: pack(columns.force, share),
      },
      protrusions,
      // As of a uniaxial matrix with a half angle of 30 degrees.
      ...(options.fibres
        ? {
            fibres: {
              bonds_um: [[1, 0], [2, 0], [2, 1], [-2, 1]].map(([a, b]): [number, number] => [a * options.spacing, b * options.spacing]),
              onset: 0.075,
            },
          }
        : {}),
    },
  };
}
