/** Arrows have the direction and the length of what they stand for, and are seen on any ground. */
import assert from "node:assert/strict";
import { test } from "node:test";
import { sampleRun } from "../sample/run";
import { paintArrows, paintPolarization, paintTraction, pixelsPerForce, usual } from "../src/run/over/arrows";
import { Camera } from "../src/run/camera";
import { film, outlineAt, placeAt } from "../src/run/frames";
import { layers } from "../src/run/matrix/layers";
import type { Pen } from "../src/run/over/pen";
import { isDarkGround, LayerScale } from "../src/run/matrix/scale";

const run = sampleRun({ radius: 60, interval: 600, end: 7200 });

interface Line {
  from: [number, number];
  to: [number, number];
}

/** Notes shafts (the first line of each arrow) and the colours of strokes. */
function recorder(): { pen: Pen; shafts: Line[]; strokes: string[] } {
  const [shafts, strokes]: [Line[], string[]] = [[], []];
  let last: [number, number] = [0, 0];
  let calls = 0;
  const pen = {
    strokeStyle: "",
    setLineDash: () => undefined,
    beginPath: () => undefined,
    moveTo: (x: number, y: number) => {
      last = [x, y];
    },
    lineTo: (x: number, y: number) => {
      if (calls++ % 3 === 0) shafts.push({ from: last, to: [x, y] });
    },
    stroke: () => strokes.push(pen.strokeStyle),
  };
  return { pen: pen as unknown as Pen, shafts, strokes };
}

const made = await film(run);
assert.ok(made);
const camera = new Camera({ left: -60, right: 60, bottom: -60, top: 60 });
camera.resize(600, 600);
camera.showWhole();
const frame = made.protrusions.findIndex((all) => all.filter((p) => p.force_nN > 0).length > 0);
const place = placeAt(made.times, made.times[frame]);
const scene = { film: made, place, camera, spacing: 2, dark: false, darkGround: false };

test("traction points from the anchor to the tip, as long as its force", () => {
  const from = usual(made, 1);
  const unit = pixelsPerForce(from);
  const { pen, shafts, strokes } = recorder();
  const outline = outlineAt(made, place);
  paintTraction(pen, scene, outline, unit);
  const pulling = made.protrusions[frame].filter((p) => p.force_nN > 0);
  assert.equal(shafts.length, pulling.length);
  pulling.forEach((p, k) => {
    const [dx, dy] = [shafts[k].to[0] - shafts[k].from[0], shafts[k].from[1] - shafts[k].to[1]];
    const [tx, ty] = [outline[2 * p.centre] - p.anchor![0], outline[2 * p.centre + 1] - p.anchor![1]];
    assert.ok(Math.abs(Math.hypot(dx, dy) - unit * p.force_nN) < 1e-6);
    assert.ok(Math.abs(dx * ty - dy * tx) < 1e-6 * Math.hypot(tx, ty) && dx * tx + dy * ty > 0);
  });
  assert.ok(Math.max(...made.protrusions.flat().map((p) => unit * p.force_nN)) <= 60 + 1e-9);
  assert.equal(new Set(strokes).size, 2, "a line and its edge");
});

test("arrows are light on dark layers and dark on light ones, whatever the page", () => {
  const all = layers(made);
  for (const dark of [false, true]) {
    const ground = (key: string): boolean => {
      const layer = all.find((one) => one.key === key)!;
      return isDarkGround(layer, new LayerScale(layer, made).on(dark));
    };
    assert.ok(!ground("pressure") && ground("von_mises") && ground("displacement"));
    assert.equal(ground("degradation"), dark);
  }
});

test("polarization has its angle, and none before the first protrusion", () => {
  const tracks = { ...run.tracks, polarization_rad: run.tracks.t_s.map((t) => (t < 1000 ? null : 0.5)) };
  const before = recorder();
  paintPolarization(before.pen, camera, tracks, 500, false);
  assert.equal(before.shafts.length, 0);
  const after = recorder();
  paintPolarization(after.pen, camera, tracks, 5000, false);
  const [{ from, to }] = after.shafts;
  assert.ok(Math.abs(Math.atan2(from[1] - to[1], to[0] - from[0]) - 0.5) < 1e-9);
});

test("displacement and velocity are drawn with an edge, and velocity not before anything moved", () => {
  for (const dark of [false, true])
    for (const kind of ["displacement", "velocity"] as const) {
      const { pen, shafts, strokes } = recorder();
      paintArrows(pen, { ...scene, darkGround: dark }, kind, 20);
      assert.ok(shafts.length > 5, kind);
      assert.deepEqual(strokes, dark ? ["#14171a", "#ffffff"] : ["#ffffff", "#1f2328"], "edge, then line");
    }
  const { pen, shafts } = recorder();
  paintArrows(pen, { ...scene, place: { frame: 0, next: 0, fraction: 0 } }, "velocity", 20);
  assert.equal(shafts.length, 0);
});
