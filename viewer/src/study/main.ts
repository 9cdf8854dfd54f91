/** The page of a study. */
import type { StudyPage } from "./contract";
import { factList, fault, h, section } from "../dom";
import { embedded } from "../embedded";
import "../page.css";
import { boxesNote, boxesOfAll } from "./boxes";
import { leastRuns, type Shown } from "./brackets";
import { pretty } from "../numbers";
import { grid, seriesKey } from "./groups";
import { claims, medians, runs, safe } from "./lists";
import { players } from "./players";
import { scatters } from "./scatter";
import { adhesionForces, correlation, msd } from "./statistics";
import "./study.css";
import { paths, shapes } from "./tracks";
import { capital, lettered, said, wordsOf } from "../words";

/** Points that small pictures and curves of each are drawn of; of more, nobody could tell one from another. */
const mostPoints = 60;

/** Where no point has enough runs for a test. */
function fewRuns(study: StudyPage): HTMLElement | null {
  const most = Math.max(0, ...study.groups.map((g) => g.n));
  if (most === 0 || most >= leastRuns || study.tests.length === 0) return null;
  return h(
    "p",
    { class: "notice" },
    `Tests need at least ${leastRuns} ${study.sampled ?? "runs"} at each point. This study has n = ${most}${study.groups.some((g) => g.n < most) ? " at most" : ""}, so nothing is called significant.`,
  );
}

function part(id: string, title: string, content: HTMLElement | null, ...before: (Node | null)[]): HTMLElement | null {
  return content ? section(id, title, ...before, content) : null;
}

function show(study: StudyPage, page: HTMLElement): void {
  document.title = study.title;
  let main = 0;
  let comparisons: Shown = "significant";
  const body = h("div", {});
  const played = players(study, safe);
  const draw = () => {
    const made = grid(study, main);
    const many = made.groups.length > mostPoints;
    const parts = [
      part(
        "claims",
        "Claims and verdicts",
        claims(study),
        study.claims_note ? h("p", { class: "notice" }, pretty(study.claims_note)) : null,
      ),
      part("scatter", "Read-outs over parameters", scatters(study)),
      study.readouts.length > 0 && !study.scatter?.factors.length
        ? section(
            "readouts",
            study.sampled ? "Read-outs" : "Read-outs by parameter",
            fewRuns(study),
            seriesKey(made),
            h("p", { class: "note" }, boxesNote(study.sampled ?? "runs")),
            h("div", { class: "boxes" }, ...boxesOfAll(study, made, comparisons)),
          )
        : null,
      many
        ? section(
            "paths",
            "Paths and shapes",
            h("p", {}, `With ${made.groups.length} points, paths, shapes and mean square displacements are not drawn here; the report of each run has them.`),
          )
        : null,
      many ? null : part("paths", "Paths from a common origin", paths(made, study.measured), seriesKey(made)),
      many ? null : part("shapes", "Cells at the end", shapes(made), seriesKey(made)),
      played,
      many ? null : part("msd", "Mean square displacement", msd(study, made)),
      part("adhesions", "Force at which adhesions ended", adhesionForces(made), seriesKey(made)),
      part("correlation", "Correlations within points", correlation(study)),
      part("medians", "Medians", medians(study, made)),
      study.sampled ? null : section("runs", "Runs", runs(study)),
      study.provenance ? section("provenance", "Provenance", h("pre", {}, study.provenance)) : null,
      section("citation", "To cite", h("p", { class: "citation" }, study.citation)),
    ];
    body.replaceChildren(...parts.filter((p): p is HTMLElement => p !== null));
  };
  const choice = h("select", {}, ...study.axes.map((a, i) => h("option", { value: i }, capital(wordsOf(a)))));
  choice.addEventListener("change", () => {
    main = Number(choice.value);
    draw();
  });
  const which = h(
    "select",
    {},
    h("option", { value: "significant" }, "significant ones"),
    h("option", { value: "all" }, "all"),
    h("option", { value: "none" }, "none"),
  );
  which.addEventListener("change", () => {
    comparisons = which.value as Shown;
    draw();
  });
  page.replaceChildren(
    h("header", {}, h("h1", {}, study.title), h("p", { class: "status" }, study.status, " ", h("strong", {}, ...lettered(said(study.summary ?? "", study.axes, study.readouts)))), factList(study.facts ?? [])),
    h(
      "div",
      { class: "study-controls" },
      study.axes.length > 1 ? h("label", {}, "Along the axis: ", choice) : null,
      study.tests.length > 0 ? h("label", {}, "Comparisons: ", which) : null,
    ),
    body,
  );
  draw();
}

const page = document.getElementById("page");
if (page) {
  try {
    show(embedded("matrigrate-study", ["axes", "readouts", "runs", "groups", "tests", "msd"]) as unknown as StudyPage, page);
  } catch (reason) {
    page.replaceChildren(fault(reason instanceof Error ? reason.message : String(reason)));
  }
  document.documentElement.dataset["ready"] = "true";
}
