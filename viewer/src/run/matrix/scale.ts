/** From a value to a colour: the limits and the colour map with which a layer is drawn. */
import { colourMaps, mapped, type MapKey, type Rgb } from "../../colour";
import { extremes, type Layer } from "./layers";
import type { Film } from "../frames";

export interface Scale {
  low: number;
  high: number;
  map: readonly Rgb[];
  /** Whether areas beyond the limits are hatched: once a person has set limits of their own. */
  hatched: boolean;
}

/** How one layer is coloured, as a person may have changed it. */
export class LayerScale {
  low: number;
  high: number;
  map: MapKey;
  private range: { low: number; high: number } | null = null;

  constructor(
    private readonly layer: Layer,
    private readonly film: Film,
  ) {
    [this.low, this.high, this.map] = [layer.low, layer.high, layer.maps[0]];
  }

  reset(): void {
    [this.low, this.high, this.map] = [this.layer.low, this.layer.high, this.layer.maps[0]];
  }

  /** Returns whether these can be limits. */
  set(low: number, high: number): boolean {
    if (!Number.isFinite(low) || !Number.isFinite(high) || !(high > low)) return false;
    [this.low, this.high] = [low, high];
    return true;
  }

  get edited(): boolean {
    return this.low !== this.layer.low || this.high !== this.layer.high;
  }

  /** At which ends of the bar values of this run lie beyond it, or were cut off when they were stored. */
  clamped(): { low: boolean; high: boolean } {
    this.range ??= extremes(this.film, this.layer);
    const { range, layer } = this;
    const slack = 1e-6 * (this.high - this.low);
    const stored = layer.field ? [layer.field.offset, layer.field.offset + 255 * layer.field.scale] : [NaN, NaN];
    const isAt = (a: number, b: number) => Math.abs(a - b) <= slack;
    return {
      low: range.low < this.low - slack || (layer.cut.low && isAt(range.low, stored[0]) && this.low >= stored[0] - slack),
      high:
        range.high > this.high + slack || (layer.cut.high && isAt(range.high, stored[1]) && this.high <= stored[1] + slack),
    };
  }

  on(dark: boolean): Scale {
    return { low: this.low, high: this.high, map: colourMaps[this.map].on(dark), hatched: this.edited };
  }
}

/** Whether most of a layer is dark, so that what is drawn on it should be light. */
export function isDarkGround(layer: Layer, { map, low, high }: Scale): boolean {
  return !isBright(...mapped(map, (layer.rest - low) / (high - low)));
}

/** Hatching: stripes across the picture, in pixels of the page. */
export const hatchPeriod = 9;
export const hatchWidth = 2.5;
export const hatchStrength = 0.65;

/** Stripes are dark on light colours and light on dark ones. */
export const isBright = (r: number, g: number, b: number): boolean => 0.3 * r + 0.59 * g + 0.11 * b > 128;
