// The page: stage, plots and tables of some runs, moved by one time. Reports and live pages share it.
import { Vector3 } from 'three';
import { Charts } from './charts.js';
import { Stage } from './stage.js';
import { cards, tables } from './tables.js';
import { $, escaped, save, shown, unitOf } from './text.js';

const icon = d => `<svg viewBox="0 0 16 16" width="14" height="14" aria-hidden="true"><path fill="currentColor" d="${d}"/></svg>`;
const ICONS = {
  play: icon('M4 2.5v11l9.5-5.5z'), pause: icon('M3.5 2.5h3.2v11H3.5zM9.3 2.5h3.2v11H9.3z'), back: icon('M3 2.5h2v11H3zM13 2.5v11L5.6 8z'),
  shot: icon('M5.5 3l-.9 1.5H2v8.5h12V4.5h-2.6L10.5 3zM8 6a2.6 2.6 0 110 5.2A2.6 2.6 0 018 6z'), theme: icon('M8 1.5a6.5 6.5 0 100 13 6.5 6.5 0 000-13zM8 3v10A5 5 0 018 3z'),
};
const SPEEDS = [.001, .01, .02, .05, .1, .2, .5, 1, 2, 5, 10, 20, 50, 100];
const LABELS = 80;

export const state = window.holonom = { ready: false, time: 0, playing: false, speed: 1, frames: 0, first: 0 };

// options: `play(on)`, `speed(s)` and `step()` of a live page, whose rows come by themselves; `still`: do not begin to play.
export function page(data, runs, options = {}) {
  const began = performance.now(), hash = new URLSearchParams(location.hash.slice(1));
  const drawingOf = run => data.drawings[run.meta.drawing ?? 0];
  let run = runs[0], other = null, beside = true, from = 0, clock = 0, range = null, t0, t1;
  const stage = state.stage = new Stage($('canvas'), drawingOf(run), { painted: hash.has('painted') });
  const charts = state.charts = new Charts($('charts'), data, runs, t => seek(t));
  if (stage.flat) for (const name of ['side', 'top']) document.querySelector(`[data-view=${name}]`).hidden = true;
  $('description').textContent = data.description;
  $('messages').innerHTML = [...(data.warnings || []), ...(data.notes || [])].map(s => `<p>${escaped(s)}</p>`).join('');

  // ------------------------------------------------------------------ time
  const slider = $('time');
  function limits() {
    const all = other ? [run, other] : [run]; t0 = Math.min(...all.map(r => r.t[0])); t1 = Math.max(...all.map(r => r.t[r.n - 1]));
    slider.min = t0; slider.max = t1;
  }
  function move(time, quick) {
    state.time = time; stage.moveTo(time); charts.moveTo(time, quick);
    const text = `${time.toFixed(t1 - t0 > 100 ? 1 : 3)} s`;
    slider.value = time; slider.setAttribute('aria-valuetext', text.replace(' s', ' seconds')); $('now').textContent = text; $('clock').textContent = `t = ${text}`;
  }
  const base = () => { from = state.time; clock = performance.now(); };
  let past = false;                       // whether a live page shows what was before
  function seek(time) { past = time < t1; if (options.play && past && state.playing) play(false); move(Math.min(t1, Math.max(t0, time))); if (state.playing) base(); }
  function play(on) {
    state.playing = on; $('play').innerHTML = on ? ICONS.pause : ICONS.play; $('play').setAttribute('aria-label', on ? 'Pause' : 'Play');
    if (options.play) { past = past && !on; return options.play(on); }
    if (!on) { $('live').textContent = `paused at ${state.time.toFixed(2)} seconds`; return; }
    const [a, b] = range || [t0, t1]; if (state.time >= b - 1e-9 || state.time < a) move(a);
    base(); stage.wake?.();
  }
  const toggle = () => play(!state.playing);
  function loop(a, b) {                   // times between which it repeats; none: all
    range = a === undefined || b - a < 1e-9 ? null : [a, b]; const mark = $('range'); mark.hidden = !range; if (!range) return;
    $('loop').checked = true; mark.style.left = `${100 * (a - t0) / (t1 - t0)}%`; mark.style.right = `${100 * (t1 - b) / (t1 - t0)}%`;
  }
  const loopFrom = () => loop(state.time, range && range[1] > state.time ? range[1] : t1), loopTo = () => loop(range && range[0] < state.time ? range[0] : t0, state.time);

  // ------------------------------------------------------------------ runs
  function choose(k, with_ = other ? runs.indexOf(other) : -1) {
    run = runs[k]; other = with_ >= 0 && with_ !== k ? runs[with_] : null; state.run = run; state.other = other;
    limits(); $('run').value = k; $('other').value = other ? with_ : -1; loop();
    const list = other ? [run, other] : [run];
    stage.show(list.map(r => ({ run: r, drawing: drawingOf(r) })), beside); charts.show(list); charts.resize(); label();
    cards(run); const why = run.meta.facts?.[0]?.title; $('why').textContent = why; $('why').hidden = !why; tables(data, runs, run, i => choose(i)); view('fit'); move(Math.min(t1, Math.max(t0, state.time)));
  }
  const names = new Vector3(); let labels = [], tags = [];
  function label() {
    const places = new Map(), drawing = drawingOf(run); $('labels').innerHTML = '';
    for (const j of drawing.joints) places.set(j.name, j.place);
    for (const s of drawing.solids) if (s.owner && s.owner !== 'ground' && !places.has(s.owner)) places.set(s.owner, { frame: s.frame, at: s.at || [0, 0, 0] });
    for (const l of drawing.links) places.set(l.name, { between: l.ends, share: .5 });
    labels = [...places].slice(0, LABELS).map(([name, place]) => { const e = document.createElement('span'); e.textContent = name; $('labels').append(e); return [e, place, 0]; });
    $('tags').innerHTML = '';
    tags = !other ? [] : [run, other].map((r, k) => { const e = document.createElement('span'); e.textContent = r.label; if (!beside) e.className = k ? 'ghost' : ''; $('tags').append(e); return e; });
  }
  function view(name) { stage.follow(document.querySelector('[data-layer=follow]').checked); stage.view(name); }

  // ------------------------------------------------------------------ controls
  for (const k of ['play', 'back', 'shot', 'theme']) $(k).innerHTML = ICONS[k];
  $('play').onclick = toggle; $('back').onclick = () => seek(range ? range[0] : t0); slider.oninput = () => seek(+slider.value); $('from').onclick = loopFrom; $('to').onclick = loopTo;
  $('speed').innerHTML = SPEEDS.map(s => `<option value="${s}">${s < 1 ? `1/${Math.round(1 / s)}` : s}×</option>`).join('');
  const speed = s => { state.speed = s; $('speed').value = s; base(); options.speed?.(s); };
  $('speed').onchange = e => speed(+e.target.value);
  for (const b of document.querySelectorAll('[data-view]')) b.onclick = () => { stage.view(b.dataset.view); };
  const layers = [...document.querySelectorAll('[data-layer]')], box = name => layers.find(x => x.dataset.layer === name);
  for (const c of layers) c.onchange = () => {
    const name = c.dataset.layer;
    if (name === 'follow') { stage.follow(c.checked); move(state.time); stage.view('fit'); } else if (name === 'names') { $('labels').hidden = !c.checked; stage.dirty = true; } else { stage.layer(name, c.checked); move(state.time); }
  };
  const theme = dark => { document.documentElement.dataset.theme = dark ? 'dark' : 'light'; state.dark = dark; stage.theme(dark); charts.redraw(); };
  const flip = () => theme(!state.dark);
  $('theme').onclick = flip;
  $('shot').onclick = () => save(`${data.name}_${state.time.toFixed(3)}.png`, picture(), 'image/png');
  const picture = state.picture = () => {  // on the colour of the page, as a transparent picture is black in some programs
    stage.dirty = true; stage.render(); const c = document.createElement('canvas'), from = $('canvas'); c.width = from.width; c.height = from.height;
    const g = c.getContext('2d'); g.fillStyle = getComputedStyle(document.body).getPropertyValue('--card'); g.fillRect(0, 0, c.width, c.height); g.drawImage(from, 0, 0);
    return c.toDataURL('image/png');
  };
  $('variables').innerHTML = data.variables.filter(v => run.columns.has(v.name)).map(v => `<option value="${escaped(v.name)}">${escaped(v.description)}</option>`).join('');
  $('find').onchange = e => { const wanted = e.target.value.split(/[\s,]+/).filter(n => run.columns.has(n)); if (wanted.length && charts.add({ names: wanted }, true)) { e.target.value = ''; charts.resize(); } };
  $('csv').onclick = () => save(`${data.name}.csv`, charts.csv([...run.columns.keys()]), 'text/csv');
  if (runs.length > 1) {
    $('compare').hidden = false;
    const list = runs.map((r, k) => `<option value="${k}">${escaped(r.label)}</option>`).join(''); $('run').innerHTML = list; $('other').innerHTML = `<option value="-1">none</option>${list}`;
    $('run').onchange = e => choose(+e.target.value); $('other').onchange = e => choose(runs.indexOf(run), +e.target.value);
    $('layout').onchange = e => { beside = e.target.value === 'beside'; choose(runs.indexOf(run)); };
  }
  addEventListener('keydown', e => {
    const typing = e.target.matches('input:not([type=range]):not([type=checkbox]), select, textarea, #controls input'), presses = e.target.matches('button, summary, input[type=checkbox]');
    if (typing || e.ctrlKey || e.metaKey || e.altKey || (e.key === ' ' && presses)) return;
    const i = run.index(state.time), on = run.t[i] < state.time - 1e-12, far = (t1 - t0) / 20;
    const keys = {
      ' ': toggle, Home: () => seek(t0), End: () => seek(t1), d: flip, l: () => $('loop').click(), '[': loopFrom, ']': loopTo, '\\': () => loop(),
      ArrowRight: () => options.step && i === run.n - 1 ? options.step() : seek(e.shiftKey ? state.time + far : run.t[Math.min(run.n - 1, i + 1)]), ArrowLeft: () => seek(e.shiftKey ? state.time - far : run.t[on ? i : Math.max(0, i - 1)]),
      0: () => stage.view('fit'), 1: () => stage.view('iso'), 2: () => stage.view('front'), 3: () => stage.view('side'), 4: () => stage.view('top'),
      n: () => box('names').click(), p: () => box('traces').click(), f: () => box('forces').click(), j: () => box('joints').click(),
    };
    if (keys[e.key]) { keys[e.key](); e.preventDefault(); }
  });
  tips();
  function tips() {
    let last = 0; const tip = $('tip'), canvas = stage.canvas;
    canvas.addEventListener('pointermove', e => {
      if (e.buttons || performance.now() - last < 60) return; last = performance.now();
      const name = stage.picked(e.offsetX, e.offsetY); tip.hidden = !name; if (!name) return;
      const own = data.variables.filter(v => v.name.startsWith(`${name}.`) && run.columns.has(v.name)).slice(0, 8);
      tip.innerHTML = `<b>${escaped(name)}</b>` + own.map(v => `<div>${escaped(v.name.slice(name.length + 1))} <span>${shown(run.value(v.name, state.time))} ${escaped(unitOf(v.unit))}</span></div>`).join('');
      tip.style.transform = `translate(${Math.max(0, Math.min(e.offsetX + 14, stage.width - 190))}px, ${Math.max(0, Math.min(e.offsetY + 14, stage.height - 20 * own.length - 40))}px)`;
    });
    canvas.addEventListener('pointerleave', () => { tip.hidden = true; });
  }
  const fit = () => { const b = $('stage').getBoundingClientRect(); if (b.width) stage.resize(Math.round(b.width), Math.round(b.height)); if (state.ready && !stage.moved) stage.view('fit'); charts.resize(); };
  new ResizeObserver(fit).observe($('stage'));
  addEventListener('beforeprint', () => { play(false); state.printed = state.dark; if (state.dark) flip(); fit(); stage.dirty = true; stage.render(); });
  addEventListener('afterprint', () => { if (state.printed) flip(); });

  // ------------------------------------------------------------------ begin
  const prefers = query => matchMedia(query).matches;
  document.documentElement.dataset.theme = prefers('(prefers-color-scheme: dark)') ? 'dark' : 'light'; state.dark = document.documentElement.dataset.theme === 'dark';
  stage.show([{ run, drawing: drawingOf(run) }], false); fit(); charts.runs = [run]; limits();
  if (stage.travels || drawingOf(run).view?.follow) box('follow').checked = true;
  for (const p of data.plots) { charts.add(p); if (p.stack && runs.length > 1) charts.add({ ...p, of: 1 }); }
  charts.resize();
  choose(0, data.compare && runs.length > 1 ? 1 : -1); view('iso'); if (stage.flat) view('front'); theme(state.dark);
  const span = options.span ?? t1 - t0; speed(span >= 2 && span <= 30 ? 1 : SPEEDS.reduce((a, b) => Math.abs(Math.log(span / b / 8)) < Math.abs(Math.log(span / a / 8)) ? b : a, 1));
  $('foot').innerHTML = '<kbd>space</kbd> play <kbd>←</kbd> <kbd>→</kbd> step <kbd>Home</kbd> <kbd>End</kbd> <kbd>[</kbd> <kbd>]</kbd> loop range <kbd>0</kbd>–<kbd>4</kbd> views <kbd>n</kbd> names <kbd>f</kbd> forces <kbd>d</kbd> dark';
  let asked = false;
  const wake = stage.wake = () => { if (!asked) { asked = true; requestAnimationFrame(frame); } };
  function frame(now) {
    asked = false;
    if (state.playing && !options.play) {
      const [a, b] = range || [t0, t1]; let t = from + Math.max(0, now - clock) / 1000 * state.speed;
      if (t >= b) { if ($('loop').checked) { t = a + (t - b) % Math.max(b - a, 1e-9); from = t; clock = now; } else { t = b; play(false); } }
      const before = performance.now(); move(t, true); state.script = performance.now() - before; state.frames++;
    }
    if (stage.render()) {
      if (!state.first) state.first = performance.now();
      tags.forEach((e, k) => { const [x, y] = beside ? stage.above(k, names) : [stage.width / 2, 26 + 22 * k]; e.style.transform = `translate(${x.toFixed(1)}px, ${y.toFixed(1)}px) translate(-50%, -130%)`; });
      if (!$('labels').hidden) for (const [e, place] of labels) { const [x, y, z] = stage.screen(place, names); e.style.transform = `translate(${x.toFixed(1)}px, ${y.toFixed(1)}px)`; e.style.display = z < 1 ? '' : 'none'; }
    }
    if (state.playing && !options.play) wake();
  }
  move(t0);
  if (hash.has('t')) seek(+hash.get('t')); else if (!options.still && !prefers('(prefers-reduced-motion: reduce)')) play(true);
  Object.assign(state, { seek, play, pace: speed, choose, loop, range: () => range, flip, ready: true, loaded: performance.now() - began });
  // For a live page: new rows at the end of the run.
  return { newest(all) {                  // all: plots and paths, too
    limits(); if (past) return;
    move(t1, true); if (!all) return;
    charts.update(); stage.trace(); if (stage.left()) view('fit'); move(t1);
  } };
}
