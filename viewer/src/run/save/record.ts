/** Films the stage while it plays, as WebM. */
import type { Clock } from "../clock";
import { paintPicture } from "./picture";
import type { Stage } from "../stage";

const types = ["video/webm;codecs=vp9", "video/webm;codecs=vp8", "video/webm"];

/** null where the browser cannot record. */
export function recordable(): string | null {
  if (typeof MediaRecorder === "undefined" || !("captureStream" in HTMLCanvasElement.prototype)) return null;
  return types.find((type) => MediaRecorder.isTypeSupported(type)) ?? null;
}

export interface Recording {
  stop(): void;
}

/**
 * From now, or from the start if it stands at the end, until it pauses or is stopped.
 * @param done  called with the film, or with null if there is none
 * @param gone  ends it: the stage is no longer there
 */
export function record(clock: Clock, stage: Stage, type: string, done: (film: Blob | null) => void, gone: AbortSignal): Recording {
  const canvas = document.createElement("canvas");
  paintPicture(canvas, stage.view(), true);
  const recorder = new MediaRecorder(canvas.captureStream(30), { mimeType: type, videoBitsPerSecond: 8e6 });
  const over = new AbortController();
  const pieces: Blob[] = [];
  recorder.addEventListener("dataavailable", (event) => {
    if (event.data.size > 0) pieces.push(event.data);
  });
  const stop = () => {
    if (over.signal.aborted) return;
    over.abort();
    recorder.stop();
  };
  recorder.addEventListener("stop", () => done(pieces.length > 0 ? new Blob(pieces, { type: "video/webm" }) : null));
  recorder.addEventListener("error", stop);
  gone.addEventListener("abort", stop);
  clock.onChange(() => {
    paintPicture(canvas, stage.view(), true);
    // The last picture still has to reach the film.
    if (!clock.playing) setTimeout(stop, 120);
  }, over.signal);
  recorder.start();
  if (!clock.playing) clock.toggle();
  return { stop };
}
