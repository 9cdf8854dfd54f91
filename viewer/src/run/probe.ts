/** The value of the layer under the pointer or, by keyboard, in the middle of the view, and what of a cell lies there. */
import { h } from "../dom";
import { readable } from "../numbers";
import { cellTextAt } from "./describe";
import type { Layer } from "./matrix/layers";
import type { Stage } from "./stage";

/** @param value  null where there is no matrix, NaN in fluid that has no value */
export function probeText(layer: Layer, value: number | null, x: number, y: number): string {
  const place = `at x ${readable(Number(x.toFixed(1)))}, y ${readable(Number(y.toFixed(1)))} \u00b5m`;
  if (value === null) return `No matrix ${place}`;
  if (Number.isNaN(value)) return `${layer.name}: none, fluid, ${place}`;
  return `${layer.name} ${readable(value, 3)}${layer.unit ? ` ${layer.unit}` : ""} ${place}`;
}

export class Probe {
  private readonly words = h("output", { class: "probe", "aria-live": "off" });
  private readonly said = h("p", { class: "unseen", role: "status" });
  private readonly cross = h("div", { class: "cross", "aria-hidden": "true" });
  private pointer: { x: number; y: number } | null = null;
  /** Shown in the middle of the view. */
  private fixed = false;

  constructor(private readonly stage: Stage) {
    const { element } = stage;
    element.append(this.cross, this.words, this.said);
    element.addEventListener("pointermove", (event) => {
      const box = element.getBoundingClientRect();
      const onButton = event.target instanceof Element && event.target.closest("button");
      this.pointer = onButton ? null : { x: event.clientX - box.left, y: event.clientY - box.top };
      this.show();
    });
    element.addEventListener("pointerleave", () => {
      this.pointer = null;
      this.show();
    });
    stage.onPaint(() => this.show());
    this.show();
  }

  toggle(): void {
    this.fixed = !this.fixed;
    this.pointer = null;
    this.show();
    this.say();
  }

  /** For those who listen: after a key, not with every picture. */
  say(): void {
    this.said.textContent = this.fixed ? this.words.textContent : "";
  }

  /** "" also where cells are not drawn. */
  private cellAt(x: number, y: number): string {
    const { film, place, shown, camera } = this.stage;
    const onScreen = 6; // pixels
    return shown.cell ? cellTextAt(film, place, x, y, Math.max(2, onScreen / camera.scale)) : "";
  }

  private show(): void {
    const { camera, layer } = this.stage;
    const at = this.pointer ?? (this.fixed ? { x: 0.5 * camera.width, y: 0.5 * camera.height } : null);
    this.cross.hidden = !this.fixed || this.pointer !== null;
    this.words.hidden = at === null;
    if (!at) return;
    const [x, y] = [camera.fromScreenX(at.x), camera.fromScreenY(at.y)];
    const cell = this.cellAt(x, y);
    const text = probeText(layer, this.stage.valueAt(x, y), x, y) + (cell ? `. ${cell}` : "");
    if (this.words.textContent !== text) this.words.textContent = text;
  }
}
