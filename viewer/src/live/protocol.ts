/** What page and worker say to each other. */
import type { LayerWords, ProtrusionRow } from "../contract";

export interface Fault {
  line: number;
  column: number;
  key: string;
  message: string;
}

/** A scenario as the core takes it. */
export interface Given {
  toml: string;
  /** "key=value" each. */
  overrides: string[];
  /** Files that the scenario names, with their content. */
  files: Record<string, string>;
}

/** Properties of a simulation, sent when it begins and when it changes. */
export interface Head {
  t_s: number;
  done: boolean;
  radius_um: number;
  spacing_um: number;
  n_particles: number;
  /** Points on the outlines of all cells. */
  n_outline: number;
  /** Number of particles of the nuclei of all cells; 0: no nuclei. */
  n_nucleus: number;
  /** Of several cells: the number of the cell of each point, from 1. */
  cell?: number[];
  duration_s: number;
  changed: Changed;
  /** From a particle to those that fibres join it to [um]; empty without fibres. */
  bonds_um: [number, number][];
  onset: number;
  /** Whether there is chemoattractant. */
  attractant: boolean;
  /** Places of the particles of rigid obstacles [um]. */
  obstacles_um: [number, number][];
}

/** Constant properties of the particles of the matrix. */
export interface CoreMatrix {
  /** x0, y0, x1, y1, ... [um] */
  reference: Float32Array;
  /** Properties that vary from place to place. */
  layers?: (LayerWords & { values: Float32Array })[];
}

/** A moment as the core gives it. */
export interface CoreFrame {
  t_s: number;
  displacement: Float32Array;
  f: Uint8Array;
  pressure: Float32Array;
  vonMises: Float32Array;
  fibreVonMises?: Float32Array;
  attractant?: Float32Array;
  outline: Float32Array;
  front: Uint8Array;
  protrusionOf: Uint8Array;
  fMat: Float32Array;
  force: Float32Array;
  nucleus?: Float32Array;
  /** Of several cells: the number of the cell of each protrusion. */
  cells?: Float32Array;
  ids: Float32Array;
  /** Counted on the cell of each. */
  centres: Float32Array;
  phases: Uint8Array;
  anchors: Float32Array;
  fMats: Float32Array;
  forces: Float32Array;
}

/** The memory of a frame, to be handed over with it. */
export const buffersOf = (frame: CoreFrame): ArrayBuffer[] =>
  Object.values(frame).flatMap((v) => (ArrayBuffer.isView(v) ? [v.buffer as ArrayBuffer] : []));

/** t [s], x, y [um], area [um^2], perimeter [um], polarization [rad], protrusions alive; of several cells its number. */
export type TrackRow = [number, number, number, number, number, number | null, number, number?];

export interface Preset {
  name: string;
  description: string;
  overrides: string[];
}

/** A law of the model as it is by default. */
export interface Law {
  path: string;
  unit: string;
  meaning: string;
  formula: string;
  /** Names of its arguments. */
  arguments: string[];
}

/** Every parameter that is not at the program's default. */
export type Changed = { path: string; value: string | number | boolean }[];

export interface Answer {
  kind: "answer";
  ticket: number;
  faults?: Fault[];
  failure?: string;
  /** To "check". */
  changed?: Changed;
  /** The resolved scenario. */
  toml?: string;
  /** To "image": the state at t_s. */
  bytes?: Uint8Array;
  t_s?: number;
}

export type ToWorker =
  | { kind: "check"; given: Given; ticket: number }
  | { kind: "start"; given: Given; image?: Uint8Array }
  | { kind: "play"; to_s?: number }
  | { kind: "pause" }
  | { kind: "step" }
  | { kind: "change"; overrides: string[] }
  | { kind: "image"; ticket: number }
  /** The last picture has been taken over; the next one may come, in the same arrays. */
  | { kind: "seen"; frame: CoreFrame };

export type FromWorker =
  | { kind: "ready"; presets: Preset[]; laws: Law[] }
  | { kind: "begun"; head: Head; matrix: CoreMatrix }
  | { kind: "changed"; head: Head; matrix: CoreMatrix; overrides: string[] }
  /** Rows of protrusions come only where they have changed. */
  | { kind: "frame"; frame: CoreFrame; tracks: TrackRow[]; protrusions?: ProtrusionRow[]; done: boolean }
  | { kind: "stopped"; why: "paused" | "done" | "failed" }
  | { kind: "faults"; faults: Fault[]; of: "start" | "change" }
  | { kind: "failure"; text: string }
  | Answer;
