/** The report of a run that the program has just made; only where MATRIGRATE_PROGRAM names it. */
import assert from "node:assert/strict";
import { execFileSync } from "node:child_process";
import { mkdtempSync, rmSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { test } from "node:test";
import { pathToFileURL } from "node:url";
import { launch } from "./browser";

const program = process.env["MATRIGRATE_PROGRAM"];

const scenario = `[ecm]
radius = "40 um"
[output]
track_interval = "8 s"
field_interval = "12 s"
[run]
duration = "60 s"
`;

test("a report of the program opens and plays", { skip: program === undefined }, async () => {
  const folder = mkdtempSync(join(tmpdir(), "matrigrate-real-"));
  const browser = await launch(false);
  try {
    writeFileSync(join(folder, "s.toml"), scenario);
    execFileSync(program!, ["run", "s.toml", "-o", "run", "--quiet"], { cwd: folder });
    const page = await browser.newPage();
    const errors: string[] = [];
    page.on("console", (message) => message.type() === "error" && errors.push(message.text()));
    page.on("pageerror", (error) => errors.push(error.message));
    await page.goto(pathToFileURL(join(folder, "run", "report.html")).href);
    await page.locator(".scrub").waitFor();
    assert.equal(await page.locator("h1").textContent(), "Migration run, seed 1");
    await page.locator(".scrub").fill("60");
    await page.locator("input[value=von_mises]").check();
    await page.locator("text=ecm.radius").first().waitFor();
    assert.deepEqual(errors, []);
  } finally {
    await browser.close();
    rmSync(folder, { recursive: true });
  }
});
