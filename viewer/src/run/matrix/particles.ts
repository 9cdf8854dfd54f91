/** Chooses how the matrix is drawn: by the graphics card, or on a plain canvas where there is none. */
import type { Film } from "../frames";
import type { ParticlePainter } from "./particle_scene";
import { plainPainter } from "./particles_2d";
import { cardPainter } from "./particles_gl";

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
