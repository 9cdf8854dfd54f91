/** Colours that people with any kind of colour vision can tell apart; they agree with the program's pictures. */

export type Rgb = readonly [number, number, number];

/** Okabe and Ito. */
export const palette = ["#0072b2", "#d55e00", "#009e73", "#cc79a7", "#000000", "#e69f00", "#56b4e9", "#f0e442"];
/** The palette of a dark page, on which blue and black would be lost. */
export const paletteOnDark = ["#56b4e9", "#e8743b", "#3cc79b", "#cc79a7", "#f0f0f0", "#e69f00", "#0072b2", "#f0e442"];

/** By the number of the phase. */
export const phaseColours = ["#f0a500", "#d55e00", "#8b1a6b", "#6e7781"];
/** Phase colours of a dark page, on which the plum of contraction would be lost. */
export const phaseColoursOnDark = ["#f0a500", "#e8743b", "#d469b8", "#9aa4b0"];

/** The front of a cell is lighter than its rear. */
export interface CellColours {
  rear: string;
  front: string;
}
const single: CellColours = { rear: "#0072b2", front: "#45c4b8" };
const several: CellColours[] = [
  { rear: "#0072b2", front: "#73b9e2" },
  { rear: "#1b7837", front: "#7fc78d" },
  { rear: "#7b3294", front: "#c2a5cf" },
  { rear: "#8a4f14", front: "#dfc27d" },
  { rear: "#b2182b", front: "#f09c8c" },
  { rear: "#01665e", front: "#5ab4ac" },
  { rear: "#4d4d4d", front: "#b0b0b0" },
  { rear: "#c51b7d", front: "#f1b6da" },
];
/** Of the nucleus of any cell. */
export const nucleusColour = "#27406b";
/** Number of colours for several cells, the same as in src/run/draw/cell_colours.cpp; they repeat beyond, and numbers tell those apart. */
export const cellColourCount = several.length;
/** @param cell  from 0   @param cells  how many there are; a single one has colours of its own */
export const cellColours = (cell: number, cells: number): CellColours =>
  cells > 1 ? several[cell % several.length] : single;

/** Colours at equal distances, as "#rrggbb" with a space between. */
const ramp = (text: string): Rgb[] =>
  text.split(" ").map((c) => [1, 3, 5].map((at) => parseInt(c.slice(at, at + 2), 16)) as unknown as Rgb);

export const viridis = ramp("#440154 #482878 #3e4989 #31688e #26828e #1f9e89 #35b779 #6ece58 #b5de2b #fde725");
export const blueWhiteOrange = ramp("#104280 #4282be #9ec5e4 #f0f0f0 #f7be7f #d9771e #8c3e00");
/** Fluid to solid on a light and on a dark page: degraded matrix is what looks empty. */
export const gelOnLight = ramp("#f8f6f1 #cbb994");
export const gelOnDark = ramp("#1b1b1a #8a7a58");

/** Nuñez, Anderton and Renslow 2018: the same to people with and without red-green blindness. */
const cividis = ramp("#00204c #00346e #3c4a6b #5b5f6d #757575 #928c78 #b0a572 #d1bf66 #ffe945");
const magma = ramp("#000004 #180f3e #451077 #721f81 #9f2f7f #cd4071 #f1605d #fd9567 #fec98d #fcfdbf");
const grey = ramp("#141414 #f5f5f5");
/** Brewer's PRGn. */
const purpleGreen = ramp("#40004b #762a83 #c2a5cf #f7f7f7 #a6dba0 #1b7837 #00441b");

/** Colour maps to choose from; all can be read with any kind of colour vision. */
export const colourMaps = {
  gel: { name: "gel", on: (dark: boolean): readonly Rgb[] => (dark ? gelOnDark : gelOnLight) },
  viridis: { name: "viridis", on: (): readonly Rgb[] => viridis },
  cividis: { name: "cividis", on: (): readonly Rgb[] => cividis },
  magma: { name: "magma", on: (): readonly Rgb[] => magma },
  grey: { name: "grey", on: (): readonly Rgb[] => grey },
  blueWhiteOrange: { name: "blue\u2013white\u2013orange", on: (): readonly Rgb[] => blueWhiteOrange },
  purpleGreen: { name: "purple\u2013white\u2013green", on: (): readonly Rgb[] => purpleGreen },
} as const;
export type MapKey = keyof typeof colourMaps;

/** @param fraction  place on the map, clamped to [0, 1] */
export function mapped(map: readonly Rgb[], fraction: number): Rgb {
  const place = Math.min(1, Math.max(0, fraction)) * (map.length - 1);
  const below = Math.min(Math.floor(place), map.length - 2);
  const t = place - below;
  const [a, b] = [map[below], map[below + 1]];
  return [0, 1, 2].map((k) => Math.round(a[k] + t * (b[k] - a[k]))) as unknown as Rgb;
}

export const css = (c: Rgb): string => `rgb(${c[0]},${c[1]},${c[2]})`;

/** A map in 256 steps of RGBA, as a texture or a look-up. */
export function lookUp(map: readonly Rgb[]): Uint8Array {
  const out = new Uint8Array(4 * 256);
  for (let i = 0; i < 256; ++i) out.set([...mapped(map, i / 255), 255], 4 * i);
  return out;
}

export const gradient = (map: readonly Rgb[]): string => `linear-gradient(to right, ${map.map(css).join(", ")})`;
