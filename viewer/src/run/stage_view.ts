/** What is taken of the stage for a picture of its own. */
import type { Camera } from "./camera";
import type { Layer } from "./matrix/layers";
import type { Scale } from "./matrix/scale";

/** What has colours, the matrix or the edge of the cell, as a colour bar shows them. */
export interface Coloured {
  layer: Pick<Layer, "name" | "symbol" | "unit" | "ends">;
  scale: Omit<Scale, "hatched">;
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
  /** What colours stand for: the layer; where they are drawn, the strain of fibres and the edge of the cell. */
  bars: Coloured[];
  title: string;
  time: number;
  dark: boolean;
}
