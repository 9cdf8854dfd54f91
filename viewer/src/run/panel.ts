/** Beside the stage: what the matrix is coloured by, what is drawn over it, and the legend of both. */
import { h, onDarkMode } from "../dom";
import { edgeChoice, edges } from "./edge";
import type { Film } from "./frames";
import { overlays, type Layer } from "./layers";
import { colourBar, signs } from "./legend";
import { scaleControls } from "./scale_controls";
import type { Stage } from "./stage";

/** The matrix as a field, or as the particles that it is computed by. */
function styleChoice(stage: Stage): HTMLElement {
  const radio = (value: string, name: string, smooth: boolean) => {
    const input = h("input", { type: "radio", name: "style", value, checked: stage.smooth === smooth });
    input.addEventListener("change", () => {
      stage.smooth = smooth;
      stage.draw();
    });
    return h("label", {}, input, name);
  };
  return h(
    "div",
    { class: "choices style", role: "group", "aria-label": "Draw the matrix as" },
    radio("smooth", "Smooth field", true),
    radio("particles", "Particles", false),
  );
}

/** A form, so that its radios are a group of their own where a page has several players. */
export function panel(stage: Stage, film: Film, all: Layer[], gone: AbortSignal): HTMLElement {
  const bar = h("div", {});
  const controls = h("div", {});
  const legend = h("div", {});
  const arrowNote = h("p", { class: "note", "aria-live": "polite" });
  const refreshBar = () => bar.replaceChildren(colourBar(stage.layer, stage.scale()));
  const refresh = () => {
    refreshBar();
    legend.replaceChildren(signs());
  };
  const chosen = () => {
    refreshBar();
    controls.replaceChildren(
      scaleControls(stage.layer, stage.scale(), () => {
        refreshBar();
        stage.draw();
      }),
    );
  };
  const refreshArrows = () => {
    const times = stage.arrowScale();
    arrowNote.hidden = !stage.shown.arrows;
    arrowNote.textContent =
      times === 1 ? "Arrows: displacement, at true length." : `Arrows: displacement, drawn ${times} times as long.`;
  };
  const radios = all.map((layer) => {
    const input = h("input", { type: "radio", name: "layer", value: layer.key, checked: layer === stage.layer });
    input.addEventListener("change", () => stage.choose(layer));
    stage.onLayer(() => {
      input.checked = layer === stage.layer;
    });
    return h("label", {}, input, layer.name);
  });
  const boxes = overlays.map((overlay) => {
    const input = h("input", { type: "checkbox", name: overlay.key, checked: overlay.on });
    input.addEventListener("change", () => {
      stage.shown[overlay.key] = input.checked;
      refreshArrows();
      stage.draw();
    });
    return h("label", {}, input, overlay.name);
  });
  stage.onLayer(chosen);
  onDarkMode(refresh, gone);
  stage.onView(refreshArrows);
  chosen();
  refresh();
  refreshArrows();
  const form = h(
    "form",
    { class: "panel" },
    h(
      "fieldset",
      {},
      h("legend", {}, "Colour the matrix by"),
      h("div", { class: "choices" }, ...radios),
      styleChoice(stage),
      bar,
      controls,
    ),
    h(
      "fieldset",
      {},
      h("legend", {}, "Draw"),
      h("div", { class: "choices" }, ...boxes),
      edgeChoice(edges(film), (edge) => {
        stage.edge = edge;
        stage.draw();
      }),
      arrowNote,
      legend,
    ),
  );
  form.addEventListener("submit", (event) => event.preventDefault());
  return form;
}
