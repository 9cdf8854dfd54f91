/** Which comparisons are drawn over boxes, and on which level each. */
import type { StudyTest } from "../contract";
import { groupAt, type Grid } from "./groups";

/** Which comparisons are drawn. */
export type Shown = "significant" | "all" | "none";

export interface Bracket {
  from: number;
  to: number;
  level: number;
  test: StudyTest;
}

/** Brackets that cross along x are put on different levels, short ones lowest. */
export function brackets(tests: StudyTest[], made: Grid, readout: string, show: Shown): Bracket[] {
  const out: Bracket[] = [];
  const wanted = tests
    .filter((t) => t.readout === readout && (show === "all" || (show === "significant" && t.p !== null && t.p < 0.05)))
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
