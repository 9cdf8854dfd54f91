/**
 * What the program writes into the page of a run: the data contract, version 1. The contract of a study is in
 * `study/contract.ts`.
 *
 * Units are those of every file of the program: um, s, nN, radians; stress in Pa; speeds in um/h. A key says its unit
 * where it has one. A number that does not exist (not yet happened, not defined) is `null`, never NaN.
 * Positions are interpolated linearly between frames; front, protrusions and anchors are those of the previous frame.
 */

/** Quantised numbers, compressed. value = offset + scale * q. Layout: `unpack.ts`. */
export interface Packed {
  /** How one q is stored; int16 is signed. */
  type: "int16" | "uint8";
  /** Numbers an entry has: 1, or 2 for x and y. */
  components: 1 | 2;
  /** Entries a frame has (not numbers: a frame has per_frame * components of these). */
  per_frame: number;
  scale: number;
  offset: number;
  /** Whether each frame after the first stores q minus the q of the frame before, modulo 2^16 or 2^8. */
  delta: boolean;
  /** base64 of a zlib stream (RFC 1950) of all frames, one after the other. */
  data: string;
}

/** Phases of a protrusion, by their number. */
export const phaseNames = ["growing", "maturing", "contracting", "finishing"] as const;
export type PhaseNumber = 0 | 1 | 2 | 3;

/** A protrusion that is alive at the time of a frame. */
export interface FrameProtrusion {
  /** As in protrusions.csv. */
  id: number;
  phase: PhaseNumber;
  /** Number of its cell, from 1; left out where there is one cell, as everywhere below. */
  cell?: number;
  /** Index of its centre (tip) particle on the outline. */
  centre: number;
  /** Where the protrusion adheres [um]; null while it does not adhere. */
  anchor: [number, number] | null;
  /** Maturation, 0 to 1 [-]. */
  f_mat: number;
  /** Magnitude of the force in its adhesion [nN]; 0 without one. */
  force_nN: number;
}

/** Particles of the matrix, in the order of `reference`, one entry a particle. */
export interface ParticleFrames {
  /** Positions [um]. */
  x: Packed;
  /** f_degr: 1 intact solid, 0 fluid [-]. */
  f: Packed;
  /** Pressure [Pa], compression positive; linear between the limits that offset and scale state, clamped to them. */
  pressure: Packed;
  /** Von Mises stress [Pa], likewise. */
  von_mises: Packed;
  /** Von Mises stress of the fibres [Pa], likewise; left out where there are no fibres. */
  fibre_von_mises?: Packed;
  /** Concentration of the attractant, between its own limits; left out where there is none. */
  attractant?: Packed;
  /** Properties that vary in space and not in time; left out if there are none. */
  layers?: (LayerWords & { values: Packed })[];
}

/** The words for a property of the matrix: its key, unit, title and a sentence. */
export interface LayerWords {
  name: string;
  unit: string;
  title: string;
  meaning: string;
}

/** Particles of the cortex, around the cell, one entry a particle; those of one cell after those of the other. */
export interface OutlineFrames {
  /** Number of the cell of each particle. */
  cell?: number[];
  /** Positions [um]. */
  x: Packed;
  /** 1 in the front of the cell, 0 in its rear. */
  front: Packed;
  /** Index into that frame's `protrusions` of the protrusion it belongs to; 255: none. */
  protrusion: Packed;
  /** Maturation, 0 to 1 [-]. */
  f_mat: Packed;
  /** Magnitude of the actomyosin force on the particle [nN]. */
  force: Packed;
  /** Particles of the nuclei, as many of each cell, in the order of cells [um]; left out where cells have none. */
  nucleus?: Packed;
}

/** Fibres of the matrix: springs that join particles for good. */
export interface FibreData {
  /** From a particle to those that it is joined to [um], in the lattice of `reference`; of two opposite bonds one. */
  bonds_um: [number, number][];
  /** Strain from which on a fibre stiffens [-]. */
  onset: number;
}

export interface Frames {
  /** Model times of the stored frames [s], rising. */
  times_s: number[];
  /** Reference positions of the matrix particles [um]: one frame, so never delta. */
  reference: Packed;
  particles: ParticleFrames;
  outline: OutlineFrames;
  /** One list a frame. */
  protrusions: FrameProtrusion[][];
  /** Left out where there are no fibres. */
  fibres?: FibreData;
  /** Places of the particles of rigid obstacles [um]; left out where there are none. */
  obstacles_um?: [number, number][];
}

/** Columns of tracks.csv, all of one length; of several cells those of one after those of the other. */
export interface Tracks {
  cell?: number[];
  t_s: number[];
  x_um: number[];
  y_um: number[];
  area_um2: number[];
  perimeter_um: number[];
  /** null before the first protrusion. */
  polarization_rad: (number | null)[];
  /** Protrusions alive. */
  n_simultaneous: number[];
}

/** Tracks of measured cells, each from the origin and from time 0, with null between tracks. */
export interface MeasuredTracks {
  /** How many were measured: of more than 200 as many are here. */
  total: number;
  t_s: (number | null)[];
  x_um: (number | null)[];
  y_um: (number | null)[];
}

/** A row of protrusions.csv; null where that has not happened. */
export interface ProtrusionRow {
  cell?: number;
  id: number;
  centre_particle: number;
  t_initiation_s: number;
  t_adhesion_s: number | null;
  t_mature_s: number | null;
  t_disassembly_s: number | null;
  t_end_s: number | null;
  /** At the end of growth. */
  length_um: number | null;
  /** At the end of maturation. */
  f_mat: number | null;
  /** At disassembly. */
  force_nN: number | null;
  /** force_nN over 2 f_mat F_am, of both strands. */
  f_adh_rel: number | null;
  /** Why the adhesion ended: "disassembly", "rupture", "lost", "unadhered"; "" or null while it has not. */
  cause: string | null;
}

export interface NamedValue {
  cell?: number;
  /** As in the file the value comes from. */
  name: string;
  /** In words, with the unit in square brackets. */
  meaning: string;
  value: number | string | null;
}

/** Something about a run or a study as a whole. */
export interface Fact {
  name: string;
  value: string;
}

export interface ChangedParameter {
  /** Path in a scenario: "ecm.youngs_modulus". */
  name: string;
  /** As in a scenario, with its unit. */
  value: string;
  /** Default value, from Table 1 or of the program. */
  default: string;
  meaning: string;
}

/** A law that differs from the paper's, with both as curves. */
export interface ChangedLaw {
  /** Path in a scenario: "laws.disassembly_rate". */
  name: string;
  /** The formula. */
  text: string;
  /** The user's constants that it names, with their values: "F_c = 0.05 nN". */
  constants?: string;
  /** "" of a ratio. */
  unit: string;
  /** Over each argument that it depends on, where others are as `at` says: "f_mat = 0.5"; "" if none matters. null where a law has no value. */
  curves: { over: string; unit: string; at: string; x: number[]; changed: (number | null)[]; usual: (number | null)[] }[];
}

/** A parameter that got another value in the middle of the run. */
export interface TimedChange {
  t_s: number;
  /** "at 3 h: cell.spring_stiffness 2.8 -> 1.4 N/m" */
  text: string;
}

export interface RunPage {
  format: "matrigrate-run";
  version: 1;
  title: string;
  /** One sentence: how far the run came, and why it ended if it failed. */
  status: string;
  /** Time that the run was to reach or, if it ended early, reached [s]. */
  t_end_s: number;
  geometry: { radius_um: number; spacing_um: number; n_particles: number; n_outline: number };
  /** The result, in a sentence: "12.7 um/h from start to end, persistent (MSD slope 1.42), 21 protrusions."; "" for nothing. */
  summary: string;
  /** What was run, when and how: scenario, stiffness, seed, command, date, wall time, trajectory hash. */
  facts: Fact[];
  /** null or left out: the run stored none. */
  frames?: Frames | null;
  tracks: Tracks;
  /** null or left out: none. */
  measured?: MeasuredTracks | null;
  protrusions: ProtrusionRow[];
  readouts: NamedValue[];
  /** Only the parameters that differ from their defaults. */
  parameters: ChangedParameter[];
  /** Left out or empty: all are the paper's. */
  laws?: ChangedLaw[];
  /** Left out or empty: none. */
  changes?: TimedChange[];
  health: NamedValue[];
  /** Text with line breaks. */
  provenance: string;
  citation: string;
}
