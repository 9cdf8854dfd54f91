/** Writes pages to look at: `npm run sample [-- RUN_FOLDER]`. */
import { mkdirSync, writeFileSync } from "node:fs";
import { embed } from "./pack";
import { runFromFolder, sampleRun } from "./run";
import { sampleStudy } from "./study";
import { sampleVerdicts } from "./verdicts";

mkdirSync("build/pages", { recursive: true });
const folder = process.argv[2];
const run = JSON.stringify(folder ? runFromFolder(folder) : sampleRun());
writeFileSync("build/pages/run.html", embed("dist/run.html", run));
writeFileSync("build/pages/study.html", embed("dist/study.html", JSON.stringify(sampleStudy())));
writeFileSync("build/pages/verdicts.html", embed("dist/verdicts.html", JSON.stringify(sampleVerdicts())));
console.log(`build/pages/run.html (data ${(run.length / 1e6).toFixed(1)} MB), build/pages/study.html and verdicts.html`);
