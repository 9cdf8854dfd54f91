/** The matrix: the interpolated field, or a square for each particle. */
import { css, gelOnDark, gelOnLight, lookUp, type Rgb } from "../../colour";
import { between, solidFrom, type Film } from "../frames";
import type { ParticleScene } from "./shared";
import { particleValue } from "./resample";
import { smoothPainter } from "./smooth";

/** Sides of the squares over their spacing: the degraded ones overlap and read as one area, the intact ones leave gaps in
 *  which the deformation of the lattice shows, unless they are too small for gaps. */
const fluidSize = 1.08;
const intactSize = (spacingPixels: number): number => (spacingPixels < 4 ? 1.08 : 0.84);

export function particlePainter(canvas: HTMLCanvasElement, film: Film, spacing: number): (scene: ParticleScene) => void {
  const context = canvas.getContext("2d");
  if (!context) throw new Error("this browser cannot draw on a canvas");
  const smooth = smoothPainter(context);

  const paintSquares = ({ place, layer, scale, camera, dark, pixels }: ParticleScene): void => {
    context.setTransform(pixels, 0, 0, pixels, 0, 0);
    const table = lookUp(scale.map);
    const colours = Array.from({ length: 256 }, (_, i) =>
      css([table[4 * i], table[4 * i + 1], table[4 * i + 2]] as Rgb),
    );
    const ground = css((dark ? gelOnDark : gelOnLight)[0]);
    const spacingPixels = spacing * camera.scale;
    const intact = intactSize(spacingPixels);
    for (let i = 0; i < film.particles; ++i) {
      const [x, y] = [between(film.x, place, 2 * i), between(film.x, place, 2 * i + 1)];
      const [sx, sy] = [camera.toScreenX(x), camera.toScreenY(y)];
      if (
        sx < -spacingPixels ||
        sy < -spacingPixels ||
        sx > camera.width + spacingPixels ||
        sy > camera.height + spacingPixels
      )
        continue;
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
