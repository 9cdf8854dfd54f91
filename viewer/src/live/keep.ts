/** What is kept in this browser: the simulation where it stands, so that a tab that was closed goes on. */
import type { ProtrusionRow, Tracks } from "../contract";
import type { FilmImage } from "./film";
import type { Scenario } from "./scenario";

export interface Kept {
  scenario: Scenario;
  /** Time of the state [s]. */
  t_s: number;
  image: Uint8Array;
  tracks: Tracks;
  protrusions: ProtrusionRow[];
  film: FilmImage;
  /** When it was kept, as Date.now(). */
  when: number;
}

const [name, store, key] = ["matrigrate-live", "runs", "last"];

function database(): Promise<IDBDatabase> {
  return new Promise((done, failed) => {
    const asked = indexedDB.open(name, 1);
    asked.onupgradeneeded = () => asked.result.createObjectStore(store);
    asked.onsuccess = () => done(asked.result);
    asked.onerror = () => failed(asked.error ?? new Error("the browser keeps nothing"));
  });
}

async function within<T>(mode: IDBTransactionMode, act: (s: IDBObjectStore) => IDBRequest<T>): Promise<T> {
  const base = await database();
  try {
    return await new Promise((done, failed) => {
      const transaction = base.transaction(store, mode);
      const asked = act(transaction.objectStore(store));
      // A write counts once the transaction is through, not when it was asked for.
      transaction.oncomplete = () => done(asked.result);
      transaction.onerror = transaction.onabort = () => failed(transaction.error ?? new Error("the browser keeps nothing"));
    });
  } finally {
    base.close();
  }
}

/** @throws where the browser has no room or keeps nothing */
export const keep = (what: Kept): Promise<unknown> => within("readwrite", (s) => s.put(what, key));
export const kept = (): Promise<Kept | undefined> => within("readonly", (s) => s.get(key) as IDBRequest<Kept | undefined>);
export const forget = (): Promise<unknown> => within("readwrite", (s) => s.delete(key));
