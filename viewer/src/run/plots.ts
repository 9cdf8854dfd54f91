/** Small line plots of the run, with a cursor at the player's time; a click or a drag in one sets that time. */
import type { RunPage, TimedChange, Tracks } from "../contract";
import { h, isDark, s } from "../dom";
import { measuredColour, measuredOf, until, type MeasuredTrack } from "../measured";
import { readable, roundStep, ticks } from "../numbers";
import { coloursOf, tracksOfCells, type CellTracks } from "./cells";
import type { Clock } from "./clock";
import { startOf } from "./over/marks";

/** Drawn once in these units and scaled by the browser only down, so that text keeps a readable size. */
const margin = { left: 60, right: 14, top: 12, bottom: 40 };

export interface Axis {
  low: number;
  high: number;
  label: string;
  ticks: number[];
  /** What stands at a tick; else its number. */
  text?: (tick: number) => string;
}

export interface Frame {
  svg: SVGSVGElement;
  width: number;
  x(value: number): number;
  y(value: number): number;
  toX(pixel: number): number;
}

/** Axes with ticks and labels; the caller adds what is in them. */
export function frame(width: number, height: number, xAxis: Axis, yAxis: Axis, label: string): Frame {
  const right = width - margin.right;
  const bottom = height - margin.bottom;
  const x = (v: number) => margin.left + ((v - xAxis.low) / (xAxis.high - xAxis.low)) * (right - margin.left);
  const y = (v: number) => bottom - ((v - yAxis.low) / (yAxis.high - yAxis.low)) * (bottom - margin.top);
  const svg = s("svg", { viewBox: `0 0 ${width} ${height}`, width, height, class: "plot", role: "img", "aria-label": label });
  const middle = { "text-anchor": "middle" };
  for (const v of yAxis.ticks)
    svg.append(
      s("path", { class: "grid", d: `M${margin.left} ${y(v)}H${right}` }),
      s("text", { x: margin.left - 7, y: y(v) + 4.5, "text-anchor": "end" }, (yAxis.text ?? readable)(v)),
    );
  for (const v of xAxis.ticks)
    svg.append(
      s("path", { class: "axis", d: `M${x(v)} ${bottom}v5` }),
      s("text", { x: x(v), y: bottom + 19, ...middle }, readable(v)),
    );
  svg.append(
    s("path", { class: "axis", d: `M${margin.left} ${margin.top}V${bottom}H${right}` }),
    s("text", { x: 0.5 * (margin.left + right), y: height - 5, ...middle }, xAxis.label),
    s("text", { transform: `translate(13 ${0.5 * (margin.top + bottom)}) rotate(-90)`, ...middle }, yAxis.label),
  );
  const toX = (pixel: number) => xAxis.low + ((pixel - margin.left) / (right - margin.left)) * (xAxis.high - xAxis.low);
  return { svg, width, x, y, toX };
}

/** A value of the pointer's place along x, while the button is down. */
export function onPick(made: Frame, pick: (x: number, y: number) => void): void {
  const tell = (event: PointerEvent) => {
    const box = made.svg.getBoundingClientRect();
    pick((event.clientX - box.left) * (made.width / box.width), (event.clientY - box.top) * (made.width / box.width));
  };
  made.svg.classList.add("pickable");
  made.svg.addEventListener("pointerdown", (event) => {
    made.svg.setPointerCapture(event.pointerId);
    tell(event);
  });
  made.svg.addEventListener("pointermove", (event) => event.buttons & 1 && tell(event));
}

/** From 0 to an end [s]. */
export const hours = ({ end }: { end: number }): Axis => {
  const high = end / 3600;
  const step = high > 0.5 && high < 8 ? (high > 2 ? 1 : 0.5) : undefined;
  return { low: 0, high, label: "time (h)", ticks: ticks(0, high, 6, step) };
};

/** A line with gaps at null. */
export const line = (made: Frame, x: number[], y: (number | null)[]): string =>
  x.map((v, i) => {
    const at = y[i];
    return at === null ? "" : `${i === 0 || y[i - 1] === null ? "M" : "L"}${made.x(v).toFixed(1)} ${made.y(at).toFixed(1)}`;
  }).join("");

type Changes = TimedChange[] | undefined;

/** The times of changes, each called "a", "b", ...  with what changes then. */
const named = (changes: Changes): { t: number; name: string; words: string[] }[] =>
  [...new Set((changes ?? []).map((change) => change.t_s))].map((t, k) => ({
    t,
    name: k < 26 ? String.fromCharCode(97 + k) : String(k + 1),
    words: (changes ?? []).filter((change) => change.t_s === t).map((change) => change.text),
  }));

/** A line with its name at each time at which parameters change, from top to bottom. */
export const changeMarks = (made: Frame, changes: Changes, top: number, bottom: number): SVGElement[] =>
  named(changes).map(({ t, name, words }) => {
    const x = made.x(t / 3600);
    const inside = [s("path", { d: `M${x} ${top}V${bottom}` }), s("text", { x: x + 4, y: bottom - 5 }, name)];
    return s("g", { class: "change" }, s("title", {}, words.join("\n")), ...inside);
  });

/** What the names at these lines mean. */
const changeWords = (changes: Changes): string => {
  const all = named(changes).map(({ name, words }) => `${name}, ${words.join(", ")}`);
  return all.length ? ` Lines mark changes of parameters: ${all.join("; ")}.` : "";
};

/** A quantity over time [s]. */
interface Curve {
  t: number[];
  v: number[];
}

/** The colour of a cell, where there are several; the style sheet has that of a single cell. */
export const tint = (number: number, cells: number, what: "stroke" | "fill" = "stroke"): { style?: string } =>
  cells > 1 ? { style: `${what}:${coloursOf(number, cells)[isDark() ? "front" : "rear"]}` } : {};

const nameOf = (number: number, cells: number): SVGElement | null => (cells > 1 ? s("title", {}, `cell ${number}`) : null);

function moveTo(dot: SVGElement, x: number, y: number): void {
  dot.setAttribute("cx", String(x));
  dot.setAttribute("cy", String(y));
}

/** One curve for each cell. */
function overTime(run: Timed, clock: Clock, width: number, of: (own: Tracks) => Curve, label: string, fromZero: boolean, gone: AbortSignal) {
  const cells = tracksOfCells(run.tracks);
  const curves = cells.map(({ tracks }) => of(tracks));
  const all = curves.flatMap(({ v }) => v);
  const highest = all.reduce((a, b) => Math.max(a, b), fromZero ? 1e-9 : -Infinity);
  const lowest = fromZero ? 0 : all.reduce((a, b) => Math.min(a, b), Infinity);
  const room = 0.06 * (highest - lowest || 1);
  const [low, high] = [fromZero ? 0 : lowest - room, highest + room];
  const made = frame(width, 210, hours(clock), { low, high, label, ticks: ticks(low, high, 4) }, `${label} over time`);
  const cursor = s("path", { class: "cursor" });
  const dots = cells.map(({ number }) => s("circle", { class: "here", r: 4.5, ...tint(number, cells.length, "fill") }));
  const words = s("text", { class: "value", y: margin.top + 10 });
  cells.forEach(({ number }, k) => {
    const d = line(made, curves[k].t.map((t) => t / 3600), curves[k].v);
    made.svg.append(s("path", { class: "curve", d, ...tint(number, cells.length) }, nameOf(number, cells.length)));
  });
  made.svg.append(...changeMarks(made, run.changes, margin.top, 210 - margin.bottom), cursor, ...dots, words);
  const update = () => {
    const at = made.x(clock.time / 3600);
    cursor.setAttribute("d", `M${at} ${margin.top}V${210 - margin.bottom}`);
    curves.forEach(({ t, v }, k) => {
      const i = nearest(t, clock.time);
      if (v[i] === undefined) return;
      moveTo(dots[k], made.x(t[i] / 3600), made.y(v[i]));
      // With several cells the curves alone show the values.
      if (curves.length === 1) words.textContent = readable(v[i], 3);
    });
    const leftward = at > 0.8 * width;
    words.setAttribute("x", String(at + (leftward ? -7 : 7)));
    words.setAttribute("text-anchor", leftward ? "end" : "start");
  };
  clock.onChange(update, gone);
  update();
  onPick(made, (x) => clock.jump(3600 * made.toX(x)));
  return made.svg;
}

export function nearest(t: number[], time: number): number {
  let best = 0;
  for (let i = 1; i < t.length; ++i) if (Math.abs(t[i] - time) < Math.abs(t[best] - time)) best = i;
  return best;
}

/** Speed over spans of about ten minutes, at the middle of each: from row to row it would be mostly jitter. */
export function speeds(tracks: Tracks): Curve {
  const span = 600;
  const out: Curve = { t: [], v: [] };
  let first = 0;
  for (let i = 1; i < tracks.t_s.length; ++i) {
    while (tracks.t_s[i] - tracks.t_s[first + 1] >= span) ++first;
    const dt = tracks.t_s[i] - tracks.t_s[first];
    if (dt < span && tracks.t_s[tracks.t_s.length - 1] - tracks.t_s[0] >= span) continue;
    out.t.push(tracks.t_s[i] - 0.5 * dt);
    out.v.push((3600 * Math.hypot(tracks.x_um[i] - tracks.x_um[first], tracks.y_um[i] - tracks.y_um[first])) / dt);
  }
  return out;
}

/** The paths with both axes to the same scale; the part so far is strong, the rest faint. */
function path(clock: Clock, width: number, cells: CellTracks[], measured: MeasuredTrack[], gone: AbortSignal): SVGSVGElement {
  const height = Math.min(width, 430);
  const every = cells.flatMap(({ tracks }, k) => tracks.t_s.map((t, i) => ({ t, x: tracks.x_um[i], y: tracks.y_um[i], k })));
  const xs = [...every.map((at) => at.x), ...measured.flatMap((track) => track.x)];
  const ys = [...every.map((at) => at.y), ...measured.flatMap((track) => track.y)];
  const most = (v: number[]) => v.reduce((a, b) => Math.max(a, b));
  const least = (v: number[]) => v.reduce((a, b) => Math.min(a, b));
  const [w, k] = [width - margin.left - margin.right, height - margin.top - margin.bottom];
  const span = (v: number[]) => most(v) - least(v);
  const scale = 1.12 * Math.max(span(xs) / w, span(ys) / k, 10 / w);
  const axis = (v: number[], pixels: number, label: string): Axis => {
    const centre = 0.5 * (most(v) + least(v));
    const [low, high] = [centre - 0.5 * scale * pixels, centre + 0.5 * scale * pixels];
    return { low, high, label, ticks: ticks(low, high, pixels / 70) };
  };
  const label = cells.length > 1 ? "Paths of the centres of mass" : "Path of the centre of mass";
  const made = frame(width, height, axis(xs, w, "x (\u00b5m)"), axis(ys, k, "y (\u00b5m)"), label);
  for (const { x, y } of measured)
    made.svg.append(s("path", { class: "curve measured", d: line(made, x, y), style: `stroke:${measuredColour(isDark())}` }));
  const bar = 0.4 * roundStep(0.5 * scale * w);
  const updates = cells.map(({ number, tracks: { t_s, x_um, y_um } }) => {
    const own = tint(number, cells.length);
    const soFar = s("path", { class: "curve", ...own });
    const dot = { class: "here", r: 5, ...tint(number, cells.length, "fill") };
    const here = s("circle", dot, nameOf(number, cells.length));
    const start = s("circle", { class: "start", r: 4.5, ...own }, s("title", {}, "start"));
    moveTo(start, made.x(x_um[0]), made.y(y_um[0]));
    made.svg.append(s("path", { class: "curve faint", d: line(made, x_um, y_um), ...own }), soFar, start, here);
    return () => {
      const i = nearest(t_s, clock.time);
      soFar.setAttribute("d", line(made, x_um.slice(0, i + 1), y_um.slice(0, i + 1)));
      moveTo(here, made.x(x_um[i]), made.y(y_um[i]));
    };
  });
  made.svg.append(
    s("path", { class: "scale-bar", d: `M${margin.left + 14} ${height - margin.bottom - 14}h${bar / scale}` }),
    s("text", { class: "value", x: margin.left + 14, y: height - margin.bottom - 22 }, `${readable(bar)} \u00b5m`),
  );
  const update = () => updates.forEach((one) => one());
  clock.onChange(update, gone);
  update();
  onPick(made, (px, py) => {
    const away = every.map(({ x, y }) => Math.hypot(made.x(x) - px, made.y(y) - py));
    clock.jump(every[away.indexOf(least(away))].t);
  });
  return made.svg;
}

export const figure = (picture: Element, caption: string) => h("figure", {}, picture, h("figcaption", {}, caption));

type Timed = Pick<RunPage, "tracks" | "measured" | "changes">;

/** @param gone  when these plots are taken away */
export function plots(run: Timed, clock: Clock, width: number, gone: AbortSignal): HTMLElement {
  if (run.tracks.t_s.length < 2) return h("p", {}, "The run is too short for a path.");
  const cells = tracksOfCells(run.tracks);
  const [x0, y0] = startOf(run.tracks);
  const { tracks: whole, words } = measuredOf(run.measured);
  const measured = whole
    .map((track) => until(track, clock.end))
    .map(({ t, x, y }) => ({ t, x: x.map((v) => x0 + v), y: y.map((v) => y0 + v) }));
  const about = words ? ` Grey violet: ${words}, each from the start of the path and at most as long as the run.` : "";
  const one = "Path of the centre of mass. The ring is the start, the dot the time of the player.";
  const several = "Paths of the centres of mass, in the colours of the cells. The rings are the starts, the dots the time of the player.";
  const column = width > 800 ? Math.floor((width - 32) / 2) : width;
  const speed = overTime(run, clock, column, speeds, "speed (\u00b5m/h)", true, gone);
  const area = overTime(run, clock, column, (own) => ({ t: own.t_s, v: own.area_um2 }), "area (\u00b5m\u00b2)", false, gone);
  return h(
    "div",
    { class: "plots" },
    figure(path(clock, column, cells, measured, gone), (cells.length > 1 ? several : one) + about),
    h(
      "div",
      {},
      figure(speed, `Speed: displacement over ten minutes.${changeWords(run.changes)}`),
      figure(area, "Area inside the cortex."),
    ),
  );
}
