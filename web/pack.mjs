// A document with its drawings inside: what is a path in `image` becomes a data: URI, all else stays
// as it is, byte for byte.
//   node pack.mjs IN.artisketch OUT.artisketch
import { readFileSync, writeFileSync } from 'node:fs';
import { dirname, join } from 'node:path';

const [from, to] = process.argv.slice(2);
const text = readFileSync(from, 'utf8').replace(/("image":\s*)"((?!data:)[^"\\]+)"/g, (_, field, path) => {
  const type = /\.jpe?g$/i.test(path) ? 'jpeg' : 'png';
  const bytes = readFileSync(join(dirname(from), path)).toString('base64');
  return `${field}"data:image/${type};base64,${bytes}"`;
});
writeFileSync(to, text);
