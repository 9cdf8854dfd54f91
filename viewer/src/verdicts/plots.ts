/** Curves and pictures of a statement. */
import { h, section } from "../dom";
import { axis, figure, named } from "../figure";
import { pretty } from "../numbers";
import { boxes, boxesNote } from "../study/boxes";
import type { StudyData } from "../study/contract";
import { grid, seriesColour, seriesKey } from "../study/groups";
import { adhesionForces, msd } from "../study/statistics";
import { paths, shapes } from "../study/tracks";
import { typeset } from "../words";
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

// What the runs of a study look like, with the plots of the page of a study.

export const studyId = (name: string): string => `study-${name}`;

export function studySection(name: string, study: StudyData): HTMLElement {
  const made = grid(study, 0);
  const part = (suffix: string, title: string, content: HTMLElement | null): Node[] =>
    content ? [h("h3", {}, title), named(`${name}${suffix}`, h("div", {}, seriesKey(made), content))] : [];
  return section(
    studyId(name),
    `Study ${name}: ${study.title}`,
    ...part("-paths", "Paths from a common origin", paths(made)),
    ...part("-shapes", "Cells at the end", shapes(made)),
    ...part("-msd", "Mean square displacement", msd(study, made)),
    ...part("-adhesions", "Force at which adhesions ended, over 2 f_mat F_am", adhesionForces(made)),
    ...part(
      "",
      "Read-outs by parameter",
      h("div", { class: "boxes" }, ...study.readouts.map((r) => boxes(study, made, r, "significant"))),
    ),
    h("p", { class: "note" }, boxesNote("runs")),
  );
}
