// Unit shapes, of which everything that moves is a scaled copy, and shapes of their own.
import {
  BoxGeometry, BufferGeometry, ConeGeometry, Curve, ExtrudeGeometry, Float32BufferAttribute, LatheGeometry, Shape, SphereGeometry, TubeGeometry,
  Vector2, Vector3,
} from 'three';

class Coil extends Curve {                // wire of a spring, with straight ends
  constructor(turns, height) { super(); Object.assign(this, { turns, height }); }
  getPoint(s, out = new Vector3()) {
    const end = .08, u = Math.min(1, Math.max(0, (s - end) / (1 - 2 * end))), a = 2 * Math.PI * this.turns * u;
    const r = Math.max(0, Math.min(1, s / end - .3, (1 - s) / end - .3));
    return out.set(r * Math.cos(a), r * Math.sin(a), s * this.height);
  }
}
const turned = (points, around) => new LatheGeometry(points.map(p => new Vector2(...p)), around).rotateX(Math.PI / 2);

// Names: box, sphere, cylinder, cone (from 0 to 1), ring:INNER, helix:HEIGHT (in radii, so that the wire stays round);
// with * at the end in light and dark quarters, so that one sees it turn.
export function unitShape(name, fine, large = false) {
  if (name.endsWith('*')) return quartered(unitShape(name.slice(0, -1), fine, true));
  const [kind, number] = name.split(':'), around = fine > 1 ? 48 : fine && (large || kind === 'ring') ? 32 : 16;
  if (kind === 'box') return new BoxGeometry(1, 1, 1);
  if (kind === 'sphere') return new SphereGeometry(1, around, 2 * Math.round(around * .3));
  if (kind === 'cylinder') return turned(fine ? [[0, -.5], [.98, -.5], [1, -.48], [1, .48], [.98, .5], [0, .5]] : [[0, -.5], [1, -.5], [1, .5], [0, .5]], around);
  if (kind === 'cone') return new ConeGeometry(1, 1, around).rotateX(Math.PI / 2).translate(0, 0, .5);
  if (kind === 'ring') { const r = +number; return turned([[r, -.5], [1, -.5], [1, .5], [r, .5], [r, -.5]], around); }
  const height = +number, turns = Math.max(4, Math.min(11, Math.round(height))) + .5;
  return new TubeGeometry(new Coil(turns, height), Math.round(turns * (fine ? 24 : 10)), .16, fine ? 8 : 3, false).scale(1, 1, 1 / height);
}

function quartered(shape) {
  const g = shape.toNonIndexed(), p = g.attributes.position, shades = [];
  for (let k = 0; k < p.count; k += 3) {
    const product = ['getX', 'getY', ...(shape.type === 'SphereGeometry' ? ['getZ'] : [])].reduce((s, get) => s * (p[get](k) + p[get](k + 1) + p[get](k + 2)), 1);
    shades.push(...Array(9).fill(product > 0 ? 1 : .68));
  }
  g.setAttribute('color', new Float32BufferAttribute(shades, 3)); return g;
}

export function ownShape(solid) {         // of what no unit shape can be scaled to
  if (solid.shape === 'prism') {
    const outline = new Shape(solid.corners.map(p => new Vector2(...p)));
    return new ExtrudeGeometry(outline, { depth: solid.thickness, bevelEnabled: false, steps: 1 }).translate(0, 0, -solid.thickness / 2);
  }
  if (solid.shape === 'mesh') return faceted(solid.vertices, solid.triangles);
  if (solid.shape === 'heights') return heights(solid);
  return superquadric(solid);
}
function faceted(vertices, triangles) {
  const g = new BufferGeometry();
  g.setAttribute('position', new Float32BufferAttribute(vertices.flat(), 3)); g.setIndex(triangles.flat());
  const flat = g.toNonIndexed(); flat.computeVertexNormals(); return flat;
}
function smooth(columns, rows, place) {
  const points = [], triangles = [];
  for (let j = 0; j <= rows; j++) for (let i = 0; i <= columns; i++) points.push(...place(i / columns, j / rows));
  for (let j = 0; j < rows; j++) for (let i = 0; i < columns; i++) { const a = j * (columns + 1) + i, b = a + columns + 1; triangles.push(a, a + 1, b, b, a + 1, b + 1); }
  const g = new BufferGeometry(); g.setAttribute('position', new Float32BufferAttribute(points, 3)); g.setIndex(triangles); g.computeVertexNormals(); return g;
}
function superquadric(solid) {
  const [a, b, c] = solid.half_axes, e = solid.exponent ?? 2, n = e, power = (x, k) => Math.sign(x) * Math.abs(x) ** (2 / k);
  return smooth(32, 20, (u, v) => {
    const w = 2 * Math.PI * u, z = Math.PI * (v - .5), ring = power(Math.cos(z), n);
    return [a * ring * power(Math.cos(w), e), b * ring * power(Math.sin(w), e), c * power(Math.sin(z), n)];
  });
}
function heights({ x, y, z }) {           // null where there is no surface
  const vertices = x.flatMap((u, i) => y.map((v, j) => [u, v, z[i][j]])), triangles = [], n = y.length;
  for (let i = 0; i + 1 < x.length; i++) for (let j = 0; j + 1 < n; j++) for (const t of [[i * n + j, (i + 1) * n + j, i * n + j + 1], [(i + 1) * n + j, (i + 1) * n + j + 1, i * n + j + 1]]) if (t.every(k => vertices[k][2] !== null)) triangles.push(t);
  return faceted(vertices.map(v => [v[0], v[1], v[2] ?? 0]), triangles);
}
