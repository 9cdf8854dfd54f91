/** Arrows: how the matrix is displaced or moves, what adhesions pull with, where the cell is polarized to; with their keys. */
import colours from "../../colours.json";
import type { Tracks } from "../../contract";
import { roundStep } from "../../numbers";
import { valueAt } from "../../embedded";
import type { Camera } from "../camera";
import { between, solidFrom, type Film, type Place } from "../frames";
import { arrow, edged, ink, labelFont, textWidth, type Pen } from "./pen";

export type ArrowKind = "displacement" | "velocity";

/** The largest of a run that is not rare: sets how long arrows are drawn. */
export interface Usual {
  /** [um] */
  displacement: number;
  /** [um/h] */
  velocity: number;
  /** Largest force of an adhesion in any frame [nN]. */
  force: number;
}

/** Speed that all but one in two hundred particles of the solid stay under [um/h]. */
function usualSpeed(film: Film): number {
  const speeds: number[] = [];
  for (const share of [0.25, 0.5, 0.75, 1]) {
    const frame = Math.max(1, Math.round(share * (film.times.length - 1)));
    if (frame >= film.times.length) break;
    for (let i = 0; i < film.particles; ++i)
      if (valueAt(film.f, frame, i) >= solidFrom) speeds.push(Math.hypot(...velocityAt(film, frame, i)));
  }
  speeds.sort((a, b) => a - b);
  return speeds[Math.floor(0.995 * (speeds.length - 1))] || 1;
}

export function usual(film: Film, displacement: number): Usual {
  const force = Math.max(0, ...film.protrusions.flat().map((p) => p.force_nN));
  return { displacement, velocity: usualSpeed(film), force };
}

/** Mean velocity of a particle from the frame before `frame` to it [um/h]. */
function velocityAt(film: Film, frame: number, i: number): [number, number] {
  const dt = (film.times[frame] - film.times[frame - 1]) / 3600;
  const along = (k: number) => (valueAt(film.x, frame, 2 * i + k) - valueAt(film.x, frame - 1, 2 * i + k)) / dt;
  return [along(0), along(1)];
}

/** Times their true length that displacements are drawn: a round number that makes the largest about 32 pixels long. */
export const displacementScale = (largest: number, camera: Camera): number =>
  Math.max(1, roundStep((0.6 * 32) / (largest * camera.scale)));

/** Pixels that an arrow of one unit is long. */
export function pixelsPerUnit(kind: ArrowKind, from: Usual, camera: Camera): number {
  return kind === "velocity" ? 36 / from.velocity : displacementScale(from.displacement, camera) * camera.scale;
}

interface Scene {
  film: Film;
  place: Place;
  camera: Camera;
  spacing: number;
  dark: boolean;
  /** The layer under the arrows is dark. */
  darkGround: boolean;
}

/** At every so many rows of the lattice, so that arrows stand apart at any zoom. */
export function paintArrows(c: Pen, { film, place, camera, spacing, darkGround }: Scene, kind: ArrowKind, unit: number): void {
  const every = Math.max(1, Math.ceil(15 / (spacing * camera.scale)));
  const onRow = (X: number) => Math.abs(X / spacing - every * Math.round(X / (spacing * every))) < 0.4;
  // A velocity belongs to the span between two frames.
  const ahead = place.next > place.frame ? place.next : place.frame;
  if (kind === "velocity" && ahead === 0) return;
  c.beginPath();
  for (let i = 0; i < film.particles; ++i) {
    const [X, Y] = [valueAt(film.reference, 0, 2 * i), valueAt(film.reference, 0, 2 * i + 1)];
    if (!onRow(X) || !onRow(Y) || valueAt(film.f, place.frame, i) < 0.5) continue;
    const [x, y] = [between(film.x, place, 2 * i), between(film.x, place, 2 * i + 1)];
    const [sx, sy] = [camera.toScreenX(x), camera.toScreenY(y)];
    if (sx < -40 || sy < -40 || sx > camera.width + 40 || sy > camera.height + 40) continue;
    const [u, v] = kind === "velocity" ? velocityAt(film, ahead, i) : [x - X, y - Y];
    if (Math.hypot(u, v) * unit >= 3) arrow(c, sx, sy, unit * u, -unit * v, 5);
  }
  const { line, edge } = ink(darkGround);
  edged(c, line, edge, 1.3, [], 0.8);
}

export const tractionColour = (dark: boolean): string => (dark ? "#ffd84d" : colours.traction);
/** Pixels that the largest force of a run is long. */
const longest = 60;
export const pixelsPerForce = (from: Usual): number => (from.force > 0 ? longest / from.force : 0);

/** Pull of each adhesion on the matrix: from its anchor towards the tip of its protrusion. */
export function paintTraction(c: Pen, { film, place, camera, dark }: Omit<Scene, "darkGround">, outline: Float32Array, unit: number): void {
  for (const p of film.protrusions[place.frame]) {
    if (!p.anchor || p.force_nN <= 0) continue;
    const [dx, dy] = [outline[2 * p.centre] - p.anchor[0], outline[2 * p.centre + 1] - p.anchor[1]];
    const length = Math.hypot(dx, dy);
    if (length === 0) continue;
    const k = (unit * p.force_nN) / length;
    c.beginPath();
    arrow(c, camera.toScreenX(p.anchor[0]), camera.toScreenY(p.anchor[1]), k * dx, -k * dy, 11);
    edged(c, tractionColour(dark), ink(dark).edge, 3);
  }
}

/** Direction of the front, at the centre of the cell. */
export function paintPolarization(c: Pen, camera: Camera, tracks: Tracks, time: number, dark: boolean): void {
  const i = Math.max(0, tracks.t_s.findLastIndex((t) => t <= time));
  const angle = tracks.polarization_rad[i] ?? null;
  if (angle === null) return;
  c.beginPath();
  const length = Math.max(34, 11 * camera.scale);
  const [x, y] = [camera.toScreenX(tracks.x_um[i]), camera.toScreenY(tracks.y_um[i])];
  arrow(c, x, y, length * Math.cos(angle), -length * Math.sin(angle), 14);
  edged(c, ink(dark).line, ink(dark).edge, 4);
}

export interface ArrowKey {
  colour: string;
  edge: string;
  width: number;
  /** Pixels of one unit. */
  unit: number;
  name: string;
  /** True on a dark ground: white arrows. */
  dark: boolean;
}

/** An arrow of round length with its number for each kind drawn, one above the other at the lower right. */
export function paintArrowKeys(c: Pen, camera: Camera, keys: ArrowKey[]): void {
  keys.forEach((key, k) => {
    const value = roundStep(16 / key.unit);
    const text = `${Number(value.toPrecision(3))} ${key.name}`;
    c.font = labelFont;
    const [length, wide] = [value * key.unit, textWidth(c, text)];
    const [x, y] = [camera.width - 16 - length - 8 - wide, camera.height - 18 - 25 * k];
    c.fillStyle = ink(key.dark).veil;
    c.fillRect(x - 8, y - 11, length + wide + 24, 24);
    c.beginPath();
    arrow(c, x, y, length, 0, 9);
    edged(c, key.colour, key.edge, key.width);
    c.fillStyle = ink(key.dark).line;
    c.fillText(text, x + length + 8, y + 5);
  });
}
