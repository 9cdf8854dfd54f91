/** Each read-out over each factor, of a design that is no grid. */
import { axis, figure, ink, type Json } from "../figure";
import { h } from "../dom";
import { pretty, pText, readable } from "../numbers";
import type { StudyPage } from "./contract";
import { seriesColour, withUnit } from "./groups";

/** On a logarithmic axis if the values span more than a decade. */
const isLog = (values: number[]): boolean => Math.min(...values) > 0 && Math.max(...values) > 10 * Math.min(...values);

export function scatters(study: StudyPage): HTMLElement | null {
  const made = study.scatter;
  if (!made || made.factors.length === 0) return null;
  const place = new Map(made.points.map((point, i) => [point.join(), i]));
  const conditions = study.axes.length > 1 ? study.axes[1].values.map(String) : [""];
  const defined = study.readouts.filter((r) => study.runs.some((run) => typeof run.readouts[r.name] === "number"));
  if (defined.length === 0) return null;
  const figures = defined.flatMap((readout) =>
    made.factors.map((factor) => {
      const c = factor.correlations.find((one) => one.readout === readout.name);
      const known = c && c.rho !== null;
      const targets = made.targets.filter((t) => t.readout === readout.name);
      const caption =
        `${readout.label} over ${factor.label}: ` +
        (known ? `Spearman's rho ${readable(c.rho, 2)} over ${c.n} points, ${pText(c.p_holm)} after Holm's correction.` : "no rank correlation.") +
        (targets.length > 0 ? " Line or band: target." : "");
      return figure(pretty(caption), 330, () => {
        const runs = study.runs.flatMap((run) => {
          const i = place.get(run.point.join());
          const y = run.readouts[readout.name];
          return i === undefined || typeof y !== "number" ? [] : [{ run, x: factor.values[i], y }];
        });
        const data = conditions.map((condition, k): Json => {
          const mine = runs.filter((r) => (r.run.point[1] ?? 0) === k);
          return {
            type: "scatter",
            mode: "markers",
            name: condition,
            x: mine.map((r) => r.x),
            y: mine.map((r) => r.y),
            marker: { color: seriesColour(k), size: 7, opacity: 0.75 },
            text: mine.map((r) => `${pretty(`${factor.label} ${readable(r.x, 3)} ${factor.unit}`)}<br>seed ${r.run.seed}: ${readable(r.y)}`),
            hoverinfo: "text",
          };
        });
        return {
          data,
          layout: {
            showlegend: conditions.length > 1,
            legend: { orientation: "h", y: 1.02, yanchor: "bottom" },
            xaxis: axis(withUnit(factor.label, factor.unit), isLog(factor.values) ? { type: "log" } : {}),
            yaxis: axis(withUnit(readout.label, readout.unit)),
            shapes: targets.map((t) => ({
              type: "rect",
              xref: "paper",
              x0: 0,
              x1: 1,
              y0: t.low,
              y1: t.high,
              line: { color: ink().soft, width: 1.5, dash: "dash" },
              fillcolor: "rgba(128,128,128,.12)",
              layer: "below",
            })),
            annotations: targets.map((t) => ({
              xref: "paper",
              x: 1,
              xanchor: "right",
              y: t.high,
              yanchor: "bottom",
              showarrow: false,
              text: "target",
              font: { size: 12, color: ink().soft },
            })),
          },
        };
      });
    }),
  );
  return h("div", { class: "boxes" }, ...figures);
}
