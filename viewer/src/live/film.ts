/**
 * A film that grows. Older moments are kept at even spaces, fewer of them as time goes on, so that memory stays the same;
 * the newest ones are kept as they come.
 */
import type { FrameProtrusion, PhaseNumber } from "../contract";
import { fibresOf, type Film } from "../run/frames";
import { cellParts, type CellPart } from "../run/cells";
import type { Field } from "../embedded";
import type { CoreFrame, CoreMatrix, Head } from "./protocol";

/** Moments of the past, and the newest ones, that are kept. */
const history = 96;
const newest = 6;
/** Between moments of the past, at first [s]. */
const firstInterval = 60;
/** First upper limits of the colours. */
const stressLimit = { pressure: 60, vonMises: 100, fibreVonMises: 100 };
const forceLimit = 4;
const attractantLimit = 1;

export type Numbers = Int16Array | Uint8Array;

/** The part of a film that the browser keeps, without its moments. */
export interface FilmIndex {
  id: string;
  times: number[];
  protrusions: FrameProtrusion[][];
  interval: number;
  past: number;
}

export interface FilmImage extends FilmIndex {
  /** Of each time: the numbers of each field. */
  moments: Numbers[][];
}

export class LiveFilm {
  readonly film: Film;
  /** Times of moments that have come, or come anew, since they were last kept in the browser. */
  readonly unsaved = new Set<number>();
  /** Tells its moments from those of other films where they are kept. */
  private readonly id = `${Date.now()}-${Math.random()}`;
  /** How many of the film's moments are of the past. */
  private past = 0;
  private interval = firstInterval;
  private readonly X: Float32Array;
  private readonly fields: Field[];

  constructor(head: Head, { reference, layers }: CoreMatrix) {
    const { n_particles: n, n_outline: m, n_nucleus: k, radius_um: radius } = head;
    const frames = history + newest;
    const scale = (1.3 * radius) / 32767;
    const wide = (stride: number, scale: number): Field => ({ q: new Int16Array(frames * stride), stride, step: stride, scale, offset: 0 });
    const narrow = (stride: number, scale: number): Field => ({ ...wide(0, scale), q: new Uint8Array(frames * stride), stride, step: stride });
    const fixed: Field = { q: Int16Array.from(reference, (v) => Math.round(v / scale)), stride: 2 * n, step: 0, scale, offset: 0 };
    const withFibres = head.bonds_um.length > 0;
    const changing = {
      x: wide(2 * n, scale),
      f: narrow(n, 1 / 255),
      pressure: wide(n, stressLimit.pressure / 255),
      vonMises: wide(n, stressLimit.vonMises / 255),
      fibreVonMises: withFibres ? wide(n, stressLimit.fibreVonMises / 255) : null,
      attractant: head.attractant ? wide(n, attractantLimit / 255) : null,
    };
    const outline = {
      x: wide(2 * m, scale),
      front: narrow(m, 1),
      protrusion: narrow(m, 1),
      fMat: narrow(m, 1 / 255),
      force: narrow(m, forceLimit / 255),
    };
    const nucleus = k > 0 ? wide(2 * k, scale) : null;
    this.X = reference;
    this.fields = [...Object.values(changing), ...Object.values(outline), nucleus].filter((one) => one !== null);
    this.film = {
      ...changing,
      times: [],
      reference: fixed,
      layers: layersOf(layers),
      obstacles: head.obstacles_um,
      cells: cellParts(m, head.cell),
      fibres: withFibres ? fibresOf(head, fixed) : null,
      outline,
      nucleus,
      protrusions: [],
      growing: true,
      particles: n,
      outlinePoints: m,
    };
  }

  get end(): number {
    return this.film.times[this.film.times.length - 1] ?? 0;
  }

  add(frame: CoreFrame): void {
    const { times, protrusions } = this.film;
    if (times.length > 0 && frame.t_s <= this.end) this.cut(frame.t_s);
    if (times.length - this.past >= newest) this.retire();
    const at = times.length;
    this.unsaved.add(frame.t_s);
    times.push(frame.t_s);
    protrusions.push(alive(frame, this.film.cells));
    this.write(at, frame);
  }

  /** Other properties of the matrix, which were set on the way. */
  setMatrix({ layers }: CoreMatrix): void {
    this.film.layers = layersOf(layers);
  }

  /** The film without its moments. */
  index(): FilmIndex {
    const { id, interval, past } = this;
    return { id, times: [...this.film.times], protrusions: [...this.film.protrusions], interval, past };
  }

  /** Copies of the numbers of the moment `k`, a field each. */
  moment(k: number): Numbers[] {
    return this.fields.map(({ q, stride }) => q.slice(k * stride, (k + 1) * stride));
  }

  /** Begins with the moments of another film, where they are of the same simulation. */
  restore(image: FilmImage): void {
    const n = image.times.length;
    const same = (moment: Numbers[]) =>
      moment.length === this.fields.length && this.fields.every(({ stride }, f) => moment[f].length === stride);
    if (image.moments.length !== n || !image.moments.every(same) || n > history + newest) return; // of another version of the page
    image.moments.forEach((moment, k) => this.fields.forEach(({ q, stride }, f) => q.set(moment[f], k * stride)));
    this.film.times.splice(0, Infinity, ...image.times);
    this.film.protrusions.splice(0, Infinity, ...image.protrusions);
    ({ interval: this.interval, past: this.past } = image);
    // From now on a film of its own: another tab may continue the old film.
    for (const t of image.times) this.unsaved.add(t);
  }

  /** Takes moments from a time on away. */
  private cut(from: number): void {
    const { times, protrusions } = this.film;
    let n = times.length;
    while (n > 0 && times[n - 1] >= from) this.unsaved.delete(times[--n]);
    times.length = protrusions.length = n;
    this.past = Math.min(this.past, n);
  }

  /** The oldest of the newest moments becomes one of the past, or goes. */
  private retire(): void {
    const { times } = this.film;
    const { past } = this;
    if (past === 0 || times[past] - times[past - 1] >= this.interval - 1e-6) {
      ++this.past;
      if (this.past === history) this.thin();
    } else this.remove([past]);
  }

  /** Every second moment of the past goes. */
  private thin(): void {
    this.interval *= 2;
    this.remove(Array.from({ length: this.past }, (_, k) => k).filter((k) => k % 2 === 1));
    this.past = Math.ceil(this.past / 2);
  }

  /** @param which  indices, rising */
  private remove(which: number[]): void {
    const { times, protrusions } = this.film;
    const gone = new Set(which);
    let to = 0;
    for (let from = 0; from < times.length; ++from) {
      if (gone.has(from)) {
        this.unsaved.delete(times[from]);
        continue;
      }
      if (to !== from) {
        for (const { q, stride } of this.fields) q.copyWithin(to * stride, from * stride, (from + 1) * stride);
        times[to] = times[from];
        protrusions[to] = protrusions[from];
      }
      ++to;
    }
    times.length = protrusions.length = to;
  }

  private write(at: number, frame: CoreFrame): void {
    const { film, X } = this;
    const { q, stride, scale } = film.x;
    for (let i = 0; i < stride; ++i) q[at * stride + i] = Math.round((X[i] + frame.displacement[i]) / scale);
    const put = (field: Field | null, values?: ArrayLike<number>) => {
      if (!field || !values) return;
      const [least, most] = field.q instanceof Int16Array ? [-32767, 32767] : [0, 255];
      const base = at * field.stride;
      for (let i = 0; i < field.stride; ++i)
        field.q[base + i] = Math.max(least, Math.min(most, Math.round(values[i] / field.scale)));
    };
    film.f.q.set(frame.f, at * film.f.stride);
    for (const name of ["pressure", "vonMises", "fibreVonMises", "attractant", "nucleus"] as const) put(film[name], frame[name]);
    for (const name of ["front", "fMat", "force"] as const) put(film.outline[name], frame[name]);
    put(film.outline.x, frame.outline);
    put(film.outline.protrusion, frame.protrusionOf);
  }
}

/** Values that hold at all times, from the lowest to the highest in 255 steps. */
const layersOf = (layers: CoreMatrix["layers"]): Film["layers"] =>
  (layers ?? []).map(({ values, ...words }) => ({ ...words, field: steady(values) }));

function steady(values: Float32Array): Field {
  const [low, high] = [values.reduce((a, b) => Math.min(a, b), Infinity), values.reduce((a, b) => Math.max(a, b), -Infinity)];
  const scale = high > low ? (high - low) / 255 : 1;
  const q = Uint8Array.from(values, (v) => Math.round((v - low) / scale));
  return { q, stride: q.length, step: 0, scale, offset: low };
}

function alive(frame: CoreFrame, cells: CellPart[]): FrameProtrusion[] {
  return Array.from(frame.ids, (id, k) => {
    const [x, y] = [frame.anchors[2 * k], frame.anchors[2 * k + 1]];
    const cell = frame.cells?.[k];
    const first = cells.find(({ number }) => number === cell)?.first ?? 0;
    return {
      id,
      ...(cell === undefined ? {} : { cell }),
      phase: frame.phases[k] as PhaseNumber,
      centre: first + frame.centres[k],
      anchor: Number.isNaN(x) ? null : [x, y],
      f_mat: frame.fMats[k],
      force_nN: frame.forces[k],
    };
  });
}
