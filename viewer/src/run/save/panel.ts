/** Moments of a run side by side, for a publication: at one scale and place, with one colour bar and one legend. */
import { timeText } from "../../numbers";
import { signs } from "../legend";
import { ink, labelFont, SvgPen } from "../over/pen";
import type { Stage } from "../stage";
import { drawnLayers, paintBar, svgDocument } from "./picture";

const [side, gap, heading, row] = [300, 12, 30, 25]; // [pixels of the page]

/** The signs of the legend from `top` down, in lines at most `width` wide.   @return their SVG and where they end */
function legend(stage: Stage, top: number, width: number): [string, number] {
  const pen = new SvgPen();
  pen.font = "14px sans-serif";
  pen.fillStyle = ink(false).line;
  let [x, y, pictures] = [gap, top, ""];
  for (const entry of signs(stage).children) {
    const words = entry.textContent ?? "";
    const needed = 37 + pen.measureText(words).width;
    if (x > gap && x + needed > width - gap) [x, y] = [gap, y + row];
    const sign = new XMLSerializer().serializeToString(entry.children[0]);
    pictures += `<g transform="translate(${x} ${y})">${sign}</g>\n`;
    pen.fillText(words, x + 37, y + 12);
    x += needed + 20;
  }
  return [pictures + pen.content(), y + row];
}

/** @param times  [s]; up to four of them stand in a row */
export function panel(stage: Stage, times: number[]): string {
  const columns = times.length <= 4 ? times.length : times.length <= 6 ? 3 : 4;
  stage.fix(side, side);
  stage.shown.traction = stage.shown.polarization = false;
  const pen = new SvgPen();
  pen.fillStyle = ink(false).line;
  pen.font = labelFont;
  const pictures = times.map((time, k) => {
    stage.clock.time = time;
    const [x, y] = [gap + (k % columns) * (side + gap), heading + Math.floor(k / columns) * (side + heading)];
    pen.fillText(timeText(time), x, y - 8);
    return `${drawnLayers(stage, `-${k + 1}`, x, y)}
<rect x="${x}" y="${y}" width="${side}" height="${side}" fill="none" stroke="${ink(false).line}"/>`;
  });
  const width = Math.max(gap + columns * (side + gap), 480);
  const bottom = heading + Math.ceil(times.length / columns) * (side + heading) - heading;
  const view = stage.view();
  view.bars.forEach((bar, k) => paintBar(pen, bar, 200, width - gap, bottom + 4 + 44 * k, false));
  const [words, end] = legend(stage, bottom + 4 + 44 * view.bars.length, width);
  return svgDocument(`${view.title}, at chosen times`, width, end, false, `${pictures.join("\n")}\n${pen.content()}\n${words}`);
}
