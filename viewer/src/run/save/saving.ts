/** Films the stage while it plays, as WebM. */
import type { RunPage } from "../../contract";
import { h } from "../../dom";
import type { Clock } from "../clock";
import type { Stage } from "../stage";
import { linkButton, momentTime } from "./link";
import { paintPicture, png, pngWidth, svg } from "./picture";

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

// Buttons that take the present view away: link, PNG, SVG, WebM.

/** A title and a time as the name of a file. */
export const fileName = (title: string, layer: string, time: number, ending: string): string =>
  `${title.replace(/[^\p{L}\p{N}]+/gu, "-").replace(/^-|-$/g, "")}-${layer}-${momentTime(time)}.${ending}`;

function download(blob: Blob, name: string): void {
  const address = URL.createObjectURL(blob);
  h("a", { href: address, download: name }).click();
  setTimeout(() => URL.revokeObjectURL(address), 10000);
}

type Tell = (text: string) => void;

function button(text: string, title: string, tell: Tell, act: () => void | Promise<void>): HTMLElement {
  const made = h("button", { type: "button", title }, text);
  made.addEventListener("click", () => {
    void (async () => act())().catch((fault: unknown) => tell(`Not saved: ${String(fault)}`));
  });
  return made;
}

function save(blob: Blob, title: string, clock: Clock, stage: Stage, ending: string, tell: Tell): void {
  const file = fileName(title, stage.layer.key, clock.time, ending);
  download(blob, file);
  tell(`Saved ${file}.`);
}

/** Buttons that save the view as a picture.   @param shown  null: there is none yet */
export function pictureButtons(title: string, clock: Clock, shown: () => Stage | null, tell: Tell): HTMLElement[] {
  const picture = (text: string, words: string, ending: string, make: (stage: Stage) => Blob | Promise<Blob>) =>
    button(text, words, tell, async () => {
      const stage = shown();
      if (stage) save(await make(stage), title, clock, stage, ending, tell);
    });
  const width = h("input", {
    type: "number",
    min: pngWidth.least,
    max: pngWidth.most,
    step: 1,
    placeholder: "as shown",
    title: "Width of the PNG in pixels: text and lines grow with it. A column of 85 mm at 600 dpi has 2008",
  });
  return [
    picture("Save PNG", "The view with time and colour bar", "png", (stage) => {
      if (!width.checkValidity()) throw new Error(`the width is a whole number from ${pngWidth.least} to ${pngWidth.most}`);
      return png(stage, width.value === "" ? null : Number(width.value));
    }),
    h("label", {}, width, " px wide"),
    picture("Save SVG", "Cell, path and arrows as vector graphics over the matrix as an image", "svg", (stage) =>
      new Blob([svg(stage, title)], { type: "image/svg+xml" }),
    ),
  ];
}

/**
 * A button that films what is shown; null where the browser cannot.
 * @param shown  null: there is nothing yet; `gone`: when its stage is no longer there, which ends the film
 * @param pauses  whether the end of the film ends the play
 */
export function filmButton(
  title: string,
  clock: Clock,
  shown: () => { stage: Stage; gone: AbortSignal } | null,
  tell: Tell,
  pauses: boolean,
): HTMLElement | null {
  const type = recordable();
  if (!type) return null;
  let recording: Recording | null = null;
  const film = button("Record WebM", "Films the player from now to the end, or until stopped", tell, () => {
    if (recording) {
      recording.stop();
      if (pauses && clock.playing) clock.toggle();
      return;
    }
    const now = shown();
    if (!now) return;
    const { stage, gone } = now;
    film.textContent = "Stop recording";
    const done = (made: Blob | null) => {
      recording = null;
      film.textContent = "Record WebM";
      if (made) save(made, title, clock, stage, "webm", tell);
    };
    recording = record(clock, stage, type, done, gone);
  });
  return film;
}

/** @param alone  the address of the page is that of this run */
export function saving(run: RunPage, clock: Clock, stage: Stage, alone: boolean, gone: AbortSignal): HTMLElement {
  const told = h("span", { class: "told", role: "status" });
  const tell = (text: string) => {
    told.textContent = text;
  };
  return h(
    "div",
    { class: "saving", role: "group", "aria-label": "This view" },
    alone ? linkButton(clock, stage, tell) : null,
    ...pictureButtons(run.title, clock, () => stage, tell),
    filmButton(run.title, clock, () => ({ stage, gone }), tell, true),
    told,
  );
}
