/** Factors by their effect on read-outs and on the discrepancy from targets, and factor sets by discrepancy. */
import type { StudyEffect, StudyPage, StudyReadout } from "./contract";
import { h, table } from "../dom";
import { pretty, readable } from "../numbers";
import { axis, figure, ink, type Json } from "../figure";
import { seriesColour, withUnit } from "./groups";

/** Rows that a plot has room for; the others are in effects.csv. */
const most = 30;
const symbols = ["circle", "square", "diamond", "triangle-up"];

const isMorris = (e: StudyEffect): boolean => e.design === "morris";
const size = (e: StudyEffect): number | null | undefined => (isMorris(e) ? e.mu_star : e.effect);
const bounds = (e: StudyEffect) => (isMorris(e) ? e.mu_star_interval : e.interval) ?? null;
const title = (e: StudyEffect): string => pretty(e.value ? `${e.label} ${e.value}` : e.label);

interface Row {
  name: string;
  effects: StudyEffect[];
  largest: number;
}

/** One row a factor, or a value of it, from the largest effect on. */
function rows(effects: StudyEffect[]): Row[] {
  const byName = new Map<string, Row>();
  for (const e of effects) {
    const name = title(e);
    const row = byName.get(name) ?? { name, effects: [], largest: 0 };
    row.effects.push(e);
    row.largest = Math.max(row.largest, Math.abs(size(e) ?? 0));
    byName.set(name, row);
  }
  return [...byName.values()].sort((a, b) => b.largest - a.largest);
}

const conditionsOf = (effects: StudyEffect[]): string[] => [...new Set(effects.map((e) => e.condition))];

function story(e: StudyEffect, unit: string): string {
  const b = bounds(e);
  const interval = b ? ` (${readable(b[0], 3)} to ${readable(b[1], 3)})` : "";
  const at = e.condition ? `<br>at ${e.condition}` : "";
  const more = isMorris(e)
    ? `<br>mu ${readable(e.mu, 3)}, sigma ${readable(e.sigma, 3)}<br>${e.n} trajectories`
    : `<br>n = ${e.n}`;
  return `${title(e)}${at}<br>${isMorris(e) ? "mu* " : ""}${readable(size(e), 3)}${interval} ${pretty(unit)}${more}`;
}

/** Lengths of bars from each value to its bounds. */
const bars = (values: (number | null | undefined)[], intervals: ([number, number] | null | undefined)[], colour: string): Json => ({
  type: "data",
  symmetric: false,
  array: intervals.map((b, i) => (b ? Math.max(0, b[1] - (values[i] ?? 0)) : 0)),
  arrayminus: intervals.map((b, i) => (b ? Math.max(0, (values[i] ?? 0) - b[0]) : 0)),
  color: colour,
  thickness: 1.6,
  width: 4,
});

const legend = (count: number): Json => ({ showlegend: count > 1, legend: { orientation: "h", y: 1.02, yanchor: "bottom" } });

function ranking(effects: StudyEffect[], readout: StudyReadout, confidence: string): HTMLElement {
  const morris = isMorris(effects[0]);
  const all = rows(effects);
  const shown = all.slice(0, most);
  const conditions = conditionsOf(effects);
  const left = all.length > most ? ` The first ${most} of ${all.length}; all are in effects.csv.` : "";
  const sense = readout.name === "discrepancy" ? "; below 0 is nearer to the targets" : "";
  const what = morris ? "mu*, the mean size of effects over a factor's whole range" : `value less base${sense}`;
  const each = 20 + 9 * (conditions.length - 1);
  return figure(
    `Effect on ${readout.label}: ${what}, with ${confidence} intervals.${left}`,
    84 + each * shown.length + (conditions.length > 1 ? 26 : 0),
    () => {
      const step = 0.7 / conditions.length;
      const data = conditions.map((condition, k): Json => {
        const points = shown.flatMap((row, i) =>
          row.effects.filter((e) => e.condition === condition && size(e) !== null).map((e) => ({ e, y: i + (k - 0.5 * (conditions.length - 1)) * step })),
        );
        const values = points.map((p) => size(p.e));
        return {
          type: "scatter",
          mode: "markers",
          name: condition,
          x: values,
          y: points.map((p) => p.y),
          marker: { color: seriesColour(k), size: 8, symbol: symbols[k % symbols.length] },
          error_x: bars(values, points.map((p) => bounds(p.e)), seriesColour(k)),
          text: points.map((p) => story(p.e, readout.unit)),
          hoverinfo: "text",
        };
      });
      return {
        data,
        layout: {
          ...legend(conditions.length),
          margin: { l: 40, r: 12, t: conditions.length > 1 ? 30 : 8, b: 44 },
          xaxis: axis(withUnit(`${morris ? "mu* of" : "effect on"} ${readout.label}`, readout.unit), {
            zeroline: true,
            zerolinecolor: ink().soft,
            ...(morris ? { rangemode: "tozero" } : {}),
          }),
          yaxis: axis("", {
            tickvals: shown.map((_, i) => i),
            ticktext: shown.map((row) => row.name),
            range: [shown.length - 0.4, -0.6],
            fixedrange: true,
          }),
        },
      };
    },
  );
}

/** mu* against sigma: far right matters, high up depends on the other factors or is not linear. */
function scatter(effects: StudyEffect[], readout: StudyReadout, confidence: string): HTMLElement {
  const conditions = conditionsOf(effects);
  return figure(
    `Effects on ${readout.label}: mu* with its ${confidence} interval, and sigma, their scatter over trajectories. Above the line sigma = mu* a factor acts mostly through others, or not linearly.`,
    380,
    () => {
      const defined = effects.filter((e) => typeof e.mu_star === "number" && typeof e.sigma === "number");
      const end = Math.max(...defined.map((e) => Math.min(e.mu_star_interval?.[1] ?? e.mu_star ?? 0, 2 * (e.mu_star ?? 0))), 0);
      const data = conditions.map((condition, k): Json => {
        const mine = defined.filter((e) => e.condition === condition);
        const values = mine.map((e) => e.mu_star);
        return {
          type: "scatter",
          mode: "markers+text",
          name: condition,
          x: values,
          y: mine.map((e) => e.sigma),
          // Names of factors that do next to nothing would lie on each other.
          text: mine.map((e) => ((e.mu_star ?? 0) > 0.03 * end || (e.sigma ?? 0) > 0.03 * end ? title(e) : "")),
          textposition: "top center",
          textfont: { size: 11 },
          cliponaxis: false,
          marker: { color: seriesColour(k), size: 8, symbol: symbols[k % symbols.length] },
          error_x: bars(values, mine.map((e) => e.mu_star_interval), seriesColour(k)),
          hovertext: mine.map((e) => story(e, readout.unit)),
          hoverinfo: "text",
        };
      });
      data.push({
        type: "scatter",
        mode: "lines",
        x: [0, end],
        y: [0, end],
        line: { color: ink().soft, width: 1, dash: "dot" },
        hoverinfo: "skip",
        showlegend: false,
      });
      return {
        data,
        layout: {
          ...legend(conditions.length),
          margin: { l: 56, r: 24, t: 30, b: 44 },
          xaxis: axis(withUnit("mu*", readout.unit), { rangemode: "tozero" }),
          yaxis: axis(withUnit("sigma", readout.unit), { rangemode: "tozero" }),
        },
      };
    },
  );
}

const percent = (confidence: number): string => `${readable(100 * confidence, 3)} %`;

/** Plots of all read-outs, the discrepancy first. */
export function rankings(study: StudyPage): HTMLElement | null {
  const screening = study.screening;
  if (!screening || screening.effects.length === 0) return null;
  const discrepancy: StudyReadout = { name: "discrepancy", label: "discrepancy", meaning: "", unit: "" };
  const confidence = percent(screening.confidence);
  const figures = [discrepancy, ...study.readouts].flatMap((readout) =>
    (["one_at_a_time", "morris"] as const).flatMap((design) => {
      const effects = screening.effects.filter((e) => e.readout === readout.name && e.design === design);
      if (!effects.some((e) => typeof size(e) === "number")) return [];
      const ranked = ranking(effects, readout, confidence);
      return design === "morris" ? [ranked, scatter(effects, readout, confidence)] : [ranked];
    }),
  );
  if (figures.length === 0) return h("p", {}, "No effect is defined yet: it needs finished runs on both sides of a step.");
  return h("div", { class: "boxes" }, ...figures);
}

export function screeningNote(study: StudyPage): HTMLElement | null {
  const screening = study.screening;
  if (!screening) return null;
  const some = (design: string) => screening.effects.some((e) => e.design === design);
  const parts = [
    some("one_at_a_time")
      ? `One at a time: the read-out with a factor changed less that of the base${screening.paired ? ", replicate by replicate" : ""}.`
      : "",
    some("morris")
      ? "Morris: elementary effects, each as if a factor went through its whole range; mu* is the mean of their sizes, sigma their standard deviation over trajectories. The scatter of replicates is part of both."
      : "",
  ];
  return h("p", { class: "note" }, parts.filter(Boolean).join(" "));
}

/** A z as it is printed, strong where it is beyond two standard errors. */
const distance = (z: number | null): HTMLElement | string =>
  z !== null && Math.abs(z) > 2 ? h("strong", {}, readable(z, 3)) : readable(z, 3);

export function sets(study: StudyPage): HTMLElement | null {
  const screening = study.screening;
  if (!screening || screening.sets.length === 0) return null;
  const label = (name: string) => study.readouts.find((r) => r.name === name)?.label ?? name;
  const heads = screening.targets.map((t) =>
    pretty(`z ${label(t.readout)}${t.condition ? ` at ${t.condition}` : ""}: ${t.target.replace("+-", "\u00b1")}${t.weight === 1 ? "" : `, weight ${readable(t.weight, 3)}`}`),
  );
  const count = screening.targets.length;
  const short = screening.sets.some((set) => set.judged < count || set.undefined > 0);
  const body = screening.sets.map((set) => [
    h("span", {}, pretty(set.label), set.settings && set.settings !== set.label ? h("div", { class: "settings" }, pretty(set.settings)) : null),
    readable(set.discrepancy, 3),
    set.interval ? `${readable(set.interval[0], 3)} to ${readable(set.interval[1], 3)}` : "\u2013",
    `${set.judged} of ${count}`,
    ...(short ? [String(set.undefined)] : []),
    ...set.z.map(distance),
  ]);
  const named = ["factors", "discrepancy", `${percent(screening.confidence)} interval`, "targets judged", ...(short ? ["values not defined"] : [])];
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
