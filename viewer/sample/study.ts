/** A made-up study: stiffness of the matrix against sensitivity of adhesions, twelve runs each. */
import type { GridPoint, StudyGroup, StudyPage, StudyRun, StudyTest } from "../src/study/contract";
import { normal, type Random, random } from "./pack";
import { sampleRun } from "./run";

const stiffness = [50, 100, 200, 300, 400];
const sensitivity = ["2e4 1/N", "8e4 1/N"];
const names = ["v_migr_abs_um_per_h", "n_protrusions", "tau_prot_min", "l_prot_um", "f_mat"];

const mean = (v: number[]): number => v.reduce((a, b) => a + b, 0) / v.length;
const variance = (v: number[]): number => v.reduce((a, b) => a + (b - mean(v)) ** 2, 0) / (v.length - 1);
/** Two-sided, as if degrees of freedom were many: good enough for made-up data. */
function pOf(t: number): number {
  const z = Math.abs(t);
  const k = 1 / (1 + 0.2316419 * z);
  const tail =
    (Math.exp((-z * z) / 2) / Math.sqrt(2 * Math.PI)) *
    k *
    (0.31938153 + k * (-0.356563782 + k * (1.781477937 + k * (-1.821255978 + k * 1.330274429))));
  return Math.min(1, 2 * tail);
}

function run(u: Random, point: GridPoint, seed: number): StudyRun {
  const rise = 1 - Math.exp(-stiffness[point[0]] / 110);
  const drift = 0.4 + 0.02 * seed;
  const path = { x_um: [0], y_um: [0] };
  const heading = 2 * Math.PI * u();
  for (let i = 0; i < 72; ++i) {
    path.x_um.push(path.x_um[i] + rise * (drift * Math.cos(heading) + 1.3 * normal(u)));
    path.y_um.push(path.y_um[i] + rise * (drift * Math.sin(heading) + 1.3 * normal(u)));
  }
  const [cx, cy] = [path.x_um[72], path.y_um[72]];
  const arms = [0, 1, 2].map(() => ({ at: 2 * Math.PI * u(), long: 22 * u() }));
  const ring = Array.from({ length: 120 }, (_, i) => {
    const a = (2 * Math.PI * i) / 120;
    const r = 14 + arms.reduce((sum, arm) => sum + arm.long * Math.exp(-(((Math.cos(a - arm.at) - 1) / 0.02) ** 2)), 0);
    return [cx + r * Math.cos(a), cy + r * Math.sin(a)];
  });
  const failed = u() < 0.03;
  const n = Math.round(8 + 9 * rise + 1.6 * normal(u) - 2 * point[1]);
  return {
    id: `${stiffness[point[0]]}-${point[1]}-${seed}`,
    point,
    replicate: seed,
    seed,
    status: failed ? "failed" : "done",
    reason: failed ? "the solver gave up after 5000 iterations at 2 h 13 min" : "",
    report: `runs/${stiffness[point[0]]}-${point[1]}-${seed}/report.html`,
    readouts: failed
      ? {}
      : {
          v_migr_abs_um_per_h: Math.max(0.3, 2 + 9 * rise + 2.6 * normal(u)),
          n_protrusions: n,
          tau_prot_min: Math.max(8, 62 - 35 * rise + 6 * normal(u) + 8 * point[1]),
          l_prot_um: 30.5 - 3 * rise + 0.8 * normal(u),
          f_mat: Math.min(0.95, 0.3 + 0.0012 * stiffness[point[0]] + 0.05 * normal(u)),
        },
    path: failed ? null : path,
    outline: failed ? null : { x_um: ring.map((p) => p[0]), y_um: ring.map((p) => p[1]) },
    f_adh_rel: failed
      ? []
      : Array.from({ length: n }, () => Math.max(0.01, (u() < 0.25 ? 0.15 : 0.75 + 0.3 * rise) + 0.18 * normal(u))),
  };
}

/** By linear interpolation between order statistics, as the program computes it. */
function quantile(v: number[], share: number): number {
  const sorted = [...v].sort((a, b) => a - b);
  const place = share * (sorted.length - 1);
  const below = Math.floor(place);
  return sorted[below] + (place - below) * ((sorted[below + 1] ?? sorted[below]) - sorted[below]);
}

function group(readout: string, point: GridPoint, v: number[]): StudyGroup {
  const [q1, q3] = [quantile(v, 0.25), quantile(v, 0.75)];
  const inside = v.filter((x) => x >= q1 - 1.5 * (q3 - q1) && x <= q3 + 1.5 * (q3 - q1));
  return {
    readout,
    point,
    n: v.length,
    mean: mean(v),
    low_whisker: Math.min(...inside),
    low_quartile: q1,
    median: quantile(v, 0.5),
    high_quartile: q3,
    high_whisker: Math.max(...inside),
  };
}

/** Holm's correction of p-values, in their order. */
function holm(p: number[]): number[] {
  const order = p.map((_, i) => i).sort((i, j) => p[i] - p[j]);
  const out = [...p];
  let largest = 0;
  order.forEach((i, rank) => {
    largest = Math.max(largest, Math.min(1, (p.length - rank) * p[i]));
    out[i] = largest;
  });
  return out;
}

/** @param replicates  runs at each point */
export function sampleStudy(replicates = 12): StudyPage {
  const u = random(11);
  const points: GridPoint[] = sensitivity.flatMap((_, k) => stiffness.map((_, i) => [i, k]));
  const runs = points.flatMap((point) => Array.from({ length: replicates }, (_, i) => run(u, point, i + 1)));
  const at = (point: GridPoint, name: string): number[] =>
    runs
      .filter((r) => r.point.join() === point.join())
      .map((r) => r.readouts[name])
      .filter((v): v is number => v !== undefined && v !== null);
  const tests: StudyTest[] = [];
  for (const readout of names)
    points.forEach((a, i) =>
      points.slice(i + 1).forEach((b) => {
        // Along the first axis within a set, and between sets at the same value.
        if (a[1] !== b[1] && a[0] !== b[0]) return;
        const [va, vb] = [at(a, readout), at(b, readout)];
        const error = Math.sqrt(variance(va) / va.length + variance(vb) / vb.length);
        const difference = mean(vb) - mean(va);
        tests.push({
          readout,
          a,
          b,
          test: "t",
          statistic: difference / error,
          p: pOf(difference / error),
          p_holm: null,
          n_a: va.length,
          n_b: vb.length,
          difference,
          interval: [difference - 2 * error, difference + 2 * error],
        });
      }),
    );
  for (const readout of names) {
    const mine = tests.filter((t) => t.readout === readout);
    const corrected = holm(mine.map((t) => t.p ?? 1));
    mine.forEach((t, i) => (t.p_holm = corrected[i]));
  }
  const done = runs.filter((r) => r.status === "done");
  const column = (name: string) => done.map((r) => r.readouts[name] ?? 0);
  const correlation = (a: string, b: string): number => {
    const [x, y] = [column(a), column(b)];
    return (
      mean(x.map((v, i) => (v - mean(x)) * (y[i] - mean(y)))) /
      Math.sqrt(mean(x.map((v) => (v - mean(x)) ** 2)) * mean(y.map((v) => (v - mean(y)) ** 2)))
    );
  };
  const r = names.map((a) => names.map((b) => correlation(a, b)));
  const lag = [10, 20, 30, 45, 60, 90, 120, 180];
  return {
    format: "matrigrate-study",
    version: 1,
    title: "Stiffness of the matrix and sensitivity of adhesions",
    status: `${done.length} of ${runs.length} runs done, ${runs.length - done.length} failed.`,
    summary: "Speed, start to end (v_migr_abs), is highest at E = 400 Pa.",
    facts: [
      { name: "command", value: "matrigrate study run stiffness.toml" },
      { name: "runs done", value: `${done.length} of ${runs.length}` },
    ],
    axes: [
      {
        name: "ecm.youngs_modulus",
        label: "E",
        meaning: "Young's modulus of the intact matrix",
        unit: "Pa",
        values: stiffness,
      },
      {
        name: "adhesion.zeta_diss",
        label: "zeta_diss",
        meaning: "Sensitivity of disassembly to force",
        unit: "",
        values: sensitivity,
      },
    ],
    readouts: [
      { name: names[0], label: "v_migr_abs", meaning: "speed, start to end", unit: "um/h" },
      { name: names[1], label: "n_protrusions", meaning: "protrusions initiated", unit: "" },
      { name: names[2], label: "tau_prot", meaning: "life of a mature adhesion, mean of a run", unit: "min" },
      { name: names[3], label: "l_prot", meaning: "length at the end of growth, mean of a run", unit: "um" },
      { name: names[4], label: "f_mat", meaning: "maturation, mean of a run", unit: "" },
    ],
    runs,
    groups: names.flatMap((name) => points.map((point) => group(name, point, at(point, name)))),
    tests,
    msd: points.map((point) => {
      const slope = 1.1 + 0.12 * point[0];
      const msd = lag.map((t) => 4 * (1 + point[0]) * (t / 10) ** slope);
      return { point, lag_min: lag, msd_um2: msd, sem_um2: msd.map((v) => 0.15 * v), slope };
    }),
    correlation: {
      names,
      r,
      p: r.map((row, i) => row.map((v, j) => (i === j ? null : pOf(v * Math.sqrt((done.length - 2) / (1 - v * v)))))),
      p_holm: r.map((row, i) => row.map((v, j) => (i === j ? null : Math.min(1, 10 * pOf(v * Math.sqrt((done.length - 2) / (1 - v * v))))))),
      n: r.map((row) => row.map(() => done.length)),
    },
    claims: [
      {
        id: "A2",
        sentence: "v_migr_abs rises over 50-200 Pa (50 vs 200 significant); 200, 300, 400 do not differ significantly",
        verdict: "holds",
        caveat: "not the paper's runs",
        published: "4.1 and 9.3 um/h",
        ours: ["v_migr_abs at 50 Pa 4.4 [3.1, 5.7] (n = 12)", "v_migr_abs at 200 Pa 9.3 [7.6, 11.0] (n = 12)"],
        statistic: ["200 Pa significantly above 50 Pa (difference 4.9 [2.8, 7.0], p 0.0001): met"],
      },
      {
        id: "A3",
        sentence: "n_protrusions rises, tau_prot falls over 50-200 Pa; no significant change 200-400",
        verdict: "does not hold",
        caveat: "not the paper's runs",
        published: "",
        ours: ["n_protrusions at 200 Pa 15.9 [15, 16.8] (n = 12)"],
        statistic: ["n_protrusions at 400 Pa not significantly different (difference 1.6, p 0.01): not met"],
      },
      {
        id: "A7",
        sentence: "usually 2 or 3 protrusions at a time, not more than 3",
        verdict: "undecided",
        caveat: "not the paper's runs",
        published: "",
        ours: [],
        statistic: ["too few runs"],
      },
    ],
    claims_note: "Not run as published: replicates 11 (published: 12). So these are no verdicts on the paper.",
    players: runs.slice(0, 2).map((r) => ({
      id: r.id,
      label: `E ${stiffness[r.point[0]]} Pa, replicate ${r.seed}`,
      run: sampleRun({ seed: r.seed, radius: 90, interval: 600, end: 7200 }),
    })),
    provenance: "matrigrate 0.1.0\nstudy          stiffness x sensitivity, 12 runs each",
    citation:
      "Heck T, Vargas DA, Smeets B, Ramon H, Van Liedekerke P, Van Oosterwyck H (2020) PLoS Comput Biol 16(1): e1007250.",
  };
}
