/** The page of a run. Tables and plots first, since they cost nothing; the film is unpacked meanwhile. */
import type { RunPage } from "../contract";
import { fault, h, section, table } from "../dom";
import { embeddedRun } from "../embedded";
import { readable } from "../numbers";
import "../page.css";
import "./run.css";
import { Clock } from "./clock";
import { film } from "./frames";
import { player } from "./player";
import { plots } from "./plots";
import { protrusionTable, timeline } from "./timeline";

function named(values: RunPage["readouts"], caption: string): HTMLElement {
  return table(
    ["what", "value", "name in files"],
    values.map((v) => [v.meaning, readable(v.value), h("code", {}, v.name)]),
    { numeric: [1], caption },
  );
}

function parameters(run: RunPage): Node {
  if (run.parameters.length === 0)
    return h("p", {}, "None: every parameter has the value of Table 1 or, where the paper gives none, of the program.");
  return table(
    ["parameter", "value", "default", "meaning"],
    run.parameters.map((p) => [h("code", {}, p.name), p.value, p.default, p.meaning]),
    { caption: "Changed parameters" },
  );
}

/** Plots are drawn for the width they get, so that their text is never scaled; a turned phone draws them anew. */
function fitted(make: (width: number) => HTMLElement): HTMLElement {
  const holder = h("div", { class: "fitted" });
  let drawn = 0;
  new ResizeObserver(() => {
    const width = Math.floor(holder.clientWidth);
    if (width === drawn || width === 0) return;
    drawn = width;
    holder.replaceChildren(make(width));
  }).observe(holder);
  return holder;
}

function show(run: RunPage, page: HTMLElement): void {
  document.title = run.title;
  const clock = new Clock(run.t_end_s, run.frames?.times_s ?? run.tracks.t_s);
  const stage = h(
    "div",
    { id: "film" },
    h("p", { class: "wait", role: "status" }, run.frames ? "Unpacking the frames \u2026" : ""),
  );
  page.replaceChildren(
    h("header", {}, h("h1", {}, run.title), h("p", { class: "status" }, run.status)),
    stage,
    section(
      "path",
      "Path, speed and area",
      fitted((width) => plots(run.tracks, clock, width)),
    ),
    section(
      "protrusions",
      "Protrusions",
      fitted((width) => timeline(run.protrusions, clock, width)),
      h("details", {}, h("summary", {}, "All numbers of the protrusions"), protrusionTable(run.protrusions)),
    ),
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
  void film(run)
    .then((made) => {
      stage.replaceChildren(
        made
          ? player(run, made, clock)
          : h(
              "p",
              { class: "notice" },
              "This run stored no frames, so there is nothing to play. Path, protrusions and tables are below.",
            ),
      );
    })
    .catch((reason: unknown) => {
      stage.replaceChildren(
        h(
          "p",
          { class: "notice", role: "alert" },
          `The frames cannot be shown: ${reason instanceof Error ? reason.message : String(reason)}.`,
        ),
      );
    })
    .finally(() => {
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
