// A DH table on the page, with the column names of its convention.

import HEADINGS from '../../../dh/headings.json';
import { renderMathText } from '../controls/math-text.js';
import { h } from '../dom.js';

/**
 * @param rows [[a, alpha, d, theta as text]]
 * @param read the number of rows that are filled in
 * @param lit the number of the highlighted row, from 1
 */
export function dhTable(convention, rows, { read = rows.length, lit = 0, label = 'DH table' } = {}) {
  return h(
    'table',
    { class: 'kv-dh', 'aria-label': label },
    h('tr', {}, ...HEADINGS[convention].map((heading) => h('th', { scope: 'col' }, ...renderMathText(heading)))),
    ...rows.map((row, k) =>
      h(
        'tr',
        k + 1 === lit ? { class: 'kv-lit' } : {},
        h('th', { scope: 'row' }, `${k + 1}`),
        ...row.map((cell) => h('td', {}, ...(k < read ? renderMathText(cell) : ['·']))),
      ),
    ),
  );
}
