/** Below the picture: play, step, reset, time, speed, and what to do with the simulation. */
import { button, choice, h, setText } from "../dom";
import { readable, timeText } from "../numbers";
import { showPlaying } from "../run/player";
import { filmButton, pictureButtons } from "../run/save/saving";
import type { Stage } from "../run/stage";
import type { LiveClock } from "./clock";

type Acts = Record<"reset" | "goOn" | "keep" | "link" | "exported", () => void>;

/** How fast it is, and what that comes to: a phone may take ten times as long as a desk. */
export function paceText(rate: number): string {
  const minutes = (6 * 60) / rate;
  const took = minutes < 1.5 ? `${readable(60 * minutes, 2)} s` : timeText(60 * Math.round(minutes));
  return `, ${readable(rate, 2)} times faster than life: 6 h take ${took}`;
}

/** @param gone  when the stage that is shown goes */
export function bar(clock: LiveClock, stage: () => Stage | null, gone: () => AbortSignal, acts: Acts) {
  const never = new AbortController().signal;
  const play = button("", { name: "play", class: "play", onclick: () => clock.toggle() });
  const step = button("Step", { name: "step", title: "One time step of the model", onclick: () => clock.step(1) });
  const reset = button("Reset", { name: "reset", title: "Begin anew with these settings", onclick: acts.reset });
  const more = button("Go on for 6 h", { name: "more", hidden: true, onclick: acts.goOn });
  const front = button("Now", { name: "front", title: "Back to where the simulation is", onclick: () => clock.toFront() });
  const range = { type: "range", min: 0, max: 1, step: 1, "aria-label": "Time" };
  const jump = ({ value }: HTMLInputElement) => clock.jump(Number(value) >= clock.end - 1 ? clock.end : Number(value));
  const scrub = h("input", { class: "scrub", ...range, oninput: jump });
  const times = h("span", { class: "times" });
  const follow = choice({ name: "follow", checked: true }, "Follow the cell", (on) => stage()?.setFollow(on));
  const told = h("span", { class: "told", role: "status" });
  const tell = (text: string) => (told.textContent = text);
  /** What the bar last showed: update() runs with every picture, but changes the page only if the text differs. */
  let shown = "";
  let rate = "";
  let rateAt = 0;
  const update = () => {
    const { playing } = clock;
    const time = playing && clock.atFront ? 10 * Math.floor(clock.time / 10) : Math.round(clock.time);
    if (!playing || performance.now() > rateAt + 1000) {
      rate = playing && clock.rate > 0 ? paceText(clock.rate) : "";
      rateAt = performance.now();
    }
    const end = Math.ceil(clock.end);
    const text = `${timeText(60 * Math.floor(end / 60))}${rate}`;
    const following = stage()?.follow ?? true;
    const now = [playing, clock.atFront, following, time, playing ? Math.floor(end / 10) : end, text].join();
    if (now === shown) return;
    shown = now;
    front.hidden = clock.atFront;
    follow.input.checked = following;
    showPlaying(play, clock);
    scrub.max = String(Math.max(1, end));
    scrub.value = String(time);
    scrub.style.setProperty("--done", `${((100 * clock.time) / Math.max(1, end)).toFixed(1)}%`);
    scrub.setAttribute("aria-valuetext", timeText(time));
    setText(times, text);
  };
  clock.onChange(update, never);
  update();
  const saving = [
    button("Save", { name: "save", title: "In this browser; also by itself twice a minute", onclick: acts.keep }),
    button("Copy link", { name: "link", title: "Address that begins this scenario", onclick: acts.link }),
    button("Export", { name: "export", title: "Scenario for the program, and what is drawn", onclick: acts.exported }),
    ...pictureButtons(stage, tell),
    filmButton(stage, gone, tell, false),
    told,
  ];
  const element = h(
    "div",
    {},
    h("div", { class: "transport" }, play, step, reset, scrub, front, times, more, follow.label),
    h("div", { class: "saving", role: "group", "aria-label": "This simulation" }, ...saving),
  );
  /** Says whether the duration is reached. */
  const done = (yes: boolean) => (more.hidden = !yes);
  return { element, done, tell };
}
