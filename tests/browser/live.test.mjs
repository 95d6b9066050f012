// How soon the page answers while one works: the live parts behind a dragged point and a dragged limb,
// and the frames that are drawn while the worker computes. Times are told, not judged: machines differ.
import assert from 'node:assert/strict';
import { execFileSync } from 'node:child_process';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import test, { after, before } from 'node:test';

import { serve } from '../../web/serve.mjs';
import { browser, open, root } from './chromium.mjs';

let site;
before(async () => {
  site = await serve(join(process.env.ARTISKETCH_WEB ?? join(root, 'build', 'web'), 'site'));
});
after(() => site.close());

// Watches, in the page, how long the drawn parts lag behind the pointer: from the event that changed the
// document to the animation frame after the one in which parts made of that change were drawn.
function watchLag() {
  const lags = window.lags = [];
  const asked = []; // [revision, time]
  let moved = performance.now(), last = artisketch.state();
  for (const kind of ['mousedown', 'mousemove', 'mouseup']) {
    addEventListener(kind, (event) => { moved = event.timeStamp; }, {capture: true});
  }
  const look = (now) => {
    const state = artisketch.state();
    if (state.revision !== last.revision) asked.push([state.revision, moved]);
    if (state.liveRevision !== last.liveRevision) {
      const since = asked.find(([revision]) => revision === state.liveRevision);
      if (since) requestAnimationFrame((shown) => lags.push(shown - since[1]));
    }
    last = state;
    requestAnimationFrame(look);
  };
  requestAnimationFrame(look);
}

async function dragged(t, mode, words, find) {
  const editor = await open(await browser(t), site.url);
  const {page} = editor;
  await editor.until((state) => state.mode === 'welcome' && state.hasModel);
  await editor.click('Outline mode');
  await editor.until((state) => state.mode === 'outline' && state.frames > 0);
  await page.keyboard.press(mode);
  await editor.rest(0.5);
  const [x, y] = await find(editor);
  await page.mouse.move(x, y);
  await page.mouse.down();
  // The first change has all parts made, later ones those that they touch.
  await page.mouse.move(x + 8, y);
  await editor.until((state) => state.liveParts > 0 && state.liveRevision === state.revision);
  await page.evaluate(watchLag);
  const began = Date.now();
  for (let i = 0; Date.now() - began < 4000; i++) {
    await page.mouse.move(x + 8 + 10 * Math.sin(i / 8), y + 10 * (1 - Math.cos(i / 8)));
    await page.waitForTimeout(16);
  }
  await page.mouse.up();
  const state = await editor.until((now) => now.liveRevision === now.revision);
  const lags = (await page.evaluate(() => window.lags)).sort((a, b) => a - b);
  assert.ok(lags.length > 0, 'the parts follow');
  const share = (s) => Math.round(lags[Math.min(lags.length - 1, Math.floor(s * lags.length))]);
  t.diagnostic(`${words} (${state.undo}): live parts redrawn ${lags.length} times in 4 s, ` +
    `after ${share(0.5)} ms (median), ${share(0.9)} ms (nine in ten)`);
  assert.deepEqual(editor.faults, []);
}

test('live parts follow a dragged point of an outline', (t) =>
  dragged(t, '1', 'an outline', async (editor) => {
    const document = JSON.parse((await editor.save()).bytes);
    const {frame} = await editor.state();
    const {points} = document.frames[frame].contours.find(({joint}) => joint === 'hand.R');
    const low = points.reduce((a, b) => (b[1] > a[1] ? b : a));
    const {x, y} = await editor.page.evaluate((of) => artisketch.project(...of), [frame, ...low]);
    await editor.page.mouse.click(x, y); // chooses the outline
    await editor.frame();
    await editor.page.waitForTimeout(400); // not a double click
    return [x, y];
  }));

test('live parts follow a dragged limb', (t) =>
  dragged(t, '3', 'a pose', async (editor) => {
    const {x, y, width, height} = await editor.widget('Joint Hand R');
    return [x + width / 2, y + height / 2];
  }));

test('frames go on being drawn while the worker computes', async (t) => {
  const editor = await open(await browser(t), site.url);
  await editor.until((state) => state.mode === 'welcome' && state.hasModel);
  await editor.click('Outline mode');
  await editor.until((state) => state.frames > 0);
  await editor.click('Reconstruct'); // as soon as it is there
  await editor.until((state) => state.busy);
  const began = Date.now(), first = await editor.frames();
  for (let i = 0; (await editor.state()).busy; i++) { // a person goes on looking about
    await editor.page.mouse.move(400 + 80 * Math.cos(i / 9), 330 + 80 * Math.sin(i / 9));
  }
  const seconds = (Date.now() - began) / 1000, frames = await editor.frames() - first;
  t.diagnostic(`reconstructed in ${seconds.toFixed(1)} s, ${(frames / seconds).toFixed(0)} frames a second meanwhile`);
  assert.ok((await editor.state()).hasModel);
  assert.ok(frames > 0);
});

// From the click to the model, as the page has it, where nothing else happens meanwhile.
async function secondsToModel(editor) {
  await editor.page.evaluate(() => {
    window.model = {};
    const watch = setInterval(() => {
      const {busy} = artisketch.state();
      if (busy) window.model.began ??= performance.now();
      if (busy || !window.model.began) return;
      clearInterval(watch);
      window.model.seconds = (performance.now() - window.model.began) / 1000;
    }, 5);
  });
  await editor.click('Reconstruct');
  return (await editor.page.waitForFunction(() => window.model.seconds)).jsonValue();
}

test('the first model is made at the speed of later ones', async (t) => {
  const editor = await open(await browser(t), site.url);
  await editor.until((state) => state.mode === 'welcome' && state.hasModel);
  await editor.click('Outline mode');
  await editor.until((state) => state.frames > 0);
  await editor.page.waitForTimeout(5000); // the rehearsal
  const seconds = [];
  for (let i = 0; i < 4; i++) seconds.push(await secondsToModel(editor));
  const began = Date.now();
  execFileSync(join(root, 'build', 'native', 'artisketch'), [
    'reconstruct', join(root, 'assets/examples/hero/hero.artisketch'), '-o', join(tmpdir(), 'hero-live.glb'),
    '--grid', '64', '--quiet'], {env: {...process.env, OMP_NUM_THREADS: '1'}});
  const native = (Date.now() - began) / 1000;
  const ratio = (it) => `${it.toFixed(2)} s (${(it / native).toFixed(2)})`;
  t.diagnostic(`models at grid 64 after ${seconds.map(ratio).join(', ')}; natively ${native.toFixed(2)} s (1)`);
  assert.deepEqual(editor.faults, []);
});
