/** The five questions of docs/lesson.md: links that begin them, also without a network. */
import { h } from "../dom";
import { fromBase64, inflate } from "../embedded";
import type { Preset } from "./protocol";
import { fresh, toHash } from "./scenario";

/** Test: tests/docs/test_lesson.py compares them with the sheet. */
export const questions: { ask: string; preset: string; then: string }[] = [
  { ask: "Is a cell faster on soft or on stiff ground?", preset: "soft", then: "Begins with 50 Pa. Then set Stiffness E to 200 Pa and to 400 Pa." },
  { ask: "Does a cell with more legs run faster?", preset: "one-protrusion", then: "Begins with one protrusion. Then set Kept number n_prot to 2, 3 and 4." },
  { ask: "Does it help to pull harder?", preset: "weak-contraction", then: "Begins with 0.2 nN. Then set Contraction F_am to 0.6 nN and to 1 nN." },
  { ask: "Do fibres show a cell the way?", preset: "two-protrusions-fibres", then: "Begins among fibres along x. Then choose the preset two-protrusions." },
  { ask: "How much of it is chance?", preset: "baseline", then: "Begins with seed 1. Then take other seeds." },
];

export function lesson() {
  const list = h("ol", {});
  const note = "Let each run for six hours: distance and speed from the start come into the table of results, which can be saved. After a slider press Reset, and play.";
  const summary = h("summary", {}, "A lesson: five questions");
  const presets = (all: Preset[]) => {
    const link = (preset: string) => toHash(fresh(all.find(({ name }) => name === preset)?.overrides));
    const items = questions.map(({ ask, preset, then }) => [h("a", { href: link(preset) }, ask), h("p", { class: "note" }, then)]);
    list.replaceChildren(...items.map((inside) => h("li", {}, ...inside)));
  };
  return { element: h("details", { class: "lesson" }, summary, list, h("p", { class: "note" }, note)), presets };
}

// Which version the page is of, and the licences of what it contains.

const unpacked = async (text: string): Promise<string> => new TextDecoder().decode(await inflate(fromBase64(text.trim()))).trim();

export function about(): HTMLElement {
  const text = document.getElementById("matrigrate-notices")?.textContent?.trim() ?? "";
  const end = text.indexOf("\n");
  const version = end < 0 ? "Matrigrate" : text.slice(0, end).replace(/(?<=commit [0-9a-f]{10})[0-9a-f]+/, "");
  const pre = h("pre", {});
  // The text is long: it is compressed, and laid out only where it is read.
  const ontoggle = async ({ open }: HTMLDetailsElement) => {
    pre.textContent = open ? await unpacked(text.slice(end + 1)).catch(String) : "";
  };
  const words = `${version}. This page is one file: it asks no network, and may be copied and given away.`;
  const summary = h("summary", {}, "Licences of what this page contains");
  return h("footer", {}, h("p", {}, words), h("details", { class: "licences", ontoggle }, summary, pre));
}
