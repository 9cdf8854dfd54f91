/** Draws the matrix as squares. Two ways, one interface: the graphics card, or a plain canvas where there is none. */
import type { Camera } from "./camera";
import type { Film, Place } from "./frames";
import type { Layer } from "./layers";
import { plainPainter } from "./particles_2d";
import { cardPainter } from "./particles_gl";

export interface ParticleScene {
  place: Place;
  layer: Layer;
  camera: Camera;
  dark: boolean;
}

export interface ParticlePainter {
  canvas: HTMLCanvasElement;
  kind: "webgl2" | "2d";
  paint(scene: ParticleScene): void;
}

/** Sides of the squares over their spacing: the degraded ones overlap and read as one area, the intact ones leave gaps in
 *  which the deformation of the lattice shows, unless they are too small for gaps. */
export const fluidSize = 1.08;
export const intactSize = (spacingPixels: number): number => (spacingPixels < 4 ? 1.08 : 0.84);

/** Below this f_degr a particle counts as fluid where only the solid has a value. */
export const solidFrom = 0.05;

/** A canvas that once had a context of one kind gives no other, so the fallback draws on a fresh one in its place. */
export function plainInstead(canvas: HTMLCanvasElement, film: Film, spacing: number): ParticlePainter {
  const fresh = canvas.cloneNode() as HTMLCanvasElement;
  canvas.replaceWith(fresh);
  return plainPainter(fresh, film, spacing);
}

/**
 * `?draw=2d` or `?draw=webgl` behind the address of the page forces one of the two, to find out what is wrong with a picture.
 * @param lost  called when the card gives up its context; `plainInstead` then goes on
 */
export function particlePainter(
  canvas: HTMLCanvasElement,
  film: Film,
  spacing: number,
  lost: () => void,
): ParticlePainter {
  const wanted = new URLSearchParams(location.search).get("draw");
  return (
    (wanted === "2d" ? null : cardPainter(canvas, film, spacing, lost, wanted === "webgl")) ??
    plainInstead(canvas, film, spacing)
  );
}
