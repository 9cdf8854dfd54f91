/** Colour maps and limits: they change the picture, say what lies beyond them, and refuse nonsense. */
import assert from "node:assert/strict";
import { test } from "node:test";
import { sampleRun } from "../sample/run";
import { colourMaps, mapped } from "../src/colour";
import { launch, open, still } from "./browser";

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
