/**
 * The fibres of the matrix: springs between reference neighbours, drawn as lines and coloured by their strain
 * |x_ij|/|X_ij| - 1, which follows from where their ends are. They are the same at all times; one with an end in the fluid is gone.
 */
import { css, mapped } from "../../colour";
import { valueAt } from "../../embedded";
import type { Camera } from "../camera";
import { between, fewFrames, solidFrom, type Fibres, type Film, type Place } from "../frames";
import { layerOf, type Layer } from "../matrix/layers";
import type { Scale } from "../matrix/scale";
import type { Pen } from "./pen";

/** Strain of a fibre at a place, NaN if it is gone. */
export function strainAt({ x, f }: Film, { ends, length }: Fibres, place: Place, k: number): number {
  const [i, j] = [ends[2 * k], ends[2 * k + 1]];
  if (between(f, place, i) < solidFrom || between(f, place, j) < solidFrom) return NaN;
  const dx = between(x, place, 2 * i) - between(x, place, 2 * j);
  const dy = between(x, place, 2 * i + 1) - between(x, place, 2 * j + 1);
  return Math.hypot(dx, dy) / length[k] - 1;
}

/** Strains of a part of the fibres at four times, ascending. */
function someStrains(film: Film, fibres: Fibres): Float32Array {
  const every = Math.max(1, Math.ceil(fibres.length.length / 30000));
  const all: number[] = [];
  for (const frame of fewFrames(film))
    for (let k = 0; k < fibres.length.length; k += every) {
      const strain = strainAt(film, fibres, { frame, next: frame, fraction: 0 }, k);
      if (!Number.isNaN(strain)) all.push(strain);
    }
  return Float32Array.from(all).sort();
}

/** The strain of the fibres as a layer, for its colours, limits and legend; null without fibres. */
export function fibreLayer(film: Film): Layer | null {
  const { fibres } = film;
  if (!fibres) return null;
  const strains = someStrains(film, fibres);
  const sizes = strains.map(Math.abs).sort();
  const usual = sizes[Math.floor(0.995 * (sizes.length - 1))] || 0;
  const most = usual > 0 ? Number(usual.toPrecision(2)) : 0.1;
  return layerOf({
    key: "fibre_strain",
    name: "Fibre strain",
    unit: "",
    ends: ["shortened, slack", "stretched, taut"],
    note: `Only taut fibres pull; beyond a strain of ${Number(fibres.onset.toPrecision(3))} they stiffen. Fibres in the fluid are gone.`,
    field: null,
    range: { low: strains[0] ?? 0, high: strains[strains.length - 1] ?? 0 },
    low: -most,
    high: most,
    maps: ["blueWhiteOrange", "purpleGreen"],
  });
}

/** Steps of the colour map; odd, so that one is that of no strain. */
const levels = 25;

/** Lines in a path: one of thousands takes a browser several times as long. */
const together = 100;

/** Most lines in a picture, so that it is drawn in time; and least distance of lines [pixels of the page]. */
const mostLines = 30000;
const leastApart = 7;

/** Rows of the lattice of which fibres are drawn: each, or every second and so on. */
export function fibreRows({ bonds }: Fibres, spacing: number, { scale, width, height }: Camera): number {
  const apart = Math.max(leastApart, Math.sqrt((bonds * width * height) / mostLines));
  return Math.max(1, Math.ceil(apart / (spacing * scale)));
}

interface Scene {
  film: Film;
  place: Place;
  camera: Camera;
  spacing: number;
}

export function paintFibres(c: Pen, { film, place, camera, spacing }: Scene, scale: Scale): void {
  const { fibres, reference, x } = film;
  if (!fibres) return;
  const every = fibreRows(fibres, spacing, camera);
  const onRow = (X: number) => every === 1 || Math.abs(X / spacing - every * Math.round(X / (spacing * every))) < 0.4;
  const lines: number[][] = Array.from({ length: levels }, () => []);
  for (let k = 0; k < fibres.length.length; ++k) {
    const i = fibres.ends[2 * k];
    const sx = camera.toScreenX(between(x, place, 2 * i));
    if (sx < -60 || sx > camera.width + 60) continue;
    const sy = camera.toScreenY(between(x, place, 2 * i + 1));
    if (sy < -60 || sy > camera.height + 60) continue;
    if (!onRow(valueAt(reference, 0, 2 * i)) || !onRow(valueAt(reference, 0, 2 * i + 1))) continue;
    const strain = strainAt(film, fibres, place, k);
    if (Number.isNaN(strain)) continue;
    const share = Math.min(1, Math.max(0, (strain - scale.low) / (scale.high - scale.low)));
    const j = fibres.ends[2 * k + 1];
    lines[Math.min(levels - 1, Math.floor(share * levels))].push(
      sx,
      sy,
      camera.toScreenX(between(x, place, 2 * j)),
      camera.toScreenY(between(x, place, 2 * j + 1)),
    );
  }
  c.setLineDash([]);
  c.lineCap = "butt";
  const wide = Math.min(2.4, Math.max(1.5, 0.07 * spacing * camera.scale));
  // The least strained first, faint and thin: what is strained shall be seen.
  const middle = (levels - 1) / 2;
  const order = lines.map((_, k) => k).sort((a, b) => Math.abs(a - middle) - Math.abs(b - middle));
  for (const level of order) {
    const line = lines[level];
    const strength = Math.min(1, (2 * Math.abs(level - middle)) / middle);
    const [r, g, b] = mapped(scale.map, level / (levels - 1));
    c.strokeStyle = strength < 1 ? `rgba(${r},${g},${b},${(0.35 + 0.65 * strength).toFixed(2)})` : css([r, g, b]);
    c.lineWidth = strength < 0.3 ? 1 : wide;
    for (let k = 0; k < line.length; k += 4 * together) {
      c.beginPath();
      for (let n = k; n < Math.min(line.length, k + 4 * together); n += 4) {
        c.moveTo(line[n], line[n + 1]);
        c.lineTo(line[n + 2], line[n + 3]);
      }
      c.stroke();
    }
  }
}
