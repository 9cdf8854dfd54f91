/** What the matrix can be coloured by: one entry a quantity, with its colours, limits and legend. */
import { blueWhiteOrange, gelOnDark, gelOnLight, viridis, type Rgb } from "../colour";
import type { Field } from "../unpack";
import { usualDisplacement, type Film } from "./frames";

export interface Layer {
  key: string;
  name: string;
  unit: string;
  /** Words for the two ends of the colour bar, where numbers alone say too little. */
  ends?: [string, string];
  note: string;
  /** null: the displacement, which is made from positions. */
  field: Field | null;
  low: number;
  high: number;
  map(dark: boolean): readonly Rgb[];
  /** Fluid has no strain and so none of these values: it is drawn as ground. */
  solidOnly: boolean;
}

const limits = (field: Field): [number, number] => [field.offset, field.offset + 255 * field.scale];

function stress(key: string, name: string, note: string, field: Field): Layer {
  const [low, high] = limits(field);
  return { key, name, unit: "Pa", note, field, low, high, map: () => viridis, solidOnly: true };
}

export function layers(film: Film): Layer[] {
  const largest = Math.max(...limits(film.pressure).map(Math.abs));
  const out: Layer[] = [
    {
      key: "degradation",
      name: "Degradation",
      unit: "",
      ends: ["fluid", "solid"],
      note: "f_degr: 1 intact solid, 0 degraded to fluid.",
      field: film.f,
      low: 0,
      high: 1,
      map: (dark) => (dark ? gelOnDark : gelOnLight),
      solidOnly: false,
    },
    {
      key: "displacement",
      name: "Displacement",
      unit: "\u00b5m",
      note: "Of the solid matrix since the start.",
      field: null,
      low: 0,
      high: usualDisplacement(film),
      map: () => viridis,
      solidOnly: true,
    },
    {
      key: "pressure",
      name: "Pressure",
      unit: "Pa",
      ends: ["pulled", "pressed"],
      note: "In the matrix; positive where it is pressed.",
      field: film.pressure,
      low: -largest,
      high: largest,
      map: () => blueWhiteOrange,
      solidOnly: false,
    },
    stress("von_mises", "Von Mises", "Von Mises stress of the solid matrix: how hard it is sheared.", film.vonMises),
  ];
  if (film.fibreVonMises)
    out.push(
      stress(
        "fibre_von_mises",
        "Fibre von Mises",
        "The part of the von Mises stress that the fibres carry (Eq. 11).",
        film.fibreVonMises,
      ),
    );
  return out;
}

/** What is drawn over the matrix. */
export const overlays = [
  { key: "cell", name: "Cell", on: true },
  { key: "protrusions", name: "Protrusions", on: true },
  { key: "adhesions", name: "Adhesions", on: true },
  { key: "path", name: "Path so far", on: true },
  { key: "arrows", name: "Arrows", on: false },
] as const;
export type OverlayKey = (typeof overlays)[number]["key"];
export type Shown = Record<OverlayKey, boolean>;
