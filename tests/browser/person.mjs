// A person at the page: sees the drawing and what the screen shows, has a pointer and a keyboard, and
// nothing else. Pointer actions (a click, a drag, a drop) are counted.
import { execFileSync } from 'node:child_process';
import { mkdtempSync, readFileSync, rmSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';

import { root } from './chromium.mjs';
import { multiply, projected, turned } from './silhouette.mjs';

// ------------------------------------------------------------ what a person sees in a drawing

// Joints of a document's frame in the drawing's pixels: name → [x, y, depth]. At rest, the body stands as in
// the frame, and all its joints are straight.
export function jointsOf(document, frame, rest = false) {
  const at = document.frames[frame], {rotations = {}, root_position} = at.pose;
  const placed = new Map(), found = new Map();
  for (const {name, parent, offset} of document.skeleton.joints) {
    const own = rest && parent ? [0, 0, 0, 1] : rotations[name] ?? [0, 0, 0, 1];
    const above = placed.get(parent);
    placed.set(name, above ? {
      turn: multiply(above.turn, own),
      at: turned(above.turn, offset).map((c, i) => c + above.at[i]),
    } : {turn: own, at: root_position});
    const place = placed.get(name).at;
    found.set(name, [...projected(document, at, place), place[2]]);
  }
  return found;
}

// One of the generator's figures: its drawings, and where on them a person who looks closely sees parts
// and joints: the example's poses are rough, so they are calibrated.
export function figure(name) {
  const folder = join(root, 'assets', 'examples', name);
  const made = mkdtempSync(join(tmpdir(), 'artisketch-seen-'));
  const seen = join(made, `${name}.artisketch`);
  execFileSync(join(root, 'build', 'native', 'artisketch'), ['calibrate', join(folder, `${name}.artisketch`), '-o', seen],
    {stdio: 'ignore'});
  const document = JSON.parse(readFileSync(seen, 'utf8'));
  const images = JSON.parse(readFileSync(join(folder, `${name}.artisketch`), 'utf8')).frames.map(({image}) => image);
  rmSync(made, {recursive: true});
  return {document, drawings: images.map((image) => ({name: image, bytes: readFileSync(join(folder, image))}))};
}

// ------------------------------------------------------------ hands

export class Person {
  constructor(editor) {
    this.editor = editor;
    this.actions = 0;
  }

  async click(label) {
    this.actions++;
    await this.editor.click(label);
  }

  async clickAt(frame, pixel) {
    this.actions++;
    const {x, y} = await this.editor.page.evaluate(
      ({frame, pixel}) => artisketch.project(frame, ...pixel), {frame, pixel});
    await this.editor.page.mouse.click(x, y);
  }

  async drag(frame, pixels) {
    this.actions++;
    await this.editor.drag(frame, pixels);
    await this.editor.frame();
  }

  key(key) {
    return this.editor.page.keyboard.press(key);
  }

  async drop(files) {
    this.actions++;
    await this.editor.page.evaluate((dropped) => {
      const transfer = new DataTransfer();
      for (const {name, data} of dropped) {
        transfer.items.add(new File([Uint8Array.from(atob(data), (c) => c.charCodeAt(0))], name));
      }
      document.getElementById('canvas').dispatchEvent(
        new DragEvent('drop', {dataTransfer: transfer, bubbles: true, cancelable: true}));
    }, files.map(({name, bytes}) => ({name, data: bytes.toString('base64')})));
  }

  // What the screen shows of the document. Reading it moves nothing.
  async document() {
    return JSON.parse((await this.editor.save()).bytes);
  }

  // To another drawing, by keys.
  async turnTo(frame) {
    for (let now = (await this.editor.state()).frame; now < frame; now++) await this.key('.');
    for (let now = (await this.editor.state()).frame; now > frame; now--) await this.key(',');
    await this.editor.until((state) => state.frame === frame);
    await this.editor.frame();
  }

  // The outline that waits, kept for that part: Tab goes through the likely ones.
  async keepFor(part) {
    const words = partWords(part);
    await this.editor.widget(/^Assign /);
    for (let tries = 0; tries < 8; tries++) {
      const cards = (await this.editor.widgets()).filter(({label}) => label.startsWith('Assign '));
      const chosen = cards.find(({active}) => active)?.label;
      if (chosen === `Assign ${words}`) return this.key('Enter');
      if (!cards.some(({label}) => label === `Assign ${words}`)) break;
      await this.key('Tab');
      await this.editor.frame();
    }
    await this.giveTo(part);
    return this.key('Enter');
  }

  // None of the likely ones: a click on the part in the list says whose it is.
  async giveTo(part) {
    await this.click('Other joint');
    await this.click(partWords(part));
  }

  async draw(frame, part, outline) {
    await this.key('d');
    const step = Math.max(1, Math.floor(outline.length / 60));
    const path = outline.filter((_, i) => i % step === 0);
    await this.drag(frame, [...path, path[0]]);
    await this.keepFor(part);
  }

  // What has one colour, by a click on it.
  async trace(frame, part, pixel) {
    await this.key('t');
    await this.clickAt(frame, pixel);
    await this.keepFor(part);
  }

  // The outline kept last, along a line; the part that it takes away is given to `part`.
  async cut(frame, part, [from, to]) {
    await this.key('k');
    const undo = (await this.editor.state()).undo;
    await this.drag(frame, [from, [(from[0] + to[0]) / 2, (from[1] + to[1]) / 2], to]);
    await this.editor.until((state) => state.undo !== undo && state.undo.startsWith('Cut '));
    const {contours} = (await this.document()).frames[frame];
    if (contours.at(-1).joint !== part) await this.giveTo(part);
  }
}

// As the editor calls a part: "upper_arm.L" → "Upper arm L".
export function partWords(name) {
  const words = name.replace(/[._]([LR])$/, ' $1').replace(/[._]/g, ' ');
  return words[0].toUpperCase() + words.slice(1);
}
