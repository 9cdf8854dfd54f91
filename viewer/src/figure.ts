/** A plotly plot in the look of the page, drawn when it comes near the window or is printed, and again for another look. */
import Plotly from "plotly.js-cartesian-dist-min";
import { h, isDark, onceNear, onDarkMode, onPrint } from "./dom";
import { roundStep } from "./numbers";
import { lettered, typeset, units, unmarked, wrapped } from "./words";

export type Json = Record<string, unknown>;

interface Drawing {
  data: Json[];
  layout: Json;
}

/** Colours of text and lines, which a drawing may need for itself. */
export const ink = () =>
  isDark()
    ? { text: "#e9edf1", soft: "#a3adb8", line: "#343b43", ground: "#14171a" }
    : { text: "#1f2328", soft: "#57606a", line: "#d0d7de", ground: "#ffffff" };

/** An axis of the page's look; `more` goes over it. */
export function axis(title: string, more: Json = {}): Json {
  const colours = ink();
  return {
    title: { text: typeset(units(title)), standoff: 8 },
    gridcolor: colours.line,
    linecolor: colours.soft,
    showline: true,
    zeroline: false,
    ticks: "outside",
    tickcolor: colours.soft,
    ticklen: 4,
    automargin: true,
    ...more,
  };
}

/** A logarithmic axis from the least to the largest value: decades where there are two, else 1, 2, 5. */
export function logAxis(title: string, values: number[], more: Json = {}): Json {
  const [low, high] = [Math.min(...values), Math.max(...values)];
  const decades = Array.from({ length: 40 }, (_, k) => 10 ** (k - 20));
  const steps = high > 99 * low ? [1] : [1, 2, 5];
  const tickvals = decades.flatMap((d) => steps.map((n) => Number((n * d).toPrecision(3)))).filter((v) => v >= 0.5 * low && v <= 2 * high);
  const exponent = (v: number) => `10<sup>${Math.round(Math.log10(v))}</sup>`.replace("-", "\u2212");
  const plain = (v: number) => (v >= 1e-4 && v < 1e5 ? String(v) : steps.length === 1 ? exponent(v) : v.toExponential(0).replace("-", "\u2212"));
  return axis(title, { type: "log", tickvals, ticktext: tickvals.map(plain), ...more });
}

/** Ticks of an axis of counts: whole numbers. */
export const wholeTicks = (low: number, high: number): Json => ({ tick0: 0, dtick: Math.max(1, roundStep((high - low) / 5)), tickformat: "d" });

/** A layout whose titles of axes are broken into lines that there is room for beside the plot [px]. */
function withTitlesInLines(layout: Json, width: number, height: number): Json {
  const fitted = { ...layout };
  for (const [name, value] of Object.entries(layout)) {
    const title = /^[xy]axis\d*$/.test(name) ? (value as { title?: { text: string } }).title : undefined;
    if (!title) continue;
    const letters = Math.max(10, Math.floor((name.startsWith("x") ? width - 70 : height - 90) / 8.2));
    fitted[name] = { ...(value as Json), title: { ...title, text: wrapped(title.text, letters).replaceAll("\n", "<br>") } };
  }
  return fitted;
}

/** Without a pointer there is nothing to hover with, and a drag should scroll the page. */
const touch = matchMedia("(hover: none)").matches;

const config: Json = {
  displayModeBar: touch ? false : "hover",
  displaylogo: false,
  responsive: true,
  modeBarButtonsToRemove: ["select2d", "lasso2d", "autoScale2d"],
  toImageButtonOptions: { format: "svg" },
};

/** Marks of runs, with what is said of each when it is hovered over. */
export const dots = (x: number[], y: (number | null)[], text: string[], marker: Json): Json =>
  ({ type: "scatter", mode: "markers", x, y, marker, text, hoverinfo: "text" });

/** Gives a figure, or several that belong together, a name, by which tests find it. */
export function named(name: string, element: HTMLElement): HTMLElement {
  element.dataset["figure"] = name;
  return element;
}

/** @param height  as it is in a window of some width   @param make  for the width that it gets [pixels] */
export function figure(caption: string, height: (window: number) => number, make: (width: number) => Drawing): HTMLElement {
  const tall = height(innerWidth);
  const plot = h("div", { class: "plotly-figure", style: `height:${tall}px`, role: "img", "aria-label": unmarked(caption) });
  const element = h("figure", {}, plot, h("figcaption", {}, ...lettered(caption)));
  let seen = false;
  const draw = () => {
    seen = true;
    const colours = ink();
    const { data, layout } = make(plot.clientWidth);
    void Plotly.react(
      plot,
      data,
      {
        paper_bgcolor: "rgba(0,0,0,0)",
        plot_bgcolor: "rgba(0,0,0,0)",
        hovermode: "closest",
        showlegend: false,
        dragmode: touch ? false : "zoom",
        font: { family: 'system-ui, "Segoe UI", Helvetica, Arial, sans-serif', size: 13, color: colours.text },
        margin: { l: 56, r: 12, t: 12, b: 44 },
        hoverlabel: { font: { size: 13 } },
        modebar: { bgcolor: "rgba(0,0,0,0)", color: colours.line, activecolor: colours.soft },
        ...withTitlesInLines(layout, plot.clientWidth, tall),
        width: plot.clientWidth,
        height: tall,
      },
      config,
    ).then(() => (plot.dataset["drawn"] = "true"));
  };
  onceNear(plot, "600px", draw);
  const replaced = new AbortController();
  onDarkMode(() => {
    if (!plot.isConnected) replaced.abort();
    else if (seen) draw();
  }, replaced.signal);
  onPrint(plot, draw);
  return element;
}
