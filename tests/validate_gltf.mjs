// Reconstructs a document and asks the Khronos validator about the result: no error, no warning.
//   node validate_gltf.mjs MODULES ARTISKETCH DOCUMENT
// MODULES is the folder that npm installed package.json into. Exit status 77 where it is missing.
import { execFileSync } from 'node:child_process';
import { existsSync, mkdtempSync, readFileSync, rmSync } from 'node:fs';
import { createRequire } from 'node:module';
import { tmpdir } from 'node:os';
import { join } from 'node:path';

const [modules, artisketch, document] = process.argv.slice(2);
if (!existsSync(join(modules, 'node_modules', 'gltf-validator'))) {
  console.log(`gltf-validator is not in ${modules}: ./dev test installs it`);
  process.exit(77);
}
const validator = createRequire(join(modules, 'package.json'))('gltf-validator');

const folder = mkdtempSync(join(tmpdir(), 'artisketch-'));
try {
  const model = join(folder, 'model.glb');
  // A coarse grid: the file's structure is in question, not the surface.
  execFileSync(artisketch, ['reconstruct', document, '-o', model, '--grid', '40', '--quiet'],
               { stdio: 'inherit' });
  const { issues } = await validator.validateBytes(new Uint8Array(readFileSync(model)),
                                                   { maxIssues: 100 });
  for (const { code, message, pointer } of issues.messages) {
    console.log(`${code} ${pointer}: ${message}`);
  }
  console.log(`${issues.numErrors} errors, ${issues.numWarnings} warnings`);
  process.exitCode = issues.numErrors + issues.numWarnings > 0 ? 1 : 0;
} finally {
  rmSync(folder, { recursive: true });
}
