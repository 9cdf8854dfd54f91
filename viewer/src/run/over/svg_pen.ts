/** A pen that writes vector graphics: what is drawn on the stage's upper canvas, as paths and text of an SVG file. */
import type { Pen } from "./pen";

const number = (v: number): string => String(Math.round(100 * v) / 100);
export const escaped = (text: string): string => text.replace(/&/g, "&amp;").replace(/</g, "&lt;").replace(/"/g, "&quot;");

export class SvgPen implements Pen {
  lineJoin: CanvasLineJoin = "miter";
  lineCap: CanvasLineCap = "butt";
  lineWidth = 1;
  strokeStyle: Pen["strokeStyle"] = "#000";
  fillStyle: Pen["fillStyle"] = "#000";
  font = "14px sans-serif";
  private dash: number[] = [];
  private path = "";
  private readonly out: string[] = [];
  private clips = 0;
  /** Groups open in each saved state. */
  private readonly saved: number[] = [];
  private inPart = false;
  private readonly ruler = document.createElement("canvas").getContext("2d");

  /** @param id  ends all names, so that several drawings can stand in a document */
  constructor(private readonly id = "") {}

  part = (name: string): void => {
    if (this.inPart) this.out.push("</g>");
    this.out.push(`<g id="${escaped(name)}${this.id}">`);
    this.inPart = true;
  };

  /** All that was drawn. */
  content(): string {
    return this.out.join("\n") + (this.inPart ? "\n</g>" : "");
  }

  setLineDash(dash: Iterable<number>): void {
    this.dash = [...dash];
  }

  beginPath(): void {
    this.path = "";
  }

  moveTo(x: number, y: number): void {
    this.path += `M${number(x)} ${number(y)}`;
  }

  /** On a canvas, the first point of a path may be a line's. */
  lineTo(x: number, y: number): void {
    this.path += `${this.path === "" ? "M" : "L"}${number(x)} ${number(y)}`;
  }

  closePath(): void {
    this.path += "Z";
  }

  /** Full circles alone: nothing else is drawn. */
  arc(x: number, y: number, radius: number): void {
    const [r, d] = [number(radius), number(2 * radius)];
    this.path += `M${number(x - radius)} ${number(y)}a${r} ${r} 0 1 0 ${d} 0a${r} ${r} 0 1 0 -${d} 0Z`;
  }

  stroke(): void {
    if (this.path === "") return;
    // Transparency as an attribute of its own, which every reader knows.
    const [, colour, opacity] = /^rgba\((.*),([\d.]+)\)$/.exec(String(this.strokeStyle)) ?? [];
    const stroke = colour ? `rgb(${colour})" stroke-opacity="${opacity}` : String(this.strokeStyle);
    const dash = this.dash.length > 0 ? ` stroke-dasharray="${this.dash.join(" ")}"` : "";
    this.out.push(
      `<path d="${this.path}" fill="none" stroke="${stroke}" stroke-width="${number(this.lineWidth)}" ` +
        `stroke-linecap="${this.lineCap}" stroke-linejoin="${this.lineJoin}"${dash}/>`,
    );
  }

  fill(): void {
    if (this.path !== "") this.out.push(`<path d="${this.path}" fill="${String(this.fillStyle)}"/>`);
  }

  save(): void {
    this.saved.push(0);
  }

  clip(): void {
    const id = `clip-${++this.clips}${this.id}`;
    this.out.push(`<clipPath id="${id}"><path d="${this.path}"/></clipPath>`, `<g clip-path="url(#${id})">`);
    if (this.saved.length > 0) ++this.saved[this.saved.length - 1];
  }

  restore(): void {
    for (let open = this.saved.pop() ?? 0; open > 0; --open) this.out.push("</g>");
  }

  fillRect(x: number, y: number, width: number, height: number): void {
    this.out.push(
      `<rect x="${number(x)}" y="${number(y)}" width="${number(width)}" height="${number(height)}" fill="${String(this.fillStyle)}"/>`,
    );
  }

  fillText(text: string, x: number, y: number): void {
    const [, weight, size] = /^(?:(\d+|bold) )?(\S+)px/.exec(this.font) ?? [];
    this.out.push(
      `<text x="${number(x)}" y="${number(y)}" fill="${String(this.fillStyle)}" font-family="Helvetica, Arial, sans-serif" ` +
        `font-size="${size ?? 14}"${weight ? ` font-weight="${weight}"` : ""}>${escaped(text)}</text>`,
    );
  }

  measureText(text: string): TextMetrics {
    if (!this.ruler) return { width: 8 * text.length } as TextMetrics;
    this.ruler.font = this.font;
    return this.ruler.measureText(text);
  }
}
