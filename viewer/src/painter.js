// Stands in for WebGLRenderer where there is no WebGL: paints the same scene, far faces first, on a 2-D canvas.
import { Color, Matrix4, Vector3 } from 'three';

const LIGHT = new Vector3(.3, .55, .8).normalize();

export class Painter {
  constructor(canvas) {
    Object.assign(this, { domElement: canvas, context: canvas.getContext('2d'), painted: true, ratio: 1 });
    this.dark = false;
  }
  setPixelRatio(ratio) { this.ratio = ratio; }
  setSize(width, height) { Object.assign(this, { width, height }); this.domElement.width = Math.round(width * this.ratio); this.domElement.height = Math.round(height * this.ratio); }
  render(scene, camera) {
    const c = this.context, faces = [], lines = [];
    scene.updateMatrixWorld(); camera.updateMatrixWorld(); const view = camera.matrixWorldInverse.copy(camera.matrixWorld).invert();
    this.toScreen = new Matrix4().multiplyMatrices(camera.projectionMatrix, view);
    c.setTransform(this.ratio, 0, 0, this.ratio, 0, 0); c.clearRect(0, 0, this.width, this.height); c.lineJoin = c.lineCap = 'round';
    scene.traverseVisible(o => { if (o.isInstancedMesh) this.gather(o, view, faces); else if (o.userData.points) lines.push(o); });
    for (const line of lines) this.line(line, c);
    faces.sort((a, b) => a.order - b.order || a.depth - b.depth);
    for (const f of faces) {
      c.globalAlpha = f.opacity; c.fillStyle = c.strokeStyle = f.colour; c.lineWidth = .7; c.beginPath();
      c.moveTo(f.p[0], f.p[1]); c.lineTo(f.p[2], f.p[3]); c.lineTo(f.p[4], f.p[5]); c.closePath(); c.fill(); if (f.opacity === 1) c.stroke();
    }
    c.globalAlpha = 1;
  }
  screen(v) { v.applyMatrix4(this.toScreen); return [(v.x + 1) / 2 * this.width, (1 - v.y) / 2 * this.height]; }
  gather(mesh, view, faces) {
    const position = mesh.geometry.attributes.position, index = mesh.geometry.index?.array, shades = mesh.geometry.attributes.color, count = index ? index.length : position.count, world = new Matrix4(), instance = new Matrix4(), colour = new Color(), text = new Color();
    const seen = [], at = [], both = mesh.material.side === 2, n = new Vector3(), e = new Vector3(), order = mesh.renderOrder;
    for (let k = 0; k < mesh.count; k++) {
      mesh.getMatrixAt(k, instance); world.multiplyMatrices(mesh.matrixWorld, instance); mesh.getColorAt(k, colour); const turn = new Matrix4().multiplyMatrices(view, world);
      for (let i = 0; i < position.count; i++) { seen[i] = new Vector3().fromBufferAttribute(position, i).applyMatrix4(turn); at[i] = this.screen(new Vector3().fromBufferAttribute(position, i).applyMatrix4(world)); }
      for (let i = 0; i < count; i += 3) {
        const [a, b, d] = index ? [index[i], index[i + 1], index[i + 2]] : [i, i + 1, i + 2], p = at[a], q = at[b], r = at[d];
        const area = (q[0] - p[0]) * (r[1] - p[1]) - (r[0] - p[0]) * (q[1] - p[1]);
        if ((area >= 0 && !both) || Math.abs(area) < .02) continue;   // faces that look away
        n.subVectors(seen[b], seen[a]).cross(e.subVectors(seen[d], seen[a])).normalize();
        text.copy(colour).multiplyScalar((.5 + .5 * Math.abs(n.dot(LIGHT))) * (shades ? shades.getX(i) : 1));
        faces.push({ p: [...p, ...q, ...r], depth: seen[a].z + seen[b].z + seen[d].z, colour: `#${text.getHexString()}`, opacity: mesh.material.opacity, order });
      }
    }
  }
  line({ userData: { points, shown, width, opacity, colour } }, c) {
    c.globalAlpha = opacity; c.strokeStyle = colour; c.lineWidth = width; c.beginPath();
    const v = new Vector3();
    for (let k = 0; k <= shown && 3 * k < points.length; k++) { const [x, y] = this.screen(v.set(points[3 * k], points[3 * k + 1], points[3 * k + 2])); k ? c.lineTo(x, y) : c.moveTo(x, y); }
    c.stroke(); c.globalAlpha = 1;
  }
  dispose() { }
}
