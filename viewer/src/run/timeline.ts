/** The life of each protrusion, one row each: its phases over time, how mature it got, and how it ended. */
import { phaseNames, type ProtrusionRow, type TimedChange } from "../contract";
import { h, phaseDot, phaseFill, s, table } from "../dom";
import { readable, timeText } from "../numbers";
import { coloursOf } from "./cells";
import type { Clock } from "./clock";
import { changeMarks, figure, frame, hours, onPick } from "./plots";

interface Bar {
  phase: number;
  from: number;
  to: number;
}

/** Phases from the times of a row; what has not ended goes on to the end of the run. */
export function bars(row: ProtrusionRow, end: number): Bar[] {
  const starts = [row.t_initiation_s, row.t_adhesion_s, row.t_mature_s, row.t_disassembly_s, row.t_end_s ?? end];
  return starts.slice(0, 4).flatMap((from, phase) => {
    const to = starts.slice(phase + 1).find((t) => t !== null)!;
    return from === null ? [] : [{ phase, from, to }];
  });
}

const causes: Record<string, string> = { disassembly: "disassembled", rupture: "ruptured", unadhered: "never adhered" };
const causeText = (row: ProtrusionRow): string =>
  row.cause ? (causes[row.cause] ?? row.cause) : row.t_mature_s !== null ? "still adheres" : "still alive";

function story(row: ProtrusionRow): string {
  const lines = [`${row.cell === undefined ? "Protrusion" : `Cell ${row.cell}, protrusion`} ${row.id}: ${causeText(row)}`, `initiated at ${timeText(row.t_initiation_s)}`];
  if (row.length_um !== null) lines.push(`length ${readable(row.length_um, 3)} \u00b5m at the end of growth`);
  if (row.f_mat !== null) lines.push(`matured to f_mat = ${readable(row.f_mat, 2)}`);
  if (row.t_disassembly_s !== null && row.t_mature_s !== null)
    lines.push(`adhered for ${readable((row.t_disassembly_s - row.t_mature_s) / 60, 3)} min after maturation`);
  if (row.force_nN !== null) lines.push(`force ${readable(row.force_nN, 3)} nN at disassembly`);
  return lines.join("\n");
}

/** The remark behind the bars of a row, as short as its room. */
function remark(row: ProtrusionRow, wide: boolean): string {
  if (row.cause === "unadhered") return wide ? "never adhered" : "\u2013";
  const parts = [];
  if (row.f_mat !== null) parts.push(`${wide ? "maturation " : ""}${readable(row.f_mat, 2)}`);
  if (row.force_nN !== null) parts.push(`${readable(row.force_nN, 2)} nN`);
  if (row.cause === "rupture") parts.push("ruptured");
  return parts.join(wide ? ", " : " ");
}

/** "3", or of several cells "2/3": the third of cell 2. */
const rowName = (row: ProtrusionRow): string => (row.cell === undefined ? String(row.id) : `${row.cell}/${row.id}`);

/** @param gone  when this timeline is taken away */
export function timeline(
  rows: ProtrusionRow[],
  clock: Clock,
  width: number,
  gone: AbortSignal,
  changes?: TimedChange[],
): HTMLElement {
  if (rows.length === 0) return h("p", {}, "No protrusion was initiated.");
  const [pitch, top, bottom] = [22, 22, 40];
  const height = top + bottom + pitch * rows.length;
  const rowsAxis = { low: 0, high: rows.length, label: "", ticks: [] };
  const label = "Phases of each protrusion over time; the table below has the numbers";
  const made = frame(width, height, hours(clock), rowsAxis, label);
  const wide = width > 700;
  const cells = Math.max(1, ...rows.map((row) => row.cell ?? 1));
  const right = made.x(clock.end / 3600);
  const remarks = s("g", { class: "remarks" });
  rows.forEach((row, k) => {
    const y = top + pitch * k;
    const all = bars(row, clock.end);
    const last = made.x(all[all.length - 1].to / 3600);
    const first = made.x(row.t_initiation_s / 3600);
    const text = remark(row, wide);
    const need = 7.2 * text.length + 12;
    const after = last + need < right;
    const before = !after && first - need > made.x(0);
    const group = s(
      "g",
      {},
      s("title", {}, story(row)),
      s("rect", { class: "row", x: made.x(0), y, width: right - made.x(0), height: pitch }),
      s("text", { x: made.x(0) - 8, y: y + 15.5, "text-anchor": "end" }, rowName(row)),
    );
    if (row.cell !== undefined)
      group.append(s("rect", { x: made.x(0) - 5, y: y + 1, width: 4, height: pitch - 2, fill: coloursOf(row.cell, cells).rear }));
    for (const { phase, from, to } of all) {
      const width = Math.max(1, made.x(to / 3600) - made.x(from / 3600));
      group.append(s("rect", { style: `fill:${phaseFill(phase)}`, x: made.x(from / 3600), y: y + 4, height: pitch - 8, width }));
    }
    // Without room on either side, the tooltip and the table still have the remark.
    const place = { x: after ? last + 6 : first - 6, y: y + 15.5, "text-anchor": after ? "start" : "end" };
    if (after || before) remarks.append(s("text", { class: "remark", ...place }, text));
    made.svg.append(group);
  });
  // Above the numbers: turned by a quarter it would be cut off where there are few rows.
  made.svg.append(s("text", { x: 2, y: 13 }, rows[0].cell === undefined ? "protrusion" : "cell/protrusion"));
  const cursor = s("path", { class: "cursor" });
  made.svg.append(...changeMarks(made, changes, top, height - bottom), cursor, remarks);
  let drawn = "";
  const update = () => {
    const d = `M${made.x(clock.time / 3600).toFixed(1)} ${top}V${height - bottom}`;
    if (d !== drawn) cursor.setAttribute("d", (drawn = d));
  };
  clock.onChange(update, gone);
  update();
  onPick(made, (x) => clock.jump(3600 * made.toX(x)));
  const legend = h("ul", { class: "signs" }, ...phaseNames.map((name, k) => h("li", {}, phaseDot(k), name)));
  const caption = "Behind each row: maturation (f_mat) and force at disassembly. A click moves the player to that time.";
  const drawing = figure(made.svg, caption);
  drawing.className = "timeline";
  return h("div", {}, legend, drawing);
}

export function protrusionTable(rows: ProtrusionRow[]): HTMLElement {
  const minutes = (seconds: number | null) => (seconds === null ? "\u2013" : (seconds / 60).toFixed(1));
  const columns: [head: string, cell: (row: ProtrusionRow) => string][] = [
    ["id", (row) => String(row.id)],
    ["initiated (min)", (row) => minutes(row.t_initiation_s)],
    ["adhered (min)", (row) => minutes(row.t_adhesion_s)],
    ["matured (min)", (row) => minutes(row.t_mature_s)],
    ["disassembled (min)", (row) => minutes(row.t_disassembly_s)],
    ["ended (min)", (row) => minutes(row.t_end_s)],
    ["length (\u00b5m)", (row) => readable(row.length_um, 3)],
    ["maturation", (row) => readable(row.f_mat, 2)],
    ["force at disassembly (nN)", (row) => readable(row.force_nN, 3)],
    ["share of its largest force", (row) => readable(row.f_adh_rel, 3)],
    ["how it ended", causeText],
  ];
  if (rows.some((row) => row.cell !== undefined)) columns.unshift(["cell", (row) => String(row.cell)]);
  const cells = rows.map((row) => columns.map(([, cell]) => cell(row)));
  return table("Protrusions", columns.map(([head]) => head), cells, columns.slice(1).map((_, k) => k));
}
