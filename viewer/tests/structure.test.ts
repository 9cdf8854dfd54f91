/** The shape of the source: files import each other one way, and stay short. */
import assert from "node:assert/strict";
import { readdirSync, readFileSync } from "node:fs";
import { dirname, join, relative } from "node:path";
import { test } from "node:test";

const files = (folder: string, kind = /\.ts$/): string[] =>
  readdirSync(folder, { withFileTypes: true }).flatMap((entry) =>
    entry.isDirectory() ? files(join(folder, entry.name), kind) : kind.test(entry.name) ? [join(folder, entry.name)] : [],
  );

/** Types included: who needs another's types cannot be read without it. */
function imports(file: string): string[] {
  const text = readFileSync(file, "utf8");
  return [...text.matchAll(/^(?:import|export)\b[^;]*?from "(\.[^"]+)"/gms)].map((found) =>
    join(dirname(file), `${found[1]}.ts`),
  );
}

test("no file imports itself by way of others", () => {
  const all = new Map(files("src").map((file) => [file, imports(file)]));
  assert.ok(all.size > 30 && [...all.values()].flat().length > 80, "the pattern misses imports");
  const finished = new Set<string>();
  const visit = (file: string, trail: string[]): void => {
    assert.ok(!trail.includes(file), [...trail, file].map((one) => relative("src", one)).join(" -> "));
    if (finished.has(file)) return;
    for (const next of all.get(file) ?? []) visit(next, [...trail, file]);
    finished.add(file);
  };
  for (const file of all.keys()) visit(file, []);
});

test("files are short enough to be read", () => {
  for (const file of files("src", /\.(ts|css)$/)) {
    const lines = readFileSync(file, "utf8").split("\n").length;
    assert.ok(lines <= 350, `${file} has ${lines} lines`);
  }
});

// `npm ci` refuses a lock file that lacks a package which another one names, be it for another system.

interface Locked {
  integrity?: string;
  dependencies?: Record<string, string>;
  optionalDependencies?: Record<string, string>;
}

test("the lock file holds every package that one of its packages names", () => {
  const { packages } = JSON.parse(readFileSync("package-lock.json", "utf8")) as { packages: Record<string, Locked> };
  for (const [place, locked] of Object.entries(packages)) {
    if (place !== "") assert.ok(locked.integrity, `${place} has no checksum`);
    for (const name of Object.keys({ ...locked.dependencies, ...locked.optionalDependencies }))
      assert.ok(
        `${place}/node_modules/${name}` in packages || `node_modules/${name}` in packages,
        `${place} names ${name}, which is not locked`,
      );
  }
});
