/** Measured tracks over the matrix: as far as they were at the time shown, from the start of the simulated path. */
import colours from "../../colours.json";
import type { Tracks } from "../../contract";
import { type MeasuredTrack, until } from "../../measured";
import type { Camera } from "../camera";
import { tracksOfCells } from "../cells";
import type { Film } from "../frames";
import { edged, polyline, type Pen } from "./pen";

/** Where the simulated path begins; of several cells the mean. */
export function startOf(tracks: Tracks): [number, number] {
  const cells = tracksOfCells(tracks).filter((one) => one.tracks.x_um.length > 0);
  const mean = (of: (own: Tracks) => number) => cells.reduce((sum, one) => sum + of(one.tracks), 0) / Math.max(1, cells.length);
  return [mean((own) => own.x_um[0]), mean((own) => own.y_um[0])];
}

/** A halo and the line in it, which are seen on any matrix and on front and rear of a cell; widths [pixels]. */
export function measuredLine(dark: boolean): { colour: string; width: number }[] {
  return [
    { colour: dark ? "#14171a" : "#ffffff", width: 4.2 },
    { colour: dark ? "#d8c4ff" : "#5b2a86", width: 1.8 },
  ];
}

export function paintMeasured(c: Pen, measured: MeasuredTrack[], tracks: Tracks, time: number, camera: Camera, dark: boolean): void {
  const [x0, y0] = startOf(tracks);
  const [halo, line] = measuredLine(dark);
  for (const track of measured) {
    const { x, y } = until(track, time);
    c.beginPath();
    polyline(c, x.map((v, i) => [camera.toScreenX(x0 + v), camera.toScreenY(y0 + y[i])]));
    edged(c, line.colour, halo.colour, line.width, [], 0.5 * (halo.width - line.width));
  }
}

// Rigid obstacles: squares where their particles lie, over any layer, since they have no values of their own.

export const obstacleColour = (dark: boolean): string => (dark ? "#9aa3ad" : colours.obstacle);

export function paintObstacles(c: Pen, film: Film, camera: Camera, spacing: number, dark: boolean): void {
  if (film.obstacles.length === 0) return;
  const side = 1.08 * spacing * camera.scale;
  c.fillStyle = obstacleColour(dark);
  c.beginPath();
  for (const [x, y] of film.obstacles) {
    const [left, top] = [camera.toScreenX(x) - 0.5 * side, camera.toScreenY(y) - 0.5 * side];
    if (left < -side || top < -side || left > camera.width || top > camera.height) continue;
    polyline(c, [[left, top], [left + side, top], [left + side, top + side], [left, top + side]]);
    c.closePath();
  }
  c.fill();
}
