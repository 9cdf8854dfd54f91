/** Numbers and times as people read them, and round ticks for axes. */

const minus = "\u2212";

/** To about four digits; a dash for what does not exist. */
export function readable(value: number | string | null | undefined, digits = 4): string {
  if (value === null || value === undefined) return "\u2013";
  if (typeof value === "string") return value;
  if (!Number.isFinite(value)) return "\u2013";
  const size = Math.abs(value);
  if (Number.isInteger(value) && size < 1e7) return value.toString().replace("-", minus);
  if (size >= 1e5 || size < 1e-3)
    return value
      .toExponential(Math.min(2, digits - 1))
      .replace(/-/g, minus)
      .replace("e+", "e");
  const decimals = Math.max(0, digits - 1 - Math.floor(Math.log10(size)));
  return Number(value.toFixed(decimals)).toString().replace("-", minus);
}

/** Units as they are printed, in a text of the program: "12 um/h" becomes "12 \u00b5m/h". Names such as um_per_h stay. */
export const pretty = (text: string): string => text.replace(/\bum\b/g, "\u00b5m").replace(/\^2\b/g, "\u00b2");

/** "4 h 05 min", "12 min", with seconds where they matter. */
export function timeText(seconds: number): string {
  const whole = Math.round(seconds);
  const hours = Math.floor(whole / 3600);
  const minutes = Math.floor((whole % 3600) / 60);
  const rest = whole % 60;
  const tail = rest > 0 ? ` ${String(rest).padStart(2, "0")} s` : "";
  if (hours > 0) return `${hours} h ${String(minutes).padStart(2, "0")} min${tail}`;
  return minutes > 0 || rest === 0 ? `${minutes} min${tail}` : `${rest} s`;
}

/** p as a paper writes it. */
export function pText(p: number | null): string {
  if (p === null) return "p not defined";
  return p < 0.0001 ? "p < 0.0001" : `p = ${p.toPrecision(2)}`;
}

/** @param p  corrected, where there are several comparisons */
export function stars(p: number | null): string {
  if (p === null || p >= 0.05) return "n.s.";
  return p < 0.001 ? "***" : p < 0.01 ? "**" : "*";
}

/** The smallest of 1, 2, 5 times a power of ten that is at least `least`. */
export function roundStep(least: number): number {
  const decade = 10 ** Math.floor(Math.log10(least) + 1e-9);
  for (const m of [1, 2, 5]) if (m * decade >= least * (1 - 1e-9)) return m * decade;
  return 10 * decade;
}

/** Round numbers inside [low, high], about `count` of them. */
export function ticks(low: number, high: number, count: number, step = roundStep((high - low) / count)): number[] {
  if (!(high > low)) return [low];
  const out: number[] = [];
  for (let k = Math.ceil(low / step - 1e-9); k * step <= high + 1e-9 * step; ++k) out.push(k === 0 ? 0 : k * step);
  return out.map((v) => Number(v.toPrecision(12)));
}
