/**
 * Every picture that the program, its pages and its packages make, beside a small one in tests/pictures/kept.tar; only where
 * MATRIGRATE_PROGRAM, MATRIGRATE_SOURCE and MATRIGRATE_CORE name the program, its source and the module of Python. With
 * MATRIGRATE_PICTURES=FOLDER all are written there: large, as wide as a column of a journal (85 mm), and a new kept.tar. A picture
 * that is meant to change is looked at, then kept.
 */
import assert from "node:assert/strict";
import { execFileSync, spawnSync } from "node:child_process";
import { cpSync, existsSync, mkdirSync, mkdtempSync, readdirSync, readFileSync, rmSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { basename, join } from "node:path";
import { test } from "node:test";
import { pathToFileURL } from "node:url";
import type { Page } from "playwright-core";
import { allDrawn, inkDifference, launch, narrow } from "./browser";

const program = process.env["MATRIGRATE_PROGRAM"];
const source = process.env["MATRIGRATE_SOURCE"];
const core = process.env["MATRIGRATE_CORE"];
const out = process.env["MATRIGRATE_PICTURES"];

/** What draws for Python and R is there. */
const able = () =>
  spawnSync("/usr/bin/python3", ["-c", "import h5py, matplotlib, pandas, scipy"]).status === 0 && spawnSync("Rscript", ["--version"]).status === 0;

/** Of the ink of both pictures, the part that may be at another place: other fonts, another way to round. */
const most = 0.3;
const column = 321; // pixels of 85 mm at 96 an inch
const small = ["--set", "ecm.radius=80 um", "--set", "protrusion.initiation_rate=2e-3 1/s", "--quiet"];

const files: Record<string, string> = {
  "study.toml": `title = "Soft and stiff matrix"
preset = "baseline"
replicates = 5
readouts = ["v_migr_path_60s_um_per_h", "n_protrusions", "l_prot_um"]
[set]
run.duration = "20 min"
ecm.radius = "60 um"
protrusion.initiation_rate = "2e-3 1/s"
output.field_interval = "300 s"
[sweep]
ecm.youngs_modulus = ["50 Pa", "400 Pa"]
`,
  "gradient.toml": `[ecm]
radius = "60 um"
[ecm.fields]
youngs_modulus = "max(50, 200 + 2*x)"
`,
};

const commands = (kept: string): string[][] => [
  ["new", "cell.toml"],
  ["run", "cell.toml", "-o", "run", "--hours", "1", ...small],
  ["new", "fibres.toml", "--preset", "two-protrusions-fibres"],
  ["run", "fibres.toml", "-o", "fibres", "--hours", "0.2", "--set", "laws.disassembly_rate=min(0.01, r_off_min + r_off_0*exp(-zeta_diss*F/f_mat))", ...small],
  ["export", "run", "--panel", "0 min, 20 min, 40 min", "-o", "panel"],
  ["export", "run", "--png", "-o", "png"],
  ["explain", "gradient.toml", "--pictures", "fields"],
  ["study", "run", "study.toml", "-o", "study", "--quiet"],
  ["study", "collect", "study"],
  ["validate", "stretch", "-o", "stretch"],
  ["reproduce", "E5", "--from", kept, "-o", "claims"],
];

/** Runs all programs.   @return files of pictures, and pages, by name */
function made(folder: string): { pictures: Map<string, string>; pages: Map<string, string> } {
  for (const [name, text] of Object.entries(files)) writeFileSync(join(folder, name), text);
  for (const command of commands(join(source!, "docs/validation"))) {
    const ended = spawnSync(program!, command, { cwd: folder, encoding: "utf8" });
    assert.ok(ended.status === 0 || (command[0] === "reproduce" && ended.status === 4), `${command.join(" ")}: ${ended.stderr}`);
  }
  const python = { env: { ...process.env, PYTHONPATH: join(source!, "python"), MATRIGRATE: program, MATRIGRATE_SMALL_RUNS: folder, MATRIGRATE_KEEP: folder }, cwd: folder, stdio: "pipe" } as const;
  execFileSync("/usr/bin/python3", ["-B", join(source!, "tests/pictures/figures.py"), "run", "study", "."], python);
  execFileSync("/usr/bin/python3", ["-B", join(source!, "tests/python/test_labels.py"), "Pages.test_of_a_fit"], python);
  execFileSync("Rscript", ["--vanilla", join(source!, "tests/pictures/figures.R"), source!, "run", "study", "."], { cwd: folder, stdio: "pipe" });
  const found: [string, string][] = readdirSync(folder).filter((name) => /^(python|r)-.*\.png$/.test(name)).map((name) => [name.slice(0, -4), name]);
  found.push(["panel", "panel/panel.svg"]);
  const last = (of: string, like: RegExp) => join(of, readdirSync(join(folder, of)).filter((name) => like.test(name)).sort().at(-1)!);
  found.push(["frame", last("png", /\.png$/)], ["frame-svg", last("png", /\.svg$/)], ["field", last("fields", /\.svg$/)]);
  const pages: [string, string][] = [["run", "run/report.html"], ["fibres", "fibres/report.html"], ["study", "study/report.html"], ["case", "stretch/report.html"],
    ["claims", "claims/report-E5.html"], ["fit", "fit.html"]];
  return { pictures: new Map(found), pages: new Map(pages) };
}

const bytes = (file: string): string =>
  `data:image/${file.endsWith(".svg") ? "svg+xml" : "png"};base64,${readFileSync(file).toString("base64")}`;

/** Pictures of a page: each layer of its player, and each of its figures. */
async function ofPage(page: Page, name: string, file: string): Promise<[string, string][]> {
  await page.setViewportSize({ width: 1280, height: 900 });
  await page.goto(pathToFileURL(file).href);
  if (existsSync(file) && !/fi?t/.test(name)) await page.waitForSelector("html[data-ready=true]");
  const found: [string, string][] = [];
  if (await page.locator(".plotly-figure").count()) await allDrawn(page);
  const shown = page.locator("figure:visible");
  const count = name === "claims" ? 3 : await shown.count(); // the others are as those of the study
  for (let k = 0; k < count; ++k)
    found.push([`${name}-figure-${k + 1}`, `data:image/png;base64,${(await shown.nth(k).screenshot()).toString("base64")}`]);
  const layers = name === "run" || name === "fibres" ? await page.locator('input[name="layer"]').evaluateAll((all) => all.map((one) => (one as HTMLInputElement).value)) : [];
  for (const layer of layers)
    found.push([`${name}-layer-${layer}`, await page.evaluate(([layer]) => {
      window.matrigrate!.show({ width: 960, height: 720, layer });
      return window.matrigrate!.frame(700).toDataURL();
    }, [layer])]);
  return found;
}

/** What a page is like on a phone, and in the dark. */
async function looks(page: Page, name: string, file: string): Promise<[string, string][]> {
  const found: [string, string][] = [];
  for (const [look, width, scheme] of [["phone", 390, "light"], ["dark", 1280, "dark"]] as const) {
    await page.emulateMedia({ colorScheme: scheme, reducedMotion: "reduce" });
    await page.setViewportSize({ width, height: 1400 });
    await page.goto(pathToFileURL(file).href);
    if (await page.locator(".plotly-figure").count()) await allDrawn(page, width);
    assert.ok((await page.evaluate(() => document.documentElement.scrollWidth)) <= width + 1, `${name} is wider than ${width} pixels`);
    await page.addStyleTag({ content: ".facts, .provenance, dl { display: none }" }).catch(() => undefined); // dates, wall times, changed sources
    found.push([`${name}-${look}`, `data:image/png;base64,${(await page.screenshot({ clip: { x: 0, y: 0, width, height: 1400 } })).toString("base64")}`]);
  }
  await page.emulateMedia({ colorScheme: "light", reducedMotion: "reduce" });
  return found;
}

test("all pictures look as those that are kept", { skip: [program, source, core].includes(undefined) || !able() }, async () => {
  const folder = mkdtempSync(join(tmpdir(), "matrigrate-pictures-"));
  const browser = await launch();
  try {
    const { pictures, pages } = made(folder);
    const page = await browser.newPage({ reducedMotion: "reduce" });
    const all: [string, string][] = [...pictures].map(([name, file]) => [name, bytes(join(folder, file))]);
    for (const [name, file] of pages) all.push(...(await ofPage(page, name, join(folder, file))), ...(await looks(page, name, join(folder, file))));
    await page.goto("about:blank");
    const kept = join(folder, "kept");
    mkdirSync(kept);
    execFileSync("tar", ["-xf", join(source!, "tests/pictures/kept.tar"), "-C", kept]);
    const faults: string[] = [];
    const seen = new Map<string, string>();
    for (const [name, picture] of all) {
      const now = await narrow(page, picture, 120, "image/webp");
      if (out) {
        for (const part of ["large", "column", "kept"]) mkdirSync(join(out, part), { recursive: true });
        const write = (to: string, data: string) => writeFileSync(join(out, to), Buffer.from(data.slice(data.indexOf(",") + 1), "base64"));
        write(`large/${name}.png`, await narrow(page, picture, 1000, "image/png"));
        write(`column/${name}.png`, await narrow(page, picture, column, "image/png"));
        write(`kept/${name}.webp`, now);
      }
      const file = join(kept, `${name}.webp`);
      if (!existsSync(file)) faults.push(`${name}: none is kept`);
      else {
        const before = `data:image/webp;base64,${readFileSync(file).toString("base64")}`;
        const moved = await inkDifference(page, before, now);
        if (moved > most) faults.push(`${name}: ${moved.toFixed(2)} of the ink has moved`);
        seen.set(name, before);
      }
    }
    const names = all.map(([name]) => name);
    assert.equal(new Set(names).size, names.length);
    assert.ok(names.length >= 40, `${names.length} pictures`);
    for (const file of readdirSync(kept)) if (!names.includes(basename(file, ".webp"))) faults.push(`${file}: is made no more`);
    for (const [one, other] of [["python-path", "python-msd"], ["r-boxes", "python-boxes"], ["frame", "panel"], ["study-dark", "study-phone"]])
      if (seen.has(one) && seen.has(other))
        assert.ok((await inkDifference(page, seen.get(one)!, seen.get(other)!)) > most, `${one} and ${other} are told apart`);
    assert.deepEqual(faults, [], out ? "" : "MATRIGRATE_PICTURES=FOLDER writes all of them");
  } finally {
    if (out) {
      const still = ["--sort=name", "--owner=0", "--group=0", "--numeric-owner", "--mtime=2026-01-01", "--mode=0644"];
      const names = readdirSync(join(out, "kept"));
      execFileSync("tar", [...still, "-cf", join(out, "kept.tar"), "-C", join(out, "kept"), ...names]);
      cpSync(folder, join(out, "work"), { recursive: true });
    }
    await browser.close();
    rmSync(folder, { recursive: true });
  }
});

