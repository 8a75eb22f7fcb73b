// One mechanism in motion: a drawing and a run become instances of shapes, each with a matrix for a time.
import { Box3, Color, DoubleSide, Group, InstancedMesh, Matrix4, MeshLambertMaterial, MeshStandardMaterial, Quaternion, Vector3 } from 'three';
import { ownShape, unitShape } from './shapes.js';
import { PALETTE } from './text.js';

const STEEL = '#8a929c', DARK = '#39424f', PIN = '#e9ecf0', SPRING = '#1f9d68', DAMPER = '#a8762a', GROUND = '#9aa1ab', REACTION = '#d61f69', CONTACT = '#b45309';
const SLIDING = new Set(['prismatic', 'cylindrical', 'screw', 'planar', 'point_on_line', 'point_on_plane', 'point_on_surface']);
const Z = new Vector3(0, 0, 1), ONE = new Vector3(1, 1, 1), NONE = new Quaternion(), HIDDEN = new Matrix4().makeScale(0, 0, 0);
const vector = a => new Vector3(a?.[0] || 0, a?.[1] || 0, a?.[2] || 0), along = axis => new Quaternion().setFromUnitVectors(Z, vector(axis).normalize());
const quaternion = w => w ? new Quaternion(w[1], w[2], w[3], w[0]) : NONE;

export class Mechanism {
  // options: ghost (translucent, nothing but shapes), fine (0 painted, 1 without a GPU, 2)
  constructor(drawing, run, options = {}) {
    Object.assign(this, { drawing, run, options, flat: drawing.dimension === 2, items: [], group: new Group(), time: run.t[0] });
    this.up = vector(this.flat ? [0, 1, 0] : drawing.up);
    let next = 0; this.first = drawing.frames.map(f => { const c = next; next += f.variables.length; return c; });
    this.live = new Float64Array(next);
    this.positions = drawing.frames.map(() => new Vector3()); this.turns = drawing.frames.map(() => new Quaternion());
    this.measure(); this.build();
  }
  pose(values) {
    this.drawing.frames.forEach((f, k) => {
      const c = this.first[k], n = f.variables.length; if (!n) return;
      this.positions[k].set(values[c], values[c + 1], this.flat ? 0 : values[c + 2]);
      if (f.kind === 'body') this.flat ? this.turns[k].setFromAxisAngle(Z, values[c + 2]) : this.turns[k].set(values[c + 4], values[c + 5], values[c + 6], values[c + 3]).normalize();
    });
  }
  place(p, out) {
    if (p.between) { const [a, b] = p.between.map(e => this.place(e, new Vector3())); return out.copy(a).lerp(b, p.share); }
    return out.set(p.at[0], p.at[1], p.at[2] || 0).applyQuaternion(this.turns[p.frame]).add(this.positions[p.frame]);
  }
  // Places whose motion says how large the mechanism is and where it goes.
  spots() {
    const spots = [...this.drawing.joints.map(j => j.place), ...this.drawing.links.flatMap(l => l.ends)];
    this.drawing.frames.forEach((f, k) => { if (f.variables.length) spots.push({ frame: k, at: [0, 0, 0] }); });
    for (const s of this.drawing.solids) {
      if (['plane', 'heights'].includes(s.shape) || this.lies(s)) continue;
      const turn = quaternion(s.turn), corners = [];
      if (s.shape === 'curve') corners.push(...s.points.filter((p, k) => k % Math.ceil(s.points.length / 24) === 0));
      else if (s.shape === 'capsule') for (const c of [s.from, s.to]) corners.push(...[0, 1, 2].flatMap(k => [-1, 1].map(sign => vector(c).setComponent(k, (c[k] || 0) + sign * s.radius).toArray())));
      else if (s.shape === 'mesh') corners.push(...s.vertices.filter((v, k) => k % Math.ceil(s.vertices.length / 200) === 0)); else if (s.shape === 'prism') corners.push(...s.corners);
      else if (s.to) { spots.push(...[s.at || [0, 0, 0], ...s.to].map(at => ({ frame: s.frame, at }))); continue; }
      else { const r = s.radius || 0, e = s.size?.map(x => x / 2) || s.half_axes || [r, r, s.length ? s.length / 2 : r]; for (let k = 0; k < 8; k++) corners.push([k & 1 ? e[0] : -e[0], k & 2 ? e[1] : -e[1], k & 4 ? e[2] || 0 : -(e[2] || 0)]); }
      for (const c of corners) spots.push({ frame: s.frame, at: vector(c).applyQuaternion(turn).add(vector(s.at)).toArray() });
    }
    return spots;
  }
  lies(s) { return s.shape === 'curve' && !this.drawing.frames[s.frame].variables.length; }      // on the ground: a road, a rail, an arc
  measure() {
    const { run } = this, spots = this.spots(), v = new Vector3(), step = Math.max(1, Math.floor(run.n / 60));
    this.swept = new Box3(); this.drawn = new Box3();
    for (let i = 0; i < run.n; i += step) {
      this.pose(run.pose(i, this.live));
      for (const s of spots) { this.place(s, v); if (!Number.isFinite(v.x)) continue; this.swept.expandByPoint(v); if (!i) this.drawn.expandByPoint(v); }
    }
    if (this.swept.isEmpty()) this.swept.set(new Vector3(-1, -1, -1), new Vector3(1, 1, 1));
    if (this.drawn.isEmpty()) this.drawn.copy(this.swept);
    this.pose(run.pose(0, this.live)); this.began = this.middle();
    this.reach = Math.hypot(...['x', 'y', 'z'].map(c => Math.max(this.began[c] - this.drawn.min[c], this.drawn.max[c] - this.began[c])));
    for (const s of this.drawing.solids) {               // of what lies on the ground what is about as large as the mechanism
      if (!this.lies(s)) continue;
      const own = new Box3().setFromPoints(s.points.map(p => this.place({ frame: s.frame, at: vector(p).applyQuaternion(quaternion(s.turn)).add(vector(s.at)).toArray() }, new Vector3())));
      if (own.getSize(v).length() < 1.5 * this.drawn.getSize(new Vector3()).length()) { this.swept.union(own); this.drawn.union(own); }
    }
    this.extent = this.swept.getSize(v).length() || 1; this.size = this.drawn.getSize(v).length() || this.extent;
    const parts = this.drawing.solids.length + this.drawing.links.length || 1, thin = .011 * this.size / Math.max(1, (parts / 12) ** .6);
    this.thick = Math.max(Math.min(thin, .075 * this.typical()), 6e-4 * this.size);
  }
  typical() {                             // length of a middling part: marks stay smaller than what they mark
    const a = new Vector3(), b = new Vector3(), list = this.drawing.links.filter(l => l.kind !== 'rail').map(l => this.place(l.ends[0], a).distanceTo(this.place(l.ends[1], b)));
    for (const s of this.drawing.solids) { const x = s.shape === 'capsule' ? vector(s.from).distanceTo(vector(s.to)) : s.to ? 1.5 * Math.max(...s.to.map(t => vector(t).distanceTo(vector(s.at)))) : Math.max(2 * (s.radius || 0), s.length || 0, ...(s.size || [])); if (x > 0) list.push(x); }
    return list.sort((x, y) => x - y)[list.length >> 1] || this.size;
  }
  middle() {                              // of what moves, or the place that the scene follows
    const out = new Vector3(), { follow } = this.drawing.view || {}; let n = 0;
    if (follow) return this.place(follow, out);
    this.drawing.frames.forEach((f, k) => { if (f.variables.length) { out.add(this.positions[k]); n++; } });
    return n ? out.divideScalar(n) : out;
  }
  box() {                                 // around what is followed, however it turns
    const at = this.middle().add(this.group.position); return new Box3(at, at.clone()).expandByScalar((this.flat ? 1.15 : .85) * this.reach);
  }

  add(shape, colour, owner, matrix, more = {}) { this.items.push({ shape, colour, owner, matrix, opacity: 1, layer: '', ...more }); }
  fixed(p, turn, scale) {
    if (p.between) { const v = new Vector3(); return out => out.compose(this.place(p, v), turn, scale); }
    const local = new Matrix4().compose(vector(p.at), turn, scale), world = new Matrix4();
    return out => out.multiplyMatrices(world.compose(this.positions[p.frame], this.turns[p.frame], ONE), local);
  }
  // A shape that lies between two places; shapes that begin at 0 (helix, cone) or are centred there.
  between(a, b, width, { from = 0, to = 1, centred = true, lift = 0, depth = width } = {}) {
    const p = new Vector3(), q = new Vector3(), d = new Vector3(), turn = new Quaternion(), scale = new Vector3();
    return out => {
      this.place(a, p); this.place(b, q); d.subVectors(q, p); const L = d.length() || 1e-12; turn.setFromUnitVectors(Z, d.divideScalar(L));
      p.addScaledVector(d, L * (centred ? (from + to) / 2 : from)); p.z += lift;
      return out.compose(p, turn, scale.set(width, depth, L * (to - from)));
    };
  }
  bar(a, b, width, lift) {                // flat, in the plane
    const p = new Vector3(), q = new Vector3(), turn = new Quaternion(), scale = new Vector3();
    return out => {
      this.place(a, p); this.place(b, q); turn.setFromAxisAngle(Z, Math.atan2(q.y - p.y, q.x - p.x)); scale.set(p.distanceTo(q) || 1e-12, 2 * width, .8 * this.thick);
      p.lerp(q, .5).z += lift; return out.compose(p, turn, scale);
    };
  }
  build() {
    const { drawing } = this; let row = 0;
    const lift = () => this.flat ? (row++ % 4) * .9 * this.thick : 0;
    for (const s of drawing.solids) this.solid(s, lift());
    for (const l of drawing.links) this.link(l, lift());
    if (!this.options.ghost) {
      for (const j of drawing.joints) this.joint(j);
      for (const j of drawing.joints) this.arrow(j, REACTION);
      for (const c of drawing.contacts || []) this.arrow(c, CONTACT);
    }
    this.instances();
  }
  solid(s, lift) {
    const T = this.thick, colour = typeof s.colour === 'string' ? s.colour : s.colour < 0 ? GROUND : PALETTE[(s.colour ?? 7) % PALETTE.length], more = { opacity: s.opacity ?? 1 };
    const p = { frame: s.frame, at: s.at || [0, 0, 0] }, turn = quaternion(s.turn), flat = x => x || 1.4 * T, put = (shape, scale, q = turn, at = p) => this.add(shape, colour, s.owner, this.fixed(at, q, scale), more);
    const mark = this.drawing.frames[s.frame].variables.length && more.opacity === 1 ? '*' : '';     // so that one sees it turn
    const ends = (from, to) => [from, to].map(x => ({ frame: s.frame, at: vector(x).applyQuaternion(turn).add(vector(s.at)).toArray() }));
    if (s.kind === 'surface') Object.assign(more, { layer: 'ground', surface: true });
    switch (s.shape) {
      case 'box': return put('box', new Vector3(Math.max(s.size[0], .6 * T), Math.max(s.size[1], .6 * T), this.flat ? flat(0) : Math.max(s.size[2], .6 * T)));
      case 'sphere': return put((this.flat ? 'cylinder' : 'sphere') + mark, new Vector3(s.radius, s.radius, this.flat ? flat(0) : s.radius));
      case 'cylinder': return put((s.inner_radius ? `ring:${(s.inner_radius / s.radius).toFixed(3)}` : 'cylinder') + mark, new Vector3(s.radius, s.radius, this.flat ? flat(0) : s.length));
      case 'capsule': {
        const [a, b] = ends(s.from, s.to), r = s.radius;
        this.add(this.flat ? 'box' : 'cylinder', colour, s.owner, this.flat ? this.bar(a, b, r, lift) : this.between(a, b, r), more);
        for (const e of [a, b]) put(this.flat ? 'cylinder' : 'sphere', new Vector3(r, r, this.flat ? .8 * T : r), NONE, e);
        return;
      }
      case 'struts': {
        const r = 1.5 * T, raised = at => ({ frame: s.frame, at: [at[0], at[1], (at[2] || 0) + lift] }), at = raised(p.at);
        for (const to of s.to.map(raised)) {
          this.add(this.flat ? 'box' : 'cylinder', colour, s.owner, this.flat ? this.bar(at, to, r, 0) : this.between(at, to, r), more);
          put(this.flat ? 'cylinder' : 'sphere', new Vector3(r, r, this.flat ? .8 * T : r), NONE, to);
        }
        return put('sphere', new Vector3(1.3 * r, 1.3 * r, 1.3 * r), NONE, at);
      }
      case 'plane': {
        const n = vector(s.normal || [0, 0, 1]).normalize(), L = 1.6 * this.extent, depth = .6 * T, at = vector(s.at), middle = this.swept.getCenter(new Vector3());
        if (!this.drawing.frames[s.frame].variables.length) at.add(middle.sub(at).projectOnPlane(n));      // under what moves
        at.addScaledVector(n, -depth / 2); const lying = new Quaternion().setFromUnitVectors(new Vector3(0, 1, 0), n);
        return put('box', this.flat ? new Vector3(L, depth, 3 * T) : new Vector3(L, L, depth), this.flat ? lying : along(n.toArray()), { frame: s.frame, at: at.toArray() });
      }
      case 'curve': {
        const points = s.points.map(x => ends(x, x)[0]);
        for (let k = 0; k + 1 < points.length; k++) this.add(this.flat ? 'box' : 'cylinder', colour, s.owner, this.flat ? this.bar(points[k], points[k + 1], .5 * T, 0) : this.between(points[k], points[k + 1], .5 * T), more);
        return;
      }
      default: return put(ownShape({ ...s, thickness: this.flat ? .8 * T : s.thickness }), ONE);
    }
  }
  link(l, lift) {
    const T = this.thick, [a, b] = l.ends, q = new Vector3(), put = (shape, colour, matrix, more) => this.add(shape, colour, l.name, matrix, more);
    for (const e of l.kind === 'rail' ? [] : l.ends) if (e.frame === 0 && !this.drawing.joints.some(j => j.ground && this.place(j.place, new Vector3()).distanceTo(this.place(e, q)) < T)) {
      put('sphere', DARK, this.fixed(e, NONE, new Vector3(1, 1, 1).multiplyScalar(1.4 * T)), { layer: 'joints' }); this.support(e);
    }
    if (l.kind === 'bar') {
      const r = (this.flat ? 1.9 : 1.5) * T, colour = PALETTE[(l.colour ?? 0) % PALETTE.length];
      put(this.flat ? 'box' : 'cylinder', colour, this.flat ? this.bar(a, b, r, lift) : this.between(a, b, r));
      for (const e of [a, b]) { const end = this.fixed(e, NONE, new Vector3(r, r, this.flat ? .8 * T : r)); put(this.flat ? 'cylinder' : 'sphere', colour, this.flat ? out => { end(out); out.elements[14] += lift; return out; } : end); }
    } else if (l.kind === 'spring') {
      const w = 3 * T, L = this.place(a, new Vector3()).distanceTo(this.place(b, new Vector3()));
      put(`helix:${Math.max(3, Math.min(40, Math.round(L / w)))}`, SPRING, this.between(a, b, w, { centred: false }));
    } else if (l.kind === 'damper') {
      put('cylinder', DAMPER, this.between(a, b, .55 * T)); put('cylinder', DAMPER, this.between(a, b, 1.35 * T, { from: .08, to: .55 }));
    } else if (l.kind === 'actuator') {
      put('cylinder', '#c9ced6', this.between(a, b, .9 * T)); put('cylinder', '#4a5361', this.between(a, b, 1.7 * T, { from: .03, to: .55 }));
    } else if (l.kind === 'rail') this.rail(l);
    else if (l.kind === 'rope') put('cylinder', '#7a6a4f', this.between(a, b, .4 * T));
    else put('cylinder', STEEL, this.between(a, b, .75 * T));
  }
  rail(l) {                               // as far as what slides on it goes
    const { run } = this, [a, b] = l.ends, axis = vector(l.axis).normalize(), p = new Vector3(), q = new Vector3(), d = new Vector3(); let low = 0, high = 0;
    for (let i = 0; i < run.n; i += Math.max(1, run.n >> 7)) { this.pose(run.pose(i, this.live)); this.place(a, p); this.place(b, q); const u = q.sub(p).dot(d.copy(axis).applyQuaternion(this.turns[a.frame])); low = Math.min(low, u); high = Math.max(high, u); }
    this.pose(run.pose(0, this.live)); const more = .1 * this.size, end = u => ({ frame: a.frame, at: vector(a.at).addScaledVector(axis, u).toArray() });
    this.add('cylinder', '#b9bec6', l.name, this.between(end(low - more), end(high + more), .6 * this.thick), { layer: a.frame ? 'joints' : 'ground' });
  }
  joint(j) {
    const T = this.thick, more = { layer: 'joints' }, put = (shape, colour, x, y, z, q = NONE, extra = more) => this.add(shape, colour, j.name, this.fixed(j.place, q, new Vector3(x, y, z).multiplyScalar(T)), extra);
    if (j.kind === 'point' || j.kind === 'fixed'&& j.share !== undefined) put('sphere', DARK, 1.4 + 2.2 * (j.share || 0), 1.4 + 2.2 * (j.share || 0), 1.4 + 2.2 * (j.share || 0), NONE, j.kind === 'point' ? {} : more);
    else if (this.flat) { put('cylinder', PIN, 1.1, 1.1, 7); put('cylinder', DARK, 1.7, 1.7, 5.6); }
    else if (j.axis) { const q = along(j.axis), long = j.kind === 'prismatic' ? 14 : 7; put('cylinder', PIN, 1.2, 1.2, long, q); put(j.kind === 'prismatic' ? 'box' : 'cylinder', DARK, j.kind === 'prismatic' ? 4 : 2, j.kind === 'prismatic' ? 4 : 2, 4.6, q); }
    else put('sphere', DARK, 1.9, 1.9, 1.9);
    if (j.ground && !SLIDING.has(j.kind)) this.support(j.place);
  }
  support(place) {                        // it stands still
    const T = this.thick, p = new Vector3(), turn = new Quaternion().setFromUnitVectors(Z, this.up), at = (h, x, y, z) => { const scale = new Vector3(x, y, z).multiplyScalar(T); return out => out.compose(this.place(place, p).addScaledVector(this.up, h * T), turn, scale); };
    this.add('cone', GROUND, 'ground', at(-4.8, 3, this.flat ? 1 : 3, 4.8), { layer: 'ground' }); this.add('box', '#7c838e', 'ground', at(-5.2, 8, this.flat ? 3 : 8, 1), { layer: 'ground' });
  }
  arrow(j, colour) {                      // as long as the square root of the force, so that small ones are seen
    const parts = !!j.force?.[0]?.endsWith('.x');              // of a reaction; a contact has the size of its force, and perhaps a direction
    if (!j.force?.length || (!parts && !j.normal && !j.from) || !j.force.every(n => this.run.columns.has(n))) return;
    const T = this.thick, p = new Vector3(), f = new Vector3(), d = new Vector3(), turn = new Quaternion(), scale = new Vector3();
    const force = parts ? () => { f.set(0, 0, 0); j.force.forEach((n, k) => f.setComponent(k, this.run.value(n, this.time) || 0)); } : () => {      // along a normal, or away from a place
      if (j.normal) f.set(...j.normal.axis).applyQuaternion(this.turns[j.normal.frame]); else { this.place(j.place, f); f.sub(this.place(j.from, p)).normalize(); }
      f.multiplyScalar(this.run.value(j.force[0], this.time) || 0);
    };
    const length = () => { force(); return .28 * this.size * Math.sqrt(Math.min(1, f.length() / this.strongest)); };
    const put = (shape, write) => this.add(shape, colour, j.name, out => { const L = length(); if (L < 2 * T) return out.copy(HIDDEN); turn.setFromUnitVectors(Z, d.copy(f).normalize()); this.place(j.place, p); write(L); return out.compose(p, turn, scale); }, { layer: 'forces' });
    put('cylinder', L => { p.addScaledVector(d, L / 2); scale.set(.55 * T, .55 * T, L); }); put('cone', L => { p.addScaledVector(d, L); scale.set(1.5 * T, 1.5 * T, 4 * T); });
    (this.arrows ||= []).push(j); this.strongest = 1; this.weigh();
  }
  weigh() {
    let most = 0;
    for (const j of this.arrows || []) { const c = (j.force[0].endsWith('.x') ? j.force : j.force.slice(0, 1)).map(n => this.run.columns.get(n)); for (let i = 0; i < this.run.n; i++) { let s = 0; for (const x of c) s += x[i] * x[i]; if (s > most) most = s; } }
    this.strongest = Math.sqrt(most) || 1;
  }
  instances() {
    const { ghost, fine } = this.options, groups = new Map(), rough = this.items.length > 600 ? 0 : fine;
    for (const it of this.items) { const key = typeof it.shape === 'string' ? `${it.shape}|${it.layer}|${it.opacity}` : it; (groups.get(key) || groups.set(key, []).get(key)).push(it); }
    this.meshes = [];
    for (const list of groups.values()) {
      const { shape, layer, surface } = list[0], opacity = ghost ? .28 : list[0].opacity;
      const material = fine > 1 ? new MeshStandardMaterial({ roughness: .5, metalness: .08 }) : new MeshLambertMaterial();
      if (typeof shape !== 'string') material.side = DoubleSide; else material.vertexColors = shape.endsWith('*');
      if (opacity < 1) Object.assign(material, { transparent: true, opacity, depthWrite: false });
      if (layer === 'forces') Object.assign(material, { depthTest: false, transparent: true });
      const mesh = new InstancedMesh(typeof shape === 'string' ? unitShape(shape, rough) : shape, material, list.length);
      Object.assign(mesh, { frustumCulled: false, castShadow: opacity === 1 && layer !== 'forces' && !surface, receiveShadow: opacity === 1, userData: { list, layer }, renderOrder: layer === 'forces' ? 5 : 0 });
      list.forEach((it, k) => mesh.setColorAt(k, new Color(it.colour)));
      this.meshes.push(mesh); this.group.add(mesh);
    }
  }
  moveTo(time) {
    this.time = Math.min(Math.max(time, this.run.t[0]), this.run.t[this.run.n - 1]); this.pose(this.run.sample(this.time, this.live));
    const m = this.matrix ||= new Matrix4();
    for (const mesh of this.meshes) {
      if (!mesh.visible) continue;
      const { list } = mesh.userData, out = mesh.instanceMatrix.array;
      for (let k = 0; k < list.length; k++) list[k].matrix(m).toArray(out, 16 * k);
      mesh.instanceMatrix.needsUpdate = true; mesh.boundingSphere = null;
    }
  }
  row() {                                 // where the time is among the rows, with a part of one
    const { t, n } = this.run, i = Math.min(this.run.index(this.time), n - 2); return i < 0 ? 0 : i + (this.time - t[i]) / (t[i + 1] - t[i] || 1);
  }
  // Points of paths: what the scene asks for, else moving points, else bodies.
  paths() {
    this.pose(this.run.pose(0, this.live));
    const frames = this.drawing.frames, wanted = this.drawing.view?.traces;
    if (wanted?.length) return wanted.map(x => x.place);
    const moves = k => frames[k].variables.length, ends = this.drawing.links.filter(l => l.kind === 'bar').flatMap(l => l.ends), joints = this.drawing.joints.map(j => j.place);
    let all = [...joints.filter((p, k) => ['point', 'driven'].includes(this.drawing.joints[k].kind)), ...ends].filter(p => p.frame !== undefined && moves(p.frame));
    const fixed = [...this.drawing.joints.filter(j => j.ground).map(j => this.place(j.place, new Vector3()).clone())];
    all = all.filter((p, k) => { const v = this.place(p, new Vector3()); return !fixed.some(x => x.distanceTo(v) < 1e-6 * this.size) && !all.slice(0, k).some(x => this.place(x, new Vector3()).distanceTo(v) < 1e-6 * this.size); });
    if (!all.length) all = frames.map((f, k) => ({ frame: k, at: [0, 0, 0] })).filter(p => moves(p.frame));
    return all.length > 8 ? all.slice(-1) : all;
  }
  path(p, most) {                         // about so many pieces, but no fewer than rows
    const { run } = this, each = run.n > 2500 ? 1 / Math.floor(run.n / 2500) : Math.max(1, Math.min(8, Math.round(most / run.n))), count = Math.floor((run.n - 1) * each) + 1, points = [], v = new Vector3();
    for (let k = 0; k < count; k++) {     // between rows as the mechanism moves there
      const i = Math.floor(k / each + 1e-9), s = k / each - i, t = run.t;
      this.pose(s > 1e-9 ? run.sample(t[i] + s * (t[i + 1] - t[i]), this.live) : run.pose(i, this.live)); this.place(p, v); v.add(this.group.position); points.push(v.x, v.y, v.z - (this.flat ? 2 * this.thick : 0));
    }
    return { points, each, count };
  }
  dispose() { for (const mesh of this.meshes) { mesh.geometry.dispose(); mesh.material.dispose(); mesh.dispose(); } this.group.removeFromParent(); }
}
