/** A read-out by parameter value: boxes with every run as a point, n, mean, and what differs significantly. */
import type { StudyData, StudyGroup, StudyReadout } from "./contract";
import { h } from "../dom";
import { pretty, readable } from "../numbers";
import { brackets, leastRuns, sign, starsNote, story, type Bracket, type Shown } from "./brackets";
import { axis, dots, figure, ink, wholeTicks, type Json } from "../figure";
import { capital, lettered, titleOf, typeset, unmarked } from "../words";
import { groupAt, nameOf, same, seriesColour, values, type Grid, type Group } from "./groups";
import { bandNote, bands, targetsOf } from "./targets";

/** The summary of a read-out at the point of a group, as the program computed it. */
const statisticsOf = (study: StudyData, group: Group, readout: string): StudyGroup | undefined =>
  study.groups.find((one) => one.readout === readout && same(one.point, group.point));

/** Runs that a box is drawn of; of fewer the runs alone. */
export const leastForBox = 5;

export const boxesNote = (many: string): string => `Boxes, of ${leastForBox} ${many} or more: median and quartiles, whiskers after Tukey; points: ${many}; diamond: mean; numbers below: n. * p < 0.05, ** p < 0.01, *** p < 0.001, with p corrected after Holm over all comparisons of the read-out; no stars below n = ${leastRuns}. Hover for both p and the test.`;

/** Height that the labels of the columns and the title below them need [pixels]: turned labels need their length. */
function labelRoom(columns: string[], width: number): number {
  const longest = 7 * Math.max(...columns.map((label) => unmarked(label).length));
  return 60 + (columns.length * longest > Math.min(width, 560) - 120 ? longest : 0);
}

/** With more columns than this there is room for bare numbers of runs alone. */
const mostWideColumns = 8;

/** Levels of comparisons over the boxes of a read-out. */
const levelsOf = (bars: Bracket[]): number => Math.max(0, ...bars.map((b) => b.level + 1));

/** A plot of each read-out that has a value, all of one height, so that those beside each other stand on one level. */
export function boxesOfAll(study: StudyData, made: Grid, show: Shown): HTMLElement[] {
  const shown = study.readouts.filter((r) => made.groups.some((g) => values(g, r.name).length > 0));
  const levels = Math.max(0, ...shown.map((r) => levelsOf(brackets(study.tests, made, r.name, show))));
  const empty = study.readouts.filter((r) => !shown.includes(r)).map((r) => r.meaning);
  return [
    ...shown.map((r) => boxes(study, made, r, show, levels)),
    ...(empty.length > 0 ? [h("p", { class: "note empty" }, ...lettered(`Nothing has a value of: ${empty.join("; ")}.`))] : []),
  ];
}

/** @param least  levels of comparisons that there is room for */
export function boxes(study: StudyData, made: Grid, readout: StudyReadout, show: Shown, least = 0): HTMLElement {
  const bars = brackets(study.tests, made, readout.name, show);
  const levels = Math.max(least, levelsOf(bars));
  const plotHeight = 270 + 17 * levels;
  const bare = made.series.length > 1 || made.columns.length > mostWideColumns;
  const targets = targetsOf(study, readout.name);
  const caption = `${capital(readout.meaning)}.${bandNote(targets)}${starsNote(study.tests, readout.name)}`;
  return figure(caption, (width) => plotHeight + labelRoom(made.columns, width), () => {
    const colours = ink();
    const every = made.groups.flatMap((g) => values(g, readout.name).map((v) => v.value));
    const ends = targets.flatMap((t) => [t.low - t.error, t.high + t.error]);
    const [low, high] = [Math.min(...every, ...ends), Math.max(...every, ...ends)];
    const band = bands(targets);
    const counted = !readout.unit && every.every(Number.isInteger);
    const span = high - low || 1;
    // Room above the data is counted in pixels, so that stars keep their distance whatever the values are.
    const pixel = (1.12 * span) / Math.max(100, plotHeight - 36 - 17 * levels);
    const [bottom, top] = [low - 0.06 * span - 18 * pixel, high + 0.05 * span + 17 * levels * pixel];
    const data: Json[] = [];
    made.series.forEach((name, k) => {
      const groups = made.groups.filter((g) => g.series === k && values(g, readout.name).length > 0);
      const colour = seriesColour(k);
      for (const g of groups) {
        const found = values(g, readout.name);
        const box = statisticsOf(study, g, readout.name);
        const text = found.map((v) => `${typeset(g.label)}<br>${nameOf(v.run)}: ${readable(v.value)}`);
        const y = found.map((v) => v.value);
        if (found.length < leastForBox) {
          const x = found.map((_, i) => g.x + made.width * 0.3 * (found.length > 1 ? i / (found.length - 1) - 0.5 : 0));
          data.push({ ...dots(x, y, text, { color: colour, size: 7, opacity: 0.75 }), name: typeset(name) });
          continue;
        }
        data.push({
          type: "box",
          name: typeset(name),
          x: [g.x],
          // Quartiles and whiskers as in groups.csv: plotly has definitions of its own.
          q1: [box?.low_quartile],
          median: [box?.median],
          q3: [box?.high_quartile],
          lowerfence: [box?.low_whisker],
          upperfence: [box?.high_whisker],
          y: [y],
          width: 0.82 * made.width,
          boxpoints: "all",
          pointpos: 0,
          jitter: 0.55,
          line: { color: colour, width: 1.5 },
          fillcolor: "rgba(128,128,128,.1)",
          marker: { color: colour, size: 5, opacity: 0.75 },
          text: [text],
          hoverinfo: "text",
          hoveron: "points",
        });
      }
      const means = groups.map((g) => statisticsOf(study, g, readout.name)?.mean ?? null);
      const about = (g: Group, i: number) => `mean ${readable(means[i])} ${pretty(readout.unit)}, n = ${values(g, readout.name).length}`;
      const words = groups.map((g, i) => `${typeset(g.label)}<br>${about(g, i)}`);
      const marker = { symbol: "diamond", size: 10, color: colours.ground, line: { color: colours.text, width: 2 } };
      data.push(dots(groups.map((g) => g.x), means, words, marker));
    });
    const at = (b: Bracket) => high + 0.05 * span + (17 * b.level + 5) * pixel;
    // A comparison within a series has its colour; one between series is grey.
    const lineColour = (b: Bracket) => {
      const [ka, kb] = [groupAt(made, b.test.a)?.series ?? 0, groupAt(made, b.test.b)?.series ?? 0];
      return made.series.length > 1 && ka === kb ? seriesColour(ka) : colours.soft;
    };
    for (const b of bars)
      data.push({
        type: "scatter",
        mode: "lines",
        x: [b.from + 0.04, b.to - 0.04],
        y: [at(b), at(b)],
        line: { color: lineColour(b), width: 1.4 },
        hoverinfo: "skip",
      });
    data.push({
      type: "scatter",
      mode: "text",
      x: bars.map((b) => 0.5 * (b.from + b.to)),
      y: bars.map((b) => at(b) + 5 * pixel),
      text: bars.map((b) => sign(b.test)),
      hovertext: bars.map((b) => story(b.test, made, readout.unit).map(typeset).join("<br>")),
      hoverinfo: "text",
      textfont: { size: 13, color: colours.text },
    });
    return {
      data,
      layout: {
        xaxis: axis(made.axisTitle, {
          tickvals: made.columns.map((_, i) => i),
          ticktext: made.columns.map(typeset),
          range: [-0.6, made.columns.length - 0.4],
          showgrid: false,
          fixedrange: true,
        }),
        yaxis: axis(titleOf(readout), { range: [bottom, top], ...(counted ? wholeTicks(low, high) : {}) }),
        shapes: band.shapes,
        annotations: band.annotations.concat(
          made.groups.map((g) => ({
            x: g.x,
            y: 0,
            yref: "paper",
            yanchor: "bottom",
            showarrow: false,
            font: { size: 12, color: colours.soft },
            text: `${bare ? "" : "n\u00a0=\u00a0"}${values(g, readout.name).length}`,
          })),
        ),
      },
    };
  });
}
