// Opens a file in Simularium's viewer in Chromium: open.mjs FILE. The viewer must find the agents of the first and of the
// last frame, report no error, and draw them.
import assert from "node:assert";
import fs from "node:fs";
import { chromium } from "playwright-core";

const text = fs.readFileSync(process.argv[2], "utf8");
const file = JSON.parse(text);
const frames = file.spatialData.bundleData;

/** How many agents the numbers of a frame are. */
function agents(data) {
  let count = 0;
  for (let at = 0; at < data.length; at += 11 + data[at + 10]) ++count;
  return count;
}

const browser = await chromium.launch({
  executablePath: process.env.CHROMIUM || "/usr/bin/chromium",
  args: ["--no-sandbox", "--use-gl=angle", "--use-angle=swiftshader", "--enable-unsafe-swiftshader"],
});
try {
  const page = await browser.newPage({ viewport: { width: 300, height: 300 } });
  const faults = [];
  page.on("pageerror", (error) => faults.push(error.message));
  await page.evaluate(() => { // so that what is drawn can be read
    const get = HTMLCanvasElement.prototype.getContext;
    HTMLCanvasElement.prototype.getContext = function (kind, options) {
      return get.call(this, kind, { ...options, preserveDrawingBuffer: true });
    };
  });
  await page.setContent("<body style='margin:0'><div id='viewer'></div></body>");
  await page.addScriptTag({ content: fs.readFileSync("page.js", "utf8") });
  await page.waitForSelector("canvas");
  await page.evaluate((of) => window.open_file(of), text);
  const last = frames.length - 1;
  for (const k of [0, last]) {
    await page.evaluate((time) => window.go_to(time), frames[k].time);
    await page.waitForFunction((time) => Math.abs(window.what_is_seen().time - time) < 1e-3, frames[k].time, { timeout: 60000 });
    const seen = await page.evaluate(() => window.what_is_seen());
    assert.strictEqual(seen.agentCount, agents(frames[k].data));
    assert.deepStrictEqual(seen.errors, []);
    assert.strictEqual(seen.info.spatialUnits.name, "µm");
    for (const name of ["matrix", "adhesion", "cell 1"]) assert.ok(seen.names.includes(name), `${name} in ${seen.names}`);
  }
  await page.waitForTimeout(2000);
  const drawn = await page.evaluate(() => document.querySelector("canvas").toDataURL("image/png"));
  const picture = Buffer.from(drawn.split(",")[1], "base64");
  fs.writeFileSync("picture.png", picture);
  assert.ok(picture.length > 5000, `the picture has ${picture.length} bytes: nothing is drawn`);
  assert.deepStrictEqual(faults, []);
  console.log(`${frames.length} frames, ${agents(frames[last].data)} agents in the last one`);
} finally {
  await browser.close();
}
