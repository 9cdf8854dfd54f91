/** The page of a run. Tables and plots first, since they cost nothing; the film is unpacked meanwhile. */
import type { RunPage } from "../contract";
import { factList, fault, h, section, table } from "../dom";
import { embeddedRun } from "../embedded";
import { pretty, readable } from "../numbers";
import { units } from "../words";
import "../page.css";
import { laws } from "./laws";
import { hook } from "./save/hook";
import { fitted, runView } from "./view";

function named(values: RunPage["readouts"], caption: string): HTMLElement {
  const several = values.some((v) => v.cell !== undefined);
  return table(
    [...(several ? ["cell"] : []), "what", "value", "name in files"],
    values.map((v) => [
      ...(several ? [String(v.cell ?? "")] : []),
      units(v.meaning),
      readable(v.value),
      h("code", {}, v.name),
    ]),
    { numeric: several ? [0, 2] : [1], caption },
  );
}

/** A number with its unit as it is printed; texts, which are copied, stay, and are broken where they must be. */
const quantity = (value: string): string | HTMLElement =>
  /^-?[\d.]+(e[-+]?\d+)?( [A-Za-z1][\w/^ ]*)?$/.test(value) ? pretty(value) : h("code", { class: "long" }, value);

function parameters(run: RunPage): Node {
  const shown = run.parameters.filter((p) => !p.name.startsWith("laws.") || !run.laws?.length); // laws have their own section
  if (shown.length === 0)
    return h("p", {}, run.parameters.length > 0 ? "None but the laws above." : "None: every parameter has the value of Table 1 or, where the paper gives none, of the program.");
  return table(
    ["parameter", "value", "default", "meaning"],
    shown.map((p) => [h("code", {}, p.name), quantity(p.value), quantity(p.default), p.meaning]),
    { caption: "Changed parameters" },
  );
}

function show(run: RunPage, page: HTMLElement): void {
  document.title = run.title;
  const { parts, ready, clock } = runView(run, true);
  window.matrigrate = hook(ready, clock);
  window.matrigrate.ready.catch(() => undefined);
  page.replaceChildren(
    h(
      "header",
      {},
      h("h1", {}, run.title),
      h("p", { class: "status" }, run.status, " ", h("strong", {}, pretty(run.summary))),
      factList(run.facts),
    ),
    ...parts,
    ...(run.laws?.length ? [section("laws", "Laws that differ from the default ones", fitted((width) => laws(run.laws ?? [], width), new AbortController().signal))] : []),
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
    section("provenance", "Provenance", h("pre", {}, run.provenance)),
    section("citation", "To cite", h("p", { class: "citation" }, run.citation)),
  );
  void ready.finally(() => {
    document.documentElement.dataset["ready"] = "true";
  });
}

const page = document.getElementById("page");
if (page) {
  try {
    show(embeddedRun(), page);
  } catch (reason) {
    page.replaceChildren(fault(reason instanceof Error ? reason.message : String(reason)));
    document.documentElement.dataset["ready"] = "true";
  }
}
