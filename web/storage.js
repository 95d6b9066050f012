// What the browser keeps for the page: settings, recent documents, and work that isn't saved.
'use strict';

function browserStorage() {
  // IndexedDB, or, where that is refused, this tab's memory.
  const kept = (() => {
    const memory = {kept: new Map(), recents: new Map()};
    const database = new Promise((resolve) => {
      try {
        const request = indexedDB.open('artisketch', 1);
        request.onupgradeneeded = () => {
          for (const store of Object.keys(memory)) request.result.createObjectStore(store);
        };
        request.onsuccess = () => resolve(request.result);
        request.onerror = request.onblocked = () => resolve(null);
      } catch {
        resolve(null);
      }
    });
    const run = (store, mode, work) => database.then((open) => new Promise((resolve, reject) => {
      if (!open) return resolve(undefined);
      const transaction = open.transaction(store, mode);
      const request = work(transaction.objectStore(store));
      transaction.oncomplete = () => resolve(request.result);
      transaction.onerror = transaction.onabort = () => reject(transaction.error);
    }));
    return {
      async get(store, key) {
        if (!await database) return memory[store].get(key);
        return run(store, 'readonly', (s) => s.get(key));
      },
      async all(store) {
        if (!await database) return [...memory[store].values()];
        return run(store, 'readonly', (s) => s.getAll());
      },
      async keys(store) {
        if (!await database) return [...memory[store].keys()];
        return run(store, 'readonly', (s) => s.getAllKeys());
      },
      async put(store, key, value) {
        if (!await database) return void memory[store].set(key, value);
        return run(store, 'readwrite', (s) => s.put(value, key));
      },
      async drop(store, key) {
        if (!await database) return void memory[store].delete(key);
        return run(store, 'readwrite', (s) => s.delete(key));
      },
    };
  })();

  // Each tab keeps its work under a name of its own, and holds a lock of that name for as long as it
  // lives: what a tab finds without its lock was left behind.
  const own = (() => {
    let name = 'autosave';
    if (navigator.locks && crypto.randomUUID) {
      name = `autosave-${crypto.randomUUID()}`;
      navigator.locks.request(name, () => new Promise(() => {})).catch(() => {});
    }
    return {
      name,
      // The newest that was left behind, now this tab's.
      async inherit() {
        const held = new Set();
        if (navigator.locks) (await navigator.locks.query()).held.forEach((lock) => held.add(lock.name));
        const left = [];
        for (const key of await kept.keys('kept')) {
          if (!/^autosave/.test(key) || key === name || held.has(key)) continue;
          left.push({key, ...await kept.get('kept', key)});
        }
        left.sort((a, b) => b.time - a.time);
        if (!left.length) return undefined;
        await kept.put('kept', name, {time: left[0].time, bytes: left[0].bytes});
        await kept.drop('kept', left[0].key);
        return left[0].bytes;
      },
    };
  })();

  return {kept, own};
}
