// The page's side of the editor: begins the two modules, draws when there is something to draw, and
// does for web/browser.cpp what only JavaScript can: files, storage, the worker, controls that a
// screen reader finds. Nothing is loaded from elsewhere, and nothing is ever sent anywhere.
//
// Scripts and tests may count on `artisketch`:
//   ready              promise that the editor is open
//   widgets()          [{label, x, y, width, height, enabled, active}] of the frame drawn last, CSS pixels
//   state()            {mode, busy, stage, progress, frame, frames, joints, hasModel, liveParts, revision,
//                    liveRevision, canUndo, undo, message, unsaved}
//   project(frame, x, y)   where that pixel of a sketch stands on the page: {x, y}, or null
'use strict';

const artisketch = (() => {
  const canvas = document.getElementById('canvas');
  let module = null; // the editor's

  // ------------------------------------------------------------ the page's own files

  // In the single file they stand inside, gzipped, in elements named after them; else beside the page.
  const inside = (name) => document.getElementById(`file:${name}`);

  async function bytesOf(name) {
    const element = inside(name);
    if (!element) {
      const answer = await fetch(name);
      if (!answer.ok) throw new Error(`${name} could not be loaded (${answer.status})`);
      return new Uint8Array(await answer.arrayBuffer());
    }
    const packed = Uint8Array.from(atob(element.textContent), (c) => c.charCodeAt(0));
    const stream = new Blob([packed]).stream().pipeThrough(new DecompressionStream('gzip'));
    return new Uint8Array(await new Response(stream).arrayBuffer());
  }

  // Compiles while it loads, where the server says that it is WebAssembly.
  async function compiled(name) {
    if (!inside(name)) {
      try {
        return await WebAssembly.compileStreaming(fetch(name));
      } catch (error) {
        if (error instanceof WebAssembly.CompileError) throw error;
      }
    }
    return WebAssembly.compile(await bytesOf(name));
  }

  // ------------------------------------------------------------ into the module

  // Calls the exported function with each Uint8Array as a pointer and a size, each string as UTF-8.
  function tell(name, ...values) {
    const taken = [];
    const place = (bytes, room) => {
      const at = module._malloc(room || 1);
      if (!at) throw new Error('out of memory');
      taken.push(at);
      module.HEAPU8.set(bytes, at);
      return at;
    };
    const args = values.flatMap((value) => {
      if (value instanceof Uint8Array) return [place(value, value.length), value.length];
      if (typeof value === 'string') {
        const text = new TextEncoder().encode(`${value}\0`);
        return [place(text, text.length)];
      }
      return [value];
    });
    try {
      return module[`_${name}`](...args);
    } finally {
      taken.forEach((at) => module._free(at));
      wake();
    }
  }

  const ask = (name, ...values) => JSON.parse(module.UTF8ToString(module[`_${name}`](...values)));

  // ------------------------------------------------------------ frames

  let due = false;
  let later = 0; // the timer of a frame that is due in a while

  function wake() {
    if (due || !module) return;
    due = true;
    // A hidden tab gets no animation frames, but what waits to be kept must still be kept.
    if (document.hidden) setTimeout(tick, 200);
    else requestAnimationFrame(tick);
  }

  function tick() {
    due = false;
    const rest = module._page_frame();
    reflect();
    clearTimeout(later);
    if (rest < 0.02) wake();
    else if (rest < 60) later = setTimeout(wake, 1000 * rest - 16); // the animation frame after it
  }

  function stir() {
    if (!module) return;
    module._page_stir();
    wake();
  }

  function watchInput() {
    const kinds = ['pointermove', 'pointerdown', 'pointerup', 'pointercancel', 'pointerleave', 'wheel',
      'mousemove', 'mousedown', 'mouseup', 'keydown', 'keyup', 'keypress', 'touchstart', 'touchmove',
      'touchend', 'touchcancel', 'resize', 'focus', 'blur'];
    for (const kind of kinds) addEventListener(kind, wake, {capture: true, passive: true});
    canvas.addEventListener('pointerdown', () => canvas.focus());
    canvas.addEventListener('contextmenu', (event) => event.preventDefault());
    document.addEventListener('visibilitychange', () => {
      due = false; // an animation frame that was asked for may never come
      stir();
    });
    matchMedia('(prefers-color-scheme: dark)').addEventListener('change', stir);
    watchPixelRatio();
    // SDL takes every key for the editor; these stay the browser's.
    addEventListener('keydown', (event) => {
      const command = event.ctrlKey || event.metaKey;
      const browsers = ['F5', 'F11', 'F12'].includes(event.key) ||
        (command && ['v', 'V'].includes(event.key)) || (command && event.key === 'r') ||
        (command && event.shiftKey && ['i', 'I', 'j', 'J', 'c', 'C', 'r', 'R'].includes(event.key));
      if (event.key === 'F6') {
        event.preventDefault();
        controls.firstElementChild?.focus();
      }
      if (browsers || event.key === 'F6') event.stopImmediatePropagation();
    }, {capture: true});
  }

  // The window may move to a screen of other density without a change of size.
  function watchPixelRatio() {
    matchMedia(`(resolution: ${devicePixelRatio}dppx)`).addEventListener('change', () => {
      dispatchEvent(new UIEvent('resize'));
      stir();
      watchPixelRatio();
    }, {once: true});
  }

  // ------------------------------------------------------------ what is kept in the browser

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

  // ------------------------------------------------------------ files

  const kMostRecents = 8;
  const handles = new Map(); // place → FileSystemFileHandle
  const isDocument = (name) => /\.artisketch$/i.test(name);
  const kinds = {
    artisketch: {description: 'ArtiSketch document', accept: {'application/json': ['.artisketch']}},
    glb: {description: 'glTF model', accept: {'model/gltf-binary': ['.glb']}},
    obj: {description: 'Wavefront model', accept: {'model/obj': ['.obj']}},
    stl: {description: 'STL model', accept: {'model/stl': ['.stl']}},
    png: {description: 'Picture', accept: {'image/png': ['.png']}},
  };
  const images = {description: 'Drawings', accept: {'image/png': ['.png'], 'image/jpeg': ['.jpg', '.jpeg']}};

  async function placeOf(handle) {
    for (const [place, known] of handles) if (await known.isSameEntry(handle)) return place;
    const place = `file-${crypto.randomUUID()}`;
    handles.set(place, handle);
    return place;
  }

  // A document opened or saved: by its handle where the browser has such, else by a copy.
  async function remember(name, place, handle, bytes) {
    if (!isDocument(name)) return;
    const all = (await kept.all('recents')).sort((a, b) => b.time - a.time);
    const same = all.find((one) => one.place === place || (!handle && !one.handle && one.name === name));
    const key = place || same?.place || `copy-${crypto.randomUUID()}`;
    await kept.put('recents', key, {place: key, name, time: Date.now(), ...(handle ? {handle} : {bytes})});
    const others = all.filter((one) => one.place !== key);
    for (const old of others.slice(kMostRecents - 1)) await kept.drop('recents', old.place);
  }

  async function recents() {
    const all = (await kept.all('recents')).sort((a, b) => b.time - a.time);
    for (const one of all) if (one.handle) handles.set(one.place, one.handle);
    return all.map((one) => [one.name.replace(/\.artisketch$/i, ''), one.place]);
  }

  async function allowed(handle, mode) {
    if (!handle.queryPermission) return true;
    if (await handle.queryPermission({mode}) === 'granted') return true;
    return await handle.requestPermission({mode}) === 'granted';
  }

  async function deliver(question, files) {
    for (const {file, handle} of files) {
      const bytes = new Uint8Array(await file.arrayBuffer());
      const place = handle && isDocument(file.name) ? await placeOf(handle) : '';
      await remember(file.name, place, handle, bytes);
      tell('page_file', file.name, place, bytes);
    }
    if (files.length) tell('page_opened', question, '');
  }

  const aborted = (error) => error?.name === 'AbortError';
  const words = (error) => String(error?.message ?? error);

  async function chooseFiles(document_) {
    if (window.showOpenFilePicker) {
      try {
        const chosen = await showOpenFilePicker({
          multiple: !document_, types: [document_ ? kinds.artisketch : images]});
        return Promise.all(chosen.map(async (handle) => ({file: await handle.getFile(), handle})));
      } catch (error) {
        if (aborted(error)) return [];
      }
    }
    const input = document.getElementById('files');
    input.accept = document_ ? '.artisketch' : '.png,.jpg,.jpeg';
    input.multiple = !document_;
    input.value = '';
    return new Promise((resolve) => {
      input.onchange = () => resolve([...input.files].map((file) => ({file})));
      input.oncancel = () => resolve([]);
      input.click();
    });
  }

  function download(name, bytes) {
    const link = document.createElement('a');
    link.href = URL.createObjectURL(new Blob([bytes], {type: 'application/octet-stream'}));
    link.download = name;
    link.click();
    setTimeout(() => URL.revokeObjectURL(link.href), 60000);
  }

  async function handleFor(name, place) {
    const known = handles.get(place);
    if (known && await allowed(known, 'readwrite')) return known;
    if (!window.showSaveFilePicker) return null;
    const kind = kinds[name.split('.').pop()];
    try {
      return await showSaveFilePicker({suggestedName: name, ...(kind ? {types: [kind]} : {})});
    } catch (error) {
      if (aborted(error)) throw error;
      return null; // not here (a frame of another site's page), or too long after the click
    }
  }

  async function saveFile(name, place, bytes) {
    const handle = await handleFor(name, place);
    if (!handle) {
      download(name, bytes);
      await remember(name, '', null, bytes);
      return {name, place: ''};
    }
    const stream = await handle.createWritable();
    await stream.write(bytes);
    await stream.close();
    const where = await placeOf(handle);
    await remember(handle.name, where, handle, bytes);
    return {name: handle.name, place: where};
  }

  function watchDrops() {
    addEventListener('dragover', (event) => event.preventDefault());
    addEventListener('drop', async (event) => {
      event.preventDefault();
      // Both must be asked for before the event is over.
      const items = [...event.dataTransfer.items].filter((item) => item.kind === 'file').map((item) => ({
        file: item.getAsFile(),
        handle: item.getAsFileSystemHandle?.().catch(() => null),
      }));
      try {
        const files = await Promise.all(items.map(async ({file, handle}) => ({file, handle: await handle})));
        await deliver(0, files.filter(({file}) => file));
      } catch (error) {
        tell('page_opened', 0, words(error));
      }
    });
    addEventListener('paste', async (event) => {
      const files = [...event.clipboardData.files].map((file) => ({file}));
      if (files.length) await deliver(0, files);
      else tell('page_paste', event.clipboardData.getData('text'));
    });
  }

  // ------------------------------------------------------------ the worker

  let core; // the compiled module, a promise
  let worker = null;

  // The worker's file is asked for once; in the single file it is a part of the page.
  let workerPlace = null;
  async function workerUrl() {
    if (!inside('worker.js')) return 'worker.js';
    return URL.createObjectURL(new Blob([await bytesOf('worker.js')], {type: 'text/javascript'}));
  }

  function beginWorker() {
    core ??= compiled('core.wasm');
    workerPlace ??= workerUrl();
    const begun = {ended: false, thread: null, waiting: []};
    worker = begun;
    const died = (ofMemory, why) => {
      if (worker === begun) tell('page_died', ofMemory, why);
    };
    Promise.all([core, workerPlace]).then(([module_, url]) => {
      if (begun.ended) return;
      begun.thread = new Worker(url);
      begun.thread.onerror = (event) => died(false, event.message || 'the worker could not be loaded');
      begun.thread.onmessage = ({data}) => {
        if (worker !== begun) return;
        if (data.progress) tell('page_progress', data.progress);
        if (data.outcome) tell('page_outcome', data.outcome);
        if (data.died) died(data.died.ofMemory, data.died.why);
      };
      begun.thread.postMessage({compiled: module_});
      begun.waiting.forEach((request) => begun.thread.postMessage({request}));
    }).catch((error) => {
      // Tried again from the start with the next job.
      core = undefined;
      begun.failed = words(error);
      if (begun.waiting.length) died(false, begun.failed);
    });
  }

  function post(request) {
    if (!worker || worker.failed) beginWorker();
    if (worker.thread) worker.thread.postMessage({request});
    else worker.waiting.push(request);
  }

  function restart() {
    if (worker) {
      worker.ended = true;
      worker.thread?.terminate();
    }
    worker = null;
    // Not at once: a worker that cannot begin must not begin for ever.
    setTimeout(() => worker ?? beginWorker(), 100);
  }

  // ------------------------------------------------------------ controls for all

  // A button, unseen, over each of the canvas's controls: a screen reader and the keyboard (F6) reach
  // them, and pressing one clicks what is drawn there.
  const controls = document.getElementById('controls');
  const status = document.getElementById('status');
  let reflected = '';
  let reflecting = 0;

  function reflect() {
    reflecting ||= setTimeout(() => {
      reflecting = 0;
      const listed = module.UTF8ToString(module._page_widgets());
      if (listed !== reflected) {
        reflected = listed;
        arrange(JSON.parse(listed));
      }
      const {message} = ask('page_state');
      if (status.textContent !== message) status.textContent = message;
    }, 250);
  }

  function arrange(widgets) {
    while (controls.children.length > widgets.length) controls.lastElementChild.remove();
    widgets.forEach(({label, x, y, width, height, enabled, active}, at) => {
      const button = controls.children[at] ?? controls.appendChild(document.createElement('button'));
      if (button.textContent !== label) button.textContent = label;
      // Not `disabled`: that would take the focus away while work is done.
      button.setAttribute('aria-disabled', String(!enabled));
      button.setAttribute('aria-pressed', String(active));
      Object.assign(button.style, {
        left: `${x}px`, top: `${y}px`, width: `${width}px`, height: `${height}px`});
    });
  }

  function clickCanvas({left, top, width, height}) {
    const at = {clientX: left + width / 2, clientY: top + height / 2, bubbles: true, button: 0};
    const steps = ['mousemove', 'mousedown', 'mouseup'];
    const step = () => {
      const kind = steps.shift();
      if (!kind) return;
      canvas.dispatchEvent(new MouseEvent(kind, {...at, buttons: kind === 'mousedown' ? 1 : 0}));
      requestAnimationFrame(step);
    };
    step();
  }

  function watchControls() {
    controls.addEventListener('click', (event) => {
      if (event.target !== controls) clickCanvas(event.target.getBoundingClientRect());
    });
    controls.addEventListener('keydown', (event) => {
      if (event.key === 'Escape' || event.key === 'F6') canvas.focus();
    });
  }

  // ------------------------------------------------------------ what browser.cpp asks for

  let unsaved = false;
  // [[name, drawings]…]; the first greets, and comes with its model.
  const examples = JSON.parse(document.querySelector('meta[name=examples]').content);
  const fetched = new Map(); // example → promise

  function example(name) {
    if (!fetched.has(name)) {
      fetched.set(name, Promise.all([
        bytesOf(`examples/${name}.artisketch`),
        name === examples[0][0] ? bytesOf(`examples/${name}.glb`) : new Uint8Array()]));
    }
    return fetched.get(name);
  }

  const host = {
    wake,
    post,
    restart,
    async open(question, document_) {
      try {
        await deliver(question, await chooseFiles(document_));
      } catch (error) {
        tell('page_opened', question, words(error));
      }
    },
    async openRecent(question, place) {
      try {
        const {name, handle, bytes} = await kept.get('recents', place) ?? {};
        if (!name) throw new Error('This document is no longer known here');
        if (handle && !await allowed(handle, 'read')) throw new Error(`No leave to read ${name}`);
        const file = handle ? await handle.getFile() : new File([bytes], name);
        await deliver(question, [{file, handle}]);
      } catch (error) {
        tell('page_opened', question, words(error));
      }
    },
    async save(question, name, place, bytes) {
      try {
        const saved = await saveFile(name, place, bytes);
        tell('page_saved', question, saved.name, saved.place, '');
      } catch (error) {
        if (!aborted(error)) tell('page_saved', question, '', '', words(error));
      }
    },
    store(key, bytes) {
      const name = key === 'autosave' ? own.name : key;
      (bytes.length ? kept.put('kept', name, {time: Date.now(), bytes}) : kept.drop('kept', name))
        .catch(() => {});
    },
    async load(question, key) {
      const found = key === 'autosave' ? own.inherit() : kept.get('kept', key).then((it) => it?.bytes);
      tell('page_loaded', question, await found.catch(() => undefined) ?? new Uint8Array());
    },
    async loadExample(question, name) {
      try {
        tell('page_example', question, ...await example(name), '');
      } catch (error) {
        fetched.delete(name);
        tell('page_example', question, new Uint8Array(), new Uint8Array(), words(error));
      }
    },
    async loadExamplePicture(question, name) {
      tell('page_loaded', question, await bytesOf(`examples/${name}.png`).catch(() => new Uint8Array()));
    },
    title(title, unsavedWork) {
      document.title = unsavedWork ? `• ${title}` : title;
      unsaved = unsavedWork;
    },
    prefersDark: () => matchMedia('(prefers-color-scheme: dark)').matches,
    macKeys: () => /Mac|iPhone|iPad/.test(navigator.platform),
    copy(text) {
      navigator.clipboard?.writeText(text).catch(() => {});
    },
  };

  // ------------------------------------------------------------ the start

  function fail(why) {
    const place = document.getElementById('failure');
    place.textContent = `ArtiSketch could not start: ${why}`;
    place.hidden = false;
  }

  async function start() {
    const program = compiled('editor.wasm');
    const listed = recents().catch(() => []);
    example(examples[0][0]).catch(() => {}); // is needed soon
    // The context that the editor then gets: it keeps what was drawn, so that only changes need be.
    canvas.getContext('webgl2', {alpha: false, antialias: false, depth: false, preserveDrawingBuffer: true});
    const begun = await createEditor({
      canvas,
      host,
      instantiateWasm(imports, done) {
        program.then((it) => WebAssembly.instantiate(it, imports)).then(done)
          .catch((error) => fail(words(error)));
        return {};
      },
    });
    module = begun;
    const fault = tell('page_start', innerWidth, innerHeight,
      JSON.stringify({examples, recents: await listed}));
    if (fault) {
      const why = module.UTF8ToString(fault);
      module = null;
      throw new Error(why);
    }
    watchInput();
    watchDrops();
    watchControls();
    addEventListener('beforeunload', (event) => {
      if (unsaved) event.preventDefault();
    });
    canvas.focus();
    wake();
    // The worker's turn once the first picture is there.
    setTimeout(() => worker ?? beginWorker(), 500);
  }

  const ready = start();
  ready.catch((error) => fail(words(error)));

  return {
    ready,
    widgets: () => ask('page_widgets'),
    state: () => ask('page_state'),
    project: (frame, x, y) => ask('page_project', frame, x, y),
  };
})();
