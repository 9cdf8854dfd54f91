/** A moment in the address of the page: `#t=3h12m&layer=pressure`. */

export interface Moment {
  /** [s]; null: not said. */
  time: number | null;
  layer: string | null;
}

/** Whole seconds, without parts that are zero. */
export function momentTime(seconds: number): string {
  const whole = Math.round(seconds);
  const parts = [Math.floor(whole / 3600), Math.floor((whole % 3600) / 60), whole % 60];
  return parts.map((v, k) => (v > 0 ? `${v}${"hms"[k]}` : "")).join("") || "0m";
}

export const momentHash = (time: number, layer: string): string =>
  `#t=${momentTime(time)}&layer=${encodeURIComponent(layer)}`;

/** Also takes bare seconds. */
export function momentOf(hash: string): Moment {
  const values = new URLSearchParams(hash.replace(/^#/, ""));
  const text = values.get("t") ?? "";
  const found = /^(?:(\d+(?:\.\d+)?)h)?(?:(\d+(?:\.\d+)?)m)?(?:(\d+(?:\.\d+)?)s?)?$/.exec(text);
  const time =
    text === "" || !found ? null : 3600 * Number(found[1] ?? 0) + 60 * Number(found[2] ?? 0) + Number(found[3] ?? 0);
  return { time, layer: values.get("layer") };
}
