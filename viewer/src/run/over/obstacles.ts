/** Rigid obstacles: squares where their particles lie, over any layer, since they have no values of their own. */
import colours from "../../colours.json";
import type { Camera } from "../camera";
import type { Film } from "../frames";
import type { Pen } from "./pen";

export const obstacleColour = colours.obstacle;
export const obstacleColourOnDark = "#9aa3ad";

export function paintObstacles(c: Pen, film: Film, camera: Camera, spacing: number, dark: boolean): void {
  if (film.obstacles.length === 0) return;
  const side = 1.08 * spacing * camera.scale;
  c.fillStyle = dark ? obstacleColourOnDark : obstacleColour;
  c.beginPath();
  for (const [x, y] of film.obstacles) {
    const [left, top] = [camera.toScreenX(x) - 0.5 * side, camera.toScreenY(y) - 0.5 * side];
    if (left < -side || top < -side || left > camera.width || top > camera.height) continue;
    c.moveTo(left, top);
    c.lineTo(left + side, top);
    c.lineTo(left + side, top + side);
    c.lineTo(left, top + side);
    c.closePath();
  }
  c.fill();
}
