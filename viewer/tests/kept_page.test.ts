/**
 * The page that `reproduce all --from docs/validation` makes; only where MATRIGRATE_PROGRAM and MATRIGRATE_SOURCE name the
 * program and its source.
 */
import assert from "node:assert/strict";
import { spawnSync } from "node:child_process";
import { mkdtempSync, rmSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { after, before, test } from "node:test";
import { pathToFileURL } from "node:url";
import type { Page } from "playwright-core";
import type { StudyData } from "../src/study/contract";
import type { VerdictPage } from "../src/verdicts/contract";
import { launch, until } from "./browser";

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
