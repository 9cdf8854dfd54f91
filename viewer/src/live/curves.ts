/** Plots that grow: speed and protrusions over time, and the path. */
import type { ProtrusionRow, Tracks } from "../contract";
import { h, onResize, s, section } from "../dom";
import { ticks } from "../numbers";
import { tracksOfCells } from "../run/cells";
import { frame, hours, onPick, speeds, tint, type Frame } from "../run/plots";
import { timeline } from "../run/timeline";
import type { LiveClock } from "./clock";

/** Redrawn so often at most [ms]. */
const pause = 1000;
/** Rows of protrusions that are drawn: the latest ones. */
const mostRows = 25;

/** Points of a line at most, which is about one a pixel. */
const mostPoints = 1000;

/** Of one cell. */
interface Line {
  t: number[];
  v: number[];
}

/** Every k-th point of a line, and the last one. */
export function thinned({ t, v }: Line): Line {
  const k = Math.ceil(t.length / mostPoints);
  if (k <= 1) return { t, v };
  const kept = (_: number, i: number) => i % k === 0 || i === t.length - 1;
  return { t: t.filter(kept), v: v.filter(kept) };
}

/** Lines over time that grow. Axes are made again where a line outgrows them, or is far below; else the lines alone change. */
function plot(clock: LiveClock, label: string, stairs: boolean) {
  const element = h("div", {});
  const room = 1.1;
  let made: Frame | null = null;
  let [end, high] = [0, 0];
  let paths: SVGPathElement[] = [];
  const draw = (width: number, lines: Line[]) => {
    const highest = Math.max(1e-9, ...lines.map(({ v }) => v.reduce((a, b) => Math.max(a, b), 0)));
    const fits = clock.end <= end && clock.end > 0.5 * end && highest <= high && highest > 0.5 * high;
    if (!made || made.width !== width || paths.length !== lines.length || !fits) {
      [end, high] = [room * clock.end, room * highest];
      const axes = frame(width, 190, hours({ end }), { low: 0, high, label, ticks: ticks(0, high, 4) }, `${label} over time`);
      onPick(axes, (x) => clock.jump(3600 * axes.toX(x)));
      paths = lines.map((_, k) => s("path", { class: "curve", ...tint(k + 1, lines.length) }));
      axes.svg.append(...paths);
      element.replaceChildren(axes.svg);
      made = axes;
    }
    const { x, y } = made;
    lines.map(thinned).forEach(({ t, v }, k) => {
      const d = t.map((_, i) => {
        const [px, py] = [x(t[i] / 3600).toFixed(1), y(v[i]).toFixed(1)];
        return i === 0 ? `M${px} ${py}` : stairs ? `H${px}V${py}` : `L${px} ${py}`;
      });
      paths[k].setAttribute("d", d.join(""));
    });
  };
  return { element, draw };
}

export function curves(clock: LiveClock, tracks: Tracks, rows: () => ProtrusionRow[], gone: AbortSignal) {
  const speed = plot(clock, "speed (\u00b5m/h)", false);
  const alive = plot(clock, "protrusions alive", true);
  const life = h("div", {});
  const older = h("p", { class: "note" });
  let drawn = 0;
  /** Up to when they are drawn [s], and with which rows. */
  let [drawnTo, drawnRows]: [number, ProtrusionRow[] | null] = [-Infinity, null];
  let drawnWidth = 0;
  let later: ReturnType<typeof setTimeout> | undefined;
  let redrawn = new AbortController();
  gone.addEventListener("abort", () => {
    clearTimeout(later);
    redrawn.abort();
  });
  const draw = () => {
    later = undefined;
    drawn = performance.now();
    const width = Math.floor(speed.element.clientWidth);
    if (width < 50 || clock.end <= 0) return;
    // While it runs, not before a pixel more can be seen.
    const tooSoon = clock.playing && clock.end > drawnTo && clock.end - drawnTo < clock.end / width;
    if (tooSoon && rows() === drawnRows && width === drawnWidth) return;
    [drawnTo, drawnRows, drawnWidth] = [clock.end, rows(), width];
    const cells = tracksOfCells(tracks).map((one) => one.tracks);
    speed.draw(width, cells.map((own) => (own.t_s.length > 1 ? speeds(own) : { t: [], v: [] })));
    alive.draw(width, cells.map((own) => ({ t: own.t_s, v: own.n_simultaneous })));
    const all = [...rows()].sort((a, b) => a.t_initiation_s - b.t_initiation_s); // of several cells, too
    redrawn.abort();
    redrawn = new AbortController();
    life.replaceChildren(timeline(all.slice(-mostRows), clock, Math.floor(life.clientWidth), redrawn.signal));
    older.textContent = all.length > mostRows ? `The latest ${mostRows} of ${all.length} protrusions.` : "";
  };
  /** Something new has come. */
  const changed = () => {
    if (later === undefined) later = setTimeout(draw, Math.max(0, pause - (performance.now() - drawn)));
  };
  onResize(speed.element, changed, gone);
  const plots = h("div", { class: "plots" }, speed.element, alive.element);
  const note = h("p", { class: "note" }, "Speed: displacement over ten minutes, at first over less.");
  const sections = [section("path", "Speed and protrusions", plots, note), section("protrusions", "Protrusions", life, older)];
  return { element: h("div", {}, ...sections), changed };
}
