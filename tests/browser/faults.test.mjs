// What goes wrong round the page: its storage is full, forbidden, silent or cleared, the graphics card
// is lost, there is no memory, a tab dies beside another or saves over it, one is hidden for an hour, the
// clock goes back. No work is lost, and nothing is silent.
//   node --test tests/browser/faults.test.mjs       (./dev test browser)
import assert from 'node:assert/strict';
import { join } from 'node:path';
import test, { after, before } from 'node:test';

import { serve } from '../../web/serve.mjs';
import { browser, open, root } from './chromium.mjs';

const built = process.env.ARTISKETCH_WEB ?? join(root, 'build', 'web');

let site;
before(async () => { site = await serve(join(built, 'site')); });
after(() => site.close());

async function openHero(editor) {
  await editor.until((state) => state.mode === 'welcome' && state.hasModel);
  await editor.click('Outline mode');
  await editor.until((state) => state.mode === 'outline' && state.frames > 0);
  await editor.once(() => editor.page.evaluate(() => artisketch.project(0, 0, 0)?.x > 0));
}

// A round outline about a pixel of the first drawing.
async function draw(editor, x, y) {
  const {revision} = await editor.state();
  await editor.click('Draw tool');
  await editor.drag(0, Array.from({length: 41}, (_, i) => {
    const angle = i * Math.PI / 20;
    return [x + 25 * Math.cos(angle), y + 25 * Math.sin(angle)];
  }));
  await editor.page.keyboard.press('Enter');
  await editor.until((state) => state.canUndo && state.revision !== revision);
}

const drawnAt = (document, x, y) => document.frames[0].contours.some(({points}) =>
  points.every(([px, py]) => Math.hypot(px - x, py - y) < 30));

const saved = async (editor) => JSON.parse((await editor.save()).bytes);

// How many pieces of work the browser keeps.
const kept = (page) => page.evaluate(() => new Promise((resolve) => {
  const request = indexedDB.open('artisketch', 1);
  request.onsuccess = () => {
    const all = request.result.transaction('kept').objectStore('kept').getAllKeys();
    all.onsuccess = () => resolve(all.result.filter((key) => String(key).startsWith('autosave')).length);
  };
}));

// The work kept under autosave's key, where there is one piece alone.
const keptDocument = (page) => page.evaluate(() => new Promise((resolve) => {
  const request = indexedDB.open('artisketch', 1);
  request.onsuccess = () => {
    const all = request.result.transaction('kept').objectStore('kept').getAll();
    all.onsuccess = () => resolve(all.result.map(({bytes}) => new TextDecoder().decode(bytes))
      .find((text) => text.startsWith('{') && text.includes('"frames"')));
  };
})).then((text) => text && JSON.parse(text));

async function crash(context, {page}) {
  const session = await context.newCDPSession(page);
  session.send('Page.crash').catch(() => {});
  await page.waitForEvent('crash');
}

// What is done to a page before its own scripts run.
const refusals = {
  full: () => {
    IDBObjectStore.prototype.put = () => { throw new DOMException('the disk is full', 'QuotaExceededError'); };
  },
  forbidden: () => {
    indexedDB.open = () => { throw new DOMException('not here', 'SecurityError'); };
  },
  silent: () => {
    indexedDB.open = () => ({});
  },
};
for (const [how, refuse] of Object.entries(refusals)) {
  test(`with a storage that is ${how} the page works, and says that it keeps nothing`, async (t) => {
    const context = await browser(t);
    await context.addInitScript(refuse);
    const editor = await open(context, site.url);
    await openHero(editor);
    await draw(editor, 60, 60);
    await editor.until((state) => /doesn't keep your work/.test(state.message));
    assert.ok(drawnAt(await saved(editor), 60, 60));
    await editor.until((state) => !state.unsaved);
  });
}

test('work that the browser clears away is said to be kept no longer', async (t) => {
  const context = await browser(t);
  const editor = await open(context, site.url);
  await openHero(editor);
  await draw(editor, 60, 60);
  await editor.once(async () => await kept(editor.page) === 1);
  const session = await context.newCDPSession(editor.page);
  await session.send('Storage.clearDataForOrigin', {origin: new URL(site.url).origin, storageTypes: 'indexeddb'});
  await draw(editor, 120, 60);
  await editor.until((state) => /doesn't keep your work/.test(state.message));
  assert.ok(drawnAt(await saved(editor), 120, 60));
});

test('without a graphics card the page says that the work is kept, and the next page has it', async (t) => {
  const context = await browser(t);
  const editor = await open(context, site.url);
  await openHero(editor);
  await draw(editor, 60, 60);
  await editor.page.evaluate(() => {
    document.getElementById('canvas').getContext('webgl2').getExtension('WEBGL_lose_context').loseContext();
  });
  const failure = editor.page.locator('#failure');
  await editor.once(async () => /is kept: reload/.test(await failure.textContent()));
  assert.ok(await failure.isVisible());
  // Nor does it pretend to go on, if the card comes back.
  await editor.page.evaluate(() => {
    document.getElementById('canvas').getContext('webgl2').getExtension('WEBGL_lose_context')?.restoreContext();
  });
  assert.ok(await failure.isVisible());
  await editor.page.reload();
  await editor.page.evaluate(() => artisketch.ready);
  await editor.until((state) => /not saved/.test(state.message));
  await editor.click('Keep');
  await editor.until((state) => state.mode !== 'welcome' && state.frames > 0);
  assert.ok(drawnAt(await saved(editor), 60, 60));
});

test('a page that gets no memory says so', async (t) => {
  const context = await browser(t);
  await context.addInitScript(() => {
    const refuse = () => Promise.reject(new RangeError('WebAssembly.instantiate(): Out of memory'));
    WebAssembly.instantiate = refuse;
    WebAssembly.instantiateStreaming = refuse;
  });
  const page = await context.newPage();
  await page.goto(site.url);
  await page.waitForFunction(() => /could not start: .*memory/.test(document.getElementById('failure').textContent));
  assert.ok(await page.locator('#failure').isVisible());
});

test('two tabs that die leave two pieces of work, and none is lost before it is answered', async (t) => {
  const context = await browser(t);
  const [one, two] = [await open(context, site.url), await open(context, site.url)];
  const places = [[60, 60], [140, 60]];
  for (const [i, editor] of [one, two].entries()) {
    await editor.page.bringToFront();
    await openHero(editor);
    await draw(editor, ...places[i]);
    await editor.once(async () => await kept(editor.page) === i + 1);
  }
  await crash(context, one);
  await crash(context, two);

  // The newest is offered. Something else is drawn before it is answered, and the tab dies, too.
  const third = await open(context, site.url);
  await third.until((state) => /not saved/.test(state.message));
  await openHero(third);
  await draw(third, 60, 140);
  await third.once(async () => await kept(third.page) === 3);
  await crash(context, third);

  const found = [];
  for (let i = 0; i < 3; ++i) {
    const editor = await open(context, site.url);
    await editor.until((state) => /not saved/.test(state.message));
    await editor.click('Keep');
    await editor.until((state) => state.mode !== 'welcome' && state.frames > 0);
    const document = await saved(editor);
    found.push([...places, [60, 140]].findIndex(([x, y]) => drawnAt(document, x, y)));
    await editor.once(async () => await kept(editor.page) === 2 - i); // what is saved is kept no longer
    await editor.page.close({runBeforeUnload: false});
  }
  assert.deepEqual(found.sort(), [0, 1, 2]);
});

// Clocks that the test moves: both of them on, or that of the day alone, back too.
function movableClocks() {
  window.passed = {run: 0, day: 0}; // milliseconds
  const [run, day] = [performance.now.bind(performance), Date.now];
  performance.now = () => run() + passed.run;
  Date.now = () => day() + passed.run + passed.day;
  let hidden = false;
  Object.defineProperty(document, 'hidden', {get: () => hidden});
  Object.defineProperty(document, 'visibilityState', {get: () => hidden ? 'hidden' : 'visible'});
  window.hide = (now) => {
    hidden = now;
    document.dispatchEvent(new Event('visibilitychange'));
  };
}

test('a tab that is hidden for an hour goes on where it was', async (t) => {
  const context = await browser(t);
  await context.addInitScript(movableClocks);
  const editor = await open(context, site.url);
  await openHero(editor);
  await draw(editor, 60, 60);
  await editor.page.evaluate(() => {
    hide(true);
    passed.run += 3600e3;
  });
  await editor.once(async () => await kept(editor.page) === 1); // while nobody looks
  await editor.page.evaluate(() => hide(false));
  await draw(editor, 140, 60);
  const document = await saved(editor);
  assert.ok(drawnAt(document, 60, 60) && drawnAt(document, 140, 60));
  assert.deepEqual(editor.faults, []);
});

test('a clock that goes back a day loses no work', async (t) => {
  const context = await browser(t);
  await context.addInitScript(movableClocks);
  const editor = await open(context, site.url);
  await openHero(editor);
  await draw(editor, 60, 60);
  await editor.once(async () => await kept(editor.page) === 1);
  await editor.page.evaluate(() => { passed.day -= 86400e3; });
  await draw(editor, 140, 60);
  await editor.once(async () => {
    const document = await keptDocument(editor.page);
    return document && drawnAt(document, 140, 60);
  });
  await crash(context, editor);
  const next = await open(context, site.url);
  await next.until((state) => /not saved/.test(state.message));
  await next.click('Keep');
  await next.until((state) => state.mode !== 'welcome' && state.frames > 0);
  const document = await saved(next);
  assert.ok(drawnAt(document, 60, 60) && drawnAt(document, 140, 60));
});

test('of two tabs with one file the second is told before it replaces what the first saved', async (t) => {
  const context = await browser(t, {pickers: true});
  await context.addInitScript(() => {
    // A file as pickers give it, of the origin's own.
    const file = async () => (await navigator.storage.getDirectory()).getFileHandle('hero.artisketch', {create: true});
    window.showSaveFilePicker = file;
    window.showOpenFilePicker = async () => [await file()];
    window.onDisk = async () => JSON.parse(await (await (await file()).getFile()).text());
  });
  const onDisk = (editor) => editor.page.evaluate(() => window.onDisk());
  const one = await open(context, site.url);
  await openHero(one);
  await draw(one, 60, 60);
  await one.page.keyboard.press('Control+s');
  await one.until((state) => !state.unsaved);
  const two = await open(context, site.url);
  await two.page.keyboard.press('Control+o');
  await two.until((state) => state.mode !== 'welcome' && state.frames > 0);
  await two.click('Outline mode');
  await two.once(() => two.page.evaluate(() => artisketch.project(0, 0, 0)?.x > 0));
  await draw(two, 140, 60);
  await two.page.keyboard.press('Control+s');
  await two.until((state) => !state.unsaved);
  assert.ok(drawnAt(await onDisk(two), 140, 60));

  await one.page.bringToFront();
  await draw(one, 60, 140);
  await one.page.keyboard.press('Control+s');
  await one.until((state) => /saved by another program/.test(state.message));
  assert.ok((await one.state()).unsaved);
  assert.ok(drawnAt(await onDisk(one), 140, 60), 'the other tab\'s work is still there');
  await one.page.keyboard.press('Control+s');
  await one.until((state) => !state.unsaved);
  assert.ok(drawnAt(await onDisk(one), 60, 140));
});
