/** Arrows have the direction and the length of what they stand for, and are seen on any ground. */
import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { after, before, test } from "node:test";
import type { Browser } from "playwright-core";
import { sampleRun } from "../sample/run";
import { Camera } from "../src/run/camera";
import { film, outlineAt, placeAt } from "../src/run/frames";
import { layers } from "../src/run/matrix/layers";
import { isDarkGround, LayerScale } from "../src/run/matrix/scale";
import { paintArrows, paintPolarization, paintTraction, pixelsPerForce, usual } from "../src/run/over/arrows";
import type { Pen } from "../src/run/over/pen";
import { launch, open, until } from "./browser";

const run = sampleRun({ radius: 60, interval: 600, end: 7200 });

interface Line {
  from: [number, number];
  to: [number, number];
}

/** Notes shafts (the first line of each arrow) and the colours of strokes. */
function recorder(): { pen: Pen; shafts: Line[]; strokes: string[] } {
  const [shafts, strokes]: [Line[], string[]] = [[], []];
  let last: [number, number] = [0, 0];
  let calls = 0;
  const pen = {
    strokeStyle: "",
    setLineDash: () => undefined,
    beginPath: () => undefined,
    moveTo: (x: number, y: number) => {
      last = [x, y];
    },
    lineTo: (x: number, y: number) => {
      if (calls++ % 3 === 0) shafts.push({ from: last, to: [x, y] });
    },
    stroke: () => strokes.push(pen.strokeStyle),
  };
  return { pen: pen as unknown as Pen, shafts, strokes };
}

const made = await film(run);
assert.ok(made);
const camera = new Camera({ left: -60, right: 60, bottom: -60, top: 60 });
camera.resize(600, 600);
camera.show(camera.whole);
const frame = made.protrusions.findIndex((all) => all.filter((p) => p.force_nN > 0).length > 0);
const place = placeAt(made.times, made.times[frame]);
const scene = { film: made, place, camera, spacing: 2, dark: false, darkGround: false };

test("traction points from the anchor to the tip, as long as its force", () => {
  const from = usual(made, 1);
  const unit = pixelsPerForce(from);
  const { pen, shafts, strokes } = recorder();
  const outline = outlineAt(made, place);
  paintTraction(pen, scene, outline, unit);
  const pulling = made.protrusions[frame].filter((p) => p.force_nN > 0);
  assert.equal(shafts.length, pulling.length);
  pulling.forEach((p, k) => {
    const [dx, dy] = [shafts[k].to[0] - shafts[k].from[0], shafts[k].from[1] - shafts[k].to[1]];
    const [tx, ty] = [outline[2 * p.centre] - p.anchor![0], outline[2 * p.centre + 1] - p.anchor![1]];
    assert.ok(Math.abs(Math.hypot(dx, dy) - unit * p.force_nN) < 1e-6);
    assert.ok(Math.abs(dx * ty - dy * tx) < 1e-6 * Math.hypot(tx, ty) && dx * tx + dy * ty > 0);
  });
  assert.ok(Math.max(...made.protrusions.flat().map((p) => unit * p.force_nN)) <= 60 + 1e-9);
  assert.equal(new Set(strokes).size, 2, "a line and its edge");
});

test("arrows are light on dark layers and dark on light ones, whatever the page", () => {
  const all = layers(made);
  for (const dark of [false, true]) {
    const ground = (key: string): boolean => {
      const layer = all.find((one) => one.key === key)!;
      return isDarkGround(layer, new LayerScale(layer, made).on(dark));
    };
    assert.ok(!ground("pressure") && ground("von_mises") && ground("displacement"));
    assert.equal(ground("degradation"), dark);
  }
});

test("polarization has its angle, and none before the first protrusion", () => {
  const tracks = { ...run.tracks, polarization_rad: run.tracks.t_s.map((t) => (t < 1000 ? null : 0.5)) };
  const before = recorder();
  paintPolarization(before.pen, camera, tracks, 500, false);
  assert.equal(before.shafts.length, 0);
  const after = recorder();
  paintPolarization(after.pen, camera, tracks, 5000, false);
  const [{ from, to }] = after.shafts;
  assert.ok(Math.abs(Math.atan2(from[1] - to[1], to[0] - from[0]) - 0.5) < 1e-9);
});

test("displacement and velocity are drawn with an edge, and velocity not before anything moved", () => {
  for (const dark of [false, true])
    for (const kind of ["displacement", "velocity"] as const) {
      const { pen, shafts, strokes } = recorder();
      paintArrows(pen, { ...scene, darkGround: dark }, kind, 20);
      assert.ok(shafts.length > 5, kind);
      assert.deepEqual(strokes, dark ? ["#14171a", "#ffffff"] : ["#ffffff", "#1f2328"], "edge, then line");
    }
  const { pen, shafts } = recorder();
  paintArrows(pen, { ...scene, place: { frame: 0, next: 0, fraction: 0 } }, "velocity", 20);
  assert.equal(shafts.length, 0);
});

// The nucleus of a cell is drawn over its body and explained; without any there is no word of it.

let browser: Browser;
before(async () => {
  browser = await launch();
});
after(async () => {
  await browser.close();
});

async function cellGroup(nucleus: boolean): Promise<string> {
  const run = sampleRun({ radius: 60, interval: 600, end: 1200, fibres: false });
  if (run.frames && nucleus) run.frames.outline.nucleus = run.frames.outline.x;
  const { page, errors } = await open(browser, "run", JSON.stringify(run));
  const entry = page.getByText("nucleus", { exact: true });
  if (nucleus) await until(async () => await entry.isVisible(), "the nucleus is explained");
  const [download] = await Promise.all([
    page.waitForEvent("download"),
    page.getByRole("button", { name: "Save SVG" }).click(),
  ]);
  assert.equal(await entry.count(), nucleus ? 1 : 0);
  assert.deepEqual(errors, []);
  const svg = readFileSync(await download.path(), "utf8");
  await page.context().close();
  return /<g id="cell">(.*?)<g id="protrusions">/s.exec(svg)?.[1] ?? "";
}

test("a nucleus is drawn over the body of its cell, and not there without one", async () => {
  assert.match(await cellGroup(true), /#27406b/);
  assert.doesNotMatch(await cellGroup(false), /#27406b/);
});

// Rigid obstacles are drawn over every layer, explained, and saved; without any there is no word of them.

test("obstacles are drawn over every layer, explained and saved, and not there without any", async () => {
  const run = sampleRun({ radius: 60, interval: 600, end: 1200, fibres: false });
  if (run.frames)
    run.frames.obstacles_um = [
      [30, 30],
      [32, 30],
    ];
  const { page, errors } = await open(browser, "run", JSON.stringify(run));
  const entry = page.getByText("rigid obstacle", { exact: true });
  await until(async () => await entry.isVisible(), "obstacles are explained");
  await page.getByRole("button", { name: "The whole matrix" }).click();
  for (const layer of ["degradation", "von_mises"]) {
    await page.locator(`input[value=${layer}]`).check();
    const [download] = await Promise.all([
      page.waitForEvent("download"),
      page.getByRole("button", { name: "Save SVG" }).click(),
    ]);
    const svg = readFileSync(await download.path(), "utf8");
    const group = /<g id="obstacles">(.*?)<\/g>/s.exec(svg)?.[1] ?? "";
    assert.equal((/ d="([^"]*)"/.exec(group)?.[1]?.match(/M/g) ?? []).length, 2, `two squares over ${layer}: ${group}`);
  }
  assert.deepEqual(errors, []);
  await page.context().close();
  const plain = await open(browser, "run", JSON.stringify(sampleRun({ radius: 60, end: 1200, fibres: false })));
  assert.equal(await plain.page.getByText("rigid obstacle").count(), 0);
});
