// Debian's Chromium with the page in it, driven as a person would: controls by their names, the rest by
// where they stand.
import { mkdtempSync, rmSync } from 'node:fs';
import { createRequire } from 'node:module';
import { tmpdir } from 'node:os';
import { dirname, join } from 'node:path';
import { fileURLToPath } from 'node:url';

export const root = join(dirname(fileURLToPath(import.meta.url)), '..', '..');
const { chromium } = createRequire(join(root, 'build', 'node', 'package.json'))('playwright-core');

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
export async function browser(t, {width = 1280, height = 720, scale = 1, dark = true, pickers = false, touch = false} = {}) {
  const profile = mkdtempSync(join(tmpdir(), 'artisketch-browser-'));
  const context = await chromium.launchPersistentContext(profile, {
    executablePath: process.env.ARTISKETCH_CHROMIUM ?? '/usr/bin/chromium', headless: true, args: flags,
    viewport: {width, height}, deviceScaleFactor: scale, colorScheme: dark ? 'dark' : 'light',
    acceptDownloads: true, hasTouch: touch,
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

  // The state, once `wanted(state)` holds.
  async until(wanted, seconds = 30) {
    const end = Date.now() + 1000 * seconds;
    for (;;) {
      const state = await this.state();
      if (wanted(state)) return state;
      if (Date.now() > end) throw new Error(`not within ${seconds} s: ${wanted}\n${JSON.stringify(state)}`);
      await this.page.waitForTimeout(20);
    }
  }

  // The control of that name (or a name like that), once it is there and can be pressed.
  async widget(label, seconds = 10) {
    const end = Date.now() + 1000 * seconds;
    for (;;) {
      const widgets = await this.widgets();
      const found = widgets.find((one) => one.enabled && (label.test ? label.test(one.label) : one.label === label));
      if (found) return found;
      if (Date.now() > end) {
        throw new Error(`no control '${label}' within ${seconds} s among: ` +
          widgets.map((one) => one.label + (one.enabled ? '' : ' (disabled)')).join(', '));
      }
      await this.page.waitForTimeout(20);
    }
  }

  async click(label) {
    const {x, y, width, height} = await this.widget(label);
    await this.page.mouse.click(x + width / 2, y + height / 2);
  }

  // The file that `action` makes the page download.
  async download(action) {
    const [download] = await Promise.all([this.page.waitForEvent('download'), action()]);
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
      await this.page.waitForTimeout(30); // as a hand would: each frame sees the pointer once
    }
    await mouse.up();
  }

  frames() {
    return this.page.evaluate(() => window.drawnFrames);
  }
}
