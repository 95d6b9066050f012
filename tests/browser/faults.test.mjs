// What goes wrong round the page: its storage is full, forbidden, silent or cleared, the graphics card
// is lost, there is no memory, a tab dies beside another. No work is lost, and nothing is silent.
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
    await editor.page.close({runBeforeUnload: false});
  }
  assert.deepEqual(found.sort(), [0, 1, 2]);
});
