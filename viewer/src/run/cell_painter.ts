/** Draws what lies over the matrix: the cell with front and rear, its protrusions, adhesions, path, and arrows. */
import { frontColour, phaseColours, phaseColoursOnDark, rearColour } from "../colour";
import type { FrameProtrusion, Tracks } from "../contract";
import { roundStep } from "../numbers";
import { valueAt } from "../unpack";
import type { Camera } from "./camera";
import { paintEdge, type Edge } from "./edge";
import { between, outlineAt, type Film, type Place } from "./frames";
import type { Shown } from "./layers";

export interface CellScene {
  film: Film;
  place: Place;
  time: number;
  camera: Camera;
  tracks: Tracks;
  shown: Shown;
  edge: Edge;
  spacing: number;
  /** Times the displacement that an arrow is long. */
  arrowScale: number;
  dark: boolean;
}

type Context = CanvasRenderingContext2D;

/** A line with a light (or dark) edge, so that it is seen on any ground. */
function edged(c: Context, colour: string, edge: string, width: number, dash: number[] = []): void {
  c.lineJoin = c.lineCap = "round";
  c.setLineDash([]);
  c.strokeStyle = edge;
  c.lineWidth = width + 2;
  c.stroke();
  c.lineCap = dash.length > 0 ? "butt" : "round";
  c.setLineDash(dash);
  c.strokeStyle = colour;
  c.lineWidth = width;
  c.stroke();
  c.setLineDash([]);
}

/** Runs of entries that fulfil a condition around a ring, each as indices in order. */
function runs(n: number, has: (i: number) => boolean): number[][] {
  let start = 0;
  while (start < n && has(start)) ++start;
  if (start === n) return [Array.from({ length: n }, (_, i) => i)];
  const out: number[][] = [];
  let open: number[] | null = null;
  for (let k = 1; k <= n; ++k) {
    const i = (start + k) % n;
    if (!has(i)) open = null;
    else if (open) open.push(i);
    else out.push((open = [i]));
  }
  return out;
}

function trace(c: Context, camera: Camera, outline: Float32Array, indices: Iterable<number>): void {
  let first = true;
  for (const i of indices) {
    const [x, y] = [camera.toScreenX(outline[2 * i]), camera.toScreenY(outline[2 * i + 1])];
    if (first) c.moveTo(x, y);
    else c.lineTo(x, y);
    first = false;
  }
}

function paintBody(c: Context, { film, place, camera }: CellScene, outline: Float32Array): void {
  const n = film.outlinePoints;
  const all = Array.from({ length: n }, (_, i) => i);
  c.save();
  c.beginPath();
  trace(c, camera, outline, all);
  c.closePath();
  c.fillStyle = rearColour;
  c.fill();
  c.clip();
  c.fillStyle = frontColour;
  for (const run of runs(n, (i) => valueAt(film.outline.front, place.frame, i) > 0.5)) {
    c.beginPath();
    trace(c, camera, outline, run);
    c.closePath();
    c.fill();
  }
  c.restore();
}

function paintProtrusion(c: Context, scene: CellScene, outline: Float32Array, p: FrameProtrusion, slot: number): void {
  const { film, place, camera, dark } = scene;
  const colour = (dark ? phaseColoursOnDark : phaseColours)[p.phase];
  for (const run of runs(film.outlinePoints, (i) => valueAt(film.outline.protrusion, place.frame, i) === slot)) {
    c.beginPath();
    trace(c, camera, outline, run);
    edged(
      c,
      colour,
      dark ? "#14171a" : "#ffffff",
      Math.min(5, Math.max(2.2, 0.5 * camera.scale)),
      p.phase === 3 ? [5, 4] : [],
    );
  }
}

function paintAdhesion(c: Context, { camera, dark }: CellScene, outline: Float32Array, p: FrameProtrusion): void {
  if (!p.anchor) return;
  const [ax, ay] = [camera.toScreenX(p.anchor[0]), camera.toScreenY(p.anchor[1])];
  const colour = (dark ? phaseColoursOnDark : phaseColours)[p.phase];
  const edge = dark ? "#14171a" : "#ffffff";
  c.beginPath();
  c.moveTo(camera.toScreenX(outline[2 * p.centre]), camera.toScreenY(outline[2 * p.centre + 1]));
  c.lineTo(ax, ay);
  edged(c, colour, edge, 1.6);
  c.beginPath();
  c.arc(ax, ay, 2.5 + 5 * p.f_mat, 0, 2 * Math.PI);
  c.fillStyle = colour;
  c.fill();
  c.lineWidth = 1.2;
  c.strokeStyle = edge;
  c.stroke();
}

function paintPath(c: Context, { camera, tracks, time, dark }: CellScene): void {
  c.beginPath();
  for (let i = 0; i < tracks.t_s.length && tracks.t_s[i] <= time; ++i)
    c.lineTo(camera.toScreenX(tracks.x_um[i]), camera.toScreenY(tracks.y_um[i]));
  edged(c, dark ? "#ffffff" : "#1f2328", dark ? "#14171a" : "#ffffff", 1.6);
  if (tracks.t_s.length === 0) return;
  c.beginPath();
  c.arc(camera.toScreenX(tracks.x_um[0]), camera.toScreenY(tracks.y_um[0]), 3.6, 0, 2 * Math.PI);
  c.fillStyle = dark ? "#14171a" : "#ffffff";
  c.fill();
  c.lineWidth = 1.8;
  c.strokeStyle = dark ? "#ffffff" : "#1f2328";
  c.stroke();
}

/** Arrows at every so many rows of the lattice, so that they stand apart at any zoom. */
function paintArrows(c: Context, { film, place, camera, spacing, arrowScale, dark }: CellScene): void {
  const every = Math.max(1, Math.ceil(15 / (spacing * camera.scale)));
  const onRow = (X: number) => Math.abs(X / spacing - every * Math.round(X / (spacing * every))) < 0.4;
  c.strokeStyle = dark ? "#ffffff" : "#1f2328";
  c.lineWidth = 1.1;
  c.lineCap = "round";
  c.beginPath();
  for (let i = 0; i < film.particles; ++i) {
    const [X, Y] = [valueAt(film.reference, 0, 2 * i), valueAt(film.reference, 0, 2 * i + 1)];
    if (!onRow(X) || !onRow(Y) || valueAt(film.f, place.frame, i) < 0.5) continue;
    const [x, y] = [between(film.x, place, 2 * i), between(film.x, place, 2 * i + 1)];
    const [dx, dy] = [arrowScale * (x - X) * camera.scale, -arrowScale * (y - Y) * camera.scale];
    const length = Math.hypot(dx, dy);
    if (length < 1.5) continue;
    const [sx, sy] = [camera.toScreenX(x), camera.toScreenY(y)];
    if (sx < -40 || sy < -40 || sx > camera.width + 40 || sy > camera.height + 40) continue;
    const head = Math.min(5, 0.4 * length) / length;
    c.moveTo(sx, sy);
    c.lineTo(sx + dx, sy + dy);
    c.moveTo(sx + dx - head * (dx + 0.6 * dy), sy + dy - head * (dy - 0.6 * dx));
    c.lineTo(sx + dx, sy + dy);
    c.lineTo(sx + dx - head * (dx - 0.6 * dy), sy + dy - head * (dy + 0.6 * dx));
  }
  c.stroke();
}

function paintScaleBar(c: Context, { camera, dark }: CellScene): void {
  const most = (0.3 * camera.width) / camera.scale;
  let length = roundStep(0.4 * most);
  if (length > most) length *= 0.4;
  const [x, y, w] = [14, camera.height - 18, length * camera.scale];
  const text = `${Number(length.toPrecision(3))} \u00b5m`;
  c.font = "600 14px system-ui, 'Segoe UI', Helvetica, Arial, sans-serif";
  c.fillStyle = dark ? "rgba(20,23,26,.8)" : "rgba(255,255,255,.85)";
  c.fillRect(x - 7, y - 9, w + c.measureText(text).width + 23, 22);
  c.fillStyle = dark ? "#f0f3f6" : "#1f2328";
  c.fillRect(x, y, w, 4);
  c.fillText(text, x + w + 8, y + 7);
}

/** @param pixels  pixels of the canvas in a pixel of the page */
export function paintCell(canvas: HTMLCanvasElement, scene: CellScene, pixels: number): void {
  const c = canvas.getContext("2d");
  if (!c) return;
  const { film, place, camera, shown } = scene;
  c.setTransform(pixels, 0, 0, pixels, 0, 0);
  c.clearRect(0, 0, camera.width, camera.height);
  const outline = outlineAt(film, place);
  if (shown.arrows) paintArrows(c, scene);
  if (shown.cell) paintBody(c, scene, outline);
  const alive = film.protrusions[place.frame];
  if (shown.protrusions) alive.forEach((p, slot) => paintProtrusion(c, scene, outline, p, slot));
  // Over the protrusions: whoever chose a colour for the edge wants to see it there above all.
  if (shown.cell) paintEdge(c, camera, outline, scene.edge, place);
  if (shown.adhesions) alive.forEach((p) => paintAdhesion(c, scene, outline, p));
  if (shown.path) paintPath(c, scene);
  paintScaleBar(c, scene);
}
