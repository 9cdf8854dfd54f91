/** Beside the stage: what the matrix is coloured by, what is drawn over it, and the legend of both. */
import { choice, h, isDark, onDarkMode, onPrint, select } from "../dom";
import type { ArrowKind } from "./over/arrows";
import { edgeBar, edges, type Edge } from "./over/edge";
import { extremes, overlays } from "./matrix/layers";
import { bareBar, colourBar, signs, smallBar } from "./legend";
import { scaleControls } from "./scale_controls";
import type { Stage } from "./stage";

const ordinal = (n: number): string => (n === 2 ? "second" : n === 3 ? "third" : `${n}th`);

/** The matrix as a field, or as the particles that it is computed by. */
function styleChoice(stage: Stage): HTMLElement {
  const radio = (value: string, name: string, smooth: boolean) =>
    choice({ type: "radio", name: "style", value, checked: stage.smooth === smooth }, name, () => {
      stage.smooth = smooth;
      stage.draw();
    }).label;
  const radios = [radio("smooth", "Smooth field", true), radio("particles", "Particles", false)];
  return h("div", { class: "choices style", role: "group", "aria-label": "Draw the matrix as" }, ...radios);
}

/** What colours the edge of the cell and, once something does, its colour bar. */
function edgeChoice(all: Edge[], chosen: (edge: Edge) => void): HTMLElement {
  const bar = h("div");
  const options = all.map(({ key, name }): [string, string] => [key, name]);
  const choose = (key: string) => {
    const edge = all.find((one) => one.key === key) ?? all[0];
    bar.replaceChildren(...(edge.field ? bareBar(edgeBar(edge)) : []));
    chosen(edge);
  };
  return h("div", { class: "edge" }, h("label", {}, "Edge of the cell: ", select({ name: "edge" }, options, choose)), bar);
}

/** Which arrows are drawn, and what they show, where they are. */
function arrowChoice(stage: Stage): HTMLElement {
  const note = h("p", { class: "note", "aria-live": "polite" });
  const kinds = ["displacement", "velocity"].map((kind): [string, string] => [kind, kind]);
  const arrows = select({ name: "arrow-kind" }, kinds, (kind) => {
    stage.arrows = kind as ArrowKind;
    refresh();
    stage.draw();
  });
  const element = h("div", { class: "edge" }, h("label", {}, "Arrows show: ", arrows), note);
  const refresh = () => {
    const times = stage.arrowScale();
    const length = times === 1 ? "at true length" : `drawn ${times} times as long`;
    const velocity = "Mean velocity of the matrix between two stored frames.";
    element.hidden = !stage.shown.arrows;
    note.textContent = stage.arrows === "velocity" ? velocity : `Since the start, ${length}.`;
  };
  stage.on("view", refresh);
  refresh();
  return element;
}

/** A form, so that its radios are a group of their own where a page has several players. */
export function panel(stage: Stage, gone: AbortSignal): HTMLElement {
  const { film, fibreLayer } = stage;
  const [bar, controls, legend, fibres] = [h("div"), h("div"), h("div"), h("div")];
  const small = h("div", { class: "small-bar", "aria-hidden": "true" });
  stage.element.append(small);
  /** What bars and signs say: at which ends of the bar values lie beyond it, what is drawn, and at which rows fibres are. */
  const state = () =>
    [...Object.values(stage.scale().clamped()), ...Object.values(stage.shown), stage.drawnFibres && stage.fibreRows()].join();
  let said = "";
  const refresh = () => {
    said = state();
    bar.replaceChildren(colourBar(stage.layer, stage.scale()));
    small.replaceChildren(...smallBar(stage.scale().bar(isDark())));
    legend.replaceChildren(signs(stage));
    const scale = stage.drawnFibres;
    fibres.hidden = scale === null;
    if (!fibreLayer || !scale) return;
    const every = stage.fibreRows();
    const part = every > 1 ? ` Drawn in this view: those of every ${ordinal(every)} row of particles.` : "";
    fibres.replaceChildren(colourBar(fibreLayer, scale), h("p", { class: "note" }, part));
  };
  const refreshIfOther = () => state() !== said && refresh();
  const chosen = () => {
    refresh();
    const moment = () => extremes(film, stage.layer, stage.place.frame, stage.place.frame + 1);
    const changed = () => {
      refresh();
      stage.scaleChanged();
    };
    controls.replaceChildren(scaleControls(stage.layer, stage.scale(), moment, changed));
  };
  const radios = stage.layers.map((layer) => {
    const attributes = { type: "radio", name: "layer", value: layer.key, checked: layer === stage.layer };
    const { input, label } = choice(attributes, layer.name, () => stage.choose(layer));
    stage.on("layer", () => (input.checked = layer === stage.layer));
    return label;
  });
  const boxes = overlays.map(({ key, name, on }) => {
    if ((key === "fibres" && !fibreLayer) || (key === "measured" && !stage.measured.words)) return null;
    const { input, label } = choice({ name: key, checked: on }, name, () => stage.toggle(key));
    stage.on("view", () => (input.checked = stage.shown[key]));
    return label;
  });
  stage.on("layer", chosen);
  stage.on("scale", chosen);
  stage.on("view", refreshIfOther);
  if (film.growing) stage.on("paint", refreshIfOther);
  onDarkMode(refresh, gone);
  const arrows = arrowChoice(stage);
  chosen();
  const edge = edgeChoice(edges(film), (edge) => {
    stage.edge = edge;
    refresh();
    stage.draw();
  });
  const group = (title: string, choices: (HTMLElement | null)[], ...more: HTMLElement[]) =>
    h("fieldset", {}, h("legend", {}, title), h("div", { class: "choices" }, ...choices), ...more);
  const form = h(
    "form",
    { class: "panel" },
    group("Colour the matrix by", radios, styleChoice(stage), bar, controls),
    group("Draw", boxes, edge, arrows, fibres, legend),
  );
  // On paper the signs have the colours of a light page.
  onPrint(form, refresh, gone);
  form.addEventListener("submit", (event) => event.preventDefault());
  return form;
}
