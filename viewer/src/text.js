// Small things that several parts of the page write with.
export const $ = id => document.getElementById(id);
export const escaped = s => String(s ?? '').replace(/[&<>"]/g, c => ({ '&': '&amp;', '<': '&lt;', '>': '&gt;', '"': '&quot;' }[c]));
export function shown(x, digits = 0) {
  if (x === null || x === undefined || Number.isNaN(x)) return '–';
  if (typeof x !== 'number') return String(x);
  const size = Math.abs(x);
  return size && (size >= 1e5 || size < 1e-3) ? x.toExponential(Math.max(2, digits - 1)) : String(+x.toPrecision(Math.max(5, digits)));
}
export const unitOf = unit => unit && unit !== '1' ? unit : '';
export function save(name, content, type) {
  const url = typeof content === 'string' && content.startsWith('data:') ? content : URL.createObjectURL(new Blob([content], { type }));
  const link = Object.assign(document.createElement('a'), { href: url, download: name });
  link.click();
  if (url.startsWith('blob:')) setTimeout(() => URL.revokeObjectURL(url), 1000);
}
export const PALETTE = ['#2f6fb2', '#e07b26', '#5a9a3c', '#8b56a0', '#2f9aa0', '#c04c5c', '#b59422', '#5b6b86'];
