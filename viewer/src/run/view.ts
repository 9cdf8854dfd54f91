/** The view of a run: player, path and protrusions, all at the same time. */
import type { RunPage } from "../contract";
import { h, messageOf, onPrint, onResize, section } from "../dom";
import { Clock } from "./clock";
import { film } from "./frames";
import { player } from "./player";
import { plots } from "./plots";
import "./stage.css";
import "./plots.css"; // for narrow screens and paper: last
import type { SharedScales } from "./matrix/scale";
import type { Stage } from "./stage";
import { protrusionTable, timeline } from "./timeline";

/** Plots are drawn for the width they get, so that their text is never scaled; a turned phone draws them again. */
export function fitted(make: (width: number, gone: AbortSignal) => HTMLElement, gone: AbortSignal): HTMLElement {
  const holder = h("div", { class: "fitted" });
  let drawn = 0;
  let replaced = new AbortController();
  gone.addEventListener("abort", () => replaced.abort());
  const draw = () => {
    const width = Math.floor(holder.clientWidth);
    if (width === drawn || width === 0) return;
    drawn = width;
    replaced.abort();
    replaced = new AbortController();
    holder.replaceChildren(make(width, replaced.signal));
  };
  onResize(holder, draw, gone);
  onPrint(holder, draw, gone);
  return holder;
}

const stops = (run: RunPage): number[] => run.frames?.times_s ?? run.tracks.t_s;

/** One clock for several runs: it ends with the last of them, and steps by the frames of all. */
export function commonClock(runs: RunPage[]): Clock {
  const all = [...new Set(runs.flatMap(stops))].sort((a, b) => a - b);
  return new Clock(Math.max(...runs.map((run) => run.t_end_s)), all);
}

interface Company {
  /** The time that all runs in view share. */
  clock: Clock;
  /** Which of them this is, from 0: the first one has the controls of the clock. */
  place: number;
  shared: SharedScales;
}

export type RunView = ReturnType<typeof runView>;

/**
 * @param alone    the page shows this run and nothing else: it starts by itself, and keys act from anywhere
 * @param company  it is looked at beside others
 * @return player, path and protrusions; when the film can be played, its stage, or null where it cannot be; what is to be called before
 *         it is taken away
 */
export function runView(run: RunPage, alone: boolean, company?: Company) {
  const clock = company?.clock ?? commonClock([run]);
  const leads = !company || company.place === 0;
  /** Names of elements must differ on a page. */
  const id = (name: string) => (leads ? name : `${name}-${company.place + 1}`);
  const gone = new AbortController();
  const wait = h("p", { class: "wait", role: "status" }, run.frames ? "Unpacking the frames \u2026" : "");
  const place = h("div", { id: id("film") }, wait);
  const lives = (width: number, replaced: AbortSignal) => timeline(run.protrusions, clock, width, replaced, run.changes);
  const parts = [
    place,
    section(id("path"), "Path, speed and area", fitted((width, replaced) => plots(run, clock, width, replaced), gone.signal)),
    section(
      id("protrusions"),
      "Protrusions",
      fitted(lives, gone.signal),
      h("details", {}, h("summary", {}, "All numbers of the protrusions"), protrusionTable(run.protrusions)),
    ),
  ];
  const unpacked = async (): Promise<Stage | null> => {
    const made = await film(run);
    if (gone.signal.aborted) return null;
    if (made) {
      const { stage, element } = player(run, made, clock, { alone, leads, id: id("player"), shared: company?.shared }, gone.signal);
      place.replaceChildren(element);
      return stage;
    }
    const words = "This run stored no frames, so there is nothing to play. Path, protrusions and tables are below.";
    place.replaceChildren(h("p", { class: "notice" }, words));
    return null;
  };
  const ready = unpacked().catch((reason: unknown) => {
    const words = `The frames cannot be shown: ${messageOf(reason)}.`;
    place.replaceChildren(h("p", { class: "notice", role: "alert" }, words));
    return null;
  });
  const stop = () => {
    gone.abort();
    if (clock.playing) clock.toggle();
  };
  return { parts, ready, stop };
}
