/** Several cells of a run: which points and rows belong to which, and the colours that tell them apart. */
import { cellColours, type CellColours } from "../colour";
import type { Tracks } from "../contract";

/** The points of one cell on the outline: from `first` up to, but without, `end`. */
export interface CellPart {
  /** As in files, from 1. */
  number: number;
  first: number;
  end: number;
}

/** @param cell  number of the cell of each point; left out: they are all of one */
export function cellParts(points: number, cell: number[] | undefined): CellPart[] {
  if (!cell || cell.length !== points) return [{ number: 1, first: 0, end: points }];
  const parts: CellPart[] = [];
  cell.forEach((number, i) => {
    const last = parts[parts.length - 1];
    if (last && last.number === number) last.end = i + 1;
    else parts.push({ number, first: i, end: i + 1 });
  });
  return parts;
}

export interface CellTracks {
  number: number;
  tracks: Tracks;
}

const split = new WeakMap<Tracks, { rows: number; found: CellTracks[] }>();

/** The tracks of each cell, in the order of their numbers; of a single one those that were given. They may have grown. */
export function tracksOfCells(tracks: Tracks): CellTracks[] {
  const { cell } = tracks;
  if (!cell) return [{ number: 1, tracks }];
  const before = split.get(tracks);
  if (before?.rows === cell.length) return before.found;
  const numbers = [...new Set(cell)].sort((a, b) => a - b);
  const columns = Object.entries(tracks) as [keyof Tracks, number[]][];
  const found = numbers.map((number) => ({
    number,
    tracks: Object.fromEntries(
      columns.map(([name, column]) => [name, column.filter((_, i) => cell[i] === number)]),
    ) as unknown as Tracks,
  }));
  split.set(tracks, { rows: cell.length, found });
  return found;
}

/** @param number  of the cell, from 1   @param cells  how many there are */
export const coloursOf = (number: number, cells: number): CellColours => cellColours(number - 1, cells);

/** What is said before something of a cell, where there are several: "cell 2, ". */
export const ofCell = (cell: number | undefined): string => (cell === undefined ? "" : `cell ${cell}, `);
