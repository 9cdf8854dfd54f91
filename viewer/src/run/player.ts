/** The player: stage, transport, choice of layers, legend, and what is true at the time shown. */
import type { RunPage } from "../contract";
import { phaseNames } from "../contract";
import { h, setText, wantsStillness } from "../dom";
import { readable, timeText } from "../numbers";
import { usual } from "./over/arrows";
import type { Clock } from "./clock";
import { ofCell } from "./cells";
import { description } from "./describe";
import { placeAt, type Film } from "./frames";
import { attachKeys, keyList } from "./keys";
import { followAddress } from "./save/link";
import { layers } from "./matrix/layers";
import type { SharedScales } from "./matrix/shared";
import { panel } from "./panel";
import { Probe } from "./probe";
import { saving } from "./save/saving";
import { Stage } from "./stage";
import { transport } from "./transport";

export function viewButtons(stage: Stage): HTMLElement {
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

/** Protrusions alive at the time shown. */
export function present(film: Film, clock: Clock, gone: AbortSignal): HTMLElement {
  const body = h("tbody", {});
  let shown = -1;
  /** Which protrusions the rows are of, and the cells with their numbers. */
  let rowsOf: string | null = null;
  let cells: HTMLElement[] = [];
  const update = () => {
    const { frame } = placeAt(film.times, clock.time);
    if (film.times[frame] === shown) return;
    shown = film.times[frame];
    const alive = film.protrusions[frame];
    const names = alive.map((p) => `${ofCell(p.cell)}${p.id} ${phaseNames[p.phase]}`);
    if (names.join() !== rowsOf) {
      rowsOf = names.join();
      cells = alive.flatMap(() => [h("td", { class: "number" }), h("td", { class: "number" })]);
      const rows = alive.map((p, k) =>
        h("tr", {}, h("td", {}, h("span", { class: `dot phase${p.phase}` }), names[k]), cells[2 * k], cells[2 * k + 1]),
      );
      body.replaceChildren(...(rows.length > 0 ? rows : [h("tr", {}, h("td", { colspan: 3 }, "none"))]));
    }
    alive.forEach((p, k) => {
      setText(cells[2 * k], p.anchor ? readable(p.f_mat, 2) : "\u2013");
      setText(cells[2 * k + 1], p.anchor ? readable(p.force_nN, 2) : "\u2013");
    });
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
          h("th", { scope: "col", class: "number" }, "maturation"),
          h("th", { scope: "col", class: "number" }, "force of the adhesion (nN)"),
        ),
      ),
      body,
    ),
  );
}

export interface Role {
  /** See `runView`. */
  alone: boolean;
  /** Has the controls of the clock. */
  leads: boolean;
  id: string;
  /** Limits and lengths that it shares with other runs in view. */
  shared?: SharedScales;
  /** Called with the stage once there is one. */
  opened: (stage: Stage) => void;
}

/** @param gone  when the player is taken away */
export function player(run: RunPage, film: Film, clock: Clock, role: Role, gone: AbortSignal): HTMLElement {
  const { alone, leads, id } = role;
  const all = layers(film);
  const displacement = all.find((layer) => layer.key === "displacement")?.high ?? 1;
  const stage = new Stage(run, film, clock, all, usual(film, displacement), role.shared, gone);
  const time = h("output", { class: "time" });
  const showTime = () => {
    setText(time, timeText(clock.time));
  };
  clock.onChange(showTime, gone);
  showTime();
  stage.element.append(time, viewButtons(stage));
  const probe = new Probe(stage);
  const keys = keyList(alone);
  attachKeys(clock, stage, probe, all, keys, alone ? document : stage.element, gone);
  const told = h("p", { class: "unseen", role: "status" });
  const tell = () => {
    // While it plays, a reader of the screen would never come to an end.
    if (!clock.playing) told.textContent = description(film, run.tracks, stage.layer, clock.time, stage.drawsFibres);
  };
  clock.onChange(tell, gone);
  stage.onLayer(tell);
  tell();
  const momentSaid = alone && followAddress(clock, stage, all, gone);
  // Someone who asked for stillness gets the whole story in one picture: the end.
  if (wantsStillness() && !momentSaid && leads) clock.set(clock.end);
  else if (alone && !momentSaid)
    queueMicrotask(() => {
      if (!clock.playing && clock.time === 0) clock.toggle();
    });
  stage.onView(tell);
  role.opened(stage);
  const aside = panel(stage, film, all, gone);
  stage.share(gone);
  return h(
    "section",
    { id, class: "run-player", "aria-label": `Player: ${run.title}` },
    h(
      "div",
      { class: "player" },
      h("div", { class: "screen" }, stage.element, transport(clock, stage, leads, gone), saving(run, clock, stage, alone, gone), keys.element, told),
      h("div", { class: "aside" }, aside, present(film, clock, gone)),
    ),
  );
}
