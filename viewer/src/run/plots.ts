/** Small line plots of the run, with a cursor at the player's time; a click or a drag in one sets that time. */
import { palette } from "../colour";
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
  const svg = s("svg", {
    viewBox: `0 0 ${width} ${height}`,
    width,
    height,
    class: "plot",
    role: "img",
    "aria-label": label,
  });
  for (const v of yAxis.ticks) {
    svg.append(
      s("path", { class: "grid", d: `M${margin.left} ${y(v)}H${right}` }),
      s("text", { x: margin.left - 7, y: y(v) + 4.5, "text-anchor": "end" }, (yAxis.text ?? readable)(v)),
    );
  }
  for (const v of xAxis.ticks)
    svg.append(
      s("path", { class: "axis", d: `M${x(v)} ${bottom}v5` }),
      s("text", { x: x(v), y: bottom + 19, "text-anchor": "middle" }, readable(v)),
    );
  svg.append(
    s("path", { class: "axis", d: `M${margin.left} ${margin.top}V${bottom}H${right}` }),
    s("text", { x: 0.5 * (margin.left + right), y: height - 5, "text-anchor": "middle" }, xAxis.label),
    s(
      "text",
      { transform: `translate(13 ${0.5 * (margin.top + bottom)}) rotate(-90)`, "text-anchor": "middle" },
      yAxis.label,
    ),
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
  made.svg.addEventListener("pointermove", (event) => {
    if (event.buttons & 1) tell(event);
  });
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
  named(changes).map(({ t, name, words }) =>
    s(
      "g",
      { class: "change" },
      s("title", {}, words.join("\n")),
      s("path", { d: `M${made.x(t / 3600)} ${top}V${bottom}` }),
      s("text", { x: made.x(t / 3600) + 4, y: bottom - 5 }, name),
    ),
  );

/** What the names at these lines mean. */
const changeWords = (changes: Changes): string => {
  const all = named(changes).map(({ name, words }) => `${name}, ${words.join(", ")}`);
  return all.length ? ` Lines mark changes of parameters: ${all.join("; ")}.` : "";
};

/** A quantity of a cell over time [s]. */
interface Curve {
  t: number[];
  values: number[];
  /** With several cells: the number of the cell, and its colour. */
  name: string;
  colour: string | undefined;
}

export const tint = (colour: string | undefined, what: "stroke" | "fill" = "stroke") => (colour ? { style: `${what}:${colour}` } : {});

/** One curve for each cell. */
function overTime(
  clock: Clock,
  width: number,
  curves: Curve[],
  label: string,
  fromZero: boolean,
  changes: Changes,
  gone: AbortSignal,
): SVGSVGElement {
  const all = curves.flatMap((curve) => curve.values);
  const high = all.reduce((a, b) => Math.max(a, b), fromZero ? 1e-9 : -Infinity);
  const low = fromZero ? 0 : all.reduce((a, b) => Math.min(a, b), Infinity);
  const room = 0.06 * (high - low || 1);
  const yAxis = {
    low: fromZero ? 0 : low - room,
    high: high + room,
    label,
    ticks: ticks(fromZero ? 0 : low - room, high + room, 4),
  };
  const made = frame(width, 210, hours(clock), yAxis, `${label} over time`);
  const cursor = s("path", { class: "cursor" });
  const dots = curves.map((curve) => s("circle", { class: "here", r: 4.5, ...tint(curve.colour, "fill") }));
  const words = s("text", { class: "value", y: margin.top + 10 });
  for (const curve of curves)
    made.svg.append(
      s(
        "path",
        { class: "curve", d: line(made, curve.t.map((v) => v / 3600), curve.values), ...tint(curve.colour) },
        ...(curve.name ? [s("title", {}, curve.name)] : []),
      ),
    );
  made.svg.append(...changeMarks(made, changes, margin.top, 210 - margin.bottom), cursor, ...dots, words);
  const update = () => {
    const at = made.x(clock.time / 3600);
    cursor.setAttribute("d", `M${at} ${margin.top}V${210 - margin.bottom}`);
    curves.forEach(({ t, values }, k) => {
      const i = nearest(t, clock.time);
      if (values[i] === undefined) return;
      dots[k].setAttribute("cx", String(made.x(t[i] / 3600)));
      dots[k].setAttribute("cy", String(made.y(values[i])));
      // With several cells the curves alone show the values.
      if (curves.length === 1) words.textContent = readable(values[i], 3);
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
export function speeds(tracks: Tracks): { t: number[]; v: number[] } {
  const span = 600;
  const out: { t: number[]; v: number[] } = { t: [], v: [] };
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
  const centre = (v: number[]) => 0.5 * (most(v) + least(v));
  const [w, k] = [width - margin.left - margin.right, height - margin.top - margin.bottom];
  const span = (v: number[]) => most(v) - least(v);
  const scale = 1.12 * Math.max(span(xs) / w, span(ys) / k, 10 / w);
  const axis = (v: number[], pixels: number, label: string): Axis => {
    const [low, high] = [centre(v) - 0.5 * scale * pixels, centre(v) + 0.5 * scale * pixels];
    return { low, high, label, ticks: ticks(low, high, pixels / 70) };
  };
  const made = frame(
    width,
    height,
    axis(xs, w, "x (\u00b5m)"),
    axis(ys, k, "y (\u00b5m)"),
    cells.length > 1 ? "Paths of the centres of mass" : "Path of the centre of mass",
  );
  for (const { x, y } of measured)
    made.svg.append(s("path", { class: "curve measured", d: line(made, x, y), style: `stroke:${measuredColour(isDark())}` }));
  const bar = 0.4 * roundStep(0.5 * scale * w);
  const updates = cells.map(({ number, tracks: { t_s, x_um, y_um } }) => {
    const ofLine = colour(number, cells.length);
    const own = tint(ofLine);
    const soFar = s("path", { class: "curve", ...own });
    const here = s("circle", { class: "here", r: 5, ...tint(ofLine, "fill") }, ...(cells.length > 1 ? [s("title", {}, `cell ${number}`)] : []));
    made.svg.append(
      s("path", { class: "curve faint", d: line(made, x_um, y_um), ...own }),
      soFar,
      s("circle", { class: "start", cx: made.x(x_um[0]), cy: made.y(y_um[0]), r: 4.5, ...own }, s("title", {}, "start")),
      here,
    );
    return () => {
      const i = nearest(t_s, clock.time);
      soFar.setAttribute("d", line(made, x_um.slice(0, i + 1), y_um.slice(0, i + 1)));
      here.setAttribute("cx", String(made.x(x_um[i])));
      here.setAttribute("cy", String(made.y(y_um[i])));
    };
  });
  made.svg.append(
    s("path", { class: "scale-bar", d: `M${margin.left + 14} ${height - margin.bottom - 14}h${bar / scale}` }),
    s("text", { class: "value", x: margin.left + 14, y: height - margin.bottom - 22 }, `${readable(bar)} \u00b5m`),
  );
  const update = () => {
    for (const one of updates) one();
  };
  clock.onChange(update, gone);
  update();
  onPick(made, (px, py) => {
    const away = every.map(({ x, y }) => Math.hypot(made.x(x) - px, made.y(y) - py));
    clock.jump(every[away.indexOf(least(away))].t);
  });
  return made.svg;
}

export const figure = (picture: Element, caption: string) => h("figure", {}, picture, h("figcaption", {}, caption));

/** Colour of a curve with several cells; the style sheet has the colour of a single cell. */
export const colour = (number: number, cells: number): string | undefined =>
  cells > 1 ? coloursOf(number, cells)[isDark() ? "front" : "rear"] : undefined;

/** @param gone  when these plots are taken away */
export function plots(
  run: Pick<RunPage, "tracks" | "measured" | "changes">,
  clock: Clock,
  width: number,
  gone: AbortSignal,
): HTMLElement {
  const { tracks, changes } = run;
  if (tracks.t_s.length < 2) return h("p", {}, "The run is too short for a path.");
  const cells = tracksOfCells(tracks);
  const [x0, y0] = startOf(tracks);
  const { tracks: whole, words } = measuredOf(run.measured);
  const measured = whole
    .map((track) => until(track, clock.end))
    .map(({ t, x, y }) => ({ t, x: x.map((v) => x0 + v), y: y.map((v) => y0 + v) }));
  const about = words ? ` Grey violet: ${words}, each from the start of the path and at most as long as the run.` : "";
  const curves = (of: (own: Tracks) => { t: number[]; v: number[] }): Curve[] =>
    cells.map(({ number, tracks: own }) => {
      const { t, v } = of(own);
      return { t, values: v, name: cells.length > 1 ? `cell ${number}` : "", colour: colour(number, cells.length) };
    });
  const column = width > 800 ? Math.floor((width - 32) / 2) : width;
  return h(
    "div",
    { class: "plots", style: `--first:${palette[0]}` },
    figure(
      path(clock, column, cells, measured, gone),
      (cells.length > 1
        ? "Paths of the centres of mass, in the colours of the cells. The rings are the starts, the dots the time of the player."
        : "Path of the centre of mass. The ring is the start, the dot the time of the player.") + about,
    ),
    h(
      "div",
      {},
      figure(
        overTime(clock, column, curves(speeds), "speed (\u00b5m/h)", true, changes, gone),
        `Speed: displacement over ten minutes.${changeWords(changes)}`,
      ),
      figure(
        overTime(clock, column, curves((own) => ({ t: own.t_s, v: own.area_um2 })), "area (\u00b5m\u00b2)", false, changes, gone),
        "Area inside the cortex.",
      ),
    ),
  );
}
