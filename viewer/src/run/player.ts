/** The player: stage, transport, choice of layers, legend, and what is true at the time shown. */
import type { RunPage } from "../contract";
import { phaseNames } from "../contract";
import { h, onDarkMode, wantsStillness } from "../dom";
import { readable, timeText } from "../numbers";
import type { Clock } from "./clock";
import { edgeChoice, edges } from "./edge";
import { placeAt, type Film } from "./frames";
import { attachKeys } from "./keys";
import { layers, overlays } from "./layers";
import { colourBar, signs } from "./legend";
import { Stage } from "./stage";
import { transport } from "./transport";

function viewButtons(stage: Stage): HTMLElement {
  const button = (text: string, label: string, act: () => void) => {
    const made = h("button", { type: "button", title: label, "aria-label": label }, text);
    made.addEventListener("click", act);
    return made;
  };
  return h(
    "div",
    { class: "view-buttons" },
    button("+", "Zoom in", () => stage.zoom(1.4)),
    button("\u2212", "Zoom out", () => stage.zoom(1 / 1.4)),
    button("\u2302", "Back to the first view (0)", () => stage.reset()),
    button("\u25ef", "The whole matrix", () => stage.showWhole()),
  );
}

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

/** Radios for the matrix, boxes for what lies over it, and the legend of both. */
function panel(stage: Stage, film: Film, all: ReturnType<typeof layers>, gone: AbortSignal): HTMLElement {
  const bar = h("div", {});
  const legend = h("div", {});
  const arrowNote = h("p", { class: "note", "aria-live": "polite" });
  const refresh = () => {
    bar.replaceChildren(colourBar(stage.layer));
    legend.replaceChildren(signs());
  };
  const refreshArrows = () => {
    const times = stage.arrowScale();
    arrowNote.hidden = !stage.shown.arrows;
    arrowNote.textContent =
      times === 1 ? "Arrows: displacement, at true length." : `Arrows: displacement, drawn ${times} times as long.`;
  };
  const radios = all.map((layer) => {
    const input = h("input", { type: "radio", name: "layer", value: layer.key, checked: layer === stage.layer });
    input.addEventListener("change", () => {
      stage.layer = layer;
      refresh();
      stage.draw();
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
  onDarkMode(refresh, gone);
  stage.onView(refreshArrows);
  refresh();
  refreshArrows();
  return h(
    "div",
    { class: "panel" },
    h("fieldset", {}, h("legend", {}, "Colour the matrix by"), h("div", { class: "choices" }, ...radios), styleChoice(stage), bar),
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
}

/** Protrusions alive at the time shown. */
function present(film: Film, clock: Clock, gone: AbortSignal): HTMLElement {
  const body = h("tbody", {});
  let shown = -1;
  const update = () => {
    const { frame } = placeAt(film.times, clock.time);
    if (frame === shown) return;
    shown = frame;
    const rows = film.protrusions[frame].map((p) =>
      h(
        "tr",
        {},
        h("td", {}, h("span", { class: `dot phase${p.phase}` }), `${p.id} ${phaseNames[p.phase]}`),
        h("td", { class: "number" }, p.anchor ? readable(p.f_mat, 2) : "\u2013"),
        h("td", { class: "number" }, p.anchor ? readable(p.force_nN, 2) : "\u2013"),
      ),
    );
    body.replaceChildren(...(rows.length > 0 ? rows : [h("tr", {}, h("td", { colspan: 3 }, "none"))]));
  };
  clock.onChange(update, gone);
  update();
  return h(
    "div",
    { class: "present" },
    h(
      "table",
      {},
      h(
        "thead",
        {},
        h(
          "tr",
          {},
          h("th", { scope: "col" }, "Protrusions now"),
          h("th", { scope: "col", class: "number" }, "f_mat"),
          h("th", { scope: "col", class: "number" }, "force [nN]"),
        ),
      ),
      body,
    ),
  );
}

/** @param alone  see `runView`   @param gone  when the player is taken away */
export function player(run: RunPage, film: Film, clock: Clock, alone: boolean, gone: AbortSignal): HTMLElement {
  const all = layers(film);
  const displacement = all.find((layer) => layer.key === "displacement")?.high ?? 1;
  const stage = new Stage(run, film, clock, all[0], displacement, gone);
  const time = h("output", { class: "time" });
  const showTime = () => {
    time.textContent = timeText(clock.time);
  };
  clock.onChange(showTime, gone);
  showTime();
  stage.element.append(time, viewButtons(stage));
  attachKeys(clock, stage, alone ? document : stage.element, gone);
  // Someone who asked for stillness gets the whole story in one picture: the end.
  if (wantsStillness()) clock.set(clock.end);
  else if (alone)
    queueMicrotask(() => {
      if (!clock.playing && clock.time === 0) clock.toggle();
    });
  return h(
    "section",
    { id: "player", "aria-label": "Player" },
    h(
      "div",
      { class: "player" },
      h("div", { class: "screen" }, stage.element, transport(clock, stage, gone)),
      h("div", { class: "aside" }, panel(stage, film, all, gone), present(film, clock, gone)),
    ),
  );
}
