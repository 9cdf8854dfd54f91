/** Chosen runs of a study: one, or two beside each other on one clock, with player, path and protrusions. */
import type { StudyPage, StudyPlayer } from "./contract";
import { h, onPrint, section } from "../dom";
import { pretty } from "../numbers";
import { SharedScales } from "../run/matrix/shared";
import { commonClock, runView, type RunView } from "../run/view";
import { said, unmarked } from "../words";

/** Unpacked when it comes near the window, or when the browser has nothing else to do, so that it can be printed. */
export function players(study: StudyPage, safe: (address: string | null) => string | null): HTMLElement | null {
  const all = study.players ?? [];
  if (all.length === 0) return null;
  const labels = all.map((p) => unmarked(said(p.label, study.axes, study.readouts)));
  const options = () => labels.map((label, i) => h("option", { value: i }, label));
  const choice = h("select", { "aria-label": "Run" }, ...options());
  const other = h("select", { name: "beside" }, h("option", { value: "" }, "none"), ...options());
  const place = h("div", { class: "chosen-run" });
  const link = h("div", {});
  let views: RunView[] = [];
  const about = (chosen: StudyPlayer) => {
    const report = safe(study.runs.find((run) => run.id === chosen.id)?.report ?? null);
    return h(
      "p",
      { class: "note" },
      `${chosen.run.title}. ${chosen.run.status} ${pretty(chosen.run.summary)} `,
      report ? h("a", { href: report }, "All about this run") : "",
    );
  };
  const show = () => {
    for (const view of views) view.stop();
    const chosen = all[Number(choice.value)];
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
    const same = h("input", { type: "checkbox", name: "same-scales", checked: true });
    same.addEventListener("change", () => {
      shared.on = same.checked;
    });
    link.replaceChildren(h("label", { class: "choice" }, same, "Same limits of colours and lengths of arrows in both"));
    place.replaceChildren(
      h(
        "div",
        { class: "beside" },
        ...views.map((view, k) => h("div", {}, h("h3", {}, labels[all.indexOf(both[k])]), about(both[k]), ...view.parts)),
      ),
    );
  };
  choice.addEventListener("change", show);
  other.addEventListener("change", show);
  const first = () => {
    if (views.length === 0) show();
  };
  new IntersectionObserver(
    (entries, observer) => {
      if (!entries.some((entry) => entry.isIntersecting)) return;
      observer.disconnect();
      first();
    },
    { rootMargin: "200px" },
  ).observe(place);
  onPrint(place, first);
  if ("requestIdleCallback" in window) requestIdleCallback(first);
  else setTimeout(first, 1000);
  return section(
    "players",
    "Chosen runs",
    h("label", { class: "choice" }, "Show: ", choice),
    all.length > 1 ? h("label", { class: "choice" }, " Beside it, on the same clock: ", other) : null,
    link,
    place,
  );
}
