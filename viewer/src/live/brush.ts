/** Drawing into the matrix by mouse, finger or pen. */
import { button, choice, h, isDark } from "../dom";
import { onButton, placeOn } from "../run/camera";
import type { Stage } from "../run/stage";
import { brushes, type Stroke, type StrokeKind } from "./scenario";

export type Brush = ReturnType<typeof brush>;

/** @param drawn  a stroke is finished   @param cleared  all are to go */
export function brush(drawn: (stroke: Stroke) => void, cleared: () => void) {
  let kind: StrokeKind | null = null;
  const size = h("output", {}, "10 \u00b5m");
  const range = { type: "range", min: 2, max: 40, step: 1, value: 10, "aria-label": "Radius of the brush" };
  const oninput = ({ value }: HTMLInputElement) => (size.textContent = `${value} \u00b5m`);
  const radius = h("input", { name: "brush-radius", ...range, oninput });
  /** Shows on the stage that is drawn on whether a drag draws. */
  let mark = (): void => undefined;
  const radio = (value: StrokeKind | null, name: string) => {
    const { input, label } = choice({ type: "radio", name: "brush", value: value ?? "look", checked: value === null }, name, () => {
      kind = value;
      mark();
    });
    if (value) input.after(h("span", { class: "dot", style: `background:${brushes[value].colour}` }));
    return label;
  };
  const element = h(
    "form",
    { class: "brush", "aria-label": "Draw into the matrix" },
    h("span", { class: "brush-title" }, "Drag to"),
    radio(null, "move the view"),
    ...Object.entries(brushes).map(([key, one]) => radio(key as StrokeKind, one.name.toLowerCase())),
    h("label", {}, "Radius", radius, size),
    button("Remove what is drawn", { onclick: cleared }),
  );

  /** Draws on a stage from now on, in place of the one before, and shows there what has been drawn. */
  const attach = (stage: Stage, strokes: () => Stroke[]) => {
    const over = h("canvas", { class: "drawn" });
    stage.element.append(over);
    let now: Stroke | null = null;
    const paint = () => {
      const { camera } = stage;
      const pixels = Math.min(2, devicePixelRatio || 1);
      const [w, t] = [Math.round(camera.width * pixels), Math.round(camera.height * pixels)];
      const all = now ? [...strokes(), now] : strokes();
      over.hidden = all.length === 0;
      if (all.length === 0) return;
      if (over.width !== w || over.height !== t) [over.width, over.height] = [w, t];
      const c = over.getContext("2d");
      if (!c) return;
      c.setTransform(pixels, 0, 0, pixels, 0, 0);
      c.clearRect(0, 0, camera.width, camera.height);
      c.lineCap = c.lineJoin = "round";
      for (const stroke of all) {
        c.globalAlpha = stroke === now ? 0.45 : isDark() ? 0.3 : 0.22;
        c.strokeStyle = brushes[stroke.kind].colour;
        c.lineWidth = 2 * stroke.radius * camera.scale;
        c.beginPath();
        const { points } = stroke;
        c.moveTo(camera.toScreenX(points[0]), camera.toScreenY(points[1]));
        if (points.length === 2) c.lineTo(camera.toScreenX(points[0]) + 0.01, camera.toScreenY(points[1]));
        for (let k = 2; k < points.length; k += 2) c.lineTo(camera.toScreenX(points[k]), camera.toScreenY(points[k + 1]));
        c.stroke();
      }
    };
    stage.on("paint", paint);
    mark = () => stage.element.classList.toggle("drawing", kind !== null);
    mark();
    const place = (event: PointerEvent) => {
      const { x, y } = placeOn(stage.element, event);
      return [stage.camera.fromScreenX(x), stage.camera.fromScreenY(y)].map((v) => Number(v.toFixed(1)));
    };
    // Before the gestures that move the view.
    const on = (type: "pointerdown" | "pointermove" | "pointerup" | "pointercancel", act: (event: PointerEvent) => void) =>
      stage.element.addEventListener(type, act, { capture: true });
    on("pointerdown", (event) => {
      if (kind === null || event.button !== 0 || onButton(event)) return;
      event.stopImmediatePropagation();
      stage.setFollow(false);
      stage.element.setPointerCapture(event.pointerId);
      now = { kind, radius: Number(radius.value), points: place(event) };
      stage.draw();
    });
    on("pointermove", (event) => {
      if (!now) return;
      event.stopImmediatePropagation();
      const [x, y] = place(event);
      const { points } = now;
      // No closer than the drawn line can show.
      if (Math.hypot(x - points[points.length - 2], y - points[points.length - 1]) < 0.25 * now.radius) return;
      points.push(x, y);
      stage.draw();
    });
    on("pointerup", () => {
      if (!now) return;
      const done = now;
      now = null;
      drawn(done);
    });
    on("pointercancel", () => {
      now = null;
      stage.draw();
    });
  };
  return { element, attach };
}
