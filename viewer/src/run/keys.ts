/** Keys of the player. Where they act from anywhere on the page, they leave controls their own keys. */
import type { Clock } from "./clock";
import type { Stage } from "./stage";

/** @param from  where keys are listened to   @param gone  when they no longer are */
export function attachKeys(clock: Clock, stage: Stage, from: Document | HTMLElement, gone: AbortSignal): void {
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
  const pressed = (event: Event) => {
    if (!(event instanceof KeyboardEvent)) return;
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
  };
  from.addEventListener("keydown", pressed, { signal: gone });
}
