/** The grid of a study as it is drawn: one axis along x, the combinations of the others as series in colours. */
import { palette, paletteOnDark } from "../colour";
import type { GridPoint, StudyAxis, StudyData, StudyRun } from "./contract";
import { h, isDark } from "../dom";
import { lettered, settingOf, titleOf, verbatim } from "../words";

export interface Group {
  point: GridPoint;
  /** Index along x. */
  column: number;
  /** Index of its series. */
  series: number;
  /** Where it is drawn along x: `column`, moved aside if there are several series. */
  x: number;
  label: string;
  runs: StudyRun[];
}

export interface Grid {
  axisTitle: string;
  columns: string[];
  /** The columns with the name of the axis and its unit. */
  columnLabels: string[];
  series: string[];
  groups: Group[];
  /** Room for one box along x. */
  width: number;
}

export const same = (a: GridPoint, b: GridPoint): boolean => a.join() === b.join();

/** Small pictures of groups: a row a series, as wide as there are columns, where the page is wide enough; several series in a row of few columns. */
const most = (made: Grid): number =>
  made.columns.length > 2 ? Math.min(6, made.columns.length) : made.columns.length * Math.min(made.series.length, made.columns.length > 1 ? 2 : 4);
const largest = 520;
export const multiplesStyle = (made: Grid, beside = most(made)): string =>
  `--columns:${beside};--some:${Math.min(3, beside)};--side:${largest}px`;
/** The side of a square one in a window of this width [px]; as study.css has it. */
export function multipleSide(made: Grid, window: number): number {
  const beside = window <= 640 ? 2 : window <= 1024 ? Math.min(3, most(made)) : most(made);
  return Math.round(Math.min(largest, (Math.min(1280, window) - 48 - 19 * (beside - 1)) / beside));
}
/** Those groups of which some run has what is drawn, in rows. */
export const inRows = (made: Grid, has: (run: StudyRun) => unknown): Group[] =>
  made.groups.filter((g) => g.runs.some(has)).sort((a, b) => a.series - b.series || a.column - b.column);

/** Whether the values of an axis name themselves: points of a study, and conditions. */
const isNamed = (axis: StudyAxis): boolean => !axis.name.includes(".");

/** @param main  index of the axis along x */
export function grid(study: StudyData, main: number): Grid {
  const axis = study.axes[main];
  const others = study.axes.map((_, i) => i).filter((i) => i !== main);
  let points: GridPoint[] = [[]];
  for (const a of study.axes) points = points.flatMap((p) => a.values.map((_, i) => [...p, i]));
  const named = (one: StudyAxis, value: number | string) => (isNamed(one) ? verbatim(String(value)) : settingOf(one, value));
  const seriesOf = (p: GridPoint) => others.map((i) => named(study.axes[i], study.axes[i].values[p[i]])).join(", ");
  const series = [...new Set(points.map(seriesOf))];
  const width = 0.8 / series.length;
  const columns = axis ? axis.values.map((value) => (isNamed(axis) || typeof value === "string" ? verbatim(String(value)) : String(value))) : [""];
  const columnLabels = axis ? axis.values.map((value) => named(axis, value)) : ["all runs"];
  const groups = points.map((point): Group => {
    const column = axis ? point[main] : 0;
    const k = series.indexOf(seriesOf(point));
    return {
      point,
      column,
      series: k,
      x: column + (k - 0.5 * (series.length - 1)) * width,
      label: [columnLabels[column], series[k]].filter(Boolean).join(", "),
      runs: study.runs.filter((run) => same(run.point, point)),
    };
  });
  return { axisTitle: axis ? titleOf(isNamed(axis) ? { ...axis, meaning: undefined } : axis) : "", columns, columnLabels, series, groups, width };
}

export const groupAt = (made: Grid, point: GridPoint): Group | undefined => made.groups.find((g) => same(g.point, point));

export function seriesColour(index: number): string {
  const colours = isDark() ? paletteOnDark : palette;
  return colours[index % colours.length];
}

/** Which colour each series has. */
export function seriesKey(made: Grid): HTMLElement | null {
  if (made.series.length < 2) return null;
  const patch = (k: number) => h("span", { class: "patch", style: `background:${seriesColour(k)}` });
  return h("ul", { class: "series" }, ...made.series.map((name, k) => h("li", {}, patch(k), ...lettered(name))));
}

/** Colours for values along x, where each is a line of its own: dark to light in order. */
export function columnColour(index: number, count: number): string {
  const share = count > 1 ? index / (count - 1) : 0;
  const [from, to] = isDark() ? [70, 95] : [15, 68];
  return `hsl(${265 - 165 * share} ${isDark() ? 55 : 60}% ${Math.min(isDark() ? 78 : 48, from + (to - from) * share)}%)`;
}

/** As it is called when it is hovered over. */
export const nameOf = (run: StudyRun): string => (run.name ? verbatim(run.name) : `seed ${run.seed}`);

export const values = (group: Group, readout: string): { run: StudyRun; value: number }[] =>
  group.runs.flatMap((run) => {
    const value = run.readouts[readout];
    return typeof value === "number" ? [{ run, value }] : [];
  });
