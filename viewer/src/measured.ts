/** Tracks of measured cells, to be drawn over simulated ones. */
import type { MeasuredTracks } from "./contract";
import { readable } from "./numbers";

/** The stretches of columns between rows in which one of them is null. */
export function stretches<K extends string>(columns: Record<K, (number | null)[]>): Record<K, number[]>[] {
  const found: Record<K, number[]>[] = [];
  const entries = Object.entries(columns) as [K, (number | null)[]][];
  let open = false;
  entries[0][1].forEach((_, i) => {
    const gap = entries.some(([, column]) => column[i] === null);
    if (!gap && !open) found.push(Object.fromEntries(entries.map(([key]) => [key, []])) as unknown as Record<K, number[]>);
    if (!gap) for (const [key, column] of entries) found[found.length - 1][key].push(column[i] as number);
    open = !gap;
  });
  return found;
}

/** Positions [um] from the start of the track, over time [s] since then. */
export type MeasuredTrack = Record<"t" | "x" | "y", number[]>;

export const measuredTracks = (measured: MeasuredTracks | null | undefined): MeasuredTrack[] =>
  measured ? stretches({ t: measured.t_s, x: measured.x_um, y: measured.y_um }) : [];

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
