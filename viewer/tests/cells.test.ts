/** Several cells: each has its colour and its number, in the player, the legend, the plots and the tables. */
import assert from "node:assert/strict";
import { after, before, test } from "node:test";
import type { Browser, Page } from "playwright-core";
import { groupOf } from "../sample/group";
import { sampleRun } from "../sample/run";
import { sampleStudy } from "../sample/study";
import { cellColourCount, cellColours } from "../src/colour";
import { cellTextAt } from "../src/run/describe";
import { cellParts, tracksOfCells } from "../src/run/cells";
import type { Film } from "../src/run/frames";
import { field, launch, open } from "./browser";

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
    outline: { x: field([...square(0), ...square(10.5)], 2, 0.001), protrusion: field(Array.from({ length: 8 }, () => 255), 1, 1) },
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
