/** Mean square displacement, forces at which adhesions ended, and correlations of read-outs across runs. */
import { blueWhiteOrange } from "../colour";
import type { StudyData, StudyPage } from "./contract";
import { h } from "../dom";
import { pText, readable, stars } from "../numbers";
import { symbolOf, typeset, wordsOf, wrapped } from "../words";
import { leastRuns } from "./brackets";
import { axis, figure, ink, type Json } from "../figure";
import { columnColour, groupAt, multiplesStyle, seriesColour, type Grid, type Group } from "./groups";

/** For logarithmic axes. */
const roundNumbers = [-2, -1, 0, 1, 2, 3, 4, 5].flatMap((k) => [1, 2, 5].map((n) => n * 10 ** k));

const dashes = ["solid", "dash", "dot", "dashdot"];
const symbols = ["circle", "square", "diamond", "triangle-up"];

export function msd(study: StudyData, made: Grid): HTMLElement | null {
  if (study.msd.length === 0) return null;
  if (study.msd.every((m) => m.lag_min.length < 2))
    return h("p", {}, "The runs are too short: there are not two lags to draw a curve through.");
  return figure(
    `Mean square displacement over ${study.sampled ?? "runs"}, with standard error; the thin line has slope 1 (random walk).`,
    (window) => (window > 760 ? 460 : 380 + 19 * study.msd.length),
    (width) => {
      const data: Json[] = [];
      for (const m of study.msd) {
        const g = groupAt(made, m.point);
        if (!g) continue;
        const color = columnColour(g.column, made.columns.length);
        data.push({
          type: "scatter",
          mode: "lines+markers",
          x: m.lag_min,
          y: m.msd_um2,
          name: `${typeset(g.label)}: slope ${readable(m.slope, 3)}`,
          line: { color, width: 2, dash: dashes[g.series % 4] },
          marker: { color, size: 7, symbol: symbols[g.series % 4] },
          error_y: m.sem_um2 && { type: "data", array: m.sem_um2.map((v) => v ?? 0), thickness: 1.2, width: 3, color },
          hovertemplate: `${typeset(g.label)}<br>lag %{x} min<br>MSD %{y:.4g} \u00b5m\u00b2<extra></extra>`,
        });
      }
      const lags = study.msd.flatMap((m) => m.lag_min);
      const [a, b] = [Math.min(...lags), Math.max(...lags)];
      const low = 0.7 * Math.min(...study.msd.map((m) => m.msd_um2[0]));
      data.push({
        type: "scatter",
        mode: "lines",
        x: [a, b],
        y: [low, (low * b) / a],
        line: { color: ink().soft, width: 1 },
        name: "slope 1",
        hoverinfo: "skip",
      });
      return {
        data,
        layout: {
          showlegend: true,
          legend: width > 700 ? { x: 1.02, y: 1 } : { orientation: "h", y: -0.18, yanchor: "top", font: { size: 12 } },
          xaxis: axis("lag (min)", { type: "log", tickvals: roundNumbers }),
          yaxis: axis("mean square displacement (\u00b5m\u00b2)", { type: "log", tickvals: roundNumbers }),
        },
      };
    },
  );
}

export function adhesionForces(made: Grid): HTMLElement | null {
  const ofRuns = (groups: Group[]) => groups.flatMap((g) => g.runs.flatMap((r) => r.f_adh_rel ?? []));
  const of = (k: number, column: number) => ofRuns(made.groups.filter((g) => g.series === k && g.column === column));
  const all = ofRuns(made.groups);
  if (all.length === 0) return null;
  const bin = 0.1;
  const count = Math.ceil(Math.max(...all) / bin + 1e-9);
  const place = (force: number) => Math.min(count - 1, Math.max(0, Math.floor(force / bin)));
  const bins = Array.from({ length: count }, (_, i) => i);
  const share = (v: number[]) => bins.map((i) => v.filter((force) => place(force) === i).length / Math.max(1, v.length));
  const columns = made.columns.map((_, c) => c).filter((c) => made.series.some((_, k) => of(k, c).length > 0));
  const top = 1.1 * Math.max(...made.series.flatMap((_, k) => made.columns.flatMap((__, c) => share(of(k, c)))));
  // Several series as outlines: bars over bars would mix their colours.
  const bars = (k: number): Json => {
    const color = seriesColour(k);
    if (made.series.length === 1) return { type: "bar", width: bin, marker: { color } };
    return { type: "scatter", mode: "lines", line: { shape: "hvh", color, width: 2.2, dash: dashes[k % 4] } };
  };
  const drawn = columns.map((c) => {
    const caption = `${made.columnLabels[c]}: n = ${made.series.map((_, k) => of(k, c).length).join(" and ")} adhesions`;
    return figure(caption, () => 230, () => ({
      data: made.series.map((series, k) => ({
        ...bars(k),
        name: typeset(series),
        x: bins.map((i) => (i + 0.5) * bin),
        y: share(of(k, c)),
        hovertemplate: `${typeset(series)}<br>force around %{x:.2f}<br>share %{y:.2f}<extra></extra>`,
      })),
      layout: {
        barmode: "overlay",
        margin: { l: 50, r: 8, t: 6, b: 40 },
        xaxis: axis("force / (2 f_mat F_am)", { range: [0, count * bin] }),
        yaxis: axis("share of adhesions", { range: [0, top], nticks: 5 }),
      },
    }));
  });
  return h("div", { class: "multiples", style: multiplesStyle(made, Math.min(6, columns.length)) }, ...drawn);
}

export function correlation(study: StudyPage): HTMLElement | null {
  const c = study.correlation;
  if (!c || c.names.length === 0) return null;
  const found = c.names.map((name) => study.readouts.find((r) => r.name === name) ?? { name, label: name, meaning: "", unit: "" });
  const broken = (text: string, letters: number) => typeset(wrapped(text, letters)).replaceAll("\n", "<br>");
  const labels = found.map((r) => broken(symbolOf(r) || wordsOf(r), 14));
  const rows = found.map((r) => broken(wordsOf(r), 26));
  const enough = (i: number, j: number) => c.n[i][j] >= leastRuns;
  const each = <T>(of: (r: number | null, i: number, j: number) => T): T[][] => c.r.map((row, i) => row.map((r, j) => of(r, i, j)));
  const about = (r: number | null, i: number, j: number) => {
    const tested = i === j ? "" : `, ${pText(c.p[i][j])}, after Holm's correction ${pText(c.p_holm[i][j])}`;
    return `${typeset(wordsOf(found[i]))} with ${typeset(wordsOf(found[j]))}<br>r = ${readable(r, 3)}${tested}<br>n = ${c.n[i][j]}`;
  };
  const number = (r: number | null, i: number, j: number) => {
    if (r === null || !enough(i, j)) return "\u2013";
    const star = (c.p_holm[i][j] ?? 1) < 0.05 ? `<br>${stars(c.p_holm[i][j])}` : "";
    return i === j ? "1" : `${r.toFixed(2).replace("-", "\u2212")}${star}`;
  };
  const bright = (r: number | null, i: number, j: number) => r !== null && enough(i, j) && Math.abs(r) > 0.62;
  const drawn = figure(
    `Correlation of read-outs within points: Pearson's r of the deviations of runs from the mean of their point, so that what the study sets makes none. Read-outs that do not vary within points are left out. Stars for p < 0.05, 0.01, 0.001 after Holm's correction over all pairs; both p and n on hover.`,
    () => 90 + 68 * labels.length,
    (width) => ({
      data: [
        {
          type: "heatmap",
          x: labels,
          y: rows,
          z: each((r, i, j) => (enough(i, j) ? r : null)),
          zmin: -1,
          zmax: 1,
          xgap: 2,
          ygap: 2,
          colorscale: blueWhiteOrange.map((rgb, i) => [i / (blueWhiteOrange.length - 1), `rgb(${rgb.join(",")})`]),
          showscale: width > 520,
          colorbar: { title: { text: "r" }, thickness: 14, outlinewidth: 0 },
          text: each(about),
          hoverinfo: "text",
        },
      ],
      layout: {
        xaxis: axis("", { showgrid: false, showline: false, ticks: "" }),
        yaxis: axis("", { autorange: "reversed", showgrid: false, showline: false, ticks: "" }),
        annotations: each((r, i, j) => ({
          x: labels[j],
          y: rows[i],
          showarrow: false,
          text: number(r, i, j),
          font: { size: width > 520 ? 13 : 12, color: bright(r, i, j) ? "#ffffff" : "#1f2328" },
        })).flat(),
      },
    }),
  );
  // Where the numbers would not fit, it is scrolled sideways.
  drawn.classList.add("wide");
  drawn.style.setProperty("--least", `${110 + 8 * 26 + 46 * labels.length}px`);
  return drawn;
}
