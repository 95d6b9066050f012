// What @pixiv/three-vrm makes of an avatar, in Chromium: humanoid, meta, T-pose, first person, and
// a spring that swings.
//   node vrm_import.mjs PACKAGES AVATAR.vrm…
// PACKAGES: where npm installed tests/package.json. Exit status 77 where Chromium or they are missing.
import assert from 'node:assert/strict';
import { existsSync, readFileSync } from 'node:fs';
import { createRequire } from 'node:module';
import { join } from 'node:path';

const [packages, ...avatars] = process.argv.slice(2);
const chromiumPath = process.env.ARTISKETCH_CHROMIUM ?? '/usr/bin/chromium';
const three = join(packages, 'node_modules', 'three');
const vrm = join(packages, 'node_modules', '@pixiv', 'three-vrm', 'lib', 'three-vrm.module.js');
if (!existsSync(chromiumPath) || !existsSync(three) || !existsSync(vrm)) {
  console.log('skipped: Chromium, three.js or three-vrm was not found');
  process.exit(77);
}
const { chromium } = createRequire(join(packages, 'package.json'))('playwright-core');

const shell = `<!DOCTYPE html>
<script type="importmap">{"imports": {"three": "/three/build/three.module.js",
  "three/addons/": "/three/examples/jsm/", "three-vrm": "/three-vrm.js"}}</script>
<script type="module">
import * as THREE from 'three';
import { GLTFLoader } from 'three/addons/loaders/GLTFLoader.js';
import { MeshoptDecoder } from 'three/addons/libs/meshopt_decoder.module.js';
import { VRMLoaderPlugin } from 'three-vrm';
const loader = new GLTFLoader().setMeshoptDecoder(MeshoptDecoder);
loader.register((parser) => new VRMLoaderPlugin(parser));
loader.load('/avatar.vrm', (gltf) => {
  const vrm = gltf.userData.vrm;
  if (!vrm) { window.failed = 'no VRM was found in the file'; return; }
  const place = (name) => vrm.humanoid.getRawBoneNode(name).getWorldPosition(new THREE.Vector3()).toArray();
  const bones = Object.keys(vrm.humanoid.humanBones);
  vrm.scene.updateMatrixWorld(true);
  const at = Object.fromEntries(bones.map((bone) => [bone, place(bone)]));
  vrm.firstPerson.setup();
  const annotations = vrm.firstPerson.meshAnnotations.map((one) => [one.type, one.meshes.length]);
  const joints = [...(vrm.springBoneManager?.joints ?? [])];
  // The avatar walks off, and what hangs on it lags behind.
  const before = joints.map((joint) => joint.bone.quaternion.toArray());
  for (let k = 0; k < 30; ++k) {
    vrm.scene.position.x += 0.02;
    vrm.update(1 / 60);
  }
  const swung = joints.map((joint, i) =>
    joint.bone.quaternion.angleTo(new THREE.Quaternion().fromArray(before[i])));
  window.result = {meta: vrm.meta, bones, at, annotations, springs: joints.map((joint) => joint.bone.name), swung};
}, undefined, (error) => { window.failed = String(error); });
</script>`;

const served = (path, avatar) =>
  path === '/' ? ['text/html', shell]
  : path === '/avatar.vrm' ? ['model/gltf-binary', readFileSync(avatar)]
  : path === '/three-vrm.js' ? ['text/javascript', readFileSync(vrm)]
  : path.startsWith('/three/') ? ['text/javascript', readFileSync(join(three, path.slice('/three/'.length)))]
  : null;

const browser = await chromium.launch({
  executablePath: chromiumPath,
  args: ['--headless=new', '--no-sandbox', '--use-gl=angle', '--use-angle=swiftshader', '--enable-unsafe-swiftshader',
         '--disable-background-networking', '--disable-component-update', '--disable-sync', '--no-first-run'],
});
async function look_at(avatar) {
  const page = await browser.newPage();
  const complaints = [];
  page.on('pageerror', (error) => complaints.push(String(error)));
  page.on('console', (message) => ['error', 'warning'].includes(message.type()) && complaints.push(message.text()));
  await page.route('http://model.test/**', (route) => {
    const answer = served(new URL(route.request().url()).pathname, avatar);
    return answer ? route.fulfill({contentType: answer[0], body: answer[1]})
                  : route.fulfill({status: 404, body: ''});
  });
  await page.goto('http://model.test/');
  await page.waitForFunction('window.result || window.failed', null, {timeout: 60000});
  assert.equal(await page.evaluate('window.failed'), undefined);
  const {meta, bones, at, annotations, springs, swung} = await page.evaluate('window.result');

  const needed = ['hips', 'spine', 'head'];
  for (const side of ['left', 'right'])
    for (const bone of ['UpperArm', 'LowerArm', 'Hand', 'UpperLeg', 'LowerLeg', 'Foot']) needed.push(side + bone);
  for (const bone of needed) assert.ok(bones.includes(bone), `${bone} is no bone of the humanoid`);
  assert.equal(meta.metaVersion, '1');
  assert.ok(meta.authors.length > 0 && meta.authors[0].length > 0, 'nobody made it');
  assert.match(meta.licenseUrl, /^https:/);

  // The T-pose: arms level to their sides (the left at +x, the avatar faces +z), legs straight down.
  const level = (from, to, sign) => {
    const way = at[to].map((x, i) => x - at[from][i]), length = Math.hypot(...way);
    assert.ok(sign * way[0] > 0.999 * length, `${from} to ${to} is not level: ${way}`);
  };
  level('leftUpperArm', 'leftLowerArm', 1), level('leftLowerArm', 'leftHand', 1);
  level('rightUpperArm', 'rightLowerArm', -1), level('rightLowerArm', 'rightHand', -1);
  for (const side of ['left', 'right'])
    for (const c of [0, 2])
      assert.ok(Math.abs(at[`${side}Foot`][c] - at[`${side}UpperLeg`][c]) < 1e-3, `the ${side} leg is not upright`);

  assert.deepEqual(annotations, [['auto', 1]]);
  assert.ok(springs.length > 0, 'nothing swings');
  assert.ok(Math.max(...swung) > 0.02, `no spring bone turned: ${swung}`);
  assert.deepEqual(complaints, []);
  console.log(`${avatar}: ${bones.length} bones, springs ${springs.join(', ')}, ` +
              `turned by up to ${(Math.max(...swung) * 180 / Math.PI).toFixed(0)} degrees`);
  await page.close();
}

try {
  for (const avatar of avatars) await look_at(avatar);
} finally {
  await browser.close();
}
