/** What was measured, as a band over a figure of a read-out. */
import { ink, type Json } from "../figure";
import { typeset, verbatim } from "../words";
import type { StudyTarget } from "./contract";

/** Of a read-out. */
export const targetsOf = (study: { targets?: StudyTarget[] }, readout: string): StudyTarget[] => (study.targets ?? []).filter((t) => t.readout === readout);

export const bandNote = (targets: StudyTarget[]): string =>
  targets.length > 0 ? " Band: measured, with one standard error." : "";

/** Shapes and annotations: a band from one standard error below to one above. */
export function bands(targets: StudyTarget[]): { shapes: Json[]; annotations: Json[] } {
  const soft = ink().soft;
  return {
    shapes: targets.map((t) => ({
      type: "rect",
      xref: "paper",
      x0: 0,
      x1: 1,
      y0: t.low - t.error,
      y1: t.high + t.error,
      line: { color: soft, width: 1, dash: "dash" },
      fillcolor: "rgba(128,128,128,.12)",
      layer: "below",
    })),
    annotations: targets.map((t) => ({
      xref: "paper",
      x: 1,
      xanchor: "right",
      y: t.high + t.error,
      yanchor: "bottom",
      showarrow: false,
      text: typeset(verbatim(`target${t.at ? ` at ${t.at}` : ""}`)),
      font: { size: 12, color: soft },
    })),
  };
}
