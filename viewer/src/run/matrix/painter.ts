/** The matrix: the interpolated field, computed at every few pixels and enlarged smoothly by the browser, or a square for each particle. */
import { css, gelOn, lookUp, type Rgb } from "../../colour";
import type { Camera } from "../camera";
import { between, solidFrom, type Film, type Place } from "../frames";
import type { Layer } from "./layers";
import { channels, contourEnds, coverage, leastShare, particleValue, solidShare, type Patch } from "./resample";
import { hatchPeriod, hatchStrength, hatchWidth, isBright, type Scale } from "./scale";

export interface MatrixScene {
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

/** Points at which the field is computed, about. */
const mostPoints = 40000;

const ramp = ([from, to]: readonly [number, number], v: number): number =>
  v <= from ? 0 : v >= to ? 1 : (v - from) / (to - from);

/** Colours as they lie in an image's memory. */
const packed = (r: number, g: number, b: number, a: number): number =>
  ((a << 24) | (b << 16) | (g << 8) | r) >>> 0;

function colouring({ low, high, map, hatched }: Scale) {
  const table = lookUp(map);
  const colours = Uint32Array.from(table, (rgb) => packed(...rgb, 255));
  const toPlace = 255 / (high - low);
  const indexOf = (place: number): number => (place > 255 ? 255 : place > 0 ? Math.round(place) : 0);
  /** Beyond limits that a person has set: a stripe of the hatching, or what is between stripes. */
  const rgb = (value: number, stripe: boolean): Rgb => {
    const place = toPlace * (value - low);
    const [r, g, b] = table[indexOf(place)];
    if (!hatched || !stripe || !(place > 255.01 || place < -0.01)) return [r, g, b];
    const line = isBright(r, g, b) ? 0 : 255;
    const mixed = (v: number): number => v + hatchStrength * (line - v);
    return [mixed(r), mixed(g), mixed(b)];
  };
  /** Packed; for limits that nobody has set. */
  const plain = (value: number): number => colours[indexOf(toPlace * (value - low))];
  return { plain, rgb };
}

function smoothPainter(context: CanvasRenderingContext2D): (scene: MatrixScene, patch: Patch) => void {
  const small = document.createElement("canvas");
  const inside = small.getContext("2d");
  let image: ImageData | null = null;

  return ({ camera, scale, dark, pixels }, patch) => {
    if (!inside) return;
    const finest = scale.hatched || pixels > 2; // a single picture, with more pixels than a screen has
    const size = Math.max(1, Math.min(finest ? 1 : 4, Math.round(Math.sqrt((camera.width * camera.height) / mostPoints))));
    const [width, height] = [Math.ceil(camera.width / size), Math.ceil(camera.height / size)];
    if (!image || image.width !== width || image.height !== height) {
      [small.width, small.height] = [width, height];
      image = inside.createImageData(width, height);
    }
    const out = new Uint32Array(image.data.buffer);
    const ground = gelOn(dark)[0];
    const { sums, columns } = patch;
    const contour = patch.contour === undefined ? null : contourEnds(patch.contour);
    const { plain, rgb } = colouring(scale);
    /** Values on both sides of a contour, and the share of the side above; else the value of the solid, and its share. */
    let [above, below, share] = [0, 0, 0];
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
        const sum = (channel: number): number => line[k + channel] + fx * (line[k + channel + 4] - line[k + channel]);
        const [solid, part] = [sum(1), sum(0)];
        if (contour) {
          const value = sum(3) / all;
          const rest = all - solid;
          above = solid > leastShare * all ? part / solid : value;
          below = rest > leastShare * all ? (sum(3) - part) / rest : value;
          share = ramp(contour, value);
        } else {
          above = part / solid;
          share = ramp(solidShare, solid / all);
        }
        if (all >= coverage[1] && !scale.hatched && (share === 1 || (share === 0 && contour))) {
          out[o] = plain(share === 1 ? above : below);
          continue;
        }
        const stripe = (size * (i + j + 1)) % hatchPeriod < hatchWidth;
        const [r, g, b] = rgb(above, stripe);
        const [r0, g0, b0] = contour ? rgb(below, stripe) : ground;
        out[o] = packed(
          Math.round(r0 + share * (r - r0)),
          Math.round(g0 + share * (g - g0)),
          Math.round(b0 + share * (b - b0)),
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

/** Sides of the squares over their spacing: the degraded ones overlap and read as one area, the intact ones leave gaps in
 *  which the deformation of the lattice shows, unless they are too small for gaps. */
const fluidSize = 1.08;
const intactSize = (spacingPixels: number): number => (spacingPixels < 4 ? 1.08 : 0.84);

export function matrixPainter(canvas: HTMLCanvasElement, film: Film, spacing: number): (scene: MatrixScene) => void {
  const context = canvas.getContext("2d");
  if (!context) throw new Error("this browser cannot draw on a canvas");
  const smooth = smoothPainter(context);

  const paintSquares = ({ place, layer, scale, camera, dark, pixels }: MatrixScene): void => {
    context.setTransform(pixels, 0, 0, pixels, 0, 0);
    const colours = lookUp(scale.map).map(css);
    const ground = css(gelOn(dark)[0]);
    const spacingPixels = spacing * camera.scale;
    const intact = intactSize(spacingPixels);
    const seen = (at: number, size: number) => at >= -spacingPixels && at <= size + spacingPixels;
    for (let i = 0; i < film.particles; ++i) {
      const [x, y] = [between(film.x, place, 2 * i), between(film.x, place, 2 * i + 1)];
      const [sx, sy] = [camera.toScreenX(x), camera.toScreenY(y)];
      if (!seen(sx, camera.width) || !seen(sy, camera.height)) continue;
      const f = between(film.f, place, i);
      const side = spacingPixels * (fluidSize + f * (intact - fluidSize));
      if (layer.solidOnly && f < solidFrom) context.fillStyle = ground;
      else {
        const fraction = (particleValue(film, layer, place, i, x, y) - scale.low) / (scale.high - scale.low);
        context.fillStyle = colours[Math.round(255 * Math.min(1, Math.max(0, fraction)))];
      }
      context.fillRect(sx - 0.5 * side, sy - 0.5 * side, side, side);
    }
  };
  return (scene) => {
    context.setTransform(1, 0, 0, 1, 0, 0);
    context.clearRect(0, 0, canvas.width, canvas.height);
    if (scene.patch) smooth(scene, scene.patch);
    else paintSquares(scene);
  };
}
