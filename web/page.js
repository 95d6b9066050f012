// The page's side of the editor: begins the two modules, draws when there is something to draw, and
// does for web/browser.cpp what only JavaScript can: files (files.js), storage (storage.js), the worker
// (core_worker.js), controls that a screen reader finds. Nothing is loaded from elsewhere, and nothing is
// ever sent anywhere.
//
// Scripts and tests may count on `artisketch`:
//   ready              promise that the editor is open
//   widgets()          [{label, words, x, y, width, height, enabled, active}] of the frame drawn last, CSS
//                    pixels; words: the label in the person's language
//   state()            {mode, busy, stage, progress, frame, frames, joints, hasModel, liveParts, revision,
//                    liveRevision, canUndo, undo, message, unsaved}
//   project(frame, x, y)   where that pixel of a sketch stands on the page: {x, y}, or null
'use strict';

const artisketch = (() => {
  const canvas = document.getElementById('canvas');
  const controls = document.getElementById('controls');
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

  // ------------------------------------------------------------ words

  let table = ''; // assets/languages/CODE.txt of the language chosen; empty: English

  // The sentence in that language, `what` in the place of its {0}.
  function say(english, what = '') {
    const at = `\n${table}`.indexOf(`\n${english}\n`);
    const found = at < 0 ? english : table.slice(at).split('\n')[1];
    return found.replace('{0}', () => what);
  }

  function speak(code, found) {
    table = found;
    document.documentElement.lang = code;
    canvas.setAttribute('aria-label', say('ArtiSketch. F6 leads to its controls, Escape back.'));
    controls.setAttribute('aria-label', say('Controls'));
  }

  const tableOf = async (code) => new TextDecoder().decode(await bytesOf(`languages/${code}.txt`));

  // The language kept, or the browser's, where the editor isn't there to say it.
  async function speakUnasked() {
    const chosen = await kept.get('kept', 'language');
    const code = chosen ? new TextDecoder().decode(chosen.bytes) : navigator.language.slice(0, 2);
    if (!table && code !== 'en') speak(code, await tableOf(code));
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

  // While a pen is near, it draws and fingers move the view. Some browsers send its tip as a touch, too.
  function watchPen() {
    let leaves = 0; // the timer of a pen that left, since a hand rests while it does
    let tip = null;
    const near = () => {
      clearTimeout(leaves);
      leaves = 0;
      module?._page_pen(true);
    };
    for (const kind of ['pointerover', 'pointermove', 'pointerdown']) {
      addEventListener(kind, (event) => {
        if (event.pointerType !== 'pen') return;
        near();
        if (kind === 'pointerdown') tip = event;
      }, {capture: true, passive: true});
    }
    addEventListener('pointerout', (event) => {
      if (event.pointerType !== 'pen' || event.relatedTarget || leaves) return;
      leaves = setTimeout(() => module?._page_pen(false), 1000);
    }, {capture: true, passive: true});
    addEventListener('touchstart', ({changedTouches}) => {
      for (const {identifier, clientX, clientY} of changedTouches) {
        if (!tip || Math.hypot(clientX - tip.clientX, clientY - tip.clientY) > 2) continue;
        module?._page_pen_touches(identifier);
        tip = null;
      }
    }, {capture: true, passive: true});
  }

  // The window may move to a screen of other density without a change of size.
  function watchPixelRatio() {
    matchMedia(`(resolution: ${devicePixelRatio}dppx)`).addEventListener('change', () => {
      dispatchEvent(new UIEvent('resize'));
      stir();
      watchPixelRatio();
    }, {once: true});
  }

  // ------------------------------------------------------------ controls for all

  // A button, unseen, over each of the canvas's controls: a screen reader and the keyboard (F6) reach
  // them, and pressing one clicks what is drawn there.
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
    const focused = controls.contains(document.activeElement) ? document.activeElement.textContent : null;
    while (controls.children.length > widgets.length) controls.lastElementChild.remove();
    widgets.forEach(({words, x, y, width, height, enabled, active}, at) => {
      const button = controls.children[at] ?? controls.appendChild(document.createElement('button'));
      if (button.textContent !== words) button.textContent = words;
      // Not `disabled`: that would take the focus away while work is done.
      button.setAttribute('aria-disabled', String(!enabled));
      button.setAttribute('aria-pressed', String(active));
      Object.assign(button.style, {
        left: `${x}px`, top: `${y}px`, width: `${width}px`, height: `${height}px`});
    });
    if (focused === null || document.activeElement.textContent === focused) return;
    // The keyboard's place is a control, wherever that comes to stand among the others.
    const same = [...controls.children].find((button) => button.textContent === focused);
    (same ?? controls.firstElementChild ?? canvas).focus();
  }

  // The browser may take the graphics card back, or the card may fail. What was drawn with it is gone;
  // the document is not: it is kept as ever, and offered by the next page.
  function watchGraphics() {
    const kKept = 4000; // ms: by then a change is kept
    canvas.addEventListener('webglcontextlost', (event) => {
      event.preventDefault();
      const frames = setInterval(stir, 500);
      fail(say('The browser took the graphics card from this page. Your work is being kept …'));
      setTimeout(() => {
        clearInterval(frames);
        unsaved = false;
        fail(say('The browser took the graphics card from this page. Your work is kept: reload the page to go on.'));
      }, kKept);
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

  // ------------------------------------------------------------ the page's other scripts

  const {kept, own} = browserStorage();
  const files = browserFiles(kept, tell, say);
  const worker = coreWorker({
    tell,
    module: () => compiled('core.wasm'),
    example: async () => (await example(examples[0][0]))[0],
    async script() {
      if (!inside('worker.js')) return 'worker.js';
      return URL.createObjectURL(new Blob([await bytesOf('worker.js')], {type: 'text/javascript'}));
    },
  });

  // ------------------------------------------------------------ what browser.cpp asks for

  let unsaved = false;
  let saidNotKept = false; // once is enough
  // [[name, drawings, shelf]…]; the first greets, and comes with its model. The shelf is
  // ExampleCard::Shelf; a gallery's figure is fetched when it is looked at.
  const examples = JSON.parse(document.querySelector('meta[name=examples]').content);
  const fetched = new Map(); // example → promise

  const placeOf = (name) => `${examples.find((one) => one[0] === name)[2] ? 'gallery' : 'examples'}/${name}`;

  function example(name) {
    if (!fetched.has(name)) {
      fetched.set(name, Promise.all([
        bytesOf(`${placeOf(name)}.artisketch`),
        name === examples[0][0] ? bytesOf(`${placeOf(name)}.glb`) : new Uint8Array()]));
    }
    return fetched.get(name);
  }

  const host = {
    wake,
    post: worker.post,
    restart: worker.restart,
    open: files.openFiles,
    openRecent: files.openRecent,
    async save(question, name, place, bytes) {
      try {
        const saved = await files.saveFile(name, place, bytes);
        tell('page_saved', question, saved.name, saved.place, '');
      } catch (error) {
        if (!aborted(error)) tell('page_saved', question, '', '', words(error));
      }
    },
    async store(key, bytes) {
      const name = key === 'autosave' ? own.name : key;
      if (key === 'language') speak(new TextDecoder().decode(bytes), '');
      try {
        if (key === 'left') await own.forgetLeft();
        else if (!bytes.length) await kept.drop('kept', name);
        else await kept.put('kept', name, {time: Date.now(), bytes});
        if (key === 'autosave' && bytes.length && !await kept.lasts()) throw new Error('it forbids it');
      } catch (error) {
        if (key !== 'autosave' || !bytes.length || saidNotKept) return;
        saidNotKept = true;
        tell('page_opened', 0, `The browser doesn't keep your work (${words(error)}): save it yourself`);
      }
    },
    async load(question, key) {
      const found = key === 'left' ? own.leftBehind() : kept.get('kept', key).then((it) => it?.bytes);
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
      tell('page_loaded', question, await bytesOf(`${placeOf(name)}.png`).catch(() => new Uint8Array()));
    },
    async loadWords(question, code) {
      const found = await tableOf(code).catch(() => '');
      if (found) speak(code, found);
      tell('page_loaded', question, new TextEncoder().encode(found));
    },
    title(title, unsavedWork) {
      document.title = unsavedWork ? `• ${title}` : title;
      unsaved = unsavedWork;
    },
    hasGuide: () => !inside('core.wasm'), // the single file comes without it
    showGuide: () => open('guide/index.html', '_blank', 'noopener'),
    prefersDark: () => matchMedia('(prefers-color-scheme: dark)').matches,
    macKeys: () => /Mac|iPhone|iPad/.test(navigator.platform),
    copy(text) {
      navigator.clipboard?.writeText(text).catch(() => {});
    },
  };

  // ------------------------------------------------------------ the start

  function fail(why) {
    const place = document.getElementById('failure');
    place.textContent = why;
    place.hidden = false;
  }

  async function notStarted(error) {
    await speakUnasked().catch(() => {}); // in English, then
    fail(say('ArtiSketch could not start: {0}', say(words(error))));
  }

  async function start() {
    const program = compiled('editor.wasm');
    const listed = files.recents().catch(() => []);
    example(examples[0][0]).catch(() => {}); // is needed soon
    // The context that the editor then gets: it keeps what was drawn, so that only changes need be.
    const drawsWith = {alpha: false, antialias: false, depth: false, preserveDrawingBuffer: true};
    if (!canvas.getContext('webgl2', drawsWith)) {
      throw new Error('this browser gives it nothing to draw with (WebGL 2). Turn graphics acceleration on ' +
        'in its settings and load the page anew, or open it in a current Chrome, Edge, Firefox or Safari.');
    }
    const begun = await createEditor({
      canvas,
      host,
      instantiateWasm(imports, done) {
        program.then((it) => WebAssembly.instantiate(it, imports)).then(done)
          .catch(notStarted);
        return {};
      },
    });
    module = begun;
    const fault = tell('page_start', innerWidth, innerHeight,
      JSON.stringify({examples, recents: await listed, language: navigator.language}));
    if (fault) {
      const why = module.UTF8ToString(fault);
      module = null;
      throw new Error(why);
    }
    watchInput();
    watchPen();
    files.watchDrops();
    watchControls();
    watchGraphics();
    addEventListener('beforeunload', (event) => {
      if (unsaved) event.preventDefault();
    });
    canvas.focus();
    wake();
    // The worker's turn once the first picture is there.
    setTimeout(worker.ready, 500);
  }

  const ready = start();
  ready.catch(notStarted);

  return {
    ready,
    widgets: () => ask('page_widgets'),
    state: () => ask('page_state'),
    project: (frame, x, y) => ask('page_project', frame, x, y),
  };
})();
