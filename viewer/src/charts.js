// Plots over time with one cursor: click to seek, drag to zoom, and their numbers as CSV.
import uPlot from 'uplot';
import { PALETTE, escaped, save, shown, unitOf } from './text.js';

const FLOOR = 1e-18;
const DASHES = [[], [7, 4], [2, 3], [10, 3, 2, 3]];

export class Charts {
  constructor(root, data, all, seek) {    // all: runs of the page; runs: those that are shown
    Object.assign(this, { root, all, seek, name: data.name, list: [], time: 0, runs: [], units: new Map(data.variables.map(v => [v.name, unitOf(v.unit)])) });
  }
  show(runs) { this.runs = runs; this.redraw(); }
  add(spec, first = false) {
    const names = spec.names.filter(n => this.all.some(r => r.columns.has(n))); if (!names.length) return null;
    const box = document.createElement('figure'), item = { box, spec: { ...spec, names } }, units = [...new Set(names.map(n => this.units.get(n)))].filter(Boolean).join(', ');
    box.className = 'card chart'; item.title = spec.title || names.join(', ');
    box.innerHTML = `<figcaption><span>${escaped(item.title)}<span class="of"></span>${units ? ` <small>[${escaped(units)}]</small>` : ''}</span><span class="chips"></span><button class="plain csv" title="Save the numbers of this plot as CSV" aria-label="Save the numbers of ${escaped(item.title)} as CSV">CSV</button><button class="plain close" title="Remove this plot" aria-label="Remove the plot ${escaped(item.title)}">×</button></figcaption><div class="plot"></div>`;
    if (first) { this.root.prepend(box); this.list.unshift(item); } else { this.root.append(box); this.list.push(item); }
    box.querySelector('.close').onclick = () => { item.plot?.destroy(); box.remove(); this.list = this.list.filter(x => x !== item); this.resize(); };
    box.querySelector('.csv').onclick = () => save(`${this.name}_${item.title.replace(/[^\w.]+/g, '_')}.csv`, this.csv(item.spec.names.concat(spec.against || [])), 'text/csv');
    this.draw(item);
    return item;
  }
  csv(names) {                            // of all runs that are shown, one below the other
    const many = this.runs.length > 1, lines = [];
    for (const r of this.runs) {
      const have = names.filter(n => r.columns.has(n)), columns = have.map(n => r.columns.get(n));
      if (!lines.length) lines.push([...(many ? ['run'] : []), 'time', ...have].map(x => /[",]/.test(x) ? `"${x.replace(/"/g, '""')}"` : x).join(','));
      for (let i = 0; i < r.n; i++) lines.push([...(many ? [`"${r.label}"`] : []), r.t[i], ...columns.map(c => c[i])].join(','));
    }
    return lines.join('\n') + '\n';
  }
  // What a plot draws: lines with a run, a colour, and values of their own. A stack is of one run, the first or the other one.
  traces({ names, stack, against, log, of = 0 }) {
    if (stack) return this.runs[of] ? stacked(this.runs[of], names, against || []) : [];
    return this.runs.flatMap((run, r) => names.filter(n => run.columns.has(n)).map((n, k) => ({
      run, label: short(n, names), dash: DASHES[r % 4], colour: PALETTE[(r * names.length + k) % PALETTE.length],
      values: log ? Array.from(run.columns.get(n), x => x ? Math.max(Math.abs(x), FLOOR) : null) : run.columns.get(n), read: t => run.value(n, t),
    })));
  }
  draw(item) {
    const { spec, box } = item, { log, stack } = spec, style = getComputedStyle(document.body), ink = name => style.getPropertyValue(name).trim(), host = box.querySelector('.plot'), traces = item.traces = this.traces(spec);
    item.plot?.destroy(); item.plot = null; box.hidden = !traces.length; if (box.hidden) return;
    box.querySelector('.of').textContent = stack && this.runs.length > 1 ? ` · ${traces[0].run.label}` : '';
    const same = traces.every(x => x.run === traces[0].run), values = same ? [traces[0].run.t, ...traces.map(x => x.values)] : uPlot.join(traces.map(x => [Array.from(x.run.t), Array.from(x.values)]));
    const chips = box.querySelector('.chips'), labels = [...new Set(traces.map(x => x.label))], chip = (x, name) => `<i title="${escaped(x.run.label)}" style="border-top-color:${x.colour}${x.dash?.length ? ';border-top-style:dashed' : ''}"></i>${escaped(name)} <b data-trace="${traces.indexOf(x)}"></b>`;
    chips.classList.toggle('many', traces.length > 1);             // a name, and its number in each run
    chips.innerHTML = labels.map(label => `<span>${traces.filter(x => x.label === label).map((x, k) => chip(x, k || labels.length === 1 ? '' : label)).join(' ')}</span>`).join('');
    item.numbers = traces.map((x, k) => chips.querySelector(`[data-trace="${k}"]`));
    const axis = { stroke: ink('--soft'), grid: { stroke: ink('--grid'), width: 1 }, ticks: { stroke: ink('--grid') }, font: '11px system-ui' }, head = ink('--accent');
    const decades = (u, k, low, high) => { const a = Math.round(Math.log10(low)), b = Math.round(Math.log10(high)), by = Math.ceil((b - a) / 4), out = []; for (let p = a; p <= b; p += by) out.push(10 ** p); return out; };
    const range = (u, a, b) => { const size = Math.max(Math.abs(a), Math.abs(b)), d = b - a > 1e-6 * size ? .06 * (b - a) : .5 * size || 1e-3; return [stack && a >= 0 ? 0 : a - d, b + d]; };
    item.plot = new uPlot({
      width: Math.max(200, host.clientWidth), height: this.height(), legend: { show: false }, pxAlign: 0, padding: [8, 18, 0, 0],
      cursor: { sync: { key: 'time' }, drag: { x: true, y: false } },
      scales: { x: { time: false }, y: log ? { distr: 3, range: (u, a, b) => [10 ** Math.floor(Math.log10(a || FLOOR)), 10 ** Math.ceil(Math.log10(Math.max(b || 0, 10 * (a || FLOOR))))] } : { range } },
      axes: [{ ...axis, size: 26, gap: 3, values: (u, v) => apart(v) }, { ...axis, size: 68, ...(log ? { splits: decades, filter: (u, v) => v, values: (u, v) => v.map(x => x.toExponential(0)) } : { space: 18, values: (u, v) => apart(v) }) }],
      series: [{}, ...traces.map(x => ({ label: x.label, stroke: x.colour, fill: x.fill, dash: x.dash, width: x.width || 1.6, spanGaps: !log, points: { show: false } }))],
      bands: stack ? traces.slice(1).filter(x => x.fill).map((x, k) => ({ series: [k + 2, k + 1], fill: x.fill })) : [],
      hooks: { draw: [u => { const x = u.valToPos(this.time, 'x', true), { left, top, width, height } = u.bbox; if (x < left - 1 || x > left + width + 1) return; u.ctx.save(); u.ctx.setLineDash([]); u.ctx.strokeStyle = head; u.ctx.lineWidth = 1.5 * devicePixelRatio; u.ctx.beginPath(); u.ctx.moveTo(x, top); u.ctx.lineTo(x, top + height); u.ctx.stroke(); u.ctx.restore(); }] },
    }, values, host);
    const over = item.plot.over; let down = 0;
    over.addEventListener('mousedown', e => { down = e.clientX; });
    over.addEventListener('mouseup', e => { if (Math.abs(e.clientX - down) < 4) this.seek(item.plot.posToVal(e.clientX - over.getBoundingClientRect().left, 'x')); });
    this.write(item);
  }
  update() {                              // new rows of a live run
    for (const item of this.visible()) { item.traces = this.traces(item.spec); item.plot.setData([this.runs[0].t, ...item.traces.map(x => x.values)]); this.write(item); }
  }
  redraw() { this.list.forEach(item => this.draw(item)); }
  visible() { return this.list.filter(item => item.plot); }
  height() { const n = this.list.filter(item => !item.box.hidden).length || 1, room = this.root.parentElement.clientHeight - 40; return Math.max(110, Math.min(190, (room - 46 * n) / n)); }
  resize() { for (const item of this.visible()) { const width = item.box.querySelector('.plot').clientWidth; if (width > 50) item.plot.setSize({ width, height: this.height() }); } }
  write(item) { item.traces.forEach((x, k) => { item.numbers[k].textContent = shown(x.read(this.time)); }); }
  moveTo(time, quick) {                   // while it plays, one plot a frame
    this.time = time; const list = this.visible(); if (!list.length) return;
    const now = quick ? [list[this.turn = ((this.turn || 0) + 1) % list.length]] : list;
    for (const item of now) { item.plot.redraw(false, false); this.write(item); }
  }
}
function apart(ticks) {                   // numbers with as many digits as tell them apart
  const texts = ticks.map(x => shown(x)); if (new Set(texts).size === texts.length) return texts;
  const digits = Math.ceil(Math.log10(Math.max(...ticks.map(Math.abs)) / (ticks[1] - ticks[0]))) + 1; return ticks.map(x => shown(x, digits));
}
// Energies on top of each other, and what they have to sum up to: what there was, and the work done since.
function stacked(run, names, against) {
  const total = new Float64Array(run.n), out = [], spans = names.filter(n => run.columns.has(n)).map(n => [n, run.columns.get(n)]).map(([n, x]) => [n, x, x.reduce((a, b) => Math.min(a, b)), x.reduce((a, b) => Math.max(a, b))]);
  const size = Math.max(...spans.map(([, , a, b]) => b - a));          // what changes
  spans.forEach(([n, column, least], k) => {
    const level = n.endsWith('.potential') && size > 1e-9 * Math.abs(least), low = level ? least : Math.min(0, least), values = new Float64Array(run.n);
    for (let i = 0; i < run.n; i++) values[i] = total[i] += column[i] - low;
    const colour = PALETTE[k % PALETTE.length]; out.push({ run, label: short(n, names) + (level && low ? ' above its least' : ''), colour, fill: colour + '66', values, read: t => run.value(n, t) - low, width: 1 });
  });
  const begin = total[0] || 0, line = Array.from(total, (x, i) => begin + against.reduce((s, n) => s + (run.columns.get(n)?.[i] || 0) - (run.columns.get(n)?.[0] || 0), 0));
  out.push({ run, label: 'at the start + work', colour: '#d9480f', dash: [4, 4], width: 2, values: line, read: t => line[run.index(t)] });
  return out;
}
function short(name, all) {               // what differs: energy.kinetic is kinetic
  const parts = name.split('.'); let k = 0;
  while (k < parts.length - 1 && all.length > 1 && all.every(n => n.split('.')[k] === parts[k])) k++;
  return parts.slice(k).join('.');
}
