// The pose of the tool as a matrix, with its columns in the colours of the axes, and a button that copies it as Python.
import { button, copyToClipboard, formatNumber, h, uniqueId } from '../dom.js';

const COLUMNS = [
  ['x̂', 'x'],
  ['ŷ', 'y'],
  ['ẑ', 'z'],
  ['p', 'p'],
];

/** @returns { element, update(q, T) } */
export function poseReadout() {
  let now = { q: [], T: [] };
  const cells = Array.from({ length: 16 }, () => h('td'));
  const copied = h('span', { class: 'kv-small', role: 'status' });
  const copy = async () => {
    copied.textContent = (await copyToClipboard(formatPython(now))) ? 'copied' : 'no access to the clipboard';
    setTimeout(() => {
      copied.textContent = '';
    }, 2000);
  };
  const id = uniqueId('pose');
  const element = h(
    'div',
    { class: 'kv-pose' },
    h(
      'div',
      { class: 'kv-head' },
      h('span', { id, class: 'kv-title' }, 'Tool pose ', h('i', {}, 'T'), '(', h('i', {}, 'q'), ')'),
      copied,
      button('Copy', copy, { class: 'kv-copy', title: 'Copy q and T(q) as Python' }),
    ),
    h(
      'table',
      { 'aria-labelledby': id },
      h(
        'thead',
        {},
        h('tr', {}, ...COLUMNS.map(([text, name]) => h('th', { scope: 'col', class: `kv-${name}` }, text))),
      ),
      h('tbody', {}, ...[0, 1, 2, 3].map((row) => h('tr', {}, ...cells.slice(4 * row, 4 * row + 4)))),
    ),
    h('p', { class: 'kv-note' }, 'pose of {b} in {s}; lengths in metres'),
  );
  return {
    element,
    update(q, T) {
      now = { q, T };
      T.flat().forEach((value, k) => {
        const text = formatNumber(value, 4);
        if (cells[k].textContent !== text) cells[k].textContent = text;
      });
    },
  };
}

/** q and T(q) as Python code with all digits, ready to be pasted into a cell. */
export function formatPython({ q, T }) {
  const row = (values) => `[${values.map((value) => `${value + 0}`).join(', ')}]`;
  return `q = np.array(${row(q)})\nT = np.array([\n${T.map((values) => `    ${row(values)},`).join('\n')}\n])`;
}
