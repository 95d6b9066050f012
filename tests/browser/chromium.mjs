// Debian's Chromium with the page in it, driven as a person would: controls by their names, the rest by
// where they stand.
import { mkdtempSync, rmSync } from 'node:fs';
import { createRequire } from 'node:module';
import { tmpdir } from 'node:os';
import { dirname, join } from 'node:path';
import { fileURLToPath } from 'node:url';

export const root = join(dirname(fileURLToPath(import.meta.url)), '..', '..');
const { chromium } = createRequire(join(root, 'build', 'node', 'package.json'))('playwright-core');

// Milliseconds after which what was waited for counts as never coming. Not a measure: machines differ.
export const patience = 300e3;

const flags = [
  '--use-gl=angle', '--use-angle=swiftshader', '--enable-unsafe-swiftshader', '--disable-background-networking',
  '--disable-component-update', '--disable-sync', '--no-first-run',
];

// Counts the animation frames in which something was drawn.
function countFrames() {
  window.drawnFrames = 0;
  let drew = false;
  const draw = WebGL2RenderingContext.prototype.drawElements;
  WebGL2RenderingContext.prototype.drawElements = function (...args) {
    if (!drew) {
      drew = true;
      window.drawnFrames++;
      queueMicrotask(() => { drew = false; });
    }
    return draw.apply(this, args);
  };
}

// A browser of its own with an empty profile. `t`: the test that it ends with.
export async function browser(t, {
  width = 1280, height = 720, scale = 1, dark = true, pickers = false, touch = false, locale = 'en-US',
} = {}) {
  const profile = mkdtempSync(join(tmpdir(), 'artisketch-browser-'));
  const context = await chromium.launchPersistentContext(profile, {
    executablePath: process.env.ARTISKETCH_CHROMIUM ?? '/usr/bin/chromium', headless: true, args: flags,
    viewport: {width, height}, deviceScaleFactor: scale, colorScheme: dark ? 'dark' : 'light',
    acceptDownloads: true, hasTouch: touch, locale,
  });
  t.after(async () => {
    await context.close();
    rmSync(profile, {recursive: true, force: true, maxRetries: 5});
  });
  await context.addInitScript(countFrames);
  // A picker of the system's can't be driven: without it the page downloads.
  if (!pickers) {
    await context.addInitScript(() => {
      delete window.showSaveFilePicker;
      delete window.showOpenFilePicker;
    });
  }
  return context;
}

// The page at `url`, once the editor is open. What goes wrong in it is collected in `faults`.
export async function open(context, url) {
  const page = await context.newPage();
  const faults = [];
  const requests = [];
  page.on('console', (message) => {
    if (['error', 'warning'].includes(message.type())) faults.push(message.text());
  });
  page.on('pageerror', (error) => faults.push(String(error)));
  page.on('request', (request) => requests.push(request.url()));
  await page.goto(url);
  await page.evaluate(() => artisketch.ready);
  return new Editor(page, faults, requests);
}

export class Editor {
  constructor(page, faults, requests) {
    Object.assign(this, {page, faults, requests});
  }

  state() {
    return this.page.evaluate(() => artisketch.state());
  }

  widgets() {
    return this.page.evaluate(() => artisketch.widgets());
  }

  // What `find()` resolves to, once that is something.
  async once(find) {
    const end = Date.now() + patience;
    for (;;) {
      const found = await find();
      if (found) return found;
      if (Date.now() > end) throw new Error(`waited in vain for ${find}\n${JSON.stringify(await this.state())}`);
      await this.page.waitForTimeout(20);
    }
  }

  // The state, once `wanted(state)` holds.
  until(wanted) {
    return this.once(async () => {
      const state = await this.state();
      return wanted(state) ? state : null;
    }).catch((error) => { throw new Error(`${error.message}\n${wanted}`); });
  }

  // Once a frame has been drawn with all that the pointer and the keys did.
  frame() {
    return this.page.evaluate(() => new Promise((done) => {
      requestAnimationFrame(() => requestAnimationFrame(() => done()));
    }));
  }

  // The control of that name (or a name like that), once it is there and can be pressed.
  async widget(label) {
    const end = Date.now() + patience;
    for (;;) {
      const widgets = await this.widgets();
      const found = widgets.find((one) => one.enabled && (label.test ? label.test(one.label) : one.label === label));
      if (found) return found;
      if (Date.now() > end) {
        throw new Error(`no control '${label}' among: ` +
          widgets.map((one) => one.label + (one.enabled ? '' : ' (disabled)')).join(', '));
      }
      await this.page.waitForTimeout(20);
    }
  }

  async click(label) {
    const {x, y, width, height} = await this.widget(label);
    await this.page.mouse.click(x + width / 2, y + height / 2);
  }

  // By the keyboard alone: F6 leads to the controls, Tab by Tab to the one of that name, as a screen reader
  // has it; Enter presses it.
  async press(label) {
    const {page} = this, {keyboard} = page;
    const button = page.getByRole('button', {name: label, exact: true}).first();
    await button.waitFor({state: 'attached'});
    await this.once(async () => { // it stands where the control does
      const [{x, y}, seen] = [await this.widget(label), await button.boundingBox()];
      return seen && Math.hypot(seen.x - x, seen.y - y) < 1;
    });
    const focused = () => page.evaluate(() => document.activeElement.textContent);
    await keyboard.press('F6');
    for (let tabs = 0; await focused() !== label; tabs++) {
      if (tabs > 300) throw new Error(`Tab never comes to ${label}`);
      await keyboard.press('Tab');
    }
    await keyboard.press('Enter');
  }

  // The file that `action` makes the page download.
  async download(action) {
    const [download] = await Promise.all([this.page.waitForEvent('download', {timeout: patience}), action()]);
    const chunks = [];
    for await (const chunk of await download.createReadStream()) chunks.push(chunk);
    return {name: download.suggestedFilename(), bytes: Buffer.concat(chunks)};
  }

  save() {
    return this.download(() => this.page.keyboard.press('Control+s'));
  }

  // Drags along pixels of the drawing.
  async drag(frame, pixels) {
    const path = await this.page.evaluate(({frame, pixels}) => pixels.map(([x, y]) => artisketch.project(frame, x, y)),
      {frame, pixels});
    const {mouse} = this.page;
    await mouse.move(path[0].x, path[0].y);
    await mouse.down();
    for (const {x, y} of path) {
      await mouse.move(x, y);
      await this.frame(); // as a hand would: each frame sees the pointer once
    }
    await mouse.up();
  }

  frames() {
    return this.page.evaluate(() => window.drawnFrames);
  }

  // Once nothing has been drawn for that many seconds: hover has faded, live parts and toasts have come to
  // rest, the autosave is written.
  async rest(seconds = 3) {
    const end = Date.now() + patience;
    for (let drawn = -1, since = 0; Date.now() - since < 1000 * seconds;) {
      const now = await this.frames();
      if (now !== drawn) [drawn, since] = [now, Date.now()];
      if (Date.now() > end) throw new Error('waited in vain for nothing to be drawn');
      await this.page.waitForTimeout(50);
    }
  }
}
