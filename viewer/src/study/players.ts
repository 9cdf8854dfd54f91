/** Chosen runs of a study: one, or two beside each other on one clock, with player, path and protrusions. */
import type { StudyPage, StudyPlayer } from "./contract";
import { choice, h, onceNear, onPrint, section, select } from "../dom";
import { pretty } from "../numbers";
import { SharedScales } from "../run/matrix/scale";
import { commonClock, runView, type RunView } from "../run/view";
import { said, unmarked } from "../words";
import { safe } from "./lists";

/** Unpacked when it comes near the window, or when the browser has nothing else to do, so that it can be printed. */
export function players(study: StudyPage): HTMLElement[] {
  const all = study.players ?? [];
  if (all.length === 0) return [];
  const labels = all.map((p) => unmarked(said(p.label, study.axes, study.readouts)));
  const options = labels.map((label, i): [number, string] => [i, label]);
  const first = select({ "aria-label": "Run" }, options, () => show());
  const other = select({ name: "beside" }, [["", "none"], ...options], () => show());
  const place = h("div", { class: "chosen-run" });
  const link = h("div", {});
  let views: RunView[] = [];
  const about = (chosen: StudyPlayer) => {
    const report = safe(study.runs.find((run) => run.id === chosen.id)?.report ?? null);
    const words = `${chosen.run.title}. ${chosen.run.status} ${pretty(chosen.run.summary)} `;
    return h("p", { class: "note" }, words, report && h("a", { href: report }, "All about this run"));
  };
  const show = () => {
    for (const view of views) view.stop();
    const chosen = all[Number(first.value)];
    const second = other.value === "" ? null : all[Number(other.value)];
    place.dataset["run"] = chosen.id;
    if (!second) {
      views = [runView(chosen.run, false)];
      link.replaceChildren(about(chosen));
      place.replaceChildren(...views[0].parts);
      return;
    }
    const both = [chosen, second];
    const clock = commonClock(both.map((p) => p.run));
    const shared = new SharedScales();
    views = both.map((p, k) => runView(p.run, false, { clock, place: k, shared }));
    const words = "Same limits of colours and lengths of arrows in both";
    const same = choice({ name: "same-scales", checked: true }, words, (on) => (shared.on = on)).label;
    same.className = "choice";
    link.replaceChildren(same);
    const part = (view: RunView, k: number) =>
      h("div", {}, h("h3", {}, labels[all.indexOf(both[k])]), about(both[k]), ...view.parts);
    place.replaceChildren(h("div", { class: "beside" }, ...views.map(part)));
  };
  const begin = () => {
    if (views.length === 0) show();
  };
  onceNear(place, "200px", begin);
  onPrint(place, begin);
  if ("requestIdleCallback" in window) requestIdleCallback(begin);
  else setTimeout(begin, 1000);
  const beside = h("label", { class: "choice" }, " Beside it, on the same clock: ", other);
  const shown = h("label", { class: "choice" }, "Show: ", first);
  return [section("players", "Chosen runs", shown, all.length > 1 && beside, link, place)];
}
