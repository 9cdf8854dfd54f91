// The live page in Chromium, as a person has it: from a file, without a graphics card.
//   node page.mjs INDEX_HTML [--program PROGRAM] [--native RUN_FOLDER] [--watch SECONDS]
// PROGRAM checks what is exported; RUN_FOLDER is its run of the baseline with seed 1; --watch: how long speed, pictures and
// memory are measured.
import assert from "node:assert/strict";
import { execFileSync } from "node:child_process";
import { mkdtempSync, readdirSync, readFileSync, rmSync, statSync, writeFileSync } from "node:fs";
import { loadavg, tmpdir } from "node:os";
import { join, resolve } from "node:path";
import { chromium } from "playwright-core";

const [file, ...rest] = process.argv.slice(2);
const option = (name) => (rest.includes(name) ? rest[rest.indexOf(name) + 1] : undefined);
const watch = Number(option("--watch") ?? 40);
const address = `file://${resolve(file)}`;
const folder = mkdtempSync(join(tmpdir(), "matrigrate-live-"));
const patience = 300_000;
const errors = [];

const open = async (options = {}) => {
  const context = await chromium.launchPersistentContext(folder, {
    executablePath: process.env.CHROMIUM ?? "/usr/bin/chromium",
    args: ["--no-sandbox", "--disable-gpu", "--disable-3d-apis", "--disable-background-networking", "--disable-component-update", "--disable-sync", "--no-first-run", "--disable-features=OptimizationHints,MediaRouter"],
    viewport: { width: 1280, height: 900 },
    acceptDownloads: true,
    ...options,
  });
  context.setDefaultTimeout(patience);
  return context;
};
const visit = async (context, at = address) => {
  const page = await context.newPage();
  page.on("console", (m) => m.type() === "error" && errors.push(m.text()));
  page.on("pageerror", (e) => errors.push(String(e)));
  page.on("request", (r) => !/^(data|blob|file):/.test(r.url()) && errors.push(`asked for ${r.url()}`));
  await page.goto(at);
  await page.waitForSelector("html[data-ready=true]");
  return page;
};
const state = (page) => page.evaluate(() => window.matrigrateLive.state());
const until = async (page, holds, what, most = patience) => {
  for (const end = Date.now() + most; Date.now() < end; await new Promise((later) => setTimeout(later, 100)))
    if (holds(await state(page))) return;
  throw new Error(`not within ${most} ms: ${what}`);
};
const playTo = async (page, t) => {
  await page.evaluate((to) => window.matrigrateLive.play(to), t);
  await until(page, (s) => !s.playing && s.t_s >= t - 1e-6, `${t} s`);
};

/** Resident memory of the browser and of the processes that it has started, by kind [MB]. */
function memory() {
  const all = readdirSync("/proc").filter((name) => /^\d+$/.test(name));
  const of = new Map();
  for (const pid of all)
    try {
      const stat = readFileSync(`/proc/${pid}/stat`, "utf8");
      of.set(pid, { parent: stat.slice(stat.lastIndexOf(")") + 2).split(" ")[1], command: readFileSync(`/proc/${pid}/cmdline`, "utf8") });
    } catch {
      // it has ended meanwhile
    }
  const root = [...of].find(([, { command }]) => command.includes(`--user-data-dir=${folder}`) && !command.includes("--type="))?.[0];
  const belongs = (pid) => pid === root || (of.has(pid) && of.get(pid).parent !== "0" && belongs(of.get(pid).parent));
  const kinds = {};
  for (const [pid, { command }] of of)
    if (belongs(pid))
      try {
        const kind = /--type=([a-z-]+)/.exec(command)?.[1] ?? "browser";
        const mb = Number(/Pss:\s+(\d+)/.exec(readFileSync(`/proc/${pid}/smaps_rollup`, "utf8"))?.[1] ?? 0) / 1024;
        kinds[kind] = (kinds[kind] ?? 0) + mb;
      } catch {
        // not ours to read, or ended
      }
  return { kinds, mb: Object.values(kinds).reduce((a, b) => a + b, 0) };
}
const median = (values) => [...values].sort((a, b) => a - b)[Math.floor(values.length / 2)];

console.log(`page of ${(statSync(file).size / 1e6).toFixed(1)} MB; load of the machine ${loadavg()[0].toFixed(1)}`);
assert.ok(statSync(file).size < 5e6, "the page is too large");
let context = await open();
let page = await visit(context);

// Speed, pictures a second, memory.
await page.locator("button[name=reset]").click();
await until(page, (s) => s.t_s === 0 && !s.playing, "a new start");
await page.locator("button[name=play]").click();
await until(page, (s) => s.t_s > 60, "it runs");
const seen = [];
const measure = async () => ({ ...(await state(page)), at: performance.now(), ...memory() });
seen.push(await measure());
/** Model time before the last new start [s]. */
let [from, covered] = [seen[0], 0];
let last = seen[0];
while (performance.now() - seen[0].at < 1000 * watch) {
  await new Promise((later) => setTimeout(later, Math.min(10_000, 250 * watch)));
  const now = await measure();
  const before = last;
  const wall = (now.at - before.at) / 1000;
  console.log(`t = ${(now.t_s / 3600).toFixed(2)} h: ${((now.t_s - before.t_s) / wall).toFixed(0)} times faster than life, ${((now.painted - before.painted) / wall).toFixed(1)} pictures a second, ${now.mb.toFixed(0)} MB (page ${now.kinds.renderer?.toFixed(0)}, drawing ${now.kinds["gpu-process"]?.toFixed(0)}, browser ${now.kinds.browser?.toFixed(0)}), ${now.frames} moments kept; load ${loadavg()[0].toFixed(1)}`);
  seen.push(now);
  last = now;
  if (!now.playing && performance.now() - seen[0].at < 1000 * watch) {
    // Six hours are done, or the cell has come to the rim.
    const fault = page.locator(".fault");
    if ((await fault.count()) > 0) {
      console.log(`it stands still: ${await fault.first().textContent()}`);
      await page.locator("button[name=reset]").click();
      await until(page, (s) => s.t_s === 0, "a new start");
      await page.locator("button[name=play]").click();
    } else await page.locator("button[name=more]").click();
    covered += now.t_s - from.t_s;
    await until(page, (s) => s.playing, "it goes on");
    from = await measure();
    last = from;
  }
}
const first = seen[0];
const wall = (last.at - first.at) / 1000;
const speed = (covered + last.t_s - from.t_s) / wall;
console.log(`in all: ${speed.toFixed(0)} times faster than life, ${((last.painted - first.painted) / wall).toFixed(1)} pictures a second, memory ${first.mb.toFixed(0)} to ${last.mb.toFixed(0)} MB, at most ${Math.max(...seen.map(({ mb }) => mb)).toFixed(0)} MB`);
const failed = [];
if (watch >= 600) {
  const third = Math.floor(seen.length / 3);
  const [early, late] = [seen.slice(0, third), seen.slice(-third)].map((some) => median(some.map(({ mb }) => mb)));
  console.log(`memory, median of the first third ${early.toFixed(0)} MB, of the last third ${late.toFixed(0)} MB`);
  if (late > 1.1 * early) failed.push("memory grows");
}
if (speed < 60) failed.push("slower than 60 times life");
if ((last.painted - first.painted) / wall < 20) failed.push("fewer than 20 pictures a second");

// The first protrusion.
if (last.t_s < 900) await playTo(page, 900);
const length = await page.evaluate(() => window.matrigrateLive.protrusions[0].length_um);
const native = option("--native");
if (native) {
  const [head, row] = readFileSync(join(native, "protrusions.csv"), "utf8").split("\n").map((line) => line.split(","));
  const theirs = Number(row[head.indexOf("length_um")]);
  console.log(`first protrusion: ${length} um here, ${theirs} um natively`);
  assert.ok(Math.abs(length - theirs) < 0.1, "the first protrusions differ");
}

// A step, a slider on the way, an export; from the start, since six hours may be over by now.
await page.locator("button[name=reset]").click();
await until(page, (s) => s.t_s === 0, "a new start");
await playTo(page, 60);
await page.evaluate(() => window.matrigrateLive.clock.playing && window.matrigrateLive.clock.toggle());
await until(page, (s) => !s.playing, "it pauses");
await page.waitForTimeout(500);
const paused = await state(page);
await page.locator("button[name=step]").click();
await until(page, (s) => s.t_s > paused.t_s && s.t_s <= paused.t_s + 5, "a step");
await page.locator('input[name="ecm.youngs_modulus"]').fill("120");
await until(page, (s) => s.scenario.changes.length > 0, "the stiffness changes");
const change = (await state(page)).scenario.changes.at(-1);
assert.ok(change.t % 5 === 0 && /^ecm\.youngs_modulus=/.test(change.overrides[0]), JSON.stringify(change));

// Every slider and the fibres act on the way, and the simulation goes on with them.
const changed = (s, path) => s.scenario.changes.some(({ overrides }) => overrides.some((one) => one.startsWith(`${path}=`)));
const paths = await page.locator(".slider input[type=range]").evaluateAll((all) => all.map((e) => e.name));
assert.equal(paths.length, 6);
for (const path of paths) {
  const { length } = (await state(page)).scenario.changes;
  await page.locator(`input[name="${path}"]`).press("PageUp"); // by a tenth; no number typed need be one of its steps
  await until(page, (s) => s.scenario.changes.length > length && changed(s, path), `${path} changes`);
}
await page.locator('select[name="fibres.arrangement"]').selectOption("isotropic");
await until(page, (s) => changed(s, "fibres.arrangement"), "fibres come");
const before = await state(page);
await page.locator("button[name=step]").click();
await until(page, (s) => s.t_s > before.t_s, "a step with all of them");
assert.equal(await page.locator(".fault").count(), 0);
console.log(`changed on the way: ${paths.join(", ")}, fibres.arrangement`);

// A new start leaves nothing of the one before behind.
const session = await context.newCDPSession(page);
await session.send("HeapProfiler.enable");
await session.send("Performance.enable");
const nodes = async () => {
  await session.send("HeapProfiler.collectGarbage");
  return (await session.send("Performance.getMetrics")).metrics.find(({ name }) => name === "Nodes").value;
};
const beginAnew = async () => {
  await page.locator("button[name=reset]").click();
  await until(page, (s) => s.t_s === 0 && s.frames > 0, "a new start");
  await playTo(page, 20);
};
await beginAnew();
const few = await nodes();
for (let k = 0; k < 6; ++k) await beginAnew();
const many = await nodes();
console.log(`nodes of the page: ${few}, after six new starts ${many}`);
assert.ok(many < 1.3 * few, "what was before is kept");
await playTo(page, 65);

// A wrong scenario, in words; the one before stays.
await page.locator(".own summary").click();
await page.locator("textarea[name=toml]").fill('[ecm]\nyoungs_module = "100 Pa"\nviscosity = "-1 Pa s"\n');
await page.locator(".own button").click();
await page.waitForSelector(".fault");
const words = await page.locator(".fault").first().textContent();
console.log(`a wrong scenario: ${words}`);
assert.match(words, /line 2.*youngs_module.*did you mean ecm\.youngs_modulus.*line 3.*out of range/s);
assert.equal((await state(page)).t_s > 60, true);
await page.locator(".fault button").click();

// A law: a wrong formula is told and stays to be mended, another one acts from now on, and an empty one is the paper's.
await page.locator(".formulas summary").click();
const law = page.locator("input[name='laws.curvature_factor']");
const enter = async (formula) => {
  await law.fill(formula);
  await law.press("Enter");
};
const paper = await law.inputValue();
await enter("exp(-kapa^2)");
await page.waitForSelector(".fault");
assert.match(await page.locator(".fault").first().textContent(), /kapa.*kappa/s);
assert.deepEqual([await law.inputValue(), await law.getAttribute("aria-invalid")], ["exp(-kapa^2)", "true"]);
for (const formula of ["exp(-(kappa/kappa_w)^2)", ""]) {
  const changes = (await state(page)).scenario.changes.length;
  await enter(formula);
  await until(page, (s) => s.scenario.changes.length > changes, "a law that acts");
  assert.deepEqual([await law.inputValue(), await law.getAttribute("aria-invalid"), await page.locator(".fault").count()], [formula || paper, "false", 0]);
}

// Constants of one's own: a formula names them, with their units.
const constants = page.locator("input[name='laws.constants']");
for (const [input, text] of [[constants, "kappa_c = 0.3 1/um"], [law, "exp(-(kappa/kappa_c)^2)"]]) {
  const changes = (await state(page)).scenario.changes.length;
  await input.fill(text);
  await input.press("Enter");
  await until(page, (s) => s.scenario.changes.length > changes, "a constant that acts");
  assert.deepEqual([await input.inputValue(), await page.locator(".fault").count()], [text, 0]);
}
await constants.fill("kappa_c = 0.3 parsec");
await constants.press("Enter");
await page.waitForSelector(".fault");
assert.match(await page.locator(".fault").first().textContent(), /kappa_c.*parsec/s);
await page.locator(".fault button").click();

// What was saved is there again after the browser was closed.
/** What must be the same after it; sums of positions and pressure of all moments of the film. */
const standing = () => {
  const { film, tracks, protrusions } = window.matrigrateLive;
  const sums = [film.film.x, film.film.pressure].map(({ q, stride }) => q.subarray(0, film.film.times.length * stride).reduce((a, b, k) => a + (k % 97) * b, 0));
  return { ...window.matrigrateLive.state(), rows: tracks.t_s.length, n: protrusions.length, sums: sums.join() };
};
await page.locator("button[name=save]").click();
await page.waitForSelector("text=Saved in this browser");
const saved = await page.evaluate(standing);
await context.close();
context = await open();
page = await visit(context);
await until(page, (s) => s.frames > 0, "it is taken up");
const again = await page.evaluate(standing);
for (const key of ["t_s", "rows", "n", "frames", "sums"]) assert.equal(again[key], saved[key], `${key} after reopening`);
assert.deepEqual(again.scenario, saved.scenario);
await playTo(page, saved.t_s + 20);
console.log(`closed and opened again: ${saved.t_s} s, ${saved.rows} rows, ${saved.n} protrusions, ${saved.frames} moments are there, and it goes on`);

// Drawing: a hole and a soft spot begin anew; the link carries them; the program takes the export.
await page.locator("button[name=reset]").click();
await until(page, (s) => s.t_s === 0, "a new start");
const box = await page.locator(".stage").boundingBox();
for (const [kind, dx] of [["hole", 250], ["soft", -250]]) {
  const before = (await state(page)).scenario.strokes.length;
  await page.locator(`input[name=brush][value=${kind}]`).check();
  await page.mouse.move(box.x + box.width / 2 + dx, box.y + box.height / 2);
  await page.mouse.down();
  await page.mouse.move(box.x + box.width / 2 + dx, box.y + box.height / 2 + 120, { steps: 8 });
  await page.mouse.up();
  await until(page, (s) => s.scenario.strokes.length === before + 1 && s.frames > 0, "a stroke");
}
await page.locator("input[name=brush][value=look]").check();
await playTo(page, 40);
// What was drawn is a layer, with values; a change on the way keeps what is looked at.
const stiffness = async () => {
  await page.locator(".stage").scrollIntoViewIfNeeded(); // a choice beside it may have moved it
  const { x, y, width, height } = await page.locator(".stage").boundingBox();
  await page.mouse.move(x + width / 2 - 250, y + height / 2 + 60);
  const text = await page.locator(".probe").textContent();
  assert.match(text, /^Young's modulus \S+ Pa at/);
  return Number(/modulus (\S+) Pa/.exec(text)[1]);
};
await page.locator("input[name=layer][value=youngs_modulus]").check();
const drawn = await stiffness();
console.log(`Young's modulus where it was drawn soft: ${drawn} Pa`);
assert.ok(drawn < 150, "the soft spot is not soft");
await page.screenshot({ path: join(folder, "drawn.png") });
const [picture] = await Promise.all([page.waitForEvent("download"), page.getByRole("button", { name: "Save PNG" }).click()]);
assert.match(picture.suggestedFilename(), /^Matrigrate-live-youngs_modulus-.*\.png$/);
assert.deepEqual([...readFileSync(await picture.path()).subarray(1, 4)], [...Buffer.from("PNG")]);
const downloads = [];
page.on("download", (d) => downloads.push(d));
await page.locator("button[name=export]").click();
for (let k = 0; k < 100 && downloads.length < 3; ++k) await page.waitForTimeout(100);
const to = mkdtempSync(join(tmpdir(), "matrigrate-export-"));
for (const d of downloads) await d.saveAs(join(to, d.suggestedFilename()));
assert.deepEqual(readdirSync(to).sort(), ["f_degr.csv", "scenario.toml", "youngs_modulus.csv"]);
const program = option("--program");
if (program) {
  console.log(execFileSync(program, ["check", join(to, "scenario.toml")], { encoding: "utf8" }).trim());
  execFileSync(program, ["run", join(to, "scenario.toml"), "-o", join(to, "run"), "--hours", "0.0125", "--set", "output.report=false", "--set", "output.track_interval=40 s"]);
  const [head, ...rows] = readFileSync(join(to, "run", "tracks.csv"), "utf8").trim().split("\n").map((line) => line.split(","));
  const row = rows.find((r) => Number(r[head.indexOf("t_s")]) === 40);
  const outline = await page.evaluate(() => {
    const { film } = window.matrigrateLive.film;
    const [f, n] = [film.times.length - 1, film.outlinePoints];
    let [area, x] = [0, []];
    for (let i = 0; i < 2 * n; ++i) x.push(film.outline.x.scale * film.outline.x.q[f * 2 * n + i]);
    for (let i = 0; i < n; ++i) area += 0.5 * (x[2 * i] * x[2 * ((i + 1) % n) + 1] - x[2 * ((i + 1) % n)] * x[2 * i + 1]);
    return area;
  });
  console.log(`drawn hole and soft spot, cell's area at 40 s: ${outline.toFixed(3)} um^2 here, ${Number(row[head.indexOf("area_um2")]).toFixed(3)} um^2 natively`);
  assert.ok(Math.abs(outline - Number(row[head.indexOf("area_um2")])) < 0.5);
}
// Ligand and attractant are drawn, are layers, and the cell senses them; a film is recorded meanwhile.
const draw = [["attractant", 8, 50, 0], ["bare", 8, -30, -30, -30, 30], ["rich", 8, 0, 35, 30, 45]];
const hash = (scenario) => `#scenario=${Buffer.from(JSON.stringify({ v: 1, set: { "run.integrator": "adaptive", "run.seed": "1" }, ...scenario })).toString("base64url")}`;
const drawnCues = await visit(context, `${address}?cues${hash({ draw })}`);
await until(drawnCues, (s) => s.playing && s.frames > 0, "it plays");
const record = drawnCues.getByRole("button", { name: "Record WebM" });
if ((await record.count()) > 0) {
  await record.click();
  await drawnCues.waitForTimeout(3000);
  const [film] = await Promise.all([drawnCues.waitForEvent("download"), drawnCues.getByRole("button", { name: "Stop recording" }).click()]);
  const bytes = readFileSync(await film.path());
  assert.equal(bytes.subarray(0, 4).toString("hex"), "1a45dfa3", "not Matroska");
  assert.ok(bytes.length > 10_000 && (await state(drawnCues)).playing);
  console.log(`recorded ${film.suggestedFilename()}, ${bytes.length} bytes, and it goes on`);
}
for (const layer of ["attractant", "ligand"]) await drawnCues.locator(`input[name=layer][value=${layer}]`).check();
const known = await drawnCues.evaluate(() => {
  const { film } = window.matrigrateLive.film;
  const range = ({ q, scale, offset }) => [offset + scale * q.reduce((a, b) => Math.min(a, b)), offset + scale * q.reduce((a, b) => Math.max(a, b))];
  return { attractant: range(film.attractant), ligand: range(film.layers.find(({ name }) => name === "ligand").field) };
});
assert.ok(known.attractant[1] > 0.2 && known.attractant[0] >= 0, JSON.stringify(known));
assert.deepEqual(known.ligand.map(Math.round), [0, 2]);

// A question of the lesson begins by its link.
await drawnCues.locator(".lesson summary").click();
await drawnCues.locator(".lesson a").nth(1).click();
await until(drawnCues, (s) => s.scenario.settings["protrusion.number"] === "1" && s.scenario.strokes.length === 0, "the second question");
await drawnCues.close();

const link = await page.evaluate(() => location.href);
const copy = await visit(context, link.replace("index.html", "index.html?copy"));
assert.deepEqual((await state(copy)).scenario.strokes, (await state(page)).scenario.strokes);
await copy.goto("about:blank");
const broken = await visit(context, `${address}?broken#scenario=AAAA`);
assert.match(await broken.locator(".fault").textContent(), /address holds a scenario that cannot be read/);
await broken.close();

// Two cells with nuclei: each is drawn in its colours, with its nucleus; a single cell without has neither of these.
const pixels = (colour) =>
  page.evaluate(async (wanted) => {
    await new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(done)));
    const canvas = document.querySelector(".stage canvas.cell");
    const { data } = canvas.getContext("2d").getImageData(0, 0, canvas.width, canvas.height);
    const [r, g, b] = [1, 3, 5].map((k) => parseInt(wanted.slice(k, k + 2), 16));
    let count = 0;
    for (let i = 0; i < data.length; i += 4) if (data[i] === r && data[i + 1] === g && data[i + 2] === b) ++count;
    return count;
  }, colour);
const [nucleus, ...ofTwo] = ["#27406b", "#0072b2", "#73b9e2", "#1b7837", "#7fc78d"];
await page.bringToFront();
assert.equal(await pixels(nucleus), 0);
const cells = "[nucleus]\nradius = '5 um'\n[[cells]]\nx = '-25 um'\ny = 0\n[[cells]]\nx = '25 um'\ny = 0\n[protrusion]\ninitiation_rate = '0.003 1/s'\n";
await page.locator(".own summary").click();
await page.locator("textarea[name=toml]").fill(cells);
await page.locator(".own button").click();
await until(page, (s) => s.scenario.toml.includes("[[cells]]") && s.frames > 0, "two cells");
await playTo(page, 600);
for (const colour of [nucleus, ...ofTwo]) assert.ok((await pixels(colour)) > 100, `nothing has the colour ${colour}`);
const signs = await page.locator(".panel .signs").textContent();
assert.match(signs, /cell 1 \(rear, front\)cell 2nucleus/);
assert.equal(await page.locator("#path .plot").first().locator(".curve").count(), 2);
console.log("two cells with nuclei are drawn, each in its colours");
await context.close();

// A processor without SIMD: the page says so.
const bare = await open({ args: ["--no-sandbox", "--disable-gpu", "--no-first-run", "--js-flags=--no-enable-sse4-1 --no-enable-ssse3"] });
const without = await bare.newPage();
await without.goto(address);
assert.match(await without.locator(".fault").textContent(), /no WebAssembly SIMD/);
await bare.close();

// A phone, light and dark.
for (const colorScheme of ["light", "dark"]) {
  const phone = await open({ viewport: { width: 390, height: 844 }, isMobile: true, hasTouch: true, colorScheme, reducedMotion: "reduce" });
  const small = await visit(phone);
  await small.evaluate(() => window.matrigrateLive.play());
  await until(small, (s) => s.rate > 0 && s.t_s > 60, "it runs");
  assert.deepEqual(await small.evaluate(() => [document.documentElement.scrollWidth, window.innerWidth]), [390, 390], "scrolls sideways");
  if (process.env.SHOTS) await small.screenshot({ path: join(process.env.SHOTS, `phone-${colorScheme}.png`) });
  await phone.close();
}
if (process.env.SHOTS) writeFileSync(join(process.env.SHOTS, "drawn.png"), readFileSync(join(folder, "drawn.png")));
assert.deepEqual(errors, []);
rmSync(folder, { recursive: true, force: true });
rmSync(to, { recursive: true, force: true });
if (failed.length > 0) {
  console.log(`NOT MET: ${failed.join("; ")}`);
  process.exit(1);
}
console.log("all is well");
