/** What is kept in this browser: the simulation where it stands, so that a tab that was closed goes on. */
import type { ProtrusionRow, Tracks } from "../contract";
import { timeText } from "../numbers";
import type { FilmImage, FilmIndex, LiveFilm, Numbers } from "./film";
import { fieldKeys, type Scenario } from "./scenario";

/** The kept simulation without its film. */
interface KeptState {
  scenario: Scenario;
  /** Time of the state [s]. */
  t_s: number;
  image: Uint8Array;
  tracks: Tracks;
  protrusions: ProtrusionRow[];
  /** When it was kept, as Date.now(). */
  when: number;
}

export interface Kept extends KeptState {
  /** null where its moments are not all there. */
  film: FilmImage | null;
}

/** A run as it is stored; the moments of its film are records of their own, so that each is written once. */
type Stored = KeptState & { film: FilmIndex };

const [name, version, runs, moments, last] = ["matrigrate-live", 2, "runs", "moments", "last"] as const;

const keyOf = (film: FilmIndex, t: number): string => `${film.id}/${t}`;

function database(): Promise<IDBDatabase> {
  return new Promise((done, failed) => {
    const asked = indexedDB.open(name, version);
    asked.onupgradeneeded = () => {
      // A run that an earlier version kept stays, without its film.
      for (const store of [runs, moments]) if (!asked.result.objectStoreNames.contains(store)) asked.result.createObjectStore(store);
    };
    asked.onsuccess = () => done(asked.result);
    asked.onerror = () => failed(asked.error ?? new Error("the browser keeps nothing"));
    asked.onblocked = () => failed(new Error("another tab has an earlier version of this page open"));
  });
}

/** One transaction over all that is kept. @param act  calls `result` with what is to be returned */
async function within<T>(mode: IDBTransactionMode, act: (t: IDBTransaction, result: (value: T) => void) => void): Promise<T> {
  const base = await database();
  base.onversionchange = () => base.close(); // a newer page wants it
  try {
    return await new Promise((done, failed) => {
      const transaction = base.transaction([runs, moments], mode);
      let result: T;
      act(transaction, (value) => {
        result = value;
      });
      // A write counts once the transaction is through, not when it was asked for.
      transaction.oncomplete = () => done(result);
      transaction.onerror = transaction.onabort = () => failed(transaction.error ?? new Error("the browser keeps nothing"));
    });
  } finally {
    base.close();
  }
}

/** All or nothing. Of the film only those moments are written that are not there yet.   @throws where the browser has no room or keeps nothing */
export async function keep(what: KeptState, film: LiveFilm): Promise<void> {
  const written: number[] = [];
  try {
    await within<void>("readwrite", (transaction) => {
      const places = transaction.objectStore(moments);
      const asked = places.getAllKeys();
      asked.onsuccess = () => {
        const index = film.index();
        const there = new Set(asked.result as string[]);
        const wanted = index.times.map((t) => keyOf(index, t));
        for (const key of there) if (!wanted.includes(key)) places.delete(key);
        index.times.forEach((t, k) => {
          if (there.has(wanted[k]) && !film.unsaved.has(t)) return;
          places.put(film.moment(k), wanted[k]);
          film.unsaved.delete(t);
          written.push(t);
        });
        transaction.objectStore(runs).put({ ...what, film: index } satisfies Stored, last);
      };
    });
  } catch (reason) {
    for (const t of written) film.unsaved.add(t);
    throw reason;
  }
}

export const kept = (): Promise<Kept | undefined> =>
  within("readonly", (transaction, result) => {
    const asked = transaction.objectStore(runs).get(last) as IDBRequest<Stored | undefined>;
    asked.onsuccess = () => {
      const run = asked.result;
      if (!run) return;
      const all: Numbers[][] = [];
      const film = { ...run.film, moments: all };
      result({ ...run, film: null });
      run.film.times.forEach((t, k) => {
        const one = transaction.objectStore(moments).get(keyOf(run.film, t)) as IDBRequest<Numbers[] | undefined>;
        one.onsuccess = () => {
          if (one.result) all[k] = one.result;
          if (k === run.film.times.length - 1 && Object.keys(all).length === k + 1) result({ ...run, film });
        };
      });
    };
  });

// The scenario as files for the program.

const quoted = (text: string): string => `'${text.replace(/'/g, `'\\''`)}'`;

/** What to do with the files, as comments of the scenario. */
function commands(scenario: Scenario): string[] {
  const lines = ["Made by the live page. The same start and events with the program:", "  matrigrate run scenario.toml -o live"];
  let from = "live";
  scenario.changes.forEach(({ t, overrides }, k) => {
    const to = `live-${k + 1}`;
    const set = overrides.map((one) => ` --set ${quoted(one)}`).join("");
    if (k === 0) lines.push("What was changed on the way, as branches of that run:");
    lines.push(`  matrigrate resume ${from} --at '${t} s'${set} -o ${to}   # at ${timeText(t)}`);
    from = to;
  });
  lines.push("Events agree until the last bits of exp, sin and others, which differ, have grown: docs/how-to/live.md.");
  return lines;
}

/** @param resolved  the scenario with all its values   @param drawn  files of fields, by name */
export function exported(scenario: Scenario, resolved: string, drawn: Record<string, string>): Record<string, string> {
  let toml = resolved;
  // The core has read the files from its own memory: "/f_degr.csv hash=..." is beside the scenario for the program.
  for (const key of fieldKeys) toml = toml.replace(new RegExp(`"/${key}\\.csv[^"\\n]*"`), `"${key}.csv"`);
  return { "scenario.toml": `${commands(scenario).map((line) => `# ${line}`).join("\n")}\n\n${toml}`, ...drawn };
}
