/** Factor sets by their discrepancy from targets. */
import type { StudyPage } from "./contract";
import { h, table } from "../dom";
import { pretty, readable } from "../numbers";

const percent = (confidence: number): string => `${readable(100 * confidence, 3)} %`;

/** A z as it is printed, strong where it is beyond two standard errors. */
const distance = (z: number | null): HTMLElement | string =>
  z !== null && Math.abs(z) > 2 ? h("strong", {}, readable(z, 3)) : readable(z, 3);

export function sets(study: StudyPage): HTMLElement | null {
  const found = study.discrepancy;
  if (!found) return null;
  const label = (name: string) => study.readouts.find((r) => r.name === name)?.label ?? name;
  const heads = found.targets.map((t) =>
    pretty(`z ${label(t.readout)}${t.condition ? ` at ${t.condition}` : ""}: ${t.target.replace("+-", "\u00b1")}${t.weight === 1 ? "" : `, weight ${readable(t.weight, 3)}`}`),
  );
  const count = found.targets.length;
  const short = found.sets.some((set) => set.judged < count || set.undefined > 0);
  const body = found.sets.map((set) => [
    h("span", {}, pretty(set.label), set.settings && set.settings !== set.label ? h("div", { class: "settings" }, pretty(set.settings)) : null),
    readable(set.discrepancy, 3),
    set.interval ? `${readable(set.interval[0], 3)} to ${readable(set.interval[1], 3)}` : "\u2013",
    `${set.judged} of ${count}`,
    ...(short ? [String(set.undefined)] : []),
    ...set.z.map(distance),
  ]);
  const named = ["factors", "discrepancy", `${percent(found.confidence)} interval`, "targets judged", ...(short ? ["values not defined"] : [])];
  return h(
    "div",
    {},
    h(
      "p",
      { class: "note" },
      "Discrepancy: D = \u221a(\u03a3 w z\u00b2 / \u03a3 w) over targets, z = (our mean \u2212 target) / \u221a(error\u00b2 + our standard error\u00b2), 0 within a range and counted from its nearer end outside. Its interval is by the bootstrap over replicates. A target with fewer than two finished runs that have a value is not judged; sets that all targets judge come first. Strong: |z| > 2.",
    ),
    table([...named, ...heads], body, {
      caption: "Factor sets by discrepancy",
      numeric: [...named, ...heads].map((_, i) => i).slice(1),
    }),
  );
}
