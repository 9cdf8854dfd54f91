/** The page of a run in a browser: it opens, plays, obeys, and says plainly what it lacks. */
import assert from "node:assert/strict";
import { after, before, test } from "node:test";
import type { Browser, Page } from "playwright-core";
import type { RunPage } from "../src/contract";
import { sampleRun } from "../sample/run";
import { launch, open, settled, shot, still, until } from "./browser";

/** A short run in a small disc for what does not depend on size. */
const small = sampleRun({ radius: 90, interval: 600, end: 7200 });
/** As large as a run of the paper. */
const large = sampleRun({ noise: 0.03 });
const json = (run: unknown): string => JSON.stringify(run);

const time = (page: Page) => page.locator(".stage .time").textContent();

let browser: Browser;
before(async () => {
  browser = await launch();
});
after(async () => {
  await browser.close();
});

test("a full run opens without an error or a request", async () => {
  assert.equal(large.geometry.n_particles, 17665);
  assert.equal(large.frames?.times_s.length, 73);
  const text = json(large);
  const opened = await open(browser, "run", text);
  console.log(
    `# ${large.geometry.n_particles} particles x 73 frames, ${(text.length / 1e6).toFixed(1)} MB, open in ${Math.round(opened.took)} ms`,
  );
  assert.deepEqual(opened.errors, []);
  assert.deepEqual(opened.requests, []);
  await opened.page.context().close();
});

test("layers change the picture", async () => {
  const { page, errors } = await open(browser, "run", json(small));
  await page.locator(".scrub").fill("3900");
  const seen = new Set<string>();
  for (const layer of ["degradation", "displacement", "pressure", "von_mises", "fibre_von_mises"]) {
    await page.locator(`input[value=${layer}]`).check();
    seen.add(await still(page));
  }
  assert.equal(seen.size, 5);
  assert.ok(await page.locator(".panel").getByText("Fibre von Mises stress (Pa)").isVisible());
  for (const overlay of ["traction", "cell", "protrusions", "adhesions", "path", "polarization", "arrows"]) {
    await page.locator(`input[name=${overlay}]`).click();
    const now = await still(page);
    assert.ok(!seen.has(now), `${overlay} changes nothing`);
    seen.add(now);
  }
  await page.locator("input[name=cell]").check();
  for (const edge of ["f_mat", "force"]) {
    await page.locator("select[name=edge]").selectOption(edge);
    const now = await still(page);
    assert.ok(!seen.has(now), `the edge by ${edge} changes nothing`);
    seen.add(now);
  }
  assert.deepEqual(errors, []);
  await page.context().close();
});

test("plays, pauses, scrubs and steps", async () => {
  const { page, errors } = await open(browser, "run", json(small));
  assert.equal(await time(page), "2 h 00 min", "who wants stillness sees the end");
  const last = await still(page);
  await page.keyboard.press(" ");
  await until(async () => (await shot(page)) !== last, "it moves");
  await page.locator(".scrub").fill("0");
  await page.keyboard.press(" ");
  await until(async () => (await time(page)) !== "0 min", "it plays");
  await page.keyboard.press(" ");
  await settled(page);
  const paused = await still(page);
  await page.waitForTimeout(200);
  assert.ok((await still(page)) === paused, "does not pause");
  await page.locator(".scrub").fill("600");
  assert.equal(await time(page), "10 min");
  await page.keyboard.press("ArrowRight");
  assert.equal(await time(page), "20 min");
  await page.keyboard.press("ArrowLeft");
  await page.keyboard.press("ArrowLeft");
  assert.equal(await time(page), "0 min");
  await page.locator(".scrub").fill("7200");
  assert.equal(await time(page), "2 h 00 min");
  assert.match((await page.locator(".times").textContent()) ?? "", /^2 h 00 min of 2 h 00 min$/);
  assert.deepEqual(errors, []);
  await page.context().close();
});

test("zooms, pans, follows and comes back", async () => {
  const { page } = await open(browser, "run", json(small));
  const home = await still(page);
  const view = () => page.locator(".stage").getAttribute("data-view");
  const homeView = await view();
  await page.locator(".stage").hover();
  await page.mouse.wheel(0, -400);
  const near = await still(page);
  assert.ok(near !== home, "the wheel does nothing");
  await page.mouse.down();
  await page.mouse.move(300, 300, { steps: 3 });
  await page.mouse.up();
  assert.ok((await still(page)) !== near, "dragging does nothing");
  await page.mouse.move(10, 10);
  await page.keyboard.press("f");
  assert.ok(await page.locator("input[name=follow]").isChecked());
  await page.keyboard.press("0");
  assert.ok(!(await page.locator("input[name=follow]").isChecked()));
  assert.equal(await view(), homeView);
  await page.context().close();
});

test("a click into a plot, the timeline or the path moves the time", async () => {
  const { page } = await open(browser, "run", json(small));
  for (const plot of ["#protrusions .plot", "#path .plot >> nth=1", "#path .plot >> nth=0"]) {
    await page.locator(".scrub").fill("7200");
    const box = await page.locator(plot).boundingBox();
    await page.locator(plot).click({ position: { x: 0.35 * (box?.width ?? 0), y: 60 } });
    assert.notEqual(await time(page), "2 h 00 min", plot);
  }
  await page.context().close();
});

test("plays by itself, once, unless stillness is wanted", async () => {
  const { page } = await open(browser, "run", json(sampleRun({ radius: 60, end: 2400 })), {
    reducedMotion: "no-preference",
  });
  await until(async () => (await time(page)) === "40 min", "it plays to its end");
  await until(async () => (await page.locator(".play").getAttribute("aria-label")) === "Play", "it stops there");
  await page.context().close();
});

test("says at the top what was run and what came out, and has a title of its own", async () => {
  const { page } = await open(browser, "run", json(small));
  assert.equal(await page.title(), small.title);
  const top = (await page.locator("header").textContent()) ?? "";
  for (const part of ["E = 100 Pa", "9.87 \u00b5m/h", "persistent", "--set 'ecm.radius=150 um'", "0123456789abcdef"])
    assert.ok(top.includes(part), part);
  await page.context().close();
});

test("plots fit the paper when it is printed", async () => {
  const { page, errors } = await open(browser, "run", json(small), { colorScheme: "dark" });
  const widths = await page.evaluate(() => {
    const all = () => [...document.querySelectorAll(".plot")].map((plot) => plot.clientWidth);
    const before = all();
    dispatchEvent(new Event("beforeprint"));
    return { before, printed: all(), signs: document.querySelector(".panel .signs")!.innerHTML };
  });
  assert.ok(widths.signs.includes("#8b1a6b") && !widths.signs.includes("#d469b8"), "signs have the colours of a dark page");
  assert.equal(widths.printed.length, widths.before.length);
  assert.ok(Math.max(...widths.before) > 1000);
  assert.ok(Math.max(...widths.printed) <= 700, `${widths.printed}`);
  assert.deepEqual(errors, []);
  await page.context().close();
});

test("names of rows are not cut off where there are few", async () => {
  const { page } = await open(browser, "run", json({ ...small, protrusions: small.protrusions.slice(0, 1) }));
  const cut = await page.evaluate(() => {
    const plot = document.querySelector("#protrusions .plot")!.getBoundingClientRect();
    return [...document.querySelectorAll("#protrusions .plot text")]
      .map((text) => text.getBoundingClientRect())
      .filter((b) => b.left < plot.left || b.top < plot.top || b.bottom > plot.bottom || b.right > plot.right).length;
  });
  assert.equal(cut, 0);
  await page.context().close();
});

test("fits a phone, light and dark", async () => {
  for (const colorScheme of ["light", "dark"] as const) {
    const { page, errors } = await open(browser, "run", json(small), {
      viewport: { width: 390, height: 844 },
      colorScheme,
    });
    assert.ok(await page.evaluate(() => document.documentElement.scrollWidth <= window.innerWidth), "scrolls sideways");
    assert.deepEqual(errors, []);
    await page.context().close();
  }
});

test("without frames the tables are still there", async () => {
  const { page, errors } = await open(browser, "run", json({ ...small, frames: null }));
  assert.ok(await page.getByText("This run stored no frames").isVisible());
  assert.equal(await page.locator(".stage").count(), 0);
  assert.ok(await page.getByText("speed, start to end (\u00b5m/h)").isVisible());
  assert.ok((await page.locator("#path svg").count()) >= 3);
  assert.deepEqual(errors, []);
  await page.context().close();
});

test("a run that ended at once shows what it has", async () => {
  const empty: RunPage = {
    ...small,
    frames: undefined,
    protrusions: [],
    parameters: [],
    tracks: {
      t_s: [0],
      x_um: [0],
      y_um: [0],
      area_um2: [707],
      perimeter_um: [94],
      polarization_rad: [null],
      n_simultaneous: [0],
    },
  };
  const { page, errors } = await open(browser, "run", json(empty));
  assert.ok(await page.getByText("The run is too short for a path.").isVisible());
  assert.ok(await page.getByText("No protrusion was initiated.").isVisible());
  assert.deepEqual(errors, []);
  await page.context().close();
});

for (const [what, given, words] of [
  ["an empty template", null, "empty template"],
  ["no JSON", '{ "format": ', "not valid JSON"],
  ["another format", json({ format: "matrigrate-study", version: 1 }), "'matrigrate-run'"],
  ["a newer version", json({ ...small, version: 2 }), "version 2"],
  ["missing tables", json({ ...small, readouts: undefined, health: undefined }), "lacks: readouts, health"],
] as const)
  test(`says plainly: ${what}`, async () => {
    const { page } = await open(browser, "run", given);
    assert.match((await page.locator("[role=alert]").textContent()) ?? "", new RegExp(words));
    await page.context().close();
  });

test("changed laws are drawn beside those of the paper, and changes of parameters marked on the axes of time", async () => {
  const at = (t_s: number, text: string) => ({ t_s, text });
  const changes = [at(0.5 * small.t_end_s, "at 1 h: a.b 1 -> 2 nN"), at(0.5 * small.t_end_s, "at 1 h: c.d 3 -> 4"), at(0.75 * small.t_end_s, "at 2 h: a.b 2 -> 1 nN")];
  const curve = { over: "F", unit: "nN", at: "f_mat = 0.5", x: [0, 0.5, 1], changed: [0.002, null, 0.001], usual: [0.001, 0.001, 0.001] };
  const law = { name: "laws.disassembly_rate", text: "r_c*exp(-F^2)", unit: "1/s", curves: [curve] };
  const { page, errors } = await open(browser, "run", json({ ...small, laws: [law], changes }));
  const figure = page.locator("#laws figure");
  assert.equal(await figure.locator("figcaption").textContent(), "Over F, at f_mat = 0.5. The dashed curve is the default law.");
  assert.equal(await page.locator("#laws h3").textContent(), "Disassembly rate: r_c*exp(-F^2)");
  assert.ok(await figure.getByText("disassembly rate (10\u207b\u00b3/s)").isVisible());
  assert.ok(await figure.getByText("F (nN)").isVisible());
  const drawn = await figure.locator(".curve").evaluateAll((all) => all.map((one) => one.getAttribute("d") ?? ""));
  assert.deepEqual(drawn.map((d) => d.replace(/[^ML]/g, "")), ["MLL", "MM"]);
  for (const where of ["#path figure:has(.change) >> nth=0", "#path figure:has(.change) >> nth=1", "#protrusions figure"]) {
    const marks = page.locator(where).locator(".change");
    assert.deepEqual(await marks.locator("title").allTextContents(), ["at 1 h: a.b 1 -> 2 nN\nat 1 h: c.d 3 -> 4", "at 2 h: a.b 2 -> 1 nN"]);
    assert.deepEqual(await marks.locator("text").allTextContents(), ["a", "b"]);
  }
  const x = await page.locator("#protrusions .change path").evaluateAll((all) => all.map((one) => Number(/M([\d.]+)/.exec(one.getAttribute("d") ?? "")?.[1])));
  const [low, high] = [60, Number(await page.locator("#protrusions svg").getAttribute("width")) - 14];
  assert.ok(Math.abs(x[0] - 0.5 * (low + high)) < 0.1 && Math.abs(x[1] - (low + 0.75 * (high - low))) < 0.1, String(x));
  assert.match((await page.locator("#path").textContent()) ?? "", /Lines mark changes of parameters: a, at 1 h: a\.b 1 -> 2 nN, at 1 h: c\.d 3 -> 4; b, at 2 h: a\.b 2 -> 1 nN\./);
  assert.deepEqual(errors, []);
  await page.context().close();
});

test("frames that are broken are named, and the tables stay", async () => {
  const broken = structuredClone(small);
  if (broken.frames) broken.frames.particles.x.per_frame += 1;
  const { page } = await open(browser, "run", json(broken));
  assert.match((await page.locator("[role=alert]").textContent()) ?? "", /particle positions: has \d+ bytes/);
  assert.ok(await page.getByText("speed, start to end (\u00b5m/h)").isVisible());
  await page.context().close();
});

test("laws stand in their own section, as they can be copied, and rates by their logarithm", async () => {
  const run = sampleRun({ radius: 90, interval: 600, end: 3600 });
  const formula = "r_off_min + r_c*exp(-F/F_c) + r_s*exp(min(20, F/F_s)^2)" + " + 0*exp(-zeta_diss*F/f_mat)".repeat(12);
  run.laws = [{
    name: "laws.disassembly_rate", text: formula, unit: "1/s",
    curves: [{ over: "F", unit: "nN", at: "f_mat = 0.5", x: [0, 1, 2], changed: [1e-1, 1e-3, 1e-5], usual: [1e-2, 1e-3, null] }],
  }];
  const field = "100 + x^2" + "+0*exp(-x)".repeat(60);
  run.parameters = [
    { name: "laws.disassembly_rate", value: formula, default: "r_off_min", meaning: "Rate" },
    { name: "ecm.fields.youngs_modulus", value: field, default: "", meaning: "Young's modulus of the matrix where it is not the same everywhere" },
    { name: "ecm.viscosity", value: "0.2 nN s/um^2", default: "1 Pa s", meaning: "Viscosity" },
  ];
  for (const width of [1280, 390]) {
    const { page, errors } = await open(browser, "run", JSON.stringify(run), { viewport: { width, height: 900 } });
    await page.waitForSelector("html[data-ready=true]");
    const rows = await page.locator("#parameters tbody tr").allTextContents();
    assert.equal(rows.length, 2);
    assert.ok(rows[0].includes(field), "as it can be copied");
    assert.ok(rows[1].includes("0.2 nN s/\u00b5m\u00b2"));
    assert.ok((await page.locator("#laws h3").textContent())?.includes(formula));
    const box = (await page.locator("#parameters table").boundingBox())!;
    assert.ok(box.height < 1200, `${box.height} pixels at ${width}`);
    assert.ok((await page.evaluate(() => document.documentElement.scrollWidth)) <= width + 1);
    const beyond = await page.locator("#parameters .table").evaluate((one) => one.scrollWidth - one.clientWidth);
    assert.ok(width < 640 || beyond <= 1, `${beyond} pixels of the table are not seen`);
    const ticks = await page.locator("#laws svg.plot text").allTextContents();
    assert.ok(["10\u207b\u2075", "10\u207b\u00b3", "10\u207b\u00b9"].every((one) => ticks.includes(one)) || ["10\u207b\u2074", "10\u207b\u00b2"].every((one) => ticks.includes(one)), ticks.join());
    assert.deepEqual(errors, []);
    await page.context().close();
  }
});
