/** Wheel, drag and pinch on the stage become zoom and pan of the camera. */
import type { Camera } from "./camera";

export function attachGestures(stage: HTMLElement, camera: Camera, changed: (panned: boolean) => void): void {
  const fingers = new Map<number, { x: number; y: number }>();
  const place = (event: MouseEvent) => {
    const box = stage.getBoundingClientRect();
    return { x: event.clientX - box.left, y: event.clientY - box.top };
  };

  stage.addEventListener(
    "wheel",
    (event) => {
      const { x, y } = place(event);
      const pixels = event.deltaMode === 1 ? 16 * event.deltaY : event.deltaY;
      // At the widest view the wheel is left to the page, so that nobody is caught in the picture.
      if (camera.zoom(Math.exp(-pixels / 300), x, y)) {
        event.preventDefault();
        changed(false);
      }
    },
    { passive: false },
  );

  stage.addEventListener("pointerdown", (event) => {
    if (event.button !== 0 || (event.target instanceof Element && event.target.closest("button"))) return;
    fingers.set(event.pointerId, place(event));
    stage.setPointerCapture(event.pointerId);
    stage.classList.add("dragging");
  });

  stage.addEventListener("pointermove", (event) => {
    const before = fingers.get(event.pointerId);
    if (!before) return;
    const now = place(event);
    const other = [...fingers].find(([id]) => id !== event.pointerId)?.[1];
    if (other) {
      const [was, is] = [
        Math.hypot(before.x - other.x, before.y - other.y),
        Math.hypot(now.x - other.x, now.y - other.y),
      ];
      if (was > 0 && is > 0) camera.zoom(is / was, 0.5 * (now.x + other.x), 0.5 * (now.y + other.y));
      camera.pan(0.5 * (now.x - before.x), 0.5 * (now.y - before.y));
    } else camera.pan(now.x - before.x, now.y - before.y);
    fingers.set(event.pointerId, now);
    changed(Math.hypot(now.x - before.x, now.y - before.y) > 0);
  });

  const release = (event: PointerEvent) => {
    fingers.delete(event.pointerId);
    if (fingers.size === 0) stage.classList.remove("dragging");
  };
  stage.addEventListener("pointerup", release);
  stage.addEventListener("pointercancel", release);
}
