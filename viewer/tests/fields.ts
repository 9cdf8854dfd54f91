/** Values of one frame as they come unpacked. */
import type { Field } from "../src/unpack";

export const field = (values: number[], components: number, scale: number): Field => ({
  q: Int16Array.from(values, (v) => Math.round(v / scale)),
  frames: 1,
  stride: values.length,
  step: values.length,
  components,
  scale,
  offset: 0,
});
