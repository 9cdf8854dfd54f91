/** Sets of parameters by their discrepancy from targets. */
import type { StudyPage } from "./contract";
import { h, table } from "../dom";
import { readable } from "../numbers";
import { lettered, said, titleOf } from "../words";

const percent = (confidence: number): string => `${readable(100 * confidence, 3)} %`;

/** A z as it is printed, strong where it is beyond two standard errors. */
const distance = (z: number | null): HTMLElement | string =>
  z !== null && Math.abs(z) > 2 ? h("strong", {}, readable(z, 3)) : readable(z, 3);

export function sets(study: StudyPage): HTMLElement | null {
  const found = study.discrepancy;
  if (!found) return null;
  const titled = (name: string) => titleOf(study.readouts.find((r) => r.name === name) ?? { name, label: name, unit: "" });
  const target = (text: string) => text.replace("+-", "\u00b1").replace(/-?\d+\.\d{4,}(e-?\d+)?/g, (digits) => readable(Number(digits)));
  const heads = found.targets.map(
    (t) => `z of ${titled(t.readout)}${t.condition ? ` at ${t.condition}` : ""}, target ${target(t.target)}${t.weight === 1 ? "" : `, weight ${readable(t.weight, 3)}`}`,
  );
  const words = (text: string) => h("span", {}, ...lettered(said(text, study.axes, study.readouts)));
  const count = found.targets.length;
  const short = found.sets.some((set) => set.judged < count || set.undefined > 0);
  const body = found.sets.map((set) => [
    h("span", {}, words(set.label), set.settings && set.settings !== set.label ? h("div", { class: "settings" }, words(set.settings)) : null),
    readable(set.discrepancy, 3),
    set.interval ? `${readable(set.interval[0], 3)} to ${readable(set.interval[1], 3)}` : "\u2013",
    `${set.judged} of ${count}`,
    ...(short ? [String(set.undefined)] : []),
    ...set.z.map(distance),
  ]);
  const named = ["parameters", "discrepancy", `${percent(found.confidence)} interval`, "targets judged", ...(short ? ["values not defined"] : [])];
  return h(
    "div",
    {},
    h(
      "p",
      { class: "note" },
      "Discrepancy: D = \u221a(\u03a3 w z\u00b2 / \u03a3 w) over targets, z = (our mean \u2212 target) / \u221a(error\u00b2 + our standard error\u00b2), 0 within a range and counted from its nearer end outside. Its interval is by the bootstrap over replicates. A target with fewer than two finished runs that have a value is not judged; sets that all targets judge come first. Strong: |z| > 2.",
    ),
    table([...named, ...heads], body, {
      caption: "Sets of parameters by discrepancy",
      numeric: [...named, ...heads].map((_, i) => i).slice(1),
    }),
  );
}
