/** What is looked at: stage, layers and plots of one simulation. */
import type { ProtrusionRow, RunPage, Tracks } from "../contract";
import { h, setText } from "../dom";
import { timeText } from "../numbers";
import { visitedBox } from "../run/frames";
import { attachKeys, keyList } from "../run/keys";
import { layers } from "../run/matrix/layers";
import { panel } from "../run/panel";
import { present, viewButtons } from "../run/player";
import { Probe } from "../run/probe";
import { Stage } from "../run/stage";
import type { Brush } from "./brush";
import type { LiveClock } from "./clock";
import { curves } from "./curves";
import type { LiveFilm } from "./film";
import type { Head, TrackRow } from "./protocol";
import type { Stroke } from "./scenario";
import { travelledText } from "./results";

/** Typical values, which scale arrows and colours [um, um/h, nN]. */
const usual = { displacement: 3, velocity: 40, force: 2 };

/** Width of the first view [um]. */
const firstView = 120;

export const noTracks = (): Tracks => ({ t_s: [], x_um: [], y_um: [], area_um2: [], perimeter_um: [], polarization_rad: [], n_simultaneous: [] });

export function addTracks(tracks: Tracks, rows: TrackRow[]): void {
  for (const [t, x, y, area, perimeter, polarization, alive, cell] of rows) {
    const last = tracks.t_s.length - 1;
    // Rows that a resumed state repeats.
    if (last >= 0 && (t < tracks.t_s[last] || (t === tracks.t_s[last] && (cell ?? 0) <= (tracks.cell?.[last] ?? 0)))) continue;
    if (cell !== undefined) (tracks.cell ??= []).push(cell);
    tracks.t_s.push(t);
    tracks.x_um.push(x);
    tracks.y_um.push(y);
    tracks.area_um2.push(area);
    tracks.perimeter_um.push(perimeter);
    tracks.polarization_rad.push(polarization);
    tracks.n_simultaneous.push(alive);
  }
}

/** Camera and visible layers, so that a new start has the same view. */
export const viewOf = ({ camera: { x, y, scale }, follow, layer }: Stage) => ({ layer: layer.key, x, y, scale, follow });
export type View = ReturnType<typeof viewOf>;
export type Scene = ReturnType<typeof scene>;

export function scene(
  head: Head,
  film: LiveFilm,
  clock: LiveClock,
  tracks: Tracks,
  rows: () => ProtrusionRow[],
  brush: Brush,
  strokes: () => Stroke[],
  before: View | null,
  gone: AbortSignal,
) {
  const run: RunPage = {
    format: "matrigrate-run",
    version: 1,
    title: "Matrigrate live",
    status: "",
    t_end_s: head.duration_s,
    geometry: head,
    summary: "",
    facts: [],
    tracks,
    protrusions: [],
    readouts: [],
    parameters: [],
    health: [],
    provenance: "",
    citation: "",
  };
  const all = layers(film.film);
  for (const layer of all) if (layer.key === "displacement") layer.high = usual.displacement;
  const stage = new Stage(run, film.film, clock, all, usual, undefined, gone);
  const chosen = all.find(({ key }) => key === before?.layer);
  if (chosen) stage.choose(chosen);
  const time = h("span", {});
  const distance = h("span", { class: "travelled" });
  const showTime = () => {
    setText(time, timeText(clock.playing ? 10 * Math.floor(clock.time / 10) : clock.time));
    setText(distance, travelledText(tracks, clock.time));
  };
  clock.onChange(showTime, gone);
  showTime();
  stage.element.append(h("output", { class: "time" }, time, distance), viewButtons(stage));
  const keys = keyList(true);
  attachKeys(stage, new Probe(stage), keys, document, gone);
  brush.attach(stage, strokes);
  // Once it has a size: the cell with room to walk, or all cells.
  const show = () => {
    const { camera } = stage;
    const { left, right, bottom, top } = visitedBox(film.film);
    const least = film.film.cells.length > 1 ? Math.max(firstView, right - left, top - bottom) : firstView;
    camera.scale = before?.scale ?? Math.min(camera.width, camera.height) / least;
    if (before) [camera.x, camera.y] = [before.x, before.y];
    stage.follow = before?.follow ?? true;
    stage.viewChanged();
  };
  requestAnimationFrame(() => requestAnimationFrame(show));
  const open = matchMedia("(min-width: 60rem)").matches;
  const look = h("details", { class: "look", open }, h("summary", {}, "Colours and what is drawn"), panel(stage, gone));
  return { stage, curves: curves(clock, tracks, rows, gone), aside: [present(film.film, clock, gone), look, keys.element] };
}
