// Without a pointer: real keys, and the controls that a screen reader finds, by their names.
import assert from 'node:assert/strict';
import { join } from 'node:path';
import { createRequire } from 'node:module';
import test, { after, before } from 'node:test';
import { pathToFileURL } from 'node:url';

import { serve } from '../../web/serve.mjs';
import { browser, open, root } from './chromium.mjs';

const built = process.env.ARTISKETCH_WEB ?? join(root, 'build', 'web');
const validator = createRequire(join(root, 'build', 'node', 'package.json'))('gltf-validator');
const drawings = ['front', 'behind'].map((side) => join(root, 'assets', 'gallery', 'alien', `${side}.png`));

let site;
before(async () => { site = await serve(join(built, 'site')); });
after(() => site.close());

test('from the blank page to the file by the keyboard alone', async (t) => {
  const editor = await open(await browser(t, {width: 1440, height: 900}), site.url);
  const {page} = editor, {keyboard} = page;
  const keys = async (key, times) => {
    while (times-- > 0) await keyboard.press(key);
    await editor.frame();
  };
  const undoes = (what) => editor.until((state) => what.test(state.undo));
  // A control of the drawing's, then back to the drawing.
  const choose = async (label, chosen = label) => {
    await editor.press(label);
    await editor.once(async () => (await editor.widgets()).some((one) => one.label === chosen && one.active));
    await keyboard.press('Escape');
  };
  await editor.until((state) => state.mode === 'welcome' && state.hasModel);
  const chooser = page.waitForEvent('filechooser');
  await editor.press('Choose files');
  await (await chooser).setFiles(drawings);
  await editor.until((state) => state.frames === 2 && state.frame === 0);
  await keyboard.press('Escape');

  await keyboard.press('2');
  await editor.press('Template Human');
  await undoes(/Human skeleton/);
  await choose('Joint Head tip');
  await keys('Shift+ArrowUp', 2);
  await undoes(/^Move Head tip$/);

  await keyboard.press('3');
  await keyboard.press('.');
  await editor.until((state) => state.mode === 'pose' && state.frame === 1);
  const across = async (side) => (await editor.widget(`Joint Hand ${side}`)).x;
  await keys('Control+ArrowRight', 36); // seen from behind, once all are taken
  await editor.once(async () => {
    const left = await across('L');
    await page.waitForTimeout(500);
    return left < await across('R') && left === await across('L');
  });
  await undoes(/^Turn body$/);
  await choose('Joint Hand L');
  await keys('Shift+ArrowDown', 2);
  await keys('ArrowLeft', 3);
  await undoes(/^Bend /);

  await keyboard.press('1');
  await keyboard.press('Shift+T');
  await undoes(/^Outline \d+ parts$/);
  await keyboard.press(',');
  await keyboard.press('Shift+T');
  await editor.until((state) => state.frame === 0 && /^Outline \d+ parts$/.test(state.undo));
  await choose('Head in 1', 'Head');
  await keys('ArrowUp', 2);
  await undoes(/^Move Head$/);

  await keyboard.press('r');
  await editor.until((state) => state.busy);
  await editor.until((state) => !state.busy && state.hasModel);
  await keyboard.press('Control+e');
  const {label} = await editor.widget(/^Export .*\.glb$/);
  const {bytes} = await editor.download(() => editor.press(label));
  assert.equal((await validator.validateBytes(new Uint8Array(bytes))).issues.numErrors, 0);
  assert.deepEqual(editor.faults, []);
});

test('? leads to the guide, in a tab of its own', async (t) => {
  const context = await browser(t);
  const editor = await open(context, site.url);
  await editor.until((state) => state.mode === 'welcome' && state.hasModel);
  await editor.page.keyboard.press('Shift+Slash');
  const opened = context.waitForEvent('page');
  await editor.press('Guide');
  const guide = await opened;
  const faults = [];
  guide.on('console', (message) => faults.push(message.text()));
  await guide.waitForLoadState();
  assert.equal(guide.url(), `${site.url}guide/index.html`);
  await guide.getByRole('heading', {name: '3. Outlines (1)'}).waitFor();
  const pictures = await guide.evaluate(() => [...document.images].map(({alt, naturalWidth}) => [alt, naturalWidth]));
  assert.ok(pictures.length >= 10 && pictures.every(([alt, width]) => alt && width > 0), `${pictures}`);
  await guide.screenshot({path: join(built, 'shots', 'guide.png')});
  assert.deepEqual(faults, []);
});

test('the single file says nothing of a guide', async (t) => {
  const editor = await open(await browser(t), pathToFileURL(join(built, 'artisketch.html')).href);
  await editor.until((state) => state.mode === 'welcome' && state.hasModel);
  await editor.page.keyboard.press('Shift+Slash');
  await editor.widget('Close shortcuts');
  assert.ok(!(await editor.widgets()).some(({label}) => label === 'Guide'));
});
