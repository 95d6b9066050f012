// From the blank page to a model, as a person does it: drawings dropped, a template's skeleton, parts
// outlined, poses, calibration, the finished file. Pointer actions are counted.
import assert from 'node:assert/strict';
import { execFileSync } from 'node:child_process';
import { mkdirSync, mkdtempSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import test, { after, before } from 'node:test';

import { serve } from '../../web/serve.mjs';
import { browser, open, root } from './chromium.mjs';
import { Person, figure, jointsOf } from './person.mjs';

const built = process.env.ARTISKETCH_WEB ?? join(root, 'build', 'web');
const shots = join(built, 'shots');

let site;
before(async () => {
  site = await serve(join(built, 'site'));
  mkdirSync(shots, {recursive: true});
});
after(() => site.close());

const isLeft = (name) => name.endsWith('.L');
const isRight = (name) => name.endsWith('.R');

// Bones as long as the drawn figure's: joints of the middle and of the left side; the right follows.
async function fitSkeleton(person, truth, names) {
  const seen = jointsOf(truth, 0, true);
  for (const [name, own] of names) {
    if (isRight(name)) continue;
    const now = jointsOf(await person.document(), 0, true).get(name);
    const wanted = seen.get(own);
    if (Math.hypot(now[0] - wanted[0], now[1] - wanted[1]) < 4) continue;
    await person.drag(0, [now, [(now[0] + wanted[0]) / 2, (now[1] + wanted[1]) / 2], wanted]);
  }
}

// Drags joints until they lie where they are seen, ends of limbs first.
async function poseAs(person, truth, frame, names, order) {
  const seen = jointsOf(truth, frame);
  const own = new Map(names);
  for (const name of order) {
    const now = jointsOf(await person.document(), frame).get(name);
    const wanted = seen.get(own.get(name));
    if (Math.hypot(now[0] - wanted[0], now[1] - wanted[1]) < 6) continue;
    await person.drag(frame, [now, [(now[0] + wanted[0]) / 2, (now[1] + wanted[1]) / 2], wanted, wanted]);
  }
}

async function fromBlankPage(t, name, template, {names, order, turn, most}) {
  const {document: truth, drawings} = figure(name);
  const editor = await open(await browser(t), site.url);
  const person = new Person(editor);
  const began = Date.now();
  const picture = async (step) => {
    t.diagnostic(`${step}: ${person.actions} pointer actions, ${Math.round((Date.now() - began) / 1000)} s`);
    await editor.page.screenshot({path: join(shots, `person-${name}-${step}.png`)});
  };
  await editor.until((state) => state.mode === 'welcome');
  await person.drop(drawings);
  await editor.until((state) => state.mode !== 'welcome' && state.frames === drawings.length);
  await person.key('2');
  await person.click(`Template ${template}`);
  await editor.until((state) => state.joints.length > 3);
  await picture('template');
  await person.turnTo(0);
  await fitSkeleton(person, truth, names);
  await picture('skeleton');

  await person.key('3');
  for (let frame = 0; frame < drawings.length; frame++) {
    await person.turnTo(frame);
    await turn(person, frame);
    await poseAs(person, truth, frame, names, order);
    await picture(`pose-${frame + 1}`);
  }

  await person.key('1');
  const called = new Map(names.map(([theirs, own]) => [own, theirs]));
  for (let frame = 0; frame < drawings.length; frame++) {
    await person.turnTo(frame);
    await person.key('d');
    for (const {joint, points} of truth.frames[frame].contours) {
      await person.draw(frame, called.get(joint), points);
    }
    await picture(`outlines-${frame + 1}`);
  }

  await person.key('Shift+C');
  await editor.widget('Keep calibrated', 60);
  await picture('calibrated');
  await person.click('Keep calibrated');
  await person.click('Reconstruct');
  await editor.until((state) => state.busy);
  await editor.until((state) => !state.busy && state.hasModel, 90);
  await person.key('4');
  await editor.page.waitForTimeout(500);
  await picture('result');
  await person.click('Export');
  const button = await editor.widget(/^Export .*\.glb$/);
  const model = await editor.download(() => person.click(button.label));
  assert.equal(model.bytes.toString('latin1', 0, 4), 'glTF');

  const folder = mkdtempSync(join(tmpdir(), 'artisketch-person-'));
  t.after(() => rmSync(folder, {recursive: true}));
  const made = await person.document();
  writeFileSync(join(folder, 'made.artisketch'), JSON.stringify(made));
  execFileSync(join(root, 'build', 'native', 'artisketch'), [
    'reconstruct', join(folder, 'made.artisketch'), '-o', join(folder, 'made.glb'), '--grid', '64', '--quiet',
    '--report', join(folder, 'report.json')]);
  const fits = JSON.parse(readFileSync(join(folder, 'report.json'))).frames.map(({iou}) => iou);
  const mean = fits.reduce((a, b) => a + b) / fits.length;
  t.diagnostic(`${person.actions} pointer actions; silhouettes ${fits.map((f) => f.toFixed(3))}, mean ${mean.toFixed(3)}`);
  assert.deepEqual(editor.faults, []);
  assert.ok(mean >= 0.97, `the silhouettes fit by ${mean}`);
  assert.ok(person.actions <= most, `${person.actions} pointer actions`);
}

// A drag over the ball beside the body, sideways; points.
async function overBall(person, by) {
  person.actions++;
  const {page} = person.editor;
  const {x, y, width, height} = await person.editor.widget('Turn the body');
  const middle = [x + width / 2, y + height / 2];
  await page.mouse.move(...middle);
  await page.mouse.down();
  for (let i = 1; i <= 12; i++) {
    await page.mouse.move(middle[0] + by * i / 12, middle[1]);
    await page.waitForTimeout(30);
  }
  await page.mouse.up();
}

test('a person, a three-frame figure: from the blank page to the model', async (t) => {
  const limbs = ['upper_arm', 'forearm', 'hand', 'thigh', 'shin', 'foot'].flatMap((part) =>
    ['L', 'R'].map((side) => [`${part}.${side}`, `${part}.${side}`]));
  const ends = ['hand', 'foot'].flatMap((part) => ['L', 'R'].map((side) => [`${part}_tip.${side}`, `${part}.tip.${side}`]));
  const names = [['hips', 'hips'], ['chest', 'chest'], ['head', 'head'], ['head_tip', 'head.tip'], ...limbs, ...ends];
  const order = ['hips', 'head', 'head_tip', 'hand.L', 'hand.R', 'foot.L', 'foot.R', 'hand_tip.L', 'hand_tip.R',
    'foot_tip.L', 'foot_tip.R'];
  await fromBlankPage(t, 'hero', 'Human', {
    names, order, most: 120,
    turn: async (person, frame) => {
      if (frame > 0) await overBall(person, [0, 36, -16][frame]);
    },
  });
});
