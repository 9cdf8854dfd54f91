/** Pens that draw what lies over the matrix, on a canvas or as vector graphics, and what all of it is drawn with. */

/** What the context of a canvas and the writer of vector graphics have in common. */
export type Pen = Pick<CanvasRenderingContext2D, Extract<keyof SvgPen, keyof CanvasRenderingContext2D>> & {
  /** Names what is drawn from here on, where the picture can hold names. */
  part?: (name: string) => void;
};

export interface Ink {
  line: string;
  /** Around lines and behind words, so that both are seen on any ground. */
  edge: string;
  /** Behind scales. */
  veil: string;
}

export const ink = (dark: boolean): Ink =>
  dark
    ? { line: "#ffffff", edge: "#14171a", veil: "rgba(20,23,26,.8)" }
    : { line: "#1f2328", edge: "#ffffff", veil: "rgba(255,255,255,.85)" };

export const labelFont = "600 14px system-ui, 'Segoe UI', Helvetica, Arial, sans-serif";

const widths = new Map<string, number>();
const mostWidths = 500;

/** Width of a text in the pen's font [pixels]; measured once, since a page that plays asks thirty times a second. */
export function textWidth(c: Pen, text: string): number {
  const key = `${c.font}\n${text}`;
  const known = widths.get(key);
  if (known !== undefined) return known;
  if (widths.size >= mostWidths) widths.clear();
  const { width } = c.measureText(text);
  widths.set(key, width);
  return width;
}

/** Strokes the present path in a colour, with an edge of another, `rim` wide. */
export function edged(c: Pen, colour: string, edge: string, width: number, dash: number[] = [], rim = 1): void {
  c.lineJoin = c.lineCap = "round";
  c.setLineDash([]);
  c.strokeStyle = edge;
  c.lineWidth = width + 2 * rim;
  c.stroke();
  c.lineCap = dash.length > 0 ? "butt" : "round";
  c.setLineDash(dash);
  c.strokeStyle = colour;
  c.lineWidth = width;
  c.stroke();
  c.setLineDash([]);
}

/** Adds a line to the path. */
export const polyline = (c: Pen, points: [number, number][]): void =>
  points.forEach(([x, y], i) => (i === 0 ? c.moveTo(x, y) : c.lineTo(x, y)));

/** Adds an arrow to the path; its head is at most `head` pixels long. */
export function arrow(c: Pen, x: number, y: number, dx: number, dy: number, head: number): void {
  const length = Math.hypot(dx, dy);
  if (length < 1e-9) return;
  const k = Math.min(head, 0.4 * length) / length;
  c.moveTo(x, y);
  c.lineTo(x + dx, y + dy);
  c.moveTo(x + dx - k * (dx + 0.6 * dy), y + dy - k * (dy - 0.6 * dx));
  c.lineTo(x + dx, y + dy);
  c.lineTo(x + dx - k * (dx - 0.6 * dy), y + dy - k * (dy + 0.6 * dx));
}

const number = (v: number): string => String(Math.round(100 * v) / 100);
export const escaped = (text: string): string => text.replace(/&/g, "&amp;").replace(/</g, "&lt;").replace(/"/g, "&quot;");

/** Writes paths and text of an SVG file. */
export class SvgPen {
  lineJoin: CanvasLineJoin = "miter";
  lineCap: CanvasLineCap = "butt";
  lineWidth = 1;
  strokeStyle: CanvasFillStrokeStyles["strokeStyle"] = "#000";
  fillStyle: CanvasFillStrokeStyles["fillStyle"] = "#000";
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
