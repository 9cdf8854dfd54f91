/** Draws what lies over the matrix: the cell with front and rear, its protrusions, adhesions, path, and arrows. */
import { nucleusColour, phaseColoursOn } from "../../colour";
import type { FrameProtrusion, Tracks } from "../../contract";
import type { MeasuredTrack } from "../../measured";
import { roundStep } from "../../numbers";
import { type Field, valueAt } from "../../embedded";
import { paintArrowKeys, paintArrows, paintPolarization, paintTraction, pixelsPerForce, pixelsPerUnit, tractionColour } from "./arrows";
import type { ArrowKey, ArrowKind, Usual } from "./arrows";
import type { Camera } from "../camera";
import { coloursOf, tracksOfCells, type CellPart } from "../cells";
import { paintEdge, type Edge } from "./edge";
import { between, outlineAt, type Film, type Place } from "../frames";
import type { Shown } from "../matrix/layers";
import type { Scale } from "../matrix/scale";
import { paintFibres } from "./fibres";
import { paintMeasured, paintObstacles } from "./marks";
import { edged, ink, labelFont, polyline, textWidth, type Pen } from "./pen";

export interface CellScene {
  film: Film;
  place: Place;
  time: number;
  camera: Camera;
  tracks: Tracks;
  /** Tracks of measured cells. */
  measured: MeasuredTrack[];
  shown: Shown;
  edge: Edge;
  spacing: number;
  arrows: ArrowKind;
  usual: Usual;
  /** Colours of the strain of the fibres; null: they are not drawn. */
  fibres: Scale | null;
  dark: boolean;
  /** The layer under the arrows is dark. */
  darkGround: boolean;
}

/** Arcs of a ring: stretches of neighbouring entries that fulfil a condition, each as indices in order. */
function arcs(n: number, has: (i: number) => boolean): number[][] {
  let start = 0;
  while (start < n && has(start)) ++start;
  if (start === n) return [range(0, n)];
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

/** A new path along points of an outline. */
function trace(c: Pen, camera: Camera, outline: Float32Array, indices: number[]): void {
  c.beginPath();
  polyline(c, indices.map((i) => [camera.toScreenX(outline[2 * i]), camera.toScreenY(outline[2 * i + 1])]));
}

/** So many numbers from `first` on. */
const range = (first: number, count: number): number[] => Array.from({ length: count }, (_, i) => first + i);

/** Arcs of one cell, as indices on the outline of all cells. */
const arcsOf = ({ first, end }: CellPart, has: (i: number) => boolean): number[][] =>
  arcs(end - first, (i) => has(first + i)).map((arc) => arc.map((i) => first + i));

function paintBody(c: Pen, { film, place, camera }: CellScene, outline: Float32Array, cell: CellPart): void {
  const { rear, front } = coloursOf(cell.number, film.cells.length);
  c.save();
  trace(c, camera, outline, range(cell.first, cell.end - cell.first));
  c.closePath();
  c.fillStyle = rear;
  c.fill();
  c.clip();
  c.fillStyle = front;
  for (const arc of arcsOf(cell, (i) => valueAt(film.outline.front, place.frame, i) > 0.5)) {
    trace(c, camera, outline, arc);
    c.closePath();
    c.fill();
  }
  c.restore();
}

/** The nucleus of each cell. */
function paintNuclei(c: Pen, { film, place, camera }: CellScene, nucleus: Field): void {
  const points = nucleus.stride / 2;
  const outline = Float32Array.from({ length: 2 * points }, (_, i) => between(nucleus, place, i));
  const each = points / film.cells.length;
  c.fillStyle = nucleusColour;
  for (let cell = 0; cell < film.cells.length; ++cell) {
    trace(c, camera, outline, range(cell * each, each));
    c.closePath();
    c.fill();
  }
}

/** The number of a cell in its middle: colours repeat, and not everybody sees them. */
function paintNumber(c: Pen, camera: Camera, outline: Float32Array, cell: CellPart): void {
  const middle = [0, 1].map((k) => {
    let sum = 0;
    for (let i = cell.first; i < cell.end; ++i) sum += outline[2 * i + k];
    return sum / (cell.end - cell.first);
  });
  const [x, y] = [camera.toScreenX(middle[0]), camera.toScreenY(middle[1])];
  const text = String(cell.number);
  c.font = labelFont;
  disc(c, x, y, 10, "rgba(255,255,255,.85)");
  c.fillStyle = "#1f2328";
  c.fillText(text, x - 0.5 * textWidth(c, text), y + 5);
}

function paintProtrusion(c: Pen, scene: CellScene, outline: Float32Array, p: FrameProtrusion, slot: number): void {
  const { film, place, camera, dark } = scene;
  const colour = phaseColoursOn(dark)[p.phase];
  const cell = film.cells.find(({ first, end }) => p.centre >= first && p.centre < end) ?? film.cells[0];
  for (const arc of arcsOf(cell, (i) => valueAt(film.outline.protrusion, place.frame, i) === slot)) {
    trace(c, camera, outline, arc);
    edged(c, colour, ink(dark).edge, Math.min(5, Math.max(2.2, 0.5 * camera.scale)), p.phase === 3 ? [5, 4] : []);
  }
}

function disc(c: Pen, x: number, y: number, radius: number, colour: string): void {
  c.beginPath();
  c.arc(x, y, radius, 0, 2 * Math.PI);
  c.fillStyle = colour;
  c.fill();
}

function paintAdhesion(c: Pen, { camera, dark }: CellScene, outline: Float32Array, p: FrameProtrusion): void {
  if (!p.anchor) return;
  const [ax, ay] = [camera.toScreenX(p.anchor[0]), camera.toScreenY(p.anchor[1])];
  const colour = phaseColoursOn(dark)[p.phase];
  const { edge } = ink(dark);
  c.beginPath();
  c.moveTo(camera.toScreenX(outline[2 * p.centre]), camera.toScreenY(outline[2 * p.centre + 1]));
  c.lineTo(ax, ay);
  edged(c, colour, edge, 1.6);
  disc(c, ax, ay, 2.5 + 5 * p.f_mat, colour);
  c.lineWidth = 1.2;
  c.strokeStyle = edge;
  c.stroke();
}

/** @param colour  of the line */
function paintPath(c: Pen, { camera, time, dark }: CellScene, tracks: Tracks, colour: string): void {
  c.beginPath();
  for (let i = 0; i < tracks.t_s.length && tracks.t_s[i] <= time; ++i)
    c.lineTo(camera.toScreenX(tracks.x_um[i]), camera.toScreenY(tracks.y_um[i]));
  edged(c, colour, ink(dark).edge, 1.6);
  if (tracks.t_s.length === 0) return;
  disc(c, camera.toScreenX(tracks.x_um[0]), camera.toScreenY(tracks.y_um[0]), 3.6, ink(dark).edge);
  c.lineWidth = 1.8;
  c.strokeStyle = colour;
  c.stroke();
}

function paintScaleBar(c: Pen, { camera, dark }: CellScene): void {
  const most = (0.3 * camera.width) / camera.scale;
  let length = roundStep(0.4 * most);
  if (length > most) length *= 0.4;
  const [x, y, w] = [14, camera.height - 18, length * camera.scale];
  const text = `${Number(length.toPrecision(3))} \u00b5m`;
  c.font = labelFont;
  c.fillStyle = ink(dark).veil;
  c.fillRect(x - 7, y - 9, w + textWidth(c, text) + 23, 22);
  c.fillStyle = dark ? "#f0f3f6" : "#1f2328";
  c.fillRect(x, y, w, 4);
  c.fillText(text, x + w + 8, y + 7);
}

/** Keys of the arrows that are shown. */
function keys({ shown, arrows, usual, camera, dark, darkGround }: CellScene): ArrowKey[] {
  const out: ArrowKey[] = [];
  if (shown.traction && usual.force > 0)
    out.push({ colour: tractionColour(dark), edge: ink(dark).edge, width: 3, unit: pixelsPerForce(usual), name: "nN traction", dark });
  if (shown.arrows) {
    const name = arrows === "velocity" ? "\u00b5m/h" : "\u00b5m displacement";
    const { line, edge } = ink(darkGround);
    out.push({ colour: line, edge, width: 1.4, unit: pixelsPerUnit(arrows, usual, camera), name, dark: darkGround });
  }
  return out;
}

export function paintCell(c: Pen, scene: CellScene): void {
  const { film, place, camera, shown, usual, arrows, dark } = scene;
  const outline = outlineAt(film, place);
  const alive = film.protrusions[place.frame];
  const bodies = shown.cell ? film.cells : [];
  const part = (name: string) => c.part?.(name);
  part("obstacles");
  paintObstacles(c, film, camera, scene.spacing, dark);
  part("fibres");
  if (scene.fibres) paintFibres(c, scene, scene.fibres);
  part("arrows");
  if (shown.arrows) paintArrows(c, scene, arrows, pixelsPerUnit(arrows, usual, camera));
  part("cell");
  for (const cell of bodies) paintBody(c, scene, outline, cell);
  if (shown.cell && film.nucleus) paintNuclei(c, scene, film.nucleus);
  part("protrusions");
  if (shown.protrusions) alive.forEach((p, slot) => paintProtrusion(c, scene, outline, p, slot));
  part("edge");
  // Drawn over the protrusions, so that a chosen colour of the edge stays visible there.
  paintEdge(c, camera, outline, bodies, scene.edge, place);
  part("adhesions");
  if (shown.adhesions) alive.forEach((p) => paintAdhesion(c, scene, outline, p));
  // Over the cell, which would hide short tracks.
  part("measured");
  if (shown.measured) paintMeasured(c, scene.measured, scene.tracks, scene.time, camera, dark);
  part("path");
  const tracks = tracksOfCells(scene.tracks);
  const lineOf = (number: number) => {
    if (tracks.length === 1) return ink(dark).line;
    const { rear, front } = coloursOf(number, tracks.length);
    return dark ? front : rear;
  };
  if (shown.path) for (const one of tracks) paintPath(c, scene, one.tracks, lineOf(one.number));
  part("polarization");
  if (shown.polarization) for (const one of tracks) paintPolarization(c, camera, one.tracks, scene.time, dark);
  part("numbers");
  if (bodies.length > 1) for (const cell of bodies) paintNumber(c, camera, outline, cell);
  part("traction");
  if (shown.traction) paintTraction(c, scene, outline, pixelsPerForce(usual));
  part("scales");
  paintScaleBar(c, scene);
  paintArrowKeys(c, camera, keys(scene));
}
