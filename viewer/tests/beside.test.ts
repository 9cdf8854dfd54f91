/** Two runs beside each other: the same colours and arrows mean the same in both, until each is to have its own. */
import assert from "node:assert/strict";
import { test } from "node:test";
import { sampleRun } from "../sample/run";
import { sampleStudy } from "../sample/study";
import { launch, open, until } from "./browser";

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
