// Firefox and WebKit, as Debian has them, on a screen of their own. Both are driven in the same few ways:
//   open(url)           goes there
//   evaluate(script)    the value of an expression in the page, awaited
//   click(x, y)         presses there, CSS pixels
//   close()
import { spawn } from 'node:child_process';
import { existsSync, mkdtempSync, readdirSync, rmSync } from 'node:fs';
import { createRequire } from 'node:module';
import { createServer } from 'node:net';
import { tmpdir } from 'node:os';
import { join } from 'node:path';

import { root } from './chromium.mjs';

// Software draws, as on machines without a graphics card. Headless, Firefox has no WebGL 2: hence a screen.
async function screen(t) {
  const home = mkdtempSync(join(tmpdir(), 'artisketch-engine-'));
  const server = spawn('Xvfb', ['-displayfd', '3', '-screen', '0', '1280x800x24'], {stdio: ['ignore', 'ignore', 'ignore', 'pipe']});
  const display = await new Promise((found, failed) => {
    server.once('error', failed);
    server.stdio[3].once('data', (bytes) => found(`:${bytes.toString().trim()}`));
  });
  t.after(() => {
    server.kill();
    rmSync(home, {recursive: true, force: true, maxRetries: 5});
  });
  return {
    ...process.env, DISPLAY: display, HOME: home, XDG_RUNTIME_DIR: home, XDG_CACHE_HOME: home, XDG_CONFIG_HOME: home,
    LIBGL_ALWAYS_SOFTWARE: '1', MOZ_DISABLE_CONTENT_SANDBOX: '1',
    WEBKIT_DISABLE_SANDBOX_THIS_IS_DANGEROUS: '1', // root's processes can't be shut in
  };
}

export async function firefox(t) {
  const puppeteer = createRequire(join(root, 'build', 'node', 'package.json'))('puppeteer-core');
  const browser = await puppeteer.launch({
    browser: 'firefox', executablePath: process.env.ARTISKETCH_FIREFOX ?? '/usr/bin/firefox-esr', headless: false,
    env: await screen(t), protocolTimeout: 0, timeout: 0, defaultViewport: null,
    extraPrefsFirefox: {'webgl.force-enabled': true, 'gfx.x11-egl.force-enabled': true},
  });
  const page = await browser.newPage();
  return {
    open: (url) => page.goto(url, {timeout: 0}),
    evaluate: (script) => page.evaluate(script),
    click: (x, y) => page.mouse.click(x, y),
    close: () => browser.close(),
  };
}

const freePort = () => new Promise((found) => {
  const server = createServer().listen(0, '127.0.0.1', () => {
    const {port} = server.address();
    server.close(() => found(port));
  });
});

// https://www.w3.org/TR/webdriver2/
export async function webkit(t) {
  const libraries = readdirSync('/usr/lib').map((name) => join('/usr/lib', name));
  const binary = process.env.ARTISKETCH_MINIBROWSER ?? libraries.flatMap((folder) =>
    ['webkit2gtk-4.1', 'webkit2gtk-4.0'].map((name) => join(folder, name, 'MiniBrowser'))).find(existsSync);
  const port = await freePort();
  const driver = spawn('WebKitWebDriver', [`--port=${port}`], {stdio: 'ignore', env: await screen(t)});
  let gone;
  driver.once('error', (error) => { gone = error; });
  const ask = async (method, path, body) => {
    const answer = await fetch(`http://127.0.0.1:${port}${path}`, {method, ...(body ? {body: JSON.stringify(body)} : {})});
    const {value} = await answer.json();
    if (!answer.ok) throw new Error(`${value.error}: ${value.message}`);
    return value;
  };
  for (;;) {
    if (gone) throw gone;
    if (await ask('GET', '/status').then(({ready}) => ready, () => false)) break;
    await new Promise((done) => setTimeout(done, 50));
  }
  const {sessionId} = await ask('POST', '/session', {capabilities: {alwaysMatch: {
    'webkitgtk:browserOptions': {binary, args: ['--automation']},
    timeouts: {script: null, pageLoad: 3600e3},
  }}});
  const at = `/session/${sessionId}`;
  const pointer = (...actions) => ask('POST', `${at}/actions`, {actions: [{
    type: 'pointer', id: 'mouse', parameters: {pointerType: 'mouse'}, actions}]});
  return {
    open: (url) => ask('POST', `${at}/url`, {url}),
    evaluate: async (script) => {
      const {value, error} = await ask('POST', `${at}/execute/async`, {args: [], script: `
        const done = arguments[arguments.length - 1];
        Promise.resolve().then(() => (${script})).then((value) => done({value}), (error) => done({error: String(error)}));`});
      if (error) throw new Error(error);
      return value;
    },
    click: async (x, y) => {
      await pointer({type: 'pointerMove', x: Math.round(x), y: Math.round(y), duration: 0});
      await pointer({type: 'pointerDown', button: 0}, {type: 'pause', duration: 60}, {type: 'pointerUp', button: 0});
    },
    close: async () => {
      await ask('DELETE', at).catch(() => {});
      driver.kill();
    },
  };
}
