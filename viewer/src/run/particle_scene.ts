/** What a painter of the matrix is given, and what both painters of particles agree on. */
import type { Camera } from "./camera";
import type { Place } from "./frames";
import type { Layer } from "./layers";

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
  /** Gives back what it holds of the graphics card. */
  close(): void;
}

/** Sides of the squares over their spacing: the degraded ones overlap and read as one area, the intact ones leave gaps in
 *  which the deformation of the lattice shows, unless they are too small for gaps. */
export const fluidSize = 1.08;
export const intactSize = (spacingPixels: number): number => (spacingPixels < 4 ? 1.08 : 0.84);

/** Below this f_degr a particle counts as fluid where only the solid has a value. */
export const solidFrom = 0.05;
