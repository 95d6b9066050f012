// A person at the page: sees the drawing and what the screen shows, has a pointer and a keyboard, and
// nothing else. Pointer actions (a click, a drag, a drop) are counted.
import { readFileSync } from 'node:fs';
import { join } from 'node:path';

import { root } from './chromium.mjs';

// ------------------------------------------------------------ what a person sees in a drawing

const multiply = (a, b) => [
  a[3] * b[0] + a[0] * b[3] + a[1] * b[2] - a[2] * b[1],
  a[3] * b[1] - a[0] * b[2] + a[1] * b[3] + a[2] * b[0],
  a[3] * b[2] + a[0] * b[1] - a[1] * b[0] + a[2] * b[3],
  a[3] * b[3] - a[0] * b[0] - a[1] * b[1] - a[2] * b[2]];

function turned([x, y, z, w], v) {
  const cross = (a, b) => [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]];
  const t = cross([x, y, z], v).map((c) => 2 * c), u = cross([x, y, z], t);
  return v.map((c, i) => c + w * t[i] + u[i]);
}

// Joints of a document's frame, or of its rest pose there, in the drawing's pixels: name → [x, y, z].
export function jointsOf(document, frame, rest = false) {
  const {camera, skeleton} = document, {size, pose, scale = 1, principal_point} = document.frames[frame];
  const middle = principal_point ?? [size[0] / 2, size[1] / 2];
  const placed = new Map(), found = new Map();
  for (const {name, parent, offset} of skeleton.joints) {
    const own = rest ? [0, 0, 0, 1] : pose.rotations?.[name] ?? [0, 0, 0, 1];
    const above = placed.get(parent);
    const turn = above ? multiply(above.turn, own) : own;
    const at = above ? turned(above.turn, offset).map((c, i) => c + above.at[i])
      : pose.root_position;
    placed.set(name, {turn, at});
    const s = camera.type === 'perspective' ? camera.focal_length / (camera.distance - at[2])
      : camera.pixels_per_unit * scale;
    found.set(name, [middle[0] + s * at[0], middle[1] - s * at[1], s * at[2]]);
  }
  return found;
}

// One of the generator's figures: its drawings, and where on them a person sees parts and joints.
export function figure(name) {
  const folder = join(root, 'assets', 'examples', name);
  const document = JSON.parse(readFileSync(join(folder, `${name}.artisketch`), 'utf8'));
  return {
    document,
    drawings: document.frames.map(({image}) => ({name: image, bytes: readFileSync(join(folder, image))})),
  };
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
    await this.editor.page.waitForTimeout(60);
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
    await this.editor.page.waitForTimeout(100);
  }

  // The outline that waits, kept for that part: Tab goes through the likely ones.
  async keepFor(part) {
    const words = partWords(part);
    for (let tries = 0; tries < 8; tries++) {
      const cards = (await this.editor.widgets()).filter(({label}) => label.startsWith('Assign '));
      const chosen = cards.find(({active}) => active)?.label;
      if (chosen === `Assign ${words}`) return this.key('Enter');
      if (!cards.some(({label}) => label === `Assign ${words}`)) break;
      await this.key('Tab');
      await this.editor.page.waitForTimeout(60);
    }
    // None of the likely ones: a click on the part in the list says whose it is.
    await this.click('Other joint');
    await this.click(words);
    return this.key('Enter');
  }

  async draw(frame, part, outline) {
    const step = Math.max(1, Math.floor(outline.length / 30));
    const path = outline.filter((_, i) => i % step === 0);
    await this.drag(frame, [...path, path[0]]);
    await this.editor.page.waitForTimeout(60);
    await this.keepFor(part);
  }
}

// As the editor calls a part: "upper_arm.L" → "Upper arm L".
export function partWords(name) {
  const words = name.replace(/[._]([LR])$/, ' $1').replace(/[._]/g, ' ');
  return words[0].toUpperCase() + words.slice(1);
}
