/** Claims with their verdicts, and the runs with how each ended. */
import type { StudyPage, StudyRun, Verdict } from "./contract";
import { h, table } from "../dom";
import { pretty, readable } from "../numbers";
import { lettered } from "../words";
import { same, type Grid, type Group } from "./groups";

/** A code name with its unit: tables alone have them. */
const withUnit = (label: string, unit: string): string => (unit ? `${label} (${pretty(unit)})` : label);

export const verdict = (word: Verdict): HTMLElement => h("span", { class: `verdict ${word.replaceAll(" ", "-")}` }, word);

/** The first sentence, and the others on demand. */
function lines([first, ...others]: string[]): HTMLElement | string {
  if (others.length === 0) return first ?? "";
  const summary = h("summary", {}, first, " ", h("span", { class: "more" }, `and ${others.length} more`));
  return h("details", {}, summary, h("ul", {}, ...others.map((text) => h("li", {}, text))));
}

export function claims(study: StudyPage): HTMLElement | null {
  if (!study.claims || study.claims.length === 0) return null;
  const rows = study.claims.map((c) => [
    c.id,
    c.sentence,
    h("div", {}, verdict(c.verdict), c.caveat && h("div", { class: "caveat" }, c.caveat)),
    pretty(c.published) || "\u2013",
    lines(c.ours.map(pretty)),
    lines(c.statistic.map(pretty)),
  ]);
  return table("Claims and verdicts", ["id", "claim", "verdict", "published", "ours: mean [95 %]", "statistic"], rows);
}

// A relative address only: a page must not lead elsewhere because its data says so.
export const safe = (address: string | null): string | null =>
  address !== null && !/^([a-z][a-z0-9+.-]*:|\/\/)/i.test(address) ? address : null;

/** A run is named by its place in the study; hovering shows the name of its folder, a hash. */
const nameOf = (run: StudyRun): string => (run.replicate ? `replicate ${run.replicate}` : run.id);

/** Of each group and read-out, where intervals are there. */
export function medians(study: StudyPage, made: Grid): HTMLElement | null {
  if (!study.groups.some((g) => g.median_interval)) return null;
  const cell = (point: Group["point"], readout: string): string => {
    const g = study.groups.find((one) => one.readout === readout && same(one.point, point));
    const [low, high] = g?.median_interval ?? [null, null];
    return g && g.n > 0 ? `${readable(g.median)} [${readable(low)}, ${readable(high)}], n = ${g.n}` : "\u2013";
  };
  const heads = ["", ...study.readouts.map((r) => withUnit(r.meaning, r.unit))];
  const row = (g: Group) => [h("span", {}, ...lettered(g.label)), ...study.readouts.map((r) => cell(g.point, r.name))];
  return table("Medians [95 %]", heads, made.groups.map(row));
}

const order: StudyRun["status"][] = ["failed", "running", "pending", "done"];

/** Failures first: they are what someone looks for here. */
export function runs(study: StudyPage): HTMLElement {
  const shown = study.readouts.slice(0, 3);
  const [axes, readouts] = [study.axes, shown].map((all) => all.map((one) => withUnit(one.label, one.unit)));
  const heads = ["run", ...axes, "seed", "status", ...readouts];
  const named = (run: StudyRun, href: string | null) => h(href ? "a" : "span", { href: href ?? false, title: run.id }, nameOf(run));
  const strong = (run: StudyRun) => h("strong", { class: run.status === "failed" && "failed" }, run.status);
  const sorted = [...study.runs].sort((a, b) => order.indexOf(a.status) - order.indexOf(b.status));
  const rows = sorted.map((run) => [
    named(run, safe(run.report)),
    ...study.axes.map((a, i) => String(a.values[run.point[i]])),
    String(run.seed),
    run.reason ? h("span", { class: "reason" }, strong(run), `: ${run.reason}`) : run.status,
    ...shown.map((r) => readable(run.readouts[r.name])),
  ]);
  const k = study.axes.length;
  return table("Runs", heads, rows, [k + 1, ...shown.map((_, i) => k + 3 + i)]);
}
