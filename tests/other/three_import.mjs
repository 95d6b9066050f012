// What three.js makes of models, in Chromium: skeleton, clip `frames`, texture, and a picture of the
// last. Of the same model packed (--compress) it makes the same: all end in one picture, nearly.
//   node three_import.mjs PACKAGES PICTURE.png MODEL.glb…
// PACKAGES: where npm installed tests/package.json. Exit status 77 where Chromium or they are missing.
import assert from 'node:assert/strict';
import { existsSync, readFileSync } from 'node:fs';
import { createRequire } from 'node:module';
import { join } from 'node:path';

const [packages, picture, ...models] = process.argv.slice(2);
const chromiumPath = process.env.ARTISKETCH_CHROMIUM ?? '/usr/bin/chromium';
const three = join(packages, 'node_modules', 'three');
if (!existsSync(chromiumPath) || !existsSync(three)) {
  console.log('skipped: Chromium or three.js was not found');
  process.exit(77);
}
const { chromium } = createRequire(join(packages, 'package.json'))('playwright-core');

const described = (bytes) => {
  const gltf = JSON.parse(bytes.subarray(20, 20 + bytes.readUInt32LE(12)));
  return {joints: gltf.skins[0].joints.map((joint) => gltf.nodes[joint].name), clip: gltf.animations[0].name};
};

const shell = `<!DOCTYPE html><style>body { margin: 0 }</style>
<script type="importmap">{"imports": {"three": "/three/build/three.module.js"}}</script>
<script type="module">
import * as THREE from 'three';
import { GLTFLoader } from '/three/examples/jsm/loaders/GLTFLoader.js';
import { MeshoptDecoder } from '/three/examples/jsm/libs/meshopt_decoder.module.js';
const size = 640;
const renderer = new THREE.WebGLRenderer({antialias: true, preserveDrawingBuffer: true});
renderer.setSize(size, size);
document.body.append(renderer.domElement);
const scene = new THREE.Scene();
scene.background = new THREE.Color(0xffffff);
scene.add(new THREE.HemisphereLight(0xffffff, 0x888888, 3));
new GLTFLoader().setMeshoptDecoder(MeshoptDecoder).load('/model.glb', (gltf) => {
  scene.add(gltf.scene);
  let skinned;
  gltf.scene.traverse((node) => { if (node.isSkinnedMesh) skinned = node; });
  const mixer = new THREE.AnimationMixer(gltf.scene);
  const clip = gltf.animations[0];
  mixer.clipAction(clip).play();
  const pose = (time, share = 8) => {
    mixer.setTime(time);
    scene.updateMatrixWorld(true);
    skinned.skeleton.update();
    const places = [], count = skinned.geometry.attributes.position.count;
    for (let i = 0; i < count; i += share) {
      const v = skinned.getVertexPosition(i, new THREE.Vector3());
      places.push([v.x, v.y, v.z]);
    }
    return places;
  };
  const box = new THREE.Box3().setFromPoints(pose(0, 1).map((p) => new THREE.Vector3(...p)));
  const middle = box.getCenter(new THREE.Vector3()), reach = box.getSize(new THREE.Vector3()).length() / 2;
  const camera = new THREE.OrthographicCamera(-reach, reach, reach, -reach, 0.1, 10 * reach);
  camera.position.set(middle.x + 1.5 * reach, middle.y + reach, middle.z + 4 * reach);
  camera.lookAt(middle);
  window.at = (time) => {
    const places = pose(time);
    renderer.render(scene, camera);
    return places;
  };
  const image = skinned.material.map?.image;
  window.found = {
    joints: skinned.skeleton.bones.map((bone) => bone.userData.name ?? bone.name), clip: clip.name,
    seconds: clip.duration, reach, texture: image ? [image.width, image.height] : null,
  };
}, undefined, (error) => { window.failed = String(error); });
</script>`;

const browser = await chromium.launch({
  executablePath: chromiumPath, headless: true,
  args: ['--use-gl=angle', '--use-angle=swiftshader', '--enable-unsafe-swiftshader'],
});
// The picture's pixels at the first key, and how far the surface moves to the second.
async function shown(bytes) {
  const expected = described(bytes);
  const page = await browser.newPage({viewport: {width: 640, height: 640}});
  const complaints = [];
  page.on('console', (message) => {
    if (['error', 'warning'].includes(message.type())) complaints.push(message.text());
  });
  await page.route('**/*', (route) => {
    const {pathname} = new URL(route.request().url());
    if (pathname === '/') return route.fulfill({body: shell, contentType: 'text/html'});
    if (pathname === '/model.glb') return route.fulfill({body: bytes});
    if (pathname.startsWith('/three/')) {
      const path = join(three, pathname.slice('/three/'.length));
      return route.fulfill({body: readFileSync(path), contentType: 'text/javascript'});
    }
    return route.fulfill({status: 204});
  });
  await page.goto('http://model.test/');
  await page.waitForFunction(() => window.found || window.failed, null, {timeout: 60000});
  assert.equal(await page.evaluate(() => window.failed), undefined);
  const found = await page.evaluate(() => window.found);
  // three.js takes dots out of names that animations speak of, and keeps what they were.
  assert.deepEqual(found.joints, expected.joints);
  assert.equal(found.clip, expected.clip);
  assert.ok(found.seconds >= 1, 'a key per second and drawing');
  assert.ok(found.texture && found.texture[0] > 64, 'a texture');

  const first = await page.evaluate(() => window.at(0));
  const later = await page.evaluate(() => window.at(1));
  assert.ok(first.flat().every(Number.isFinite), 'every vertex is somewhere');
  const moved = first.reduce((most, p, i) => Math.max(most, Math.hypot(...p.map((x, c) => x - later[i][c]))), 0);
  assert.ok(moved > 0.1 * found.reach, `frames moves the surface by ${moved}`);

  await page.evaluate(() => window.at(0));
  const png = await page.screenshot({path: picture});
  const colours = await page.evaluate(async (data) => {
    const image = new Image();
    image.src = `data:image/png;base64,${data}`;
    await image.decode();
    const canvas = new OffscreenCanvas(image.width, image.height).getContext('2d');
    canvas.drawImage(image, 0, 0);
    const {data: pixels} = canvas.getImageData(0, 0, image.width, image.height);
    const hues = new Set();
    for (let i = 0; i < pixels.length; i += 4) {
      const [r, g, b] = pixels.subarray(i, i + 3);
      const most = Math.max(r, g, b), least = Math.min(r, g, b);
      if (most - least < 60) continue;  // grey
      const hue = most === r ? (g - b) / (most - least) : most === g ? 2 + (b - r) / (most - least)
        : 4 + (r - g) / (most - least);
      hues.add(Math.round((hue + 6) % 6));
    }
    return {hues: hues.size, pixels: [...pixels].filter((_, i) => i % 28 < 4)};
  }, png.toString('base64'));
  assert.ok(colours.hues >= 3, `the texture is seen: ${colours.hues} hues`);
  assert.deepEqual(complaints, []);
  await page.close();
  return {pixels: colours.pixels, moved};
}

try {
  let before;
  for (const model of models) {
    const now = await shown(readFileSync(model));
    if (before) {
      const off = now.pixels.filter((value, i) => Math.abs(value - before.pixels[i]) > 16).length;
      assert.ok(off < 0.005 * now.pixels.length, `${model} differs in ${off} of ${now.pixels.length} values`);
      assert.ok(Math.abs(now.moved - before.moved) < 0.05 * before.moved, `${model} moves otherwise`);
    }
    before = now;
  }
} finally {
  await browser.close();
}
