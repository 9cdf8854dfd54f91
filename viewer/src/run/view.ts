/** The view of a run: player, path and protrusions, all at the same time. */
import type { RunPage } from "../contract";
import { h, onPrint, onResize, section } from "../dom";
import { Clock } from "./clock";
import { film } from "./frames";
import { player } from "./player";
import { plots } from "./plots";
import "./stage.css";
import "./plots.css"; // for narrow screens and paper: last
import type { SharedScales } from "./matrix/shared";
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

export interface RunView {
  /** Player, path, protrusions. */
  parts: HTMLElement[];
  /** Fulfilled when the film can be played, with its stage, or cannot be: with none. */
  ready: Promise<Stage | null>;
  clock: Clock;
  /** To be called before it is taken away. */
  stop: () => void;
}

const stops = (run: RunPage): number[] => run.frames?.times_s ?? run.tracks.t_s;

/** One clock for several runs: it ends with the last of them, and steps by the frames of all. */
export function commonClock(runs: RunPage[]): Clock {
  const all = [...new Set(runs.flatMap(stops))].sort((a, b) => a - b);
  return new Clock(Math.max(...runs.map((run) => run.t_end_s)), all);
}

export interface Company {
  /** The time that all runs in view share. */
  clock: Clock;
  /** Which of them this is, from 0: the first one has the controls of the clock. */
  place: number;
  shared: SharedScales;
}

/**
 * @param alone    the page shows this run and nothing else: it starts by itself, and keys act from anywhere
 * @param company  it is looked at beside others
 */
export function runView(run: RunPage, alone: boolean, company?: Company): RunView {
  const clock = company?.clock ?? commonClock([run]);
  const leads = !company || company.place === 0;
  /** Names of elements must differ on a page. */
  const id = (name: string) => (leads ? name : `${name}-${company.place + 1}`);
  const gone = new AbortController();
  const stage = h(
    "div",
    { id: id("film") },
    h("p", { class: "wait", role: "status" }, run.frames ? "Unpacking the frames \u2026" : ""),
  );
  const parts = [
    stage,
    section(
      id("path"),
      "Path, speed and area",
      fitted((width, replaced) => plots(run, clock, width, replaced), gone.signal),
    ),
    section(
      id("protrusions"),
      "Protrusions",
      fitted((width, replaced) => timeline(run.protrusions, clock, width, replaced, run.changes), gone.signal),
      h("details", {}, h("summary", {}, "All numbers of the protrusions"), protrusionTable(run.protrusions)),
    ),
  ];
  let shown: Stage | null = null;
  const opened = (made: Stage) => {
    shown = made;
  };
  const role = { alone, leads, id: id("player"), shared: company?.shared, opened };
  const ready = film(run)
    .then((made) => {
      if (gone.signal.aborted) return null;
      stage.replaceChildren(
        made
          ? player(run, made, clock, role, gone.signal)
          : h(
              "p",
              { class: "notice" },
              "This run stored no frames, so there is nothing to play. Path, protrusions and tables are below.",
            ),
      );
      return shown;
    })
    .catch((reason: unknown) => {
      stage.replaceChildren(
        h(
          "p",
          { class: "notice", role: "alert" },
          `The frames cannot be shown: ${reason instanceof Error ? reason.message : String(reason)}.`,
        ),
      );
      return null;
    });
  return {
    parts,
    ready,
    clock,
    stop: () => {
      gone.abort();
      if (clock.playing) clock.toggle();
    },
  };
}
