/** The interpolated matrix on a plain canvas: computed at every few pixels, and enlarged smoothly by the browser. */
import { gelOnDark, gelOnLight, lookUp } from "../../colour";
import type { ParticleScene } from "./particle_scene";
import { channels, coverage, solidShare, type Patch } from "./resample";
import { hatchPeriod, hatchStrength, hatchWidth, isBright } from "./scale";

/** Points at which the field is computed, about. */
const mostPoints = 40000;

const ramp = ([from, to]: readonly [number, number], v: number): number =>
  v <= from ? 0 : v >= to ? 1 : (v - from) / (to - from);

/** Colours as they lie in an image's memory. */
const packed = (r: number, g: number, b: number, a: number): number =>
  ((a << 24) | (b << 16) | (g << 8) | r) >>> 0;

export function smoothPainter(context: CanvasRenderingContext2D): (scene: ParticleScene, patch: Patch) => void {
  const small = document.createElement("canvas");
  const inside = small.getContext("2d");
  let image: ImageData | null = null;

  return ({ camera, scale, dark, pixels }, patch) => {
    if (!inside) return;
    const size = Math.max(1, Math.min(scale.hatched ? 1 : 4, Math.round(Math.sqrt((camera.width * camera.height) / mostPoints))));
    const [width, height] = [Math.ceil(camera.width / size), Math.ceil(camera.height / size)];
    if (!image || image.width !== width || image.height !== height) {
      [small.width, small.height] = [width, height];
      image = inside.createImageData(width, height);
    }
    const out = new Uint32Array(image.data.buffer);
    const table = lookUp(scale.map);
    const colours = Uint32Array.from({ length: 256 }, (_, i) => packed(table[4 * i], table[4 * i + 1], table[4 * i + 2], 255));
    const ground = (dark ? gelOnDark : gelOnLight)[0];
    const toPlace = 255 / (scale.high - scale.low);
    const { sums, columns } = patch;
    const columnOf = new Int32Array(width);
    const restOf = new Float32Array(width);
    /** The sums between two rows of nodes. */
    const line = new Float32Array(channels * columns);
    for (let i = 0; i < width; ++i) {
      const gx = (camera.x + (size * (i + 0.5) - 0.5 * camera.width) / camera.scale - patch.left) / patch.step;
      columnOf[i] = channels * Math.min(columns - 2, Math.floor(gx));
      restOf[i] = gx - columnOf[i] / channels;
    }
    for (let j = 0, o = 0; j < height; ++j) {
      const gy = (camera.y - (size * (j + 0.5) - 0.5 * camera.height) / camera.scale - patch.bottom) / patch.step;
      const row = Math.max(0, Math.min(patch.rows - 2, Math.floor(gy)));
      const fy = gy - row;
      for (let k = 0, below = channels * row * columns, up = below + line.length; k < line.length; ++k)
        line[k] = sums[below + k] + fy * (sums[up + k] - sums[below + k]);
      for (let i = 0; i < width; ++i, ++o) {
        const fx = restOf[i];
        const k = columnOf[i];
        const all = line[k + 2] + fx * (line[k + 6] - line[k + 2]);
        if (all <= coverage[0]) {
          out[o] = 0;
          continue;
        }
        const solid = line[k + 1] + fx * (line[k + 5] - line[k + 1]);
        const value = (line[k] + fx * (line[k + 4] - line[k])) / solid;
        const place = toPlace * (value - scale.low);
        const index = place > 255 ? 255 : place > 0 ? Math.round(place) : 0;
        const beyond = scale.hatched && (place > 255.01 || place < -0.01);
        if (all >= coverage[1] && solid >= solidShare[1] * all && !beyond) {
          out[o] = colours[index];
          continue;
        }
        let [r, g, b] = [table[4 * index], table[4 * index + 1], table[4 * index + 2]];
        if (beyond && (size * (i + j + 1)) % hatchPeriod < hatchWidth) {
          const stripe = isBright(r, g, b) ? 0 : 255;
          [r, g, b] = [r, g, b].map((v) => v + hatchStrength * (stripe - v));
        }
        const t = ramp(solidShare, solid / all);
        out[o] = packed(
          Math.round(ground[0] + t * (r - ground[0])),
          Math.round(ground[1] + t * (g - ground[1])),
          Math.round(ground[2] + t * (b - ground[2])),
          Math.round(255 * ramp(coverage, all)),
        );
      }
    }
    inside.putImageData(image, 0, 0);
    context.setTransform(pixels, 0, 0, pixels, 0, 0);
    context.imageSmoothingEnabled = true;
    context.drawImage(small, 0, 0, size * width, size * height);
  };
}
