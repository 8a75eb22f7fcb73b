// The place where mechanisms move: light, ground, camera, paths. WebGL, or a painted canvas.
import {
  Box3, BufferGeometry, Color, DirectionalLight, Float32BufferAttribute, HemisphereLight, Line, LineBasicMaterial, Mesh, OrthographicCamera, PCFShadowMap, PerspectiveCamera, PlaneGeometry, Quaternion, Raycaster, Scene,
  ShaderMaterial, ShadowMaterial, Vector2, Vector3, WebGLRenderer, Object3D,
} from 'three';
import { OrbitControls } from 'three/addons/controls/OrbitControls.js';
import { Line2 } from 'three/addons/lines/Line2.js';
import { LineGeometry } from 'three/addons/lines/LineGeometry.js';
import { LineMaterial } from 'three/addons/lines/LineMaterial.js';
import { Mechanism } from './mechanism.js';
import { Painter } from './painter.js';
import { PALETTE } from './text.js';

const Z = new Vector3(0, 0, 1), FIELD = 28;
const SOFTWARE = /swiftshader|llvmpipe|software|basic render/i;

// What draws here: the name of the renderer, asked for on a canvas of its own.
function graphics() {
  const context = document.createElement('canvas').getContext('webgl2'); if (!context) return '';
  const about = context.getExtension('WEBGL_debug_renderer_info'), name = context.getParameter(about ? about.UNMASKED_RENDERER_WEBGL : context.RENDERER);
  context.getExtension('WEBGL_lose_context')?.loseContext();
  return String(name);
}

export class Stage {
  constructor(canvas, drawing, options = {}) {
    this.flat = drawing.dimension === 2; this.up = this.flat ? new Vector3(0, 1, 0) : new Vector3(...drawing.up);
    this.layers = { traces: true, joints: true, forces: false, ground: true }; this.shown = []; this.lines = [];
    this.graphics = options.painted ? '' : graphics(); this.fine = !this.graphics ? 0 : SOFTWARE.test(this.graphics) ? 1 : 2;
    this.scene = new Scene();
    try { if (!this.fine) throw new Error('no WebGL'); this.renderer = this.webgl(canvas); } catch {
      const fresh = canvas.cloneNode(); canvas.replaceWith(fresh);       // a canvas keeps its first kind of context
      this.fine = 0; this.renderer = new Painter(fresh);
    }
    this.canvas = this.renderer.domElement; this.painted = !!this.renderer.painted;
    this.canvas.addEventListener('webglcontextlost', e => { e.preventDefault(); this.lost = true; });
    this.canvas.addEventListener('webglcontextrestored', () => { this.lost = false; this.dirty = true; });
    this.camera = this.flat ? new OrthographicCamera() : new PerspectiveCamera(FIELD); this.camera.up.copy(this.up);
    const c = this.controls = new OrbitControls(this.camera, this.canvas); c.enableDamping = false; c.zoomToCursor = true;
    if (this.flat) { c.enableRotate = false; c.mouseButtons.LEFT = 2; c.touches.ONE = 1; }
    c.addEventListener('change', () => { this.dirty = true; }); c.addEventListener('start', () => { this.moved = true; });
    this.ground();
  }
  // What is to be drawn anew is drawn in the next frame; `wake` asks for one.
  get dirty() { return this.stale; }
  set dirty(on) { this.stale = on; if (on) this.wake?.(); }
  webgl(canvas) {
    const r = new WebGLRenderer({ canvas, antialias: this.fine > 1, alpha: true, preserveDrawingBuffer: true });
    r.shadowMap.enabled = this.fine > 1; r.shadowMap.type = PCFShadowMap;
    return r;
  }
  ground() {                              // light, shadow and a grid that fades; no depth, or they would fight
    this.sun = new DirectionalLight('#ffffff', this.fine > 1 ? 2 : 1.5); this.sun.castShadow = true; this.sun.shadow.mapSize.setScalar(2048); this.sun.shadow.bias = -6e-4;
    this.scene.add(this.sun, this.sun.target, this.sky = new HemisphereLight('#ffffff', '#8890a0'));
    if (this.painted) return;
    const plane = new PlaneGeometry(1, 1);
    this.shadow = new Mesh(plane, new ShadowMaterial({ opacity: .2, depthWrite: false })); this.shadow.receiveShadow = true;
    this.grid = new Mesh(plane, new ShaderMaterial({
      transparent: true, depthWrite: false, uniforms: { colour: { value: new Color('#8894a6') }, cell: { value: .1 }, origin: { value: new Vector2() } },
      vertexShader: 'varying vec2 at, edge; void main() { vec4 p = modelMatrix * vec4(position, 1.); edge = position.xy * 2.; at = position.xy * vec2(length(modelMatrix[0].xyz), length(modelMatrix[1].xyz)); gl_Position = projectionMatrix * viewMatrix * p; }',
      fragmentShader: 'varying vec2 at, edge; uniform vec3 colour; uniform float cell; uniform vec2 origin; float lines(float size) { vec2 g = (at + origin) / size, d = abs(fract(g - .5) - .5) / fwidth(g); return 1. - min(min(d.x, d.y), 1.); } void main() { float a = max(.5 * lines(cell), lines(5. * cell)) * smoothstep(1., .3, length(edge)) * .6; if (a < .01) discard; gl_FragColor = vec4(colour, a); }',
    }));
    for (const x of [this.shadow, this.grid]) { x.renderOrder = -2; this.scene.add(x); }
  }
  // Shows these mechanisms: { drawing, run, ghost, label }; the first leads, others are ghosts or stand beside it.
  show(list, beside) {
    for (const m of this.shown) m.dispose();
    this.shown = list.map((x, k) => new Mechanism(x.drawing, x.run, { ghost: k > 0 && !beside, fine: this.fine }));
    const [m] = this.shown, right = this.flat ? new Vector3(1, 0, 0) : this.axes(1, 0, 0), across = this.flat ? this.up.clone().negate() : this.axes(0, 1, 0), wide = d => Math.max(...this.shown.map(x => Math.abs(x.swept.getSize(new Vector3()).dot(d))));
    this.travels = m.extent > 5 * m.size;
    const side = this.travels && wide(across) < wide(right) ? across : right, width = wide(side) + .25 * m.size;     // beside the way of what travels
    this.shown.forEach((x, k) => { x.group.position.copy(side).multiplyScalar(beside ? k * width : 0); x.group.updateMatrixWorld(true); this.scene.add(x.group); });
    this.size = m.size; this.whole = new Box3(); for (const x of this.shown) this.whole.union(x.swept.clone().translate(x.group.position));
    this.extent = this.whole.getSize(new Vector3()).length() || 1;
    this.settle(); this.trace(); for (const name in this.layers) this.layer(name, this.layers[name]);
    this.last = null;
  }
  settle() {
    const S = this.extent, centre = this.whole.getCenter(new Vector3()), from = this.flat ? new Vector3(-.35, .5, 1) : this.axes(.55, -.45, 1.1);
    this.sun.position.copy(centre).addScaledVector(from.normalize(), 2 * S); this.sun.target.position.copy(centre); this.sun.shadow.normalBias = .004 * S;
    Object.assign(this.sun.shadow.camera, { left: -.75 * S, right: .75 * S, bottom: -.75 * S, top: .75 * S, near: .1 * S, far: 5 * S }); this.sun.shadow.camera.updateProjectionMatrix();
    Object.assign(this.camera, { near: .01 * S, far: 60 * S });
    if (this.painted) return;
    const low = Math.min(this.whole.min.dot(this.up), this.whole.max.dot(this.up)) - .03 * this.size, at = this.flat ? centre.clone().setZ(-8 * this.shown[0].thick) : centre.clone().addScaledVector(this.up, low - centre.dot(this.up));
    const turn = new Quaternion().setFromUnitVectors(Z, this.flat ? Z : this.up);
    for (const x of [this.shadow, this.grid]) { x.position.copy(at); x.quaternion.copy(turn); x.scale.setScalar((this.flat ? 4 : 5) * S); }
    this.cell = 10 ** Math.floor(Math.log10(S / 2)); this.grid.material.uniforms.cell.value = this.cell; if (this.flat) this.grid.material.uniforms.origin.value.set(at.x, at.y);
  }
  left() {                                // whether something of a live mechanism is beyond what is seen: then that grows
    const [m] = this.shown, far = m.drawing.frames.filter((f, k) => f.variables.length && this.whole.distanceToPoint(m.positions[k]) > .3 * this.size).length;
    if (!far || this.following) return false;
    m.positions.forEach((p, k) => { if (m.drawing.frames[k].variables.length && Number.isFinite(p.x)) this.whole.expandByPoint(p); }); this.whole.expandByScalar(.5 * this.size);
    this.extent = this.whole.getSize(new Vector3()).length(); this.settle(); return true;
  }
  axes(x, y, z) {                         // right, away and up, whatever axis is up
    const k = ['x', 'y', 'z'].findIndex(c => Math.abs(this.up[c]) > .5), right = new Vector3().setComponent((k + 1) % 3, 1), away = new Vector3().crossVectors(this.up, right);
    return right.multiplyScalar(x).addScaledVector(away, y).addScaledVector(this.up, z);
  }
  direction(name) {
    if (this.flat) return name === 'iso' ? new Vector3(-.35, .35, 1) : Z.clone();
    const wanted = this.shown?.[0]?.drawing.view?.direction;
    return name === 'front' ? this.axes(0, -1, 0) : name === 'side' ? this.axes(1, 0, 0) : name === 'top' ? this.axes(0, -.001, 1) : wanted ? new Vector3(...wanted) : this.axes(.62, -.88, .42);
  }
  view(name) {                            // looks from there, so that all that is swept can be seen
    this.moved = false;
    const { camera, controls } = this, box = this.following ? this.shown.reduce((all, x) => all.union(x.box()), new Box3()) : this.whole, centre = box.getCenter(new Vector3());
    const d = (name === 'fit' ? camera.position.clone().sub(controls.target) : this.direction(name)).normalize();
    controls.target.copy(centre); camera.position.copy(centre).addScaledVector(d, this.flat ? 6 * this.extent : 1); camera.lookAt(centre); camera.updateMatrixWorld();
    const [right, up, out] = [0, 1, 2].map(k => new Vector3().setFromMatrixColumn(camera.matrixWorld, k)), aspect = this.width / this.height || 1.5, tan = Math.tan(FIELD * Math.PI / 360), margin = 1.2;
    let w = 0, h = 0, far = 0;
    for (let k = 0; k < 8; k++) {
      const c = new Vector3(k & 1 ? box.max.x : box.min.x, k & 2 ? box.max.y : box.min.y, k & 4 ? box.max.z : box.min.z).sub(centre), x = Math.abs(c.dot(right)), y = Math.abs(c.dot(up)), z = c.dot(out);
      w = Math.max(w, x); h = Math.max(h, y); far = Math.max(far, z + margin * y / tan, z + margin * x / (tan * aspect));
    }
    if (this.flat) { this.half = Math.max(h, w / aspect, .01 * this.size) * margin; camera.zoom = 1; } else camera.position.copy(centre).addScaledVector(d, Math.max(far, .02 * this.extent));
    this.resized = this.dirty = true; controls.update();
  }
  follow(on) { this.following = on; this.last = null; }
  resize(width, height) { Object.assign(this, { width, height, resized: true, dirty: true }); }
  theme(dark) { this.sky.intensity = (this.fine > 1 ? 1.3 : 1.7) * (dark ? 1.6 : 1); this.grid?.material.uniforms.colour.value.set(dark ? '#7f8ea6' : '#8894a6'); this.dirty = true; }
  layer(name, on) {
    this.layers[name] = on;
    for (const m of this.shown) for (const mesh of m.meshes) if (mesh.userData.layer === name) mesh.visible = on;
    if (name === 'ground' && this.grid) this.grid.visible = this.shadow.visible = on;
    if (name === 'forces') for (const m of this.shown) m.moveTo(m.time);
    this.dirty = true;
  }
  trace() {
    for (const l of this.lines) { l.removeFromParent(); l.geometry?.dispose(); l.material?.dispose(); }
    this.lines = []; const moving = this.shown.filter(m => !m.options.ghost);
    for (const m of moving) m.paths().slice(0, 12).forEach((p, k, all) => {
      const { points, each, count } = m.path(p, (this.fine > 1 ? 4000 : 2000) / all.length / moving.length), colour = PALETTE[(k + 3) % PALETTE.length]; if (count < 3) return;
      for (const [width, opacity, whole] of [[1, .4, true], [2.2, .95, false]]) {
        const data = { m, points, each, whole, width, opacity, colour, most: count - 1, shown: count - 1 };
        const ink = { color: colour, linewidth: width, transparent: true, opacity, depthWrite: false };      // a wide line costs ten times a thin one
        const line = this.painted ? new Object3D() : whole ? new Line(new BufferGeometry().setAttribute('position', new Float32BufferAttribute(points, 3)), new LineBasicMaterial(ink)) : new Line2(new LineGeometry().setPositions(points), new LineMaterial(ink));
        Object.assign(line, { userData: data, frustumCulled: false, renderOrder: 1 }); this.lines.push(line); this.scene.add(line);
      }
    });
  }
  moveTo(time) {
    for (const m of this.shown) m.moveTo(time);
    const [m] = this.shown;
    if (this.following) {
      const now = m.middle();
      if (this.last) { const d = now.clone().sub(this.last); for (const x of [this.camera.position, this.controls.target, this.sun.position, this.sun.target.position]) x.add(d); }
      this.last = now;
    }
    for (const line of this.lines) {
      const u = line.userData, count = u.whole ? u.most : Math.min(u.most, Math.floor(u.m.row() * u.each + 1e-9));
      u.shown = count; line.visible = this.layers.traces && count > 0; if (line.isLine2) line.geometry.instanceCount = count;
    }
    this.dirty = true;
  }
  render() {
    if (this.lost || !this.dirty || !this.width) return false;
    const { renderer, camera } = this;
    if (this.resized) {
      renderer.setPixelRatio(this.fine === 1 ? 1 : Math.min(2, devicePixelRatio || 1)); renderer.setSize(this.width, this.height, false);
      const aspect = this.width / this.height; if (this.flat) Object.assign(camera, { top: this.half, bottom: -this.half, right: this.half * aspect, left: -this.half * aspect }); else camera.aspect = aspect;
      camera.updateProjectionMatrix(); this.resized = false;
    }
    this.dirty = false; renderer.render(this.scene, camera);
    return true;
  }
  picked(x, y) {
    const ray = this.ray ||= new Raycaster(); ray.setFromCamera(new Vector2(2 * x / this.width - 1, 1 - 2 * y / this.height), this.camera);
    const found = ray.intersectObjects(this.shown.filter(m => !m.options.ghost).flatMap(m => m.meshes.filter(mesh => mesh.visible)), false)[0];
    return found?.object.userData.list[found.instanceId].owner;
  }
  screen(place, out) { const [m] = this.shown; m.place(place, out).project(this.camera); return [(out.x + 1) / 2 * this.width, (1 - out.y) / 2 * this.height, out.z]; }
  above(k, out) {                         // the middle of the top edge of a mechanism among several
    const { swept, drawn, group, began } = this.shown[k], box = this.following ? drawn.clone().translate(this.shown[k].middle().sub(began)) : swept, name = ['x', 'y', 'z'].find(c => Math.abs(this.up[c]) > .5);
    box.getCenter(out); out[name] = this.up[name] > 0 ? box.max[name] : box.min[name]; out.add(group.position).project(this.camera);
    return [(out.x + 1) / 2 * this.width, (1 - out.y) / 2 * this.height];
  }
}
