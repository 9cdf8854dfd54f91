/** What the stage shows at a time, in words: for screen readers, and beneath a picture. */
import { phaseNames, type Tracks } from "../contract";
import { readable, timeText } from "../numbers";
import { ofCell, tracksOfCells, type CellTracks } from "./cells";
import { placeAt, type Film } from "./frames";
import type { Layer } from "./matrix/layers";
import { nearest } from "./plots";

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
