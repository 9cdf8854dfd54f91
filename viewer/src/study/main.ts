/** The page of a study. */
import type { StudyPage } from "./contract";
import { fillPage, h, header, section, select, sources } from "../dom";
import { embedded } from "../embedded";
import "../page.css";
import { boxesNote, boxesOfAll } from "./boxes";
import { leastRuns, type Shown } from "./brackets";
import { pretty } from "../numbers";
import { grid, seriesKey } from "./groups";
import { claims, medians, runs } from "./lists";
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
  const here = `This study has n = ${most}${study.groups.some((g) => g.n < most) ? " at most" : ""}`;
  const words = `Tests need at least ${leastRuns} ${study.sampled ?? "runs"} at each point. ${here}, so nothing is called significant.`;
  return h("p", { class: "notice" }, words);
}

const part = (id: string, title: string, content: HTMLElement | null, ...before: (Node | null)[]): HTMLElement[] =>
  content ? [section(id, title, ...before, content)] : [];

fillPage((page) => {
  const study = embedded("matrigrate-study", ["axes", "readouts", "runs", "groups", "tests", "msd"]) as unknown as StudyPage;
  let main = 0;
  let comparisons: Shown = "significant";
  const body = h("div", {});
  const played = players(study);
  const draw = () => {
    const made = grid(study, main);
    const many = made.groups.length > mostPoints;
    const instead = `With ${made.groups.length} points, paths, shapes and mean square displacements are not drawn here; the report of each run has them.`;
    const note = study.claims_note ? h("p", { class: "notice" }, pretty(study.claims_note)) : null;
    const boxed = study.readouts.length > 0 && !study.scatter?.factors.length;
    body.replaceChildren(
      ...part("claims", "Claims and verdicts", claims(study), note),
      ...part("scatter", "Read-outs over parameters", scatters(study)),
      ...part(
        "readouts",
        study.sampled ? "Read-outs" : "Read-outs by parameter",
        boxed ? h("div", { class: "boxes" }, ...boxesOfAll(study, made, comparisons)) : null,
        fewRuns(study),
        seriesKey(made),
        h("p", { class: "note" }, boxesNote(study.sampled ?? "runs")),
      ),
      ...part("paths", "Paths and shapes", many ? h("p", {}, instead) : null),
      ...part("paths", "Paths from a common origin", many ? null : paths(made, study.measured), seriesKey(made)),
      ...part("shapes", "Cells at the end", many ? null : shapes(made), seriesKey(made)),
      ...played,
      ...part("msd", "Mean square displacement", many ? null : msd(study, made)),
      ...part("adhesions", "Force at which adhesions ended", adhesionForces(made), seriesKey(made)),
      ...part("correlation", "Correlations within points", correlation(study)),
      ...part("medians", "Medians", medians(study, made)),
      ...part("runs", "Runs", study.sampled ? null : runs(study)),
      ...sources(study),
    );
  };
  const along = select({}, study.axes.map((a, i) => [i, capital(wordsOf(a))]), (axis) => {
    main = Number(axis);
    draw();
  });
  const which = select({}, [["significant", "significant ones"], ["all", "all"], ["none", "none"]], (shown) => {
    comparisons = shown as Shown;
    draw();
  });
  const summary = lettered(said(study.summary ?? "", study.axes, study.readouts));
  page.replaceChildren(
    header(study.title, study.status, summary, study.facts ?? []),
    h(
      "div",
      { class: "study-controls" },
      study.axes.length > 1 && h("label", {}, "Along the axis: ", along),
      study.tests.length > 0 && h("label", {}, "Comparisons: ", which),
    ),
    body,
  );
  draw();
});
