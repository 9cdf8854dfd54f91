/** A made-up run, and a real run folder with a made-up film: the latter shows real tables. */
import { existsSync, readFileSync } from "node:fs";
import { join } from "node:path";
import type { ChangedParameter, NamedValue, ProtrusionRow, RunPage, Tracks } from "../src/contract";
import { sampleFrames } from "./frames";
import { outlinePoints, protrusionRows, tracks as madeTracks } from "./life";
import { random } from "./pack";

const citation =
  "Heck T, Vargas DA, Smeets B, Ramon H, Van Liedekerke P, Van Oosterwyck H (2020) The role of actin protrusion dynamics in cell " +
  "migration through a degradable viscoelastic extracellular matrix: Insights from a computational model. PLoS Comput " +
  "Biol 16(1): e1007250.";

export interface RunOptions {
  seed?: number;
  radius?: number;
  interval?: number;
  end?: number;
  fibres?: boolean;
  noise?: number;
  /** Without frames: as a run whose fields were turned off. */
  still?: boolean;
}

function page(options: RunOptions, tracks: Tracks, protrusions: ProtrusionRow[], end: number): RunPage {
  const [radius, spacing] = [options.radius ?? 150, 2];
  const made = options.still
    ? null
    : sampleFrames(tracks, protrusions, end, {
        radius,
        spacing,
        interval: options.interval ?? 300,
        fibres: options.fibres ?? true,
        noise: options.noise ?? 0,
      });
  return {
    format: "matrigrate-run",
    version: 1,
    title: `sample: E = 100 Pa, seed ${options.seed ?? 1}`,
    status: `Done: ${end / 3600} h, 54000 steps.`,
    summary: `9.87 um/h from start to end, persistent (MSD slope 1.42), ${protrusions.length} protrusions.`,
    facts: [
      { name: "scenario", value: "sample" },
      { name: "command", value: "matrigrate run sample.toml --set 'ecm.radius=150 um'" },
      { name: "trajectory hash", value: "0123456789abcdef" },
    ],
    t_end_s: end,
    geometry: {
      radius_um: radius,
      spacing_um: spacing,
      n_particles: made?.particles ?? 17665,
      n_outline: outlinePoints,
    },
    frames: made?.frames ?? null,
    tracks,
    protrusions,
    readouts: [],
    parameters: [],
    health: [],
    provenance: "matrigrate 0.1.0\nbuild          Release: -O3 -DNDEBUG\nthreads        2",
    citation,
  };
}

export function sampleRun(options: RunOptions = {}): RunPage {
  const u = random(options.seed ?? 7);
  const end = options.end ?? 21600;
  const rows = protrusionRows(u, end);
  const run = page(options, madeTracks(u, end, rows), rows, end);
  run.readouts = [
    { name: "v_migr_abs_um_per_h", meaning: "speed, start to end (um/h)", value: 9.871 },
    { name: "n_protrusions", meaning: "protrusions initiated", value: rows.length },
    { name: "path_angle_deg", meaning: "mean angle of the path to uniaxial fibres, each step of 600 s weighted by its length [degrees]", value: null },
  ];
  run.parameters = [
    { name: "ecm.youngs_modulus", value: "100 Pa", default: "200 Pa", meaning: "Young's modulus of the intact matrix" },
  ];
  run.health = [
    { name: "solver_iterations_max", meaning: "most iterations of the solver in a step", value: 17 },
    { name: "solver_residual_max", meaning: "largest relative residual", value: 9.9e-5 },
  ];
  return run;
}

type Table = Record<string, string[]>;

function csv(file: string): Table {
  const [head, ...lines] = readFileSync(file, "utf8")
    .trim()
    .split("\n")
    .map((line) => line.split(","));
  return Object.fromEntries(head.map((name, i) => [name, lines.map((line) => line[i])]));
}

const numbers = (column: string[]): number[] => column.map(Number);
const numberOrNull = (text: string): number | null => (text === "" ? null : Number(text));

function changed(folder: string): ChangedParameter[] {
  const schema = "../docs/parameters.md";
  if (!existsSync(schema)) return [];
  const defaults = new Map<string, { value: string; meaning: string }>();
  let group = "";
  for (const line of readFileSync(schema, "utf8").split("\n")) {
    group = /^## \[(\w+)\]/.exec(line)?.[1] ?? group;
    const cells = line.split("|").map((cell) => cell.trim().replace(/^`|`$/g, ""));
    if (group && cells.length > 6) defaults.set(`${group}.${cells[1]}`, { value: cells[2], meaning: cells[5] });
  }
  const out: ChangedParameter[] = [];
  for (const line of readFileSync(join(folder, "scenario.resolved.toml"), "utf8").split("\n")) {
    group = /^\[(\w+)\]/.exec(line)?.[1] ?? group;
    const [key, value] = line.split(" = ");
    const known = defaults.get(`${group}.${key}`);
    if (known && value !== known.value && `${group}.${key}` !== "run.seed")
      out.push({
        name: `${group}.${key}`,
        value: value.replace(/"/g, ""),
        default: known.value.replace(/"/g, ""),
        meaning: known.meaning,
      });
  }
  return out;
}

export function runFromFolder(folder: string): RunPage {
  const t = csv(join(folder, "tracks.csv"));
  const p = csv(join(folder, "protrusions.csv"));
  const health = csv(join(folder, "health.csv"));
  const tracks: Tracks = {
    t_s: numbers(t["t_s"]),
    x_um: numbers(t["x_um"]),
    y_um: numbers(t["y_um"]),
    area_um2: numbers(t["area_um2"]),
    perimeter_um: numbers(t["perimeter_um"]),
    polarization_rad: t["polarization_rad"].map(numberOrNull),
    n_simultaneous: numbers(t["n_simultaneous"]),
  };
  const rows = p["id"].map(
    (_, i) =>
      Object.fromEntries(
        Object.entries(p).map(([key, column]) => [key, key === "cause" ? column[i] || null : numberOrNull(column[i])]),
      ) as unknown as ProtrusionRow,
  );
  const run = page({}, tracks, rows, tracks.t_s[tracks.t_s.length - 1]);
  const summary = JSON.parse(readFileSync(join(folder, "summary.json"), "utf8")) as Record<string, number | null>;
  const meta = JSON.parse(readFileSync(join(folder, "run.json"), "utf8")) as Record<string, unknown>;
  run.title = `Migration run, seed ${String(meta["seed"])}`;
  run.status = `Done: 6 h, ${String(meta["steps"])} steps. The film on this page is made up; the tables and plots are real.`;
  run.readouts = Object.entries(summary).map(([name, value]) => ({ name, meaning: name.replace(/_/g, " "), value }));
  run.parameters = changed(folder);
  const most = (name: string, meaning: string): NamedValue => ({
    name,
    meaning,
    value: Math.max(...numbers(health[name])),
  });
  run.health = [
    most("solver_iterations_max", "most iterations of the solver in a step"),
    most("solver_residual_max", "largest relative residual"),
    most("n_orphans", "particles that became fluid for want of neighbours"),
    most("n_torn", "particles torn"),
    most("n_solid_inside", "solid particles inside the cell"),
    most("deepest_solid_um", "deepest of them [um]"),
    most("crosses_itself", "cortex crosses itself (1: yes)"),
  ];
  run.provenance = JSON.stringify(meta, null, 1)
    .replace(/[{}",[\]]/g, "")
    .replace(/\n\s*\n/g, "\n")
    .trim();
  return run;
}
