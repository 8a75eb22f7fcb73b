import 'uplot/dist/uPlot.min.css';
import './style.css';
import { inflated, readRun } from './data.js';
import { live } from './live.js';
import { page, state } from './page.js';
import { $ } from './text.js';

$('cut').remove();                        // what a page says whose end, these scripts, is missing

async function report(data) {
  const before = performance.now();
  const runs = await Promise.all(data.runs.map((meta, k) => readRun(meta, data.kinds, k, id => $(id)?.textContent ?? '')));
  state.decoded = performance.now() - before;
  for (let k = 0; k < 3 * runs.length; k++) $(`block${k}`)?.remove();
  page(data, runs);
}
async function show() {
  let data;
  try { data = JSON.parse(new TextDecoder().decode(await inflated($('data').textContent))); } catch { throw new Error('data, what the runs are of, is damaged; the file was cut off or changed: write the report again'); }
  return (data.live ? live : report)(data);
}
show().catch(error => {
  state.error = String(error.stack || error);
  const p = Object.assign(document.createElement('p'), { className: 'broken', textContent: `This page cannot be shown: ${error.message}` });
  p.setAttribute('role', 'alert'); document.body.prepend(p);
});
