/** What the colours and signs of the stage mean, with units and numbers. */
import { cellColourCount, cellColours, css, gelOn, gradient, mapped, nucleusColour, phaseColoursOn } from "../colour";
import { phaseNames } from "../contract";
import { h, isDark, s } from "../dom";
import { hasColours } from "./over/edge";
import { measuredLine, obstacleColour } from "./over/marks";
import { readable } from "../numbers";
import { tractionColour } from "./over/arrows";
import { ink } from "./over/pen";
import { titleOf, type Layer } from "./matrix/layers";
import type { Coloured, LayerScale } from "./matrix/scale";
import type { Stage } from "./stage";

/** The numbers at the ends of a bar. */
export const endsOf = ({ low, high }: Coloured["scale"], beyond: Coloured["clamped"]): [string, string] =>
  [(beyond.low ? "\u2264 " : "") + readable(low, 3), (beyond.high ? "\u2265 " : "") + readable(high, 3)];

const barNumbers = (numbers: string[]) => h("div", { class: "bar-numbers" }, ...numbers.map((number) => h("span", {}, number)));

/** In the picture: what its colours mean, in short. Pixel by pixel, so that the same view is the same picture. */
export function smallBar({ layer, scale, clamped }: Coloured): HTMLElement[] {
  const canvas = h("canvas", { width: 120, height: 8 });
  const c = canvas.getContext("2d");
  for (let x = 0; c && x < canvas.width; ++x) {
    c.fillStyle = css(mapped(scale.map, (x + 0.5) / canvas.width));
    c.fillRect(x, 0, 1, canvas.height);
  }
  const numbers = barNumbers(endsOf(scale, clamped));
  const words = numbers.textContent?.length ?? 0;
  const { ends } = layer;
  // Where there is room for them.
  if (ends && words + ends.join("").length < 16) [...numbers.children].forEach((one, k) => one.append(` ${ends[k]}`));
  return [h("span", {}, titleOf(layer)), canvas, numbers];
}

/** The colour bar of what has colours, with low, middle and high value. */
export function bareBar({ layer, scale, clamped }: Coloured): HTMLElement[] {
  const ends = `${clamped.low ? " more-low" : ""}${clamped.high ? " more-high" : ""}`;
  const [low, high] = endsOf(scale, clamped);
  return [
    h("p", { class: "legend-title" }, titleOf(layer)),
    h("div", { class: `bar${ends}`, style: `background:${gradient(scale.map)}` }),
    barNumbers([low, readable(0.5 * (scale.low + scale.high), 3), high]),
  ];
}

/** The colour bar of a layer with what is to be known of it. An arrow marks an end beyond which values lie. */
export function colourBar(layer: Layer, scale: LayerScale): HTMLElement {
  const bar = scale.bar(isDark());
  const { low, high } = bar.clamped;
  const note = (...words: (HTMLElement | string)[]) => h("p", { class: "note" }, ...words);
  const which = low && high ? "both ends" : "the pointed end";
  const beyond = `Values beyond ${which} have the colour of that end${scale.limits.edited ? " and are hatched" : ""}.`;
  const swatch = h("span", { class: "swatch", style: `background:${css(gelOn(isDark())[0])}` });
  return h(
    "div",
    { class: "legend-layer" },
    ...bareBar(bar),
    layer.ends && h("div", { class: "bar-numbers words" }, ...layer.ends.map((end) => h("span", {}, end))),
    note(layer.note),
    (low || high) && note(beyond),
    layer.solidOnly && note(swatch, "fluid: no value"),
  );
}

const sign = (...children: SVGElement[]) =>
  s("svg", { viewBox: "0 0 30 14", width: 30, height: 14, "aria-hidden": "true" }, ...children);

const patch = (fill: string, rx = 2) => sign(s("rect", { width: 30, height: 14, rx, fill }));
const half = (x: number, fill: string) => s("rect", { x, width: 15, height: 14, fill });

type Entry = [picture: SVGElement, words: string];

/** Front and rear of a single cell; of several the colours of each: "cell 1, 9". */
function cellSigns(cells: number): Entry[] {
  if (cells < 2) return [[patch(cellColours(0, cells).front), "front"], [patch(cellColours(0, cells).rear), "rear"]];
  return Array.from({ length: Math.min(cells, cellColourCount) }, (_, k) => {
    const { front, rear } = cellColours(k, cells);
    const numbers = Array.from({ length: Math.ceil((cells - k) / cellColourCount) }, (_, n) => 1 + k + n * cellColourCount);
    const words = `cell ${numbers.slice(0, 4).join(", ")}${numbers.length > 4 ? ", \u2026" : ""}${k === 0 ? " (rear, front)" : ""}`;
    return [sign(half(0, rear), half(15, front)), words];
  });
}

/** Phases of protrusions, on the edge of the cell or, where it has other colours, of adhesions alone. */
function protrusionSigns(colours: string[], onEdge: boolean, adhesions: boolean): Entry[] {
  const line = (stroke: string, k: number) =>
    s("path", { d: "M1 7h28", stroke, "stroke-width": 4, "stroke-dasharray": k === 3 ? "5 3" : undefined });
  const adhesion = (k: number, r: number) =>
    sign(
      s("path", { d: "M2 7h20", stroke: colours[k], "stroke-width": 1.6 }),
      s("circle", { cx: 23, cy: 7, r, fill: colours[k] }),
    );
  const phases = onEdge ? phaseNames.map((name, k): Entry => [sign(line(colours[k], k)), name]) : [];
  if (!adhesions) return phases;
  if (onEdge) return [...phases, [adhesion(2, 5), "adhesion, larger when mature"]];
  return [[adhesion(1, 3.5), "adhesion, maturing"], [adhesion(2, 5), "adhesion, contracting"]];
}

const arrow = (d: string, stroke: string, width: number) => sign(s("path", { d, stroke, "stroke-width": width, fill: "none" }));

/** The start of a path, and the path. */
function pathSign(dark: boolean): SVGElement {
  const { line, edge } = ink(dark);
  const pen = { stroke: line, "stroke-width": 1.6 };
  return sign(s("path", { d: "M5 7h24", ...pen }), s("circle", { cx: 5, cy: 7, r: 3.4, fill: edge, ...pen }));
}

function measuredSign(dark: boolean): SVGElement {
  const wave = { d: "M2 9l7 -5l8 6l6 -5l6 3", fill: "none", "stroke-linejoin": "round", "stroke-linecap": "round" };
  return sign(...measuredLine(dark).map(({ colour, width }) => s("path", { ...wave, stroke: colour, "stroke-width": width })));
}

/** The signs drawn over the matrix, of what the stage draws. */
export function signs({ film, shown, edge, measured }: Pick<Stage, "film" | "shown" | "edge" | "measured">): HTMLElement {
  const dark = isDark();
  const entries: (Entry | false)[] = [
    film.obstacles.length > 0 && [patch(obstacleColour(dark), 0), "rigid obstacle"],
    ...(shown.cell ? cellSigns(film.cells.length) : []),
    shown.cell && film.nucleus !== null && [patch(nucleusColour), "nucleus"],
    ...protrusionSigns(phaseColoursOn(dark), shown.protrusions && !hasColours(edge, shown), shown.adhesions),
    shown.path && [pathSign(dark), "path of the centre"],
    shown.measured && measured.words !== "" && [measuredSign(dark), `${measured.words}, from the start of the path`],
    shown.traction && [arrow("M2 7h26m-8 -5l8 5l-8 5", tractionColour(dark), 2.6), "traction: pull of an adhesion on the matrix"],
    shown.polarization && [arrow("M2 7h26m-9 -5.5l9 5.5l-9 5.5", ink(dark).line, 3.2), "polarization: direction of the front"],
  ];
  const items = entries.filter((entry) => entry !== false).map(([picture, words]) => h("li", {}, picture, words));
  return h("ul", { class: "signs" }, ...items);
}
