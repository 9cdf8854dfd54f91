/** What runs beside each other have in common, so that their pictures can be compared: limits of colours, lengths of arrows. */
import type { Camera } from "../camera";
import type { Place } from "../frames";
import type { Usual } from "../over/arrows";
import type { Layer } from "./layers";
import type { Patch } from "./resample";
import { Limits, type Scale } from "./scale";

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

// What the painter of the matrix is given.

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
