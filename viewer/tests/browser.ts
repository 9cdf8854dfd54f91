/** Ends what hangs, however slow the machine is [ms]. */
import { mkdirSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { after } from "node:test";
import { type Browser, type BrowserContextOptions, chromium, type Page } from "playwright-core";
import { embed } from "../sample/pack";
import type { Field } from "../src/embedded";

export const patience = 5 * 60 * 1000;

/** A browser that opens sample pages from files, counts what it complains about, and lets no request out. */

const quiet = [
  "--no-sandbox",
  "--disable-gpu",
  "--disable-background-networking",
  "--disable-component-update",
  "--disable-sync",
  "--disable-default-apps",
  "--no-first-run",
  "--metrics-recording-only",
  "--disable-domain-reliability",
  "--disable-features=OptimizationHints,MediaRouter",
  "--disable-3d-apis",
];

const launched: Browser[] = [];

// A test that fails leaves its browser open, and the process would wait for it for ever.
after(async () => {
  await Promise.all(launched.map((browser) => browser.close()));
});

export async function launch(): Promise<Browser> {
  const browser = await chromium.launch({
    executablePath: process.env["CHROMIUM"] ?? "/usr/bin/chromium",
    timeout: patience,
    args: quiet,
  });
  launched.push(browser);
  return browser;
}

export interface Opened {
  page: Page;
  /** Errors of the console and of scripts. */
  errors: string[];
  /** Addresses asked for, other than the page itself. */
  requests: string[];
  /** From the call to open it until all of it is there [ms]. */
  took: number;
}

const folder = join(tmpdir(), `matrigrate-viewer-${process.pid}`);
let count = 0;

/** @param json  what the program would write; null: the bare template */
export async function open(
  browser: Browser,
  template: "run" | "study" | "verdicts",
  json: string | null,
  options: BrowserContextOptions = {},
  query = "",
): Promise<Opened> {
  mkdirSync(folder, { recursive: true });
  const file = join(folder, `${template}-${++count}.html`);
  writeFileSync(file, embed(`dist/${template}.html`, json ?? "null"));
  const context = await browser.newContext({
    viewport: { width: 1280, height: 900 },
    reducedMotion: "reduce",
    ...options,
  });
  context.setDefaultTimeout(patience);
  const page = await context.newPage();
  const [errors, requests]: [string[], string[]] = [[], []];
  page.on("console", (message) => {
    if (message.type() === "error") errors.push(message.text());
  });
  page.on("pageerror", (error) => errors.push(String(error)));
  page.on("request", (request) => {
    if (!/^(data|blob):/.test(request.url()) && !request.url().endsWith(file + query)) requests.push(request.url());
  });
  const begin = performance.now();
  await page.goto(`file://${file}${query}`);
  await page.waitForSelector("html[data-ready=true]");
  // Until the first picture has really been painted.
  await page.evaluate("new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(done)))");
  return { page, errors, requests, took: performance.now() - begin };
}

/** Asks again until it holds. (playwright's own waiting evaluates strings, which the pages forbid.) */
export async function until(holds: () => Promise<boolean>, what: string, most = patience): Promise<void> {
  for (
    const end = performance.now() + most;
    performance.now() < end;
    await new Promise((later) => setTimeout(later, 50))
  )
    if (await holds()) return;
  throw new Error(`not within ${most} ms: ${what}`);
}

/** Until what was asked for has been painted. */
export async function settled(page: Page): Promise<void> {
  await page.evaluate(() => new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(done))));
}

/** The stage as it is painted next: a PNG in base64. Its corners are square: the pixels of round ones vary in the last bits. */
export async function shot(page: Page): Promise<string> {
  const stage = page.locator(".stage");
  await stage.evaluate((element: HTMLElement) => (element.style.borderRadius = "0"));
  await settled(page);
  return (await stage.screenshot()).toString("base64");
}

/** The stage once pictures a while apart are the same: on a slow machine the page may still be laid out. */
export async function still(page: Page): Promise<string> {
  const later = async () => {
    await page.waitForTimeout(150);
    return shot(page);
  };
  let [last, now] = [await shot(page), await later()];
  for (const end = performance.now() + patience; now !== last && performance.now() < end; ) [last, now] = [now, await later()];
  return now;
}

/** Draws every plot of a page by making the window as high as it is.   @return how many there are */
export async function allDrawn(page: Page, width = 1280): Promise<number> {
  await page.setViewportSize({ width, height: await page.evaluate(() => document.documentElement.scrollHeight) });
  await until(
    () =>
      page.evaluate(() => {
        const plots = [...document.querySelectorAll(".plotly-figure")];
        return (
          plots.length > 0 &&
          plots.every((plot) => plot.getAttribute("data-drawn") === "true" && plot.querySelector(".main-svg"))
        );
      }),
    "every plot is drawn",
  );
  return page.locator(".plotly-figure").count();
}

// Comparing pictures, in a browser.

/**
 * Mean difference of two pictures, given as addresses of their data, as a share of the largest one there can be. The
 * second may have more pixels, and is drawn as large as the first.
 */
export function difference(page: Page, one: string, other: string): Promise<number> {
  return page.evaluate(
    async ([a, b]) => {
      const decoded = async (address: string) => {
        const image = new Image();
        image.src = address;
        await image.decode();
        return image;
      };
      const [one, other] = [await decoded(a), await decoded(b)];
      const { width, height } = one;
      if (Math.abs(width * other.height - height * other.width) > width) throw new Error("pictures of different shape");
      const pixels = (image: HTMLImageElement) => {
        const canvas = document.createElement("canvas");
        [canvas.width, canvas.height] = [width, height];
        const context = canvas.getContext("2d")!;
        context.imageSmoothingQuality = "high";
        context.drawImage(image, 0, 0, width, height);
        return context.getImageData(0, 0, width, height).data;
      };
      const [first, second] = [pixels(one), pixels(other)];
      let sum = 0;
      for (let i = 0; i < first.length; ++i) sum += Math.abs(first[i] - second[i]);
      return sum / (255 * first.length);
    },
    [one, other] as const,
  );
}

/** A picture as wide as this, as the address of its data. */
export function narrow(page: Page, address: string, width: number, type: string): Promise<string> {
  return page.evaluate(
    async ([address, width, type]) => {
      const image = new Image();
      image.src = address;
      await image.decode();
      const canvas = document.createElement("canvas");
      [canvas.width, canvas.height] = [width, Math.max(1, Math.round((width * image.height) / image.width))];
      const context = canvas.getContext("2d")!;
      context.fillStyle = "white";
      context.fillRect(0, 0, canvas.width, canvas.height);
      context.imageSmoothingQuality = "high";
      context.drawImage(image, 0, 0, canvas.width, canvas.height);
      return canvas.toDataURL(type, 0.6);
    },
    [address, width, type] as const,
  );
}

/**
 * Of what two pictures have on their grounds (the commonest colour), the part that differs, from 0 to 1. Both are looked at 60 pixels wide, so
 * that letters of another font and lines that are rounded otherwise count little.
 */
export function inkDifference(page: Page, one: string, other: string): Promise<number> {
  return page.evaluate(
    async ([a, b]) => {
      const pixels = async (address: string, height?: number) => {
        const image = new Image();
        image.src = address;
        await image.decode();
        const canvas = document.createElement("canvas");
        [canvas.width, canvas.height] = [60, height ?? Math.max(1, Math.round((60 * image.height) / image.width))];
        const context = canvas.getContext("2d")!;
        context.imageSmoothingQuality = "high";
        context.drawImage(image, 0, 0, canvas.width, canvas.height);
        const { data } = context.getImageData(0, 0, canvas.width, canvas.height);
        const count = new Map<string, number>();
        for (let i = 0; i < data.length; i += 4) {
          const colour = [data[i] >> 3, data[i + 1] >> 3, data[i + 2] >> 3].join();
          count.set(colour, (count.get(colour) ?? 0) + 1);
        }
        const ground = [...count].reduce((most, now) => (now[1] > most[1] ? now : most))[0].split(",").map((c) => 8 * Number(c) + 4);
        return { data, ground, height: canvas.height };
      };
      const first = await pixels(a);
      const second = await pixels(b, first.height);
      let [ink, moved] = [0, 0];
      for (let i = 0; i < first.data.length; ++i) {
        if (i % 4 === 3) continue;
        ink += Math.abs(first.data[i] - first.ground[i % 4]) + Math.abs(second.data[i] - second.ground[i % 4]);
        moved += Math.abs(first.data[i] - second.data[i]);
      }
      return moved / Math.max(1, ink);
    },
    [one, other] as const,
  );
}

// Values of one frame as they come unpacked.

export const field = (values: number[], scale: number): Field => ({
  q: Int16Array.from(values, (v) => Math.round(v / scale)),
  stride: values.length,
  step: values.length,
  scale,
  offset: 0,
});
