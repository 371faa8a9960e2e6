// Keeps values in IndexedDB, where the job under work with its data files and history has room. Without it nothing is kept.

const STORE = "kept";

function open(): Promise<IDBDatabase> {
  return new Promise((resolve, reject) => {
    const request = indexedDB.open("flankwright", 1);
    request.onupgradeneeded = () => request.result.createObjectStore(STORE);
    request.onsuccess = () => resolve(request.result);
    request.onerror = () => reject(request.error ?? new Error("no storage"));
  });
}

async function use<T>(mode: IDBTransactionMode, work: (store: IDBObjectStore) => IDBRequest<T>): Promise<T | undefined> {
  try {
    const database = await open();
    return await new Promise<T>((resolve, reject) => {
      const request = work(database.transaction(STORE, mode).objectStore(STORE));
      request.onsuccess = () => resolve(request.result);
      request.onerror = () => reject(request.error ?? new Error("no storage"));
    });
  } catch {
    return undefined;
  }
}

export const keep = (name: string, value: unknown): Promise<unknown> => use("readwrite", (store) => store.put(value, name));

export const recall = <T>(name: string): Promise<T | undefined> =>
  use<T>("readonly", (store) => store.get(name) as IDBRequest<T>);
