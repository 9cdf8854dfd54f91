/** From a value to a colour: the limits and the colour map with which a layer is drawn. */
import { colourMaps, mapped, type MapKey, type Rgb } from "../../colour";
import { extremes, type Layer } from "./layers";
import type { Film } from "../frames";
import type { Usual } from "../over/arrows";

export interface Scale {
  low: number;
  high: number;
  map: readonly Rgb[];
  /** True if areas beyond the limits are hatched: after a person has set limits. */
  hatched: boolean;
}

/** What has colours, the matrix or the edge of the cell, as a colour bar shows them. */
export interface Coloured {
  layer: Pick<Layer, "name" | "symbol" | "unit" | "ends">;
  scale: Omit<Scale, "hatched">;
  /** Ends of the scale beyond which there are values. */
  clamped: { low: boolean; high: boolean };
}

/** Limits and colour map of a layer, as a person may have changed them. Runs beside each other may share them. */
export class Limits {
  low: number;
  high: number;
  map: MapKey;
  /** Limits and colour map at the start. */
  private readonly home: { low: number; high: number; map: MapKey };

  constructor(layer: Layer) {
    const { low, high } = layer;
    this.home = { low, high, map: layer.maps[0] };
    ({ low: this.low, high: this.high, map: this.map } = this.home);
  }

  /** Widens the limits, unless they have been set, so that the same layer of another run fits in. */
  include(layer: Layer): void {
    const { edited, home } = this;
    home.low = Math.min(home.low, layer.low);
    home.high = Math.max(home.high, layer.high);
    if (!edited) ({ low: this.low, high: this.high } = home);
  }

  reset(): void {
    ({ low: this.low, high: this.high, map: this.map } = this.home);
  }

  /** Returns whether these can be limits. */
  set(low: number, high: number): boolean {
    if (!Number.isFinite(low) || !Number.isFinite(high) || !(high > low)) return false;
    [this.low, this.high] = [low, high];
    return true;
  }

  get edited(): boolean {
    return this.low !== this.home.low || this.high !== this.home.high;
  }
}

/** How a layer of a run is coloured. */
export class LayerScale {
  private range: { low: number; high: number } | null = null;
  /** When it was found, where the film grows. */
  private found = 0;

  constructor(
    private readonly layer: Layer,
    private readonly film: Film,
    readonly limits = new Limits(layer),
  ) {}

  get low(): number {
    return this.limits.low;
  }

  get high(): number {
    return this.limits.high;
  }

  /** Smallest and largest value; of a film that grows, its newest moment is looked at once a second. */
  private reach(): { low: number; high: number } {
    const { film, layer } = this;
    if (!this.range) this.range = extremes(film, layer);
    else if (film.growing && performance.now() > this.found + 1000) {
      const { low, high } = extremes(film, layer, film.times.length - 1);
      this.range = { low: Math.min(low, this.range.low), high: Math.max(high, this.range.high) };
    } else return this.range;
    this.found = performance.now();
    return this.range;
  }

  /** The ends of the bar beyond which values lie, or at which stored values were cut off. */
  clamped(): { low: boolean; high: boolean } {
    const { layer } = this;
    const range = this.reach();
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
    return { low: this.low, high: this.high, map: colourMaps[this.limits.map].on(dark), hatched: this.limits.edited };
  }

  bar(dark: boolean): Coloured {
    return { layer: this.layer, scale: this.on(dark), clamped: this.clamped() };
  }
}

/** True if most of a layer is dark, so that the signs on it should be light. */
export function isDarkGround(layer: Layer, { map, low, high }: Scale): boolean {
  return !isBright(...mapped(map, (layer.rest - low) / (high - low)));
}

/** Hatching: stripes across the picture, in pixels of the page. */
export const hatchPeriod = 9;
export const hatchWidth = 2.5;
export const hatchStrength = 0.65;

/** Stripes are dark on light colours and light on dark ones. */
export const isBright = (r: number, g: number, b: number): boolean => 0.3 * r + 0.59 * g + 0.11 * b > 128;

/** What runs beside each other have in common, so that their pictures can be compared: limits of colours, lengths of arrows. */
export class SharedScales {
  /** Of all runs together. */
  readonly usual: Usual = { displacement: 0, velocity: 0, force: 0 };
  private shared = true;
  private readonly limits = new Map<string, Limits>();
  private readonly members = new Map<object, () => void>();

  /** True if limits are shared; else each run has its own. */
  get on(): boolean {
    return this.shared;
  }

  set on(on: boolean) {
    this.shared = on;
    this.tell(null);
  }

  /**
   * @param all      what the run can colour
   * @param changed  called when others have changed what is shared
   * @param gone     when the run is taken away
   */
  join(member: object, all: Layer[], usual: Usual, changed: () => void, gone: AbortSignal): void {
    for (const layer of all) {
      const there = this.limits.get(layer.key);
      if (there) there.include(layer);
      else this.limits.set(layer.key, new Limits(layer));
    }
    for (const key of ["displacement", "velocity", "force"] as const)
      this.usual[key] = Math.max(this.usual[key], usual[key]);
    this.members.set(member, changed);
    gone.addEventListener("abort", () => this.members.delete(member));
    this.tell(member);
  }

  of(layer: Layer): Limits | undefined {
    return this.limits.get(layer.key);
  }

  /** @param by  who changed something, and need not be told */
  tell(by: object | null): void {
    for (const [member, changed] of this.members) if (member !== by) changed();
  }
}
