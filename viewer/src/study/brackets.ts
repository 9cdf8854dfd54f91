/** Which comparisons are drawn over boxes, on which level each, and what is said of them. */
import type { StudyTest } from "./contract";
import { pretty, pText, readable, stars } from "../numbers";
import { groupAt, type Grid } from "./groups";

/** Which comparisons are drawn. */
export type Shown = "significant" | "all" | "none";

export interface Bracket {
  from: number;
  to: number;
  level: number;
  test: StudyTest;
}

/** Runs that a test needs at each point: the scatter of two says next to nothing. */
export const leastRuns = 3;
export const enoughRuns = (test: StudyTest): boolean => Math.min(test.n_a, test.n_b) >= leastRuns;

const significant = (test: StudyTest): boolean => enoughRuns(test) && test.p_holm !== null && test.p_holm < 0.05;

/** Over a bracket: stars after Holm's correction, or why there are none. */
export const sign = (test: StudyTest): string => (enoughRuns(test) ? stars(test.p_holm) : `n < ${leastRuns}`);

/** The correction behind the stars of a read-out; "" if no comparison can have stars. Holm counts comparisons with a p. */
export function starsNote(tests: StudyTest[], readout: string): string {
  const tested = tests.filter((t) => t.readout === readout && t.p !== null);
  if (!tested.some(enoughRuns)) return "";
  return ` Stars: p after Holm's correction over ${tested.length} comparison${tested.length > 1 ? "s" : ""}.`;
}

const testNames: Record<string, [name: string, statistic: string]> = {
  t: ["t-test", "t"],
  welch: ["Welch's t-test", "t"],
  mann_whitney: ["Mann-Whitney test", "U"],
};

/** All about a comparison, line by line. */
export function story(test: StudyTest, made: Grid, unit: string): string[] {
  const [name, letter] = testNames[test.test] ?? [test.test, "statistic"];
  const number = (value: number) => readable(value, 3);
  const lines = [
    `${groupAt(made, test.a)?.label ?? ""} against ${groupAt(made, test.b)?.label ?? ""}`,
    `${name}: ${pText(test.p)}${test.statistic === null ? "" : `, ${letter} = ${number(test.statistic)}`}`,
    `after Holm's correction: ${pText(test.p_holm)}`,
    `n = ${test.n_a} and ${test.n_b}${enoughRuns(test) ? "" : `: too few, a test needs ${leastRuns} at each point`}`,
  ];
  if (test.difference !== null)
    lines.push(
      `difference ${number(test.difference)} ${pretty(unit)}${test.interval && enoughRuns(test) ? ` (95 %: ${number(test.interval[0])} to ${number(test.interval[1])})` : ""}`,
    );
  return lines;
}

/** Brackets that cross along x are put on different levels, short ones lowest. */
export function brackets(tests: StudyTest[], made: Grid, readout: string, show: Shown): Bracket[] {
  const out: Bracket[] = [];
  const wanted = tests
    .filter((t) => t.readout === readout && (show === "all" || (show === "significant" && significant(t))))
    .flatMap((test) => {
      const [a, b] = [groupAt(made, test.a), groupAt(made, test.b)];
      return a && b ? [{ from: Math.min(a.x, b.x), to: Math.max(a.x, b.x), test }] : [];
    })
    .sort((a, b) => a.to - a.from - (b.to - b.from) || a.from - b.from);
  for (const one of wanted) {
    let level = 0;
    while (out.some((o) => o.level === level && o.from < one.to + 0.05 && one.from < o.to + 0.05)) ++level;
    out.push({ ...one, level });
  }
  return out;
}
