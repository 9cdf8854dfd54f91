/** Play, scrub, speed, loop, follow. */
import { h, setText } from "../dom";
import { timeText } from "../numbers";
import type { Clock } from "./clock";
import type { Stage } from "./stage";

/** Model minutes a second. */
const speeds = [5, 10, 20, 40, 80];

/** Keeps the view on the cell. */
function followBox(stage: Stage): HTMLElement {
  const follow = h("input", { type: "checkbox", name: "follow" });
  follow.addEventListener("change", () => stage.setFollow(follow.checked));
  stage.onView(() => {
    follow.checked = stage.follow;
  });
  return h("label", {}, follow, "Follow the cell");
}

/** @param leads  whether the clock is driven from here */
export function transport(clock: Clock, stage: Stage, leads: boolean, gone: AbortSignal): HTMLElement {
  if (!leads) return h("div", { class: "transport" }, followBox(stage));
  const play = h("button", { type: "button", class: "play" });
  play.addEventListener("click", () => clock.toggle());
  const scrub = h("input", { type: "range", class: "scrub", min: 0, max: clock.end, step: 1, "aria-label": "Time" });
  scrub.addEventListener("input", () => clock.jump(Number(scrub.value)));
  const speed = h(
    "select",
    { "aria-label": "Speed" },
    ...speeds.map((v) => h("option", { value: v * 60, selected: v * 60 === clock.speed }, `${v} min/s`)),
  );
  speed.addEventListener("change", () => {
    clock.speed = Number(speed.value);
  });
  const loop = h("input", { type: "checkbox", name: "loop", checked: clock.loop });
  loop.addEventListener("change", () => {
    clock.loop = loop.checked;
  });
  const times = h("span", { class: "times" });
  const update = () => {
    setText(play, clock.playing ? "\u275a\u275a" : "\u25b6\ufe0e");
    play.setAttribute("aria-label", clock.playing ? "Pause" : "Play");
    scrub.value = String(Math.round(clock.time));
    scrub.style.setProperty("--done", `${(100 * clock.time) / clock.end}%`);
    scrub.setAttribute("aria-valuetext", timeText(clock.time));
    setText(times, `${timeText(60 * Math.floor(clock.time / 60))} of ${timeText(clock.end)}`);
  };
  clock.onChange(update, gone);
  update();
  return h(
    "div",
    { class: "transport" },
    play,
    scrub,
    times,
    h("label", {}, "Speed ", speed),
    h("label", {}, loop, "Loop"),
    followBox(stage),
  );
}
