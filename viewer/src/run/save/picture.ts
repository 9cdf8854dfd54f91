/** The present view as a picture of its own: PNG, SVG with the field inside as pixels, and what a recording films. */
import { css, mapped } from "../../colour";
import { readable, timeText } from "../../numbers";
import { labelFont, ink, type Pen } from "../over/pen";
import type { Stage, View } from "../stage";
import { escaped, SvgPen } from "../over/svg_pen";

/** Beneath the view: the time, and the colours with their limits [pixels of the page]. */
const strip = 44;
const ground = (dark: boolean): string => (dark ? "#14171a" : "#ffffff");

/** @param y  its upper edge */
function paintStrip(c: Pen, { camera, dark, layer, scale, clamped, time }: View, y: number): void {
  c.part?.("legend");
  const { width } = camera;
  c.fillStyle = ground(dark);
  c.fillRect(0, y, width, strip);
  c.font = labelFont;
  c.fillStyle = ink(dark).line;
  c.fillText(timeText(60 * Math.floor(time / 60)), 12, y + 28);
  const bar = Math.min(220, 0.34 * width);
  const left = width - bar - 24;
  const steps = 64;
  // Between whole pixels, so that no seams are seen.
  const edge = (i: number) => Math.round(left + (bar * i) / steps);
  for (let i = 0; i < steps; ++i) {
    c.fillStyle = css(mapped(scale.map, (i + 0.5) / steps));
    c.fillRect(edge(i), y + 8, edge(i + 1) - edge(i), 11);
  }
  c.fillStyle = ink(dark).line;
  c.font = "12px sans-serif";
  const low = (clamped.low ? "\u2264 " : "") + readable(scale.low, 3);
  const high = (clamped.high ? "\u2265 " : "") + readable(scale.high, 3);
  c.fillText(low, left, y + 34);
  c.fillText(high, left + bar - c.measureText(high).width, y + 34);
  const name = layer.name + (layer.unit ? ` [${layer.unit}]` : "");
  c.fillText(name, left - c.measureText(name).width - 10, y + 18);
}

/** Draws the view and the strip on a canvas. Call right after the stage has painted: the card keeps a picture no longer. */
export function paintPicture(canvas: HTMLCanvasElement, view: View): void {
  const { camera, pixels, matrix, top, dark } = view;
  const [width, height] = [matrix.width, matrix.height + Math.round(strip * pixels)];
  // Video wants even sizes; a size set anew would end a recording.
  const [w, h] = [width + (width % 2), height + (height % 2)];
  if (canvas.width !== w || canvas.height !== h) [canvas.width, canvas.height] = [w, h];
  const c = canvas.getContext("2d");
  if (!c) return;
  c.setTransform(1, 0, 0, 1, 0, 0);
  c.fillStyle = ground(dark);
  c.fillRect(0, 0, w, h);
  c.drawImage(matrix, 0, 0);
  c.drawImage(top, 0, 0);
  c.setTransform(pixels, 0, 0, pixels, 0, 0);
  paintStrip(c, view, camera.height);
}

export function png(stage: Stage): Promise<Blob> {
  const canvas = document.createElement("canvas");
  paintPicture(canvas, stage.view());
  return new Promise((done, failed) =>
    canvas.toBlob((blob) => (blob ? done(blob) : failed(new Error("the browser made no picture"))), "image/png"),
  );
}

/** Outline, protrusions, path, arrows and scales as paths; the matrix as an image. */
export function svg(stage: Stage, title: string): Blob {
  const view = stage.view();
  const { width, height } = view.camera;
  const [signs, legend] = [new SvgPen(), new SvgPen()];
  stage.drawOver(signs);
  paintStrip(legend, view, height);
  const text = `<svg xmlns="http://www.w3.org/2000/svg" width="${width}" height="${height + strip}" viewBox="0 0 ${width} ${height + strip}">
<title>${escaped(title)}</title>
<clipPath id="view"><rect width="${width}" height="${height}"/></clipPath>
<rect width="${width}" height="${height + strip}" fill="${ground(view.dark)}"/>
<image id="matrix" width="${width}" height="${height}" href="${view.matrix.toDataURL("image/png")}"/>
<g clip-path="url(#view)">
${signs.content()}
</g>
${legend.content()}
</svg>
`;
  return new Blob([text], { type: "image/svg+xml" });
}
