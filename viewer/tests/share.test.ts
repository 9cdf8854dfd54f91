/** Taking a view away: an address of a moment, PNG, SVG, and a film. */
import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { test } from "node:test";
import type { Page } from "playwright-core";
import { sampleRun } from "../sample/run";
import { momentHash, momentOf, momentTime } from "../src/run/save/link";
import { fileName } from "../src/run/save/saving";
import { difference, launch, open, settled, until } from "./browser";

const run = sampleRun({ radius: 60, interval: 600, end: 7200 });
const time = (page: Page) => page.locator(".stage .time").textContent();

test("a moment is written and read again", () => {
  assert.equal(momentTime(11520), "3h12m");
  assert.equal(momentTime(0), "0m");
  for (const t of [0, 59, 60, 3600, 11520, 11525])
    assert.deepEqual(momentOf(momentHash(t, "pressure")), { time: t, layer: "pressure" });
  assert.equal(momentOf("#t=1.5h").time, 5400);
  assert.equal(momentOf("#t=90").time, 90);
  for (const hash of ["", "#players", "#t=", "#t=abc", "#t=3x"]) assert.equal(momentOf(hash).time, null, hash);
  assert.equal(fileName("cell: E = 200 Pa, seed 1", "pressure", 720, "png"), "cell-E-200-Pa-seed-1-pressure-12m.png");
});

test("an address names a moment and a layer, follows the player, and is copied", async () => {
  const browser = await launch();
  const { page, errors } = await open(browser, "run", JSON.stringify(run), { reducedMotion: "no-preference" }, "#t=1h05m&layer=pressure");
  assert.equal(await time(page), "1 h 05 min");
  await page.waitForTimeout(200);
  assert.equal(await time(page), "1 h 05 min", "it stays there");
  assert.ok(await page.locator("input[value=pressure]").isChecked());
  await page.locator(".scrub").fill("600");
  await until(async () => page.url().endsWith("#t=10m&layer=pressure"), "the address follows");
  await page.locator("input[value=von_mises]").check();
  await until(async () => page.url().endsWith("#t=10m&layer=von_mises"), "the layer too");
  await page.getByRole("button", { name: "Copy link" }).click();
  await page.getByText("Link copied.").waitFor();
  await page.evaluate(() => {
    location.hash = "#t=30m&layer=nonsense";
  });
  await until(async () => (await time(page)) === "30 min", "an address typed in is obeyed");
  assert.ok(await page.locator("input[value=von_mises]").isChecked());
  assert.deepEqual(errors, []);
  await browser.close();
});

test("pictures are saved as pixels and as vectors", async () => {
  const browser = await launch();
  const { page, errors, requests } = await open(browser, "run", JSON.stringify(run));
  await page.locator(".scrub").fill("3900");
  await page.locator("input[name=arrows]").check();
  const saved = async (name: string) => {
    const [download] = await Promise.all([page.waitForEvent("download"), page.getByRole("button", { name }).click()]);
    return { name: download.suggestedFilename(), bytes: readFileSync(await download.path()) };
  };
  const png = await saved("Save PNG");
  assert.equal(png.name, "sample-E-100-Pa-seed-1-degradation-1h5m.png");
  assert.equal(png.bytes.subarray(1, 4).toString(), "PNG");
  const address = (bytes: Buffer) => `data:image/png;base64,${bytes.toString("base64")}`;
  const size = (bytes: Buffer) => [bytes.readUInt32BE(16), bytes.readUInt32BE(20)];
  const [width, height] = size(png.bytes);
  await page.getByLabel("px wide").fill(String(3 * width));
  const wide = await saved("Save PNG");
  assert.equal(size(wide.bytes)[0], 3 * width);
  assert.ok(Math.abs(size(wide.bytes)[1] - 3 * height) <= 1);
  assert.ok((await difference(page, address(png.bytes), address(wide.bytes))) < 0.01, "the wide picture is another one");
  await page.getByLabel("px wide").fill("8000");
  const large = await saved("Save PNG");
  assert.equal(size(large.bytes)[0], 8000);
  assert.ok((await difference(page, address(png.bytes), address(large.bytes))) < 0.01, "the largest picture is another one");
  for (const wrong of ["199", "8001", "2000.5"]) {
    await page.getByLabel("px wide").fill(wrong);
    await page.getByRole("button", { name: "Save PNG" }).click();
    await page.getByText("Not saved: Error: the width is a whole number from 200 to 8000").waitFor();
    await page.getByLabel("px wide").fill("");
    assert.deepEqual((await saved("Save PNG")).bytes, png.bytes, "the view is as it was");
  }
  const svg = await saved("Save SVG");
  const seen = await page.evaluate(async (text) => {
    const parsed = new DOMParser().parseFromString(text, "image/svg+xml");
    const image = new Image();
    image.src = parsed.querySelector("image")!.getAttribute("href")!;
    await image.decode();
    const canvas = document.createElement("canvas");
    [canvas.width, canvas.height] = [image.width, image.height];
    const context = canvas.getContext("2d")!;
    context.drawImage(image, 0, 0);
    return {
      fault: parsed.querySelector("parsererror")?.textContent ?? null,
      parts: [...parsed.querySelectorAll("g[id]")].map((g) => g.id),
      paths: Object.fromEntries([...parsed.querySelectorAll("g[id]")].map((g) => [g.id, g.querySelectorAll("path").length])),
      texts: [...parsed.querySelectorAll("text")].map((t) => t.textContent),
      middle: context.getImageData(10, image.height >> 1, 1, 1).data[3],
      width: image.width,
    };
  }, svg.bytes.toString());
  assert.equal(seen.fault, null);
  for (const part of ["arrows", "cell", "protrusions", "adhesions", "path", "traction", "scales", "legend"])
    assert.ok(seen.parts.includes(part), part);
  for (const part of ["arrows", "cell", "protrusions", "path", "traction"]) assert.ok(seen.paths[part] > 0, part);
  assert.ok(seen.texts.includes("1 h 05 min") && ["Intact matrix (f_degr)", "0 fluid", "1 intact"].every((text) => seen.texts.includes(text)), seen.texts.join());
  assert.equal(seen.middle, 255, "the matrix is not in the picture");
  assert.deepEqual(errors, []);
  assert.deepEqual(requests, []);
  await browser.close();
});

test("an edge of the cell in colours has their scale in saved pictures, and no legend of what it hides", async () => {
  const browser = await launch();
  const { page, errors } = await open(browser, "run", JSON.stringify(run));
  const saved = async (name: string) => {
    const [download] = await Promise.all([page.waitForEvent("download"), page.getByRole("button", { name }).click()]);
    return readFileSync(await download.path());
  };
  const legend = async () => (await page.locator(".panel .signs li").allTextContents()).join("; ");
  const texts = async () =>
    [...(await saved("Save SVG")).toString().matchAll(/<text [^>]*>([^<]*)/g)].map((match) => match[1]);
  assert.match(await legend(), /growing; maturing; contracting; finishing; adhesion, larger when mature/);
  assert.ok(!(await texts()).includes("Edge:"));
  const plain = await saved("Save PNG");
  await page.locator("select[name=edge]").selectOption("force");
  const bar = (await page.locator("div.edge .bar-numbers").first().textContent()) ?? "";
  const seen = await texts();
  for (const text of ["Edge:", "actomyosin force (nN)"]) assert.ok(seen.includes(text), seen.join());
  assert.ok(bar.endsWith(seen[seen.indexOf("actomyosin force (nN)") - 2]), `${bar}: ${seen.join()}`);
  assert.match(await legend(), /adhesion, maturing; adhesion, contracting/);
  assert.ok(!/growing|finishing/.test(await legend()), await legend());
  const coloured = await saved("Save PNG");
  assert.ok(coloured.readUInt32BE(20) >= plain.readUInt32BE(20), "room for its scale");
  await page.locator("input[name=cell]").uncheck();
  assert.ok(!(await texts()).includes("Edge:"), "the edge goes with the cell");
  assert.match(await legend(), /growing/);
  assert.deepEqual(errors, []);
  await browser.close();
});

test("a film is recorded where the browser can, and the button is not there where it cannot", async () => {
  const browser = await launch();
  const short = JSON.stringify(sampleRun({ radius: 40, interval: 600, end: 2400 }));
  const { page, errors } = await open(browser, "run", short);
  const button = page.getByRole("button", { name: "Record WebM" });
  if (await page.evaluate(() => typeof MediaRecorder !== "undefined" && MediaRecorder.isTypeSupported("video/webm"))) {
    const [download] = await Promise.all([page.waitForEvent("download"), button.click()]);
    const bytes = readFileSync(await download.path());
    assert.ok(bytes.length > 2000, `${bytes.length} bytes`);
    assert.equal(bytes.subarray(0, 4).toString("hex"), "1a45dfa3", "not Matroska");
    await button.waitFor();
  }
  assert.deepEqual(errors, []);
  const bare = await browser.newContext();
  await bare.addInitScript(() => {
    Reflect.deleteProperty(window, "MediaRecorder");
  });
  const other = await bare.newPage();
  await other.goto(page.url());
  await other.waitForSelector("html[data-ready=true]");
  assert.equal(await other.getByRole("button", { name: "Record WebM" }).count(), 0);
  await browser.close();
});

// `window.matrigrate`, by which other programs take pictures: they are those that the player saves.

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
