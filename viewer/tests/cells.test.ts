/** Several cells: each has its colour and its number, in the player, the legend, the plots and the tables. */
import assert from "node:assert/strict";
import { after, before, test } from "node:test";
import type { Browser, Page } from "playwright-core";
import { groupOf } from "../sample/group";
import { sampleRun } from "../sample/run";
import { sampleStudy } from "../sample/study";
import { cellColourCount, cellColours } from "../src/colour";
import { valueAt } from "../src/embedded";
import { cellParts, tracksOfCells } from "../src/run/cells";
import { type Film, film, outlineAt } from "../src/run/frames";
import { layers } from "../src/run/matrix/layers";
import { cellTextAt, description, isInside, probeText } from "../src/run/probe";
import { field, launch, open, settled } from "./browser";

const one = () => sampleRun({ radius: 110, interval: 600, end: 7200, fibres: false });
const shifts: [number, number][] = [
  [-40, 0],
  [40, 0],
  [0, 55],
];

let browser: Browser;
before(async () => {
  browser = await launch();
});
after(async () => {
  await browser.close();
});

/** How many pixels of the upper canvas have a colour. */
async function pixelsOf(page: Page, colour: string): Promise<number> {
  await page.evaluate(() => new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(done))));
  return page.evaluate((wanted) => {
    const canvas = document.querySelector<HTMLCanvasElement>(".stage canvas.cell")!;
    const { data } = canvas.getContext("2d")!.getImageData(0, 0, canvas.width, canvas.height);
    const [r, g, b] = [1, 3, 5].map((k) => parseInt(wanted.slice(k, k + 2), 16));
    let count = 0;
    for (let i = 0; i < data.length; i += 4) if (data[i] === r && data[i + 1] === g && data[i + 2] === b) ++count;
    return count;
  }, colour);
}

test("points and rows are told apart by the number of the cell", () => {
  assert.deepEqual(cellParts(3, undefined), [{ number: 1, first: 0, end: 3 }]);
  assert.deepEqual(cellParts(4, [1, 1, 2, 2]), [
    { number: 1, first: 0, end: 2 },
    { number: 2, first: 2, end: 4 },
  ]);
  const { tracks } = one();
  assert.equal(tracksOfCells(tracks)[0].tracks, tracks);
});

test("each of several cells has a colour of its own, and a single one those that it had", () => {
  const all = Array.from({ length: cellColourCount }, (_, k) => cellColours(k, 2));
  assert.equal(new Set(all.flatMap(({ rear, front }) => [rear, front])).size, 2 * cellColourCount);
  assert.deepEqual(cellColours(0, 1), { rear: "#0072b2", front: "#45c4b8" });
  assert.deepEqual(cellColours(cellColourCount, 20), cellColours(0, 20));
});

test("the player draws each cell in its colours, and the page says which cell", async () => {
  const { page, errors } = await open(browser, "run", JSON.stringify(await groupOf(one(), shifts)));
  await page.locator(".scrub").fill("6000");
  for (const k of [0, 1, 2]) {
    const { rear, front } = cellColours(k, 3);
    assert.ok((await pixelsOf(page, rear)) > 100, `rear of cell ${k + 1}`);
    assert.ok((await pixelsOf(page, front)) > 100, `front of cell ${k + 1}`);
  }
  assert.equal(await pixelsOf(page, cellColours(0, 1).front), 0);
  const signs = await page.locator(".panel .signs").textContent();
  assert.match(signs ?? "", /cell 1 \(rear, front\)cell 2cell 3/);
  assert.match((await page.locator(".run-player .unseen").allTextContents()).join(" "), /Cell 3 at x/);
  assert.match((await page.locator(".present").textContent()) ?? "", /cell 1, \d+ /);
  assert.equal(await page.locator("#path .plot").first().locator(".curve.faint").count(), 3);
  assert.equal(await page.locator("#path .plot").nth(1).locator(".curve").count(), 3);
  assert.match((await page.locator("#protrusions .plot").textContent()) ?? "", /2\/1/);
  assert.equal(await page.locator("#readouts th").first().textContent(), "cell");
  assert.deepEqual(errors, []);
  await page.context().close();
});

test("a point in a cell is of that cell, though the edge of its neighbour is within reach", () => {
  const square = (left: number) => [left, 0, left + 10, 0, left + 10, 10, left, 10];
  const made = {
    outline: { x: field([...square(0), ...square(10.5)], 0.001), protrusion: field(Array.from({ length: 8 }, () => 255), 1) },
    outlinePoints: 8,
    cells: cellParts(8, [1, 1, 1, 1, 2, 2, 2, 2]),
    protrusions: [[]],
  } as unknown as Film;
  const at = (x: number, y: number) => cellTextAt(made, { frame: 0, next: 0, fraction: 0 }, x, y, 2);
  assert.deepEqual([at(9.8, 9), at(10.7, 9), at(-1, 0), at(5, 30)], ["Cell 1", "Cell 2", "Cell 1", ""]);
});

test("the page of a study plays all cells of a run, and has a path for each", async () => {
  const study = sampleStudy();
  const first = study.players![0];
  first.run = await groupOf(one(), shifts);
  const run = study.runs.find(({ id }) => id === first.id)!;
  const { x_um: x, y_um: y } = run.path!;
  run.path = { x_um: [...x, null, ...x.map((v) => v && v + 20)], y_um: [...y, null, ...y] };
  const { page, errors } = await open(browser, "study", JSON.stringify(study));
  await page.locator("#players .stage").waitFor({ state: "attached" });
  await page.locator("#players h2 >> nth=0").scrollIntoViewIfNeeded();
  await page.locator("#players .scrub").fill("6000");
  for (const k of [0, 1, 2]) {
    const { rear, front } = cellColours(k, 3);
    assert.ok((await pixelsOf(page, rear)) > 100, `rear of cell ${k + 1}`);
    assert.ok((await pixelsOf(page, front)) > 100, `front of cell ${k + 1}`);
  }
  assert.match((await page.locator("#players .panel .signs").textContent()) ?? "", /cell 1 \(rear, front\)cell 2cell 3/);
  const ofSecondCell = () =>
    page.evaluate(
      () =>
        [...document.querySelectorAll<HTMLElement & { data?: { text?: string }[] }>("#paths .js-plotly-plot")]
          .flatMap((plot) => (plot.data ?? []).map(({ text }) => String(text)))
          .filter((text) => text.includes("cell 2")).length,
    );
  await page.locator("#paths").scrollIntoViewIfNeeded();
  for (let k = 0; k < 100 && (await ofSecondCell()) === 0; ++k) await page.waitForTimeout(100); // drawn when it is looked at
  assert.equal(await ofSecondCell(), 1, "a path of the second cell");
  assert.deepEqual(errors, []);
  await page.context().close();
});

test("a single cell has neither numbers nor a column for them", async () => {
  const { page, errors } = await open(browser, "run", JSON.stringify(one()));
  await page.locator(".scrub").fill("6000");
  assert.ok((await pixelsOf(page, cellColours(0, 1).front)) > 100);
  assert.equal(await pixelsOf(page, cellColours(0, 2).front), 0);
  assert.doesNotMatch((await page.locator(".panel .signs").textContent()) ?? "", /cell 1/);
  assert.equal(await page.locator("#readouts th").first().textContent(), "what");
  assert.deepEqual(errors, []);
  await page.context().close();
});

// Values under the pointer and by keyboard, the words for screen readers, and every control by keyboard.

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
