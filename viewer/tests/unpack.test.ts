/** Packed arrays come back as they were, and broken ones are named. */
import assert from "node:assert/strict";
import { test } from "node:test";
import { pack } from "../sample/pack";
import { unpack, valueAt } from "../src/unpack";

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
