/**
 * What the program writes into the pages: the data contract, version 1.
 *
 * Units are those of every file of the program: um, s, nN, radians; stress in Pa; speeds in um/h. A key says its unit
 * where it has one. A number that does not exist (not yet happened, not defined) is `null`, never NaN.
 * The same contract in words, with the exact layout of a packed array, is in README.md.
 */

/** Quantised numbers, compressed. value = offset + scale * q. Layout: see `unpack.ts` and README.md. */
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
  /** Where it adheres [um]; null while it does not. */
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
  /** Young's modulus of the intact matrix [Pa], and ligand over the usual one: the same in all frames; left out where the same everywhere. */
  youngs_modulus?: Packed;
  ligand?: Packed;
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
  /** force_nN over f_mat F_am. */
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
  /** That of Table 1 or of the program. */
  default: string;
  meaning: string;
}

export interface RunPage {
  format: "matrigrate-run";
  version: 1;
  title: string;
  /** One sentence: how far it came, and why it ended if it failed. */
  status: string;
  /** Time that the run was to reach or, if it ended early, reached [s]. */
  t_end_s: number;
  geometry: { radius_um: number; spacing_um: number; n_particles: number; n_outline: number };
  /** What came out, in a sentence: "12.7 um/h from start to end, persistent (MSD slope 1.42), 21 protrusions."; "" for nothing. */
  summary: string;
  /** What was run, when and how: scenario, stiffness, seed, command, date, wall time, trajectory hash. */
  facts: Fact[];
  /** null or left out: the run stored none. */
  frames?: Frames | null;
  tracks: Tracks;
  protrusions: ProtrusionRow[];
  readouts: NamedValue[];
  /** Those that differ from their default alone. */
  parameters: ChangedParameter[];
  health: NamedValue[];
  /** Text with line breaks. */
  provenance: string;
  citation: string;
}

/** A parameter that a study varies. */
export interface StudyAxis {
  /** Path in a scenario. */
  name: string;
  /** Short: the symbol, "E". */
  label: string;
  meaning: string;
  /** "" for none. */
  unit: string;
  /** In the order to draw them; words where a value is no number. */
  values: (number | string)[];
}

/** A read-out that runs are compared by. */
export interface StudyReadout {
  /** Key in `StudyRun.readouts`. */
  name: string;
  /** Short: "v_migr_abs". */
  label: string;
  meaning: string;
  /** "" for none. */
  unit: string;
}

/** Lines, with null between those of several cells [um]. */
export interface Lines {
  x_um: (number | null)[];
  y_um: (number | null)[];
}

/** Place in the grid: one index into `values` for each axis. */
export type GridPoint = number[];

export interface StudyRun {
  /** Unique in the study. */
  id: string;
  point: GridPoint;
  seed: number;
  status: "done" | "failed" | "running" | "pending";
  /** Why it failed; "" otherwise. */
  reason: string;
  /** Relative address of its report; null: none. */
  report: string | null;
  /** By name; null or missing: not defined for this run. */
  readouts: Record<string, number | null>;
  /** Centre of mass over time [um]; drawn from a common origin. */
  path?: Lines | null;
  /** Outline of the cell at the end [um], in the coordinates of the path. */
  outline?: Lines | null;
  /** force over f_mat F_am at disassembly, one number an adhesion [-]. */
  f_adh_rel?: number[];
}

/** Mean square displacement over the runs of a grid point. */
export interface StudyMsd {
  point: GridPoint;
  lag_min: number[];
  msd_um2: number[];
  /** Standard error of the mean over runs [um^2]; null for one run. */
  sem_um2?: (number | null)[];
  /** Slope of log MSD over log lag [-]. */
  slope: number | null;
}

/** The sample of a read-out at a grid point; the same numbers as in groups.csv. null: not defined. */
export interface StudyGroup {
  readout: string;
  point: GridPoint;
  n: number;
  mean: number | null;
  low_whisker: number | null;
  low_quartile: number | null;
  median: number | null;
  high_quartile: number | null;
  high_whisker: number | null;
}

/** Two grid points compared by a read-out. */
export interface StudyTest {
  readout: string;
  a: GridPoint;
  b: GridPoint;
  /** Name of the test: "t", "welch" or "mann_whitney". */
  test: string;
  statistic: number | null;
  p: number | null;
  /** Corrected after Holm over all comparisons of this read-out. */
  p_holm: number | null;
  n_a: number;
  n_b: number;
  /** Mean of b minus mean of a, in the unit of the read-out, and its 95 % confidence interval. */
  difference: number | null;
  interval: [number, number] | null;
}

/** Pairwise correlations across all runs; square matrices in the order of `names`. */
export interface StudyCorrelation {
  names: string[];
  r: (number | null)[][];
  p: (number | null)[][];
  n: number[][];
}

export interface StudyClaim {
  id: string;
  claim: string;
  /** The paper's numbers; "" where it gives none. */
  published: string;
  verdict: "holds" | "fails" | "open";
  /** What was found: means with their intervals. */
  ours: string[];
  /** Conditions with their statistics, and whether each is met. */
  statistic: string[];
}

/** What a read-out should be under a condition. */
export interface StudyTarget {
  readout: string;
  /** "" without conditions. */
  condition: string;
  /** "12.1 +- 1", "3 to 5 +- 0.2". */
  target: string;
  weight: number;
}

/** A factor set against all targets; null: not defined. */
export interface StudyFactorSet {
  label: string;
  /** What differs from the base, in words. */
  settings: string;
  discrepancy: number | null;
  interval: [number, number] | null;
  /** Targets that could be judged. */
  judged: number;
  /** Finished runs without a value of a target's read-out. */
  undefined: number;
  /** One a target. */
  z: (number | null)[];
  means: (number | null)[];
}

/** The effect of a factor on a read-out, or on the discrepancy, under a condition. */
export interface StudyEffect {
  design: "one_at_a_time" | "morris";
  /** A name of `readouts`, or "discrepancy". */
  readout: string;
  /** "" for the discrepancy, and without conditions. */
  condition: string;
  /** Path of the parameter. */
  factor: string;
  /** Short. */
  label: string;
  /** One at a time; "" otherwise. */
  value: string;
  n: number;
  /** One at a time: value less base. */
  effect?: number | null;
  interval?: [number, number] | null;
  /** Morris. */
  mu?: number | null;
  mu_star?: number | null;
  mu_star_interval?: [number, number] | null;
  sigma?: number | null;
  sigma_interval?: [number, number] | null;
}

export interface StudyScreening {
  /** Of the intervals: 0.95. */
  confidence: number;
  /** Whether replicates have common random numbers. */
  paired: boolean;
  targets: StudyTarget[];
  /** From the best on; empty without targets. */
  sets: StudyFactorSet[];
  effects: StudyEffect[];
}

/** A run that the page of a study plays. */
export interface StudyPlayer {
  /** As in `runs`. */
  id: string;
  /** Which one it is, and why it was chosen. */
  label: string;
  run: RunPage;
}

export interface StudyPage {
  format: "matrigrate-study";
  version: 1;
  /** With the size of the study: "Stiffness: 4 points x 12 replicates". */
  title: string;
  status: string;
  /** What came out, in a sentence; "" for nothing. */
  summary?: string;
  /** Command, date, version of the program, runs done. */
  facts?: Fact[];
  /** The first is drawn along x, the others side by side in colours. */
  axes: StudyAxis[];
  readouts: StudyReadout[];
  runs: StudyRun[];
  groups: StudyGroup[];
  tests: StudyTest[];
  msd: StudyMsd[];
  correlation?: StudyCorrelation | null;
  claims?: StudyClaim[];
  /** In what the study is not the published one; "" for nothing. */
  claims_note?: string;
  /** What stands beside each verdict: "not the paper's runs"; "" for nothing. */
  claims_caveat?: string;
  screening?: StudyScreening | null;
  players?: StudyPlayer[];
  provenance: string;
  citation: string;
}
