// Puts the page together from what was compiled, twice: OUT/site/, static files for any web host, and
// OUT/artisketch.html, all of it in one file that works from disk.
//   node assemble.mjs OUT EXAMPLE… -- FIGURE…
// Its languages' words are fetched when they are asked for.
// OUT holds editor.js, editor.wasm, core.js, core.wasm, examples/NAME.artisketch, .glb and .png,
// gallery/NAME.artisketch and .png, and guide/index.html with its pictures. The first example comes with its
// model; the others are made where they are opened. The gallery's figures are fetched one by one; the single
// file comes without them and without the guide.
import { createHash } from 'node:crypto';
import { copyFileSync, cpSync, mkdirSync, readFileSync, readdirSync, rmSync, statSync, writeFileSync } from 'node:fs';
import { dirname, join } from 'node:path';
import { fileURLToPath } from 'node:url';
import { gzipSync } from 'node:zlib';

const here = dirname(fileURLToPath(import.meta.url));
const [out, ...names] = process.argv.slice(2);
const examples = names.slice(0, names.indexOf('--')), gallery = names.slice(names.indexOf('--') + 1);
const site = join(out, 'site');
const source = (name) => readFileSync(join(here, name), 'utf8');
const script = (name) => source(name).replace(/^ *\/\/.*\n/gm, ''); // its comments are for those who read it here
const built = (name) => readFileSync(join(out, name));

// What the page loads, by the name that it asks for.
const files = new Map([
  ['editor.wasm', built('editor.wasm')],
  ['core.wasm', built('core.wasm')],
  ['worker.js', Buffer.concat([built('core.js'), Buffer.from(script('worker.js'))])],
]);
for (const name of examples) {
  for (const kind of name === examples[0] ? ['artisketch', 'glb', 'png'] : ['artisketch', 'png']) {
    files.set(`examples/${name}.${kind}`, built(`examples/${name}.${kind}`));
  }
}
const languages = join(here, '../assets/languages');
for (const name of readdirSync(languages)) files.set(`languages/${name}`, readFileSync(join(languages, name)));
const pageScript = ['storage.js', 'files.js', 'core_worker.js', 'page.js'].map(script).join('\n');
const scripts = [['editor.js', built('editor.js').toString()], ['page.js', pageScript]];
const style = source('page.css');

// Nothing from elsewhere, nothing to elsewhere.
function policy(sources) {
  return Object.entries({
    'default-src': "'none'", 'base-uri': "'none'", 'form-action': "'none'", 'img-src': 'data:', ...sources,
  }).map(([what, from]) => `${what} ${from}`).join('; ');
}

// As the page's meta element has it: [[name, drawings, shelf]…], its shelf as in ExampleCard.
const kFirstScreen = 0, kGallery = 1, kElsewhere = 2;
const card = (folder, shelf) => (name) =>
  [name, JSON.parse(built(`${folder}/${name}.artisketch`)).frames.length, shelf];
const cards = (shelf) => JSON.stringify([...examples.map(card('examples', kFirstScreen)),
  ...gallery.map(card('gallery', shelf))]).replaceAll('"', '&quot;');

function page(parts) {
  return source('shell.html').replace(/@([A-Z]+)@/g, (_, name) => parts[name]);
}

// ---------------------------------------------------------------- the site

rmSync(site, {recursive: true, force: true});
for (const folder of ['examples', 'gallery', 'languages']) mkdirSync(join(site, folder), {recursive: true});
for (const [name, bytes] of files) writeFileSync(join(site, name), bytes);
for (const name of gallery) {
  for (const kind of ['artisketch', 'png']) {
    copyFileSync(join(out, `gallery/${name}.${kind}`), join(site, `gallery/${name}.${kind}`));
  }
}
for (const [name, text] of scripts) writeFileSync(join(site, name), text);
writeFileSync(join(site, 'page.css'), style);
cpSync(join(out, 'guide'), join(site, 'guide'), {recursive: true});
writeFileSync(join(site, 'index.html'), page({
  POLICY: policy({
    'script-src': "'self' 'wasm-unsafe-eval'", 'style-src': "'self'", 'connect-src': "'self'",
    'worker-src': "'self'",
  }),
  EXAMPLES: cards(kGallery),
  STYLE: '<link rel="stylesheet" href="page.css">\n' +
    '<link rel="preload" href="editor.wasm" as="fetch" crossorigin>',
  FILES: '',
  SCRIPTS: scripts.map(([name]) => `<script src="${name}"></script>`).join('\n'),
}));

// ---------------------------------------------------------------- the single file

const hash = (text) => `'sha256-${createHash('sha256').update(text).digest('base64')}'`;
for (const [name, text] of scripts) {
  if (/<\/script|<!--/i.test(text)) throw new Error(`${name} would end its own element`);
}
const single = join(out, 'artisketch.html');
writeFileSync(single, page({
  POLICY: policy({
    'script-src': `${scripts.map(([, text]) => hash(text)).join(' ')} 'wasm-unsafe-eval'`,
    'style-src': hash(style), 'worker-src': 'blob:',
  }),
  EXAMPLES: cards(kElsewhere),
  STYLE: `<style>${style}</style>`,
  FILES: [...files].map(([name, bytes]) =>
    `<script type="text/plain" id="file:${name}">${gzipSync(bytes, {level: 9}).toString('base64')}</script>`)
    .join('\n'),
  SCRIPTS: scripts.map(([, text]) => `<script>${text}</script>`).join('\n'),
}));

const kilobytes = (bytes) => `${Math.round(bytes / 1000)} kB`;
console.log(`${single}: ${kilobytes(statSync(single).size)}`);
