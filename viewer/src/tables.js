// Cards and tables below the animation: what is true of a run, in numbers.
import { $, escaped, shown, unitOf } from './text.js';

const table = (label, head, rows) => `<div class="scroll" tabindex="0" role="group" aria-label="${escaped(label)}"><table><thead><tr>${head.map((h, k) => `<th scope="col"${rows[0]?.split('<td')[k + 1].startsWith(' class="n"') ? ' class="n"' : ''}>${escaped(h)}</th>`).join('')}</tr></thead><tbody>${rows.join('')}</tbody></table></div>`;
const section = (title, body, open) => `<details class="card"${open ? ' open' : ''}><summary>${escaped(title)}</summary>${body}</details>`;
const number = x => `<td class="n">${escaped(shown(x))}</td>`, code = x => `<td><code>${escaped(x)}</code></td>`, cell = x => `<td>${escaped(x)}</td>`;

export function cards(run) {
  $('facts').innerHTML = (run.meta.facts || []).map(f => `<div class="fact ${escaped(f.level)}" title="${escaped(f.title)}"><b>${escaped(f.value)}</b><span>${escaped(f.label)}</span></div>`).join('');
}

export function tables(data, runs, run, choose) {
  const parts = [], number_of = runs.indexOf(run), given = v => run.meta.settings?.[v.name] ?? v.start;
  if (runs.length > 1) {
    const names = Object.keys(data.runs[0].parameters || {}), labels = data.runs[0].facts.map(f => f.label.startsWith('t =') ? 'end' : f.label);
    parts.push(section('Runs', table('Runs', ['run', ...names, ...labels], data.runs.map((r, k) => `<tr data-run="${k}" tabindex="0"${k === number_of ? ' class="on" aria-current="true"' : ''}>${cell(r.label)}${names.map(n => number(r.parameters[n])).join('')}${r.facts.map(f => `<td class="n" title="${escaped(f.title)}">${escaped(f.value)}</td>`).join('')}</tr>`)), true));
  }
  const rows = role => data.variables.filter(v => role.includes(v.role) && v.start !== undefined).map(v => `<tr>${code(v.name)}${number(given(v))}${cell(unitOf(v.unit))}${cell(v.description)}</tr>`);
  const own = rows(['parameter', 'input']), settings = rows(['setting']), head = ['name', 'value', 'unit', 'meaning'];
  if (own.length && !data.live) parts.push(section(`Parameters and inputs (${own.length})`, table('Parameters and inputs', head, own), own.length <= 30));
  if (settings.length) parts.push(section('Settings of the solver', table('Settings of the solver', head, settings), false));
  const statistics = data.variables.filter(v => run.columns.has(v.name)).map(v => {
    const x = run.columns.get(v.name); let low = Infinity, high = -Infinity, sum = 0;
    for (let i = 0; i < run.n; i++) { if (x[i] < low) low = x[i]; if (x[i] > high) high = x[i]; sum += x[i]; }
    return `<tr>${code(v.name)}${[x[0], low, high, sum / run.n, x[run.n - 1]].map(number).join('')}${cell(unitOf(v.unit))}${cell(v.description)}</tr>`;
  });
  if (statistics.length && !data.live) parts.push(section(`Variables (${statistics.length})`, table('Variables', ['name', 'start', 'least', 'largest', 'mean', 'end', 'unit', 'meaning'], statistics), false));
  $('tables').innerHTML = parts.join('');
  for (const row of document.querySelectorAll('tr[data-run]')) {
    row.onclick = () => choose(+row.dataset.run);
    row.onkeydown = e => { if (e.key === 'Enter') choose(+row.dataset.run); };
  }
}
