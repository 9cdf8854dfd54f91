/** Rigid obstacles are drawn over every layer, explained, and saved; without any there is no word of them. */
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
