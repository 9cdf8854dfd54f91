/** The player: stage, transport, choice of layers, legend, and what is true at the time shown. */
import type { RunPage } from "../contract";
import { phaseNames } from "../contract";
import { button, choice, h, phaseDot, select, setText, wantsStillness } from "../dom";
import { readable, timeText } from "../numbers";
import { usual } from "./over/arrows";
import type { Clock } from "./clock";
import { ofCell } from "./cells";
import { placeAt, type Film } from "./frames";
import { attachKeys, keyList } from "./keys";
import { followAddress } from "./save/link";
import { layers } from "./matrix/layers";
import type { SharedScales } from "./matrix/scale";
import { panel } from "./panel";
import { description, Probe } from "./probe";
import { saving } from "./save/saving";
import { Stage } from "./stage";

export function viewButtons(stage: Stage): HTMLElement {
  const made = (text: string, title: string, onclick: () => void) => button(text, { title, "aria-label": title, onclick });
  return h(
    "div",
    { class: "view-buttons" },
    made("+", "Zoom in", () => stage.zoom(1.4)),
    made("\u2212", "Zoom out", () => stage.zoom(1 / 1.4)),
    made("\u2302", "Back to the first view (0)", () => stage.reset()),
    made("\u25ef", "The whole matrix", () => stage.showWhole()),
  );
}

/** Play or pause, as the clock does. */
export function showPlaying(play: HTMLButtonElement, { playing }: Clock): void {
  setText(play, playing ? "\u275a\u275a" : "\u25b6\ufe0e");
  play.setAttribute("aria-label", playing ? "Pause" : "Play");
}

/** Model minutes a second. */
const speeds = [5, 10, 20, 40, 80];

/** Play, scrub, speed, loop, follow.   @param leads  whether the clock is driven from here */
function transport(stage: Stage, leads: boolean, gone: AbortSignal): HTMLElement {
  const { clock } = stage;
  const follow = choice({ name: "follow" }, "Follow the cell", (on) => stage.setFollow(on));
  stage.on("view", () => (follow.input.checked = stage.follow));
  if (!leads) return h("div", { class: "transport" }, follow.label);
  const play = button("", { class: "play", onclick: () => clock.toggle() });
  const range = { type: "range", min: 0, max: clock.end, step: 1, "aria-label": "Time" };
  const scrub = h("input", { class: "scrub", ...range, oninput: ({ value }) => clock.jump(Number(value)) });
  const options = speeds.map((v): [number, string] => [60 * v, `${v} min/s`]);
  const speed = select({ "aria-label": "Speed" }, options, (v) => (clock.speed = Number(v)), clock.speed);
  const loop = choice({ name: "loop", checked: clock.loop }, "Loop", (on) => (clock.loop = on)).label;
  const times = h("span", { class: "times" });
  const update = () => {
    showPlaying(play, clock);
    scrub.value = String(Math.round(clock.time));
    scrub.style.setProperty("--done", `${(100 * clock.time) / clock.end}%`);
    scrub.setAttribute("aria-valuetext", timeText(clock.time));
    setText(times, `${timeText(60 * Math.floor(clock.time / 60))} of ${timeText(clock.end)}`);
  };
  clock.onChange(update, gone);
  update();
  return h("div", { class: "transport" }, play, scrub, times, h("label", {}, "Speed ", speed), loop, follow.label);
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
      const rows = alive.map((p, k) => h("tr", {}, h("td", {}, phaseDot(p.phase), names[k]), cells[2 * k], cells[2 * k + 1]));
      body.replaceChildren(...(rows.length > 0 ? rows : [h("tr", {}, h("td", { colspan: 3 }, "none"))]));
    }
    alive.forEach((p, k) => {
      setText(cells[2 * k], p.anchor ? readable(p.f_mat, 2) : "\u2013");
      setText(cells[2 * k + 1], p.anchor ? readable(p.force_nN, 2) : "\u2013");
    });
  };
  clock.onChange(update, gone);
  update();
  const heads = ["Protrusions now", "maturation", "force of the adhesion (nN)"];
  const head = h("tr", {}, ...heads.map((text, i) => h("th", { scope: "col", class: i > 0 && "number" }, text)));
  return h("div", { class: "present" }, h("table", {}, h("thead", {}, head), body));
}

interface Role {
  /** See `runView`. */
  alone: boolean;
  /** Has the controls of the clock. */
  leads: boolean;
  id: string;
  /** Limits and lengths that it shares with other runs in view. */
  shared?: SharedScales;
}

/** @param gone  when the player is taken away */
export function player(run: RunPage, film: Film, clock: Clock, { alone, leads, id, shared }: Role, gone: AbortSignal) {
  const all = layers(film);
  const displacement = all.find((layer) => layer.key === "displacement")?.high ?? 1;
  const stage = new Stage(run, film, clock, all, usual(film, displacement), shared, gone);
  const time = h("output", { class: "time" });
  const showTime = () => setText(time, timeText(clock.time));
  clock.onChange(showTime, gone);
  showTime();
  stage.element.append(time, viewButtons(stage));
  const probe = new Probe(stage);
  const keys = keyList(alone);
  attachKeys(stage, probe, keys, alone ? document : stage.element, gone);
  const told = h("p", { class: "unseen", role: "status" });
  const tell = () => {
    // While it plays, a reader of the screen would never come to an end.
    if (!clock.playing) told.textContent = description(film, run.tracks, stage.layer, clock.time, stage.drawnFibres !== null);
  };
  clock.onChange(tell, gone);
  stage.on("layer", tell);
  tell();
  const momentSaid = alone && followAddress(stage, gone);
  // Someone who asked for stillness gets the whole story in one picture: the end.
  if (wantsStillness() && !momentSaid && leads) clock.set(clock.end);
  else if (alone && !momentSaid)
    queueMicrotask(() => {
      if (!clock.playing && clock.time === 0) clock.toggle();
    });
  stage.on("view", tell);
  const aside = h("div", { class: "aside" }, panel(stage, gone), present(film, clock, gone));
  stage.share(gone);
  const below = [transport(stage, leads, gone), saving(stage, alone, gone), keys.element, told];
  const inside = h("div", { class: "player" }, h("div", { class: "screen" }, stage.element, ...below), aside);
  return { stage, element: h("section", { id, class: "run-player", "aria-label": `Player: ${run.title}` }, inside) };
}
