/** The live page without its simulation: the film that grows, and scenarios in addresses and files. */
import assert from "node:assert/strict";
import { test } from "node:test";
import { unable } from "../src/live/troubles";
import { paceText } from "../src/live/bar";
import { thinned } from "../src/live/curves";
import { exported } from "../src/live/keep";
import { LiveFilm, type FilmImage } from "../src/live/film";
import type { CoreFrame, Head, TrackRow } from "../src/live/protocol";
import { drawnFiles, fresh, fromHash, given, now, pascals, toHash, type Scenario, type StrokeKind } from "../src/live/scenario";
import { csv, resultsOf } from "../src/live/results";
import { addTracks, noTracks } from "../src/live/scene";
import { tracksOfCells } from "../src/run/cells";
import { extremes, layers } from "../src/run/matrix/layers";
import { valueAt } from "../src/embedded";

const head: Head = {
  t_s: 0,
  done: false,
  radius_um: 150,
  spacing_um: 2,
  n_particles: 2,
  n_outline: 3,
  n_nucleus: 0,
  duration_s: 21600,
  changed: [],
  bonds_um: [],
  obstacles_um: [],
  onset: 0,
  attractant: false,
};

/** All that is kept of a film. */
const imageOf = (live: LiveFilm): FilmImage => ({ ...live.index(), moments: live.film.times.map((_, k) => live.moment(k)) });

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
  const live = new LiveFilm(head, { reference: Float32Array.of(10, 20, -30, -40) });
  const bytes = live.film.x.q.byteLength;
  for (let t = 0; t <= 100_000; t += 10) {
    live.add(moment(t));
    const { times } = live.film;
    assert.equal(times[0], 0);
    assert.equal(times[times.length - 1], t);
    assert.ok(times.length <= 102);
    assert.equal(live.film.protrusions.length, times.length);
    assert.equal(live.unsaved.size, times.length);
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

test("a stiffness that was drawn is a layer, the same at all times; where it is uniform there is none", () => {
  const reference = Float32Array.of(10, 20, -30, -40);
  assert.deepEqual(new LiveFilm(head, { reference }).film.layers, []);
  const drawn = (...E: number[]) => [{ name: "youngs_modulus", unit: "Pa", title: "Young's modulus", meaning: "", values: Float32Array.of(...E) }];
  const live = new LiveFilm(head, { reference, layers: drawn(50, 200) });
  for (const t of [0, 10, 20]) live.add(moment(t));
  const layer = layers(live.film).find(({ key }) => key === "youngs_modulus")!;
  assert.deepEqual([layer.low, layer.high], [50, 200]);
  for (const frame of [0, 1, 2]) assert.deepEqual([0, 1].map((i) => valueAt(layer.field!, frame, i)), [50, 200]);
  assert.deepEqual(extremes(live.film, layer, 2), { low: 50, high: 200 });
  live.setMatrix({ reference, layers: drawn(100, 400) });
  assert.deepEqual([0, 1].map((i) => valueAt(live.film.layers[0].field, 2, i)), [100, 400]);
});

test("a film that was kept is the same again, and grows on", () => {
  const live = new LiveFilm(head, { reference: Float32Array.of(10, 20, -30, -40) });
  for (let t = 0; t <= 900; t += 10) live.add(moment(t));
  const again = new LiveFilm(head, { reference: Float32Array.of(10, 20, -30, -40) });
  again.restore(structuredClone(imageOf(live)));
  for (const film of [live, again]) for (let t = 900; t <= 2000; t += 10) film.add(moment(t));
  const { id, ...kept } = imageOf(live);
  const { id: other, ...taken } = imageOf(again);
  assert.deepEqual(taken, kept);
  assert.notEqual(other, id, "two tabs that go on with one film do not write over each other's moments");
  assert.deepEqual(new Set(again.film.times), again.unsaved);
});

/** Two cells with nuclei, each of them once moved: the second one's protrusion is at its own particle 1. */
const pair: Head = { ...head, n_outline: 6, n_nucleus: 4, cell: [1, 1, 1, 2, 2, 2] };
const ofPair = (t: number): CoreFrame => ({
  ...moment(t),
  outline: Float32Array.of(0, 0, 1, 0, 0, 1, 20, 0, 21, 0, 20, 1),
  front: Uint8Array.of(1, 1, 0, 0, 0, 1),
  protrusionOf: Uint8Array.of(0, 255, 255, 255, 1, 255),
  fMat: new Float32Array(6),
  force: new Float32Array(6),
  nucleus: Float32Array.of(0.1, 0.2, 0.3, 0.2, 20.1, 0.2, 20.3, 0.2),
  cells: Float32Array.of(1, 2),
  ids: Float32Array.of(7, 7),
  centres: Float32Array.of(0, 1),
  phases: Uint8Array.of(2, 0),
  anchors: Float32Array.of(NaN, NaN, NaN, NaN),
  fMats: Float32Array.of(0.9, 0),
  forces: Float32Array.of(0, 0),
});

test("a film has the nuclei and the points of all cells, and none of them where there is one cell without", () => {
  const live = new LiveFilm(pair, { reference: Float32Array.of(10, 20, -30, -40) });
  for (const t of [0, 10]) live.add(ofPair(t));
  const again = new LiveFilm(pair, { reference: Float32Array.of(10, 20, -30, -40) });
  again.restore(structuredClone(imageOf(live)));
  for (const { film } of [live, again]) {
    assert.deepEqual(film.cells, [
      { number: 1, first: 0, end: 3 },
      { number: 2, first: 3, end: 6 },
    ]);
    assert.equal(film.nucleus?.stride, 8);
    assert.ok(Math.abs(valueAt(film.nucleus!, 1, 6) - 20.3) < 0.01);
    assert.ok(Math.abs(valueAt(film.outline.x, 1, 8) - 21) < 0.01);
    assert.deepEqual(film.protrusions[1].map(({ cell, centre }) => [cell, centre]), [[1, 0], [2, 4]]);
  }
  const one = new LiveFilm(head, { reference: Float32Array.of(10, 20, -30, -40) });
  one.restore(imageOf(live)); // of another simulation: nothing is taken over
  assert.deepEqual(one.film.times, []);
  one.add(moment(0));
  assert.equal(one.film.nucleus, null);
  assert.equal(one.film.cells.length, 1);
  assert.deepEqual(Object.keys(one.film.protrusions[0][0]), ["id", "phase", "centre", "anchor", "f_mat", "force_nN"]);
});

test("tracks of several cells are told apart, also once they have grown", () => {
  const row = (t: number, x: number, cell?: number): TrackRow => (cell ? [t, x, 0, 700, 95, null, 0, cell] : [t, x, 0, 700, 95, null, 0]);
  const tracks = noTracks();
  addTracks(tracks, [row(0, 1, 1), row(0, 2, 2), row(60, 3, 1), row(60, 4, 2)]);
  assert.deepEqual(tracksOfCells(tracks).map(({ tracks: own }) => own.x_um), [[1, 3], [2, 4]]);
  addTracks(tracks, [row(60, 5, 1), row(60, 6, 2), row(120, 7, 1), row(120, 8, 2)]);
  assert.deepEqual(tracksOfCells(tracks).map(({ tracks: own }) => own.x_um), [[1, 3, 7], [2, 4, 8]]);
  const single = noTracks();
  addTracks(single, [row(0, 1), row(60, 2), row(60, 3)]);
  assert.deepEqual(single.x_um, [1, 2]);
  assert.equal(single.cell, undefined);
});

const drawn: Scenario = {
  ...fresh(["ecm.youngs_modulus=100 Pa"], "7"),
  strokes: [
    { kind: "hole", radius: 6, points: [0, 30, 20, 30] },
    { kind: "soft", radius: 10, points: [-40, 0] },
  ],
  changes: [{ t: 600, overrides: ["actomyosin.force=1 nN"] }],
};

const ground = { youngs_modulus: 100, radius: 150, spacing: 2, set: {} };

test("an address carries a scenario, and says what is wrong with it", () => {
  assert.deepEqual(fromHash(toHash(drawn)), { ...drawn, changes: [] });
  assert.deepEqual(fromHash(toHash({ ...drawn, toml: 'a = "\u00b5"' }))?.toml, 'a = "\u00b5"');
  assert.equal(fromHash(""), null);
  assert.equal(fromHash("#t=3"), null);
  const whole = toHash(drawn);
  for (const broken of ["#scenario=AAAA", "#scenario=%%%", whole.slice(0, -5), `${whole.slice(0, 30)}xx${whole.slice(32)}`, `#scenario=${btoa("null")}`, `#scenario=${btoa('{"v":1,"draw":3}')}`])
    assert.throws(() => fromHash(broken), /cannot be read: a part of it is missing or was changed; copy the whole link once more\.$/, broken);
  assert.throws(() => fromHash(`#scenario=${btoa('{"v":2}')}`), /version is 2/);
  assert.throws(() => fromHash(`#scenario=${btoa('{"v":1,"draw":[["x",1,2,3]]}')}`), /drawn in it cannot be read/);
});

test("what is drawn becomes grids with a node at each particle", () => {
  const files = drawnFiles(drawn.strokes, ground);
  const at = (file: string, x: number, y: number) =>
    files[file].split("\n").find((line) => line.startsWith(`${x},${y},`))?.split(",")[2];
  assert.equal(files["f_degr.csv"].trim().split("\n").length, 1 + 151 * 151);
  assert.equal(at("f_degr.csv", 10, 34), "0");
  assert.equal(at("f_degr.csv", 10, 38), "1");
  assert.equal(at("youngs_modulus.csv", -40, 8), "25");
  assert.equal(at("youngs_modulus.csv", -40, 12), "100");
  const { overrides } = given(drawn, ground);
  assert.ok(overrides.includes("ecm.fields.f_degr=/f_degr.csv"));
  assert.equal(now(drawn)["actomyosin.force"], "1 nN");
  assert.deepEqual([pascals("0.2 kPa"), pascals("50 Pa"), pascals("7")], [200, 50, 7]);
});

test("ligand and a source of attractant are drawn, with what the cell needs to sense them", () => {
  const stroke = (kind: StrokeKind, x: number) => ({ kind, radius: 6, points: [x, 0] });
  const scenario: Scenario = { ...fresh(), strokes: [stroke("rich", 40), stroke("bare", -40), stroke("attractant", 80)] };
  const { files, overrides } = given(scenario, { ...ground, set: { "cues.diffusion": "20 um^2/s" } });
  assert.deepEqual(Object.keys(files).sort(), ["attractant_source.csv", "ligand.csv"]);
  const at = (file: string, x: number) => files[file].split("\n").find((line) => line.startsWith(`${x},0,`))?.split(",")[2];
  assert.deepEqual([0, 40, -40].map((x) => at("ligand.csv", x)), ["1", "2", "0"]);
  assert.deepEqual([0, 80].map((x) => at("attractant_source.csv", x)), ["0", "0.1"]);
  assert.ok(overrides.includes("ecm.fields.attractant_source=/attractant_source.csv") && overrides.includes("laws.initiation_bias=exp(4*ligand) * exp(20*occupancy)"));
  assert.ok(!overrides.some((one) => one.startsWith("cues.diffusion")), "what the scenario sets stays");
  assert.deepEqual(fromHash(toHash(scenario))?.strokes, scenario.strokes);
});

test("attractant is a layer of the film where there is any", () => {
  const live = new LiveFilm({ ...head, attractant: true }, { reference: Float32Array.of(10, 20, -30, -40) });
  for (const t of [0, 10]) live.add({ ...moment(t), attractant: Float32Array.of(0.25, t / 5) });
  const layer = layers(live.film).find(({ key }) => key === "attractant")!;
  assert.deepEqual([layer.low, layer.high], [0, 1]);
  assert.ok(Math.abs(valueAt(layer.field!, 1, 0) - 0.25) < 0.002 && Math.abs(valueAt(layer.field!, 1, 1) - 2) < 0.002);
  assert.equal(new LiveFilm(head, { reference: Float32Array.of(10, 20, -30, -40) }).film.attractant, null);
});

test("the pace is told in words that fit", () => {
  assert.equal(paceText(180), ", 180 times faster than life: 6 h take 2 min");
  assert.equal(paceText(6), ", 6 times faster than life: 6 h take 1 h 00 min");
  assert.equal(paceText(720), ", 720 times faster than life: 6 h take 30 s");
});

test("without WebAssembly, or without its SIMD, the reason is told", () => {
  const { validate } = WebAssembly;
  assert.equal(unable(), null);
  try {
    WebAssembly.validate = () => false;
    assert.match(unable() ?? "", /no WebAssembly SIMD.*Safari 16\.4/);
  } finally {
    WebAssembly.validate = validate;
  }
});

test("a long line is drawn with no more points than can be seen, and to its end", () => {
  const t = Array.from({ length: 3480 }, (_, i) => 60 * i);
  const line = thinned({ t, v: t.map((s) => s / 2) });
  assert.ok(line.t.length <= 1001 && line.t.length > 800);
  assert.deepEqual([line.t[0], line.t[1], line.t[line.t.length - 1]], [0, 240, 60 * 3479]);
  assert.deepEqual(line.v, line.t.map((s) => s / 2));
  const short = { t: [0, 60], v: [1, 2] };
  assert.deepEqual(thinned(short), short);
});

test("an export names its files beside it, and says the commands", () => {
  const toml = 'youngs_modulus = "/youngs_modulus.csv hash=0123456789abcdef"\nf_degr = "/f_degr.csv hash=00"\n';
  const all = exported(drawn, toml, { "f_degr.csv": "x" });
  assert.deepEqual(Object.keys(all), ["scenario.toml", "f_degr.csv"]);
  assert.match(all["scenario.toml"], /youngs_modulus = "youngs_modulus\.csv"\nf_degr = "f_degr\.csv"/);
  assert.match(all["scenario.toml"], /resume live --at '600 s' --set 'actomyosin\.force=1 nN' -o live-1/);
});

test("a table of results has a row for each cell of a run, and is read by other programs", () => {
  const tracks = noTracks();
  addTracks(tracks, [[0, 0, 0, 0, 0, null, 0], [3600, 3, 4, 0, 0, null, 0], [7200, 6, 8, 0, 0, null, 0]] as TrackRow[]);
  const settings = { "ecm.youngs_modulus": '"0.05 kPa"', "run.seed": "7", "run.duration": "2 h", "fibres.arrangement": '"uniaxial"' };
  const rows = resultsOf(tracks, 7200, settings, ['at 1 h: x = "2", y']);
  assert.deepEqual(rows, [{ E_Pa: 50, seed: 7, cell: "", time_h: 2, distance_um: 10, speed_um_per_h: 5, other: 'fibres.arrangement = uniaxial; at 1 h: x = "2", y' }]);
  assert.equal(csv(rows), 'E_Pa,seed,cell,time_h,distance_um,speed_um_per_h,other\n50,7,,2,10,5,"fibres.arrangement = uniaxial; at 1 h: x = ""2"", y"\n');
  assert.deepEqual(resultsOf(tracks, 7200, {}).map(({ E_Pa, seed }) => [E_Pa, seed]), [[200, 1]]);
  const pair = noTracks();
  addTracks(pair, [1, 2].flatMap((cell) => [0, 7200].map((t) => [t, cell * t, 0, 0, 0, null, 0, cell])) as TrackRow[]);
  assert.deepEqual(resultsOf(pair, 7200, {}).map(({ cell }) => cell), [1, 2]);
});
