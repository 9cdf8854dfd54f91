/** The writer's side of a packed array, in the browser's language: what the program does, and what the tests compare with. */
import { readFileSync } from "node:fs";
import { deflateSync } from "node:zlib";
import type { Packed } from "../src/contract";

export interface Quantisation {
  type: "int16" | "uint8";
  components: 1 | 2;
  scale: number;
  offset: number;
  delta: boolean;
}

/** @param frames  of equally many numbers each, components interleaved */
export function pack(frames: ArrayLike<number>[], how: Quantisation): Packed {
  const stride = frames[0].length;
  const wide = how.type === "int16";
  const [low, high] = wide ? [-32768, 32767] : [0, 255];
  const bytes = new Uint8Array(frames.length * stride * (wide ? 2 : 1));
  let before = new Int32Array(stride);
  frames.forEach((frame, k) => {
    const q = Int32Array.from(frame, (v) => Math.min(high, Math.max(low, Math.round((v - how.offset) / how.scale))));
    const begin = k * stride * (wide ? 2 : 1);
    for (let i = 0; i < stride; ++i) {
      const stored = how.delta && k > 0 ? q[i] - before[i] : q[i];
      bytes[begin + i] = stored & 0xff;
      if (wide) bytes[begin + stride + i] = (stored >> 8) & 0xff;
    }
    before = q;
  });
  return { ...how, per_frame: stride / how.components, data: deflateSync(bytes, { level: 6 }).toString("base64") };
}

// Puts data into a template, as the program does.

const placeholder = '<script type="application/json" id="matrigrate-data">null</script>';

export function embed(template: string, json: string): string {
  const html = readFileSync(template, "utf8");
  if (html.split(placeholder).length !== 2) throw new Error(`${template}: the placeholder is not there once`);
  return html.replace(placeholder, () => placeholder.replace("null", () => json.replace(/</g, "\\u003c")));
}

// Repeatable random numbers for sample data.

export type Random = () => number;

/** mulberry32: uniform in [0, 1). */
export function random(seed: number): Random {
  let state = seed >>> 0;
  return () => {
    state = (state + 0x6d2b79f5) >>> 0;
    let z = state;
    z = Math.imul(z ^ (z >>> 15), z | 1);
    z ^= z + Math.imul(z ^ (z >>> 7), z | 61);
    return ((z ^ (z >>> 14)) >>> 0) / 4294967296;
  };
}

export const normal = (u: Random): number => Math.sqrt(-2 * Math.log(1 - u())) * Math.cos(2 * Math.PI * u());
