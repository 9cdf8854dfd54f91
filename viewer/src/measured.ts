/** Tracks of measured cells, to be drawn over simulated ones. */
import type { MeasuredTracks } from "./contract";
import { readable } from "./numbers";

/** Positions [um] from the start of the track, over time [s] since then. */
export interface MeasuredTrack {
  t: number[];
  x: number[];
  y: number[];
}

export function measuredTracks(measured: MeasuredTracks | null | undefined): MeasuredTrack[] {
  const tracks: MeasuredTrack[] = [];
  let open = false;
  measured?.t_s.forEach((t, i) => {
    const [x, y] = [measured.x_um[i], measured.y_um[i]];
    if (t === null || x === null || y === null) {
      open = false;
      return;
    }
    if (!open) tracks.push({ t: [], x: [], y: [] });
    open = true;
    const own = tracks[tracks.length - 1];
    own.t.push(t);
    own.x.push(x);
    own.y.push(y);
  });
  return tracks;
}

export interface Measured {
  tracks: MeasuredTrack[];
  /** For legends: how many there are; "" for none. */
  words: string;
}

export function measuredOf(measured: MeasuredTracks | null | undefined): Measured {
  const tracks = measuredTracks(measured);
  return { tracks, words: measured && tracks.length > 0 ? countOf(tracks, measured.total) : "" };
}

/** The part of a track up to a time [s]. */
export function until({ t, x, y }: MeasuredTrack, time: number): MeasuredTrack {
  const after = t.findIndex((v) => v > time);
  const n = after < 0 ? t.length : after;
  return { t: t.slice(0, n), x: x.slice(0, n), y: y.slice(0, n) };
}

/** "30 measured tracks", "200 of 840 measured tracks". */
export function countOf(tracks: MeasuredTrack[], total: number): string {
  const shown = tracks.length < total ? `${tracks.length} of ${total}` : String(total);
  return `${shown} measured track${total === 1 ? "" : "s"}`;
}

/** Duration of the longest track: "0.5 h". */
export const durationOf = (tracks: MeasuredTrack[]): string =>
  `${readable(tracks.reduce((most, { t }) => Math.max(most, t[t.length - 1]), 0) / 3600, 2)} h`;

export const measuredColour = (dark: boolean): string => (dark ? "#9d90b0" : "#75658a");
