/** The nucleus of a cell is drawn over its body and explained; without any there is no word of it. */
import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { after, before, test } from "node:test";
import type { Browser } from "playwright-core";
import { sampleRun } from "../sample/run";
import { launch, open, until } from "./browser";

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
