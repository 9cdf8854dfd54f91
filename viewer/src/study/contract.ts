/** What the program writes into the page of a study: the data contract, version 1. Units and null as in `../contract.ts`. */
import type { Fact, MeasuredTracks, RunPage } from "../contract";

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
  /** From 1. */
  replicate?: number;
  seed: number;
  /** Of a measured track, in place of the seed. */
  name?: string;
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
  /** force over 2 f_mat F_am at disassembly, one number an adhesion [-]. */
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
  /** With a confidence of 95 %. */
  median_interval?: [number, number] | null;
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

/** Pairwise correlations within points; square matrices in the order of `names`. */
export interface StudyCorrelation {
  names: string[];
  r: (number | null)[][];
  p: (number | null)[][];
  /** Corrected after Holm over all pairs. */
  p_holm: (number | null)[][];
  n: number[][];
}

/** What became of a statement. */
export type Verdict = "holds" | "in direction" | "does not hold" | "undecided";

export interface StudyClaim {
  id: string;
  sentence: string;
  /** The paper's numbers; "" where it gives none. */
  published: string;
  verdict: Verdict;
  /** Beside the verdict: "not the paper's runs"; "" for nothing. */
  caveat: string;
  /** What was found: means with their intervals. */
  ours: string[];
  /** Conditions with their statistics, and whether each is met. */
  statistic: string[];
}

/** What was measured: a value, or a range, with its standard error. */
export interface StudyTarget {
  readout: string;
  low: number;
  high: number;
  error: number;
  /** Conditions that it holds at; "" for all. */
  at: string;
}

/** Read-outs over the factors of a design that is no grid. */
export interface StudyScatter {
  /** Grid point of each value. */
  points: GridPoint[];
  factors: {
    name: string;
    label: string;
    /** A sentence. */
    meaning?: string;
    unit: string;
    /** One value per point. */
    values: number[];
    /** Spearman's rank correlation over the means of points, p after Holm over all factors and read-outs. */
    correlations: { readout: string; rho: number | null; p_holm: number | null; n: number }[];
  }[];
}

/** A run that the page of a study plays. */
export interface StudyPlayer {
  /** As in `runs`. */
  id: string;
  /** Which one it is, and why it was chosen. */
  label: string;
  run: RunPage;
}

/** What is drawn of a study. */
export interface StudyData {
  title: string;
  /** What groups are of, runs if left out. */
  sampled?: "tracks";
  /** The first is drawn along x, the others side by side in colours. */
  axes: StudyAxis[];
  readouts: StudyReadout[];
  runs: StudyRun[];
  groups: StudyGroup[];
  tests: StudyTest[];
  msd: StudyMsd[];
  targets?: StudyTarget[];
}

/** The page of a study. The title has its size: "Stiffness: 4 points x 12 replicates". */
export interface StudyPage extends StudyData {
  format: "matrigrate-study";
  version: 1;
  status: string;
  /** The result, in a sentence; "" for nothing. */
  summary?: string;
  /** Command, date, version of the program, runs done. */
  facts?: Fact[];
  correlation?: StudyCorrelation | null;
  claims?: StudyClaim[];
  /** How the study differs from the published one; "" for nothing. */
  claims_note?: string;
  scatter?: StudyScatter | null;
  players?: StudyPlayer[];
  /** Measured tracks, and the points that they are to be compared with. */
  measured?: (MeasuredTracks & { points: GridPoint[] })[];
  provenance: string;
  citation: string;
}
