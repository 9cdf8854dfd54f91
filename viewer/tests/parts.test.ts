/** The parts of the pages that need no browser. */
import assert from "node:assert/strict";
import { test } from "node:test";
import { protrusionRows, tracks } from "../sample/life";
import { pack, random } from "../sample/pack";
import { sampleStudy } from "../sample/study";
import { unpack, valueAt } from "../src/embedded";
import { nameOf } from "../src/live/scenario";
import { travelled, travelledText } from "../src/live/results";
import { addTracks, noTracks } from "../src/live/scene";
import { pretty, pText, readable, roundStep, stars, ticks, timeText } from "../src/numbers";
import { Camera } from "../src/run/camera";
import { Clock } from "../src/run/clock";
import { placeAt } from "../src/run/frames";
import { speeds } from "../src/run/plots";
import { bars } from "../src/run/timeline";
import { brackets, sign, starsNote, story } from "../src/study/brackets";
import { grid } from "../src/study/groups";

test("numbers as people read them", () => {
  assert.equal(readable(0.74524), "0.7452");
  assert.equal(readable(-12.3456, 3), "\u221212.3");
  assert.equal(readable(9.55e-5), "9.55e\u22125");
  assert.equal(readable(null), "\u2013");
  assert.equal(timeText(21600), "6 h 00 min");
  assert.equal(timeText(95), "1 min 35 s");
  assert.equal(pText(0.00001), "p < 0.0001");
  assert.deepEqual([0.2, 0.04, 0.004, 0.0004].map(stars), ["n.s.", "*", "**", "***"]);
  assert.equal(roundStep(0.021), 0.05);
  assert.deepEqual(ticks(-1, 1, 4), [-1, -0.5, 0, 0.5, 1]);
});

test("units as they are printed", () => {
  assert.equal(pretty("4.1 and 9.3 um/h, 30 um^2, v_um_per_h"), "4.1 and 9.3 \u00b5m/h, 30 \u00b5m\u00b2, v_um_per_h");
});

test("laws are called by the first clause of their meaning", () => {
  const name = (meaning: string, unit: string, ...names: string[]) => nameOf({ path: "", formula: "", meaning, unit, arguments: names });
  assert.equal(
    name("Eq. 7: rate at which an adhesion disassembles. Arguments: F: force of the adhesion, 0 to 10 nN; t: time since contraction began, 0 to 100000 s", "1/s", "F", "t"),
    "Eq. 7: rate at which an adhesion disassembles (F, t), 1/s",
  );
  assert.equal(name("Where along the cortex protrusions begin: the rate is multiplied by bias / mean bias, so the total", "", "angle"), "Where along the cortex protrusions begin (angle)");
  assert.equal(name("Rate [1/s] of degradation around the body; around its rear times body_rear_share", "1/s", "f", "p"), "Rate [1/s] of degradation around the body (f, p), 1/s");
  assert.equal(name("Rate of 0.5 a turn", "", "angle"), "Rate of 0.5 a turn (angle)");
});

test("place of a time among frames", () => {
  assert.deepEqual(placeAt([0, 300, 600], -5), { frame: 0, next: 0, fraction: 0 });
  assert.deepEqual(placeAt([0, 300, 600], 450), { frame: 1, next: 2, fraction: 0.5 });
  assert.deepEqual(placeAt([0, 300, 600], 601), { frame: 2, next: 2, fraction: 0 });
  assert.deepEqual(placeAt([0], 7), { frame: 0, next: 0, fraction: 0 });
});

test("a clock forgets who is gone", () => {
  const clock = new Clock(100, [0, 50, 100]);
  const gone = new AbortController();
  let told = 0;
  clock.onChange(() => ++told, gone.signal);
  clock.set(10);
  gone.abort();
  clock.set(20);
  assert.equal(told, 1);
  assert.equal(clock.listening, 0);
});

test("a clock with a loop begins anew at its end, one without stops there", () => {
  const queued: FrameRequestCallback[] = [];
  const before = globalThis.requestAnimationFrame;
  globalThis.requestAnimationFrame = (tick) => queued.push(tick);
  try {
    for (const loop of [true, false]) {
      const clock = new Clock(100, [0, 50, 100]);
      clock.loop = loop;
      clock.speed = 1e6;
      clock.toggle();
      queued.shift()!(performance.now() + 50);
      assert.equal(clock.time, loop ? 0 : 100);
      assert.equal(clock.playing, loop);
      assert.equal(queued.length, loop ? 1 : 0);
      queued.length = 0;
    }
  } finally {
    globalThis.requestAnimationFrame = before;
  }
});

test("zoom keeps the point under the pointer", () => {
  const camera = new Camera({ left: -150, right: 150, bottom: -150, top: 150 });
  camera.resize(800, 600);
  camera.show(camera.whole);
  const at = (sx: number, sy: number) => [camera.x + (sx - 400) / camera.scale, camera.y - (sy - 300) / camera.scale];
  const before = at(700, 100);
  camera.zoom(2, 700, 100);
  at(700, 100).forEach((v, i) => assert.ok(Math.abs(v - before[i]) < 1e-9));
});

test("phases of a protrusion join without gaps, and go on to the end of the run", () => {
  const end = 21600;
  for (const row of protrusionRows(random(3), end)) {
    const all = bars(row, end);
    all.forEach((bar, i) => {
      if (i > 0) assert.equal(bar.from, all[i - 1].to);
    });
    assert.equal(all.at(-1)?.to, row.t_end_s ?? end);
  }
});

test("speed of a straight walk", () => {
  const made = tracks(random(1), 3600, []);
  made.x_um = made.t_s.map((t) => (12 * t) / 3600);
  made.y_um = made.t_s.map(() => 0);
  for (const v of speeds(made).v) assert.ok(Math.abs(v - 12) < 1e-9);
});

test("brackets of significance never overlap", () => {
  const study = sampleStudy();
  const made = grid(study, 0);
  assert.equal(made.groups.length, 10);
  const found = brackets(study.tests, made, "n_protrusions", "all");
  assert.equal(found.length, study.tests.filter((t) => t.readout === "n_protrusions").length);
  for (const a of found)
    for (const b of found) if (a !== b && a.level === b.level) assert.ok(a.to <= b.from || b.to <= a.from);
  assert.equal(brackets(study.tests, made, "n_protrusions", "none").length, 0);
});

test("stars follow p after Holm's correction, and need three runs at each point", () => {
  const study = sampleStudy();
  const made = grid(study, 0);
  const one = study.tests[0];
  const shown = (change: Partial<typeof one>) => {
    const test = { ...one, p: 0.02, p_holm: 0.02, n_a: 3, n_b: 3, ...change };
    return { drawn: brackets([test], made, one.readout, "significant").length === 1, sign: sign(test) };
  };
  assert.deepEqual(shown({}), { drawn: true, sign: "*" });
  assert.deepEqual(shown({ p_holm: 0.06 }), { drawn: false, sign: "n.s." });
  assert.deepEqual(shown({ p: 0.0001, p_holm: 0.004 }), { drawn: true, sign: "**" });
  assert.deepEqual(shown({ n_b: 2 }), { drawn: false, sign: "n < 3" });
  assert.deepEqual(shown({ p: null, p_holm: null }), { drawn: false, sign: "n.s." });
  const words = story({ ...one, p: 0.042, p_holm: 0.083, n_a: 2, n_b: 5 }, made, "um/h").join("\n");
  for (const part of ["t-test: p = 0.042, t = ", "Holm's correction: p = 0.083", "n = 2 and 5: too few", "\u00b5m/h"])
    assert.ok(words.includes(part), words);
});

test("a caption counts the comparisons that have a p, and names no stars where there can be none", () => {
  const study = sampleStudy();
  const readout = study.readouts[0].name;
  const tests = study.tests.filter((t) => t.readout === readout).slice(0, 4);
  assert.match(starsNote(tests, readout), /over 4 comparisons\.$/);
  tests[0] = { ...tests[0], p: null, p_holm: null };
  assert.match(starsNote(tests, readout), /over 3 comparisons\.$/);
  assert.match(starsNote(tests.slice(0, 2), readout), /over 1 comparison\.$/);
  assert.equal(starsNote(tests.slice(0, 1), readout), "");
  assert.equal(starsNote(tests.map((t) => ({ ...t, n_a: 2 })), readout), "");
});

// Packed arrays come back as they were, and broken ones are named.

const frames = [
  [-163.8, 0, 1.234, 163.8],
  [163.8, -0.005, 1.24, -163.8],
  [0, 0.3, -1, 2],
];

for (const delta of [false, true])
  test(`int16 ${delta ? "as differences, which wrap" : "as it is"}`, async () => {
    const field = await unpack(pack(frames, { type: "int16", components: 2, scale: 0.005, offset: 0, delta }), "x", 3);
    assert.equal(field.stride, 4);
    frames.forEach((frame, k) =>
      frame.forEach((v, i) => assert.ok(Math.abs(valueAt(field, k, i) - v) <= 0.0025 + 1e-9)),
    );
  });

test("uint8 is clamped to its limits and wraps as differences", async () => {
  const given = [
    [-60, 60, 0],
    [60, -60, 1000],
    [-1000, 3, 60],
  ];
  const field = await unpack(
    pack(given, { type: "uint8", components: 1, scale: 120 / 255, offset: -60, delta: true }),
    "pressure",
    3,
  );
  given.forEach((frame, k) =>
    frame.forEach((v, i) =>
      assert.ok(Math.abs(valueAt(field, k, i) - Math.min(60, Math.max(-60, v))) <= 60 / 255 + 1e-9),
    ),
  );
});

test("bytes of an int16 frame: all low ones, then all high ones", async () => {
  // zlib stream of 01 03 02 04: q = 0x0201, 0x0403
  const { deflateSync } = await import("node:zlib");
  const data = deflateSync(Uint8Array.from([0x01, 0x03, 0x02, 0x04])).toString("base64");
  const field = await unpack(
    { type: "int16", components: 1, per_frame: 2, scale: 1, offset: 0, delta: false, data },
    "x",
    1,
  );
  assert.deepEqual([...field.q], [0x0201, 0x0403]);
});

test("what is broken is named", async () => {
  const good = pack(frames, { type: "int16", components: 2, scale: 1, offset: 0, delta: false });
  await assert.rejects(unpack(good, "outline", 4), /outline: has 24 bytes instead of 32/);
  await assert.rejects(unpack({ ...good, data: "AAAA" }, "outline", 3), /outline: cannot be unpacked/);
});

// Distance and speed from the start, as the live page says them.

const row = (t: number, x: number, y: number, cell?: number): [number, ...number[]] => [t, x, y, 0, 0, 0, 0, ...(cell === undefined ? [] : [cell])];
const walked = (rows: number[][]) => {
  const tracks = noTracks();
  addTracks(tracks, rows as Parameters<typeof addTracks>[1]);
  return tracks;
};

test("distance and speed from the start, at the time that is shown", () => {
  const tracks = walked([row(0, 5, 5), row(1800, 5, 9), row(3600, 8, 9), row(7200, 8, 5)]);
  assert.deepEqual(travelled(tracks, 3600), { net: 5, path: 7, speed: 5 });
  assert.deepEqual(travelled(tracks, 3700), { net: 5, path: 7, speed: 5 }, "the last row counts");
  assert.deepEqual(travelled(tracks, 7200), { net: 3, path: 11, speed: 1.5 });
  assert.equal(travelledText(tracks, 7200), "3 \u00b5m from the start, 1.5 \u00b5m/h; path 11 \u00b5m");
});

test("no speed before ten minutes, and nothing without tracks", () => {
  assert.deepEqual(travelled(walked([row(0, 0, 0), row(599, 1, 0)]), 599), { net: 1, path: 1 });
  assert.deepEqual(travelled(walked([row(0, 0, 0), row(600, 1, 0)]), 600), { net: 1, path: 1, speed: 6 });
  assert.deepEqual(travelled(noTracks(), 100), { net: 0, path: 0 });
});

test("of several cells the distances of the first ones", () => {
  const tracks = walked([0, 3600].flatMap((t) => [1, 2, 3, 4, 5].map((k) => row(t, (k * t) / 3600, 0, k))));
  assert.equal(travelledText(tracks, 3600, 2), "From the start: 1, 2 \u00b5m and 3 more");
});
