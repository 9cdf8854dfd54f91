/** `window.matrigrate`, by which other programs take pictures: they are those that the player saves. */
import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { test } from "node:test";
import { sampleRun } from "../sample/run";
import { difference, launch, open, settled } from "./browser";

test("pictures of the hook are those of the player", async () => {
  const browser = await launch();
  const run = sampleRun({ radius: 60, interval: 600, end: 7200 });
  const { page, errors } = await open(browser, "run", JSON.stringify(run));
  const taken = await page.evaluate(async () => {
    const { matrigrate } = window;
    if (!matrigrate) throw new Error("there is no hook");
    await matrigrate.ready;
    matrigrate.show({ width: 640, height: 480, layer: "pressure" });
    const canvas = matrigrate.frame(3900);
    return { data: canvas.toDataURL("image/png"), size: [canvas.width, canvas.height] };
  });
  assert.deepEqual(taken.size, [640, 480]);
  assert.ok(await page.locator("input[value=pressure]").isChecked());
  await page.locator(".scrub").evaluate((bar: HTMLInputElement) => {
    bar.value = "3900";
    bar.dispatchEvent(new Event("input"));
  });
  await settled(page);
  const [download] = await Promise.all([
    page.waitForEvent("download"),
    page.getByRole("button", { name: "Save PNG" }).evaluate((button: HTMLButtonElement) => button.click()),
  ]);
  const saved = `data:image/png;base64,${readFileSync(await download.path()).toString("base64")}`;
  assert.equal(await difference(page, taken.data, saved), 0);
  const other = await page.evaluate(() => window.matrigrate!.frame(600).toDataURL("image/png"));
  assert.ok((await difference(page, taken.data, other)) > 0.001, "the time changes nothing");
  const followed = await page.evaluate(() => {
    window.matrigrate!.show({ width: 640, height: 480, follow: true });
    return window.matrigrate!.frame(600).toDataURL("image/png");
  });
  assert.ok((await difference(page, followed, other)) > 0.001, "following changes nothing");
  const whole = await page.evaluate(() => {
    window.matrigrate!.show({ width: 640, height: 480, follow: false, whole: true });
    return window.matrigrate!.frame(600).toDataURL("image/png");
  });
  assert.ok((await difference(page, whole, other)) > 0.001, "the whole matrix is no wider view");
  const drawn = await page.evaluate(() => {
    const { matrigrate } = window;
    return { one: matrigrate!.svg(600), several: matrigrate!.panel([0, 600, 3900, 7200, 6600]) };
  });
  const vector = (text: string) => `data:image/svg+xml;base64,${Buffer.from(text).toString("base64")}`;
  assert.ok((await difference(page, whole, vector(drawn.one))) < 0.01, "the SVG is another picture");
  for (const time of ["0 min", "10 min", "1 h 05 min", "1 h 50 min", "2 h 00 min"])
    assert.equal(drawn.several.split(`>${time}</text>`).length, 2, time);
  assert.equal(drawn.several.match(/<image /g)?.length, 5);
  assert.equal(drawn.several.match(/>Pressure \(/g)?.length, 1, "one colour bar");
  for (const sign of ["front", "maturing", "path of the centre"]) assert.ok(drawn.several.includes(`>${sign}</text>`), sign);
  const names = [...drawn.several.matchAll(/ id="([^"]*)"/g)].map(([, name]) => name);
  assert.equal(new Set(names).size, names.length, "a name stands twice");
  assert.ok(await page.evaluate((text) => !new DOMParser().parseFromString(text, "image/svg+xml").querySelector("parsererror"), drawn.several));
  const fault = await page.evaluate(() => {
    try {
      window.matrigrate!.show({ width: 640, height: 480, layer: "colour" });
      return "";
    } catch (reason) {
      return String(reason);
    }
  });
  assert.match(fault, /no layer "colour"/);
  assert.deepEqual(errors, []);
  await page.context().close();
  const empty = await open(browser, "run", JSON.stringify({ ...run, frames: null }));
  const none = await empty.page.evaluate(() => window.matrigrate!.ready.then(() => "", String));
  assert.match(none, /no frames/);
  assert.deepEqual(empty.errors, []);
  await browser.close();
});
