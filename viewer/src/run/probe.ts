/** What is at a point, under the pointer or, by keyboard, in the middle of the view: the value of the layer, and what of a cell lies there. */
import { phaseNames, type Tracks } from "../contract";
import { h } from "../dom";
import { valueAt } from "../embedded";
import { readable, timeText } from "../numbers";
import { type CellPart, type CellTracks, ofCell, tracksOfCells } from "./cells";
import { type Film, outlineAt, type Place, placeAt } from "./frames";
import { onButton, placeOn } from "./camera";
import type { Layer } from "./matrix/layers";
import { nearest } from "./plots";
import type { Stage } from "./stage";

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

/** @param value  null where there is no matrix, NaN in fluid that has no value */
export function probeText(layer: Layer, value: number | null, x: number, y: number): string {
  const place = `at x ${readable(Number(x.toFixed(1)))}, y ${readable(Number(y.toFixed(1)))} \u00b5m`;
  if (value === null) return `No matrix ${place}`;
  if (Number.isNaN(value)) return `${layer.name}: none, fluid, ${place}`;
  return `${layer.name} ${readable(value, 3)}${layer.unit ? ` ${layer.unit}` : ""} ${place}`;
}

export class Probe {
  private readonly words = h("output", { class: "probe", "aria-live": "off" });
  private readonly said = h("p", { class: "unseen", role: "status" });
  private readonly cross = h("div", { class: "cross", "aria-hidden": "true" });
  private pointer: { x: number; y: number } | null = null;
  /** Shown in the middle of the view. */
  private fixed = false;

  constructor(private readonly stage: Stage) {
    const { element } = stage;
    element.append(this.cross, this.words, this.said);
    element.addEventListener("pointermove", (event) => {
      this.pointer = onButton(event) ? null : placeOn(element, event);
      this.show();
    });
    element.addEventListener("pointerleave", () => {
      this.pointer = null;
      this.show();
    });
    stage.on("paint", () => this.show());
    this.show();
  }

  toggle(): void {
    this.fixed = !this.fixed;
    this.pointer = null;
    this.show();
    this.say();
  }

  /** For those who listen: after a key, not with every picture. */
  say(): void {
    this.said.textContent = this.fixed ? this.words.textContent : "";
  }

  /** "" also where cells are not drawn. */
  private cellAt(x: number, y: number): string {
    const { film, place, shown, camera } = this.stage;
    const onScreen = 6; // pixels
    return shown.cell ? cellTextAt(film, place, x, y, Math.max(2, onScreen / camera.scale)) : "";
  }

  private show(): void {
    const { camera, layer } = this.stage;
    const at = this.pointer ?? (this.fixed ? { x: 0.5 * camera.width, y: 0.5 * camera.height } : null);
    this.cross.hidden = !this.fixed || this.pointer !== null;
    this.words.hidden = at === null;
    if (!at) return;
    const [x, y] = [camera.fromScreenX(at.x), camera.fromScreenY(at.y)];
    const cell = this.cellAt(x, y);
    const text = probeText(layer, this.stage.valueAt(x, y), x, y) + (cell ? `. ${cell}` : "");
    if (this.words.textContent !== text) this.words.textContent = text;
  }
}

// What the stage shows at a time, in words: for screen readers, and beneath a picture.

export function description(film: Film, tracks: Tracks, layer: Layer, time: number, fibres = false): string {
  const { frame } = placeAt(film.times, time);
  const um = (v: number | undefined) => readable(v === undefined ? null : Number(v.toFixed(1)));
  const alive = film.protrusions[frame].map((p) => {
    const force = p.anchor ? `, force ${readable(p.force_nN, 2)} nN` : "";
    return `${ofCell(p.cell)}number ${p.id} ${phaseNames[p.phase]}${force}`;
  });
  const protrusions = alive.length === 0 ? "no protrusion" : `${alive.length} protrusion${alive.length > 1 ? "s" : ""}: ${alive.join("; ")}`;
  const cells = tracksOfCells(tracks);
  const place = ({ number, tracks: own }: CellTracks) => {
    const i = nearest(own.t_s, time);
    const name = cells.length > 1 ? `Cell ${number}` : "Cell";
    return own.t_s.length > 0 ? `${name} at x ${um(own.x_um[i])}, y ${um(own.y_um[i])} \u00b5m, ` : "";
  };
  const where = cells.map(place).join("");
  return `${timeText(time)}. ${where}${protrusions}. Colours show ${layer.name[0].toLowerCase()}${layer.name.slice(1)}${fibres ? " and the strain of fibres" : ""}.`;
}
