// What moves, and what goes out with it, by pointer: clips of the library, dropped motions, engines' names for
// joints, sprites.
import assert from 'node:assert/strict';
import { execFileSync } from 'node:child_process';
import { mkdtempSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { createRequire } from 'node:module';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import test, { after, before } from 'node:test';

import { serve } from '../../web/serve.mjs';
import { browser, open, root } from './chromium.mjs';

const built = process.env.ARTISKETCH_WEB ?? join(root, 'build', 'web');
const validator = createRequire(join(root, 'build', 'node', 'package.json'))('gltf-validator');

let site;
before(async () => { site = await serve(join(built, 'site')); });
after(() => site.close());

async function drop(page, name, bytes) {
  await page.evaluate(({name, data}) => {
    const transfer = new DataTransfer();
    transfer.items.add(new File([Uint8Array.from(atob(data), (c) => c.charCodeAt(0))], name));
    document.getElementById('canvas').dispatchEvent(
      new DragEvent('drop', {dataTransfer: transfer, bubbles: true, cancelable: true}));
  }, {name, data: Buffer.from(bytes).toString('base64')});
}

// Hips that stay and an arm that is lifted.
const wave = () => {
  const channels = 'CHANNELS 3 Zrotation Xrotation Yrotation\n';
  return 'HIERARCHY\nROOT Hips\n{\nOFFSET 0 0 0\n' +
    'CHANNELS 6 Xposition Yposition Zposition Zrotation Xrotation Yrotation\n' +
    `JOINT LeftArm\n{\nOFFSET 20 50 0\n${channels}JOINT LeftForeArm\n{\nOFFSET 30 0 0\n${channels}` +
    'End Site\n{\nOFFSET 30 0 0\n}\n}\n}\n}\nMOTION\nFrames: 3\nFrame Time: 0.5\n' +
    [0, 45, 80].map((angle) => `0 90 0 0 0 0 ${angle} 0 0 0 0 0\n`).join('');
};

// A line of the menu that a button opens, once it stands where it stays.
async function choose(editor, button, line) {
  await editor.click(button);
  let last = '';
  await editor.once(async () => {
    const place = JSON.stringify(await editor.widget(line));
    await editor.page.waitForTimeout(200);
    return place === last || (last = place, false);
  });
  await editor.click(line);
}

function json(glb) {
  return JSON.parse(glb.subarray(20, 20 + glb.readUInt32LE(12)));
}

test('clips are chosen, dropped, mapped and exported for an engine and as sprites', async (t) => {
  const editor = await open(await browser(t, {height: 1000}), site.url);
  await editor.until((state) => state.mode === 'welcome' && state.hasModel);
  await editor.click('Outline mode');
  await editor.until((state) => state.mode === 'outline' && state.frames > 0);
  await editor.click('Result mode');
  await editor.until((state) => state.mode === 'result');

  // From the library: it is there at once, and moves.
  await choose(editor, 'Library', 'Add walk');
  await editor.widget('Clip walk');
  const view = {x: 400, y: 150, width: 400, height: 350};
  const seen = await editor.page.screenshot({clip: view});
  await editor.once(async () => !seen.equals(await editor.page.screenshot({clip: view})));

  // As it was drawn, and as an engine has it.
  await editor.click('Export');
  const button = await editor.widget(/^Export .*\.glb$/);
  const drawn = await editor.download(() => editor.click(button.label));
  await choose(editor, 'Joints\' names', 'Unreal\'s mannequin');
  const rigged = await editor.download(() => editor.click(button.label));
  const {issues} = await validator.validateBytes(new Uint8Array(rigged.bytes));
  assert.equal(issues.numErrors + issues.numWarnings, 0, JSON.stringify(issues.messages));
  const names = json(rigged.bytes).nodes.map(({name}) => name);
  for (const joint of ['pelvis', 'spine_01', 'neck_01', 'clavicle_l', 'hand_r', 'ball_l']) {
    assert.ok(names.includes(joint), `${joint} among ${names}`);
  }

  // A sheet, drawn beside the page: what the command line makes of the same model.
  await editor.click('Format Sprites');
  for (const choice of ['Sides 8', 'Size 32', 'A second 6']) await editor.click(choice);
  const sheet = await editor.download(() => editor.click('Export hero.zip'));
  const folder = mkdtempSync(join(tmpdir(), 'artisketch-sprites-'));
  t.after(() => rmSync(folder, {recursive: true}));
  const glb = join(folder, 'drawn.glb'), zip = join(folder, 'hero.zip');
  writeFileSync(glb, drawn.bytes);
  execFileSync(join(root, 'build', 'native', 'artisketch'),
    ['sprites', glb, '-o', zip, '--clip', 'walk', '--directions', '8', '--size', '32', '--rate', '6']);
  assert.ok(sheet.bytes.equals(readFileSync(zip)), 'the same bytes');
  await editor.click('Export');

  // A motion, and a joint that it shall not move.
  await drop(editor.page, 'hello.bvh', wave());
  await editor.widget('Clip hello');
  await editor.click('Motion');
  await choose(editor, 'Mover of upper_arm.L', 'Nobody');
  await editor.until((state) => state.undo === 'Map upper_arm.L');
  await editor.click('Motion');
  const kept = JSON.parse((await editor.save()).bytes);
  assert.deepEqual(kept.motion, {still: ['upper_arm.L']});
  assert.deepEqual(kept.animations.map(({name}) => name), ['walk', 'hello']);

  // A model's clips come in as well, from that engine's joints to the document's.
  await drop(editor.page, 'model.glb', rigged.bytes);
  await editor.once(async () =>
    (await editor.widgets()).filter(({label}) => label === 'Clip walk').length > 1 ||
    /walk/.test((await editor.state()).message));
  const {animations} = JSON.parse((await editor.save()).bytes);
  assert.ok(animations.length > 2, animations.map(({name}) => name).join(', '));
  assert.deepEqual(editor.faults, []);
});
