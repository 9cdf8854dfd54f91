/** Chosen runs of a study: one at a time, with player, path and protrusions. */
import type { StudyPage, StudyPlayer } from "../contract";
import { h, section } from "../dom";
import { pretty } from "../numbers";
import { onPrint } from "../paper";
import { runView, type RunView } from "../run/view";

/** Unpacked when it comes near the window, or when the browser has nothing else to do, so that it can be printed. */
export function players(study: StudyPage, safe: (address: string | null) => string | null): HTMLElement | null {
  const all = study.players ?? [];
  if (all.length === 0) return null;
  const choice = h("select", { "aria-label": "Run" }, ...all.map((p, i) => h("option", { value: i }, p.label)));
  const place = h("div", { class: "chosen-run" });
  const link = h("p", { class: "note" });
  let view: RunView | null = null;
  const show = (chosen: StudyPlayer) => {
    view?.stop();
    view = runView(chosen.run, false);
    const report = safe(study.runs.find((run) => run.id === chosen.id)?.report ?? null);
    link.replaceChildren(
      `${chosen.run.title}. ${chosen.run.status} ${pretty(chosen.run.summary)} `,
      report ? h("a", { href: report }, "All about this run") : "",
    );
    place.replaceChildren(...view.parts);
    place.dataset["run"] = chosen.id;
  };
  choice.addEventListener("change", () => show(all[Number(choice.value)]));
  const first = () => {
    if (!view) show(all[Number(choice.value)]);
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
  return section("players", "Chosen runs", h("label", { class: "choice" }, "Show: ", choice), link, place);
}
