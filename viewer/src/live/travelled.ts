/** How far the cells have come: what every question of the lesson asks for. Test: tests/travelled.test.ts */
import type { Tracks } from "../contract";
import { readable } from "../numbers";
import { tracksOfCells } from "../run/cells";

export interface Travelled {
  /** From the start in a straight line, and along the path [um]. */
  net: number;
  path: number;
  /** The first, over the time since the start [um/h]; none in the first ten minutes, in which it says nothing. */
  speed?: number;
}

/** @param t  up to then [s]; the last row at or before it counts */
export function travelled({ t_s, x_um, y_um }: Tracks, t: number): Travelled {
  let path = 0;
  let last = 0;
  for (let i = 1; i < t_s.length && t_s[i] <= t; last = i++) path += Math.hypot(x_um[i] - x_um[i - 1], y_um[i] - y_um[i - 1]);
  const net = t_s.length ? Math.hypot(x_um[last] - x_um[0], y_um[last] - y_um[0]) : 0;
  const since = t_s.length ? t_s[last] - t_s[0] : 0;
  return since < 600 ? { net, path } : { net, path, speed: (3600 * net) / since };
}

/** "15.4 µm from the start, 7.1 µm/h; path 31 µm"; of several cells the distances of the first ones. */
export function travelledText(tracks: Tracks, t: number, most = 5): string {
  const cells = tracksOfCells(tracks).map((one) => travelled(one.tracks, t));
  if (cells.length > 1) {
    const rest = cells.length > most ? ` and ${cells.length - most} more` : "";
    return `From the start: ${cells.slice(0, most).map(({ net }) => readable(net, 3)).join(", ")} \u00b5m${rest}`;
  }
  const [{ net, path, speed }] = cells;
  return `${readable(net, 3)} \u00b5m from the start${speed === undefined ? "" : `, ${readable(speed, 3)} \u00b5m/h`}; path ${readable(path, 3)} \u00b5m`;
}
