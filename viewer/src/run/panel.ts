/** Beside the stage: what the matrix is coloured by, what is drawn over it, and the legend of both. */
import { h, onDarkMode, onPrint } from "../dom";
import type { ArrowKind } from "./over/arrows";
import { edgeChoice, edges } from "./over/edge";
import type { Film } from "./frames";
import { extremesOf, overlays, type Layer } from "./matrix/layers";
import { colourBar, signs, smallBar } from "./legend";
import { scaleControls } from "./scale_controls";
import type { Stage } from "./stage";

const ordinal = (n: number): string => (n === 2 ? "second" : n === 3 ? "third" : `${n}th`);

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
  const arrows = h(
    "select",
    { name: "arrow-kind" },
    h("option", { value: "displacement" }, "displacement"),
    h("option", { value: "velocity" }, "velocity"),
  );
  const arrowChoice = h("div", { class: "edge" }, h("label", {}, "Arrows show: ", arrows), arrowNote);
  const fibres = h("div", {});
  const { fibreLayer } = stage;
  const small = h("div", { class: "small-bar", "aria-hidden": "true" });
  stage.element.append(small);
  /** Whether values lie beyond the ends of the bar, which changes in a film that grows. */
  const ends = () => {
    const { low, high } = stage.scale().clamped();
    return `${low} ${high}`;
  };
  let said = "";
  const refreshBar = () => {
    said = ends();
    bar.replaceChildren(colourBar(stage.layer, stage.scale()));
    small.replaceChildren(...smallBar(stage.layer, stage.scale()));
    if (!fibreLayer) return;
    fibres.hidden = !stage.drawsFibres;
    const every = stage.fibreRows();
    const part = every > 1 ? ` Drawn in this view: those of every ${ordinal(every)} row of particles.` : "";
    fibres.replaceChildren(colourBar(fibreLayer, stage.fibreScale(fibreLayer)), h("p", { class: "note" }, part));
  };
  const refresh = () => {
    refreshBar();
    legend.replaceChildren(signs(stage));
  };
  const chosen = () => {
    refreshBar();
    controls.replaceChildren(
      scaleControls(
        stage.layer,
        stage.scale(),
        () => extremesOf(film, stage.layer, stage.place.frame, stage.place.frame + 1),
        () => {
          refreshBar();
          stage.scaleChanged();
        },
      ),
    );
  };
  const refreshArrows = () => {
    const times = stage.arrowScale();
    arrowChoice.hidden = !stage.shown.arrows;
    arrowNote.textContent =
      stage.arrows === "velocity"
        ? "Mean velocity of the matrix between two stored frames."
        : `Since the start, ${times === 1 ? "at true length" : `drawn ${times} times as long`}.`;
  };
  arrows.addEventListener("change", () => {
    stage.arrows = arrows.value as ArrowKind;
    refreshArrows();
    stage.draw();
  });
  const radios = all.map((layer) => {
    const input = h("input", { type: "radio", name: "layer", value: layer.key, checked: layer === stage.layer });
    input.addEventListener("change", () => stage.choose(layer));
    stage.onLayer(() => {
      input.checked = layer === stage.layer;
    });
    return h("label", {}, input, layer.name);
  });
  const boxes = overlays.map((overlay) => {
    if (overlay.key === "fibres" && !fibreLayer) return null;
    if (overlay.key === "measured" && !stage.measured.words) return null;
    const input = h("input", { type: "checkbox", name: overlay.key, checked: overlay.on });
    input.addEventListener("change", () => stage.toggle(overlay.key));
    stage.onView(() => {
      input.checked = stage.shown[overlay.key];
    });
    return h("label", {}, input, overlay.name);
  });
  stage.onLayer(chosen);
  stage.onScale(chosen);
  if (film.growing) stage.onPaint(() => ends() !== said && refreshBar());
  onDarkMode(refresh, gone);
  let rows = 0;
  let drawn = Object.values(stage.shown).join();
  stage.onView(() => {
    refreshArrows();
    const shown = Object.values(stage.shown).join();
    if (shown !== drawn) refresh();
    drawn = shown;
    const now = fibreLayer && stage.drawsFibres ? stage.fibreRows() : 0;
    if (now !== rows) refreshBar();
    rows = now;
  });
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
        refresh();
        stage.draw();
      }),
      arrowChoice,
      fibres,
      legend,
    ),
  );
  // On paper the signs have the colours of a light page.
  onPrint(form, refresh, gone);
  form.addEventListener("submit", (event) => event.preventDefault());
  return form;
}
