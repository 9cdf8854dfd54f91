/** The interpolated matrix: it says what the particles say. */
import assert from "node:assert/strict";
import { test } from "node:test";
import type { Browser, Page } from "playwright-core";
import { sampleRun } from "../sample/run";
import { colourMaps, mapped } from "../src/colour";
import { Camera } from "../src/run/camera";
import type { Film } from "../src/run/frames";
import type { Layer } from "../src/run/matrix/layers";
import { resample, valueOn } from "../src/run/matrix/resample";
import { field, launch, open, still } from "./browser";

const spacing = 2;

/** A square lattice with a value at each particle. */
function lattice(value: (x: number, y: number) => number, solid: (x: number, y: number) => boolean, spare?: Float32Array, contour?: number) {
  const places: number[] = [];
  for (let i = -20; i <= 20; ++i) for (let j = -20; j <= 20; ++j) places.push(spacing * i, spacing * j);
  const all = Array.from({ length: places.length / 2 }, (_, i) => [places[2 * i], places[2 * i + 1]] as const);
  const x = field(places, 0.005);
  const f = field(all.map(([a, b]) => (solid(a, b) ? 1 : 0)), 1 / 255);
  const film = { x, reference: x, f, particles: all.length } as unknown as Film;
  const layer = { field: field(all.map(([a, b]) => value(a, b)), 0.001), solidOnly: contour === undefined, contour } as unknown as Layer;
  const camera = new Camera({ left: -40, right: 40, bottom: -40, top: 40 });
  camera.resize(600, 600);
  camera.show(camera.whole);
  return resample(film, layer, { frame: 0, next: 0, fraction: 0 }, camera, spacing, spare);
}

test("a linear field is interpolated as it is, and the solid alone makes the value", () => {
  const patch = lattice((x, y) => 3 + 0.2 * x - 0.1 * y + (x < 0 ? 1000 : 0), (x) => x >= 0);
  for (const [x, y] of [[9, 0], [10.3, -7.7], [20, 15.1], [33.3, 3.3]])
    assert.ok(Math.abs(valueOn(patch, x, y)! - (3 + 0.2 * x - 0.1 * y)) < 0.01, `at ${x}, ${y}`);
  assert.ok(Number.isNaN(valueOn(patch, -20, 3)), "fluid has a value");
  assert.equal(valueOn(patch, 46, 0), null, "there is matrix where there is none");
});

test("a layer with a contour jumps there, and is interpolated on both sides of it", () => {
  const patch = lattice((x, y) => (x < 0 ? 0.001 * y + 0.1 : 1 - 0.005 * x), () => true, undefined, 0.5);
  const at = (x: number) => valueOn(patch, x, 4)!;
  for (const x of [-9, -3, -1.6]) assert.ok(Math.abs(at(x) - 0.104) < 0.002, `${at(x)} at ${x}`);
  for (const x of [-0.5, 0.5, 7, 30]) assert.ok(Math.abs(at(x) - (1 - 0.005 * x)) < 0.01, `${at(x)} at ${x}`);
  const soft = lattice((x) => 0.5 + 0.01 * x, () => true, undefined, 0.5);
  for (const x of [-20, -1, 0, 1, 20]) assert.ok(Math.abs(valueOn(soft, x, 0)! - (0.5 + 0.01 * x)) < 0.015, "no jump where there is none");
});

test("the memory of a patch is used again, with nothing of what was in it", () => {
  const first = lattice((x) => x, () => true);
  const apart = lattice((x, y) => x * y, (x) => x >= 0);
  const again = lattice((x, y) => x * y, (x) => x >= 0, first.sums);
  assert.equal(again.sums.buffer, first.sums.buffer);
  assert.deepEqual(again.sums, apart.sums);
  assert.notEqual(lattice((x) => x, () => true, new Float32Array(8)).sums.buffer.byteLength, 32);
});

/** How far two pictures are apart, and in how many places the second leaps from pixel to pixel; computed in a page. */
function compared(page: Page, one: string, other: string): Promise<{ mean: number; share: number; leaps: number }> {
  return page.evaluate(
    async ([a, b]) => {
      const pixels = async (data: string) => {
        const image = new Image();
        image.src = `data:image/png;base64,${data}`;
        await image.decode();
        const canvas = document.createElement("canvas");
        [canvas.width, canvas.height] = [image.width, image.height];
        const context = canvas.getContext("2d")!;
        context.drawImage(image, 0, 0);
        return context.getImageData(0, 0, image.width, image.height);
      };
      const [first, second] = [await pixels(a), await pixels(b)];
      if (first.data.length !== second.data.length) throw new Error("pictures of different size");
      let [sum, far, leaps] = [0, 0, 0];
      for (let i = 0; i < first.data.length; ++i) {
        const away = Math.abs(first.data[i] - second.data[i]);
        sum += away;
        if (away > 24) ++far;
      }
      for (let y = 150; y < second.height - 60; ++y)
        for (let x = 20; x < second.width - 80; ++x) {
          const k = 4 * (y * second.width + x);
          if (Math.abs(second.data[k] - second.data[k + 4]) > 12) ++leaps;
        }
      return { mean: sum / first.data.length, share: far / first.data.length, leaps };
    },
    [one, other],
  );
}

async function prepared(browser: Browser, run: string): Promise<Page> {
  const { page } = await open(browser, "run", run, { viewport: { width: 800, height: 560 } });
  await page.locator(".scrub").fill("3900");
  for (const overlay of ["fibres", "cell", "protrusions", "adhesions", "path"])
    await page.locator(`input[name=${overlay}]`).uncheck();
  return page;
}

test("the interpolated field is smooth, and hatched beyond limits set by hand", async () => {
  const browser = await launch();
  const page = await prepared(browser, JSON.stringify(sampleRun({ radius: 60, interval: 600, end: 7200 })));
  assert.ok(await page.locator("input[value=smooth]").isChecked(), "smooth is what is seen first");
  await page.locator("input[value=von_mises]").check();
  const unhatched = await still(page);
  await page.locator("input[name=high]").fill("20");
  await page.locator("input[name=high]").press("Enter");
  assert.ok((await compared(page, unhatched, await still(page))).share > 0.001);
  // Far fewer leaps of colour than particles with gaps between them have.
  await page.locator("input[value=degradation]").check();
  const field = await still(page);
  await page.locator("input[value=particles]").check();
  const [smooth, tiles] = [await compared(page, field, field), await compared(page, field, await still(page))];
  assert.ok(smooth.leaps < 0.1 * tiles.leaps, `${smooth.leaps} leaps in the field, ${tiles.leaps} in the particles`);
  await browser.close();
});

// Colour maps and limits: they change the picture, say what lies beyond them, and refuse nonsense.

test("sequential colour maps rise in brightness, so that they can be read without colour", () => {
  for (const key of ["viridis", "cividis", "magma", "grey"] as const) {
    const map = colourMaps[key].on();
    const bright = Array.from({ length: 33 }, (_, i) => {
      const [r, g, b] = mapped(map, i / 32);
      return 0.3 * r + 0.59 * g + 0.11 * b;
    });
    for (let i = 1; i < bright.length; ++i) assert.ok(bright[i] > bright[i - 1], `${key} at ${i}`);
  }
});

test("limits and colours can be chosen, and are taken back", async () => {
  const browser = await launch();
  const { page, errors } = await open(browser, "run", JSON.stringify(sampleRun({ radius: 60, interval: 600, end: 7200 })));
  const bar = page.locator(".legend-layer .bar").first();
  await page.locator(".scrub").fill("3900");
  await page.locator("input[value=von_mises]").check();
  const before = await still(page);
  await page.locator("input[name=high]").fill("20");
  await page.locator("input[name=high]").press("Enter");
  const narrow = await still(page);
  assert.notEqual(narrow, before);
  assert.match((await page.locator(".bar-numbers").first().textContent()) ?? "", /\u2265 20/);
  assert.match((await bar.getAttribute("class")) ?? "", /more-high/);
  assert.ok(await page.getByText("and are hatched").isVisible());
  await page.locator("input[name=low]").fill("30");
  await page.locator("input[name=low]").press("Enter");
  assert.equal(await page.locator("input[name=low]").getAttribute("aria-invalid"), "true");
  assert.ok(await page.getByText("must be a number below").isVisible());
  assert.equal(await still(page), narrow, "nonsense is not drawn");
  await page.locator("select[name=map]").selectOption("cividis");
  assert.notEqual(await still(page), narrow);
  await page.getByRole("button", { name: "Reset" }).click();
  assert.equal(await still(page), before);
  // Fitted to the moment nothing lies beyond the limits, which another moment has others of.
  await page.locator("button[name=fit]").click();
  const ends = () => Promise.all(["low", "high"].map((end) => page.locator(`input[name=${end}]`).inputValue().then(Number)));
  const [low, high] = await ends();
  assert.ok(low >= 0 && high > low && high < 120, `${low} to ${high}`);
  assert.doesNotMatch((await bar.getAttribute("class")) ?? "", /more-low/);
  await page.locator(".scrub").fill("7200");
  await page.locator("button[name=fit]").click();
  assert.notDeepEqual(await ends(), [low, high]);
  await page.getByRole("button", { name: "Reset" }).click();
  assert.deepEqual(await ends(), [0, 120]);
  // Where white means zero, both limits move together, and each layer keeps its own.
  await page.locator("input[value=pressure]").check();
  await page.locator("input[name=high]").fill("15");
  await page.locator("input[name=high]").press("Enter");
  assert.equal(await page.locator("input[name=low]").inputValue(), "-15");
  await page.locator("button[name=fit]").click();
  const [negative, positive] = await ends();
  assert.equal(negative, -positive);
  await page.locator("input[value=von_mises]").check();
  assert.equal(await page.locator("input[name=high]").inputValue(), "120");
  assert.deepEqual(errors, []);
  await browser.close();
});
