// The core in Node.js: how fast it is, and whether it does what the native program does.
//   node core.mjs core_node.js [hours] [native run folder]
import { readFileSync } from "node:fs";
import { createRequire } from "node:module";
import { resolve } from "node:path";

const [script, hours = "0.5", native] = process.argv.slice(2);
const core = await createRequire(import.meta.url)(resolve(script))({});
const ask = (text) => {
  const answer = JSON.parse(text);
  if (answer.faults || answer.failure) throw new Error(text);
  return answer;
};

const wrong = JSON.parse(core.check("[ecm]\nyoungs_module = '200 Pa'\nviscosity = '-1 Pa s'\n", "[]"));
console.log("a wrong scenario:", JSON.stringify(wrong));
if (wrong.faults?.length !== 2) throw new Error("two faults were expected");
const faultOf = (toml) => JSON.parse(core.check(toml, "[]")).faults?.[0]?.message ?? "";
if (!/zeta_dis.*zeta_diss/s.test(faultOf("[laws]\ndisassembly_rate = 'r_off_min + exp(-zeta_dis*F)'\n"))) throw new Error("a wrong law is not told");
if (!/f_degr|x, y/.test(faultOf("[ecm.fields]\nf_degr = 'abs(z) < 5 ? 0 : 1'\n"))) throw new Error("a wrong formula is not told");

const settings = JSON.stringify(["run.integrator=adaptive", "run.seed=1"]);
ask(core.start("", settings, ""));
const begin = performance.now();
let now = { t_s: 0 };
while (now.t_s < 3600 * Number(hours) - 1e-6 && !now.done) now = ask(core.march(3600 * Number(hours), 1000));
const wall = (performance.now() - begin) / 1000;
console.log(`${now.t_s} s in ${wall.toFixed(1)} s, ${now.step} steps: ${(now.t_s / wall).toFixed(0)} times faster than life`);
const rows = ask(core.protrusions());
const tracks = ask(core.tracks());

// Laws: those of the paper written otherwise are the same to rounding; another one changes the run, and can come on the way.
const laws = ask(core.laws());
if (laws.length !== 14 || !laws.every(({ formula, arguments: names }) => formula && names.length > 0)) throw new Error(JSON.stringify(laws));
const reached = (changes) => {
  ask(core.start("", JSON.stringify(["run.integrator=adaptive", "run.seed=1", "ecm.fields.f_degr=abs(y) < 5 ? 0.5 : 1"]), ""));
  const marchTo = (t) => {
    for (let there = { t_s: 0 }; there.t_s < t - 1e-6; ) there = ask(core.march(t, 1000));
  };
  for (const [t, law] of changes) {
    marchTo(t);
    ask(core.change(JSON.stringify([law])));
  }
  marchTo(240);
  const { outline } = core.frame(undefined);
  return Math.max(...outline.map((x, k) => Math.hypot(x, outline[k ^ 1])));
};
const [usual, same, weaker] = [[], [[0, "laws.growth_force=(n_prot > 0 && A > 1 ? 1/A : 1) + 0"]], [[60, "laws.growth_force=0.2"]]].map(reached);
console.log(`the cell reaches out by the paper's growth, the same as a formula, and a fifth of it from 60 s on: ${usual}, ${same}, ${weaker} um`);
if (!(Math.abs(usual - same) < 1e-4) || !(weaker < usual - 1)) throw new Error("laws do not act");
ask(core.start("", settings, ""));
for (now = { t_s: 0 }; now.t_s < 3600 * Number(hours) - 1e-6 && !now.done; ) now = ask(core.march(3600 * Number(hours), 1000));

// A state that was kept goes on to the same bits.
const image = core.image();
const on = now.t_s + 60;
while (now.t_s < on - 1e-6) now = ask(core.march(on, 1000));
const [x, y] = [core.frame(undefined), now.step];
ask(core.start("", settings, image));
now = { t_s: 0 };
while (now.t_s < on - 1e-6) now = ask(core.march(on, 1000));
const again = core.frame(undefined);
for (const key of Object.keys(x))
  if (JSON.stringify(Array.from([x[key]].flat())) !== JSON.stringify(Array.from([again[key]].flat())))
    throw new Error(`${key} differs after a state was taken up`);
if (y !== now.step) throw new Error("steps differ after a state was taken up");
console.log("a state that was kept and taken up goes on to the same bits");

// The arrays of a frame that is no longer read are used again, where they fit.
const spare = core.frame(undefined);
spare.displacement.fill(7);
spare.outline = new Float32Array(3);
const used = core.frame(spare);
if (used.displacement !== spare.displacement || used.outline === spare.outline) throw new Error("arrays are not used again, or do not fit");
for (const key of Object.keys(again))
  if (JSON.stringify(Array.from([again[key]].flat())) !== JSON.stringify(Array.from([used[key]].flat()))) throw new Error(`${key} differs in arrays used again`);

// Cells with nuclei: all of them are in the frames; a single one without has none of that.
const sizes = () => {
  const { outline, nucleus, cells } = core.frame(undefined);
  return { outline: outline.length / 2, nucleus: nucleus?.length / 2, cells: cells && [...new Set(cells)] };
};
const alone = ask(core.start("", settings, ""));
if (alone.n_nucleus !== 0 || "cell" in alone || "nucleus" in core.frame(undefined) || "cells" in core.frame(undefined)) throw new Error("a nucleus or a number where there is none");
const two = ask(core.start("[nucleus]\nradius = '5 um'\n[[cells]]\nx = '-25 um'\ny = 0\n[[cells]]\nx = '25 um'\ny = 0\n[protrusion]\ninitiation_rate = '0.01 1/s'\n", settings, ""));
for (now = two; now.t_s < 120; ) now = ask(core.march(120, 1000));
const found = sizes();
console.log(`two cells with nuclei: ${JSON.stringify(found)}`);
if (found.outline !== 2 * alone.n_outline || two.n_outline !== found.outline || two.cell.length !== found.outline) throw new Error("not the outlines of both cells");
if (!(found.nucleus > 0) || found.nucleus !== two.n_nucleus) throw new Error("not the nuclei of both cells");
const numbers = (list) => [...new Set(list)].sort().join();
if (numbers(found.cells) !== "1,2" || numbers(ask(core.tracks()).map((row) => row[7])) !== "1,2" || numbers(ask(core.protrusions()).map(({ cell }) => cell)) !== "1,2")
  throw new Error("not protrusions and tracks of both cells");

if (native) {
  const table = (name) => {
    const [head, ...lines] = readFileSync(`${native}/${name}`, "utf8").trim().split("\n").map((line) => line.split(","));
    return lines.map((line) => Object.fromEntries(head.map((key, k) => [key, line[k]])));
  };
  const theirs = table("protrusions.csv");
  console.log("protrusion: initiated [s], length [um], f_mat: here / native");
  rows.forEach((row, k) => {
    const other = theirs[k] ?? {};
    console.log(`${row.id}: ${row.t_initiation_s} ${row.length_um} ${row.f_mat} / ${other.t_initiation_s} ${other.length_um} ${other.f_mat}`);
  });
  const path = table("tracks.csv");
  let last = 0;
  for (const [t, px, py] of tracks) {
    const row = path.find((one) => Math.abs(Number(one.t_s) - t) < 1e-6);
    if (!row) continue;
    const away = Math.hypot(px - Number(row.x_um), py - Number(row.y_um));
    if (t % 1800 === 0) console.log(`t = ${t} s: centres ${away.toExponential(2)} um apart`);
    last = away;
  }
  const difference = Math.abs(rows[0].length_um - Number(theirs[0].length_um));
  console.log(`first protrusion: ${rows[0].length_um} um here, ${theirs[0].length_um} um natively; last centres ${last.toExponential(2)} um apart`);
  if (!(difference < 0.1)) throw new Error("the first protrusions differ");
}
