// Asks the Khronos validator about models: no error, no warning, and no information but about what
// goes unused, and textures whose sides are no powers of two: charts are packed closely instead, and
// engines since OpenGL ES 3 take them so.
//   node validate_gltf.mjs MODULES MODEL.glb…
// MODULES is the folder that npm installed package.json into. Exit status 77 where the validator is
// not in it, 1 where a model has faults.
import { existsSync, readFileSync } from 'node:fs';
import { createRequire } from 'node:module';
import { join } from 'node:path';

const [modules, ...models] = process.argv.slice(2);
if (!existsSync(join(modules, 'node_modules', 'gltf-validator'))) {
  console.log(`gltf-validator is not in ${modules}: ./dev test installs it`);
  process.exit(77);
}
const validator = createRequire(join(modules, 'package.json'))('gltf-validator');

for (const model of models) {
  const bytes = new Uint8Array(readFileSync(model));
  const { issues } = await validator.validateBytes(bytes, { maxIssues: 100 });
  for (const { code, message, pointer } of issues.messages) {
    console.log(`${code} ${pointer}: ${message}`);
  }
  const { numErrors, numWarnings, numInfos } = issues;
  console.log(`${model}: ${numErrors} errors, ${numWarnings} warnings, ${numInfos} infos`);
  // The validator knows no avatars: tests/other/vrm_import.mjs looks at what makes one; nor what is
  // packed: the same model unpacked is among the samples, and tests/other/three_import.mjs unpacks one.
  const told = issues.messages.filter(({ severity, code, message }) => severity === 2 &&
    !code.startsWith('UNUSED_') && code !== 'IMAGE_NPOT_DIMENSIONS' && !(code === 'UNSUPPORTED_EXTENSION' && /'(VRMC_|EXT_meshopt_)/.test(message)));
  if (numErrors + numWarnings + told.length > 0) process.exitCode = 1;
}
