/** `npm ci` refuses a lock file that lacks a package which another one names, be it for another system. */
import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { test } from "node:test";

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
