/** The edge of the cell coloured by what its cortex does: maturation, or the force of its actomyosin. */
import { css, lookUp, viridis } from "../../colour";
import type { Shown } from "../matrix/layers";
import type { Coloured } from "../matrix/scale";
import type { Field } from "../../embedded";
import type { Camera } from "../camera";
import type { CellPart } from "../cells";
import { between, type Film, type Place } from "../frames";
import type { Pen } from "./pen";

export interface Edge {
  key: string;
  name: string;
  unit: string;
  field: Field | null;
  high: number;
}

/** The largest value, rounded up to two digits. */
function top(field: Field): number {
  let q = 0;
  for (const v of field.q) q = Math.max(q, v);
  const largest = field.offset + field.scale * q;
  if (!(largest > 0)) return 1;
  const step = 10 ** (Math.floor(Math.log10(largest)) - 1);
  return Number((step * Math.ceil(largest / step - 1e-6)).toPrecision(2));
}

export const edges = (film: Film): Edge[] => [
  { key: "plain", name: "plain", unit: "", field: null, high: 1 },
  { key: "f_mat", name: "maturation f_mat", unit: "", field: film.outline.fMat, high: 1 },
  { key: "force", name: "actomyosin force", unit: "nN", field: film.outline.force, high: top(film.outline.force) },
];

/** Whether it is drawn in colours of its own, which hide those of protrusions. */
export const hasColours = (edge: Edge, shown: Shown): boolean => edge.field !== null && shown.cell;

/** The colour bar of an edge that has colours. */
export const edgeBar = ({ name, unit, high }: Edge): Coloured => ({
  layer: { name: `Edge: ${name}`, unit },
  scale: { low: 0, high, map: viridis },
  clamped: { low: false, high: false },
});

const colours = lookUp(viridis).map(css);

export function paintEdge(c: Pen, camera: Camera, outline: Float32Array, cells: CellPart[], edge: Edge, place: Place): void {
  if (!edge.field) return;
  c.lineCap = "round";
  // First a light line all around, which sets the colours off from the cell and the matrix.
  for (const ground of [true, false]) {
    c.lineWidth = ground ? 7 : 4.5;
    for (const { first, end } of cells)
      for (let i = first; i < end; ++i) {
        const k = i + 1 === end ? first : i + 1;
        const value = Math.min(1, Math.max(0, between(edge.field, place, i) / edge.high));
        c.strokeStyle = ground ? "#ffffff" : colours[Math.round(255 * value)];
        c.beginPath();
        c.moveTo(camera.toScreenX(outline[2 * i]), camera.toScreenY(outline[2 * i + 1]));
        c.lineTo(camera.toScreenX(outline[2 * k]), camera.toScreenY(outline[2 * k + 1]));
        c.stroke();
      }
  }
}
