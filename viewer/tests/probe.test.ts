/** Values under the pointer and by keyboard, the words for screen readers, and every control by keyboard. */
import assert from "node:assert/strict";
import { test } from "node:test";
import { sampleRun } from "../sample/run";
import { cellTextAt, description, isInside } from "../src/run/describe";
import { film, outlineAt } from "../src/run/frames";
import { valueAt } from "../src/embedded";
import { layers } from "../src/run/matrix/layers";
import { probeText } from "../src/run/probe";
import { launch, open, settled } from "./browser";

const run = sampleRun({ radius: 60, interval: 600, end: 7200 });

test("a value has its unit and place, and says where there is none", async () => {
  const all = layers((await film(run))!);
  const pressure = all.find((layer) => layer.key === "pressure")!;
  assert.equal(probeText(pressure, -3.456, 12.34, -5.67), "Pressure \u22123.46 Pa at x 12.3, y \u22125.7 \u00b5m");
  assert.equal(probeText(pressure, null, 0, 0), "No matrix at x 0, y 0 \u00b5m");
  assert.match(probeText(pressure, NaN, 0, 0), /none, fluid/);
});

test("a moment in words", async () => {
  const made = (await film(run))!;
  const text = description(made, run.tracks, layers(made)[0], 3600);
  assert.match(text, /^1 h 00 min\. Cell at x .* \u00b5m, (no protrusion|\d protrusions?: number)/);
  assert.match(text, /Colours show intact matrix\.$/);
});

test("a point lies in a ring or outside of it", () => {
  const ring = [0, 0, 4, 0, 4, 4, 2, 1, 0, 4]; // with a notch from above
  assert.ok(isInside(ring, 0.5, 1));
  assert.ok(isInside(ring, 3.5, 1));
  assert.ok(!isInside(ring, 2, 3));
  assert.ok(!isInside(ring, 5, 1));
});

test("what of a cell lies at a point is said: its body, a protrusion with its phase, or nothing", async () => {
  const made = (await film(run))!;
  let protrusions = 0;
  for (let frame = 0; frame < made.times.length; ++frame) {
    const place = { frame, next: frame, fraction: 0 };
    const outline = outlineAt(made, place);
    const [cx, cy] = [0, 1].map((c) => outline.filter((_, k) => k % 2 === c).reduce((a, b) => a + b, 0) / made.outlinePoints);
    assert.match(cellTextAt(made, place, cx, cy, 0), /^Cell$/);
    assert.equal(cellTextAt(made, place, cx + 500, cy, 2), "");
    for (let i = 0; i < made.outlinePoints; ++i) {
      const p = made.protrusions[frame][valueAt(made.outline.protrusion, frame, i)];
      const text = cellTextAt(made, place, outline[2 * i], outline[2 * i + 1], 0.01);
      if (!p) assert.equal(text, "Cell");
      else {
        ++protrusions;
        assert.match(text, new RegExp(`^Protrusion ${p.id}: (growing|maturing, f_mat|contracting, f_mat|finishing, f_mat)`));
      }
    }
  }
  assert.ok(protrusions > 0);
});

test("the pointer and the keyboard find the same value, as field and as particles", async () => {
  const browser = await launch();
  const { page, errors } = await open(browser, "run", JSON.stringify(run));
  const probe = page.locator(".probe");
  await page.locator(".scrub").fill("3900");
  await page.locator("input[value=pressure]").check();
  assert.ok(!(await probe.isVisible()));
  const box = (await page.locator(".stage").boundingBox())!;
  await page.mouse.move(box.x + 0.5 * box.width, box.y + 0.5 * box.height);
  await settled(page);
  const pointed = await probe.textContent();
  assert.match(pointed ?? "", /^Pressure \S+ Pa at x \S+, y \S+ \u00b5m(\. (Cell|Protrusion).*)?$/);
  await page.mouse.move(5, 5);
  assert.ok(!(await probe.isVisible()));
  await page.locator(".stage").focus();
  await page.keyboard.press("v");
  await settled(page);
  const numbers = (text: string | null) => (text ?? "").match(/[\d.]+/g)!.map(Number);
  assert.ok(Math.abs(numbers(await probe.textContent())[1] - numbers(pointed)[1]) <= 0.2);
  await page.keyboard.press("Shift+ArrowRight");
  await settled(page);
  assert.notEqual(await probe.textContent(), pointed);
  await page.locator(".stage [role=status]").getByText(/Pressure/).waitFor({ state: "attached" });
  await page.locator("input[value=particles]").check();
  await settled(page);
  assert.match((await probe.textContent()) ?? "", /^Pressure .* Pa at x/);
  await page.locator(".stage").focus();
  await page.keyboard.press("l");
  assert.ok(await page.locator("input[value=von_mises]").isChecked(), "L goes to the next layer");
  assert.deepEqual(errors, []);
  await browser.close();
});

test("every control is reached by the tab key and has a name; the story is there in words", async () => {
  const browser = await launch();
  const { page } = await open(browser, "run", JSON.stringify(run));
  const nameless = await page.evaluate(() =>
    [...document.querySelectorAll("button, input, select, summary, [tabindex]")]
      .filter((e) => e.getClientRects().length > 0)
      .filter((e) => !(e.getAttribute("aria-label") || e.textContent?.trim() || (e as HTMLInputElement).labels?.length))
      .map((e) => e.outerHTML),
  );
  assert.deepEqual(nameless, []);
  const ids = await page.evaluate(() => [...document.querySelectorAll("[id]")].map((e) => e.id));
  assert.equal(new Set(ids).size, ids.length, "ids are not unique");
  assert.match((await page.locator(".screen > [role=status]").textContent()) ?? "", /^2 h 00 min\. Cell at x/);
  const reached = new Set<string>();
  for (let i = 0; i < 40; ++i) {
    await page.keyboard.press("Tab");
    reached.add(await page.evaluate(() => document.activeElement?.getAttribute("name") ?? document.activeElement?.className ?? ""));
  }
  for (const one of ["stage", "play", "scrub", "layer", "style", "map", "low", "high", "cell", "edge"])
    assert.ok(reached.has(one), `${one} is not reached: ${[...reached].join(", ")}`);
  await browser.close();
});
