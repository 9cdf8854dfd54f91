/** Paths from a common origin, with measured tracks over them, and the shapes of the cells at the end: one small picture a grid point, all to one scale. */
import type { GridPoint, Lines, StudyPage } from "./contract";
import { h, isDark, s } from "../dom";
import { countOf, durationOf, measuredColour, measuredTracks, type MeasuredTrack } from "../measured";
import { readable, roundStep } from "../numbers";
import { axis, figure } from "../figure";
import { lettered, typeset, unmarked } from "../words";
import { inRows, multipleSide, nameOf, multiplesStyle, seriesColour, type Grid, type Group } from "./groups";

/** One line for each cell. */
function eachCell(lines: Lines | null | undefined): { x: number[]; y: number[] }[] {
  const cells: { x: number[]; y: number[] }[] = [];
  let open = false;
  lines?.x_um.forEach((x, i) => {
    const y = lines.y_um[i];
    if (x === null || y === null) {
      open = false;
      return;
    }
    if (!open) cells.push({ x: [], y: [] });
    open = true;
    cells[cells.length - 1].x.push(x);
    cells[cells.length - 1].y.push(y);
  });
  return cells;
}

const withPath = (made: Grid): Group[] =>
  inRows(made.groups.filter((g) => g.runs.some((r) => r.path && r.path.x_um.length > 1)));

interface Measured {
  points: GridPoint[];
  total: number;
  tracks: MeasuredTrack[];
}

/** The paths with a switch for the measured tracks, where there are any. */
export function paths(made: Grid, measured: StudyPage["measured"] = []): HTMLElement | null {
  const sets = measured.map((set) => ({ points: set.points, total: set.total, tracks: measuredTracks(set) }));
  if (sets.length === 0) return pictures(made, []);
  const box = h("input", { type: "checkbox", name: "measured", checked: true });
  const holder = h("div", {});
  const draw = () => holder.replaceChildren(...[pictures(made, box.checked ? sets : [])].filter((made) => made !== null));
  box.addEventListener("change", draw);
  draw();
  if (holder.childElementCount === 0) return null;
  const colour = h("span", { class: "patch measured", style: `background:${measuredColour(isDark())}` });
  const words = sets.map(({ tracks, total }) => `${countOf(tracks, total)} of up to ${durationOf(tracks)}`).join("; ");
  return h("div", {}, h("label", { class: "choice" }, box, colour, words, ", each moved to the origin"), holder);
}

function pictures(made: Grid, sets: Measured[]): HTMLElement | null {
  const groups = withPath(made);
  if (groups.length === 0) return null;
  const measuredAt = (g: Group) => sets.filter((set) => set.points.some((point) => point.join() === g.point.join())).flatMap((set) => set.tracks);
  let reach = 1;
  for (const { tracks } of sets)
    for (const { x, y } of tracks) x.forEach((v, i) => (reach = Math.max(reach, Math.abs(v), Math.abs(y[i]))));
  for (const g of groups)
    for (const r of g.runs)
      for (const { x, y } of eachCell(r.path))
        x.forEach((v, i) => (reach = Math.max(reach, Math.abs(v - x[0]), Math.abs(y[i] - y[0]))));
  reach *= 1.08;
  return h(
    "div",
    { class: "multiples", style: multiplesStyle(made) },
    ...groups.map((g) =>
      figure(
        `${g.label}, n\u00a0=\u00a0${g.runs.filter((r) => r.path).length}`,
        (window) => multipleSide(made, window),
        () => ({
          data: [
            ...measuredAt(g).map(({ x, y }) => ({
              type: "scatter",
              mode: "lines",
              x,
              y,
              line: { width: 1, color: measuredColour(isDark()) },
              opacity: 0.55,
              text: "measured",
              hoverinfo: "text",
            })),
            ...g.runs.flatMap((r) =>
            eachCell(r.path).map(({ x, y }, cell, all) => ({
              type: "scatter",
              mode: "lines+markers",
              x: x.map((v) => v - x[0]),
              y: y.map((v) => v - y[0]),
              line: { width: 1.4, color: seriesColour(g.series) },
              opacity: 0.75,
              marker: {
                size: x.map((_, i) => (i === x.length - 1 ? 6 : 0)),
                color: seriesColour(g.series),
                opacity: 1,
              },
              text: `${typeset(nameOf(r))}${all.length > 1 ? `, cell ${cell + 1}` : ""}`,
              hoverinfo: "text",
            })),
          )],
          layout: {
            margin: { l: 44, r: 8, t: 6, b: 38 },
            xaxis: axis("x (\u00b5m)", { range: [-reach, reach], nticks: 5, constrain: "domain" }),
            yaxis: axis("y (\u00b5m)", { range: [-reach, reach], nticks: 5, scaleanchor: "x", constrain: "domain" }),
          },
        }),
      ),
    ),
  );
}

const known = (v: (number | null)[]): number[] => v.filter((a) => a !== null);
const middle = (v: (number | null)[]): number => 0.5 * (Math.max(...known(v)) + Math.min(...known(v)));

/** Runs side by side, their cells as they lie, none turned. */
export function shapes(made: Grid): HTMLElement | null {
  const groups = inRows(made.groups.filter((g) => g.runs.some((r) => r.outline)));
  if (groups.length === 0) return null;
  let side = 1;
  const sides = (v: (number | null)[]) => 2 * (Math.max(...known(v)) - middle(v));
  for (const g of groups)
    for (const r of g.runs) if (r.outline) side = Math.max(side, sides(r.outline.x_um), sides(r.outline.y_um));
  side *= 1.06;
  const bar = roundStep(0.2 * side);
  const across = 4;
  // 13 pixels high at the width that the picture gets (study.css).
  const text = (13 * across * side) / (innerWidth <= 640 ? innerWidth - 24 : multipleSide(made, innerWidth));
  return h(
    "div",
    { class: "multiples cells", style: multiplesStyle(made) },
    ...groups.map((g) => {
      const cells = g.runs.filter((r) => r.outline);
      const down = Math.ceil(cells.length / across);
      const svg = s("svg", {
        viewBox: `0 0 ${across * side} ${down * side + 0.12 * side + text}`,
        class: "shapes",
        role: "img",
        "aria-label": `Shapes at the end, ${unmarked(g.label)}`,
      });
      cells.forEach((r, i) => {
        if (!r.outline) return;
        const [mx, my] = [middle(r.outline.x_um), middle(r.outline.y_um)];
        const [cx, cy] = [(i % across) * side + 0.5 * side, Math.floor(i / across) * side + 0.5 * side];
        for (const { x, y } of eachCell(r.outline)) {
          const points = x.map((v, k) => `${(cx + v - mx).toFixed(1)},${(cy - y[k] + my).toFixed(1)}`).join(" ");
          svg.append(
            s("polygon", { points, style: `fill:${seriesColour(g.series)}` }, s("title", {}, `seed ${r.seed}`)),
          );
        }
      });
      const y = down * side + 0.12 * side;
      svg.append(
        s("rect", { class: "bar-of-scale", x: 0.1 * side, y, width: bar, height: 0.03 * side }),
        s(
          "text",
          { x: 0.1 * side + bar + 0.06 * side, y: y + 0.015 * side + 0.36 * text, "font-size": text },
          `${readable(bar)} \u00b5m`,
        ),
      );
      return h("figure", {}, svg, h("figcaption", {}, ...lettered(g.label)));
    }),
  );
}
