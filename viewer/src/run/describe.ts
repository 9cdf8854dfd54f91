/** What the stage shows at a time, in words: for screen readers, and beneath a picture. */
import { phaseNames, type Tracks } from "../contract";
import { readable, timeText } from "../numbers";
import { placeAt, type Film } from "./frames";
import type { Layer } from "./matrix/layers";
import { nearest } from "./plots";

export function description(film: Film, tracks: Tracks, layer: Layer, time: number, fibres = false): string {
  const { frame } = placeAt(film.times, time);
  const i = nearest(tracks.t_s, time);
  const um = (v: number | undefined) => readable(v === undefined ? null : Number(v.toFixed(1)));
  const alive = film.protrusions[frame].map((p) => {
    const force = p.anchor ? `, force ${readable(p.force_nN, 2)} nN` : "";
    return `number ${p.id} ${phaseNames[p.phase]}${force}`;
  });
  const protrusions = alive.length === 0 ? "no protrusion" : `${alive.length} protrusion${alive.length > 1 ? "s" : ""}: ${alive.join("; ")}`;
  const where = tracks.t_s.length > 0 ? `Cell at x ${um(tracks.x_um[i])}, y ${um(tracks.y_um[i])} \u00b5m, ` : "";
  return `${timeText(time)}. ${where}${protrusions}. Matrix coloured by ${layer.name.toLowerCase()}${fibres ? ", fibres by their strain" : ""}.`;
}
