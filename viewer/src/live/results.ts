/** What came of each run: a table for a class, which can be saved. Test: tests/live.test.ts */
import type { Tracks } from "../contract";
import { h, table } from "../dom";
import { readable } from "../numbers";
import { tracksOfCells } from "../run/cells";
import { pascals, type Settings } from "./scenario";
import { travelled } from "./travelled";

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

const shown = (value: Result[keyof Result]): string => (typeof value === "number" ? (Number.isFinite(value) ? String(Number(value.toPrecision(6))) : "") : value);

/** As other programs read it. Texts that begin as formulas of spreadsheets are none. */
export function csv(all: Result[]): string {
  const quoted = (text: string) => (/[",\n]/.test(text) ? `"${text.replaceAll('"', '""')}"` : text);
  return [columns.join(","), ...all.map((row) => columns.map((name) => quoted(shown(row[name]))).join(","))].join("\n") + "\n";
}

export interface Results {
  element: HTMLElement;
  /** Rows that are there already stay once. */
  add(rows: Result[]): void;
}

/** @param save  offers a file   @param present  the run as it is now */
export function results(save: (name: string, content: string) => void, present: () => Result[]): Results {
  const all: Result[] = [];
  const holder = h("div", {});
  const button = (text: string, name: string, act: () => void) => {
    const made = h("button", { type: "button", name }, text);
    made.addEventListener("click", act);
    return made;
  };
  const saved = button("Save CSV", "save-results", () => save("matrigrate-live-results.csv", csv(all)));
  const draw = () => {
    saved.disabled = all.length === 0;
    const rows = all.map((row) => columns.map((name) => (typeof row[name] === "number" && name !== "seed" ? readable(row[name], 3) : String(row[name]))));
    holder.replaceChildren(
      all.length > 0 ? table(heads, rows, { numeric: [0, 1, 2, 3, 4, 5], caption: "Results" }) : h("p", { class: "note" }, "Each run that reaches its end leaves a row here."),
    );
  };
  const add = (rows: Result[]) => {
    const there = new Set(all.map((row) => csv([row])));
    all.push(...rows.filter((row) => !there.has(csv([row]))));
    draw();
  };
  draw();
  const buttons = h("div", { class: "saving" }, saved, button("Add the run as it is", "add-result", () => add(present())), button("Clear", "clear-results", () => (all.splice(0), draw())));
  return { element: h("details", { class: "results" }, h("summary", {}, "Results of the runs"), holder, buttons), add };
}
