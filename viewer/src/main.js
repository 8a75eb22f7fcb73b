import 'uplot/dist/uPlot.min.css';
import './style.css';
import { readRun } from './data.js';
import { live } from './live.js';
import { page, state } from './page.js';
import { $ } from './text.js';

async function report(data) {
  const before = performance.now();
  const runs = await Promise.all(data.runs.map((meta, k) => readRun(meta, data.kinds, k, id => $(id)?.textContent ?? '')));
  state.decoded = performance.now() - before;
  for (let k = 0; k < 3 * runs.length; k++) $(`block${k}`)?.remove();
  page(data, runs);
}
const data = JSON.parse($('data').textContent);
(data.live ? live : report)(data).catch(error => {
  state.error = String(error.stack || error);
  const p = Object.assign(document.createElement('p'), { className: 'broken', textContent: `This page cannot be shown: ${error.message}` });
  p.setAttribute('role', 'alert'); document.body.prepend(p);
});
