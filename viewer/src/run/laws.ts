/** Laws that differ from the default ones: both as curves over each argument. */
import type { ChangedLaw } from "../contract";
import { h, s } from "../dom";
import { pretty, ticks } from "../numbers";
import { capital } from "../words";
import { figure, frame, line } from "./plots";

const height = 210;
const withUnit = (words: string, unit: string): string => (unit ? `${words} (${pretty(unit)})` : words);
const raised = (exponent: number): string =>
  [...String(exponent)].map((sign) => (sign === "-" ? "\u207b" : "\u2070\u00b9\u00b2\u00b3\u2074\u2075\u2076\u2077\u2078\u2079"[Number(sign)])).join("");

function curve(words: string, law: ChangedLaw, of: ChangedLaw["curves"][number], width: number): SVGSVGElement {
  const values = [...of.changed, ...of.usual].filter((v) => v !== null);
  const high = 1.06 * (values.reduce((a, b) => Math.max(a, b), 0) || 1);
  const exponent = high < 0.1 || high > 5000 ? Math.floor(Math.log10(high)) : 0; // short numbers at the ticks
  const shown = (all: (number | null)[]) => all.map((v) => v && v / 10 ** exponent);
  const unit = exponent === 0 ? law.unit : `10${raised(exponent)}${law.unit.startsWith("1/") ? law.unit.slice(1) : law.unit && ` ${law.unit}`}`;
  const [left, right] = [of.x[0], of.x[of.x.length - 1]];
  const made = frame(
    width,
    height,
    { low: left, high: right, label: withUnit(of.over, of.unit), ticks: ticks(left, right, 6) },
    { low: 0, high: high / 10 ** exponent, label: withUnit(words, unit), ticks: ticks(0, high / 10 ** exponent, 4) },
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
      h("h3", {}, `${capital(words)}: `, h("code", {}, law.text)),
      h("div", { class: "plots", style: `grid-template-columns:repeat(${columns},minmax(0,1fr))` }, ...law.curves.map((of) =>
        figure(curve(words, law, of, column), `Over ${of.over}${of.at ? `, at ${pretty(of.at)}` : ""}. The dashed curve is the default law.`))),
    ];
  }));
}
