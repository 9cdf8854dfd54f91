/** What is wrong, in words. */
import { h } from "../dom";
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
    const close = h("button", { type: "button" }, "Close");
    close.addEventListener("click", () => this.clear());
    this.element.replaceChildren(h("div", { class: "fault" }, ...content, close));
  }
}
