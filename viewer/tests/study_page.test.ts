/** The page of a study in a browser: every plot is drawn, and the choices work. */
import assert from "node:assert/strict";
import { after, before, test } from "node:test";
import type { Browser } from "playwright-core";
import { sampleStudy } from "../sample/study";
import { allDrawn, launch, open, settled, until } from "./browser";

let browser: Browser;
before(async () => {
  browser = await launch();
});
after(async () => {
  await browser.close();
});

test("draws every plot without an error or a request", async () => {
  const study = sampleStudy();
  const { page, errors, requests, took } = await open(browser, "study", JSON.stringify(study));
  console.log(`# study of ${study.runs.length} runs: open in ${Math.round(took)} ms`);
  // Read-outs, paths for each of ten points, MSD, forces for each of five columns, correlation.
  assert.equal(await allDrawn(page), 5 + 10 + 1 + 5 + 1);
  assert.equal(await page.locator("#shapes polygon").count(), study.runs.filter((r) => r.outline).length);
  assert.equal(await page.locator("#readouts .plotly-figure >> nth=0 >> .boxlayer .trace").count(), 10);
  assert.equal(await page.locator("#correlation .hm").count(), 1);
  assert.equal(await page.locator("#msd .scatterlayer .trace").count(), 11);
  assert.deepEqual(errors, []);
  assert.deepEqual(requests, []);
  await page.locator(".study-controls select >> nth=0").selectOption("1");
  await page.locator(".study-controls select >> nth=1").selectOption("none");
  assert.equal(await page.locator(".plotly-figure").count(), 5 + 10 + 1 + 2 + 1);
  assert.deepEqual(errors, []);
  await page.context().close();
});

test("groups of tracks have names in place of seeds, and medians with their intervals", async () => {
  const study = sampleStudy();
  study.sampled = "tracks";
  study.provenance = "";
  for (const run of study.runs) run.name = `<track> ${run.id}`;
  for (const group of study.groups) if (group.median !== null) group.median_interval = [group.median - 1, group.median + 1];
  const { page, errors } = await open(browser, "study", JSON.stringify(study));
  const group = study.groups.find((g) => g.median !== null && g.n > 0);
  assert.ok(group);
  const text = (await page.locator("#medians").textContent()) ?? "";
  assert.ok(text.includes(`n = ${group.n}`) && text.includes("["), text.slice(0, 200));
  assert.ok((await page.locator("#readouts").textContent())?.includes("points: tracks"));
  assert.equal(await page.locator("#runs").count(), 0);
  assert.equal(await page.locator("#provenance").count(), 0);
  assert.deepEqual(errors, []);
  await page.context().close();
});

test("begins with what came out, the command and the number of runs", async () => {
  const study = sampleStudy();
  const { page } = await open(browser, "study", JSON.stringify(study));
  assert.equal(await page.title(), study.title);
  const head = (await page.locator("header").textContent()) ?? "";
  for (const part of [study.title, study.status, study.summary?.replace("v_migr_abs", "vmigr,abs"), "command", "matrigrate study run", "runs done"])
    assert.ok(head.includes(part ?? ""), part);
  await page.context().close();
});

test("boxes have the quartiles and whiskers that the program computed", async () => {
  const study = sampleStudy();
  const group = study.groups.find((g) => g.readout === study.readouts[0].name && g.point.join() === "1,0");
  assert.ok(group);
  Object.assign(group, { low_whisker: 3.5, low_quartile: 4.25, median: 5.5, high_quartile: 6.75, high_whisker: 7.5 });
  const { page } = await open(browser, "study", JSON.stringify(study));
  await allDrawn(page);
  const drawn = await page.evaluate(() => {
    const plot = document.querySelector("#readouts .plotly-figure") as unknown as {
      calcdata: { lf: number; q1: number; med: number; q3: number; uf: number }[][];
    };
    return plot.calcdata.map(([box]) => [box.lf, box.q1, box.med, box.q3, box.uf]);
  });
  assert.deepEqual(
    drawn.filter((box) => box[2] === 5.5),
    [[3.5, 4.25, 5.5, 6.75, 7.5]],
  );
  const of = (g: (typeof study.groups)[number]) => [
    g.low_whisker,
    g.low_quartile,
    g.median,
    g.high_quartile,
    g.high_whisker,
  ];
  for (const g of study.groups.filter((g) => g.readout === study.readouts[0].name))
    assert.ok(
      drawn.some((box) => box.join() === of(g).join()),
      `${g.point}`,
    );
  await page.context().close();
});

test("with two runs at a point nothing is starred, and it says why", async () => {
  const { page } = await open(browser, "study", JSON.stringify(sampleStudy(2)));
  await allDrawn(page);
  assert.match((await page.locator("#readouts .notice").textContent()) ?? "", /at least 3 runs at each point.* n = 2/);
  await page.locator(".study-controls select >> nth=1").selectOption("all");
  await allDrawn(page);
  const texts = await page.locator("#readouts .textpoint text").allTextContents();
  assert.ok(texts.length > 0);
  assert.deepEqual([...new Set(texts)], ["n < 3"]);
  await page.context().close();
  const enough = await open(browser, "study", JSON.stringify(sampleStudy(12)));
  assert.equal(await enough.page.locator("#readouts .notice").count(), 0);
  assert.match(
    (await enough.page.locator("#readouts figcaption >> nth=0").textContent()) ?? "",
    /Holm's correction over \d+ comparisons/,
  );
  await enough.page.context().close();
});

test("everything is drawn when it is printed, and fits the paper", async () => {
  const { page, errors } = await open(browser, "study", JSON.stringify(sampleStudy()), { colorScheme: "dark" });
  const [before, after] = await page.evaluate(() => {
    const state = () => {
      const plots = [...document.querySelectorAll(".plotly-figure")];
      return {
        plots: plots.length,
        drawn: plots.filter((plot) => plot.querySelector(".main-svg .cartesianlayer path, .main-svg .hm")).length,
        widest: Math.max(...plots.map((plot) => plot.querySelector(".main-svg")?.clientWidth ?? 0)),
        timelines: document.querySelectorAll("#players .timeline svg").length,
      };
    };
    const first = state();
    dispatchEvent(new Event("beforeprint"));
    return [first, state()];
  });
  assert.ok(before.drawn < before.plots, "some wait until they are seen");
  assert.equal(after.drawn, after.plots);
  assert.ok(after.widest <= 700, `${after.widest}`);
  assert.equal(after.timelines, 1);
  await page.emulateMedia({ media: "print" });
  const colours = await page.evaluate(() =>
    [...document.querySelectorAll(".patch, .swatch, .dot, .bar")].map(
      (one) => getComputedStyle(one).getPropertyValue("print-color-adjust") || getComputedStyle(one).getPropertyValue("-webkit-print-color-adjust"),
    ),
  );
  assert.ok(colours.length > 0);
  assert.deepEqual([...new Set(colours)], ["exact"], "legends keep their colours");
  assert.deepEqual(errors, []);
  await page.context().close();
});

test("lists verdicts, failures first, and links to reports beside it alone", async () => {
  const study = sampleStudy();
  study.runs[0].report = "javascript:alert(1)";
  study.runs[1].report = "https://example.org/";
  const { page } = await open(browser, "study", JSON.stringify(study));
  assert.match((await page.locator("#runs tbody tr >> nth=0").textContent()) ?? "", /failed: the solver gave up/);
  assert.match((await page.locator("#claims").textContent()) ?? "", /does not hold/);
  assert.equal(await page.locator("#runs a").count(), study.runs.length - 2);
  await page.context().close();
});

test("shows claims with the published value, ours and the statistic", async () => {
  const { page } = await open(browser, "study", JSON.stringify(sampleStudy()));
  const heads = await page.locator("#claims th").allTextContents();
  assert.deepEqual(heads.slice(1), ["claim", "verdict", "published", "ours: mean [95 %]", "statistic"]);
  const first = (await page.locator("#claims tbody tr >> nth=0").textContent()) ?? "";
  for (const part of ["A2", "holds", "4.1 and 9.3 \u00b5m/h", "[7.6, 11.0]", "p 0.0001", "not the paper's runs"])
    assert.ok(first.includes(part), part);
  assert.match((await page.locator("#claims .notice").textContent()) ?? "", /Not run as published/);
  await page.context().close();
});

test("plays chosen runs, one at a time, when they are looked at", async () => {
  const study = sampleStudy();
  const { page, errors, requests } = await open(browser, "study", JSON.stringify(study));
  await page.locator("#players .stage").waitFor({ state: "attached" }); // though nobody has scrolled to it
  await page.locator("#players h2 >> nth=0").scrollIntoViewIfNeeded();
  await page.locator("#players .stage").waitFor();
  assert.equal(await page.locator("#players .play").getAttribute("aria-label"), "Play", "it waits to be started");
  await page.locator("#players .scrub").fill("3600");
  const early = (await page.locator("#players .stage").screenshot()).toString("base64");
  await page.locator("#players .scrub").fill("7200");
  await page.evaluate(() => new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(done))));
  assert.notEqual((await page.locator("#players .stage").screenshot()).toString("base64"), early);
  await page.locator("#players .play").click();
  await until(async () => (await page.locator("#players .stage .time").textContent()) !== "2 h 00 min", "it plays");
  await page.locator("#players select >> nth=0").selectOption("1");
  await page.locator(`.chosen-run[data-run="${study.players?.[1].id}"] .stage`).waitFor();
  assert.equal(await page.locator("#players .stage").count(), 1);
  assert.equal(await page.locator("#players .note a").getAttribute("href"), study.runs[1].report);
  assert.deepEqual(errors, []);
  assert.deepEqual(requests, []);
  await page.context().close();
});

test("plays two runs beside each other on one clock", async () => {
  const { page, errors } = await open(browser, "study", JSON.stringify(sampleStudy()));
  await page.locator("#players .stage").waitFor({ state: "attached" });
  await page.locator("select[name=beside]").selectOption("1");
  await until(async () => (await page.locator("#players .stage").count()) === 2, "both are there");
  await page.locator("#players .stage >> nth=0").scrollIntoViewIfNeeded();
  assert.equal(await page.locator("#players .scrub").count(), 1, "one clock has one control");
  await page.locator("#players .scrub").fill("3600");
  assert.deepEqual(await page.locator("#players .stage .time").allTextContents(), ["1 h 00 min", "1 h 00 min"]);
  // The layers of each are its own.
  await page.locator("#players input[value=pressure] >> nth=1").check();
  assert.ok(await page.locator("#players input[value=degradation] >> nth=0").isChecked());
  const [a, b] = [await page.locator("#film").boundingBox(), await page.locator("#film-2").boundingBox()];
  assert.ok(a && b && b.x > a.x + a.width - 1 && Math.abs(a.y - b.y) < 60, "not beside each other");
  const ids = await page.evaluate(() => [...document.querySelectorAll("[id]")].map((e) => e.id));
  assert.equal(new Set(ids).size, ids.length, "ids are not unique");
  await page.locator("select[name=beside]").selectOption("");
  await until(async () => (await page.locator("#players .stage").count()) === 1, "one is left");
  assert.deepEqual(errors, []);
  await page.context().close();
  const phone = await open(browser, "study", JSON.stringify(sampleStudy()), { viewport: { width: 390, height: 844 } });
  await phone.page.locator("select[name=beside]").selectOption("1");
  await until(async () => (await phone.page.locator("#players .stage").count()) === 2, "both are there");
  const wide = await phone.page.evaluate(() => document.documentElement.scrollWidth - window.innerWidth);
  assert.ok(wide <= 0, `scrolls sideways by ${wide}`);
  await phone.page.context().close();
});

test("a player that is closed listens no more", async () => {
  const { page, errors } = await open(browser, "study", JSON.stringify(sampleStudy()));
  await page.locator("#players .stage").waitFor({ state: "attached" });
  await page.evaluate(() => {
    const real = window.requestAnimationFrame.bind(window);
    window.requestAnimationFrame = (callback) => {
      document.documentElement.dataset["asked"] = String(Number(document.documentElement.dataset["asked"] ?? 0) + 1);
      return real(callback);
    };
  });
  /** Pictures that are asked for when the colours of the page change. */
  const asked = async (colorScheme: "dark" | "light") => {
    const count = () => page.evaluate(() => Number(document.documentElement.dataset["asked"] ?? 0));
    const quiet = async () => {
      for (let before = -1, now = await count(); now !== before; now = await count()) {
        before = now;
        await page.waitForTimeout(500);
      }
    };
    await settled(page);
    await quiet();
    const before = await count();
    await page.emulateMedia({ colorScheme });
    await until(async () => (await count()) > before, "the player follows the colours of the page");
    await quiet();
    return (await count()) - before;
  };
  const one = await asked("dark");
  for (const choice of ["1", "0", "1", "0"]) {
    await page.locator("#players select >> nth=0").selectOption(choice);
    await page.waitForTimeout(50);
    await page.locator("#players .stage").waitFor({ state: "attached" });
  }
  assert.equal(await asked("light"), one);
  assert.deepEqual(errors, []);
  await page.context().close();
});

test("a study with one axis, or with nothing done yet", async () => {
  const study = sampleStudy();
  const one = {
    ...study,
    axes: study.axes.slice(0, 1),
    runs: study.runs.filter((r) => r.point[1] === 0).map((r) => ({ ...r, point: [r.point[0]] })),
    tests: [],
    msd: [],
    correlation: null,
    claims: undefined,
    players: undefined,
  };
  const first = await open(browser, "study", JSON.stringify(one));
  assert.equal(await allDrawn(first.page), 5 + 5 + 5);
  assert.deepEqual(first.errors, []);
  await first.page.context().close();
  const none = {
    ...one,
    runs: one.runs.map((r) => ({
      ...r,
      status: "pending",
      readouts: {},
      path: null,
      outline: null,
      f_adh_rel: undefined,
    })),
  };
  const second = await open(browser, "study", JSON.stringify(none), { viewport: { width: 390, height: 844 } });
  assert.ok(await second.page.locator("#runs").isVisible());
  assert.ok(
    await second.page.evaluate(() => document.documentElement.scrollWidth <= window.innerWidth),
    "scrolls sideways",
  );
  assert.deepEqual(second.errors, []);
  await second.page.context().close();
});

test("boxes have the band of what was measured", async () => {
  const study = sampleStudy(3);
  const targets = [
    { readout: study.readouts[0].name, low: 8, high: 9, error: 0.5, at: "" },
    { readout: study.readouts[0].name, low: 40, high: 40, error: 1, at: "stiff_gel" },
  ];
  const { page, errors } = await open(browser, "study", JSON.stringify({ ...study, targets }));
  await allDrawn(page);
  const first = await page.evaluate(() => {
    const one = document.querySelector("#readouts .plotly-figure") as unknown as {
      layout: { shapes: { y0: number; y1: number }[]; annotations: { text: string }[]; yaxis: { range: number[] } };
    };
    return { ends: one.layout.shapes.map((s) => [s.y0, s.y1]), said: one.layout.annotations.map((a) => a.text), top: one.layout.yaxis.range[1] };
  });
  assert.deepEqual(first.ends, [[7.5, 9.5], [39, 41]]);
  assert.deepEqual(first.said.slice(0, 2), ["target", "target at stiff_gel"]);
  assert.ok(first.top > 41, "a target beyond the runs is in sight");
  assert.match((await page.locator("#readouts figcaption >> nth=0").textContent()) ?? "", /Band: measured, with one standard error/);
  assert.deepEqual(errors, []);
  await page.context().close();
});

test("a design that is no grid is drawn over its factors, with targets", async () => {
  const study = sampleStudy(2);
  const values = [138, 50, 900, 210, 77];
  const labels = values.map((_, i) => `sample ${i + 1}`);
  const points = values.map((_, i) => [i]);
  const correlations = study.readouts.map((r) => ({ readout: r.name, rho: 0.9, p_holm: 0.04, n: 5 }));
  const design = {
    ...study,
    axes: [{ name: "point", label: "point", meaning: "Point of the study", unit: "", values: labels }],
    runs: study.runs.filter((r) => r.point[1] === 0).map((r) => ({ ...r, point: [r.point[0]] })),
    groups: study.groups.filter((g) => g.point[1] === 0).map((g) => ({ ...g, point: [g.point[0]] })),
    tests: [],
    msd: [],
    scatter: {
      points,
      factors: [{ name: "ecm.youngs_modulus", label: "ecm.youngs_modulus (E)", meaning: "Young's modulus of the intact matrix", unit: "Pa", values, correlations }],
    },
    targets: [{ readout: study.readouts[0].name, low: 5, high: 6, error: 1, at: "" }],
  };
  const { page, errors } = await open(browser, "study", JSON.stringify(design));
  await allDrawn(page);
  assert.equal(await page.locator("#scatter .plotly-figure").count(), study.readouts.length);
  assert.equal(await page.locator("#readouts").count(), 0, "no boxes over names of samples");
  const caption = (await page.locator("#scatter figcaption >> nth=0").textContent()) ?? "";
  assert.match(caption, /^Speed, start to end, over Young's modulus of the intact matrix: Spearman's rho 0.9 over 5 points, p = 0.040 after Holm/);
  const shapes = await page.evaluate(() =>
    [...document.querySelectorAll("#scatter .plotly-figure")].map(
      (one) => (one as unknown as { layout: { shapes: { y0: number; y1: number }[] } }).layout.shapes.map((s) => [s.y0, s.y1]),
    ),
  );
  assert.deepEqual(shapes.slice(0, 2), [[[4, 7]], []], "the target on its read-out alone");
  assert.deepEqual(errors, []);
  await page.context().close();
});

test("of fewer than five runs the points are drawn, and no box", async () => {
  const { page, errors } = await open(browser, "study", JSON.stringify(sampleStudy(2)));
  await allDrawn(page);
  assert.equal(await page.locator("#readouts .boxlayer .trace").count(), 0);
  assert.match((await page.locator("#runs tbody a >> nth=0").textContent()) ?? "", /^replicate \d+$/);
  assert.deepEqual(errors, []);
  await page.context().close();
});

test("of very many points, small pictures are left out", async () => {
  const study = sampleStudy(1);
  const labels = Array.from({ length: 61 }, (_, i) => `sample ${i + 1}`);
  const axes = [{ name: "point", label: "point", meaning: "Point of the study", unit: "", values: labels }];
  const runs = labels.map((_, i) => ({ ...study.runs[0], id: `run ${i}`, point: [i] }));
  const many = { ...study, axes, runs, groups: [], tests: [], msd: [], claims: undefined, players: undefined };
  const { page, errors } = await open(browser, "study", JSON.stringify(many));
  assert.match((await page.locator("#paths").textContent()) ?? "", /With 61 points/);
  assert.equal(await page.locator("#paths .plotly-figure, #shapes, #msd").count(), 0);
  assert.deepEqual(errors, []);
  await page.context().close();
});

test("says plainly what is wrong with the data", async () => {
  const { page } = await open(browser, "study", "null");
  assert.match((await page.locator("[role=alert]").textContent()) ?? "", /empty template/);
  await page.context().close();
});
