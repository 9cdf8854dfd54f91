/** Distance and speed from the start, as the live page says them. */
import assert from "node:assert/strict";
import { test } from "node:test";
import { addTracks, noTracks } from "../src/live/scene";
import { travelled, travelledText } from "../src/live/travelled";

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
