/** The page of a run. Tables and plots first, since they cost nothing; the film is unpacked meanwhile. */
import type { RunPage } from "../contract";
import { fillPage, h, header, section, sources, table } from "../dom";
import { embeddedRun } from "../embedded";
import { pretty, readable } from "../numbers";
import { units } from "../words";
import "../page.css";
import { laws } from "./laws";
import { hook } from "./save/hook";
import { fitted, runView } from "./view";

function named(values: RunPage["readouts"], caption: string): HTMLElement {
  const several = values.some((v) => v.cell !== undefined);
  const heads = [...(several ? ["cell"] : []), "what", "value", "name in files"];
  const rows = values.map((v) => [units(v.meaning), readable(v.value), h("code", {}, v.name)]);
  const whole = several ? rows.map((row, i) => [String(values[i].cell ?? ""), ...row]) : rows;
  return table(caption, heads, whole, several ? [0, 2] : [1]);
}

/** A number with its unit as it is printed; texts, which are copied, stay, and are broken where they must be. */
const quantity = (value: string): string | HTMLElement =>
  /^-?[\d.]+(e[-+]?\d+)?( [A-Za-z1][\w/^ ]*)?$/.test(value) ? pretty(value) : h("code", { class: "long" }, value);

function parameters(run: RunPage): Node {
  const shown = run.parameters.filter((p) => !p.name.startsWith("laws.") || !run.laws?.length); // laws have their own section
  const none = "None: every parameter has the value of Table 1 or, where the paper gives none, of the program.";
  if (shown.length === 0) return h("p", {}, run.parameters.length > 0 ? "None but the laws above." : none);
  const rows = shown.map((p) => [h("code", {}, p.name), quantity(p.value), quantity(p.default), p.meaning]);
  return table("Changed parameters", ["parameter", "value", "default", "meaning"], rows);
}

fillPage((page) => {
  const run = embeddedRun();
  const { parts, ready } = runView(run, true);
  window.matrigrate = hook(ready);
  window.matrigrate.ready.catch(() => undefined);
  const changed = run.laws ?? [];
  const drawn = fitted((width) => laws(changed, width), new AbortController().signal);
  page.replaceChildren(
    header(run.title, run.status, [pretty(run.summary)], run.facts),
    ...parts,
    ...(changed.length > 0 ? [section("laws", "Laws that differ from the default ones", drawn)] : []),
    h(
      "div",
      { class: "two" },
      section("readouts", "Read-outs", named(run.readouts, "Read-outs")),
      h(
        "div",
        {},
        section("parameters", "Parameters that differ from Table 1", parameters(run)),
        section("health", "Health of the computation", named(run.health, "Health")),
      ),
    ),
    ...sources(run),
  );
  return ready;
});
