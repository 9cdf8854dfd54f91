/** The matrix on a plain canvas: slower than the card, the same picture. */
import { css, gelOnDark, gelOnLight, lookUp, type Rgb } from "../colour";
import { between, type Film } from "./frames";
import { fluidSize, intactSize, solidFrom, type ParticlePainter, type ParticleScene } from "./particle_scene";

export function plainPainter(canvas: HTMLCanvasElement, film: Film, spacing: number): ParticlePainter {
  const context = canvas.getContext("2d");
  if (!context) throw new Error("this browser can draw neither with WebGL nor on a canvas");

  const paint = ({ place, layer, camera, dark }: ParticleScene): void => {
    const pixels = canvas.width / camera.width;
    context.setTransform(pixels, 0, 0, pixels, 0, 0);
    context.clearRect(0, 0, camera.width, camera.height);
    const table = lookUp(layer.map(dark));
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
        const value = layer.field
          ? between(layer.field, place, i)
          : Math.hypot(
              x - between(film.reference, { frame: 0, next: 0, fraction: 0 }, 2 * i),
              y - between(film.reference, { frame: 0, next: 0, fraction: 0 }, 2 * i + 1),
            );
        const fraction = (value - layer.low) / (layer.high - layer.low);
        context.fillStyle = colours[Math.round(255 * Math.min(1, Math.max(0, fraction)))];
      }
      context.fillRect(sx - 0.5 * side, sy - 0.5 * side, side, side);
    }
  };
  return { canvas, kind: "2d", paint, close: () => undefined };
}
