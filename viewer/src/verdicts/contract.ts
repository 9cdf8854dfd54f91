/** What the program writes into the page of verdicts: the data contract, version 1. Units and null as in `../contract.ts`. */
import type { Fact } from "../contract";
import type { StudyData, Verdict } from "../study/contract";

export interface Curve {
  /** "" for no entry in the legend. */
  label: string;
  /** null breaks the line, and so does what is not positive on a logarithmic axis. */
  x: (number | null)[];
  y: (number | null)[];
  mark: "line" | "dashed" | "points";
  /** Index into the palette. */
  colour: number;
}

export interface Plot {
  /** Unique on the page. */
  name: string;
  title: string;
  caption: string;
  /** With unit: "time [s]". */
  x_label: string;
  y_label: string;
  log_x: boolean;
  log_y: boolean;
  series: Curve[];
}

/** A picture that the program has drawn. */
export interface Picture {
  name: string;
  caption: string;
  /** The whole document. */
  svg: string;
}

/** A number against what it should be. */
export interface Check {
  /** With its unit. */
  quantity: string;
  measured: number | null;
  expected: number | null;
  /** Largest difference that holds. */
  tolerance: number | null;
  sense: "near" | "at_least" | "at_most";
  /** Where the tolerance comes from. */
  reason: string;
  holds: boolean;
}

/** Something that holds or does not: a verification case, a claim of the paper. */
export interface Statement {
  /** "creep", "A2"; unique on the page. */
  id: string;
  /** "calibration"; "" for none. */
  kind: string;
  sentence: string;
  verdict: Verdict;
  /** Beside the verdict: "not the paper's runs"; "" for nothing. */
  caveat: string;
  /** The paper's numbers; "" where it gives none. */
  published: string;
  /** Ours, in a line; "" for nothing. */
  brief: string;
  /** "" if it holds. */
  why_not: string;
  checks: Check[];
  /** The paper's, on the same run. */
  claims: Check[];
  details: { name: string; sentences: string[] }[];
  /** Names in `studies`. */
  studies: string[];
  plots: Plot[];
  pictures: Picture[];
}

export interface VerdictPage {
  format: "matrigrate-verdicts";
  version: 1;
  title: string;
  facts: Fact[];
  /** How the runs were made; "" for nothing. */
  setting: string;
  statements: Statement[];
  studies: { name: string; study: StudyData }[];
  provenance: string;
  citation: string;
}
