/** What a painter of the matrix is given, and what all painters agree on. */
import type { Camera } from "../camera";
import type { Place } from "../frames";
import type { Layer } from "./layers";
import type { Patch } from "./resample";
import type { Scale } from "./scale";

export interface ParticleScene {
  place: Place;
  layer: Layer;
  scale: Scale;
  camera: Camera;
  dark: boolean;
  /** The layer interpolated over what is seen; null: particles are drawn as squares. */
  patch: Patch | null;
  /** Pixels of the canvas in a pixel of the page. */
  pixels: number;
}

export interface ParticlePainter {
  canvas: HTMLCanvasElement;
  kind: "webgl2" | "2d";
  paint(scene: ParticleScene): void;
  /** Gives back what it holds of the graphics card. */
  close(): void;
}

/** Sides of the squares over their spacing: the degraded ones overlap and read as one area, the intact ones leave gaps in
 *  which the deformation of the lattice shows, unless they are too small for gaps. */
export const fluidSize = 1.08;
export const intactSize = (spacingPixels: number): number => (spacingPixels < 4 ? 1.08 : 0.84);
