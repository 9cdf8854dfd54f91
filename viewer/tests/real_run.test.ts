/** The report of a run that the program has just made; only where MATRIGRATE_PROGRAM names it. */
import assert from "node:assert/strict";
import { execFileSync, spawn, spawnSync } from "node:child_process";
import { mkdtempSync, readdirSync, readFileSync, rmSync, symlinkSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { test } from "node:test";
import { pathToFileURL } from "node:url";
import type { Browser, Page } from "playwright-core";
import { difference, launch, shot, until } from "./browser";

const program = process.env["MATRIGRATE_PROGRAM"];

const scenario = `[ecm]
radius = "40 um"
[output]
track_interval = "8 s"
field_interval = "12 s"
[run]
duration = "60 s"
`;

const study = `scenario = "s.toml"
replicates = 2
readouts = ["v_migr_abs_um_per_h", "n_protrusions"]
[sweep]
ecm.youngs_modulus = ["50 Pa", "200 Pa"]
`;

/** Colours of a canvas that differ by more than drawing does, on a coarse grid of the picture as it is seen. */
async function coloursOf(page: Page): Promise<number> {
  const picture = (await page.locator(".stage").screenshot()).toString("base64");
  return page.evaluate(async (data) => {
    const image = new Image();
    image.src = `data:image/png;base64,${data}`;
    await image.decode();
    const canvas = document.createElement("canvas");
    [canvas.width, canvas.height] = [image.width, image.height];
    const context = canvas.getContext("2d")!;
    context.drawImage(image, 0, 0);
    const { data: pixels } = context.getImageData(0, 0, image.width, image.height);
    const seen = new Set<number>();
    for (let i = 0; i < pixels.length; i += 4 * 97)
      seen.add(((pixels[i] >> 5) << 6) | ((pixels[i + 1] >> 5) << 3) | (pixels[i + 2] >> 5));
    return seen.size;
  }, picture);
}

async function opened(browser: Browser, file: string): Promise<{ page: Page; errors: string[] }> {
  const page = await browser.newPage();
  const errors: string[] = [];
  page.on("console", (message) => message.type() === "error" && errors.push(message.text()));
  page.on("pageerror", (error) => errors.push(error.message));
  await page.goto(pathToFileURL(file).href);
  await page.waitForSelector("html[data-ready=true]");
  return { page, errors };
}

async function within(work: (folder: string, browser: Browser) => Promise<void>): Promise<void> {
  const folder = mkdtempSync(join(tmpdir(), "matrigrate-real-"));
  const browser = await launch();
  try {
    writeFileSync(join(folder, "s.toml"), scenario);
    writeFileSync(join(folder, "e.toml"), study);
    await work(folder, browser);
  } finally {
    await browser.close();
    rmSync(folder, { recursive: true });
  }
}

test("a report of the program opens, plays and shows every layer", { skip: program === undefined }, () =>
  within(async (folder, browser) => {
    execFileSync(program!, ["run", "s.toml", "-o", "run", "--quiet"], { cwd: folder });
    const { page, errors } = await opened(browser, join(folder, "run", "report.html"));
    assert.equal(await page.locator("h1").textContent(), "s: E = 200 Pa, seed 1");
    assert.equal(await page.title(), "s: E = 200 Pa, seed 1");
    const time = () => page.locator(".stage .time").textContent();
    if ((await page.locator(".play").getAttribute("aria-label")) === "Pause") await page.locator(".play").click();
    await page.locator(".scrub").fill("0");
    const first = await shot(page);
    assert.ok((await coloursOf(page)) > 3, "a blank picture");
    await page.locator(".play").click();
    await until(async () => (await time()) !== "0 s" && (await time()) !== "0 min", "it plays");
    await page.locator(".scrub").fill("60");
    assert.notEqual(await shot(page), first, "nothing moves");
    const layers = await page
      .locator("input[name=layer]")
      .evaluateAll((all) => all.map((e) => e.getAttribute("value")));
    assert.deepEqual(layers, ["degradation", "displacement", "pressure", "von_mises"]);
    const seen = new Set<string>();
    for (const layer of layers) {
      await page.locator(`input[value=${layer}]`).check();
      seen.add(await shot(page));
    }
    assert.equal(seen.size, layers.length);
    for (const box of await page.locator(".panel input[type=checkbox]").all()) {
      const before = await shot(page);
      await box.setChecked(!(await box.isChecked()));
      if ((await box.getAttribute("name")) === "cell") assert.notEqual(await shot(page), before);
    }
    await page.locator("text=ecm.radius").first().waitFor();
    assert.deepEqual(errors, []);
  }),
);

const has = (tool: string): boolean => !spawnSync(tool, ["-version"]).error;

test("a movie of the program shows what the player shows", { skip: program === undefined || !has("ffmpeg") }, () =>
  within(async (folder, browser) => {
    execFileSync(program!, ["run", "s.toml", "-o", "run", "--quiet"], { cwd: folder });
    const options = ["--fps", "30", "--seconds", "0.5", "--size", "640x480", "--layer", "pressure"];
    execFileSync(program!, ["export", "run", "--movie", ...options, "-o", "out"], { cwd: folder });
    const pictures = ["-loglevel", "error", "-i", "out/movie.mp4", "-fps_mode", "passthrough", "p%d.png"];
    execFileSync("ffmpeg", pictures, { cwd: folder });
    const { page, errors } = await opened(browser, join(folder, "run", "report.html"));
    await page.evaluate(async () => {
      await window.matrigrate!.ready;
      window.matrigrate!.show({ width: 640, height: 480, layer: "pressure" });
    });
    const shown = (t: number) => page.evaluate((at) => window.matrigrate!.frame(at).toDataURL("image/png"), t);
    const filmed = (k: number) => `data:image/png;base64,${readFileSync(join(folder, `p${k + 1}.png`)).toString("base64")}`;
    for (const k of [0, 5, 14]) {
      const away = await difference(page, filmed(k), await shown((60 * k) / 14));
      assert.ok(away < 0.01, `picture ${k} is ${(100 * away).toFixed(2)} % off`);
    }
    const end = await difference(page, filmed(14), await shown(60));
    assert.ok(end < (await difference(page, filmed(14), await shown(0))), "nothing moves");
    assert.throws(() => filmed(15), "15 pictures in half a second");
    assert.deepEqual(readdirSync(join(folder, "out")), ["movie.mp4"], "nothing is left behind");
    assert.deepEqual(errors, []);
  }),
);

test("the program draws pictures of frames and a panel", { skip: program === undefined }, () =>
  within(async (folder, browser) => {
    execFileSync(program!, ["run", "s.toml", "-o", "run", "--quiet"], { cwd: folder });
    const options = ["--png", "--whole", "--size", "640x480", "--panel", "0 s, 24 s, 55 s", "--layer", "pressure", "-o", "out"];
    const said = spawnSync(program!, ["export", "run", ...options], { cwd: folder, encoding: "utf8" });
    assert.equal(said.stderr, "matrigrate: --panel: there is no frame at 55 s; the nearest is taken, at 1 min\n");
    const frames = [0, 1, 2, 3, 4, 5].flatMap((k) => [`frame_000${k}.png`, `frame_000${k}.svg`]);
    assert.deepEqual(readdirSync(join(folder, "out")), [...frames, "panel.svg"], "one for each frame, and nothing else");
    const { page, errors } = await opened(browser, join(folder, "run", "report.html"));
    const shown = await page.evaluate(async () => {
      await window.matrigrate!.ready;
      window.matrigrate!.show({ width: 640, height: 480, layer: "pressure", whole: true });
      return window.matrigrate!.frame(24).toDataURL("image/png");
    });
    const drawn = (ending: string, type: string) =>
      `data:image/${type};base64,${readFileSync(join(folder, `out/frame_0002.${ending}`)).toString("base64")}`;
    assert.ok((await difference(page, drawn("png", "png"), shown)) < 0.001);
    assert.ok((await difference(page, drawn("svg", "svg+xml"), shown)) < 0.01);
    const panel = readFileSync(join(folder, "out/panel.svg"), "utf8");
    for (const time of ["0 min", "24 s", "1 min"]) assert.ok(panel.includes(`>${time}</text>`), time);
    assert.deepEqual(errors, []);
  }),
);

test("a movie that is stopped leaves no process and no movie", { skip: program === undefined || !has("ffmpeg") }, () =>
  within(async (folder) => {
    execFileSync(program!, ["run", "s.toml", "-o", "run", "--quiet"], { cwd: folder });
    /** Processes that work in the folder of the movie; those that have ended show no command. */
    const working = () =>
      readdirSync("/proc").filter((id) => {
        try {
          return /^\d+$/.test(id) && readFileSync(`/proc/${id}/cmdline`, "utf8").includes(join(folder, "out/.drawing"));
        } catch {
          return false; // it has ended meanwhile
        }
      });
    for (const signal of ["SIGINT", "SIGTERM", "SIGKILL"] as const) {
      const made = spawn(program!, ["export", "run", "--movie", "--seconds", "3600", "-o", "out"], { cwd: folder });
      await until(async () => working().length > 3, "node, browser and ffmpeg work");
      made.kill(signal);
      await until(async () => working().length === 0, `nothing is left after ${signal}`);
      assert.equal(made.signalCode, signal);
    }
    assert.ok(!readdirSync(join(folder, "out")).includes("movie.mp4"));
    execFileSync(program!, ["export", "run", "--movie", "--seconds", "0.1", "-o", "out"], { cwd: folder });
    assert.deepEqual(readdirSync(join(folder, "out")), ["movie.mp4"], "what was left behind is gone");
    symlinkSync(folder, join(folder, "out/.drawing"));
    const refused = spawnSync(program!, ["export", "run", "--movie", "--force", "-o", "out"], { cwd: folder, encoding: "utf8" });
    assert.equal(refused.status, 5);
    assert.match(refused.stderr, /is a symbolic link/);
    assert.ok(readdirSync(folder).includes("run"), "what a link leads to stays");
  }),
);

test("a study of the program shows shapes and plays runs", { skip: program === undefined }, () =>
  within(async (folder, browser) => {
    execFileSync(program!, ["study", "run", "e.toml", "-o", "study", "--quiet"], { cwd: folder });
    const { page, errors } = await opened(browser, join(folder, "study", "report.html"));
    assert.equal(await page.locator("#shapes polygon").count(), 4);
    await page.locator("#players h2 >> nth=0").scrollIntoViewIfNeeded();
    await page.locator("#players .stage").waitFor();
    assert.ok((await coloursOf(page)) > 3, "a blank picture");
    assert.equal(await page.locator("#players select >> nth=0 >> option").count(), 2);
    assert.deepEqual(errors, []);
  }),
);
