/** Fibres: found from the bonds of the lattice, strained as their ends move, drawn and explained where there are any. */
import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { test } from "node:test";
import { sampleRun } from "../sample/run";
import { fibresOf, type Film } from "../src/run/frames";
import { fibreLayer, strainAt } from "../src/run/over/fibres";
import { field, launch, open, still, until } from "./browser";


/** Particles of a square lattice, 5 by 5, and of a hexagonal one. */
const square = Array.from({ length: 25 }, (_, i) => [2 * (i % 5) - 4, 2 * Math.floor(i / 5) - 4]);
const row = Math.sqrt(3);
const hexagonal = Array.from({ length: 25 }, (_, i) => {
  const j = Math.floor(i / 5) - 2;
  return [2 * ((i % 5) - 2) + (j % 2 === 0 ? 0 : 1), row * j];
});

test("fibres join the particles that the bonds say, those along shorter ones left out", () => {
  const bonds: [number, number][] = [[2, 0], [4, 0], [4, 2], [-4, 2]];
  const { ends, length } = fibresOf({ bonds_um: bonds, onset: 0.075 }, field(square.flat(), 0.005));
  assert.equal(ends.length, 2 * length.length);
  assert.equal(length.length, 5 * 4 + 4 * 3 + 4 * 3);
  const seen = new Set<string>();
  for (let k = 0; k < length.length; ++k) {
    const [a, b] = [square[ends[2 * k]], square[ends[2 * k + 1]]];
    const bond = [b[0] - a[0], b[1] - a[1]].join();
    assert.ok(["2,0", "4,2", "-4,2"].includes(bond), bond);
    assert.ok(Math.abs(length[k] - Math.hypot(b[0] - a[0], b[1] - a[1])) < 1e-6);
    seen.add([ends[2 * k], ends[2 * k + 1]].sort().join());
  }
  assert.equal(seen.size, length.length, "a fibre is drawn twice");
  const around: [number, number][] = [[2, 0], [1, row], [-1, row]];
  const found = fibresOf({ bonds_um: around, onset: 0 }, field(hexagonal.flat(), 0.005));
  assert.equal(found.length.length, 5 * 4 + 2 * 4 * 5 - 4, "neighbours of a hexagonal lattice");
});

test("strain is that of the ends, and a fibre with an end in the fluid is gone", () => {
  const reference = field(square.flat(), 0.005);
  const x = field(square.flatMap(([a, b]) => [1.1 * a, 0.95 * b]), 0.005);
  const f = field(square.map((_, i) => (i === 0 ? 0 : 1)), 1 / 255);
  const fibres = fibresOf({ bonds_um: [[2, 0], [0, 2]], onset: 0.075 }, reference);
  const film = { times: [0], x, f, reference, fibres, particles: 25 } as unknown as Film;
  const place = { frame: 0, next: 0, fraction: 0 };
  let gone = 0;
  for (let k = 0; k < fibres.length.length; ++k) {
    const [i, j] = [fibres.ends[2 * k], fibres.ends[2 * k + 1]];
    const strain = strainAt(film, fibres, place, k);
    if (i === 0 || j === 0) {
      assert.ok(Number.isNaN(strain));
      ++gone;
    } else assert.ok(Math.abs(strain - (square[i][1] === square[j][1] ? 0.1 : -0.05)) < 0.004, `${strain}`);
  }
  assert.equal(gone, 2);
  const layer = fibreLayer(film);
  assert.deepEqual([layer?.low, layer?.high], [-0.1, 0.1]);
  assert.equal(fibreLayer({ ...film, fibres: null }), null);
});

test("fibres are drawn, explained, switched by key and box, saved, and not there without any", async () => {
  const browser = await launch();
  const run = sampleRun({ radius: 60, interval: 600, end: 7200 });
  const { page, errors } = await open(browser, "run", JSON.stringify(run));
  await page.locator(".scrub").fill("3900");
  const box = page.locator("input[name=fibres]");
  const legend = page.getByText("Fibre strain", { exact: true });
  await until(async () => (await box.isChecked()) && (await legend.isVisible()), "fibres are drawn and explained");
  assert.ok(await page.getByText("beyond a strain of 0.075 they stiffen").isVisible());
  const off = () => until(async () => !(await box.isChecked()) && !(await legend.isVisible()), "the key switches them off");
  const on = async () => {
    await box.check();
    await until(() => legend.isVisible(), "the box switches them on");
    return still(page);
  };
  const keyed = async () => {
    await page.keyboard.press("b");
    await off();
    return still(page);
  };
  // Twice, since a slow page may still be laid out the first time round.
  let [bare, drawn] = [await keyed(), await on()];
  await until(async () => {
    const [before, then] = [bare, drawn];
    [bare, drawn] = [await keyed(), await on()];
    return bare === before && drawn === then;
  }, "key and box give the same two pictures again");
  assert.ok(bare !== drawn, "neither changes anything");
  assert.match((await page.locator(".screen > [role=status].unseen").textContent()) ?? "", /and the strain of fibres\.$/);
  const bars = () => page.locator(".legend-layer .bar").evaluateAll((all) => all.map((e) => e.getAttribute("style")));
  await page.locator("input[value=pressure]").check();
  const [pressure, strain] = await bars();
  assert.notEqual(strain, pressure, "fibres are lost on a layer of the same colours");
  await page.locator("input[value=degradation]").check();
  assert.equal((await bars())[1], pressure);
  await page.locator("input[value=particles]").check();
  const particles = await still(page);
  await page.keyboard.press("b");
  assert.ok((await still(page)) !== particles, "over particles, too");
  await page.keyboard.press("b");
  await page.getByRole("button", { name: "The whole matrix" }).click();
  const [download] = await Promise.all([
    page.waitForEvent("download"),
    page.getByRole("button", { name: "Save SVG" }).click(),
  ]);
  const svg = readFileSync(await download.path(), "utf8");
  const group = /<g id="fibres">(.*?)<\/g>/s.exec(svg)?.[1] ?? "";
  assert.ok((group.match(/<path/g) ?? []).length > 5, "lines of a few colours");
  assert.ok(svg.includes(">Fibre strain</text>") && !svg.includes("rgba(,"));
  assert.deepEqual(errors, []);
  await page.context().close();
  const plain = await open(browser, "run", JSON.stringify(sampleRun({ radius: 60, end: 1200, fibres: false })));
  assert.equal(await plain.page.locator("input[name=fibres]").count(), 0);
  assert.equal(await plain.page.getByText("Fibre strain").count(), 0);
  await plain.page.locator(".stage").focus();
  await plain.page.keyboard.press("b");
  assert.deepEqual(plain.errors, []);
  await browser.close();
});
