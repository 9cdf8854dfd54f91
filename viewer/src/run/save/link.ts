/** Keeps the address of the page at the moment that is shown, and copies it. */
import { h } from "../../dom";
import type { Clock } from "../clock";
import type { Layer } from "../matrix/layers";
import { momentHash, momentOf } from "./moment";
import type { Stage } from "../stage";

/** Browsers allow few changes of the address in a short time [ms]. */
const pause = 250;

/** Shows what the address says. Returns whether it said a time. */
function obey(clock: Clock, stage: Stage, all: Layer[]): boolean {
  const { time, layer } = momentOf(location.hash);
  const wanted = all.find((one) => one.key === layer);
  if (wanted) stage.choose(wanted);
  if (time !== null) clock.jump(time);
  return time !== null;
}

/** Follows the address, and writes it whenever the film stands still at another time or layer. */
export function followAddress(clock: Clock, stage: Stage, all: Layer[], gone: AbortSignal): boolean {
  let later: ReturnType<typeof setTimeout> | undefined;
  const write = () => {
    clearTimeout(later);
    if (clock.playing) return;
    later = setTimeout(() => {
      if (!clock.playing) history.replaceState(null, "", momentHash(clock.time, stage.layer.key));
    }, pause);
  };
  const said = obey(clock, stage, all);
  clock.onChange(write, gone);
  stage.onLayer(write);
  addEventListener("hashchange", () => obey(clock, stage, all), { signal: gone });
  gone.addEventListener("abort", () => clearTimeout(later));
  return said;
}

/** Where the clipboard is closed to pages, the old way still works. */
export async function copied(text: string): Promise<boolean> {
  try {
    await navigator.clipboard.writeText(text);
    return true;
  } catch {
    const area = h("textarea", { class: "unseen", readonly: true }, text);
    document.body.append(area);
    area.select();
    const done = document.execCommand("copy");
    area.remove();
    return done;
  }
}

/** @param tell  says what came of it */
export function linkButton(clock: Clock, stage: Stage, tell: (text: string) => void): HTMLElement {
  const button = h("button", { type: "button", class: "link", title: "Address of this page at this time" }, "Copy link");
  button.addEventListener("click", () => {
    const address = location.href.replace(/#.*$/, "") + momentHash(clock.time, stage.layer.key);
    void copied(address).then((done) => tell(done ? "Link copied." : `Link: ${address}`));
  });
  return button;
}
