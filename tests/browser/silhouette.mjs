// What a drawing and a posed model cover, as masks: one byte per pixel, rows from the top.
import { read } from './glb.mjs';

// ------------------------------------------------------------ turning

export const multiply = (a, b) => [
  a[3] * b[0] + a[0] * b[3] + a[1] * b[2] - a[2] * b[1],
  a[3] * b[1] - a[0] * b[2] + a[1] * b[3] + a[2] * b[0],
  a[3] * b[2] + a[0] * b[1] - a[1] * b[0] + a[2] * b[3],
  a[3] * b[3] - a[0] * b[0] - a[1] * b[1] - a[2] * b[2]];

const cross = (a, b) => [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]];

export function turned([x, y, z, w], v) {
  const t = cross([x, y, z], v).map((c) => 2 * c), u = cross([x, y, z], t);
  return v.map((c, i) => c + w * t[i] + u[i]);
}

// ------------------------------------------------------------ masks

// Whether each pixel's centre is inside, by the even-odd rule; `rings` in pixels.
function fill(mask, width, height, rings) {
  const rows = Array.from({length: height}, () => []);
  for (const ring of rings) {
    ring.forEach(([x, y], i) => {
      const [u, v] = ring[(i + 1) % ring.length];
      const [low, high] = y < v ? [y, v] : [v, y];
      for (let r = Math.max(0, Math.ceil(low - 0.5)); r + 0.5 < high && r < height; r++) {
        rows[r].push(x + (r + 0.5 - y) * (u - x) / (v - y));
      }
    });
  }
  rows.forEach((crossings, r) => {
    crossings.sort((a, b) => a - b);
    for (let i = 0; i + 1 < crossings.length; i += 2) {
      const from = Math.max(0, Math.ceil(crossings[i] - 0.5));
      const to = Math.min(width, Math.ceil(crossings[i + 1] - 0.5));
      if (to > from) mask.fill(1, r * width + from, r * width + to);
    }
  });
}

// The drawn figure: all of its outlines, a part's inner ones being holes.
export function drawnMask({size: [width, height], contours}) {
  const mask = new Uint8Array(width * height);
  for (const joint of new Set(contours.map((contour) => contour.joint))) {
    fill(mask, width, height, contours.filter((contour) => contour.joint === joint).map(({points}) => points));
  }
  return mask;
}

// Where the camera of a document's frame shows a point of the world.
export function projected({camera}, {size, scale = 1, principal_point}, [x, y, z]) {
  const middle = principal_point ?? [size[0] / 2, size[1] / 2];
  const s = camera.type === 'perspective' ? camera.focal_length / (camera.distance - z)
    : camera.pixels_per_unit * scale;
  return [middle[0] + s * x, middle[1] - s * y];
}

// A model's vertices as a key of its clip poses them: linear blend skinning, as any viewer does it.
function posed(glb, clip, key) {
  const {json, array} = read(glb);
  const {nodes, skins: [skin], animations, meshes} = json;
  const animation = animations.find(({name}) => name === clip);
  const keyed = (node, path, width, usual) => {
    const channel = animation.channels.find(({target}) => target.node === node && target.path === path);
    return channel ? [...array(animation.samplers[channel.sampler].output).subarray(width * key, width * (key + 1))]
      : nodes[node][path] ?? usual;
  };
  const parents = new Map(nodes.flatMap(({children = []}, node) => children.map((child) => [child, node])));
  const placed = new Map();
  const place = (node) => {
    if (!placed.has(node)) {
      const turn = keyed(node, 'rotation', 4, [0, 0, 0, 1]), at = keyed(node, 'translation', 3, [0, 0, 0]);
      const above = parents.has(node) ? place(parents.get(node)) : null;
      placed.set(node, !above ? {turn, at} : {
        turn: multiply(above.turn, turn), at: turned(above.turn, at).map((c, i) => c + above.at[i])});
    }
    return placed.get(node);
  };
  const inverse = array(skin.inverseBindMatrices); // translations, by columns
  const moves = skin.joints.map((node, j) => ({...place(node), from: [...inverse.subarray(16 * j + 12, 16 * j + 15)]}));
  const {attributes, indices} = meshes[0].primitives[0];
  const rest = array(attributes.POSITION), joints = array(attributes.JOINTS_0), weights = array(attributes.WEIGHTS_0);
  const vertices = [];
  for (let v = 0; 3 * v < rest.length; v++) {
    const sum = [0, 0, 0];
    for (let k = 4 * v; k < 4 * v + 4; k++) {
      if (weights[k] === 0) continue;
      const {turn, at, from} = moves[joints[k]];
      turned(turn, from.map((c, i) => c + rest[3 * v + i])).forEach((c, i) => { sum[i] += weights[k] * (c + at[i]); });
    }
    vertices.push(sum);
  }
  return {vertices, triangles: array(indices)};
}

// What the model covers in a document's frame, posed by that key of its clip `frames`.
export function modelMask(glb, document, frame) {
  const at = document.frames[frame], [width, height] = at.size;
  const {vertices, triangles} = posed(glb, 'frames', frame);
  const seen = vertices.map((vertex) => projected(document, at, vertex));
  const mask = new Uint8Array(width * height);
  for (let t = 0; t < triangles.length; t += 3) {
    const corners = [...triangles.subarray(t, t + 3)].map((i) => seen[i]);
    fillTriangle(mask, width, height, corners);
  }
  return mask;
}

function fillTriangle(mask, width, height, corners) {
  const ys = corners.map(([, y]) => y);
  const low = Math.max(0, Math.ceil(Math.min(...ys) - 0.5)), high = Math.min(height, Math.ceil(Math.max(...ys) - 0.5));
  for (let r = low; r < high; r++) {
    let from = Infinity, to = -Infinity;
    corners.forEach(([x, y], i) => {
      const [u, v] = corners[(i + 1) % 3];
      if ((y <= r + 0.5) === (v <= r + 0.5)) return;
      const at = x + (r + 0.5 - y) * (u - x) / (v - y);
      from = Math.min(from, at);
      to = Math.max(to, at);
    });
    const first = Math.max(0, Math.ceil(from - 0.5)), last = Math.min(width, Math.ceil(to - 0.5));
    if (last > first) mask.fill(1, r * width + first, r * width + last);
  }
}

export function intersectionOverUnion(a, b) {
  let both = 0, either = 0;
  a.forEach((in_a, i) => {
    both += in_a & b[i];
    either += in_a | b[i];
  });
  return either ? both / either : 1;
}
