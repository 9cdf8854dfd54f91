/** Which part of the plane is seen: y points up in the model and down on the screen. */

export interface Box {
  left: number;
  right: number;
  bottom: number;
  top: number;
}

export class Camera {
  x = 0;
  y = 0;
  /** Pixels (of the page) a um. */
  scale = 1;
  width = 1;
  height = 1;
  private smallest = 0.1;

  constructor(readonly whole: Box) {}

  resize(width: number, height: number): void {
    // The visible width in um is kept when a window or a phone is turned.
    this.scale *= Math.min(width, height) / Math.min(this.width, this.height);
    this.width = width;
    this.height = height;
    this.smallest = 0.9 * this.fitting(this.whole);
  }

  private fitting(box: Box): number {
    return Math.min(this.width / (box.right - box.left), this.height / (box.top - box.bottom));
  }

  show(box: Box): void {
    this.x = 0.5 * (box.left + box.right);
    this.y = 0.5 * (box.bottom + box.top);
    this.scale = this.fitting(box);
  }

  toScreenX(x: number): number {
    return 0.5 * this.width + this.scale * (x - this.x);
  }

  toScreenY(y: number): number {
    return 0.5 * this.height - this.scale * (y - this.y);
  }

  fromScreenX(sx: number): number {
    return this.x + (sx - 0.5 * this.width) / this.scale;
  }

  fromScreenY(sy: number): number {
    return this.y - (sy - 0.5 * this.height) / this.scale;
  }

  pan(dx: number, dy: number): void {
    this.x -= dx / this.scale;
    this.y += dy / this.scale;
    this.x = Math.min(this.whole.right, Math.max(this.whole.left, this.x));
    this.y = Math.min(this.whole.top, Math.max(this.whole.bottom, this.y));
  }

  /** About a point of the screen, which stays where it is. Returns whether anything changed. */
  zoom(factor: number, sx = 0.5 * this.width, sy = 0.5 * this.height): boolean {
    const scale = Math.min(200, Math.max(this.smallest, this.scale * factor));
    if (Math.abs(scale - this.scale) < 1e-9) return false;
    const [dx, dy] = [sx - 0.5 * this.width, sy - 0.5 * this.height];
    this.x += dx / this.scale - dx / scale;
    this.y -= dy / this.scale - dy / scale;
    this.scale = scale;
    return true;
  }
}

/** Where the pointer is on an element. */
export function placeOn(element: Element, { clientX, clientY }: MouseEvent): { x: number; y: number } {
  const box = element.getBoundingClientRect();
  return { x: clientX - box.left, y: clientY - box.top };
}

export const onButton = ({ target }: Event): boolean => target instanceof Element && target.closest("button") !== null;

/** Wheel, drag and pinch on the stage become zoom and pan of the camera. */
export function attachGestures(stage: HTMLElement, camera: Camera, changed: (panned: boolean) => void): void {
  const fingers = new Map<number, { x: number; y: number }>();
  const place = (event: MouseEvent) => placeOn(stage, event);
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
    if (event.button !== 0 || onButton(event)) return;
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
      const [was, is] = [before, now].map(({ x, y }) => Math.hypot(x - other.x, y - other.y));
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
