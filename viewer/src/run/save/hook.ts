/** `window.matrigrate`: for programs that drive the page, such as `matrigrate export --movie`. Stated in README.md. */
import type { Clock } from "../clock";
import type { Layer } from "../matrix/layers";
import type { Stage } from "../stage";
import { paintPicture, stripHeight } from "./picture";

export interface Wanted {
  /** Size of the whole picture [pixels of the page]. */
  width: number;
  height: number;
  /** A key of `layers`; left out: as it is. */
  layer?: string;
  follow?: boolean;
}

export interface Hook {
  /** Fulfilled when there are frames to show; refused where there are none. */
  ready: Promise<void>;
  /** Sets up the view, for all pictures to come. Throws if the run has no such layer. */
  show: (wanted: Wanted) => void;
  /** The picture at a time [s] as it would be saved. The same canvas is painted each time. */
  frame: (time: number) => HTMLCanvasElement;
}

declare global {
  interface Window {
    matrigrate?: Hook;
  }
}

export function hook(ready: Promise<Stage | null>, clock: Clock): Hook {
  const canvas = document.createElement("canvas");
  let stage: Stage | null = null;
  const there = (): Stage => {
    if (!stage) throw new Error("there are no frames to show");
    return stage;
  };
  return {
    ready: ready.then((made) => {
      stage = made;
      there();
    }),
    show: ({ width, height, layer, follow }) => {
      const shown = there();
      if (clock.playing) clock.toggle();
      const wanted: Layer | undefined = shown.layers.find((one) => one.key === layer);
      if (layer !== undefined && !wanted) throw new Error(`there is no layer "${layer}"`);
      if (wanted) shown.choose(wanted);
      shown.fix(width, height - stripHeight(width, shown.view().bars.length));
      if (follow !== undefined) shown.setFollow(follow);
    },
    frame: (time) => {
      const shown = there();
      // Only the picture changes: the rest of the page gets no event.
      clock.time = Math.min(clock.end, Math.max(0, time));
      paintPicture(canvas, shown.view());
      return canvas;
    },
  };
}
