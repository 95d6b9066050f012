// What drawings made by hand need, by pointer: figures of other sizes, drawings from one side alone, poses to be
// suggested, things held.
import assert from 'node:assert/strict';
import { mkdirSync, readFileSync } from 'node:fs';
import { join } from 'node:path';
import test, { after, before } from 'node:test';

import { serve } from '../../web/serve.mjs';
import { browser, open, root } from './chromium.mjs';

const built = process.env.ARTISKETCH_WEB ?? join(root, 'build', 'web');
const shots = join(built, 'shots');
let site;
before(async () => {
  mkdirSync(shots, {recursive: true});
  site = await serve(join(built, 'site'));
});
after(() => site.close());

// An example's document without its pictures, changed by `change`.
function example(name, change) {
  const document = JSON.parse(readFileSync(join(root, 'assets', 'examples', name, `${name}.artisketch`)));
  for (const frame of document.frames) delete frame.image;
  change(document);
  return JSON.stringify(document);
}

async function dropped(t, text) {
  const editor = await open(await browser(t, {width: 1440, height: 900}), site.url);
  await editor.until((state) => state.mode === 'welcome');
  await editor.page.evaluate((text) => {
    const transfer = new DataTransfer();
    transfer.items.add(new File([text], 'drawn.artisketch'));
    document.getElementById('canvas').dispatchEvent(
      new DragEvent('drop', {dataTransfer: transfer, bubbles: true, cancelable: true}));
  }, text);
  await editor.until((state) => state.mode !== 'welcome' && state.frames > 0);
  return editor;
}

async function saved(editor) {
  return JSON.parse((await editor.save()).bytes);
}

// Reconstructs and opens the list of notes on the model.
async function notes(editor) {
  await editor.click('Result mode');
  await editor.page.keyboard.press('r');
  await editor.click('Read');
  await editor.widget('Close notes');
}

test('a figure drawn smaller is offered its size, and undone', async (t) => {
  const editor = await dropped(t, example('fox', ({frames: [, frame]}) => {
    const middle = frame.size.map((length) => length / 2);
    for (const contour of frame.contours)
      contour.points = contour.points.map((p) => p.map((x, k) => middle[k] + 0.7 * (x - middle[k])));
    frame.pose.root_position = frame.pose.root_position.map((x, k) => k < 2 ? 0.7 * x : x);
  }));
  await notes(editor);
  await editor.page.screenshot({path: join(shots, 'sizes.png')});
  await editor.click(/^Set size in /);
  const scale = (await saved(editor)).frames[1].scale;
  assert.ok(scale > 0.6 && scale < 0.8, `${scale}`);
  await editor.page.keyboard.press('Control+z');
  assert.equal((await saved(editor)).frames[1].scale ?? 1, 1);
});

test('drawings from one side alone are warned of', async (t) => {
  const editor = await dropped(t, example('hero', (document) => {
    document.frames = [document.frames[0], structuredClone(document.frames[0])];
    document.frames[1].name = 'again';
  }));
  await notes(editor);
  await editor.page.screenshot({path: join(shots, 'one-side.png')});
  const labels = (await editor.widgets()).map(({label}) => label);
  assert.ok(labels.some((label) => /nearly the same side/.test(label)), labels.join('\n'));
});

test('what would hold from sides not drawn is said of each part', async (t) => {
  const trust = /^From sides not drawn: (good|doubtful|a guess)/;
  const said = async (frames) => {
    const editor = await dropped(t, example('hero', (document) => { document.frames = frames(document.frames); }));
    await editor.click('Result mode');
    await editor.page.keyboard.press('r');
    await editor.until((state) => state.hasModel && !state.busy);
    await editor.click('Head in 1');
    const {label} = await editor.widget(trust);
    await editor.page.screenshot({path: join(shots, `trust-${label.match(trust)[1].split(' ').at(-1)}.png`)});
    return label.match(trust)[1];
  };
  assert.equal(await said((frames) => frames), 'good');
  assert.equal(await said(([front]) => [front]), 'a guess');
});

test('a suggested pose has rivals', async (t) => {
  const editor = await dropped(t, example('hero', ({frames: [, frame]}) => {
    frame.posed = false;
    frame.pose.rotations = {};
  }));
  await editor.click('Pose mode');
  await editor.page.keyboard.press('.');
  await editor.until((state) => state.frame === 1);
  await editor.click('Suggest tool');
  await editor.widget('Keep');
  const best = (await saved(editor)).frames[1].pose;
  await editor.page.screenshot({path: join(shots, 'rivals.png')});
  await editor.click('Rival 2');
  assert.notDeepEqual((await saved(editor)).frames[1].pose, best);
  await editor.click('Rival 1');
  assert.deepEqual((await saved(editor)).frames[1].pose, best);
  await editor.click('Keep');
});

test('what a hand holds becomes a part of its own', async (t) => {
  const editor = await dropped(t, example('hero', () => {}));
  await editor.click('Outline mode');
  const before = await saved(editor);
  const hand = before.frames[0].contours.find(({joint}) => joint === 'hand.R').points;
  const [x, y] = hand.reduce((low, p) => p[1] > low[1] ? p : low);
  const at = await editor.page.evaluate(([x, y]) => artisketch.project(0, x, y), [x, y]);
  await editor.page.mouse.click(at.x, at.y, {button: 'right'});
  await editor.click('New held thing');
  await editor.until((state) => state.undo === 'Thing held by Hand R');
  const {skeleton, parts} = await saved(editor);
  const joint = skeleton.joints.find(({name}) => name === 'thing');
  assert.equal(joint?.parent, 'hand.R', JSON.stringify(skeleton.joints.map(({name}) => name)));
  assert.ok(JSON.stringify(parts).includes('"held"'), JSON.stringify(parts));
  await editor.page.screenshot({path: join(shots, 'held.png')});
});
