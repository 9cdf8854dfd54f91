/** What the matrix can be coloured by: one entry a quantity, with its colours, limits and legend. */
import type { MapKey } from "../../colour";
import { type Field, valueAt } from "../../embedded";
import { solidFrom, usualDisplacement, type Film } from "../frames";

export interface Layer {
  key: string;
  name: string;
  /** As files and the paper call it. */
  symbol?: string;
  unit: string;
  /** Words for the two ends of the colour bar, where numbers alone say too little. */
  ends?: [string, string];
  note: string;
  /** null: made from positions, as the displacement is. */
  field: Field | null;
  /** Smallest and largest value over the run, where they are known. */
  range?: { low: number; high: number };
  low: number;
  high: number;
  /** Value of the matrix at the start, which most of the picture has. */
  rest: number;
  /** Colour maps that suit it; the first is taken until another is chosen. */
  maps: readonly MapKey[];
  /** The ends at which the program may have cut values off when it packed them. */
  cut: { low: boolean; high: boolean };
  /** Fluid has no strain and so none of these values: it is drawn as ground. */
  solidOnly: boolean;
  /** The value at which it jumps: areas above and below have a sharp edge. */
  contour?: number;
}

/** "Intact matrix (f_degr)", "Pressure (Pa)" */
export const titleOf = ({ name, symbol, unit }: Pick<Layer, "name" | "symbol" | "unit">): string =>
  name + (symbol ? ` (${symbol})` : "") + (unit ? ` (${unit})` : "");

const sequential: MapKey[] = ["viridis", "cividis", "magma", "grey"];

const limits = (field: Field): [number, number] => [field.offset, field.offset + 255 * field.scale];

type Own = Pick<Layer, "key" | "name" | "unit" | "note" | "field" | "low" | "high">;
/** A layer that differs from others by what is given. */
export const layerOf = (own: Own & Partial<Layer>): Layer => ({
  rest: 0,
  maps: sequential,
  cut: { low: false, high: false },
  solidOnly: false,
  ...own,
});

function stress(key: string, name: string, note: string, field: Field): Layer {
  const [low, high] = limits(field);
  return layerOf({ key, name, unit: "Pa", note, field, low, high, cut: { low: false, high: true }, solidOnly: true });
}

/** A layer of a field that the scenario gives the matrix; solid and fluid have a value. */
function given(key: string, name: string, unit: string, note: string, field: Field): Layer {
  const [low, high] = limits(field);
  return layerOf({ key, name, unit, note, field, low, high, rest: low });
}

export function layers(film: Film): Layer[] {
  const { fibreVonMises, attractant } = film;
  const largest = Math.max(...limits(film.pressure).map(Math.abs));
  return [
    layerOf({
      key: "degradation",
      name: "Intact matrix",
      symbol: "f_degr",
      unit: "",
      ends: ["fluid", "intact"],
      note: "1 intact solid, 0 degraded to fluid; the edge between them is at 0.5.",
      field: film.f,
      low: 0,
      high: 1,
      rest: 1,
      maps: ["gel", ...sequential],
      contour: 0.5,
    }),
    layerOf({
      key: "displacement",
      name: "Displacement",
      unit: "\u00b5m",
      note: "Of the solid matrix since the start.",
      field: null,
      low: 0,
      high: usualDisplacement(film),
      solidOnly: true,
    }),
    layerOf({
      key: "pressure",
      name: "Pressure",
      unit: "Pa",
      ends: ["pulled", "pressed"],
      note: "In the matrix; positive where it is pressed.",
      field: film.pressure,
      low: -largest,
      high: largest,
      maps: ["blueWhiteOrange", "purpleGreen", ...sequential],
      cut: { low: true, high: true },
    }),
    stress("von_mises", "Von Mises stress", "Von Mises stress of the solid matrix: how hard it is sheared.", film.vonMises),
    ...(fibreVonMises ? [stress("fibre_von_mises", "Fibre von Mises stress", ofFibres, fibreVonMises)] : []),
    ...film.layers.map(({ name, title, unit, meaning, field }) => given(name, title, unit, meaning, field)),
    ...(attractant ? [given("attractant", "Attractant", "", "Concentration of the chemoattractant.", attractant)] : []),
  ];
}
const ofFibres = "The part of the von Mises stress that the fibres carry (Eq. 11).";

/** Smallest and largest value of the stored frames from `first` up to, but without, `end`. */
export function extremes(film: Film, layer: Layer, first = 0, end = film.growing ? film.times.length : Infinity): { low: number; high: number } {
  if (layer.range) return layer.range;
  if (layer.field) {
    let [low, high] = [Infinity, -Infinity];
    const { q: all, step } = layer.field;
    for (const q of step > 0 ? all.subarray(first * step, end * step) : all) {
      if (q < low) low = q;
      if (q > high) high = q;
    }
    const { offset, scale } = layer.field;
    return { low: offset + scale * low, high: offset + scale * high };
  }
  let high = 0;
  for (let frame = first; frame < Math.min(end, film.times.length); ++frame)
    for (let i = 0; i < film.particles; ++i) {
      if (valueAt(film.f, frame, i) < solidFrom) continue;
      const dx = valueAt(film.x, frame, 2 * i) - valueAt(film.reference, 0, 2 * i);
      const dy = valueAt(film.x, frame, 2 * i + 1) - valueAt(film.reference, 0, 2 * i + 1);
      high = Math.max(high, dx * dx + dy * dy);
    }
  return { low: 0, high: Math.sqrt(high) };
}

/** The overlays, drawn over the matrix. */
export const overlays = [
  { key: "fibres", name: "Fibres", on: true },
  { key: "cell", name: "Cell", on: true },
  { key: "protrusions", name: "Protrusions", on: true },
  { key: "adhesions", name: "Adhesions", on: true },
  { key: "path", name: "Path so far", on: true },
  { key: "measured", name: "Measured tracks", on: true },
  { key: "traction", name: "Traction", on: true },
  { key: "polarization", name: "Polarization", on: false },
  { key: "arrows", name: "Arrows", on: false },
] as const;
export type OverlayKey = (typeof overlays)[number]["key"];
export type Shown = Record<OverlayKey, boolean>;
