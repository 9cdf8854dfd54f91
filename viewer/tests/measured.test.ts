/** Measured tracks over simulated ones: on the stage, beside the path and on the page of a study. */
import assert from "node:assert/strict";
import { after, before, test } from "node:test";
import type { Browser, Page } from "playwright-core";
import { sampleRun } from "../sample/run";
import { sampleStudy } from "../sample/study";
import { cellColours, gelOn, viridis } from "../src/colour";
import type { MeasuredTracks } from "../src/contract";
import { measuredOf, until as upTo } from "../src/measured";
import { measuredLine } from "../src/run/over/marks";
import { allDrawn, launch, open, still, until } from "./browser";

/** Two straight tracks of an hour, along x and along y. */
const two: MeasuredTracks = {
  total: 2,
  t_s: [0, 1800, 3600, null, 0, 1800, 3600],
  x_um: [0, 10, 20, null, 0, 0, 0],
  y_um: [0, 0, 0, null, 0, 15, 30],
};

test("null parts the tracks, and the words count them", () => {
  const { tracks, words } = measuredOf(two);
  assert.deepEqual(tracks[1], { t: [0, 1800, 3600], x: [0, 0, 0], y: [0, 15, 30] });
  assert.equal(words, "2 measured tracks");
  assert.equal(measuredOf({ ...two, total: 500 }).words, "2 of 500 measured tracks");
  assert.deepEqual(upTo(tracks[0], 1800), { t: [0, 1800], x: [0, 10], y: [0, 0] });
  assert.deepEqual(upTo(tracks[0], 9e9), tracks[0]);
  assert.deepEqual(measuredOf(null), { tracks: [], words: "" });
});

/** Contrast of two colours (WCAG 2). */
function contrast(one: string, other: string): number {
  const [high, low] = [one, other]
    .map((colour) => {
      const [r, g, b] = [1, 3, 5].map((at) => {
        const v = parseInt(colour.slice(at, at + 2), 16) / 255;
        return v <= 0.04045 ? v / 12.92 : ((v + 0.055) / 1.055) ** 2.4;
      });
      return 0.2126 * r + 0.7152 * g + 0.0722 * b;
    })
    .sort((a, b) => b - a);
  return (high + 0.05) / (low + 0.05);
}

const hex = (rgb: readonly number[]) => `#${rgb.map((part) => part.toString(16).padStart(2, "0")).join("")}`;

test("a track is seen on front and rear of a cell and on any matrix, on light and dark pages", () => {
  const { front, rear } = cellColours(0, 1);
  for (const dark of [false, true]) {
    const [halo, line] = measuredLine(dark);
    assert.ok(halo.width >= line.width + 2 && line.width >= 1.5, "lines that are wide enough");
    assert.ok(contrast(halo.colour, line.colour) > 7, "a line in its halo");
    const maps = [gelOn(false), gelOn(true), [viridis[0]!, viridis.at(-1)!]].flat();
    for (const ground of [front, rear, ...maps.map(hex)]) {
      const most = Math.max(contrast(halo.colour, ground), contrast(line.colour, ground));
      assert.ok(most > 3, `${ground}, ${dark ? "dark" : "light"}: ${most}`);
    }
  }
});

let browser: Browser;
before(async () => {
  browser = await launch();
});
after(async () => {
  await browser.close();
});

const small = sampleRun({ radius: 90, interval: 600, end: 7200 });
/** Pixels of the stage's upper canvas that are about as violet as measured tracks on a light page (117, 101, 138). */
const painted = (page: Page): Promise<number> =>
  page.evaluate(() => {
    const canvas = document.querySelector<HTMLCanvasElement>("canvas.cell");
    const data = canvas?.getContext("2d")?.getImageData(0, 0, canvas.width, canvas.height).data ?? [];
    let n = 0;
    for (let i = 0; i < data.length; i += 4) {
      const [r, g, b, a] = [data[i], data[i + 1], data[i + 2], data[i + 3]];
      if (a > 200 && r < 160 && r - g > 8 && b - g > 20) ++n;
    }
    return n;
  });

test("the stage draws them up to its time, and a switch takes them away", async () => {
  const { page, errors } = await open(browser, "run", JSON.stringify({ ...small, measured: two }));
  for (const name of ["cell", "protrusions", "adhesions", "path", "traction"]) await page.locator(`input[name=${name}]`).uncheck();
  const at = async (time: string) => {
    await page.locator(".scrub").fill(time);
    await still(page);
    return painted(page);
  };
  const [start, middle, end] = [await at("0"), await at("1800"), await at("3600")];
  assert.ok(start < 0.1 * middle && middle < 0.8 * end, `${start}, ${middle}, ${end} pixels`);
  assert.ok((await page.locator(".panel .signs").textContent())?.includes("2 measured tracks, from the start of the path"));
  await page.locator("input[name=measured]").uncheck();
  await still(page);
  assert.equal(await painted(page), 0);
  assert.deepEqual(errors, []);
  await page.context().close();
});

test("the plot of the path begins them where the path begins, and ends them with the run", async () => {
  const short = { ...small, t_end_s: 1800, measured: two };
  const { page } = await open(browser, "run", JSON.stringify(short));
  assert.equal(await page.locator("#path .curve.measured").count(), 2);
  const lines = await page.locator("#path .curve.measured").evaluateAll((all) => all.map((one) => one.getAttribute("d") ?? ""));
  assert.deepEqual(lines.map((d) => d.split(/[ML]/).length - 1), [2, 2], "positions up to 1800 s");
  const start = await page.locator("#path .start").first();
  const from = `M${Number(await start.getAttribute("cx")).toFixed(1)} ${Number(await start.getAttribute("cy")).toFixed(1)}`;
  for (const d of lines) assert.ok(d.startsWith(from), `${d} starts at ${from}`);
  assert.ok((await page.locator("#path figcaption").first().textContent())?.includes("2 measured tracks"));
  await page.context().close();
});

test("a page without measured tracks says nothing of them", async () => {
  const { page } = await open(browser, "run", JSON.stringify({ ...small, measured: null }));
  assert.equal(await page.locator("input[name=measured]").count(), 0);
  assert.ok(!(await page.locator("body").innerText()).includes("easured track"));
  await page.context().close();
});

test("a study draws them at the points that they belong to, until its switch is off", async () => {
  const study = sampleStudy();
  const points = study.groups.map((g) => g.point).filter((p) => p[1] === 0).slice(0, 1);
  const { page, errors } = await open(browser, "study", JSON.stringify({ ...study, measured: [{ ...two, points }] }));
  await allDrawn(page);
  const counts = () =>
    page.locator("#paths .plotly-figure").evaluateAll((all) =>
      all.map((plot) => (plot as unknown as { data: { text: string }[] }).data.filter((trace) => trace.text === "measured").length),
    );
  const first = await counts();
  assert.equal(first.length, 10);
  assert.equal(first.reduce((a, b) => a + b), 2, "two tracks at one of ten points");
  assert.ok((await page.locator("#paths").textContent())?.includes("2 measured tracks of up to 1 h, each moved to the origin"));
  await page.locator("#paths input[name=measured]").uncheck();
  await allDrawn(page);
  assert.deepEqual(await counts(), Array(10).fill(0));
  assert.deepEqual(errors, []);
  await page.context().close();
});

// Two runs beside each other: the same colours and arrows mean the same in both, until each is to have its own.

test("limits of colours and lengths of arrows are shared, or each run's own", async () => {
  const browser = await launch();
  const study = sampleStudy(1);
  const [first, second] = study.players ?? [];
  // Stresses of the second run are half those of the first.
  second.run = sampleRun({ seed: 5, radius: 60, interval: 600, end: 7200 });
  first.run = sampleRun({ seed: 6, radius: 60, interval: 600, end: 7200 });
  if (second.run.frames) second.run.frames.particles.von_mises.scale /= 2;
  const { page, errors } = await open(browser, "study", JSON.stringify(study));
  await page.locator("#players .stage").waitFor({ state: "attached" });
  assert.equal(await page.locator("input[name=same-scales]").count(), 0, "a run alone has nobody to share with");
  await page.locator("select[name=beside]").selectOption("1");
  await until(async () => (await page.locator("#players .stage").count()) === 2, "both are there");
  for (const k of [0, 1]) await page.locator(`#players input[value=von_mises] >> nth=${k}`).check();
  const highs = () => page.locator("#players input[name=high]").evaluateAll((all) => all.map((e) => (e as HTMLInputElement).value));
  const same = page.locator("input[name=same-scales]");
  assert.ok(await same.isChecked());
  assert.deepEqual(await highs(), ["120", "120"]);
  const keys = () => page.locator("#players .legend-layer >> text=Fibre strain").count();
  assert.equal(await keys(), 2);
  await same.uncheck();
  assert.deepEqual(await highs(), ["120", "60"]);
  await page.locator("#players input[name=high] >> nth=1").fill("30");
  await page.locator("#players input[name=high] >> nth=1").press("Enter");
  assert.deepEqual(await highs(), ["120", "30"]);
  await same.check();
  assert.deepEqual(await highs(), ["120", "120"]);
  await page.locator("#players input[name=high] >> nth=1").fill("80");
  await page.locator("#players input[name=high] >> nth=1").press("Enter");
  await page.locator("#players select[name=map] >> nth=0").selectOption("magma");
  assert.deepEqual(await highs(), ["80", "80"], "what is set in one holds in the other");
  assert.equal(await page.locator("#players select[name=map] >> nth=1").inputValue(), "magma");
  await page.getByRole("button", { name: "Reset" }).first().click();
  assert.deepEqual(await highs(), ["120", "120"]);
  await same.uncheck();
  assert.deepEqual(await highs(), ["120", "30"], "each has kept its own");
  assert.deepEqual(errors, []);
  await browser.close();
});
