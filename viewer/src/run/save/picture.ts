/** The present view as a picture of its own: PNG, SVG with the field inside as pixels, and what a recording films. */
import { css, mapped } from "../../colour";
import { timeText } from "../../numbers";
import { endsOf } from "../legend";
import { escaped, ink, labelFont, SvgPen, type Pen } from "../over/pen";
import { titleOf } from "../matrix/layers";
import type { Coloured } from "../matrix/scale";
import type { Stage, View } from "../stage";

/** Beneath the view: time and title, and the colours with their limits [pixels of the page]. */
const row = 44;
const [side, gap, beforeBar] = [24, 24, 10];
const barFont = "12px sans-serif";
const ground = (dark: boolean): string => ink(dark).edge;

/** The name of what a bar is of, in one line or two. */
function nameOf({ layer }: Coloured): string[] {
  const [first, ...rest] = titleOf(layer).split(": ");
  return rest.length > 0 ? [`${first}:`, rest.join(": ")] : [first];
}

let ruler: CanvasRenderingContext2D | null = null;
function widthOf(text: string): number {
  ruler ??= document.createElement("canvas").getContext("2d");
  if (!ruler) return 7 * text.length;
  ruler.font = barFont;
  return ruler.measureText(text).width;
}

/**
 * Bars up to the right end, in as many rows as they need.
 * @return the width of a bar, right end and row of each, how many rows, and the right end of the room for time and title
 */
function stripOf(width: number, bars: Coloured[]) {
  const bar = Math.min(200, (width < 700 ? 0.3 : 0.17) * width);
  const needed = bars.map((one) => gap + Math.max(...nameOf(one).map(widthOf)) + beforeBar + bar);
  const leastRoom = 110; // for time and title
  const places: { right: number; row: number }[] = [];
  let [row, left] = [0, width - side];
  let room = left;
  needed.forEach((own, k) => {
    if (k > 0 && (width < 700 || left - own < leastRoom)) [row, left] = [row + 1, width - side];
    for (const place of places) if (place.row === row) place.right -= own;
    places.push({ right: width - side, row });
    left -= own;
    if (row === 0) room = left;
  });
  return { bar, places, rows: row + 1, room };
}

/** Height of the strip beneath a view of this width, with these colour bars. */
export const stripHeight = (width: number, bars: Coloured[]): number => row * stripOf(width, bars).rows;

/** @param right, y  upper right corner */
export function paintBar(c: Pen, coloured: Coloured, width: number, right: number, y: number, dark: boolean): void {
  const { layer, scale, clamped } = coloured;
  const left = right - width;
  const steps = 64;
  // Each over the rest of the bar, so that no seams are seen.
  for (let i = 0; i < steps; ++i) {
    c.fillStyle = css(mapped(scale.map, (i + 0.5) / steps));
    c.fillRect(left + (width * i) / steps, y + 8, width * (1 - i / steps), 11);
  }
  c.fillStyle = ink(dark).line;
  c.font = barFont;
  const numbers = endsOf(scale, clamped);
  const worded = layer.ends ? numbers.map((number, k) => `${number} ${layer.ends?.[k] ?? ""}`) : numbers;
  const widths = (texts: string[]): number => texts.reduce((sum, text) => sum + c.measureText(text).width, 0);
  const [low, high] = widths(worded) + 8 <= width ? worded : numbers;
  c.fillText(low, left, y + 34);
  c.fillText(high, right - c.measureText(high).width, y + 34);
  nameOf(coloured).forEach((line, k) => c.fillText(line, left - c.measureText(line).width - beforeBar, y + 18 + 16 * k));
}

/** A text without its end, where it does not fit. */
function fitted(c: Pen, text: string, width: number): string {
  if (c.measureText(text).width <= width) return text;
  let short = text;
  while (short.length > 0 && c.measureText(`${short}\u2026`).width > width) short = short.slice(0, -1);
  return `${short}\u2026`;
}

/** @param y  its upper edge */
function paintStrip(c: Pen, { camera, dark, bars, title, time }: View, y: number): void {
  c.part?.("legend");
  const { width } = camera;
  const { bar, places, rows, room: end } = stripOf(width, bars);
  c.fillStyle = ground(dark);
  c.fillRect(0, y, width, row * rows);
  const room = end - 12;
  c.fillStyle = ink(dark).line;
  c.font = labelFont;
  c.fillText(fitted(c, timeText(60 * Math.floor(time / 60)), room), 12, y + 19);
  c.font = barFont;
  c.fillText(fitted(c, title, room), 12, y + 36);
  bars.forEach((one, k) => paintBar(c, one, bar, places[k].right, y + places[k].row * row, dark));
}

/**
 * Draws the view and the strip on a canvas. Call right after the stage has painted: the card keeps a picture no longer.
 * @param even  whether width and height are even numbers of pixels, as films want them
 */
export function paintPicture(canvas: HTMLCanvasElement, view: View, even: boolean): void {
  const { camera, pixels, matrix, top, dark } = view;
  const strip = stripHeight(camera.width, view.bars);
  const [width, height] = [matrix.width, matrix.height + Math.round(strip * pixels)];
  const [w, h] = even ? [width + (width % 2), height + (height % 2)] : [width, height];
  // A size set anew would end a recording.
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

/** Limits of the width of a PNG, and its greatest height [pixels]. A graphics card may draw less, and then says so. */
export const pngWidth = { least: 200, most: 8000 };

/** @param width  within the limits [pixels]; null: as it is shown */
export async function png(stage: Stage, width: number | null): Promise<Blob> {
  const canvas = document.createElement("canvas");
  if (width === null) paintPicture(canvas, stage.view(), false);
  else {
    const pixels = width / stage.camera.width;
    if (pixels * stage.camera.height > pngWidth.most) throw new Error(`it would be more than ${pngWidth.most} pixels high`);
    stage.viewAt(pixels, (view) => paintPicture(canvas, view, false));
  }
  const blob = await new Promise<Blob | null>((done) => canvas.toBlob(done, "image/png"));
  if (!blob) throw new Error("the browser made no picture");
  return blob;
}

export const svgDocument = (title: string, width: number, height: number, dark: boolean, content: string): string =>
  `<svg xmlns="http://www.w3.org/2000/svg" width="${width}" height="${height}" viewBox="0 0 ${width} ${height}">
<title>${escaped(title)}</title>
<rect width="${width}" height="${height}" fill="${ground(dark)}"/>
${content}
</svg>
`;

/** The stage as a part of an SVG document: the matrix as an image, what lies over it as paths.   @param id  ends all names in it */
export function drawnLayers(stage: Stage, id = "", x = 0, y = 0): string {
  const { camera, matrix } = stage.view();
  const size = `width="${camera.width}" height="${camera.height}"`;
  const pen = new SvgPen(id);
  stage.drawOver(pen);
  return `<svg x="${x}" y="${y}" ${size}>
<image id="matrix${id}" ${size} href="${matrix.toDataURL("image/png")}"/>
${pen.content()}
</svg>`;
}

export function svg(stage: Stage): string {
  const view = stage.view();
  const { width, height } = view.camera;
  const legend = new SvgPen();
  paintStrip(legend, view, height);
  const content = `${drawnLayers(stage)}\n${legend.content()}`;
  return svgDocument(view.title, width, height + stripHeight(width, view.bars), view.dark, content);
}
