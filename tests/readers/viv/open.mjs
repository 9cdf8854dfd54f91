// fields.ome.tif of run.sh's run in Viv's loader: order of the dimensions, channels, scale, and the numbers of fields.h5 at
// some pixels, which field_pixels.py writes. open.mjs PICTURE PIXELS.json
import { loadOmeTiff } from "@vivjs/loaders";
import { DOMParser } from "@xmldom/xmldom";
import assert from "node:assert";
import fs from "node:fs";
import http from "node:http";

globalThis.DOMParser = DOMParser; // a browser has one
const file = fs.readFileSync(process.argv[2]);
const pixels = JSON.parse(fs.readFileSync(process.argv[3], "utf8"));

const server = http.createServer((request, response) => { // the loader asks for ranges of bytes, as of a file on the web
  const range = /^bytes=(\d+)-(\d+)$/.exec(request.headers.range ?? "");
  if (!range) return response.writeHead(200, { "content-length": file.length }).end(request.method === "HEAD" ? "" : file);
  const [first, last] = [Number(range[1]), Math.min(Number(range[2]), file.length - 1)];
  response.writeHead(206, { "content-range": `bytes ${first}-${last}/${file.length}` }).end(file.subarray(first, last + 1));
});
await new Promise((listening) => server.listen(0, "127.0.0.1", listening));
try {
  const { data, metadata } = await loadOmeTiff(`http://127.0.0.1:${server.address().port}/fields.ome.tif`);
  assert.strictEqual(data.length, 1);
  const [source] = data;
  assert.deepStrictEqual(source.labels, ["t", "c", "z", "y", "x"]);
  assert.deepStrictEqual(source.shape, [6, 8, 1, 60, 60]);
  assert.strictEqual(source.dtype, "Float32");
  assert.deepStrictEqual(source.meta.physicalSizes, { x: { size: 2, unit: "µm" }, y: { size: 2, unit: "µm" } });
  assert.strictEqual(metadata.Pixels.DimensionOrder, "XYZCT");
  const names = metadata.Pixels.Channels.map((channel) => channel.Name);
  assert.deepStrictEqual(names, ["displacement_x [um]", "displacement_y [um]", "velocity_x [um/s]", "velocity_y [um/s]",
    "f_degr", "pressure [Pa]", "von_mises [Pa]", "cell"]);
  assert.ok(pixels.length >= 30, `${pixels.length} pixels`);
  for (const [t, name, row, column, value] of pixels) {
    const { data: numbers, width } = await source.getRaster({ selection: { t, z: 0, c: names.indexOf(name) } });
    assert.strictEqual(numbers[row * width + column], Math.fround(value), `${name}, frame ${t}, row ${row}, column ${column}`);
  }
  const { data: beyond } = await source.getRaster({ selection: { t: 0, z: 0, c: 0 } });
  assert.ok(Number.isNaN(beyond[0]));
  console.log(`Viv's loader: ${names.length} channels, ${pixels.length} pixels`);
} finally {
  server.close();
  server.closeAllConnections();
}
