/** Laws that differ from the default ones: both as curves over each argument. */
import type { ChangedLaw } from "../contract";
import { h, s } from "../dom";
import { pretty, ticks } from "../numbers";
import { capital } from "../words";
import { figure, frame, line, type Axis } from "./plots";

const height = 210;
const withUnit = (words: string, unit: string): string => (unit ? `${words} (${pretty(unit)})` : words);
const raised = (exponent: number): string =>
  [...String(exponent)].map((sign) => (sign === "-" ? "\u207b" : "\u2070\u00b9\u00b2\u00b3\u2074\u2075\u2076\u2077\u2078\u2079"[Number(sign)])).join("");

/** The axis of values, and where a value is on it: rates above zero by their logarithm, which shows the small ones too. */
function scale(words: string, unit: string, values: number[]): { axis: Axis; at: (value: number) => number } {
  const [low, high] = [Math.min(...values), Math.max(...values)];
  if (unit === "1/s" && low > 0) {
    const room = 0.06 * Math.log10(high / low) || 0.5; // of a constant half a decade
    const [from, to] = [Math.log10(low) - room, Math.log10(high) + room];
    const decades = ticks(from, to, 5, Math.max(1, Math.ceil((to - from) / 5)));
    if (decades.length > 2) {
      const text = (v: number) => `10${raised(v)}`;
      return { axis: { low: from, high: to, label: withUnit(words, unit), ticks: decades, text }, at: Math.log10 };
    }
    const whole = Math.floor(Math.log10(low) + 1e-9); // in the unit, so that numbers at the ticks are short
    const parts = ticks(Math.floor(from), Math.ceil(to), 9, 1).flatMap((k) => [1, 2, 3, 5].map((m) => k + Math.log10(m))).filter((v) => v >= from && v <= to);
    const label = withUnit(words, `10${raised(whole)}/s`);
    return { axis: { low: from, high: to, label, ticks: parts, text: (v: number) => String(Number((10 ** (v - whole)).toPrecision(2))) }, at: Math.log10 };
  }
  const top = 1.06 * (Math.max(0, high) || 1);
  const exponent = top < 0.1 || top > 5000 ? Math.floor(Math.log10(top)) : 0; // short numbers at the ticks
  const inUnit = exponent === 0 ? unit : `10${raised(exponent)}${unit.startsWith("1/") ? unit.slice(1) : unit && ` ${unit}`}`;
  const end = top / 10 ** exponent;
  return { axis: { low: 0, high: end, label: withUnit(words, inUnit), ticks: ticks(0, end, 4) }, at: (value) => value / 10 ** exponent };
}

function curve(words: string, law: ChangedLaw, of: ChangedLaw["curves"][number], width: number): SVGSVGElement {
  const { axis, at } = scale(words, law.unit, [...of.changed, ...of.usual].filter((v) => v !== null));
  const shown = (all: (number | null)[]) => all.map((v) => (v === null ? null : at(v)));
  const [left, right] = [of.x[0], of.x[of.x.length - 1]];
  const made = frame(
    width,
    height,
    { low: left, high: right, label: withUnit(of.over, of.unit), ticks: ticks(left, right, 6) },
    axis,
    `${capital(words)} over ${of.over}`,
  );
  made.svg.append(
    s("path", { class: "curve of-default", d: line(made, of.x, shown(of.usual)) }, s("title", {}, "by default")),
    s("path", { class: "curve", d: line(made, of.x, shown(of.changed)) }, s("title", {}, "here")),
  );
  return made.svg;
}

export function laws(all: ChangedLaw[], width: number): HTMLElement {
  const columns = width > 800 ? 2 : 1;
  const column = Math.floor((width - 32 * (columns - 1)) / columns);
  return h("div", {}, ...all.flatMap((law) => {
    const words = law.name.slice(law.name.indexOf(".") + 1).replaceAll("_", " ");
    return [
      h("h3", {}, `${capital(words)}: `, h("code", {}, law.text), law.constants ? h("span", {}, " where ", h("code", {}, law.constants)) : ""),
      h("div", { class: "plots", style: `grid-template-columns:repeat(${columns},minmax(0,1fr))` }, ...law.curves.map((of) =>
        figure(curve(words, law, of, column), `Over ${of.over}${of.at ? `, at ${pretty(of.at)}` : ""}. The dashed curve is the default law.`))),
    ];
  }));
}
