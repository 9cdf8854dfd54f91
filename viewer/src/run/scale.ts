/** From a value to a colour: the limits and the colour map with which a layer is drawn. */
import type { Rgb } from "../colour";

export interface Scale {
  low: number;
  high: number;
  map: readonly Rgb[];
  /** Whether areas beyond the limits are hatched: once a person has set limits of their own. */
  hatched: boolean;
}

/** Hatching: stripes across the picture, in pixels of the page. */
export const hatchPeriod = 9;
export const hatchWidth = 2.5;
export const hatchStrength = 0.65;

/** Stripes are dark on light colours and light on dark ones. */
export const isBright = (r: number, g: number, b: number): boolean => 0.3 * r + 0.59 * g + 0.11 * b > 128;
