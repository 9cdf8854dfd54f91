/** What a person sets: preset, seed, sliders, a scenario of one's own. */
import { button, h, select } from "../dom";
import { readable } from "../numbers";
import { laws, now, pascals, type Scenario, type Settings } from "./scenario";
import type { Preset } from "./protocol";

interface Slider {
  path: string;
  name: string;
  unit: string;
  low: number;
  high: number;
  /** Equal steps are equal ratios. */
  ratio: boolean;
  /** Whole numbers. */
  whole?: boolean;
  /** The program's default. */
  usual: number;
}

export const sliders: Slider[] = [
  { path: "ecm.youngs_modulus", name: "Stiffness E", unit: "Pa", low: 10, high: 1000, ratio: true, usual: 200 },
  { path: "actomyosin.force", name: "Contraction F_am", unit: "nN", low: 0.1, high: 3, ratio: true, usual: 0.6 },
  { path: "protrusion.initiation_rate", name: "Initiation r_prot", unit: "1/s", low: 6e-6, high: 6e-4, ratio: true, usual: 6e-5 },
  { path: "protrusion.number", name: "Kept number n_prot", unit: "", low: 0, high: 6, ratio: false, whole: true, usual: 0 },
  { path: "degradation.threshold", name: "Threshold p_th", unit: "Pa", low: 0, high: 100, ratio: false, usual: 20 },
  { path: "fibres.stiffness", name: "Fibres k_0", unit: "Pa", low: 100, high: 20000, ratio: true, usual: 1000 },
];
export const arrangements = ["none", "isotropic", "uniaxial"] as const;

const steps = 200;

const toPlace = ({ low, high, ratio }: Slider, value: number): number =>
  steps * (ratio ? Math.log(value / low) / Math.log(high / low) : (value - low) / (high - low));

function fromPlace({ low, high, ratio, whole }: Slider, place: number): number {
  const share = place / steps;
  const value = ratio ? low * (high / low) ** share : low + share * (high - low);
  return whole ? Math.round(value) : Number(value.toPrecision(2));
}

const stress = (unit: string) => unit === "Pa";

function valueOf(slider: Slider, settings: Settings): number {
  const text = settings[slider.path];
  if (text === undefined) return slider.usual;
  return stress(slider.unit) ? pascals(text) : parseFloat(text.replace(/^"|"$/g, ""));
}

interface Wishes {
  /** A preset begins a new simulation. */
  preset(overrides: string[]): void;
  seed(seed: string): void;
  /** A parameter is to change from now on. */
  set(path: string, value: string): void;
  /** A scenario file of one's own begins a new simulation. */
  toml(text: string): void;
}

function sliderRow(slider: Slider, wishes: Wishes) {
  const shown = h("output", {});
  const say = (value: number) => {
    const text = slider.path === "protrusion.number" && value === 0 ? "by r_prot" : `${readable(value, 3)}${slider.unit ? ` ${slider.unit}` : ""}`;
    shown.textContent = text;
    input.setAttribute("aria-valuetext", text);
  };
  const value = () => fromPlace(slider, Number(input.value));
  const input: HTMLInputElement = h("input", {
    type: "range",
    name: slider.path,
    min: 0,
    max: steps,
    step: slider.whole ? steps / (slider.high - slider.low) : 1,
    oninput: () => say(value()),
    onchange: () => wishes.set(slider.path, slider.unit ? `${value()} ${slider.unit}` : String(value())),
  });
  const show = (settings: Settings) => {
    const set = valueOf(slider, settings);
    input.value = String(toPlace(slider, Math.min(slider.high, Math.max(slider.low, set))));
    say(set);
  };
  return { element: h("label", { class: "slider" }, h("span", {}, slider.name), shown, input), show };
}

export function controls(wishes: Wishes) {
  let list: Preset[] = [];
  const preset = select({ name: "preset" }, [["", "\u2013"]], (value) => {
    const chosen = list.find(({ name }) => name === value);
    if (chosen) wishes.preset(chosen.overrides);
  });
  const whole = { type: "number", min: 0, max: 9007199254740991, step: 1, value: 1 };
  const seed = h("input", { name: "seed", ...whole, onchange: ({ value }) => wishes.seed(value) });
  const rows = sliders.map((slider) => sliderRow(slider, wishes));
  const path = "fibres.arrangement";
  const fibres = select({ name: path }, arrangements.map((one) => [one, one]), (one) => wishes.set(path, one));
  const placeholder = '[ecm]\nyoungs_modulus = "100 Pa"';
  const text = h("textarea", { name: "toml", rows: 8, spellcheck: "false", placeholder, "aria-label": "Scenario as TOML" });
  const use = button("Begin with this scenario", { onclick: () => wishes.toml(text.value) });
  const formulas = laws(wishes.set);
  const choice = (name: string, ...inside: Node[]) => h("label", { class: "choice" }, h("span", {}, name), ...inside);
  const element = h(
    "form",
    { class: "settings", "aria-label": "Settings" },
    h("div", { class: "choices-row" }, choice("Preset", preset), choice("Seed", seed)),
    ...rows.slice(0, 5).map((row) => row.element),
    h("div", { class: "choices-row" }, choice("Fibres", fibres)),
    rows[5].element,
    h("p", { class: "note" }, "A slider acts from now on; preset, seed and what is drawn begin anew."),
    formulas.element,
    h("details", { class: "own" }, h("summary", {}, "A scenario file"), text, use),
  );
  element.addEventListener("submit", (event) => event.preventDefault());
  return {
    element,
    presets(all: Preset[]) {
      list = all;
      preset.append(...all.map(({ name, description }) => h("option", { value: name, title: description }, name)));
    },
    laws: formulas.list,
    /** Shows values as they are.   @param all  every parameter that is not at its default   @param refused  what was asked for before */
    show(all: Settings, scenario: Scenario, refused = false) {
      formulas.show(all, refused);
      for (const row of rows) row.show(all);
      seed.value = all["run.seed"] ?? "1";
      fibres.value = all["fibres.arrangement"] ?? "none";
      text.value = scenario.toml;
      const settings = now(scenario);
      const own = Object.keys(settings).filter((path) => !path.startsWith("run."));
      const same = (one: Preset) =>
        own.length === one.overrides.length &&
        one.overrides.every((o) => settings[o.slice(0, o.indexOf("="))] === o.slice(o.indexOf("=") + 1));
      preset.value = scenario.toml === "" ? (list.find(same)?.name ?? "") : "";
    },
  };
}
