/** The pages without a mouse, without sight of colours, without motion, and on paper. */
import assert from "node:assert/strict";
import { test } from "node:test";
import { sampleRun } from "../sample/run";
import { sampleStudy } from "../sample/study";
import { sampleVerdicts } from "../sample/verdicts";
import { colourMaps, mapped, phaseColoursOn, type Rgb } from "../src/colour";
import { launch, open, settled, until } from "./browser";

const run = sampleRun({ radius: 60, interval: 600, end: 7200 });
const told = ".screen > [role=status].unseen";

/** How a colour looks without one kind of cones (Vienot, Brettel and Mollon 1999), roughly: in linear light. */
const linear = (v: number) => (v <= 10 ? v / 3294.6 : ((v / 255 + 0.055) / 1.055) ** 2.4);
const withoutRed = ([r, g, b]: number[]): number[] => [0.112 * r + 0.888 * g, 0.112 * r + 0.888 * g, 0.004 * r - 0.004 * g + b];
const withoutGreen = ([r, g, b]: number[]): number[] => [0.293 * r + 0.707 * g, 0.293 * r + 0.707 * g, -0.021 * r + 0.021 * g + b];
const seenBy = (how: (c: number[]) => number[], colour: Rgb): number[] => how(colour.map(linear)).map((v) => Math.cbrt(Math.max(0, v)));
const apart = (a: number[], b: number[]): number => Math.hypot(...a.map((v, k) => v - b[k]));
const rgb = (hex: string): Rgb => [1, 3, 5].map((k) => parseInt(hex.slice(k, k + 2), 16)) as unknown as Rgb;

test("diverging maps have two ends, and a middle lighter than both, with any kind of colour vision", () => {
  for (const key of ["blueWhiteOrange", "purpleGreen"] as const)
    for (const eyes of [(c: number[]) => c, withoutRed, withoutGreen]) {
      const at = (share: number) => seenBy(eyes, mapped(colourMaps[key].on(), share));
      const bright = (share: number) => at(share).reduce((a, b) => a + b);
      for (let k = 1; k <= 12; ++k) {
        assert.ok(bright(0.5 + k / 24) < bright(0.5 + (k - 1) / 24), `${key}: above, ${k}`);
        assert.ok(bright(0.5 - k / 24) < bright(0.5 - (k - 1) / 24), `${key}: below, ${k}`);
      }
      for (const share of [0.1, 0.2, 0.3]) assert.ok(apart(at(share), at(1 - share)) > 0.1, `${key} at ${share}`);
    }
  // The fourth is drawn with dashes.
  for (const colours of [phaseColoursOn(false).slice(0, 3), phaseColoursOn(true).slice(0, 3)])
    for (const eyes of [withoutRed, withoutGreen])
      colours.forEach((a, i) =>
        colours.slice(i + 1).forEach((b) => assert.ok(apart(seenBy(eyes, rgb(a)), seenBy(eyes, rgb(b))) > 0.1, `${a} ${b}`)),
      );
});

test("letters act from any control that has no use for them, until they are switched off", async () => {
  const browser = await launch();
  const { page, errors } = await open(browser, "run", JSON.stringify(run));
  const layer = () => page.locator("input[name=layer]:checked").getAttribute("value");
  await page.locator("input[value=displacement]").check();
  await page.keyboard.press("l");
  assert.equal(await layer(), "pressure");
  await page.locator("select[name=map]").focus();
  await page.keyboard.press("l");
  assert.equal(await layer(), "pressure", "a choice is made by letters");
  await page.locator(".keys summary").click();
  await page.locator("input[name=keys-anywhere]").uncheck();
  await page.keyboard.press("l");
  assert.equal(await layer(), "pressure", "switched off");
  await page.locator(".stage").focus();
  await page.keyboard.press("l");
  assert.equal(await layer(), "von_mises", "the picture has them still");
  assert.deepEqual(errors, []);
  await browser.close();
});

test("whoever listens hears the moment, the layer and the fibres, and nothing while it plays", async () => {
  const browser = await launch();
  const { page } = await open(browser, "run", JSON.stringify(run));
  const words = async () => (await page.locator(told).textContent()) ?? "";
  await page.locator(".stage").focus();
  await page.keyboard.press("Home");
  assert.match(await words(), /^0 min\. Cell at x .* protrusion.*Colours show intact matrix and the strain of fibres\.$/);
  await page.keyboard.press("b");
  assert.match(await words(), /intact matrix\.$/);
  await page.keyboard.press("ArrowRight");
  assert.match(await words(), /^10 min\./);
  const before = await words();
  await page.keyboard.press(" ");
  await until(async () => (await page.locator(".stage .time").textContent()) !== "10 min", "it plays");
  assert.equal(await words(), before);
  await page.keyboard.press(" ");
  await until(async () => (await words()) !== before, "it is told again");
  await browser.close();
});

test("nothing moves by itself where stillness is wanted", async () => {
  const browser = await launch();
  const { page } = await open(browser, "run", JSON.stringify(run), { reducedMotion: "reduce" });
  assert.equal(await page.locator(".stage .time").textContent(), "2 h 00 min", "the end is shown");
  const moving = await page.evaluate(() => document.getAnimations().length);
  assert.equal(moving, 0);
  assert.equal(await page.locator(".play").getAttribute("aria-label"), "Play");
  await browser.close();
});

test("on paper there are pictures with their legends, and no controls", async () => {
  const browser = await launch();
  const { page, errors } = await open(browser, "run", JSON.stringify(run), { colorScheme: "dark" });
  await page.emulateMedia({ media: "print" });
  await page.evaluate(() => dispatchEvent(new Event("beforeprint")));
  await settled(page);
  for (const gone of [".transport", ".view-buttons", ".saving", ".keys", ".scale-controls", ".panel .choices"])
    assert.ok(!(await page.locator(gone).first().isVisible()), gone);
  for (const there of [".stage", ".legend-layer >> nth=0", ".legend-layer >> nth=1", ".signs >> nth=0", ".time", "#path .plot >> nth=0"])
    assert.ok(await page.locator(there).isVisible(), there);
  assert.equal(await page.evaluate(() => getComputedStyle(document.body).backgroundColor), "rgb(255, 255, 255)");
  assert.ok((await page.pdf()).length > 20000);
  assert.deepEqual(errors, []);
  await browser.close();
});

test("controls and regions have names of their own", async () => {
  const browser = await launch();
  for (const [template, data] of [["run", run], ["study", sampleStudy(2)], ["verdicts", sampleVerdicts()]] as const) {
    const { page } = await open(browser, template, JSON.stringify(data));
    const found = await page.evaluate(() => {
      const name = (e: Element) =>
        e.getAttribute("aria-label") ??
        document.getElementById(e.getAttribute("aria-labelledby") ?? "")?.textContent ??
        [...((e as HTMLInputElement).labels ?? [])].map((label) => label.textContent).join() + (e.textContent ?? "");
      const controls = [...document.querySelectorAll("button, input, select, a[href], [tabindex='0']")];
      const regions = [...document.querySelectorAll("section[aria-label], section[aria-labelledby], [role=region]")].map(name);
      return {
        nameless: controls.filter((e) => name(e).trim() === "").map((e) => e.outerHTML.slice(0, 120)),
        heads: [...document.querySelectorAll("th")].filter((e) => e.textContent === "").length,
        regions,
      };
    });
    assert.deepEqual(found.nameless, []);
    assert.equal(found.heads, 0, "a column without a heading");
    assert.equal(new Set(found.regions).size, found.regions.length, found.regions.join());
    await page.context().close();
  }
  await browser.close();
});
