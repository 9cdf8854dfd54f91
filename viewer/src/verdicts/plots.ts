/** Curves and pictures of a statement. */
import { h } from "../dom";
import { axis, figure, named } from "../figure";
import { pretty } from "../numbers";
import { typeset } from "../words";
import { seriesColour } from "../study/groups";
import type { Picture, Plot } from "./contract";

const symbols = ["circle", "square", "triangle-up", "diamond"];

/** Rows of a legend above a plot [1]: its entries are as wide as the widest. */
function legendRows(labels: string[], window: number): number {
  const entry = 45 + 6.5 * Math.max(...labels.map((label) => label.length));
  return Math.ceil(labels.length / Math.max(1, Math.floor((Math.min(window - 24, 600) - 72) / entry)));
}

export function plot(p: Plot): HTMLElement {
  const labels = p.series.map((s) => s.label).filter((label) => label !== "");
  const height = (window: number) => 360 + (labels.length > 0 ? 20 * legendRows(labels, window) : 0);
  const drawn = figure(pretty(`${p.title}. ${p.caption}`), height, () => ({
    data: p.series.map((s) => ({
      type: "scatter",
      mode: s.mark === "points" ? "markers" : "lines",
      x: s.x,
      y: s.y,
      name: typeset(pretty(s.label)),
      showlegend: s.label !== "",
      line: { color: seriesColour(s.colour), width: 2, dash: s.mark === "dashed" ? "dash" : "solid" },
      marker: { color: seriesColour(s.colour), size: 7, symbol: symbols[s.colour % symbols.length] },
      hoverinfo: s.label === "" ? "x+y" : "x+y+name",
    })),
    layout: {
      showlegend: labels.length > 0,
      legend: { orientation: "h", x: 0, xanchor: "left", y: 1.02, yanchor: "bottom", font: { size: 12 } },
      xaxis: axis(pretty(p.x_label), p.log_x ? { type: "log" } : {}),
      yaxis: axis(pretty(p.y_label), p.log_y ? { type: "log" } : {}),
    },
  }));
  return named(p.name, drawn);
}

/** As an image: what is inside cannot reach the page. */
export const picture = (p: Picture): HTMLElement =>
  h(
    "figure",
    { class: "picture" },
    h("img", { alt: p.caption, src: `data:image/svg+xml;charset=utf-8,${encodeURIComponent(p.svg)}` }),
    h("figcaption", {}, pretty(p.caption)),
  );
