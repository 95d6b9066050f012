// The page in Firefox and WebKit: it opens with the hero, makes a model of it, and exports that.
//   node --test tests/browser/engines.test.mjs       (./dev test engines)
import assert from 'node:assert/strict';
import { execFileSync } from 'node:child_process';
import { mkdtempSync, readFileSync, rmSync } from 'node:fs';
import { createRequire } from 'node:module';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import test, { after, before } from 'node:test';

import { serve } from '../../web/serve.mjs';
import { patience, root } from './chromium.mjs';
import { firefox, webkit } from './engines.mjs';
import { difference, surface } from './glb.mjs';

const validator = createRequire(join(root, 'build', 'node', 'package.json'))('gltf-validator');

let site;
before(async () => {
  site = await serve(join(process.env.ARTISKETCH_WEB ?? join(root, 'build', 'web'), 'site'));
});
after(() => site.close());

// The command line's model of the hero, as the page makes it.
function modelOfHero() {
  const folder = mkdtempSync(join(tmpdir(), 'artisketch-models-'));
  const out = join(folder, 'hero.glb');
  execFileSync(join(root, 'build', 'native', 'artisketch'), [
    'reconstruct', join(root, 'assets/examples/hero/hero.artisketch'), '-o', out, '--grid', '64', '--quiet']);
  const bytes = readFileSync(out);
  rmSync(folder, {recursive: true});
  return bytes;
}

async function until(words, find) {
  for (const end = Date.now() + patience; ;) {
    const found = await find();
    if (found) return found;
    if (Date.now() > end) throw new Error(`waited in vain for ${words}`);
    await new Promise((done) => setTimeout(done, 50));
  }
}

async function pageWorks(t, start) {
  const engine = await start(t);
  t.after(() => engine.close());
  const state = () => engine.evaluate('artisketch.state()');
  const click = async (label) => {
    const widget = await until(`the control ${label}`, async () =>
      (await engine.evaluate('artisketch.widgets()')).find((one) =>
        one.enabled && (label.test ? label.test(one.label) : one.label === label)));
    await engine.click(widget.x + widget.width / 2, widget.y + widget.height / 2);
  };
  const reach = (words, wanted) => until(words, async () => wanted(await state()));

  await engine.open(site.url);
  await engine.evaluate('artisketch.ready.then(() => true)');
  await reach('the hero', ({mode, hasModel}) => mode === 'welcome' && hasModel);
  await click('Outline mode');
  await reach('the drawings', ({mode, frames}) => mode === 'outline' && frames === 3);
  await click('Reconstruct');
  await reach('the job', ({busy}) => busy);
  await reach('the model', ({busy, hasModel}) => !busy && hasModel);

  // A browser keeps what was downloaded where it likes: here it is what the page hands to it.
  await engine.evaluate(`(() => {
    const make = URL.createObjectURL;
    URL.createObjectURL = (blob) => { window.handed = blob; return make.call(URL, blob); };
  })()`);
  await click('Export');
  await click(/^Export .*\.glb$/);
  await reach('the file', async () => await engine.evaluate('!!window.handed'));
  const bytes = Buffer.from(await engine.evaluate(`window.handed.arrayBuffer().then((buffer) =>
    btoa(Array.from(new Uint8Array(buffer), (byte) => String.fromCharCode(byte)).join('')))`), 'base64');
  const {issues} = await validator.validateBytes(new Uint8Array(bytes));
  assert.equal(issues.numErrors + issues.numWarnings, 0, JSON.stringify(issues.messages));
  const apart = difference(surface(bytes), surface(modelOfHero()));
  t.diagnostic(`${await engine.evaluate('navigator.userAgent')}: the surface is ${apart} of its size from the command line's`);
  assert.ok(apart <= 1e-4, `apart by ${apart}`);
}

test('the page works in Firefox', (t) => pageWorks(t, firefox));
test('the page works in WebKit', (t) => pageWorks(t, webkit));
