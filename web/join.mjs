// Puts the core and the script around it into the page, which makes a worker of them: one file that opens by double click.
//   node join.mjs live.html core_worker.js live_worker.js NOTICES OUTPUT
import { readFileSync, writeFileSync } from "node:fs";
import { deflateSync } from "node:zlib";

const [page, core, worker, notices, output] = process.argv.slice(2);
const put = (html, id, text) => {
  const marker = `<script type="text/plain" id="${id}"></script>`;
  if (!html.includes(marker)) throw new Error(`${page} has no place for ${id}`);
  return html.replace(marker, () => marker.replace("></", () => `>${text}</`));
};
// What would end or open a script element inside of one.
const code = `${readFileSync(core, "utf8")}\n${readFileSync(worker, "utf8")}`;
if (/<\/script|<!--/i.test(code)) throw new Error("the code would end its element");
const [version, ...terms] = readFileSync(notices, "utf8").split("\n");
const about = `${version}\n${deflateSync(terms.join("\n"), { level: 9 }).toString("base64")}`;
writeFileSync(output, put(put(readFileSync(page, "utf8"), "matrigrate-core", code), "matrigrate-notices", about));
