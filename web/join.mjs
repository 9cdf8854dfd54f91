// Puts the core and the script around it into the page, which makes a worker of them: one file that opens by double click.
//   node join.mjs live.html core_worker.js live_worker.js OUTPUT
import { readFileSync, writeFileSync } from "node:fs";

const [page, core, worker, output] = process.argv.slice(2);
const marker = '<script type="text/plain" id="matrigrate-core"></script>';
const html = readFileSync(page, "utf8");
if (!html.includes(marker)) throw new Error(`${page} has no place for the core`);
// What would end or open a script element inside of one.
const code = `${readFileSync(core, "utf8")}\n${readFileSync(worker, "utf8")}`;
if (/<\/script|<!--/i.test(code)) throw new Error("the code would end its element");
writeFileSync(output, html.replace(marker, () => marker.replace("></", `>${code}</`)));
