/** Below the picture: play, step, reset, time, speed, and what to do with the simulation. */
import { h, setText } from "../dom";
import { readable, timeText } from "../numbers";
import { filmButton, pictureButtons } from "../run/save/saving";
import type { Stage } from "../run/stage";
import type { LiveClock } from "./clock";

export interface Acts {
  reset(): void;
  goOn(): void;
  keep(): void;
  link(): void;
  exported(): void;
}

/** How fast it is, and what that comes to: a phone may take ten times as long as a desk. */
export function paceText(rate: number): string {
  const minutes = (6 * 60) / rate;
  return `, ${readable(rate, 2)} times faster than life: 6 h take ${minutes < 1.5 ? `${readable(60 * minutes, 2)} s` : timeText(60 * Math.round(minutes))}`;
}

export interface Bar {
  element: HTMLElement;
  /** Says whether the duration is reached. */
  done(yes: boolean): void;
  tell(text: string): void;
}

/** @param gone  when the stage that is shown goes */
export function bar(clock: LiveClock, stage: () => Stage | null, gone: () => AbortSignal, acts: Acts): Bar {
  const never = new AbortController().signal;
  const button = (text: string, name: string, act: () => void, title?: string) => {
    const made = h("button", { type: "button", name, title }, text);
    made.addEventListener("click", act);
    return made;
  };
  const play = button("", "play", () => clock.toggle());
  play.className = "play";
  const step = button("Step", "step", () => clock.step(1), "One time step of the model");
  const more = button("Go on for 6 h", "more", acts.goOn);
  more.hidden = true;
  const front = button("Now", "front", () => clock.toFront(), "Back to where the simulation is");
  const scrub = h("input", { type: "range", class: "scrub", min: 0, max: 1, step: 1, "aria-label": "Time" });
  scrub.addEventListener("input", () => clock.jump(Number(scrub.value) >= clock.end - 1 ? clock.end : Number(scrub.value)));
  const times = h("span", { class: "times" });
  const follow = h("input", { type: "checkbox", name: "follow", checked: true });
  follow.addEventListener("change", () => stage()?.setFollow(follow.checked));
  const told = h("span", { class: "told", role: "status" });
  const tell = (text: string) => {
    told.textContent = text;
  };
  const filmed = () => {
    const now = stage();
    return now ? { stage: now, gone: gone() } : null;
  };
  const film = filmButton("Matrigrate live", clock, filmed, tell, false);
  /** What the bar last showed: update() runs with every picture, but changes the page only if the text differs. */
  let shown = "";
  let rate = "";
  let rateAt = 0;
  const update = () => {
    const { playing } = clock;
    const time = playing && clock.atFront ? 10 * Math.floor(clock.time / 10) : Math.round(clock.time);
    if (!playing || performance.now() > rateAt + 1000) {
      rate = playing && clock.measured > 0 ? paceText(clock.measured) : "";
      rateAt = performance.now();
    }
    const end = Math.ceil(clock.end);
    const text = `${timeText(60 * Math.floor(end / 60))}${rate}`;
    const following = stage()?.follow ?? true;
    const now = [playing, clock.atFront, following, time, playing ? Math.floor(end / 10) : end, text].join();
    if (now === shown) return;
    shown = now;
    front.hidden = clock.atFront;
    follow.checked = following;
    setText(play, playing ? "\u275a\u275a" : "\u25b6\ufe0e");
    play.setAttribute("aria-label", playing ? "Pause" : "Play");
    scrub.max = String(Math.max(1, end));
    scrub.value = String(time);
    scrub.style.setProperty("--done", `${((100 * clock.time) / Math.max(1, end)).toFixed(1)}%`);
    scrub.setAttribute("aria-valuetext", timeText(time));
    setText(times, text);
  };
  clock.onChange(update, never);
  update();
  const element = h(
    "div",
    {},
    h("div", { class: "transport" }, play, step, button("Reset", "reset", acts.reset, "Begin anew with these settings"), scrub, front, times, more, h("label", {}, follow, "Follow the cell")),
    h(
      "div",
      { class: "saving", role: "group", "aria-label": "This simulation" },
      button("Save", "save", acts.keep, "In this browser; also by itself twice a minute"),
      button("Copy link", "link", acts.link, "Address that begins this scenario"),
      button("Export", "export", acts.exported, "Scenario for the program, and what is drawn"),
      ...pictureButtons("Matrigrate live", clock, stage, tell),
      ...(film ? [film] : []),
      told,
    ),
  );
  return {
    element,
    done: (yes) => {
      more.hidden = !yes;
    },
    tell,
  };
}
