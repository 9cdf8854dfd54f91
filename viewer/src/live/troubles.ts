/** What is wrong, in words. */
import { button, h } from "../dom";
import type { Fault } from "./protocol";

export class Troubles {
  readonly element = h("div", { role: "alert", "aria-live": "assertive" });

  clear(): void {
    this.element.replaceChildren();
  }

  faults(all: Fault[], of: "start" | "change"): void {
    const title = of === "start" ? "This scenario cannot be simulated:" : "This cannot change now:";
    const lines = all.map(({ line, column, key, message }) => {
      const place = line > 0 ? `line ${line}, column ${column}: ` : "";
      return h("li", {}, place, key ? h("code", {}, key) : null, key ? " " : "", message);
    });
    this.show(h("p", {}, h("strong", {}, title)), h("ul", {}, ...lines));
  }

  failure(text: string): void {
    this.show(h("p", {}, h("strong", {}, "The simulation has stopped: "), text));
  }

  say(text: string): void {
    this.show(h("p", {}, text));
  }

  private show(...content: Node[]): void {
    const close = button("Close", { onclick: () => this.clear() });
    this.element.replaceChildren(h("div", { class: "fault" }, ...content, close));
  }
}

// What the simulation needs of a browser.

/** A module with two SIMD instructions (i8x16.splat, i8x16.popcnt). */
const withSimd = Uint8Array.of(0, 97, 115, 109, 1, 0, 0, 0, 1, 5, 1, 96, 0, 1, 123, 3, 2, 1, 0, 10, 10, 1, 8, 0, 65, 0, 253, 15, 253, 98, 11);

/** Why this browser cannot simulate, in words; null if it can. */
export function unable(): string | null {
  const lacks = typeof WebAssembly === "undefined" ? "WebAssembly" : WebAssembly.validate(withSimd) ? "" : "WebAssembly SIMD";
  if (!lacks) return null;
  return (
    `This browser, on this processor, has no ${lacks}, which the simulation needs. Chrome and Edge 91, Firefox 89 and Safari 16.4 (iOS 16.4) have it, and later ones. ` +
    "Some browsers switch WebAssembly off in their strictest setting, such as the lockdown mode of iOS. Another browser or device opens the same file; the program needs no browser."
  );
}
