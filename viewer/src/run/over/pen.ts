/** The pen of the signs: the part of a canvas's context that a writer of vector pictures can implement too. */
export type Pen = Pick<
  CanvasRenderingContext2D,
  | "lineJoin"
  | "lineCap"
  | "lineWidth"
  | "strokeStyle"
  | "fillStyle"
  | "font"
  | "setLineDash"
  | "beginPath"
  | "moveTo"
  | "lineTo"
  | "closePath"
  | "arc"
  | "stroke"
  | "fill"
  | "save"
  | "clip"
  | "restore"
  | "fillRect"
  | "fillText"
  | "measureText"
> & {
  /** Names what is drawn from here on, where the picture can hold names. */
  part?: (name: string) => void;
};

export interface Ink {
  line: string;
  /** Around lines and behind words, so that both are seen on any ground. */
  edge: string;
}

export const ink = (dark: boolean): Ink =>
  dark ? { line: "#ffffff", edge: "#14171a" } : { line: "#1f2328", edge: "#ffffff" };

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
