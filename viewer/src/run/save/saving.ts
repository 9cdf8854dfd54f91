/** Films the stage while it plays, as WebM. */
import { button, h } from "../../dom";
import type { Stage } from "../stage";
import { linkButton, momentTime } from "./link";
import { paintPicture, png, pngWidth, svg } from "./picture";

const types = ["video/webm;codecs=vp9", "video/webm;codecs=vp8", "video/webm"];

/** null where the browser cannot record. */
function recordable(): string | null {
  if (typeof MediaRecorder === "undefined" || !("captureStream" in HTMLCanvasElement.prototype)) return null;
  return types.find((type) => MediaRecorder.isTypeSupported(type)) ?? null;
}

/**
 * From now, or from the start if it stands at the end, until it pauses or is stopped.
 * @param done  called with the film, or with null if there is none
 * @param gone  ends it: the stage is no longer there
 * @return stops it
 */
function record(stage: Stage, type: string, done: (film: Blob | null) => void, gone: AbortSignal): () => void {
  const { clock } = stage;
  const canvas = document.createElement("canvas");
  paintPicture(canvas, stage.view(), true);
  const recorder = new MediaRecorder(canvas.captureStream(30), { mimeType: type, videoBitsPerSecond: 8e6 });
  const over = new AbortController();
  const pieces: Blob[] = [];
  recorder.addEventListener("dataavailable", ({ data }) => data.size > 0 && pieces.push(data));
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
  return stop;
}

// Buttons that take the present view away: link, PNG, SVG, WebM.

/** A title and a time as the name of a file. */
export const fileName = (title: string, layer: string, time: number, ending: string): string =>
  `${title.replace(/[^\p{L}\p{N}]+/gu, "-").replace(/^-|-$/g, "")}-${layer}-${momentTime(time)}.${ending}`;

export function download(name: string, content: BlobPart, type = "text/plain"): void {
  const address = URL.createObjectURL(new Blob([content], { type }));
  h("a", { href: address, download: name }).click();
  setTimeout(() => URL.revokeObjectURL(address), 10000);
}

type Tell = (text: string) => unknown;

const saver = (text: string, title: string, tell: Tell, act: () => unknown): HTMLElement =>
  button(text, { title, onclick: () => (async () => act())().catch((fault: unknown) => tell(`Not saved: ${String(fault)}`)) });

function save(blob: Blob, stage: Stage, ending: string, tell: Tell): void {
  const file = fileName(stage.title, stage.layer.key, stage.clock.time, ending);
  download(file, blob, blob.type);
  tell(`Saved ${file}.`);
}

/** Buttons that save the view as a picture.   @param shown  null: there is none yet */
export function pictureButtons(shown: () => Stage | null, tell: Tell): HTMLElement[] {
  const picture = (text: string, title: string, ending: string, make: (stage: Stage) => Blob | Promise<Blob>) =>
    saver(text, title, tell, async () => {
      const stage = shown();
      if (stage) save(await make(stage), stage, ending, tell);
    });
  const { least: min, most: max } = pngWidth;
  const title = "Width of the PNG in pixels: text and lines grow with it. A column of 85 mm at 600 dpi has 2008";
  const width = h("input", { type: "number", min, max, step: 1, placeholder: "as shown", title });
  const ofWidth = (stage: Stage) => {
    if (!width.checkValidity()) throw new Error(`the width is a whole number from ${min} to ${max}`);
    return png(stage, width.value === "" ? null : Number(width.value));
  };
  const vector = (stage: Stage) => new Blob([svg(stage)], { type: "image/svg+xml" });
  return [
    picture("Save PNG", "The view with time and colour bar", "png", ofWidth),
    h("label", {}, width, " px wide"),
    picture("Save SVG", "Cell, path and arrows as vector graphics over the matrix as an image", "svg", vector),
  ];
}

/**
 * A button that films what is shown; null where the browser cannot.
 * @param shown   null: there is nothing yet
 * @param gone    when its stage is no longer there, which ends the film
 * @param pauses  whether the end of the film ends the play
 */
export function filmButton(shown: () => Stage | null, gone: () => AbortSignal, tell: Tell, pauses: boolean): HTMLElement | null {
  const type = recordable();
  if (!type) return null;
  let stop: (() => void) | null = null;
  const film = saver("Record WebM", "Films the player from now to the end, or until stopped", tell, () => {
    const stage = shown();
    if (stop) {
      stop();
      if (pauses && stage?.clock.playing) stage.clock.toggle();
    } else if (stage) {
      film.textContent = "Stop recording";
      const done = (made: Blob | null) => {
        stop = null;
        film.textContent = "Record WebM";
        if (made) save(made, stage, "webm", tell);
      };
      stop = record(stage, type, done, gone());
    }
  });
  return film;
}

/** @param alone  the address of the page is that of this run */
export function saving(stage: Stage, alone: boolean, gone: AbortSignal): HTMLElement {
  const told = h("span", { class: "told", role: "status" });
  const tell = (text: string) => (told.textContent = text);
  const link = alone ? linkButton(stage, tell) : null;
  const film = filmButton(() => stage, () => gone, tell, true);
  const all = [link, ...pictureButtons(() => stage, tell), film, told];
  return h("div", { class: "saving", role: "group", "aria-label": "This view" }, ...all);
}
