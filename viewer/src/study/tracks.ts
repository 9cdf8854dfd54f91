/** Paths from a common origin, with measured tracks over them, and the shapes of the cells at the end: one small picture a grid point, all to one scale. */
import type { GridPoint, Lines, StudyPage, StudyRun } from "./contract";
import { h, isDark, s } from "../dom";
import { countOf, durationOf, measuredColour, measuredTracks, stretches, type MeasuredTrack } from "../measured";
import { readable, roundStep } from "../numbers";
import { axis, figure } from "../figure";
import { lettered, typeset, unmarked } from "../words";
import { inRows, multipleSide, nameOf, multiplesStyle, same, seriesColour, type Grid, type Group } from "./groups";

/** One line for each cell. */
const eachCell = (lines: Lines | null | undefined) => (lines ? stretches({ x: lines.x_um, y: lines.y_um }) : []);

/** The paths with a switch for the measured tracks, where there are any. */
export function paths(made: Grid, measured: StudyPage["measured"] = []): HTMLElement | null {
  const sets = measured.map((set) => ({ ...set, tracks: measuredTracks(set) }));
  if (sets.length === 0) return pictures(made, []);
  const first = pictures(made, sets);
  if (!first) return null;
  const holder = h("div", {}, first);
  const draw = ({ checked }: HTMLInputElement) => holder.replaceChildren(pictures(made, checked ? sets : []) ?? "");
  const box = h("input", { type: "checkbox", name: "measured", checked: true, onchange: draw });
  const colour = h("span", { class: "patch measured", style: `background:${measuredColour(isDark())}` });
  const words = sets.map(({ tracks, total }) => `${countOf(tracks, total)} of up to ${durationOf(tracks)}`).join("; ");
  return h("div", {}, h("label", { class: "choice" }, box, colour, words, ", each moved to the origin"), holder);
}

function pictures(made: Grid, sets: { points: GridPoint[]; tracks: MeasuredTrack[] }[]): HTMLElement | null {
  const groups = inRows(made, (r) => r.path && r.path.x_um.length > 1);
  if (groups.length === 0) return null;
  const measuredAt = (g: Group) => sets.filter((set) => set.points.some((point) => same(point, g.point))).flatMap((set) => set.tracks);
  /** The lines of a run, each from the origin. */
  const moved = (r: StudyRun) => eachCell(r.path).map(({ x, y }) => ({ x: x.map((v) => v - x[0]), y: y.map((v) => v - y[0]) }));
  const lines = [...sets.flatMap((set) => set.tracks), ...groups.flatMap((g) => g.runs.flatMap(moved))];
  const reach = 1.08 * lines.flatMap(({ x, y }) => [...x, ...y]).reduce((most, v) => Math.max(most, Math.abs(v)), 1);
  const measuredLine = ({ x, y }: MeasuredTrack) => {
    const line = { width: 1, color: measuredColour(isDark()) };
    return { type: "scatter", mode: "lines", x, y, line, opacity: 0.55, text: "measured", hoverinfo: "text" };
  };
  const data = (g: Group) => {
    const color = seriesColour(g.series);
    const ofRun = (r: StudyRun) =>
      moved(r).map(({ x, y }, cell, all) => ({
        type: "scatter",
        mode: "lines+markers",
        x,
        y,
        line: { width: 1.4, color },
        opacity: 0.75,
        marker: { size: x.map((_, i) => (i === x.length - 1 ? 6 : 0)), color, opacity: 1 },
        text: `${typeset(nameOf(r))}${all.length > 1 ? `, cell ${cell + 1}` : ""}`,
        hoverinfo: "text",
      }));
    return [...measuredAt(g).map(measuredLine), ...g.runs.flatMap(ofRun)];
  };
  const ofGroup = (g: Group) => {
    const caption = `${g.label}, n\u00a0=\u00a0${g.runs.filter((r) => r.path).length}`;
    const range = { range: [-reach, reach], nticks: 5, constrain: "domain" };
    const layout = () => ({
      margin: { l: 44, r: 8, t: 6, b: 38 },
      xaxis: axis("x (\u00b5m)", range),
      yaxis: axis("y (\u00b5m)", { ...range, scaleanchor: "x" }),
    });
    return figure(caption, (window) => multipleSide(made, window), () => ({ data: data(g), layout: layout() }));
  };
  return h("div", { class: "multiples", style: multiplesStyle(made) }, ...groups.map(ofGroup));
}

/** Middle and extent of what is known. */
function spread(v: (number | null)[]): [number, number] {
  const known = v.filter((a) => a !== null);
  const [low, high] = [Math.min(...known), Math.max(...known)];
  return [0.5 * (high + low), high - low];
}

/** Runs side by side, their cells as they lie, none turned. */
export function shapes(made: Grid): HTMLElement | null {
  const groups = inRows(made, (r) => r.outline);
  if (groups.length === 0) return null;
  const outlines = groups.flatMap((g) => g.runs.flatMap((r) => r.outline ?? []));
  const side = 1.06 * Math.max(1, ...outlines.flatMap(({ x_um, y_um }) => [spread(x_um)[1], spread(y_um)[1]]));
  const bar = roundStep(0.2 * side);
  const across = 4;
  // 13 pixels high at the width that the picture gets (study.css).
  const text = (13 * across * side) / (innerWidth <= 640 ? innerWidth - 24 : multipleSide(made, innerWidth));
  const ofGroup = (g: Group) => {
    const cells = g.runs.flatMap(({ outline, seed }) => (outline ? [{ outline, seed }] : []));
    const y = Math.ceil(cells.length / across) * side + 0.12 * side;
    const label = `Shapes at the end, ${unmarked(g.label)}`;
    const svg = s("svg", { viewBox: `0 0 ${across * side} ${y + text}`, class: "shapes", role: "img", "aria-label": label });
    cells.forEach(({ outline, seed }, i) => {
      const [[mx], [my]] = [spread(outline.x_um), spread(outline.y_um)];
      const [cx, cy] = [(i % across) * side + 0.5 * side, Math.floor(i / across) * side + 0.5 * side];
      for (const { x, y } of eachCell(outline)) {
        const points = x.map((v, k) => `${(cx + v - mx).toFixed(1)},${(cy - y[k] + my).toFixed(1)}`).join(" ");
        svg.append(s("polygon", { points, style: `fill:${seriesColour(g.series)}` }, s("title", {}, `seed ${seed}`)));
      }
    });
    const place = { x: 0.1 * side + bar + 0.06 * side, y: y + 0.015 * side + 0.36 * text, "font-size": text };
    svg.append(
      s("rect", { class: "bar-of-scale", x: 0.1 * side, y, width: bar, height: 0.03 * side }),
      s("text", place, `${readable(bar)} \u00b5m`),
    );
    return h("figure", {}, svg, h("figcaption", {}, ...lettered(g.label)));
  };
  return h("div", { class: "multiples cells", style: multiplesStyle(made) }, ...groups.map(ofGroup));
}
