/** The page of verdicts: of `matrigrate validate` on verification cases, of `matrigrate reproduce` on the paper's claims. */
import { fillPage, h, header, section, sources, table } from "../dom";
import { embedded } from "../embedded";
import { axis, figure, named } from "../figure";
import { pretty, readable } from "../numbers";
import "../page.css";
import { boxes, boxesNote } from "../study/boxes";
import type { StudyData } from "../study/contract";
import { grid, seriesColour, seriesKey } from "../study/groups";
import { verdict } from "../study/lists";
import { adhesionForces, msd } from "../study/statistics";
import "../study/study.css";
import { paths, shapes } from "../study/tracks";
import { lettered, typeset, units } from "../words";
import type { Check, Picture, Plot, Statement, VerdictPage } from "./contract";
import "./verdicts.css";

const statementId = (s: Statement): string => `row-${s.id}`;

const badge = (s: Statement): HTMLElement =>
  h("span", {}, verdict(s.verdict), s.caveat && h("span", { class: "caveat" }, ` ${s.caveat}`));

/** Columns that no statement has anything for are left out. */
function overview(page: VerdictPage): HTMLElement {
  const text = (of: (s: Statement) => string) => (s: Statement) => pretty(of(s));
  const columns: [head: string, cell: (s: Statement) => string | HTMLElement][] = [
    ["id", (s) => h("span", {}, h("a", { href: `#${statementId(s)}` }, s.id), s.kind ? ` ${s.kind}` : "")],
    ["statement", text((s) => s.sentence)],
    ["verdict", badge],
    ["published", text((s) => s.published)],
    ["ours", text((s) => s.brief)],
    ["why not", text((s) => s.why_not)],
  ];
  const shown = columns.filter(([, cell]) => page.statements.some((s) => cell(s) !== ""));
  const rows = page.statements.map((s) => shown.map(([, cell]) => cell(s)));
  return table("Verdicts", shown.map(([head]) => head), rows);
}

const bounds = { near: "", at_least: "at least ", at_most: "at most " };

function checks(title: string, list: Check[]): HTMLElement | null {
  if (list.length === 0) return null;
  const heads = ["quantity", "measured", "expected", "tolerance", "verdict", "why this tolerance"];
  const rows = list.map((c) => [
    h("span", {}, ...lettered(units(c.quantity))),
    readable(c.measured, 5),
    `${bounds[c.sense]}${readable(c.expected, 5)}`,
    c.sense === "near" ? readable(c.tolerance) : "none",
    verdict(c.holds ? "holds" : "does not hold"),
    pretty(c.reason),
  ]);
  const made = table(title, heads, rows);
  made.classList.add("checks");
  return made;
}

// Curves and pictures of a statement.

const symbols = ["circle", "square", "triangle-up", "diamond"];

/** Rows of a legend above a plot [1]: its entries are as wide as the widest. */
function legendRows(labels: string[], window: number): number {
  const entry = 45 + 6.5 * Math.max(...labels.map((label) => label.length));
  return Math.ceil(labels.length / Math.max(1, Math.floor((Math.min(window - 24, 600) - 72) / entry)));
}

function plot(p: Plot): HTMLElement {
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
function picture(p: Picture): HTMLElement {
  const image = h("img", { alt: p.caption, src: `data:image/svg+xml;charset=utf-8,${encodeURIComponent(p.svg)}` });
  return h("figure", { class: "picture" }, image, h("figcaption", {}, pretty(p.caption)));
}

// What the runs of a study look like, with the plots of the page of a study.

const studyId = (name: string): string => `study-${name}`;

function studySection(name: string, study: StudyData): HTMLElement {
  const made = grid(study, 0);
  const drawn = study.readouts.map((r) => boxes(study, made, r, "significant"));
  const part = (suffix: string, title: string, content: HTMLElement | null): Node[] =>
    content ? [h("h3", {}, title), named(`${name}${suffix}`, h("div", {}, seriesKey(made), content))] : [];
  return section(
    studyId(name),
    `Study ${name}: ${study.title}`,
    ...part("-paths", "Paths from a common origin", paths(made)),
    ...part("-shapes", "Cells at the end", shapes(made)),
    ...part("-msd", "Mean square displacement", msd(study, made)),
    ...part("-adhesions", "Force at which adhesions ended, over 2 f_mat F_am", adhesionForces(made)),
    ...part("", "Read-outs by parameter", h("div", { class: "boxes" }, ...drawn)),
    h("p", { class: "note" }, boxesNote("runs")),
  );
}

function statement(s: Statement, names: string[]): HTMLElement {
  const studies = s.studies.filter((name) => names.includes(name));
  const links = studies.flatMap((name, i) => [i > 0 ? ", " : "", h("a", { href: `#${studyId(name)}` }, name)]);
  const figures = [...s.plots.map(plot), ...s.pictures.map(picture)];
  return section(
    statementId(s),
    `${s.id}: ${pretty(s.sentence)}`,
    h("p", {}, "Verdict: ", badge(s)),
    s.published && h("p", {}, `Published: ${pretty(s.published)}`),
    checks("Checks", s.checks),
    s.claims.length > 0 && h("h3", {}, "The paper's claims"),
    checks("The paper's claims", s.claims),
    ...s.details.flatMap((d) => [
      h("h3", {}, d.name),
      h("ul", {}, ...d.sentences.map((text) => h("li", {}, pretty(text)))),
    ]),
    links.length > 0 && h("p", {}, "Runs: ", ...links),
    figures.length > 0 && h("div", { class: "boxes curves" }, ...figures),
  );
}

fillPage((place) => {
  const page = embedded("matrigrate-verdicts", ["facts", "statements", "studies"]) as unknown as VerdictPage;
  const count = (word: Statement["verdict"]) => page.statements.filter((s) => s.verdict === word).length;
  const told = (word: Statement["verdict"]) => (count(word) > 0 ? [`${count(word)} ${word}`] : []);
  const names = page.studies.map((one) => one.name);
  const status = [`${count("holds")} of ${page.statements.length} hold`, ...told("in direction"), ...told("undecided")];
  const warns = page.statements.some((s) => s.caveat);
  const head = header(page.title, `${status.join(", ")}.`, [], page.facts);
  if (page.setting) head.append(h("p", { class: warns && "notice" }, pretty(page.setting)));
  place.replaceChildren(
    head,
    section("claims", "Verdicts", overview(page)),
    ...page.statements.map((s) => statement(s, names)),
    ...page.studies.map((one) => studySection(one.name, one.study)),
    ...sources(page),
  );
});
