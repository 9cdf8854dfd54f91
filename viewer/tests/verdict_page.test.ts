/** The page of verdicts in a browser: every statement, figure and study is there. */
import assert from "node:assert/strict";
import { spawnSync } from "node:child_process";
import { mkdtempSync, rmSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { after, before, test } from "node:test";
import { pathToFileURL } from "node:url";
import type { Browser, Page } from "playwright-core";
import { sampleVerdicts } from "../sample/verdicts";
import type { StudyData } from "../src/study/contract";
import type { VerdictPage } from "../src/verdicts/contract";
import { allDrawn, launch, open, until } from "./browser";

let browser: Browser;
before(async () => {
  browser = await launch();
});
after(async () => {
  await browser.close();
});

const opened = (data = sampleVerdicts(), options = {}) => open(browser, "verdicts", JSON.stringify(data), options);

test("shows verdicts in words, with what was published, what came out and why not", async () => {
  const { page, errors, requests } = await opened();
  assert.match((await page.locator(".status").textContent()) ?? "", /^1 of 3 hold, 1 undecided\.$/);
  assert.match((await page.locator("header .notice").textContent()) ?? "", /no verdicts on the paper/);
  const rows = await page.locator("#claims tbody tr").allTextContents();
  assert.equal(rows.length, 3);
  for (const part of ["A2 calibration", "does not hold", "not the paper's runs", "9.3 \u00b5m/h", "not met: 200 Pa"])
    assert.ok(rows[1].includes(part), part);
  assert.ok(rows[2].includes("undecided"));
  await page.locator("#claims a >> nth=1").click();
  assert.ok(page.url().endsWith("#row-A2"));
  const links = await page.locator("#row-A2 p a").allTextContents();
  assert.deepEqual(links, ["stiffness"], "of studies that are on the page");
  assert.deepEqual(errors, []);
  assert.deepEqual(requests, []);
  await page.context().close();
});

test("columns that nothing is said in are left out", async () => {
  const data = sampleVerdicts();
  const { page } = await opened({ ...data, statements: data.statements.slice(0, 1), setting: "" });
  assert.deepEqual(await page.locator("#claims th").allTextContents(), ["id", "statement", "verdict"]);
  assert.equal(await page.locator("header .notice").count(), 0);
  await page.context().close();
});

test("shows checks with measured, expected, tolerance and its reason", async () => {
  const { page } = await opened();
  const rows = page.locator("#row-creep .checks tbody tr");
  const texts = async (k: number) => rows.nth(k).locator("td").allTextContents();
  assert.deepEqual(await texts(0), ["final displacement (\u00b5m)", "0.998", "1", "0.01", "holds", "second order in the spacing"]);
  assert.deepEqual(await texts(1), ["force (nN)", "\u2013", "at most 2", "none", "does not hold", "a bound"]);
  assert.match((await page.locator("#row-creep ul").textContent()) ?? "", /<b>rigid<\/b>.*12 \u00b5m apart/, "text, not HTML");
  await page.context().close();
});

test("draws curves with their marks, axes and legend, and pictures as they are", async () => {
  const { page, errors } = await opened();
  await allDrawn(page);
  const drawn = await page.evaluate(() => {
    const plot = document.querySelector("[data-figure=creep] .plotly-figure") as unknown as {
      data: { mode: string; line: { dash: string; color: string }; y: unknown[] }[];
      _fullLayout: { xaxis: { type: string; title: { text: string } }; yaxis: { type: string; title: { text: string } } };
    };
    const { xaxis, yaxis } = plot._fullLayout;
    return {
      curves: plot.data.map((s) => [s.mode, s.line.dash, s.line.color, s.y.length]),
      axes: [xaxis.type, xaxis.title.text, yaxis.type, yaxis.title.text],
    };
  });
  assert.deepEqual(drawn.curves, [
    ["lines", "solid", "#0072b2", 21],
    ["markers", "solid", "#d55e00", 21],
    ["lines", "dash", "#009e73", 2],
  ]);
  assert.deepEqual(drawn.axes, ["linear", "time (s)", "log", "displacement (\u00b5m)"]);
  // No dot for the value that is missing, nor for the one that is zero, which a logarithmic axis cannot show.
  assert.equal(await page.locator("[data-figure=creep] .points path").count(), 19);
  assert.deepEqual(await page.locator("[data-figure=creep] .legendtext").allTextContents(), ["1 - exp(-t)", "measured"]);
  const picture = page.locator("#row-creep .picture img");
  assert.deepEqual(await picture.evaluate((e: HTMLImageElement) => [e.naturalWidth, e.naturalHeight, e.alt]), [60, 40, "The layer from above."]);
  assert.deepEqual(errors, []);
  await page.context().close();
});

test("draws of a study what its own page draws", async () => {
  const { page, errors } = await opened();
  await allDrawn(page);
  const count = (name: string, what = ".plotly-figure") => page.locator(`[data-figure="${name}"] ${what}`).count();
  assert.deepEqual(
    [await count("stiffness"), await count("stiffness-paths"), await count("stiffness-msd"), await count("stiffness-adhesions")],
    [5, 10, 1, 5],
  );
  const { study } = sampleVerdicts().studies[0];
  assert.equal(await count("stiffness-shapes", "polygon"), study.runs.filter((r) => r.outline).length);
  assert.equal(await count("stiffness-msd", ".scatterlayer .trace"), study.msd.length + 1);
  assert.deepEqual(errors, []);
  await page.context().close();
});

test("reads on a phone and on paper", async () => {
  for (const colorScheme of ["light", "dark"] as const) {
    const { page } = await opened(sampleVerdicts(), { viewport: { width: 390, height: 844 }, colorScheme });
    await allDrawn(page, 390);
    const wide = await page.evaluate(() => document.documentElement.scrollWidth - window.innerWidth);
    assert.ok(wide <= 0, `scrolls sideways by ${wide}`);
    await page.context().close();
  }
  const { page, errors } = await opened(sampleVerdicts(), { colorScheme: "dark" });
  const undrawn = await page.evaluate(() => {
    dispatchEvent(new Event("beforeprint"));
    return [...document.querySelectorAll(".plotly-figure")].filter((plot) => !plot.querySelector(".main-svg")).length;
  });
  assert.equal(undrawn, 0);
  await page.emulateMedia({ media: "print" });
  assert.equal(await page.evaluate(() => getComputedStyle(document.body).backgroundColor), "rgb(255, 255, 255)");
  assert.deepEqual(errors, []);
  await page.context().close();
});

test("says plainly what is wrong with its data", async () => {
  const { page } = await open(browser, "verdicts", JSON.stringify({ format: "matrigrate-study", version: 1 }));
  assert.match((await page.locator(".fault").textContent()) ?? "", /holds 'matrigrate-study'/);
  await page.context().close();
});

// The page that `reproduce all --from docs/validation` makes; only where MATRIGRATE_PROGRAM and MATRIGRATE_SOURCE name the
// program and its source.

const program = process.env["MATRIGRATE_PROGRAM"];
const source = process.env["MATRIGRATE_SOURCE"];
const options = { skip: program === undefined || source === undefined };

let folder = "";
before(() => {
  folder = mkdtempSync(join(tmpdir(), "matrigrate-kept-"));
});
after(() => rmSync(folder, { recursive: true }));

/** The page of some rows. Claims that do not hold are no failure. */
function reproduced(rows: string): string {
  const out = join(folder, rows);
  const ended = spawnSync(program!, ["reproduce", rows, "--from", join(source!, "docs/validation"), "-o", out]);
  assert.ok(ended.status === 0 || ended.status === 4, String(ended.stderr));
  return join(out, `report-${rows}.html`);
}

/** Traces of each plot of a figure, and the numbers of their points. */
async function traces(page: Page, name: string): Promise<number[][]> {
  const plots = page.locator(`[data-figure="${name}"] .plotly-figure`);
  for (const plot of await plots.all()) {
    await plot.scrollIntoViewIfNeeded();
    await until(async () => (await plot.getAttribute("data-drawn")) === "true", `${name} is drawn`);
  }
  return plots.evaluateAll((all) =>
    all.map((plot) => (plot as unknown as { data: { x: unknown[] }[] }).data.map((trace) => trace.x.length)),
  );
}

const sum = (v: number[]): number => v.reduce((a, b) => a + b, 0);

async function checkStudy(page: Page, name: string, study: StudyData): Promise<void> {
  const done = study.runs.filter((run) => run.status === "done");
  assert.ok(done.length > 0, name);
  const paths = await traces(page, `${name}-paths`);
  const hasPaths = done.some((run) => run.path); // their tables are kept of some studies only
  if (hasPaths) assert.equal(paths.length, new Set(done.map((run) => run.point.join())).size, `${name}: a picture of paths a point`);
  const lines = done.flatMap((run) => (run.path ? run.path.x_um.join().split(",,") : []));
  assert.equal(paths.flat().length, lines.length, `${name}: paths`);
  assert.equal(sum(paths.flat()), sum(lines.map((line) => line.split(",").length)), `${name}: points of paths`);
  assert.equal((await traces(page, name)).length, study.readouts.length, `${name}: boxes`);
  const heights = await page
    .locator(`[data-figure="${name}"] .plotly-figure`)
    .evaluateAll((all) => all.map((plot) => (plot as unknown as { _fullLayout: { _size: { h: number } } })._fullLayout._size.h));
  assert.ok(Math.min(...heights) > 250, `${name}: boxes are ${heights.join(", ")} pixels high, beside their labels`);
  const [msd] = await traces(page, `${name}-msd`);
  if (study.msd.length > 0) assert.deepEqual(msd, [...study.msd.map((m) => m.lag_min.length), 2], `${name}: mean square displacements`);
  const outlines = study.runs.filter((run) => run.outline).length;
  assert.equal(await page.locator(`[data-figure="${name}-shapes"] polygon`).count(), outlines, `${name}: shapes`);
  const forces = (await traces(page, `${name}-adhesions`)).length;
  assert.equal(forces > 0, done.some((run) => (run.f_adh_rel ?? []).length > 0), `${name}: forces`);
}

test("every figure of the kept results is drawn, with all its points", options, async () => {
  const browser = await launch();
  for (const rows of ["all", "X"]) {
    const page = await browser.newPage();
    const errors: string[] = [];
    page.on("console", (message) => message.type() === "error" && errors.push(message.text()));
    page.on("pageerror", (error) => errors.push(error.message));
    await page.goto(pathToFileURL(reproduced(rows)).href);
    await page.waitForSelector("html[data-ready=true]");
    const data = JSON.parse((await page.locator("#matrigrate-data").textContent()) ?? "") as VerdictPage;
    for (const { name, study } of data.studies) await checkStudy(page, name, study);
    assert.deepEqual(errors, []);
    await page.close();
  }
  await browser.close();
});
