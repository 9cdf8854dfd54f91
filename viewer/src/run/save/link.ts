/** A moment in the address of the page: `#t=3h12m&layer=pressure`. */
import { button, h } from "../../dom";
import type { Stage } from "../stage";

export interface Moment {
  /** [s]; null: not said. */
  time: number | null;
  layer: string | null;
}

/** Whole seconds, without parts that are zero. */
export function momentTime(seconds: number): string {
  const whole = Math.round(seconds);
  const parts = [Math.floor(whole / 3600), Math.floor((whole % 3600) / 60), whole % 60];
  return parts.map((v, k) => (v > 0 ? `${v}${"hms"[k]}` : "")).join("") || "0m";
}

export const momentHash = (time: number, layer: string): string =>
  `#t=${momentTime(time)}&layer=${encodeURIComponent(layer)}`;

/** Also takes bare seconds. */
export function momentOf(hash: string): Moment {
  const values = new URLSearchParams(hash.replace(/^#/, ""));
  const text = values.get("t") ?? "";
  const found = /^(?:(\d+(?:\.\d+)?)h)?(?:(\d+(?:\.\d+)?)m)?(?:(\d+(?:\.\d+)?)s?)?$/.exec(text);
  const time =
    text === "" || !found ? null : 3600 * Number(found[1] ?? 0) + 60 * Number(found[2] ?? 0) + Number(found[3] ?? 0);
  return { time, layer: values.get("layer") };
}

// Keeps the address of the page at the moment that is shown, and copies it.

/** Browsers allow few changes of the address in a short time [ms]. */
const pause = 250;

/** Shows what the address says. Returns whether it said a time. */
function obey(stage: Stage): boolean {
  const { time, layer } = momentOf(location.hash);
  const wanted = stage.layers.find((one) => one.key === layer);
  if (wanted) stage.choose(wanted);
  if (time !== null) stage.clock.jump(time);
  return time !== null;
}

/** Follows the address, and writes it whenever the film stands still at another time or layer. */
export function followAddress(stage: Stage, gone: AbortSignal): boolean {
  const { clock } = stage;
  let later: ReturnType<typeof setTimeout> | undefined;
  const write = () => {
    clearTimeout(later);
    if (clock.playing) return;
    later = setTimeout(() => {
      if (!clock.playing) history.replaceState(null, "", momentHash(clock.time, stage.layer.key));
    }, pause);
  };
  const said = obey(stage);
  clock.onChange(write, gone);
  stage.on("layer", write);
  addEventListener("hashchange", () => obey(stage), { signal: gone });
  gone.addEventListener("abort", () => clearTimeout(later));
  return said;
}

/** Where the clipboard is closed to pages, the old way still works. */
function copiedByHand(text: string): boolean {
  const area = h("textarea", { class: "unseen", readonly: true }, text);
  document.body.append(area);
  area.select();
  const done = document.execCommand("copy");
  area.remove();
  return done;
}

/** Copies the address of this page with another end. */
export async function copyLink(hash: string, tell: (text: string) => void): Promise<void> {
  const address = location.href.replace(/#.*$/, "") + hash;
  let done = true;
  try {
    await navigator.clipboard.writeText(address);
  } catch {
    done = copiedByHand(address);
  }
  tell(done ? "Link copied." : `Link: ${address}`);
}

/** @param tell  says what came of it */
export function linkButton(stage: Stage, tell: (text: string) => void): HTMLElement {
  const onclick = () => copyLink(momentHash(stage.clock.time, stage.layer.key), tell);
  return button("Copy link", { class: "link", title: "Address of this page at this time", onclick });
}
