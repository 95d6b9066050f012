// The same document makes the same model, to the byte: natively and in WebAssembly, in whatever place,
// language, time zone and on however many cores.
//   node --test tests/browser/same_bytes.test.mjs       (./dev test browser)
import assert from 'node:assert/strict';
import { execFile } from 'node:child_process';
import { mkdtemp, readdir, readFile, rm } from 'node:fs/promises';
import { tmpdir } from 'node:os';
import { dirname, join } from 'node:path';
import { fileURLToPath } from 'node:url';
import { promisify } from 'node:util';
import test from 'node:test';

const root = join(dirname(fileURLToPath(import.meta.url)), '..', '..');
const examples = join(root, 'assets', 'examples');
const native = process.env.ARTISKETCH ?? join(root, 'build', 'native', 'artisketch');
const web = join(process.env.ARTISKETCH_WEB ?? join(root, 'build', 'web'), 'artisketch.js');
const flags = ['--grid', '48', '--triangles', '5000', '--quiet'];
const run = promisify(execFile);

async function modelBy(t, [command, ...before], name, options = {}) {
  const folder = await mkdtemp(join(tmpdir(), 'artisketch-same-'));
  t.after(() => rm(folder, {recursive: true}));
  const document = join(examples, name, `${name}.artisketch`), glb = join(folder, 'model.glb');
  await run(command, [...before, 'reconstruct', document, '-o', glb, ...flags], options);
  return readFile(glb);
}

for (const name of await readdir(examples)) {
  test(`${name} is the same natively and in WebAssembly`, async (t) => {
    const [one, other] = await Promise.all([
      modelBy(t, [native], name), modelBy(t, [process.execPath, '--no-experimental-fetch', web], name)]);
    assert.ok(one.equals(other), `${one.length} and ${other.length} bytes`);
  });
}

test('a model depends on no place, language, time zone, variable or number of cores', async (t) => {
  const [first] = await readdir(examples);
  const usual = await modelBy(t, [native], first);
  for (const [what, command, options] of [
    ['place', [native], {cwd: '/'}],
    ['language', [native], {env: {LC_ALL: 'de_DE.UTF-8', LANG: 'tr_TR.UTF-8', LC_NUMERIC: 'fr_FR'}}],
    ['time zone', [native], {env: {TZ: 'Pacific/Kiritimati'}}],
    ['no variables', [native], {env: {}}],
    ['threads asked for', [native], {env: {OMP_NUM_THREADS: '7', EIGEN_NUM_THREADS: '7'}}],
    ['one core', ['taskset', '-c', '0', native], {}],
  ])
    assert.ok(usual.equals(await modelBy(t, command, first, options)), what);
});
