/** The laws of the model as formulas, to be changed while the cell moves. */
import { h } from "../dom";
import { pretty } from "../numbers";
import type { Law } from "./protocol";
import type { Settings } from "./scenario";

interface Laws {
  element: HTMLElement;
  /** What there is to change. */
  list(all: Law[]): void;
  /** @param refused  a formula that cannot be is still to be read, and mended */
  show(settings: Settings, refused: boolean): void;
}

/** "Eq. 5: stiffness of a fibre over k_0 (eps)": the first clause of the meaning, which goes on with the arguments. */
export function nameOf({ meaning, unit, arguments: names }: Law): string {
  const clause = /^(?:Eq\. \d+: )?.*?(?=[.:;] |$)/.exec(meaning)?.[0] ?? meaning;
  return `${clause} (${names.join(", ")})${unit ? `, ${pretty(unit)}` : ""}`;
}

/** @param set  a law is to be another from now on */
export function laws(set: (path: string, formula: string) => void): Laws {
  const rows = h("div", { class: "laws" });
  const element = h("details", { class: "formulas" }, h("summary", {}, "Laws as formulas"), rows, h("p", { class: "note" }, "Enter takes a formula; an empty one is the paper's. Lengths in \u00b5m, times in s, forces in nN, stresses in Pa."));
  const inputs: { law: Law; input: HTMLInputElement }[] = [];
  return {
    element,
    list(all) {
      for (const law of all) {
        const input = h("input", { type: "text", name: law.path, spellcheck: "false", autocomplete: "off", placeholder: law.formula, title: pretty(law.meaning) });
        input.addEventListener("change", () => set(law.path, input.value.trim() || law.formula));
        inputs.push({ law, input });
        rows.append(h("label", {}, h("span", {}, pretty(nameOf(law))), input));
      }
    },
    show(settings, refused) {
      for (const { law, input } of inputs) {
        const formula = settings[law.path] ?? law.formula;
        const wrong = refused && input.value.trim() !== "" && input.value !== formula;
        if (!wrong) input.value = formula;
        input.setAttribute("aria-invalid", String(wrong));
      }
    },
  };
}
