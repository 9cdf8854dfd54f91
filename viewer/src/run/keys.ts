/** Keys of the player. Where they act from anywhere on the page, they leave controls their own keys. */
import { choice, h } from "../dom";
import type { Probe } from "./probe";
import type { Stage } from "./stage";

const help: [string, string][] = [
  ["Space", "play or pause"],
  ["\u2190 \u2192", "stored frame before or after"],
  ["Home, End", "start or end, on the picture or the time bar"],
  ["+ \u2212", "zoom"],
  ["Shift + arrows", "move the view"],
  ["0, W", "first view, whole matrix"],
  ["F", "follow the cell"],
  ["L", "next layer (Shift + L: the one before)"],
  ["B", "fibres on or off, where there are fibres"],
  ["V", "value in the middle of the view"],
];

/**
 * @param choosable  the keys may act on the whole page; not all readers of screens and of speech can do with that
 * @return with `anywhere`: true if they do; else they act on the picture and the time bar alone
 */
export function keyList(choosable: boolean) {
  const keys = { element: h("details", { class: "keys" }, h("summary", {}, "Keys")), anywhere: choosable };
  const row = ([key, what]: [string, string]) => h("div", {}, h("dt", {}, h("kbd", {}, key)), h("dd", {}, what));
  keys.element.append(h("dl", {}, ...help.map(row)));
  const words = "They act anywhere on this page, not only on the picture and the time bar";
  const box = choice({ name: "keys-anywhere", checked: true }, words, (on) => (keys.anywhere = on));
  if (choosable) keys.element.append(box.label);
  return keys;
}

type Keys = Pick<ReturnType<typeof keyList>, "anywhere">;

/** True if a control uses the key itself. */
function isTaken(target: Element, key: string): boolean {
  const letter = key.length === 1 && key !== " ";
  return letter
    ? target.closest("select, textarea, input:not([type=radio], [type=checkbox], [type=range])") !== null
    : target.closest("button, input, select, textarea, summary, a, [tabindex]") !== null;
}

/** @param from  where keys are listened to   @param gone  when they no longer are */
export function attachKeys(stage: Stage, probe: Probe, keys: Keys, from: Document | HTMLElement, gone: AbortSignal): void {
  const { clock } = stage;
  const actions: Record<string, () => unknown> = {
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
    w: () => stage.showWhole(),
    b: () => stage.fibreLayer && stage.toggle("fibres"),
    v: () => probe.toggle(),
    l: () => nextLayer(1),
    L: () => nextLayer(-1),
  };
  const step = 24;
  /** With the shift key. */
  const shifted: Record<string, () => void> = {
    ArrowRight: () => stage.pan(-step, 0),
    ArrowLeft: () => stage.pan(step, 0),
    ArrowUp: () => stage.pan(0, step),
    ArrowDown: () => stage.pan(0, -step),
  };
  const nextLayer = (by: 1 | -1) => {
    const all = stage.layers;
    stage.choose(all[(all.indexOf(stage.layer) + by + all.length) % all.length]);
  };
  const pressed = (event: Event) => {
    if (!(event instanceof KeyboardEvent) || event.ctrlKey || event.metaKey || event.altKey) return;
    const target = event.target instanceof Element ? event.target : null;
    const scrubber = target?.matches(".scrub") ?? false;
    const inPlayer = target === null || target === document.body || target === stage.element || scrubber;
    const onPicture = target === stage.element || scrubber;
    if (!onPicture && from === document && !keys.anywhere) return;
    // A focused button takes the space bar, a choice takes the arrows, a page is scrolled by Home and End.
    if (!inPlayer && target && isTaken(target, event.key)) return;
    if ((event.key === "Home" || event.key === "End") && !onPicture) return;
    const act = (event.shiftKey && !scrubber ? shifted[event.key] : undefined) ?? actions[event.key];
    if (!act) return;
    event.preventDefault();
    act();
    // The picture first, then what is said about it.
    requestAnimationFrame(() => requestAnimationFrame(() => probe.say()));
  };
  from.addEventListener("keydown", pressed, { signal: gone });
}
