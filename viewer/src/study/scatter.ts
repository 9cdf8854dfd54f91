/** Each read-out over each parameter, of a design that is no grid. */
import { axis, dots, figure, logAxis, wholeTicks, type Json } from "../figure";
import { h } from "../dom";
import { pretty, pText, readable } from "../numbers";
import type { StudyPage } from "./contract";
import { seriesColour } from "./groups";
import { bandNote, bands, targetsOf } from "./targets";
import { capital, settingOf, titleOf, typeset, verbatim, wordsOf } from "../words";

/** How far the ranks of values are from even steps between the ends. */
function unevenness(values: number[]): number {
  const sorted = [...values].sort((a, b) => a - b);
  const span = sorted[sorted.length - 1] - sorted[0] || 1;
  return Math.max(...sorted.map((v, i) => Math.abs((v - sorted[0]) / span - i / (sorted.length - 1 || 1))));
}

/** The scale on which a parameter was drawn: that on which its values are spread evenly. */
export const isLog = (values: number[]): boolean =>
  values.length > 2 && Math.min(...values) > 0 && unevenness(values.map(Math.log)) < unevenness(values);

export function scatters(study: StudyPage): HTMLElement | null {
  const made = study.scatter;
  const defined = study.readouts.filter((r) => study.runs.some((run) => typeof run.readouts[r.name] === "number"));
  if (!made || made.factors.length === 0 || defined.length === 0) return null;
  const place = new Map(made.points.map((point, i) => [point.join(), i]));
  const conditions = study.axes.length > 1 ? study.axes[1].values.map(String) : [""];
  const figures = defined.flatMap((readout) =>
    made.factors.map((factor) => {
      const c = factor.correlations.find((one) => one.readout === readout.name);
      const known = c && c.rho !== null;
      const targets = targetsOf(study, readout.name);
      const caption =
        `${capital(readout.meaning)}, over ${wordsOf(factor)}: ` +
        (known ? `Spearman's rho ${readable(c.rho, 2)} over ${c.n} points, ${pText(c.p_holm)} after Holm's correction.` : "no rank correlation.") +
        bandNote(targets);
      return figure(pretty(caption), () => 330, () => {
        const runs = study.runs.flatMap((run) => {
          const i = place.get(run.point.join());
          const y = run.readouts[readout.name];
          return i === undefined || typeof y !== "number" ? [] : [{ run, x: factor.values[i], y }];
        });
        const data = conditions.map((condition, k): Json => {
          const mine = runs.filter((r) => (r.run.point[1] ?? 0) === k);
          const text = mine.map((r) => `${typeset(settingOf(factor, readable(r.x, 3)))}<br>seed ${r.run.seed}: ${readable(r.y)}`);
          const marker = { color: seriesColour(k), size: 7, opacity: 0.75 };
          return { ...dots(mine.map((r) => r.x), mine.map((r) => r.y), text, marker), name: typeset(verbatim(condition)) };
        });
        const [low, high] = [Math.min(...runs.map((r) => r.y)), Math.max(...runs.map((r) => r.y))];
        const counted = !readout.unit && runs.every((r) => Number.isInteger(r.y));
        return {
          data,
          layout: {
            showlegend: conditions.length > 1,
            legend: { orientation: "h", y: 1.02, yanchor: "bottom" },
            xaxis: isLog(factor.values) ? logAxis(titleOf(factor), factor.values) : axis(titleOf(factor)),
            yaxis: axis(titleOf(readout), counted ? wholeTicks(low, high) : {}),
            ...bands(targets),
          },
        };
      });
    }),
  );
  return h("div", { class: "boxes" }, ...figures);
}
