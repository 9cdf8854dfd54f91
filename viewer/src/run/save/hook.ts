/** `window.matrigrate`: for programs that drive the page, such as `drive.mjs`. Stated in README.md. */
import type { Stage } from "../stage";
import { panel } from "./panel";
import { paintPicture, stripHeight, svg } from "./picture";

export interface Wanted {
  /** Size of the whole picture [pixels of the page]. */
  width: number;
  height: number;
  /** A key of `layers`; left out: as it is. */
  layer?: string;
  follow?: boolean;
  /** The whole matrix is seen, not the surroundings of the cell. */
  whole?: boolean;
}

export interface Hook {
  /** Fulfilled when there are frames to show; refused where there are none. */
  ready: Promise<void>;
  /** Sets up the view, for all pictures to come. Throws if the run has no such layer. */
  show: (wanted: Wanted) => void;
  /** The picture at a time [s] as it would be saved. The same canvas is painted each time. */
  frame: (time: number) => HTMLCanvasElement;
  /** The same as an SVG document. */
  svg: (time: number) => string;
  /** Several times side by side as an SVG document; the pictures have a size of their own from then on. */
  panel: (times: number[]) => string;
}

declare global {
  interface Window {
    matrigrate?: Hook;
  }
}

export function hook(ready: Promise<Stage | null>): Hook {
  const canvas = document.createElement("canvas");
  let stage: Stage | null = null;
  const there = (): Stage => {
    if (!stage) throw new Error("there are no frames to show");
    return stage;
  };
  /** Only a picture is wanted: nothing else on the page is told of the time. */
  const at = (time: number): Stage => {
    const shown = there();
    shown.clock.time = Math.min(shown.clock.end, Math.max(0, time));
    return shown;
  };
  return {
    ready: ready.then((made) => {
      stage = made;
      there();
    }),
    show: ({ width, height, layer, follow, whole }) => {
      const shown = there();
      if (shown.clock.playing) shown.clock.toggle();
      const wanted = shown.layers.find((one) => one.key === layer);
      if (layer !== undefined && !wanted) throw new Error(`there is no layer "${layer}"`);
      if (wanted) shown.choose(wanted);
      shown.fix(width, height - stripHeight(width, shown.view().bars));
      if (whole) shown.showWhole();
      if (follow !== undefined) shown.setFollow(follow);
    },
    frame: (time) => {
      paintPicture(canvas, at(time).view(), true);
      return canvas;
    },
    svg: (time) => svg(at(time)),
    panel: (times) => panel(there(), times),
  };
}
