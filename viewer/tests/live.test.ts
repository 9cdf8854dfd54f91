/** The live page without its simulation: the film that grows, and scenarios in addresses and files. */
import assert from "node:assert/strict";
import { test } from "node:test";
import { exported } from "../src/live/export";
import { LiveFilm } from "../src/live/film";
import type { CoreFrame, Head } from "../src/live/protocol";
import { drawnFiles, fresh, fromHash, given, now, pascals, toHash, type Scenario } from "../src/live/scenario";
import { valueAt } from "../src/unpack";

const head: Head = {
  t_s: 0,
  step: 0,
  done: false,
  radius_um: 150,
  spacing_um: 2,
  n_particles: 2,
  n_outline: 3,
  duration_s: 21600,
  time_step_s: 5,
  changed: [],
  bonds_um: [],
  obstacles_um: [],
  onset: 0,
};

const moment = (t: number): CoreFrame => ({
  t_s: t,
  displacement: Float32Array.of(t / 1000, 0, 0, 0),
  f: Uint8Array.of(255, 51),
  pressure: Float32Array.of(1, -2),
  vonMises: Float32Array.of(3, 4000),
  outline: Float32Array.of(0, 0, 1, 0, 0, 1),
  front: Uint8Array.of(1, 1, 0),
  protrusionOf: Uint8Array.of(0, 255, 255),
  fMat: Float32Array.of(0.1, 0.2, 0.3),
  force: Float32Array.of(0.5, 0, 0),
  ids: Float32Array.of(7),
  centres: Float32Array.of(0),
  phases: Uint8Array.of(2),
  anchors: Float32Array.of(NaN, NaN),
  fMats: Float32Array.of(0.9),
  forces: Float32Array.of(0),
});

test("a film that grows keeps the newest moments and evenly spaced old ones, in the same memory", () => {
  const live = new LiveFilm(head, Float32Array.of(10, 20, -30, -40));
  const bytes = live.film.x.q.byteLength;
  for (let t = 0; t <= 100_000; t += 10) {
    live.add(moment(t));
    const { times } = live.film;
    assert.equal(times[0], 0);
    assert.equal(times[times.length - 1], t);
    assert.ok(times.length <= 102);
    assert.equal(live.film.protrusions.length, times.length);
  }
  assert.equal(live.film.x.q.byteLength, bytes);
  const { times, x } = live.film;
  assert.ok(times.length > 45);
  assert.deepEqual(times.slice(-5), [99960, 99970, 99980, 99990, 100000]);
  const gaps = times.slice(1, -6).map((t, k) => t - times[k]);
  assert.ok(Math.max(...gaps) <= 2 * Math.min(...gaps), `${gaps}`);
  times.forEach((t, k) => assert.ok(Math.abs(valueAt(x, k, 0) - 10 - t / 1000) < 0.01, `${t} s`));
  assert.equal(live.film.protrusions[0][0].anchor, null);
  assert.ok(Math.abs(valueAt(live.film.vonMises, 0, 1) - 4000) < 1);
});

test("a film that was kept is the same again, and grows on", () => {
  const live = new LiveFilm(head, Float32Array.of(10, 20, -30, -40));
  for (let t = 0; t <= 900; t += 10) live.add(moment(t));
  const again = new LiveFilm(head, Float32Array.of(10, 20, -30, -40));
  again.restore(structuredClone(live.image()));
  for (const film of [live, again]) for (let t = 900; t <= 2000; t += 10) film.add(moment(t));
  assert.deepEqual(again.image(), live.image());
});

const drawn: Scenario = {
  ...fresh(["ecm.youngs_modulus=100 Pa"], "7"),
  strokes: [
    { kind: "hole", radius: 6, points: [0, 30, 20, 30] },
    { kind: "soft", radius: 10, points: [-40, 0] },
  ],
  changes: [{ t: 600, overrides: ["actomyosin.force=1 nN"] }],
};

test("an address carries a scenario, and says what is wrong with it", () => {
  assert.deepEqual(fromHash(toHash(drawn)), { ...drawn, changes: [] });
  assert.deepEqual(fromHash(toHash({ ...drawn, toml: 'a = "\u00b5"' }))?.toml, 'a = "\u00b5"');
  assert.equal(fromHash(""), null);
  assert.equal(fromHash("#t=3"), null);
  assert.throws(() => fromHash("#scenario=AAAA"), /cannot be read/);
  assert.throws(() => fromHash(`#scenario=${btoa('{"v":2}')}`), /version is 2/);
  assert.throws(() => fromHash(`#scenario=${btoa('{"v":1,"draw":[["x",1,2,3]]}')}`), /drawn in it cannot be read/);
});

test("what is drawn becomes grids with a node at each particle", () => {
  const files = drawnFiles(drawn.strokes, { youngs_modulus: 100, radius: 150, spacing: 2 });
  const at = (file: string, x: number, y: number) =>
    files[file].split("\n").find((line) => line.startsWith(`${x},${y},`))?.split(",")[2];
  assert.equal(files["f_degr.csv"].trim().split("\n").length, 1 + 151 * 151);
  assert.equal(at("f_degr.csv", 10, 34), "0");
  assert.equal(at("f_degr.csv", 10, 38), "1");
  assert.equal(at("youngs_modulus.csv", -40, 8), "25");
  assert.equal(at("youngs_modulus.csv", -40, 12), "100");
  const { overrides } = given(drawn, { youngs_modulus: 100, radius: 150, spacing: 2 });
  assert.ok(overrides.includes("ecm.fields.f_degr=/f_degr.csv"));
  assert.equal(now(drawn)["actomyosin.force"], "1 nN");
  assert.deepEqual([pascals("0.2 kPa"), pascals("50 Pa"), pascals("7")], [200, 50, 7]);
});

test("an export names its files beside it, and says the commands", () => {
  const toml = 'youngs_modulus = "/youngs_modulus.csv hash=0123456789abcdef"\nf_degr = "/f_degr.csv hash=00"\n';
  const all = exported(drawn, toml, { "f_degr.csv": "x" });
  assert.deepEqual(Object.keys(all), ["scenario.toml", "f_degr.csv"]);
  assert.match(all["scenario.toml"], /youngs_modulus = "youngs_modulus\.csv"\nf_degr = "f_degr\.csv"/);
  assert.match(all["scenario.toml"], /resume live --at '600 s' --set 'actomyosin\.force=1 nN' -o live-1/);
});
