// What the browser keeps for the page: settings, recent documents, and work that isn't saved.
'use strict';

function browserStorage() {
  // IndexedDB, or, where that is refused or never answers, this tab's memory.
  const kPatience = 5000; // ms
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
        setTimeout(resolve, kPatience, null);
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
      lasts: () => database.then(Boolean), // beyond this tab
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
  // lives: what a tab finds without its lock was left behind. Without locks, all others' was.
  const own = (() => {
    const name = `autosave-${crypto.randomUUID?.() ?? `${Date.now()}-${Math.random()}`}`;
    // Whether the lock is this tab's from now on, until `until` resolves.
    const hold = (lock, until) => new Promise((resolve) => {
      if (!navigator.locks) return resolve(true);
      navigator.locks.request(lock, {ifAvailable: true}, (held) => {
        resolve(Boolean(held));
        return held && until;
      }).catch(() => resolve(false));
    });
    hold(name, new Promise(() => {}));
    let left; // {key, release}: what this tab offers, in its place until that is answered
    return {
      name,
      // The newest that was left behind.
      async leftBehind() {
        const found = [];
        for (const key of await kept.keys('kept')) {
          if (/^autosave/.test(key) && key !== name) found.push({key, ...await kept.get('kept', key)});
        }
        found.sort((a, b) => b.time - a.time);
        for (const {key, bytes} of found) {
          let release;
          if (!await hold(key, new Promise((resolve) => { release = resolve; }))) continue;
          left = {key, release};
          return bytes;
        }
        return undefined;
      },
      async forgetLeft() {
        if (!left) return;
        const {key, release} = left;
        left = undefined;
        await kept.drop('kept', key).finally(release);
      },
    };
  })();

  return {kept, own};
}
