/** What a person reads on axes, in legends and in captions is in words: no code name, no "um", no unit in brackets, no name twice. */
import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { join } from "node:path";
import { after, before, test } from "node:test";
import type { Browser, Page } from "playwright-core";
import { sampleRun } from "../sample/run";
import { sampleStudy } from "../sample/study";
import { sampleVerdicts } from "../sample/verdicts";
import { said, settingOf, symbolOf, titleOf, typeset, units, unmarked, verbatim, wordsOf } from "../src/words";
import type { StudyPage } from "../src/study/contract";
import { allDrawn, launch, open } from "./browser";

let browser: Browser;
before(async () => {
  browser = await launch();
});
after(async () => {
  await browser.close();
});

const source = process.env["MATRIGRATE_SOURCE"] ?? "..";
const document_ = (name: string) => JSON.parse(readFileSync(join(source, "docs", name), "utf8"));

/** A code name, a unit in letters that are no unit, or one in brackets. */
const code = /[a-z]{2,}_[a-z0-9]|[a-z0-9]_[a-z]{2,}|\bum\b|\[[^\]]*\]/;

interface Entry {
  type?: string;
  description: string;
  properties?: Record<string, Entry>;
}

function parameters(entry: Entry, path = ""): { name: string; label: string; meaning: string; unit: string }[] {
  return Object.entries(entry.properties ?? {}).flatMap(([key, inner]) => {
    if (inner.properties) return parameters(inner, `${path}${key}.`);
    const name = path + key;
    const meaning = inner.description.split(/; |\. Default/)[0];
    return path ? [{ name, label: / \(([^()\s]+)\)$/.exec(meaning)?.[1] ?? key, meaning: meaning.replace(/ \([^()\s]+\)$/, ""), unit: "" }] : [];
  });
}

test("every parameter has words of its own, and none is a code name", () => {
  const all = parameters(document_("scenario.schema.json"));
  assert.ok(all.length > 100);
  const words = all.map(wordsOf);
  for (const [i, text] of words.entries()) {
    assert.doesNotMatch(typeset(text), code, all[i].name);
    assert.equal(words.indexOf(text), i, `${all[i].name} and ${all[words.indexOf(text)].name}`);
  }
});

test("every read-out has words of its own", () => {
  const titles = (document_("readouts.json") as { name: string; label: string; unit: string; meaning: string }[]).map(titleOf);
  for (const title of titles) assert.doesNotMatch(typeset(title), code);
  assert.equal(new Set(titles).size, titles.length);
  assert.ok(titles.includes("speed, start to end, v_migr_abs (\u00b5m/h)"));
  assert.ok(titles.includes("protrusions initiated"), "a count has no symbol");
});

test("symbols are set as the paper does", () => {
  assert.equal(typeset("f_mat F_am, tau_prot, r_off,min"), "f<sub>mat</sub> F<sub>am</sub>, \u03c4<sub>prot</sub>, r<sub>off,min</sub>");
  assert.equal(typeset("n_protrusions msd_slope"), "n_protrusions msd_slope");
  const constant = { name: "laws.constants.F_s", label: "F_s", meaning: "Constant of the laws", unit: "nN" };
  assert.deepEqual([titleOf(constant), settingOf(constant, 0.4)], ["F_s (nN)", "F_s = 0.4 nN"]);
  assert.equal(symbolOf({ name: "protrusion.force", label: "protrusion.force (F_prot)", unit: "nN" }), "F_prot");
  assert.equal(symbolOf({ name: "degradation.tip_rate", label: "tip_rate", unit: "1/s" }), "");
  assert.equal(settingOf({ name: "protrusion.force", label: "F_prot", meaning: "Growth force of a protrusion", unit: "nN" }, 0.2), "F_prot = 0.2 nN");
  assert.equal(units("ratio [-]"), "ratio");
  assert.equal(units("displacement [um]"), "displacement (\u00b5m)");
});

test("a headline calls points and read-outs as the plots do", () => {
  const axes = [{ name: "ecm.youngs_modulus", label: "ecm.youngs_modulus (E)", meaning: "Young's modulus of the intact matrix", unit: "Pa", values: [5, 50, 400] }];
  const readouts = [
    { name: "v_migr_abs_um_per_h", label: "v_migr_abs", meaning: "speed, start to end", unit: "um/h" },
    { name: "n_protrusions", label: "n_protrusions", meaning: "protrusions initiated", unit: "" },
  ];
  assert.equal(
    typeset(said("Speed, start to end (v_migr_abs) is lowest, 8 um/h at youngs_modulus 50 Pa; protrusions initiated (n_protrusions) at youngs_modulus 5 Pa", axes, readouts)),
    "Speed, start to end (v<sub>migr,abs</sub>) is lowest, 8 \u00b5m/h at E = 50 Pa; protrusions initiated at E = 5 Pa",
  );
});

test("a headline names each of two forces that are equal, and numbers that begin alike", () => {
  const axes = [
    { name: "protrusion.force", label: "protrusion.force (F_prot)", meaning: "Growth force of a protrusion", unit: "nN", values: [0.2, 0.4] },
    { name: "actomyosin.force", label: "actomyosin.force (F_am)", meaning: "Actomyosin force of a strand", unit: "nN", values: [0.2, 0.6] },
    { name: "protrusion.number", label: "protrusion.number (n_prot)", meaning: "Target number", unit: "", values: [1, 12] },
  ];
  const headline = (text: string) => unmarked(said(text, axes, []));
  assert.equal(
    headline("lowest, 11.4 um/h at protrusion.force 0.2 nN, actomyosin.force 0.2 nN, and highest at protrusion.force 0.2 nN, actomyosin.force 0.6 nN."),
    "lowest, 11.4 \u00b5m/h at F_prot = 0.2 nN, F_am = 0.2 nN, and highest at F_prot = 0.2 nN, F_am = 0.6 nN.",
  );
  assert.equal(headline("at actomyosin.force 0.2 nN, number 12, protrusion.force 0.2 nN, number 1."), "at F_am = 0.2 nN, n_prot = 12, F_prot = 0.2 nN, n_prot = 1.");
  assert.equal(headline("12 of number 1 at myforce 0.2 nN"), "12 of n_prot = 1 at myforce 0.2 nN");
});

const odd = "a_b & <b>c</b> 50%{x} um $d$";

test("text of the user stands as it is within text that is typeset", () => {
  assert.equal(typeset(`${verbatim(odd)}, f_mat`), "a_b &amp; &lt;b>c&lt;/b> 50%&#123;x} um $d$, f<sub>mat</sub>");
  assert.equal(unmarked(said(`at ${odd}, of 3 um`, [{ name: "point", label: "point", unit: "", values: [odd] }], [])), `at ${odd}, of 3 \u00b5m`);
  assert.equal(typeset(settingOf({ name: "ecm.fields.youngs_modulus", label: "E", unit: "Pa" }, "E_x.csv")), "E = E_x.csv Pa");
});

test("labels of points stand as they are in plots, captions and lists", async () => {
  const study = hypercube();
  const labels = [odd, "_control", "f_mat", "$x_1$", "<i>e</i> &amp; um"];
  study.axes[0].values = labels;
  study.scatter = null;
  study.summary = `Speed is lowest, 3 um/h at ${odd}, and highest at f_mat.`;
  const { page, errors } = await open(browser, "study", JSON.stringify(study));
  await allDrawn(page);
  assert.deepEqual(await page.evaluate(() => [...document.querySelectorAll("#readouts .plotly-figure")].slice(0, 1).flatMap((one) => [...one.querySelectorAll(".xtick text")].map((text) => text.textContent))), labels);
  const captions = await page.evaluate(() => [...document.querySelectorAll("#paths figcaption")].map((one) => one.innerHTML));
  assert.ok(captions.some((text) => text.startsWith("a_b &amp; &lt;b&gt;c&lt;/b&gt; 50%{x} um $d$, n")), captions[0]);
  assert.ok(captions.some((text) => text.startsWith("f_mat, n")), "no symbol");
  assert.match((await page.locator("header .status").textContent()) ?? "", /3 \u00b5m\/h at a_b & <b>c<\/b> 50%\{x\} um \$d\$, and highest at f_mat\./);
  const named = await page.evaluate(() => [...document.querySelectorAll(".plotly-figure")].map((one) => one.getAttribute("aria-label") ?? ""));
  assert.ok(named.every((text) => !/[\ue000\ue001]/.test(text)));
  assert.ok(!/[\ue000\ue001]/.test((await page.locator("body").innerText())), "no marks are seen");
  assert.deepEqual(errors, []);
  await page.context().close();
});

/** All that is written in and below the plots of a page, as lines of plain text. */
const written = (page: Page) =>
  page.evaluate(() =>
    [...document.querySelectorAll("figure svg text, figcaption, ul.series li, .plots text, .study-controls option, header h1, header .status")].map((one) => {
      const copy = one.cloneNode(true) as Element;
      for (const below of copy.querySelectorAll("sub, tspan[style*='font-size']")) below.replaceWith(` ${below.textContent ?? ""}`);
      return copy.textContent ?? "";
    }),
  );

/** A study of two forces, both `force` by their last word. */
function hypercube(): StudyPage {
  const study = sampleStudy(2);
  const values = [0.01, 0.03, 0.1, 0.3, 1];
  const correlations = study.readouts.map((r) => ({ readout: r.name, rho: 0.9, p_holm: 0.04, n: 5 }));
  const factor = (name: string, label: string, meaning: string, of: number[]) => ({ name, label, meaning, unit: "nN", values: of, correlations });
  return {
    ...study,
    axes: [{ name: "point", label: "point", meaning: "Point of the study", unit: "", values: values.map((_, i) => `sample ${i + 1}`) }],
    runs: study.runs.filter((r) => r.point[1] === 0).map((r) => ({ ...r, point: [r.point[0]], readouts: { ...r.readouts, tau_prot_min: null } })),
    groups: study.groups.filter((g) => g.point[1] === 0).map((g) => ({ ...g, point: [g.point[0]] })),
    tests: [],
    msd: [],
    scatter: {
      points: values.map((_, i) => [i]),
      factors: [
        factor("protrusion.force", "protrusion.force (F_prot)", "Growth force of a protrusion", values),
        factor("actomyosin.force", "actomyosin.force (F_am)", "Actomyosin force of a strand at full maturation", [1, 2, 3, 4, 5]),
      ],
    },
  };
}

test("pages are read without knowing the code", async () => {
  for (const [kind, data] of [
    ["study", sampleStudy()],
    ["study", hypercube()],
    ["verdicts", sampleVerdicts()],
    ["run", sampleRun({ radius: 90, interval: 600, end: 3600 })],
  ] as const) {
    const { page, errors } = await open(browser, kind, JSON.stringify(data));
    await (kind === "run" ? page.locator(".plots svg >> nth=0").waitFor({ state: "attached" }) : allDrawn(page));
    const texts = (await written(page)).map((text) => text.replace(/\([vf]_[a-z_]+\)/g, ""));
    assert.ok(texts.length > 20, kind);
    for (const text of texts) assert.doesNotMatch(text, code, kind);
    const cells = await page.evaluate(() => [...document.querySelectorAll("th, td:not(:has(code))")].map((one) => one.textContent ?? ""));
    assert.ok(cells.length > 20, kind);
    for (const text of cells) assert.doesNotMatch(text, /\bum\b|\[(-|\u00b5m.*|nN|Pa|min|s)\]/, kind);
    assert.deepEqual(errors, []);
    await page.context().close();
  }
});

test("a plot tells its parameter from others, and has the scale that this was drawn on", async () => {
  const { page } = await open(browser, "study", JSON.stringify(hypercube()));
  await allDrawn(page);
  const axes = await page.evaluate(() =>
    [...document.querySelectorAll("#scatter .plotly-figure")].map((one) => {
      const { xaxis, yaxis } = (one as unknown as { layout: Record<string, { title: { text: string }; type?: string; ticktext?: string[]; dtick?: number }> }).layout;
      return { x: xaxis.title.text.replaceAll("<br>", " "), type: xaxis.type, ticks: xaxis.ticktext, y: yaxis.title.text, step: yaxis.dtick };
    }),
  );
  assert.equal(axes[0].x, "growth force of a protrusion, F<sub>prot</sub> (nN)");
  assert.equal(axes[1].x, "actomyosin force of a strand at full maturation, F<sub>am</sub> (nN)");
  assert.deepEqual(axes.slice(0, 2).map((a) => a.type), ["log", "linear"]);
  assert.deepEqual(axes[0].ticks, ["0.01", "0.1", "1"], "decades");
  assert.ok(axes.filter((a) => a.y === "protrusions initiated").every((a) => Number.isInteger(a.step)), "counts");
  assert.equal(axes.filter((a) => a.y.startsWith("life of")).length, 0, "no plot without a value");
  await page.context().close();
});

test("plots beside each other stand on one level, and one without a value is said, not drawn", async () => {
  const study = sampleStudy();
  for (const run of study.runs) run.readouts["l_prot_um"] = null;
  study.tests = study.tests.filter((t) => t.readout !== "f_mat"); // fewer levels of comparisons
  const { page } = await open(browser, "study", JSON.stringify(study));
  await allDrawn(page);
  const boxes = await page.evaluate(() =>
    [...document.querySelectorAll("#readouts .plotly-figure")].map((one) => one.getBoundingClientRect()).map((r) => ({ top: r.top, height: r.height })),
  );
  assert.equal(boxes.length, study.readouts.length - 1);
  for (let i = 0; i + 1 < boxes.length; i += 2) assert.deepEqual(boxes[i], boxes[i + 1]);
  assert.match((await page.locator("#readouts .empty").textContent()) ?? "", /Nothing has a value of: length at the end of growth/);
  await page.context().close();
});

test("titles of axes lie within their plots, also on a phone", async () => {
  for (const width of [1280, 390]) {
    const { page } = await open(browser, "study", JSON.stringify(hypercube()), { viewport: { width, height: 900 } });
    await allDrawn(page, width);
    const titles = await page.evaluate(() =>
      [...document.querySelectorAll(".plotly-figure")].flatMap((plot) => {
        const outer = plot.getBoundingClientRect();
        return [...plot.querySelectorAll(".xtitle, .ytitle")].map((title) => {
          const inner = title.getBoundingClientRect();
          return { text: title.textContent ?? "", out: Math.max(outer.left - inner.left, inner.right - outer.right, outer.top - inner.top, inner.bottom - outer.bottom) };
        });
      }),
    );
    assert.ok(titles.length > 8);
    for (const title of titles) assert.ok(title.out <= 1, `${title.text} at ${width}: ${title.out} pixels outside`);
    await page.context().close();
  }
});

test("few small pictures use the width of the page", async () => {
  const study = sampleStudy(2);
  const one = { ...study, axes: study.axes.slice(0, 1).map((a) => ({ ...a, values: a.values.slice(0, 2) })), tests: [], msd: [], correlation: null };
  one.runs = study.runs.filter((r) => r.point[1] === 0 && r.point[0] < 2).map((r) => ({ ...r, point: [r.point[0]] }));
  const { page } = await open(browser, "study", JSON.stringify(one));
  await allDrawn(page);
  const width = await page.evaluate(() => [...document.querySelectorAll("#paths .plotly-figure")].reduce((sum, f) => sum + f.clientWidth, 0));
  assert.ok(width > 900, `${width}`);
  await page.context().close();
});
