/** What the runs of a study look like, with the plots of the page of a study. */
import { h, section } from "../dom";
import { named } from "../figure";
import { boxes, boxesNote } from "../study/boxes";
import type { StudyData } from "../study/contract";
import { grid, seriesKey } from "../study/groups";
import { adhesionForces, msd } from "../study/statistics";
import { paths, shapes } from "../study/tracks";

export const studyId = (name: string): string => `study-${name}`;

export function studySection(name: string, study: StudyData): HTMLElement {
  const made = grid(study, 0);
  const part = (suffix: string, title: string, content: HTMLElement | null): Node[] =>
    content ? [h("h3", {}, title), named(`${name}${suffix}`, h("div", {}, seriesKey(made), content))] : [];
  return section(
    studyId(name),
    `Study ${name}: ${study.title}`,
    ...part("-paths", "Paths from a common origin", paths(made)),
    ...part("-shapes", "Cells at the end", shapes(made)),
    ...part("-msd", "Mean square displacement", msd(study, made)),
    ...part("-adhesions", "Force at which adhesions ended, over 2 f_mat F_am", adhesionForces(made)),
    ...part(
      "",
      "Read-outs by parameter",
      h("div", { class: "boxes" }, ...study.readouts.map((r) => boxes(study, made, r, "significant"))),
    ),
    h("p", { class: "note" }, boxesNote("runs")),
  );
}
