// A live page: `holonom view` sends rows as they are computed, and sliders send values back.
import { page, state } from './page.js';
import { $, escaped, shown, unitOf } from './text.js';

const MOST = 40000;                       // rows that are kept: of more, the older half goes
const REDRAWN = 120;                      // ms between two new drawings of all plots and paths

function floats(text) {
  const raw = atob(text), bytes = new Uint8Array(raw.length);
  for (let i = 0; i < raw.length; i++) bytes[i] = raw.charCodeAt(i);
  return new Float32Array(bytes.buffer);
}

// A source like Run of data.js, which grows.
class LiveRun {
  constructor({ kinds, live, runs }) {
    const at = new Map(live.columns.map((name, k) => [name, k]));
    Object.assign(this, { kinds, label: '', meta: runs[0], n: 0, room: 1024, channels: live.frames.map(name => at.get(name)) });
    this.times = new Float64Array(this.room); this.values = live.columns.map(() => new Float32Array(this.room));
    this.columns = { has: name => at.has(name), keys: () => at.keys(), get: name => this.values[at.get(name)]?.subarray(0, this.n) };
  }
  push({ time, values }) {
    if (this.n && time <= this.times[this.n - 1]) return;
    if (this.n === this.room) this.widen();
    this.times[this.n] = time; floats(values).forEach((x, k) => { this.values[k][this.n] = x; });
    this.n++; this.t = this.times.subarray(0, this.n);
  }
  widen() {
    const from = this.room < MOST ? 0 : this.n >> 1; if (!from) this.room *= 2;
    const moved = x => { const y = new x.constructor(this.room); y.set(x.subarray(from, this.n)); return y; };
    this.times = moved(this.times); this.values = this.values.map(moved); this.n -= from;
  }
  restart(rows) { this.n = 0; rows.forEach(row => this.push(row)); }
  index(time) {                           // the last row that is not after this time
    let low = 0, high = this.n - 1;
    while (high - low > 1) { const m = (low + high) >> 1; if (this.times[m] <= time) low = m; else high = m; }
    return time >= this.times[high] ? high : low;
  }
  between(time) {
    const i = Math.max(0, Math.min(this.index(time), this.n - 2)), j = Math.min(i + 1, this.n - 1), h = this.times[j] - this.times[i];
    return [i, j, h > 0 ? Math.min(1, Math.max(0, (time - this.times[i]) / h)) : 0];
  }
  pose(i, out) { this.channels.forEach((k, c) => { out[c] = this.values[k][i]; }); return out; }
  sample(time, out) {
    const [i, j, s] = this.between(time);
    this.channels.forEach((k, c) => { const x = this.values[k]; out[c] = x[i] + s * (x[j] - x[i]); });
    return out;
  }
  value(name, time) {
    const x = this.columns.get(name); if (!x) return NaN;
    const [i, j, s] = this.between(time); return x[i] + s * (x[j] - x[i]);
  }
}

// Commands go one after another; of values that change faster, the last ones.
class Link {
  constructor() { this.waiting = []; this.values = null; this.busy = false; }
  send(command) { this.waiting.push(command); this.flush(); }
  set(name, value) { (this.values ||= {})[name] = value; this.flush(); }
  async flush() {
    if (this.busy) return; this.busy = true;
    while (this.waiting.length || this.values) {
      let command = this.waiting.shift(); if (!command) { command = { set: this.values }; this.values = null; }
      try {
        const answer = await fetch(`do${location.search}`, { method: 'POST', body: JSON.stringify(command) });
        if (!answer.ok) say(await answer.text());
      } catch { say(GONE); this.waiting = []; this.values = null; }
    }
    this.busy = false;
  }
}
const AGAIN = '<svg viewBox="0 0 16 16" width="11" height="11" role="img" aria-label="restarts"><path fill="none" stroke="currentColor" stroke-width="1.8" d="M3.2 6A5.2 5.2 0 1 1 2.8 9.5M3 2.2V6h3.8"/></svg>';
const GONE = 'holonom view has ended: start it again';
function say(text) { $('said').textContent = text; $('said').hidden = !text; }

function controls(list, link) {
  const box = Object.assign(document.createElement('section'), { id: 'controls', className: 'card' }); box.setAttribute('aria-label', 'Inputs and parameters');
  const row = (c, k) => {
    const name = escaped(c.name), of = `data-control="${k}" step="any" value="${c.start}"`;
    return `<div class="control" title="${escaped(c.description)}"><span>${name} <small>${escaped(unitOf(c.unit))} ${c.live ? '' : AGAIN}</small></span><input type="range" ${of} min="${c.low}" max="${c.high}" aria-label="${name}"><input type="number" ${of} aria-label="${name} as a number"></div>`;
  };
  box.innerHTML = `<div class="tools"><button id="step" title="One step (right arrow, at the end)">Step</button><button id="restart" title="From the start, with these values">Restart</button><button id="original" title="From the start, with the values of the file">Original values</button>${list.every(c => c.live) ? '' : `<small>${AGAIN} restarts</small>`}<span id="pace"></span></div><p id="said" role="alert" hidden></p>${list.map(row).join('')}`;
  $('plots').prepend(box);
  const show = (k, value, but) => { for (const e of box.querySelectorAll(`[data-control="${k}"]`)) if (e !== but) e.value = e.type === 'number' ? +shown(value) : value; };
  const act = (e, done) => {
    const k = e.target.dataset.control, c = list[k], value = e.target.valueAsNumber; if (!c || !Number.isFinite(value)) return;
    if (e.target.type === 'range' || done) show(k, value, e.target);
    if (done || (c.live && e.target.type === 'range')) link.set(c.name, value);
  };
  box.oninput = e => act(e, false); box.onchange = e => act(e, true);
  $('step').onclick = () => link.send({ step: true }); $('restart').onclick = () => link.send({ reset: true }); $('original').onclick = () => link.send({ original: true });
  return values => list.forEach((c, k) => { if (c.name in values && !box.querySelector(`[data-control="${k}"]:active`)) show(k, values[c.name]); });
}

export async function live(data) {
  const run = new LiveRun(data), link = new Link(), { preview } = data.live; let told = false, dirty = false, since = 0, drawn = JSON.stringify(data.drawings[0]);
  document.body.classList.add('live');
  const show = controls(data.live.controls, link); run.restart(preview);
  const view = page(data, [run], { span: data.live.span, play: on => told || link.send({ play: on }), speed: s => told || link.send({ speed: s }), step: () => link.send({ step: true }) });
  const from = server => { told = true; if (server.speed !== state.speed) state.pace(server.speed); if (server.playing !== state.playing) state.play(server.playing); told = false; };
  const events = new EventSource(`events${location.search}`), on = (name, act) => events.addEventListener(name, e => act(JSON.parse(e.data)));
  on('start', row => {
    const now = JSON.stringify(row.drawing);
    if (now !== drawn) { drawn = now; data.drawings[0] = row.drawing; run.restart(preview); state.choose(0); }
    run.restart([row]); view.newest(true); show(row.set); from(row); say('');
  });
  on('row', row => { run.push(row); dirty = true; state.rows = run.n; pace(row); });
  on('state', from);
  on('failed', d => { say(`stopped at t = ${d.time.toFixed(3)} s: ${d.reason}`); from({ playing: false, speed: state.speed }); });
  on('said', d => say(d.text));
  on('anew', () => location.reload());
  events.onerror = () => { say(GONE); from({ playing: false, speed: state.speed }); };
  let mark = null;                        // time and clock half a second ago, while it cannot keep up
  function pace({ time, late }) {
    const now = performance.now(); if (!late || !mark || time < mark[0]) { mark = late ? [time, now] : null; $('pace').textContent = late ? 'slower than the clock' : ''; return; }
    if (now - mark[1] < 500) return;
    $('pace').textContent = `slower than the clock: ${shown(+(1e5 * (time - mark[0]) / (now - mark[1]) / state.speed).toPrecision(2))} % of this speed`; mark = [time, now];
  }
  addEventListener('pagehide', () => events.close());
  requestAnimationFrame(function tick(now) {
    if (dirty) { dirty = false; const all = now - since > REDRAWN; if (all) since = now; view.newest(all); }
    else if (since && now - since > REDRAWN) { since = 0; view.newest(true); }   // the last rows before a pause
    requestAnimationFrame(tick);
  });
}
