/** What is taken of the stage for a picture of its own. */
import type { Camera } from "./camera";
import type { Layer } from "./matrix/layers";
import type { Scale } from "./matrix/scale";

/** A layer with its colours, as a colour bar shows them. */
export interface Coloured {
  layer: Layer;
  scale: Scale;
  /** Ends of the scale beyond which there are values. */
  clamped: { low: boolean; high: boolean };
}

/** A picture of the stage as it is. */
export interface View {
  camera: Camera;
  /** Pixels of the canvases in a pixel of the page. */
  pixels: number;
  matrix: HTMLCanvasElement;
  top: HTMLCanvasElement;
  /** What colours stand for: the layer, and the strain of fibres where they are drawn. */
  bars: Coloured[];
  title: string;
  time: number;
  dark: boolean;
}
