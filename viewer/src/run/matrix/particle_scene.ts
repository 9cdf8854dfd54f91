/** What the painter of the matrix is given. */
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
