/** Plots that grow: speed and protrusions over time, and the path. */
import type { ProtrusionRow, Tracks } from "../contract";
import { h, onResize, s, section } from "../dom";
import { ticks } from "../numbers";
import { frame, hours, onPick, speeds } from "../run/plots";
import { timeline } from "../run/timeline";
import type { LiveClock } from "./clock";

/** Redrawn so often at most [ms]. */
const pause = 1000;
/** Rows of protrusions that are drawn: the latest ones. */
const mostRows = 25;

function curve(clock: LiveClock, width: number, t: number[], v: number[], label: string, stairs: boolean): SVGSVGElement {
  const high = Math.max(1e-9, ...v);
  const axis = { low: 0, high: 1.06 * high, label, ticks: ticks(0, 1.06 * high, 4) };
  const made = frame(width, 190, hours(clock), axis, `${label} over time`);
  const at = (i: number) => `${made.x(t[i] / 3600).toFixed(1)} ${made.y(v[i]).toFixed(1)}`;
  const d = t.map((_, i) => (i === 0 ? `M${at(0)}` : stairs ? `H${made.x(t[i] / 3600).toFixed(1)}V${made.y(v[i]).toFixed(1)}` : `L${at(i)}`));
  made.svg.append(s("path", { class: "curve", d: d.join("") }));
  onPick(made, (x) => clock.jump(3600 * made.toX(x)));
  return made.svg;
}

export interface Curves {
  element: HTMLElement;
  /** Something new has come. */
  changed(): void;
}

export function curves(clock: LiveClock, tracks: Tracks, rows: () => ProtrusionRow[], gone: AbortSignal): Curves {
  const speed = h("div", {});
  const alive = h("div", {});
  const life = h("div", {});
  const older = h("p", { class: "note" });
  let drawn = 0;
  let later: ReturnType<typeof setTimeout> | undefined;
  let redrawn = new AbortController();
  gone.addEventListener("abort", () => {
    clearTimeout(later);
    redrawn.abort();
  });
  const draw = () => {
    later = undefined;
    drawn = performance.now();
    const width = Math.floor(speed.clientWidth);
    if (width < 50 || clock.end <= 0) return;
    const measured = tracks.t_s.length > 1 ? speeds(tracks) : { t: [], v: [] };
    speed.replaceChildren(curve(clock, width, measured.t, measured.v, "speed [\u00b5m/h]", false));
    alive.replaceChildren(curve(clock, width, tracks.t_s, tracks.n_simultaneous, "protrusions alive", true));
    const all = rows();
    redrawn.abort();
    redrawn = new AbortController();
    life.replaceChildren(timeline(all.slice(-mostRows), clock, Math.floor(life.clientWidth), redrawn.signal));
    older.textContent = all.length > mostRows ? `The latest ${mostRows} of ${all.length} protrusions.` : "";
  };
  const changed = () => {
    if (later === undefined) later = setTimeout(draw, Math.max(0, pause - (performance.now() - drawn)));
  };
  onResize(speed, changed, gone);
  const element = h(
    "div",
    {},
    section("path", "Speed and protrusions", h("div", { class: "plots" }, speed, alive)),
    section("protrusions", "Protrusions", life, older),
  );
  return { element, changed };
}
