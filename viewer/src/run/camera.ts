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

  constructor(private readonly whole: Box) {}

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

  showWhole(): void {
    this.show(this.whole);
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
