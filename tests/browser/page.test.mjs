// The page as people get it, in Chromium: from a plain static server and from disk.
//   node --test tests/browser/       (./dev test browser)
import assert from 'node:assert/strict';
import { execFileSync } from 'node:child_process';
import { mkdirSync, mkdtempSync, readFileSync, readdirSync, rmSync, statSync } from 'node:fs';
import { createRequire } from 'node:module';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import test, { after, before } from 'node:test';
import { pathToFileURL } from 'node:url';
import { brotliCompressSync } from 'node:zlib';

import { serve } from '../../web/serve.mjs';
import { browser, open, root } from './chromium.mjs';
import { difference, surface } from './glb.mjs';

const built = process.env.ARTISKETCH_WEB ?? join(root, 'build', 'web');
const single = pathToFileURL(join(built, 'artisketch.html')).href;
const shots = join(built, 'shots');
const validator = createRequire(join(root, 'build', 'node', 'package.json'))('gltf-validator');

let site;
before(async () => {
  site = await serve(join(built, 'site'));
  mkdirSync(shots, {recursive: true});
});
after(() => site.close());

const hasHero = (state) => state.mode === 'welcome' && state.hasModel;
const isDone = (state) => !state.busy && state.hasModel;

// The hero as a document of one's own, in outline mode.
async function openHero(editor) {
  await editor.until(hasHero);
  await editor.click('Outline mode');
  await editor.until((state) => state.mode === 'outline' && state.frames > 0);
  // The drawing finds its place with the frame after.
  await editor.once(() => editor.page.evaluate(() => artisketch.project(0, 0, 0)?.y > 0));
}

// Share of the picture's pixels that are unlike its commonest colour.
async function variety(page, clip) {
  const png = (await page.screenshot({clip})).toString('base64');
  return page.evaluate(async (data) => {
    const image = new Image();
    image.src = `data:image/png;base64,${data}`;
    await image.decode();
    const canvas = new OffscreenCanvas(image.width, image.height).getContext('2d');
    canvas.drawImage(image, 0, 0);
    const pixels = new Uint32Array(canvas.getImageData(0, 0, image.width, image.height).data.buffer);
    const counts = new Map();
    for (const p of pixels) counts.set(p, (counts.get(p) ?? 0) + 1);
    return 1 - Math.max(...counts.values()) / pixels.length;
  }, png);
}

for (const [where, url] of [['a static server', () => site.url], ['disk', () => single]]) {
  test(`from ${where}: opens, shows the hero, asks for nothing from elsewhere`, async (t) => {
    const editor = await open(await browser(t), url());
    const state = await editor.until(hasHero);
    assert.ok(state.frames >= 2, 'the hero has several drawings');
    assert.ok(await variety(editor.page, {x: 100, y: 100, width: 1000, height: 500}) > 0.05, 'the hero is seen');
    for (const request of editor.requests) {
      assert.ok(request.startsWith(site.url) || request.startsWith(single) || /^(data|blob):/.test(request), request);
    }
    assert.deepEqual(editor.faults, []);
  });

  test(`from ${where}: reconstructs with progress while frames are drawn, and cancels`, async (t) => {
    const editor = await open(await browser(t), url());
    await openHero(editor);
    await editor.click('Reconstruct');
    await editor.until((state) => state.busy);
    await editor.page.evaluate(() => {
      window.progress = [];
      window.watch = setInterval(() => {
        const {busy, stage, progress} = artisketch.state();
        if (busy) window.progress.push([stage, progress]);
      }, 50);
    });
    const began = Date.now();
    const first = await editor.frames();
    await editor.until(isDone);
    const seconds = (Date.now() - began) / 1000;
    const rate = (await editor.frames() - first) / seconds;
    assert.ok(rate > 0, 'frames are drawn meanwhile');
    const progress = await editor.page.evaluate(() => { clearInterval(window.watch); return window.progress; });
    assert.ok(new Set(progress.map(([stage]) => stage)).size >= 2, `stages: ${progress}`);
    assert.ok(progress.every(([, share], i) => i === 0 || share >= progress[i - 1][1]), 'progress never falls');
    t.diagnostic(`reconstructed in ${seconds.toFixed(1)} s, ${rate.toFixed(0)} frames a second meanwhile`);

    await editor.click('Reconstruct');
    await editor.until((state) => state.busy && state.progress > 0);
    // From the pointer's release on, as the page has it.
    await editor.page.evaluate(() => {
      addEventListener('pointerup', () => {
        const released = performance.now();
        const watch = setInterval(() => {
          if (artisketch.state().busy) return;
          clearInterval(watch);
          window.cancelledIn = performance.now() - released;
        }, 5);
      }, {capture: true, once: true});
    });
    await editor.click('Cancel');
    const state = await editor.until((now) => !now.busy);
    await editor.page.waitForFunction(() => window.cancelledIn !== undefined);
    const cancelledIn = await editor.page.evaluate(() => window.cancelledIn);
    t.diagnostic(`cancelled in ${cancelledIn.toFixed(0)} ms`);
    assert.ok(state.hasModel, 'the old model stays');

    await editor.click('Reconstruct');
    await editor.until((now) => now.busy);
    await editor.until(isDone);
    assert.deepEqual(editor.faults, []);
  });
}

test('a figure of the gallery is fetched when it is looked at, and made', async (t) => {
  const editor = await open(await browser(t), site.url);
  await editor.until(hasHero);
  const fetched = () => editor.requests.filter((request) => request.includes('/gallery/'));
  assert.deepEqual(fetched(), []);
  await editor.click('Gallery');
  await editor.widget(/^Example Prince$/);
  await editor.rest(1);
  await editor.page.screenshot({path: join(shots, 'gallery.png')});
  assert.ok(fetched().length > 5 && fetched().every((request) => request.endsWith('.png')), `${fetched()}`);
  await editor.click('Example Monster');
  await editor.until((state) => state.mode === 'result' && state.busy);
  const state = await editor.until(isDone);
  assert.ok(state.hasModel && state.frames === 1);
  assert.deepEqual(fetched().filter((request) => request.endsWith('.artisketch')).length, 1);
  assert.deepEqual(editor.faults, []);
});

test('the single file says that the gallery is not in it', async (t) => {
  const editor = await open(await browser(t), single);
  await editor.until(hasHero);
  await editor.frame();
  assert.ok(!(await editor.widgets()).some(({label}) => label === 'Gallery'));
  await editor.page.screenshot({path: join(shots, 'single-file.png')});
});

// Width and height of the first image in a GLB.
function pictureSize(glb) {
  const length = glb.readUInt32LE(12), {images, bufferViews} = JSON.parse(glb.subarray(20, 20 + length));
  const png = glb.subarray(28 + length + (bufferViews[images[0].bufferView].byteOffset ?? 0));
  return [png.readUInt32BE(16), png.readUInt32BE(20)];
}

test('the downloaded model is valid, and the command line\'s', async (t) => {
  const editor = await open(await browser(t), site.url);
  await openHero(editor);
  await editor.click('Reconstruct');
  await editor.until((state) => state.busy);
  await editor.until(isDone);
  await editor.click('Export');
  const button = await editor.widget(/^Export .*\.glb$/);
  const {name, bytes} = await editor.download(() => editor.click(button.label));
  assert.match(name, /\.glb$/);
  const {issues} = await validator.validateBytes(new Uint8Array(bytes));
  assert.equal(issues.numErrors + issues.numWarnings, 0, JSON.stringify(issues.messages));

  const folder = mkdtempSync(join(tmpdir(), 'artisketch-models-'));
  t.after(() => rmSync(folder, {recursive: true}));
  const out = join(folder, 'hero.glb');
  execFileSync(join(root, 'build', 'native', 'artisketch'), [
    'reconstruct', join(root, 'assets/examples/hero/hero.artisketch'), '-o', out, '--grid', '64', '--quiet']);
  const apart = difference(surface(bytes), surface(readFileSync(out)));
  const smallest = await editor.widget(/^Texture \d+$/); // of those offered, the first
  await editor.click(smallest.label);
  const small = await editor.download(() => editor.click(button.label));
  assert.equal(`Texture ${Math.max(...pictureSize(small.bytes))}`, smallest.label);
  assert.ok(small.bytes.length < bytes.length);
  assert.equal((await validator.validateBytes(new Uint8Array(small.bytes))).issues.numErrors, 0);
  t.diagnostic(`the surfaces are ${apart} of the model's size apart`);
  assert.ok(apart <= 1e-4, `apart by ${apart}`);
});

function withoutWebGL2() {
  const context = HTMLCanvasElement.prototype.getContext;
  HTMLCanvasElement.prototype.getContext = function (kind, ...more) {
    return kind === 'webgl2' ? null : context.call(this, kind, ...more);
  };
}

test('a page that lacks WebGL 2 says what to do, and does nothing else', async (t) => {
  const context = await browser(t);
  await context.addInitScript(withoutWebGL2);
  const page = await context.newPage();
  const faults = [];
  page.on('pageerror', (error) => faults.push(error));
  await page.goto(site.url);
  const failure = page.locator('#failure');
  await failure.waitFor({state: 'visible'});
  assert.match(await failure.textContent(), /graphics acceleration/);
  await page.mouse.move(300, 300);
  await page.keyboard.press('d');
  await page.waitForTimeout(1000);
  assert.deepEqual(faults, []);
});

for (const [locale, failure, label] of [
  ['de-AT', /konnte nicht starten: Dieser Browser/, /F6 führt/], ['es-MX', /no pudo iniciarse: Este navegador/, /F6 lleva/],
]) {
  test(`the page itself speaks the browser's language: ${locale}`, async (t) => {
    const context = await browser(t, {locale});
    const {page} = await open(context, site.url);
    await page.waitForFunction(() => document.documentElement.lang !== 'en');
    assert.match(await page.getAttribute('#canvas', 'aria-label'), label);
    await context.addInitScript(withoutWebGL2);
    await page.goto(site.url);
    await page.waitForFunction(() => !document.getElementById('failure').hidden);
    assert.match(await page.textContent('#failure'), failure);
    assert.equal(await page.getAttribute('html', 'lang'), locale.slice(0, 2));
  });
}

test('a worker that crashes or lacks memory is reported in words, and the next one works', async (t) => {
  const context = await browser(t);
  let wrong = 'crash';
  await context.route('**/worker.js', async (route) => {
    const answer = await route.fetch();
    let body = await answer.text();
    // Live parts are made as ever: a request begins with its kind.
    const instead = (what) => `\n;{ const as_ever = onmessage; onmessage = (event) => {
      if (event.data.request && new DataView(event.data.request.slice(0, 4).buffer).getInt32(0, true) === 0) ${what}
      else as_ever(event); }; }`;
    if (wrong === 'crash') body += instead('throw new Error("a test broke it");');
    if (wrong === 'memory') body += instead('postMessage({died: {why: "out of memory", ofMemory: true}});');
    wrong = {crash: 'memory', memory: 'none', none: 'none'}[wrong];
    await route.fulfill({response: answer, body});
  });
  const editor = await open(context, site.url);
  await openHero(editor);
  await editor.until((state) => state.liveRevision === state.revision);
  await editor.click('Reconstruct');
  assert.match((await editor.until((s) => !s.busy && /broke off/.test(s.message))).message, /a test broke it/);
  await editor.click('Reconstruct');
  await editor.until((s) => !s.busy && /memory/.test(s.message));
  await editor.click('Reconstruct');
  await editor.until((s) => s.busy);
  assert.ok((await editor.until(isDone)).frames > 0, 'the document is untouched');
});

test('what was saved comes back, drawings and all', async (t) => {
  const editor = await open(await browser(t), site.url);
  await openHero(editor);
  const saved = await editor.save();
  assert.match(saved.name, /\.artisketch$/);
  const document = JSON.parse(saved.bytes);
  assert.ok(document.frames.every((frame) => frame.image.startsWith('data:image/')), 'drawings are inside');

  const again = await open(editor.page.context(), site.url);
  await again.until(hasHero);
  await drop(again.page, saved.name, saved.bytes);
  const state = await again.until((s) => s.mode !== 'welcome' && s.frames > 0);
  assert.equal(state.frames, document.frames.length);
  assert.deepEqual(state.joints, document.skeleton.joints.map((joint) => joint.name));
  assert.deepEqual(JSON.parse((await again.save()).bytes), document);
});

async function drop(page, name, bytes) {
  await dropAll(page, [{name, type: '', bytes}]);
}

// Files as the browser hands them over: {name, type, bytes}.
async function dropAll(page, files) {
  await page.evaluate((dropped) => {
    const transfer = new DataTransfer();
    for (const {name, type, data} of dropped) {
      transfer.items.add(new File([Uint8Array.from(atob(data), (c) => c.charCodeAt(0))], name, {type}));
    }
    document.getElementById('canvas').dispatchEvent(
      new DragEvent('drop', {dataTransfer: transfer, bubbles: true, cancelable: true}));
  }, files.map(({name, type, bytes}) => ({name, type, data: bytes.toString('base64')})));
}

test('drawings of all kinds that the browser shows are taken, damaged ones told', async (t) => {
  const editor = await open(await browser(t), site.url);
  const {page} = editor;
  await editor.until(hasHero);
  await page.keyboard.press('Control+n');
  await editor.until((state) => state.mode !== 'welcome');
  // A disc, as a WebP of 160 × 120.
  const webp = await page.evaluate(async () => {
    const canvas = new OffscreenCanvas(160, 120), brush = canvas.getContext('2d');
    brush.fillStyle = 'teal';
    brush.arc(80, 60, 40, 0, 7);
    brush.fill();
    const bytes = new Uint8Array(await (await canvas.convertToBlob({type: 'image/webp'})).arrayBuffer());
    return btoa(String.fromCharCode(...bytes));
  });
  const svg = '<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 30 60"><circle cx="15" cy="30" r="12"/></svg>';
  await dropAll(page, [
    {name: 'disc.webp', type: 'image/webp', bytes: Buffer.from(webp, 'base64')},
    {name: 'torn.webp', type: 'image/webp', bytes: Buffer.from('RIFF')},
    {name: 'lines.svg', type: 'image/svg+xml', bytes: Buffer.from(svg)},
  ]);
  const {message} = await editor.until((state) => state.frames === 2 && /torn/.test(state.message));
  assert.match(message, /torn\.webp is damaged.*PNG/);
  const {frames} = JSON.parse((await editor.save()).bytes);
  assert.deepEqual(frames.map(({name, size}) => [name, ...size]),
    [['disc', 160, 120], ['lines', 512, 1024]]);
  assert.ok(frames.every(({image}) => image.startsWith('data:image/png')));
});

test('two fingers pan and zoom, a tap of two undoes', async (t) => {
  const context = await browser(t, {touch: true});
  const editor = await open(context, site.url);
  await openHero(editor);
  const cdp = await context.newCDPSession(editor.page);
  const fingers = async (type, points) => {
    await cdp.send('Input.dispatchTouchEvent', {
      type, touchPoints: points.map(([x, y], id) => ({x, y, id}))});
    await editor.frame();
  };
  const where = async () => {
    await editor.page.waitForFunction(() => artisketch.project(0, 300, 300));
    return editor.page.evaluate(() => [[300, 300], [400, 300]].map(([x, y]) => {
      const at = artisketch.project(0, x, y);
      return [at.x, at.y];
    }));
  };
  const [[x, y]] = await where();
  const before = await where();
  await fingers('touchStart', [[x - 40, y]]);
  await fingers('touchStart', [[x - 40, y], [x + 40, y]]);
  for (let i = 1; i <= 10; i++) await fingers('touchMove', [[x - 40 - 4 * i, y + 3 * i], [x + 40 + 4 * i, y + 3 * i]]);
  const length = ([a, b]) => b[0] - a[0];
  await editor.once(async () => { // once the last move is drawn
    const now = await where();
    return Math.abs(now[0][1] - before[0][1] - 30) < 3 && Math.abs(length(now) / length(before) - 2) < 0.1;
  });
  await fingers('touchEnd', []);
  assert.equal((await editor.state()).canUndo, false, 'fingers draw nothing');

  await editor.click('Draw tool');
  await editor.drag(0, Array.from({length: 41}, (_, i) => [
    300 + 20 * Math.cos(i * Math.PI / 20), 300 + 20 * Math.sin(i * Math.PI / 20)]));
  await editor.page.keyboard.press('Enter');
  await editor.until((state) => state.canUndo);
  await fingers('touchStart', [[x - 40, y], [x + 40, y]]);
  await fingers('touchEnd', []);
  await editor.until((state) => !state.canUndo);

  // A finger that rests asks what can be done; what it began to draw is gone.
  const [cheek] = await where();
  await fingers('touchStart', [cheek]);
  await editor.widget('Delete');
  await fingers('touchEnd', []);
  await editor.click('Delete');
  await editor.until((state) => state.undo === 'Delete Head');
});

test('while a pen is near it draws, and a finger pans and taps', async (t) => {
  const context = await browser(t, {touch: true});
  const editor = await open(context, site.url);
  await openHero(editor);
  const {page} = editor;
  const cdp = await context.newCDPSession(page);
  const pen = (type, {x, y}, buttons = 0) => cdp.send('Input.dispatchMouseEvent', {
    type, x, y, buttons, pointerType: 'pen', ...(type === 'mouseMoved' ? {} : {button: 'left', clickCount: 1})});
  const touch = async (type, places) => {
    await cdp.send('Input.dispatchTouchEvent', {type, touchPoints: places.map(({x, y}) => ({x, y, id: 7}))});
    await editor.frame();
  };
  const where = (x, y) => page.evaluate((at) => artisketch.project(0, ...at), [x, y]);
  const disc = (t) => where(300 + 20 * Math.cos(t), 300 + 20 * Math.sin(t));

  await editor.click('Draw tool');
  await pen('mouseMoved', await disc(0));
  await editor.frame();
  const before = await where(300, 300);
  await touch('touchStart', [before]);
  for (let i = 1; i <= 10; i++) await touch('touchMove', [{x: before.x + 4 * i, y: before.y + 2 * i}]);
  await touch('touchEnd', []);
  await editor.once(async () => { // the finger pans
    const after = await where(300, 300);
    return Math.abs(after.x - before.x - 40) < 1 && Math.abs(after.y - before.y - 20) < 1;
  });
  assert.equal((await editor.state()).canUndo, false, 'and draws nothing');

  await pen('mouseMoved', await disc(0));
  await pen('mousePressed', await disc(0), 1);
  for (let i = 0; i <= 40; i++) {
    await pen('mouseMoved', await disc(i * Math.PI / 20), 1);
    await editor.frame();
  }
  await pen('mouseReleased', await disc(0));
  await page.keyboard.press('Enter');
  await editor.until((state) => state.undo.startsWith('Draw '));

  const {x, y, width, height} = await editor.widget('Undo');
  await touch('touchStart', [{x: x + width / 2, y: y + height / 2}]);
  await touch('touchEnd', []);
  await editor.until((state) => !state.canUndo);
  assert.deepEqual(editor.faults, []);
});

test('a killed tab loses little', async (t) => {
  const context = await browser(t);
  const editor = await open(context, site.url);
  await openHero(editor);
  const {page} = editor;
  await editor.click('Draw tool');
  const [x, y] = [60, 60];
  await editor.drag(0, Array.from({length: 41}, (_, i) => {
    const angle = i * Math.PI / 20;
    return [x + 25 * Math.cos(angle), y + 25 * Math.sin(angle)];
  }));
  await page.keyboard.press('Enter');
  await editor.until((state) => state.canUndo);
  const began = Date.now();
  const kept = () => page.evaluate(() => new Promise((resolve) => {
    const request = indexedDB.open('artisketch', 1);
    request.onsuccess = () => {
      const all = request.result.transaction('kept').objectStore('kept').getAllKeys();
      all.onsuccess = () => resolve(all.result.some((key) => String(key).startsWith('autosave')));
    };
  }));
  await editor.once(kept);
  t.diagnostic(`kept after ${Date.now() - began} ms`); // three seconds where nobody else works
  const crash = await context.newCDPSession(page);
  crash.send('Page.crash').catch(() => {});
  await page.waitForEvent('crash');

  const again = await open(context, site.url);
  await again.until((state) => /not saved|Recovered/.test(state.message));
  await again.click('Keep');
  await again.until((state) => state.mode !== 'welcome' && state.frames > 0);
  const document = JSON.parse((await again.save()).bytes);
  const near = ([px, py]) => Math.hypot(px - x, py - y) < 30;
  assert.ok(document.frames[0].contours.some(({points}) => points.every(near)), 'the new outline is there');
});

test('what is drawn piece by piece looks as what is drawn whole', async (t) => {
  const editor = await open(await browser(t), site.url);
  await openHero(editor);
  const {page} = editor;
  for (const key of ['2', '3', '.', 'g', '1', ',', '?', 'Escape']) {
    await page.keyboard.press(key);
    await editor.frame();
  }
  for (let i = 0; i < 40; i++) await page.mouse.move(250 + 8 * i, 200 + 5 * i);
  await page.mouse.move(30, 700); // over nothing that lights up
  await editor.rest();
  const pieces = await page.screenshot();
  await page.setViewportSize({width: 1270, height: 720}); // a canvas of another size is empty
  await editor.rest(0.5);
  await page.setViewportSize({width: 1280, height: 720});
  await page.mouse.move(31, 700);
  await editor.rest(1);
  const whole = await page.screenshot();
  assert.ok(pieces.equals(whole), 'the same pixels');
});

test('at rest nothing is drawn', async (t) => {
  const editor = await open(await browser(t), site.url);
  await openHero(editor);
  await editor.rest();
});

test('every control stands in the accessibility tree, and can be pressed there', async (t) => {
  const editor = await open(await browser(t), site.url);
  await openHero(editor);
  const {page} = editor;
  for (const {label} of await editor.widgets()) {
    await page.getByRole('button', {name: label, exact: true, includeHidden: false}).first().waitFor({state: 'attached'});
  }
  await page.keyboard.press('F6');
  assert.equal(await page.evaluate(() => document.activeElement.parentElement.id), 'controls');
  await page.getByRole('button', {name: 'Pose mode', exact: true}).focus();
  await page.keyboard.press('Enter');
  await editor.until((state) => state.mode === 'pose');
  await page.keyboard.press('Escape');
  assert.equal(await page.evaluate(() => document.activeElement.id), 'canvas');
});

test('by the keyboard alone an example is opened, changed, reconstructed and exported', async (t) => {
  const editor = await open(await browser(t), site.url);
  const {page} = editor, {keyboard} = page;
  await editor.until(hasHero);
  const press = (label) => editor.press(label);
  await press('Menu');
  await press('Menu Light or dark');
  await press('Example Hero');
  await editor.until((state) => state.mode === 'outline');
  await press('Menu');
  await editor.widget('Menu Save');
  await keyboard.press('Escape'); // to the canvas
  await keyboard.press('Escape');
  await editor.once(async () => !(await editor.widgets()).some(({label}) => label === 'Menu Save'));
  await press('Hand R in 1');
  await keyboard.press('Escape');
  await keyboard.press('Delete');
  await editor.until((state) => state.undo === 'Delete Hand R');
  await keyboard.press('Control+z');
  await keyboard.press('r');
  await editor.until((state) => state.busy);
  await editor.until(isDone);
  await keyboard.press('Control+e');
  const {label} = await editor.widget(/^Export .*\.glb$/);
  const {bytes} = await editor.download(() => press(label));
  assert.equal(bytes.toString('latin1', 0, 4), 'glTF');
  assert.deepEqual(editor.faults, []);
});

for (const [name, size] of Object.entries({
  'outline-dark': {width: 1440, height: 900}, 'outline-light': {width: 1440, height: 900, dark: false},
  'outline-small': {width: 1280, height: 720}, 'outline-tablet': {width: 820, height: 1180},
})) {
  test(`picture ${name}`, async (t) => {
    const editor = await open(await browser(t, size), site.url);
    await editor.until(hasHero);
    await editor.frame();
    await editor.page.screenshot({path: join(shots, `${name.replace('outline', 'welcome')}.png`)});
    await editor.click('Gallery');
    await editor.widget(/^Example Prince$/);
    await editor.frame();
    await editor.page.screenshot({path: join(shots, `${name.replace('outline', 'gallery')}.png`)});
    await openHero(editor);
    await editor.rest(0.5);
    await editor.page.screenshot({path: join(shots, `${name}.png`)});
    // Nothing stands outside the window.
    for (const {label, x, y, width, height} of await editor.widgets()) {
      assert.ok(x >= -1 && y >= -1 && x + width <= size.width + 1 && y + height <= size.height + 1, label);
    }
    assert.deepEqual(editor.faults, []);
  });
}

test('the page is small', (t) => {
  const packed = (name) => brotliCompressSync(readFileSync(join(built, 'site', name))).length;
  const loaded = readdirSync(join(built, 'site')).filter((name) => name.includes('.'));
  const pictures = readdirSync(join(built, 'site/examples')).filter((name) => name.endsWith('.png'));
  const examples = ['hero.artisketch', 'hero.glb', ...pictures].map((name) => `examples/${name}`);
  const all = [...loaded, ...examples].map(packed).reduce((a, b) => a + b);
  const file = statSync(join(built, 'artisketch.html')).size;
  t.diagnostic(`${all} bytes compressed, ${file} in the single file`);
  assert.ok(all <= 1.6e6, `${all} bytes compressed`);
  assert.ok(file <= 4e6, `${file} bytes in the single file`);
});
