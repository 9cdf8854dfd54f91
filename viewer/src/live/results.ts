/** What came of each run: a table for a class, which can be saved. Test: tests/live.test.ts */
import type { Tracks } from "../contract";
import { button, h, table } from "../dom";
import { readable } from "../numbers";
import { tracksOfCells } from "../run/cells";
import { download } from "../run/save/saving";
import { pascals, type Settings } from "./scenario";

export interface Result {
  E_Pa: number;
  seed: number;
  /** "" of a single cell. */
  cell: number | "";
  time_h: number;
  distance_um: number;
  speed_um_per_h: number;
  /** What else is not at its default: "fibres.arrangement = uniaxial; protrusion.number = 2". */
  other: string;
}

const columns = ["E_Pa", "seed", "cell", "time_h", "distance_um", "speed_um_per_h", "other"] as const satisfies readonly (keyof Result)[];
const heads = ["E (Pa)", "seed", "cell", "time (h)", "distance (\u00b5m)", "speed (\u00b5m/h)", "other settings"];

/** A row for each cell of a run.   @param changes  made on the way: "at 3 h: ecm.youngs_modulus = 50 Pa" */
export function resultsOf(tracks: Tracks, t: number, settings: Settings, changes: string[] = []): Result[] {
  const bare = (text: string) => text.replace(/^"(.*)"$/, "$1");
  const other = Object.entries(settings).filter(([path]) => path !== "ecm.youngs_modulus" && !path.startsWith("run."));
  const cells = tracksOfCells(tracks);
  return cells.map(({ number, tracks: own }) => {
    const { net, speed } = travelled(own, t);
    return {
      E_Pa: settings["ecm.youngs_modulus"] === undefined ? 200 : pascals(settings["ecm.youngs_modulus"]),
      seed: Number(settings["run.seed"] ?? 1),
      cell: cells.length > 1 ? number : "",
      time_h: t / 3600,
      distance_um: net,
      speed_um_per_h: speed ?? NaN,
      other: [...other.map(([path, value]) => `${path} = ${bare(value)}`), ...changes].join("; "),
    };
  });
}

function shown(value: Result[keyof Result]): string {
  if (typeof value === "string") return value;
  return Number.isFinite(value) ? String(Number(value.toPrecision(6))) : "";
}

/** As other programs read it. Texts that begin as formulas of spreadsheets are none. */
export function csv(all: Result[]): string {
  const quoted = (text: string) => (/[",\n]/.test(text) ? `"${text.replaceAll('"', '""')}"` : text);
  return [columns.join(","), ...all.map((row) => columns.map((name) => quoted(shown(row[name]))).join(","))].join("\n") + "\n";
}

/** @param present  the run as it is now */
export function results(present: () => Result[]) {
  const all: Result[] = [];
  const holder = h("div", {});
  const save = () => download("matrigrate-live-results.csv", csv(all));
  const saved = button("Save CSV", { name: "save-results", onclick: save });
  const text = (row: Result, name: keyof Result) =>
    typeof row[name] === "number" && name !== "seed" ? readable(row[name], 3) : String(row[name]);
  const draw = () => {
    saved.disabled = all.length === 0;
    const rows = all.map((row) => columns.map((name) => text(row, name)));
    const none = h("p", { class: "note" }, "Each run that reaches its end leaves a row here.");
    holder.replaceChildren(all.length > 0 ? table("Results", heads, rows, [0, 1, 2, 3, 4, 5]) : none);
  };
  /** Rows that are there already stay once. */
  const add = (rows: Result[]) => {
    const there = new Set(all.map((row) => csv([row])));
    all.push(...rows.filter((row) => !there.has(csv([row]))));
    draw();
  };
  const clear = () => {
    all.length = 0;
    draw();
  };
  draw();
  const added = button("Add the run as it is", { name: "add-result", onclick: () => add(present()) });
  const buttons = h("div", { class: "saving" }, saved, added, button("Clear", { name: "clear-results", onclick: clear }));
  return { element: h("details", { class: "results" }, h("summary", {}, "Results of the runs"), holder, buttons), add };
}

// How far the cells have come: what every question of the lesson asks for. Test: tests/parts.test.ts

export interface Travelled {
  /** From the start in a straight line, and along the path [um]. */
  net: number;
  path: number;
  /** The first, over the time since the start [um/h]; none in the first ten minutes, in which it says nothing. */
  speed?: number;
}

/** @param t  up to then [s]; the last row at or before it counts */
export function travelled({ t_s, x_um, y_um }: Tracks, t: number): Travelled {
  let path = 0;
  let last = 0;
  for (let i = 1; i < t_s.length && t_s[i] <= t; last = i++) path += Math.hypot(x_um[i] - x_um[i - 1], y_um[i] - y_um[i - 1]);
  const net = t_s.length ? Math.hypot(x_um[last] - x_um[0], y_um[last] - y_um[0]) : 0;
  const since = t_s.length ? t_s[last] - t_s[0] : 0;
  return since < 600 ? { net, path } : { net, path, speed: (3600 * net) / since };
}

/** "15.4 µm from the start, 7.1 µm/h; path 31 µm"; of several cells the distances of the first ones. */
export function travelledText(tracks: Tracks, t: number, most = 5): string {
  const cells = tracksOfCells(tracks).map((one) => travelled(one.tracks, t));
  if (cells.length > 1) {
    const rest = cells.length > most ? ` and ${cells.length - most} more` : "";
    return `From the start: ${cells.slice(0, most).map(({ net }) => readable(net, 3)).join(", ")} \u00b5m${rest}`;
  }
  const [{ net, path, speed }] = cells;
  return `${readable(net, 3)} \u00b5m from the start${speed === undefined ? "" : `, ${readable(speed, 3)} \u00b5m/h`}; path ${readable(path, 3)} \u00b5m`;
}
