/** Colours that people with any kind of colour vision can tell apart. Those that figures of Python have as well are in colours.json. */
import colours from "./colours.json";

export type Rgb = readonly [number, number, number];

/** Okabe and Ito. */
export const palette = colours.palette;
/** The palette of a dark page, on which blue and black would be lost. */
export const paletteOnDark = ["#56b4e9", "#e8743b", "#3cc79b", "#cc79a7", "#f0f0f0", "#e69f00", "#0072b2", "#f0e442"];

/** Phase colours of a dark page, on which the plum of contraction would be lost. */
const phaseColoursOnDark = ["#f0a500", "#e8743b", "#d469b8", "#9aa4b0"];
/** By the number of the phase. */
export const phaseColoursOn = (dark: boolean): string[] => (dark ? phaseColoursOnDark : colours.phases);

/** The front of a cell is lighter than its rear. */
export interface CellColours {
  rear: string;
  front: string;
}
const pair = ([rear, front]: string[]): CellColours => ({ rear, front });
const single = pair(colours.cell);
const several = colours.cells.map(pair);
/** Of the nucleus of any cell. */
export const nucleusColour = colours.nucleus;
/** Number of colours for several cells; they repeat beyond, and numbers tell cells of one colour apart. */
export const cellColourCount = several.length;
/** @param cell  from 0   @param cells  how many there are; a single one has colours of its own */
export const cellColours = (cell: number, cells: number): CellColours =>
  cells > 1 ? several[cell % several.length] : single;

/** Colours at equal distances, each "#rrggbb". */
const ramp = (all: string[]): Rgb[] =>
  all.map((c) => [1, 3, 5].map((at) => parseInt(c.slice(at, at + 2), 16)) as unknown as Rgb);

export const viridis = ramp("#440154 #482878 #3e4989 #31688e #26828e #1f9e89 #35b779 #6ece58 #b5de2b #fde725".split(" "));
export const blueWhiteOrange = ramp(colours.blue_white_orange);
const [gelOnLight, gelOnDark] = [ramp(colours.gel), ramp("#1b1b1a #8a7a58".split(" "))];
/** Fluid to solid on a light and on a dark page: degraded matrix is what looks empty. */
export const gelOn = (dark: boolean): readonly Rgb[] => (dark ? gelOnDark : gelOnLight);

/** Nuñez, Anderton and Renslow 2018: the same to people with and without red-green blindness. */
const cividis = ramp("#00204c #00346e #3c4a6b #5b5f6d #757575 #928c78 #b0a572 #d1bf66 #ffe945".split(" "));
const magma = ramp("#000004 #180f3e #451077 #721f81 #9f2f7f #cd4071 #f1605d #fd9567 #fec98d #fcfdbf".split(" "));
const grey = ramp("#141414 #f5f5f5".split(" "));
/** Brewer's PRGn. */
const purpleGreen = ramp("#40004b #762a83 #c2a5cf #f7f7f7 #a6dba0 #1b7837 #00441b".split(" "));

/** Colour maps to choose from; all can be read with any kind of colour vision. */
export const colourMaps = {
  gel: { name: "gel", on: gelOn },
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

/** A map in 256 steps. */
export const lookUp = (map: readonly Rgb[]): Rgb[] => Array.from({ length: 256 }, (_, i) => mapped(map, i / 255));

export const gradient = (map: readonly Rgb[]): string => `linear-gradient(to right, ${map.map(css).join(", ")})`;
