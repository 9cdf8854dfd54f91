/** What of a cell lies at a point: its body or one of its protrusions, in words. */
import { phaseNames } from "../contract";
import { readable } from "../numbers";
import { valueAt } from "../unpack";
import type { CellPart } from "./cells";
import { outlineAt, type Film, type Place } from "./frames";

/** Whether a point lies inside a ring of points x0, y0, x1, y1, ... (even-odd rule). */
export function isInside(ring: ArrayLike<number>, x: number, y: number): boolean {
  let inside = false;
  const n = ring.length / 2;
  for (let i = 0, j = n - 1; i < n; j = i++) {
    const [xi, yi, xj, yj] = [ring[2 * i], ring[2 * i + 1], ring[2 * j], ring[2 * j + 1]];
    if (yi > y !== yj > y && x < xi + ((y - yi) / (yj - yi)) * (xj - xi)) inside = !inside;
  }
  return inside;
}

/**
 * @param reach  how far from the outline a point still counts as on it [um]
 * @return "Protrusion 3: contracting, f_mat 0.6, 1.2 nN", "Cell"; of several "Cell 2, protrusion 3: ...", "Cell 2"; "" away from all
 */
export function cellTextAt(film: Film, place: Place, x: number, y: number, reach: number): string {
  const outline = outlineAt(film, place);
  const holds = ({ first, end }: CellPart) => isInside(outline.subarray(2 * first, 2 * end), x, y);
  // The edge of a neighbour may be within reach of a point that lies in a cell.
  const around = film.cells.find(holds);
  for (const { number, first, end } of around ? [around] : film.cells) {
    let [nearest, distance] = [first, Infinity];
    for (let i = first; i < end; ++i) {
      const d = Math.hypot(outline[2 * i] - x, outline[2 * i + 1] - y);
      if (d < distance) [nearest, distance] = [i, d];
    }
    const onEdge = distance <= reach;
    if (!onEdge && !around) continue;
    const cell = film.cells.length > 1 ? `Cell ${number}` : "";
    const p = onEdge ? film.protrusions[place.frame][valueAt(film.outline.protrusion, place.frame, nearest)] : undefined;
    if (!p) return cell || "Cell";
    const force = p.anchor ? `, ${readable(p.force_nN, 2)} nN` : "";
    const mature = p.phase > 0 ? `, f_mat ${readable(p.f_mat, 2)}` : "";
    return `${cell ? `${cell}, protrusion` : "Protrusion"} ${p.id}: ${phaseNames[p.phase]}${mature}${force}`;
  }
  return "";
}
