/** What stands on axes, in legends and in captions: words of the program's tables, the paper's symbol and the unit. Python's `draw/words.py` says the same. */
import { pretty } from "./numbers";

interface Named {
  /** Code name: key of a read-out, or path of a parameter. */
  name: string;
  /** Symbol, or the end of the code name where there is none. */
  label: string;
  /** A sentence. */
  meaning?: string;
  unit: string;
}

const greek: Record<string, string> = {
  eta: "\u03b7", gamma: "\u03b3", zeta: "\u03b6", kappa: "\u03ba", mu: "\u03bc", nu: "\u03bd", tau: "\u03c4", eps: "\u03b5",
};
const letter = `(?:${Object.keys(greek).join("|")}|[A-Za-z])`;
/** "f_mat", "tau_prot", "r_off,min"; not counts such as n_protrusions. */
const symbolPattern = new RegExp(`(?<![\\w.])(?!n_(?!prot\\b))(${letter})_([A-Za-z0-9]+(?:[_,][A-Za-z0-9]+)*)(?![\\w.])`, "g");

const marks = /[\ue000\ue001]/g;
/** Text of the user within text of the program: in plots and on pages it stands as it is. */
export const verbatim = (text: string): string => `\ue000${text.replace(marks, "")}\ue001`;
/** Without the marks of `verbatim`: where nothing is typeset, as in lists to choose from. */
export const unmarked = (text: string): string => text.replace(marks, "");

type Part = string | { sign: string; below: string };

/** The parts of a text: its plain ones, and a symbol with what stands below. */
function parts(text: string): Part[] {
  return text.split(/\ue000([^\ue001]*)\ue001/).flatMap((stretch, i): Part[] => {
    if (i % 2) return [stretch];
    const found: Part[] = [];
    let end = 0;
    for (const match of stretch.matchAll(symbolPattern)) {
      found.push(stretch.slice(end, match.index), { sign: greek[match[1]] ?? match[1], below: match[2].replaceAll("_", ",") });
      end = match.index + match[0].length;
    }
    return [...found, stretch.slice(end)];
  });
}

/** What plotly would take for marks and for values of its templates, as text. */
const literal = (text: string): string => text.replaceAll("&", "&amp;").replaceAll("<", "&lt;").replaceAll("%{", "%&#123;");

/** For plots: symbols with their index below the line, everything else as it stands. */
export const typeset = (text: string): string =>
  parts(text).map((part) => (typeof part === "string" ? literal(part) : `${part.sign}<sub>${part.below}</sub>`)).join("");

/** The same for a page. */
export const lettered = (text: string): (string | HTMLElement)[] =>
  parts(text).flatMap((part) => {
    if (typeof part === "string") return part ? [part] : [];
    const below = document.createElement("sub");
    below.textContent = part.below;
    return [part.sign, below];
  });

/** The paper's symbol as it is typed, "f_mat"; "" if there is none. */
export function symbolOf({ name, label }: Named): string {
  if (name.includes(".") && label.startsWith(name)) return /\((\S+)\)$/.exec(label)?.[1].replace(/^[a-z]+$/, (name) => greek[name] ?? name) ?? "";
  if (new RegExp(`^${symbolPattern.source}$`).test(label)) return label;
  return name.includes(".") && !name.endsWith(`.${label}`) ? (greek[label] ?? label) : "";
}

/** A noun for a thing whose meaning is a sentence: its first clause; of a rule or a law the words of its name. */
export function wordsOf(one: Named): string {
  const clause = (one.meaning ?? "").split(/[;:,(]/)[0].trim();
  if (one.name.startsWith("laws.constants.")) return one.name.slice("laws.constants.".length);
  if (!one.name.includes(".")) return one.meaning || one.label.replaceAll("_", " ");
  if (clause && clause.length <= 60 && !one.name.startsWith("laws.") && !/^(The|With|Two|A|Whether|How|Which|What) /.test(clause)) return lower(clause);
  const [section, key] = [one.name.slice(0, one.name.lastIndexOf(".")), one.name.slice(one.name.lastIndexOf(".") + 1)];
  return `${section}: ${key}`.replaceAll("_", " ").replaceAll(".", " ");
}

/** Within a sentence: names of people stay. */
const lower = (text: string): string => (/^(Young|Poisson|Kelvin|x |y )/.test(text) ? text : `${text[0].toLowerCase()}${text.slice(1)}`);
export const capital = (text: string): string => `${text[0]?.toUpperCase() ?? ""}${text.slice(1)}`;

/** "speed, start to end, v_migr,abs (\u00b5m/h)" */
export function titleOf(one: Named): string {
  const words = [...new Set([wordsOf(one), symbolOf(one)].filter(Boolean))].join(", ");
  return `${words}${one.unit && one.unit !== "-" ? ` (${pretty(one.unit)})` : ""}`;
}

/** A value of a parameter as a legend names it: "E = 50 Pa"; without a symbol by words. */
export function settingOf(one: Named, value: number | string): string {
  const symbol = symbolOf(one);
  return `${symbol ? `${symbol} =` : wordsOf(one)} ${typeof value === "string" ? verbatim(value) : value}${one.unit ? ` ${pretty(one.unit)}` : ""}`;
}

/** Text for a regular expression that finds it. */
const found = (text: string): string => text.replace(/[.*+?^${}()|[\]\\]/g, "\\$&");

/**
 * A sentence of the program about points and read-outs, as plots name them. It calls settings by code names ("E = 50 Pa" here), read-outs by
 * their labels, "(v_migr_abs)", and points by what their author calls them, which stays.
 */
export function said(text: string, axes: (Named & { values: (number | string)[] })[], readouts: Named[]): string {
  const shown = new Map<string, string>(); // by what stands there
  for (const axis of axes)
    for (const value of axis.values)
      if (!axis.name.includes(".")) shown.set(String(value), verbatim(String(value)));
      else
        for (const name of [axis.name, axis.name.slice(axis.name.lastIndexOf(".") + 1), symbolOf(axis)])
          if (name) shown.set(`${name} ${value}${axis.unit ? ` ${axis.unit}` : ""}`, settingOf(axis, value));
  const longestFirst = [...shown.keys()].filter(Boolean).sort((a, b) => b.length - a.length).map((one) => `(?<![\\w.])${found(one)}(?!\\w|\\.\\d)`);
  for (const one of readouts) shown.set(` (${one.label})`, symbolOf(one) ? ` (${symbolOf(one)})` : "");
  const patterns = [...longestFirst, ...readouts.map((one) => found(` (${one.label})`))];
  if (patterns.length === 0) return pretty(text);
  return text.split(new RegExp(`(${patterns.join("|")})`)).map((part, i) => (i % 2 ? shown.get(part) : pretty(part))).join("");
}

/** The unit of a label of the program, "force [nN]", as axes have it: "force (nN)"; none of a ratio. */
export const units = (label: string): string => pretty(label.replace(/ \[-\]$/, "").replace(/ \[([^\][]+)\]$/, " ($1)"));

/** Lines of at most some letters; marks of what is typeset are none. */
export function wrapped(text: string, letters: number): string {
  const length = (line: string) => line.replace(/<[^>]*>/g, "").length;
  const lines = [""];
  for (const word of text.split(" ")) {
    const last = lines.length - 1;
    if (lines[last] && length(`${lines[last]} ${word}`) > letters) lines.push(word);
    else lines[last] += (lines[last] ? " " : "") + word;
  }
  return lines.join("\n");
}
