/** The scenario as files for the program. */
import { timeText } from "../numbers";
import { fieldFiles, type Scenario } from "./scenario";

const quoted = (text: string): string => `'${text.replace(/'/g, `'\\''`)}'`;

/** What to do with the files, as comments of the scenario. */
function commands(scenario: Scenario): string[] {
  const lines = ["Made by the live page. The same start and events with the program:", "  matrigrate run scenario.toml -o live"];
  let from = "live";
  scenario.changes.forEach(({ t, overrides }, k) => {
    const to = `live-${k + 1}`;
    const set = overrides.map((one) => ` --set ${quoted(one)}`).join("");
    if (k === 0) lines.push("What was changed on the way, as branches of that run:");
    lines.push(`  matrigrate resume ${from} --at '${t} s'${set} -o ${to}   # at ${timeText(t)}`);
    from = to;
  });
  lines.push("Events agree until the last bits of exp, sin and others, which differ, have grown: docs/how-to/live.md.");
  return lines;
}

/** @param resolved  the scenario with all its values   @param drawn  files of fields, by name */
export function exported(scenario: Scenario, resolved: string, drawn: Record<string, string>): Record<string, string> {
  let toml = resolved;
  // The core has read the files from its own memory: "/f_degr.csv hash=..." is beside the scenario for the program.
  for (const { file } of Object.values(fieldFiles))
    toml = toml.replace(new RegExp(`"/${file.replace(".", "\\.")}[^"\\n]*"`), `"${file}"`);
  return { "scenario.toml": `${commands(scenario).map((line) => `# ${line}`).join("\n")}\n\n${toml}`, ...drawn };
}

export function download(name: string, content: string): void {
  const link = document.createElement("a");
  link.href = URL.createObjectURL(new Blob([content], { type: "text/plain" }));
  link.download = name;
  link.click();
  setTimeout(() => URL.revokeObjectURL(link.href), 10_000);
}
