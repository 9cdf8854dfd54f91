/** Paths from a common origin, and the shapes of the cells at the end: one small picture a grid point, all to one scale. */
import { h, s } from "../dom";
import { readable, roundStep } from "../numbers";
import { axis, figure } from "./figure";
import { inRows, multipleSide, multiplesStyle, seriesColour, type Grid, type Group } from "./groups";

const withPath = (made: Grid): Group[] =>
  inRows(made.groups.filter((g) => g.runs.some((r) => r.path && r.path.x_um.length > 1)));

export function paths(made: Grid): HTMLElement | null {
  const groups = withPath(made);
  if (groups.length === 0) return null;
  let reach = 1;
  for (const g of groups)
    for (const r of g.runs)
      r.path?.x_um.forEach((x, i) => {
        if (r.path) reach = Math.max(reach, Math.abs(x - r.path.x_um[0]), Math.abs(r.path.y_um[i] - r.path.y_um[0]));
      });
  reach *= 1.08;
  return h(
    "div",
    { class: "multiples", style: multiplesStyle(made) },
    ...groups.map((g) =>
      figure(
        `${g.label}, n\u00a0=\u00a0${g.runs.filter((r) => r.path).length}`,
        (window) => multipleSide(made, window),
        () => ({
          data: g.runs.flatMap((r) => {
            if (!r.path) return [];
            const { x_um: x, y_um: y } = r.path;
            const last = x.length - 1;
            return [
              {
                type: "scatter",
                mode: "lines+markers",
                x: x.map((v) => v - x[0]),
                y: y.map((v) => v - y[0]),
                line: { width: 1.4, color: seriesColour(g.series) },
                opacity: 0.75,
                marker: { size: x.map((_, i) => (i === last ? 6 : 0)), color: seriesColour(g.series), opacity: 1 },
                text: `seed ${r.seed}`,
                hoverinfo: "text",
              },
            ];
          }),
          layout: {
            margin: { l: 44, r: 8, t: 6, b: 38 },
            xaxis: axis("x [\u00b5m]", { range: [-reach, reach], nticks: 5, constrain: "domain" }),
            yaxis: axis("y [\u00b5m]", { range: [-reach, reach], nticks: 5, scaleanchor: "x", constrain: "domain" }),
          },
        }),
      ),
    ),
  );
}

/** Cells side by side, as they lie, none turned. */
export function shapes(made: Grid): HTMLElement | null {
  const groups = inRows(made.groups.filter((g) => g.runs.some((r) => r.outline)));
  if (groups.length === 0) return null;
  let side = 1;
  const sides = (v: number[]) => Math.max(...v) - Math.min(...v);
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
        "aria-label": `Shapes at the end, ${g.label}`,
      });
      cells.forEach((r, i) => {
        if (!r.outline) return;
        const { x_um: x, y_um: y } = r.outline;
        const middle = (v: number[]) => 0.5 * (Math.max(...v) + Math.min(...v));
        const [cx, cy] = [(i % across) * side + 0.5 * side, Math.floor(i / across) * side + 0.5 * side];
        const points = x
          .map((v, k) => `${(cx + v - middle(x)).toFixed(1)},${(cy - y[k] + middle(y)).toFixed(1)}`)
          .join(" ");
        svg.append(s("polygon", { points, style: `fill:${seriesColour(g.series)}` }, s("title", {}, `seed ${r.seed}`)));
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
      return h("figure", {}, svg, h("figcaption", {}, g.label));
    }),
  );
}
