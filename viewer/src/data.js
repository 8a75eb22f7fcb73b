// Numbers of a run, decoded from the blocks of the page (packing.py says how they are written).
//
// A run is a source: { n, t, columns, kinds, label, meta, sample(time, out), pose(i, out),
// value(name, time), index(time) }. A live page has a source of its own with the same members.

const TURN = 2 * Math.PI / 65536, PARTS = 2 / 65000;

function decoded(text) {                  // for browsers of before 2025
  const raw = atob(text.trim()), bytes = new Uint8Array(raw.length);
  for (let i = 0; i < raw.length; i++) bytes[i] = raw.charCodeAt(i);
  return bytes;
}
export async function inflated(text) {
  const bytes = Uint8Array.fromBase64 ? Uint8Array.fromBase64(text) : decoded(text);
  const stream = new Blob([bytes]).stream().pipeThrough(new DecompressionStream('deflate'));
  return new Uint8Array(await new Response(stream).arrayBuffer());
}

// Bytes that stand apart, all first ones, then all second ones, become numbers again.
function joined(bytes, width) {
  const n = bytes.length / width, out = new Uint8Array(bytes.length);
  for (let p = 0; p < width; p++) for (let i = 0, o = p, k = p * n; i < n; i++, o += width) out[o] = bytes[k++];
  return out.buffer;
}

const NAMES = ['times', 'poses', 'values'];

export async function readRun(meta, kinds, number, block) {
  const parts = await Promise.all(NAMES.map(async (name, k) => {
    const id = `block${3 * number + k}`;
    try {
      const bytes = await inflated(block(id)), wide = meta.poses.wide ? kinds.filter(x => x === 'x').length : 0;
      const size = [8 * meta.n, (2 * (kinds.length - wide) + 4 * wide) * meta.n, 4 * meta.n * meta.values.length][k];
      if (bytes.length !== size) throw new Error('size');
      return bytes;
    } catch {
      const run = meta.label ? ` of run ${meta.label}` : '';
      throw new Error(`${id}, the ${name}${run}, is damaged; the file was cut off or changed: write the report again`);
    }
  }));
  return new Run(meta, kinds, ...parts);
}

export class Run {
  constructor(meta, kinds, times, poses, values) {
    Object.assign(this, { meta, kinds, n: meta.n, label: meta.label });
    const n = this.n, wide = meta.poses.wide, floats = joined(values, 4);
    this.t = new Float64Array(times.buffer.slice(times.byteOffset, times.byteOffset + 8 * n));
    this.columns = new Map(meta.values.map((name, k) => {
      const column = new Float32Array(floats, 4 * k * n, n), level = meta.levels[name];
      return [name, level ? Float64Array.from(column, x => level + x) : column];
    }));
    const counted = kinds.map((kind, c) => c).filter(c => !(wide && kinds[c] === 'x')), end = 2 * n * counted.length;
    const bits = new Uint16Array(joined(poses.subarray(0, end), 2)), far = new Float32Array(joined(poses.subarray(end), 4));
    this.scale = { x: [meta.poses.step, meta.poses.low], q: [PARTS, -1], angle: [TURN, 0] };
    this.channels = [];
    counted.forEach((c, k) => {
      const column = bits.subarray(k * n, (k + 1) * n);
      for (let order = 0; order < 2; order++) for (let i = 1; i < n; i++) column[i] += column[i - 1];
      this.channels[c] = column;
    });
    kinds.map((kind, c) => c).filter(c => !this.channels[c]).forEach((c, k) => { this.channels[c] = far.subarray(k * n, (k + 1) * n); });
  }
  index(time) {                           // the last row that is not after this time
    const { t } = this; let low = 0, high = this.n - 1;
    while (high - low > 1) { const m = (low + high) >> 1; if (t[m] <= time) low = m; else high = m; }
    return time >= t[high] ? high : low;
  }
  scaled(c) { return this.channels[c] instanceof Float32Array ? [1, 0] : this.scale[this.kinds[c]]; }
  pose(i, out) {
    for (let c = 0; c < this.kinds.length; c++) { const [step, low] = this.scaled(c); out[c] = low + step * this.channels[c][i]; }
    return out;
  }
  // Between rows: a cubic through four of them, so that rods keep their length.
  sample(time, out) {
    const { t, n } = this, i = Math.max(0, Math.min(this.index(time), n - 2)), j = Math.min(i + 1, n - 1);
    const h = t[j] - t[i], s = h > 0 ? Math.min(1, Math.max(0, (time - t[i]) / h)) : 0;
    const a = Math.max(i - 1, 0), b = Math.min(j + 1, n - 1);
    const before = t[j] - t[a], after = t[b] - t[i];     // slopes at both ends from their neighbours
    const h01 = s * s * (3 - 2 * s), h10 = s * (1 - s) ** 2 * h, h11 = s * s * (s - 1) * h;
    for (let c = 0; c < this.kinds.length; c++) {
      const [step, low] = this.scaled(c), x = this.channels[c], p = x[i];
      let d0 = x[a] - p, d = x[j] - p, d3 = x[b] - p;
      if (this.kinds[c] === 'angle') { d0 = d0 << 16 >> 16; d = d << 16 >> 16; d3 = d + ((x[b] - x[j]) << 16 >> 16); }
      let m0 = before > 0 ? (d - d0) / before : 0, m1 = after > 0 ? d3 / after : 0;
      if (b === j && h > 0) m1 = 2 * d / h - m0; else if (a === i && h > 0) m0 = 2 * d / h - m1;     // a parabola at both ends of the run
      out[c] = low + step * (p + h01 * d + h10 * m0 + h11 * m1);
    }
    return out;
  }
  value(name, time) {
    const x = this.columns.get(name); if (!x) return NaN;
    const { t, n } = this, i = Math.max(0, Math.min(this.index(time), n - 2)), j = Math.min(i + 1, n - 1), h = t[j] - t[i];
    return h > 0 ? x[i] + (x[j] - x[i]) * Math.min(1, Math.max(0, (time - t[i]) / h)) : x[i];
  }
}
