/** What the colours and signs of the stage mean, with units and numbers. */
import {
  cellColourCount,
  cellColours,
  css,
  gelOnDark,
  gelOnLight,
  gradient,
  mapped,
  nucleusColour,
  phaseColours,
  phaseColoursOnDark,
} from "../colour";
import { phaseNames } from "../contract";
import { h, isDark, s } from "../dom";
import { hasColours } from "./over/edge";
import { measuredLine, obstacleColour, obstacleColourOnDark } from "./over/marks";
import { readable } from "../numbers";
import { tractionColour } from "./over/arrows";
import { titleOf, type Layer } from "./matrix/layers";
import type { LayerScale } from "./matrix/scale";
import type { Stage } from "./stage";

/** The colour bar of a layer; an arrow marks an end beyond which values lie. */
function strip(scale: LayerScale): HTMLElement {
  const beyond = scale.clamped();
  const ends = `${beyond.low ? " more-low" : ""}${beyond.high ? " more-high" : ""}`;
  return h("div", { class: `bar${ends}`, style: `background:${gradient(scale.on(isDark()).map)}` });
}

/** The numbers at the ends and in the middle of a bar. */
function barNumbers(scale: LayerScale, middle: boolean): HTMLElement {
  const beyond = scale.clamped();
  const value = (share: number) => readable(scale.low + share * (scale.high - scale.low), 3);
  return h(
    "div",
    { class: "bar-numbers" },
    h("span", {}, (beyond.low ? "\u2264 " : "") + value(0)),
    middle ? h("span", {}, value(0.5)) : null,
    h("span", {}, (beyond.high ? "\u2265 " : "") + value(1)),
  );
}

/** In the picture: what its colours mean, in short. Pixel by pixel, so that the same view is the same picture. */
export function smallBar(layer: Layer, scale: LayerScale): HTMLElement[] {
  const canvas = h("canvas", { width: 120, height: 8 });
  const c = canvas.getContext("2d");
  for (let x = 0; c && x < canvas.width; ++x) {
    c.fillStyle = css(mapped(scale.on(isDark()).map, (x + 0.5) / canvas.width));
    c.fillRect(x, 0, 1, canvas.height);
  }
  const numbers = barNumbers(scale, false);
  const words = numbers.textContent?.length ?? 0;
  const { ends } = layer;
  // Where there is room for them.
  if (ends && words + ends.join("").length < 16) [...numbers.children].forEach((one, k) => one.append(` ${ends[k]}`));
  return [h("span", {}, titleOf(layer)), canvas, numbers];
}

/** The colour bar of a layer, with low, middle and high value. */
export function colourBar(layer: Layer, scale: LayerScale): HTMLElement {
  const dark = isDark();
  const beyond = scale.clamped();
  const ground = css((dark ? gelOnDark : gelOnLight)[0]);
  return h(
    "div",
    { class: "legend-layer" },
    h("p", { class: "legend-title" }, titleOf(layer)),
    strip(scale),
    barNumbers(scale, true),
    layer.ends
      ? h("div", { class: "bar-numbers words" }, h("span", {}, layer.ends[0]), h("span", {}, layer.ends[1]))
      : null,
    h("p", { class: "note" }, layer.note),
    beyond.low || beyond.high
      ? h(
          "p",
          { class: "note" },
          `Values beyond ${beyond.low && beyond.high ? "both ends" : "the pointed end"} have the colour of that end${scale.limits.edited ? " and are hatched" : ""}.`,
        )
      : null,
    layer.solidOnly
      ? h("p", { class: "note sign" }, h("span", { class: "swatch", style: `background:${ground}` }), "fluid: no value")
      : null,
  );
}

const sign = (...children: SVGElement[]) =>
  s("svg", { viewBox: "0 0 30 14", width: 30, height: 14, "aria-hidden": "true" }, ...children);

const half = (x: number, width: number, fill: string) => s("rect", { x, width, height: 14, fill });

/** Front and rear of a single cell; of several the colours of each: "cell 1, 9". */
function cellSigns(cells: number): [SVGElement, string][] {
  if (cells < 2) {
    const { front, rear } = cellColours(0, cells);
    return [
      [sign(s("rect", { width: 30, height: 14, rx: 2, fill: front })), "front"],
      [sign(s("rect", { width: 30, height: 14, rx: 2, fill: rear })), "rear"],
    ];
  }
  return Array.from({ length: Math.min(cells, cellColourCount) }, (_, k) => {
    const { front, rear } = cellColours(k, cells);
    const numbers = Array.from({ length: Math.ceil((cells - k) / cellColourCount) }, (_, n) => 1 + k + n * cellColourCount);
    const words = `cell ${numbers.slice(0, 4).join(", ")}${numbers.length > 4 ? ", \u2026" : ""}${k === 0 ? " (rear, front)" : ""}`;
    return [sign(half(0, 15, rear), half(15, 15, front)), words];
  });
}

/** Phases of protrusions, on the edge of the cell or, where it has other colours, of adhesions alone. */
function protrusionSigns(colours: string[], onEdge: boolean, adhesions: boolean): [SVGElement, string][] {
  const line = (k: number) =>
    s("path", { d: "M1 7h28", stroke: colours[k], "stroke-width": 4, "stroke-dasharray": k === 3 ? "5 3" : undefined });
  const adhesion = (k: number, r: number) =>
    sign(
      s("path", { d: "M2 7h20", stroke: colours[k], "stroke-width": 1.6 }),
      s("circle", { cx: 23, cy: 7, r, fill: colours[k] }),
    );
  const out: [SVGElement, string][] = onEdge ? phaseNames.map((name, k) => [sign(line(k)), name]) : [];
  if (adhesions && onEdge) out.push([adhesion(2, 5), "adhesion, larger when mature"]);
  if (adhesions && !onEdge)
    out.push([adhesion(1, 3.5), "adhesion, maturing"], [adhesion(2, 5), "adhesion, contracting"]);
  return out;
}

/** What a stage draws. */
export type Signed = Pick<Stage, "film" | "shown" | "edge" | "measured" | "hasObstacles">;

/** The signs drawn over the matrix, of what the stage draws. */
export function signs({ film, shown, edge, measured, hasObstacles }: Signed): HTMLElement {
  const dark = isDark();
  const colours = dark ? phaseColoursOnDark : phaseColours;
  const line = dark ? "#fff" : "#1f2328";
  const entry = (picture: SVGElement, words: string) => h("li", {}, picture, words);
  return h(
    "ul",
    { class: "signs" },
    hasObstacles
      ? entry(
          sign(s("rect", { width: 30, height: 14, fill: dark ? obstacleColourOnDark : obstacleColour })),
          "rigid obstacle",
        )
      : null,
    ...(shown.cell ? cellSigns(film.cells.length) : []).map(([picture, words]) => entry(picture, words)),
    shown.cell && film.nucleus
      ? entry(sign(s("rect", { width: 30, height: 14, rx: 2, fill: nucleusColour })), "nucleus")
      : null,
    ...protrusionSigns(colours, shown.protrusions && !hasColours(edge, shown), shown.adhesions).map(([picture, words]) =>
      entry(picture, words),
    ),
    shown.path
      ? entry(
          sign(
            s("path", { d: "M5 7h24", stroke: line, "stroke-width": 1.6 }),
            s("circle", { cx: 5, cy: 7, r: 3.4, fill: dark ? "#14171a" : "#fff", stroke: line, "stroke-width": 1.6 }),
          ),
          "path of the centre",
        )
      : null,
    shown.measured && measured.words
      ? entry(
          sign(
            ...measuredLine(dark).map(({ colour, width }) =>
              s("path", { d: "M2 9l7 -5l8 6l6 -5l6 3", stroke: colour, "stroke-width": width, fill: "none", "stroke-linejoin": "round", "stroke-linecap": "round" }),
            ),
          ),
          `${measured.words}, from the start of the path`,
        )
      : null,
    shown.traction
      ? entry(
          sign(
            s("path", { d: "M2 7h26m-8 -5l8 5l-8 5", stroke: tractionColour(dark), "stroke-width": 2.6, fill: "none" }),
          ),
          "traction: pull of an adhesion on the matrix",
        )
      : null,
    shown.polarization
      ? entry(
          sign(s("path", { d: "M2 7h26m-9 -5.5l9 5.5l-9 5.5", stroke: line, "stroke-width": 3.2, fill: "none" })),
          "polarization: direction of the front",
        )
      : null,
  );
}
