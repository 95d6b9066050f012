// What tests ask of a model: its surface, and how far two surfaces are apart.

const kinds = {5126: Float32Array, 5125: Uint32Array, 5123: Uint16Array, 5121: Uint8Array};
const widths = {SCALAR: 1, VEC2: 2, VEC3: 3, VEC4: 4, MAT4: 16};

// A GLB's JSON, and its accessors as arrays.
export function read(bytes) {
  const length = bytes.readUInt32LE(12);
  const json = JSON.parse(bytes.toString('utf8', 20, 20 + length));
  const base = 20 + length + 8;
  const array = (index) => {
    const accessor = json.accessors[index];
    const view = json.bufferViews[accessor.bufferView];
    const kind = kinds[accessor.componentType];
    const from = base + (view.byteOffset ?? 0) + (accessor.byteOffset ?? 0);
    const size = accessor.count * widths[accessor.type] * kind.BYTES_PER_ELEMENT;
    return new kind(new Uint8Array(bytes.subarray(from, from + size)).buffer);
  };
  return {json, array};
}

// Positions and triangles of a GLB with one mesh.
export function surface(bytes) {
  const {json, array} = read(bytes);
  const primitive = json.meshes[0].primitives[0];
  return {positions: array(primitive.attributes.POSITION), triangles: array(primitive.indices)};
}

function box({positions}) {
  const low = [Infinity, Infinity, Infinity], high = [-Infinity, -Infinity, -Infinity];
  positions.forEach((x, i) => {
    low[i % 3] = Math.min(low[i % 3], x);
    high[i % 3] = Math.max(high[i % 3], x);
  });
  return {low, high, size: Math.hypot(...high.map((h, a) => h - low[a]))};
}

const sub = (a, b) => [a[0] - b[0], a[1] - b[1], a[2] - b[2]];
const dot = (a, b) => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];

// Ericson, "Real-Time Collision Detection", 5.1.5.
function toTriangle(p, a, b, c) {
  const ab = sub(b, a), ac = sub(c, a), ap = sub(p, a);
  const d1 = dot(ab, ap), d2 = dot(ac, ap);
  const at = (v, w) => Math.hypot(...[0, 1, 2].map((i) => p[i] - a[i] - v * ab[i] - w * ac[i]));
  if (d1 <= 0 && d2 <= 0) return at(0, 0);
  const bp = sub(p, b), d3 = dot(ab, bp), d4 = dot(ac, bp);
  if (d3 >= 0 && d4 <= d3) return at(1, 0);
  const vc = d1 * d4 - d3 * d2;
  if (vc <= 0 && d1 >= 0 && d3 <= 0) return at(d1 / (d1 - d3), 0);
  const cp = sub(p, c), d5 = dot(ab, cp), d6 = dot(ac, cp);
  if (d6 >= 0 && d5 <= d6) return at(0, 1);
  const vb = d5 * d2 - d1 * d6;
  if (vb <= 0 && d2 >= 0 && d6 <= 0) return at(0, d2 / (d2 - d6));
  const va = d3 * d6 - d5 * d4;
  if (va <= 0 && d4 - d3 >= 0 && d5 - d6 >= 0) {
    const w = (d4 - d3) / ((d4 - d3) + (d5 - d6));
    return at(1 - w, w);
  }
  const all = va + vb + vc;
  return at(vb / all, vc / all);
}

// Largest distance from a vertex of `from` to the surface `to`, looked for up to `reach`.
function farthest(from, to, reach) {
  const cells = new Map();
  const point = (mesh, i) => [...mesh.positions.subarray(3 * i, 3 * i + 3)];
  const key = (i, j, k) => `${i},${j},${k}`;
  const index = (x) => Math.floor(x / reach);
  const corners = (t) => [0, 1, 2].map((i) => point(to, to.triangles[3 * t + i]));
  for (let t = 0; 3 * t < to.triangles.length; ++t) {
    const c = corners(t);
    const [low, high] = [Math.min, Math.max].map((pick) => [0, 1, 2].map((a) => index(pick(c[0][a], c[1][a], c[2][a]))));
    for (let i = low[0]; i <= high[0]; ++i) {
      for (let j = low[1]; j <= high[1]; ++j) {
        for (let k = low[2]; k <= high[2]; ++k) {
          const at = key(i, j, k);
          if (!cells.has(at)) cells.set(at, []);
          cells.get(at).push(t);
        }
      }
    }
  }
  let most = 0;
  for (let v = 0; 3 * v < from.positions.length; ++v) {
    const p = point(from, v);
    const [i, j, k] = p.map(index);
    let least = reach;
    for (let di = -1; di <= 1; ++di) {
      for (let dj = -1; dj <= 1; ++dj) {
        for (let dk = -1; dk <= 1; ++dk) {
          for (const t of cells.get(key(i + di, j + dj, k + dk)) ?? []) least = Math.min(least, toTriangle(p, ...corners(t)));
        }
      }
    }
    most = Math.max(most, least);
  }
  return most;
}

// How far two models' surfaces are apart at most, as a share of the first one's diagonal; 0.01 where
// more.
export function difference(a, b) {
  const {size} = box(a);
  return Math.max(farthest(a, b, size / 100), farthest(b, a, size / 100)) / size;
}
