/** Reads the data that the program put into the page, and says plainly what is wrong with it. */
import type { Packed, RunPage } from "./contract";
import { messageOf } from "./dom";

const isRecord = (value: unknown): value is Record<string, unknown> =>
  typeof value === "object" && value !== null && !Array.isArray(value);

/** Data of a format with these lists. Throws an Error whose message can be shown as it is. */
export function embedded(format: string, lists: string[]): Record<string, unknown> {
  const text = document.getElementById("matrigrate-data")?.textContent ?? "";
  let data: unknown;
  try {
    data = JSON.parse(text);
  } catch (fault) {
    throw new Error(`The data in this page is not valid JSON: ${messageOf(fault)}.`);
  }
  if (data === null) throw new Error("This page is an empty template: no data has been put into it.");
  if (!isRecord(data)) throw new Error("The data in this page is not an object.");
  if (data["format"] !== format)
    throw new Error(`This page shows data of the format '${format}'; it holds '${String(data["format"])}'.`);
  if (data["version"] !== 1)
    throw new Error(`This page understands version 1 of its data; it holds version ${String(data["version"])}.`);
  const missing = lists.filter((key) => !Array.isArray(data[key]));
  if (missing.length > 0) throw new Error(`The data in this page lacks: ${missing.join(", ")}.`);
  return data;
}

export function embeddedRun(): RunPage {
  const data = embedded("matrigrate-run", ["facts", "protrusions", "readouts", "parameters", "health"]);
  const tracks = data["tracks"];
  if (!isRecord(tracks) || !Array.isArray(tracks["t_s"])) throw new Error("The data in this page lacks: tracks.");
  if (!isRecord(data["geometry"])) throw new Error("The data in this page lacks: geometry.");
  return data as unknown as RunPage;
}

// Packed arrays back into numbers; `sample/pack.ts` is the inverse. The layout:
// 
// value = offset + scale * q. A frame has N = per_frame * components numbers q, the components of an entry side by side
// (x0, y0, x1, y1, ...). The number of frames is the length of `times_s`; `reference` has one frame.
// 1. q = round((value - offset) / scale), clamped to the range of the type; a non-finite value is q = 0.
// 2. With `delta` each frame after the first stores d = q - q of the frame before, modulo 2^16 (int16) or 2^8 (uint8).
//    Otherwise d = q.
// 3. Bytes of a frame. uint8: d[0], ..., d[N-1]. int16: first the N low bytes, then the N high bytes, which compresses
//    better. Two entries 0x0201, 0x0403 of one component are the bytes 01 03 02 04.
// 4. All frames one after the other are one zlib stream (RFC 1950), then base64 with padding, without line breaks.

/** Frames of quantised numbers: value = offset + scale * q. Kept quantised, since that is what the graphics card gets. */
export interface Field {
  q: Int16Array | Uint8Array;
  /** Numbers a frame has. */
  stride: number;
  /** From a frame to the next in `q`: the stride, or 0 where there is one frame that holds at all times. */
  step: number;
  scale: number;
  offset: number;
}

export const valueAt = ({ q, step, scale, offset }: Field, frame: number, index: number): number =>
  offset + scale * q[frame * step + index];

/** By a loop, since `Uint8Array.from` takes twenty times as long, and a film has megabytes. */
export function fromBase64(text: string): Uint8Array {
  const binary = atob(text);
  const bytes = new Uint8Array(binary.length);
  for (let i = 0; i < bytes.length; ++i) bytes[i] = binary.charCodeAt(i);
  return bytes;
}

/** @throws Error where the browser cannot */
export async function inflate(bytes: Uint8Array): Promise<Uint8Array> {
  if (typeof DecompressionStream === "undefined")
    throw new Error("this browser is too old to unpack what is compressed (it has no DecompressionStream)");
  const stream = new Blob([bytes]).stream().pipeThrough(new DecompressionStream("deflate"));
  return new Uint8Array(await new Response(stream).arrayBuffer());
}

/** Joins the low and the high bytes of each frame, which are stored apart since they compress better so. */
function joinBytes(bytes: Uint8Array, stride: number): Int16Array {
  const q = new Int16Array(bytes.length / 2);
  for (let begin = 0; begin < q.length; begin += stride) {
    const low = 2 * begin;
    const high = low + stride;
    for (let i = 0; i < stride; ++i) q[begin + i] = bytes[low + i] | (bytes[high + i] << 8);
  }
  return q;
}

/** @param name  for messages   @param frames  how many there must be */
export async function unpack(packed: Packed, name: string, frames: number): Promise<Field> {
  const { type, components, per_frame, scale, offset } = packed;
  if (type !== "int16" && type !== "uint8") throw new Error(`${name}: unknown type '${String(type)}'`);
  const stride = components * per_frame;
  let bytes: Uint8Array;
  try {
    bytes = await inflate(fromBase64(packed.data));
  } catch (fault) {
    throw new Error(`${name}: cannot be unpacked (${messageOf(fault)})`);
  }
  const expected = frames * stride * (type === "int16" ? 2 : 1);
  if (bytes.length !== expected) throw new Error(`${name}: has ${bytes.length} bytes instead of ${expected}`);
  const q = type === "int16" ? joinBytes(bytes, stride) : bytes;
  // Each frame is added to the one before; typed arrays wrap as the contract demands.
  if (packed.delta) for (let i = stride; i < q.length; ++i) q[i] += q[i - stride];
  return { q, stride, step: stride, scale, offset };
}
