/** Made-up verdicts: a verification case with checks and plots, claims with and without a study. */
import type { Statement, VerdictPage } from "../src/verdicts/contract";
import { sampleStudy } from "./study";

const statement = (more: Partial<Statement> & Pick<Statement, "id" | "sentence" | "verdict">): Statement => ({
  kind: "",
  caveat: "",
  published: "",
  brief: "",
  why_not: "",
  checks: [],
  claims: [],
  details: [],
  studies: [],
  plots: [],
  pictures: [],
  ...more,
});

const x = Array.from({ length: 21 }, (_, i) => 0.5 * i);

export function sampleVerdicts(): VerdictPage {
  const { title, axes, readouts, runs, groups, tests, msd } = sampleStudy(3);
  return {
    format: "matrigrate-verdicts",
    version: 1,
    title: "Claims of a paper: A",
    facts: [{ name: "command", value: "matrigrate reproduce A" }],
    setting: "Replicates: 3. Not run as the paper ran it, so these are no verdicts on the paper.",
    statements: [
      statement({
        id: "creep",
        sentence: "A layer creeps to rest under a constant force.",
        verdict: "holds",
        checks: [
          { quantity: "final displacement [um]", measured: 0.998, expected: 1, tolerance: 0.01, sense: "near", reason: "second order in the spacing", holds: true },
          { quantity: "force [nN]", measured: null, expected: 2, tolerance: 0, sense: "at_most", reason: "a bound", holds: false },
        ],
        details: [{ name: "Remarks", sentences: ["The walls are <b>rigid</b>.", "12 um apart."] }],
        plots: [
          {
            name: "creep",
            title: "Creep of a layer",
            caption: "Displacement of its middle.",
            x_label: "time [s]",
            y_label: "displacement [um]",
            log_x: false,
            log_y: true,
            series: [
              { label: "1 - exp(-t)", x, y: x.map((t) => 1 - Math.exp(-t)), mark: "line", colour: 0 },
              { label: "measured", x, y: x.map((t, i) => (i === 7 ? null : 1 - Math.exp(-0.9 * t))), mark: "points", colour: 1 },
              { label: "", x: [0, 10], y: [1, 1], mark: "dashed", colour: 2 },
            ],
          },
        ],
        pictures: [
          {
            name: "map",
            caption: "The layer from above.",
            svg: '<svg xmlns="http://www.w3.org/2000/svg" width="60" height="40"><circle cx="30" cy="20" r="9"/></svg>',
          },
        ],
      }),
      statement({
        id: "A2",
        kind: "calibration",
        sentence: "v_migr_abs rises over 50-200 Pa",
        verdict: "does not hold",
        caveat: "not the paper's runs",
        published: "4.1 and 9.3 um/h",
        brief: "4.4 and 5.0 um/h",
        why_not: "not met: 200 Pa above 50 Pa",
        details: [{ name: "Ours", sentences: ["v_migr_abs at 50 Pa 4.4 [3.1, 5.7] (n = 3)"] }],
        studies: ["stiffness", "not there"],
      }),
      statement({ id: "A7", kind: "predicted", sentence: "usually 2 or 3 protrusions at a time", verdict: "undecided" }),
    ],
    studies: [{ name: "stiffness", study: { title, axes, readouts, runs, groups, tests, msd } }],
    provenance: "matrigrate 0.1.0",
    citation: "Heck T et al. (2020) PLoS Comput Biol 16(1): e1007250.",
  };
}
