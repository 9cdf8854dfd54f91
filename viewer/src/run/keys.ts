/** Keys of the player. They act from anywhere on the page, but leave controls their own keys. */
import type { Clock } from "./clock";
import type { Stage } from "./stage";

export function attachKeys(clock: Clock, stage: Stage): void {
  const actions: Record<string, () => void> = {
    " ": () => clock.toggle(),
    ArrowRight: () => clock.step(1),
    ArrowLeft: () => clock.step(-1),
    Home: () => clock.jump(0),
    End: () => clock.jump(clock.end),
    "+": () => stage.zoom(1.25),
    "=": () => stage.zoom(1.25),
    "-": () => stage.zoom(0.8),
    f: () => stage.setFollow(!stage.follow),
    "0": () => stage.reset(),
  };
  document.addEventListener("keydown", (event) => {
    if (event.ctrlKey || event.metaKey || event.altKey) return;
    const target = event.target instanceof Element ? event.target : null;
    const scrubber = target?.matches(".scrub") ?? false;
    const inPlayer = target === null || target === document.body || target === stage.element || scrubber;
    // A focused button takes the space bar, a choice takes the arrows, a page is scrolled by Home and End.
    if (!inPlayer && target?.closest("button, input, select, textarea, summary, a, [tabindex]")) return;
    if ((event.key === "Home" || event.key === "End") && target !== stage.element && !scrubber) return;
    const act = actions[event.key];
    if (!act) return;
    event.preventDefault();
    act();
  });
}
