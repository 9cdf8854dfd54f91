/** What is simulated: a scenario, settings on top of it, what was drawn, and what changed on the way. */
import { h } from "../dom";
import { fromBase64 } from "../embedded";
import { pretty } from "../numbers";
import type { Given, Law } from "./protocol";

/** A line drawn by a brush: points x0, y0, x1, y1, ... [um]. */
export interface Stroke {
  kind: StrokeKind;
  radius: number;
  points: number[];
}

interface BrushKind {
  name: string;
  colour: string;
  field: FieldKey;
  /** From the value of the field elsewhere. */
  value: (elsewhere: number) => number;
  /** What the model needs so that the cell takes notice of it, unless the scenario says otherwise. */
  needs?: Settings;
  /** Where protrusions then begin, as a law. */
  bias?: string;
}

/** What a brush makes of a field of the matrix. */
const kinds = {
  soft: { name: "Soft spot", colour: "#56b4e9", field: "youngs_modulus", value: (E: number) => 0.25 * E },
  stiff: { name: "Stiff spot", colour: "#7a3e9d", field: "youngs_modulus", value: (E: number) => 4 * E },
  hole: { name: "Hole", colour: "#009e73", field: "f_degr", value: () => 0 },
  obstacle: { name: "Obstacle", colour: "#3d4248", field: "obstacle", value: () => 1 },
  bare: { name: "No ligand", colour: "#d55e00", field: "ligand", value: () => 0 },
  rich: { name: "Twice the ligand", colour: "#cc79a7", field: "ligand", value: () => 2, bias: "exp(4*ligand)" },
  attractant: {
    name: "Source of attractant",
    colour: "#e69f00",
    field: "attractant_source",
    value: () => 0.1,
    // Those of the preset attractant-source.
    needs: { "cues.diffusion": "10 um^2/s", "cues.decay": "1e-3 1/s", "cues.uptake": "0.01 1/s" },
    bias: "exp(20*occupancy)",
  },
} satisfies Record<string, BrushKind>;
export type StrokeKind = keyof typeof kinds;
export const brushes: Record<StrokeKind, BrushKind> = kinds;

/** Fields that are drawn: the column of the file, and the value where nothing is drawn, of Young's modulus that of the scenario. */
const fields = {
  youngs_modulus: { column: "E_Pa", elsewhere: null },
  f_degr: { column: "f_degr", elsewhere: 1 },
  obstacle: { column: "obstacle", elsewhere: 0 },
  ligand: { column: "ligand", elsewhere: 1 },
  attractant_source: { column: "attractant_source_per_s", elsewhere: 0 },
};
type FieldKey = keyof typeof fields;
export const fieldKeys = Object.keys(fields) as FieldKey[];

/** Settings by parameter, as after --set. */
export type Settings = Record<string, string>;

export interface Change {
  /** [s] */
  t: number;
  overrides: string[];
}

export interface Scenario {
  /** A scenario file; "" for the program's defaults. */
  toml: string;
  settings: Settings;
  strokes: Stroke[];
  changes: Change[];
}

/** As `matrigrate new` writes it: with the adaptive integrator. */
const usual: Settings = { "run.integrator": "adaptive" };

export const settingsOf = (overrides: string[]): Settings =>
  Object.fromEntries(overrides.map((one) => [one.slice(0, one.indexOf("=")), one.slice(one.indexOf("=") + 1)]));

/** @param overrides  of a preset */
export function fresh(overrides: string[] = [], seed = "1"): Scenario {
  return { toml: "", settings: { ...usual, ...settingsOf(overrides), "run.seed": seed }, strokes: [], changes: [] };
}

const distance = (x: number, y: number, ax: number, ay: number, bx: number, by: number): number => {
  const [dx, dy] = [bx - ax, by - ay];
  const length = dx * dx + dy * dy;
  const share = length > 0 ? Math.max(0, Math.min(1, ((x - ax) * dx + (y - ay) * dy) / length)) : 0;
  return Math.hypot(x - ax - share * dx, y - ay - share * dy);
};

export function covers({ points, radius }: Stroke, x: number, y: number): boolean {
  if (points.length === 2) return Math.hypot(x - points[0], y - points[1]) <= radius;
  for (let k = 0; k + 3 < points.length; k += 2)
    if (distance(x, y, points[k], points[k + 1], points[k + 2], points[k + 3]) <= radius) return true;
  return false;
}

/** "200 Pa", "0.2 kPa" or a bare number in Pa. */
export function pascals(text: string): number {
  const found = /^\s*([-+0-9.eE]+)\s*(Pa|kPa|MPa)?\s*$/.exec(text.replace(/^"|"$/g, ""));
  return found ? Number(found[1]) * { Pa: 1, kPa: 1e3, MPa: 1e6 }[found[2] ?? "Pa"]! : NaN;
}

/** A grid of values at the places of the matrix particles, so that each of them gets exactly the value drawn there. */
function grid(strokes: Stroke[], key: FieldKey, base: number, radius: number, spacing: number): string {
  const lines = [`x_um,y_um,${fields[key].column}`];
  const n = Math.ceil(radius / spacing);
  for (let j = -n; j <= n; ++j)
    for (let i = -n; i <= n; ++i) {
      const [x, y] = [i * spacing, j * spacing];
      const over = strokes.findLast((stroke) => covers(stroke, x, y));
      lines.push(`${x},${y},${over ? Number(brushes[over.kind].value(base).toPrecision(12)) : base}`);
    }
  return `${lines.join("\n")}\n`;
}

export interface Ground {
  /** Of the uniform matrix [Pa]. */
  youngs_modulus: number;
  /** [um] */
  radius: number;
  spacing: number;
  /** Parameters that the scenario sets. */
  set: Settings;
}

/** The files of what was drawn. */
export function drawnFiles(strokes: Stroke[], ground: Ground): Record<string, string> {
  const files: Record<string, string> = {};
  for (const key of fieldKeys) {
    const own = strokes.filter((stroke) => brushes[stroke.kind].field === key);
    const base = fields[key].elsewhere ?? ground.youngs_modulus;
    if (own.length > 0) files[`${key}.csv`] = grid(own, key, base, ground.radius, ground.spacing);
  }
  return files;
}

/** For the core. */
export function given(scenario: Scenario, ground: Ground): Given {
  const files = drawnFiles(scenario.strokes, ground);
  const drawn = fieldKeys.flatMap((key) => (`${key}.csv` in files ? `ecm.fields.${key}=/${key}.csv` : []));
  const needs: Settings = Object.assign({}, ...scenario.strokes.map(({ kind }) => brushes[kind].needs ?? {}));
  const biases = new Set(scenario.strokes.flatMap(({ kind }) => brushes[kind].bias ?? []));
  if (biases.size > 0) needs["laws.initiation_bias"] = [...biases].join(" * ");
  const missing = Object.entries(needs).filter(([path]) => !(path in ground.set));
  const settings = [...missing, ...Object.entries(scenario.settings)].map(([path, value]) => `${path}=${value}`);
  return { toml: scenario.toml, overrides: [...settings, ...drawn], files };
}

/** The settings as they are after all changes on the way. */
export function now(scenario: Scenario): Settings {
  return Object.assign({}, scenario.settings, ...scenario.changes.map(({ overrides }) => settingsOf(overrides))) as Settings;
}

const short = (v: number): number => Number(v.toFixed(1));

/** The scenario of an address, behind the #. Later changes are not in a link: it starts at the beginning. */
export function toHash({ toml, settings, strokes }: Scenario): string {
  const data = {
    v: 1,
    ...(toml ? { toml } : {}),
    set: settings,
    ...(strokes.length > 0 ? { draw: strokes.map(({ kind, radius, points }) => [kind, radius, ...points.map(short)]) } : {}),
  };
  const bytes = new TextEncoder().encode(JSON.stringify(data));
  let binary = "";
  for (const byte of bytes) binary += String.fromCharCode(byte);
  return `#scenario=${btoa(binary).replace(/\+/g, "-").replace(/\//g, "_").replace(/=+$/, "")}`;
}

/** What is wrong with a scenario of an address, in words for a person. */
class WrongScenario extends Error {}

/** null without a scenario. @throws Error saying what is wrong with it */
export function fromHash(hash: string): Scenario | null {
  const found = /^#scenario=(.*)$/.exec(hash);
  if (!found) return null;
  try {
    const bytes = fromBase64(found[1].replace(/-/g, "+").replace(/_/g, "/"));
    const text = new TextDecoder("utf-8", { fatal: true }).decode(bytes);
    const data = JSON.parse(text) as { v?: unknown; toml?: unknown; set?: unknown; draw?: unknown };
    if (data.v !== 1) throw new WrongScenario(`its version is ${String(data.v)}, and this page knows version 1`);
    const settings = Object.entries((data.set ?? {}) as object).map(([k, v]) => [k, String(v)]);
    const strokes = ((data.draw ?? []) as [StrokeKind, ...number[]][]).map(([kind, radius, ...points]): Stroke => {
      const numbers = [radius, ...points];
      if (!(kind in brushes) || points.length < 2 || points.length % 2 !== 0 || !numbers.every(Number.isFinite))
        throw new WrongScenario("something drawn in it cannot be read");
      return { kind, radius, points };
    });
    return { toml: typeof data.toml === "string" ? data.toml : "", settings: Object.fromEntries(settings) as Settings, strokes, changes: [] };
  } catch (reason) {
    const why = reason instanceof WrongScenario ? reason.message : "a part of it is missing or was changed; copy the whole link once more";
    throw new Error(`The address holds a scenario that cannot be read: ${why}.`);
  }
}

// The laws of the model as formulas, to be changed while the cell moves.

/** "Eq. 5: stiffness of a fibre over k_0 (eps)": the first clause of the meaning, which goes on with the arguments. */
export function nameOf({ meaning, unit, arguments: names }: Law): string {
  const clause = /^(?:Eq\. \d+: )?.*?(?=[.:;] |$)/.exec(meaning)?.[0] ?? meaning;
  return `${clause} (${names.join(", ")})${unit ? `, ${pretty(unit)}` : ""}`;
}

/** What a user writes beside the formulas: names for their numbers, each with its unit. */
const constants = { path: "laws.constants", formula: "" };

/** @param set  a law, or the constants, are to be another from now on */
export function laws(set: (path: string, formula: string) => void) {
  const rows = h("div", { class: "laws" });
  const note = "Enter takes a formula; an empty one is the paper's. Lengths in \u00b5m, times in s, forces in nN, stresses in Pa.";
  const summary = h("summary", {}, "Laws as formulas");
  const element = h("details", { class: "formulas" }, summary, rows, h("p", { class: "note" }, note));
  const inputs: { law: typeof constants; input: HTMLInputElement }[] = [];
  const row = (law: typeof constants, name: string, title: string, placeholder = law.formula) => {
    const text = { type: "text", spellcheck: "false", autocomplete: "off", placeholder, title };
    const onchange = ({ value }: HTMLInputElement) => set(law.path, value.trim() || law.formula);
    const input = h("input", { ...text, name: law.path, onchange });
    inputs.push({ law, input });
    rows.append(h("label", {}, h("span", {}, name), input));
  };
  return {
    element,
    /** What there is to change. */
    list(all: Law[]) {
      row(constants, "Constants of your own, first", "Names that the formulas below may use", "F_c = 0.05 nN, n = 2");
      for (const law of all) row(law, pretty(nameOf(law)), pretty(law.meaning));
    },
    /** @param refused  a formula that cannot be is still to be read, and mended */
    show(settings: Settings, refused: boolean) {
      for (const { law, input } of inputs) {
        const formula = settings[law.path] ?? law.formula;
        const wrong = refused && input.value.trim() !== "" && input.value !== formula;
        if (!wrong) input.value = formula;
        input.setAttribute("aria-invalid", String(wrong));
      }
    },
  };
}
