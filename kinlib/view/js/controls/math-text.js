// Sentences that contain symbols as Python writes them: z_{i-1}, O_1, alpha_3. On the page they are set as symbols.
import { h } from '../dom.js';

const NAME = /\b(alpha|theta|[A-Za-z])_(\{[^}]+\}|[0-9inxz]+)|\b(alpha|theta|pi)\b/g;
const GREEK = { alpha: 'α', theta: 'θ', pi: 'π' };

/** The DOM nodes of a sentence. */
export function renderMathText(sentence) {
  const text = sentence.replace(/(^|[\s(])-(?=\d| )/g, '$1−');
  const nodes = [];
  let done = 0;
  for (const found of text.matchAll(NAME)) {
    const [whole, base, index, word] = found;
    nodes.push(text.slice(done, found.index), name(base ?? word, index?.replace(/[{}]/g, '')));
    done = found.index + whole.length;
  }
  return [...nodes, text.slice(done)].filter((node) => node !== '');
}

/** Set a sentence in an element. A screen reader announces changes, so an unchanged one is not set again. */
export function setSentence(element, sentence) {
  if (element.dataset.text !== sentence) element.replaceChildren(...renderMathText(sentence));
  element.dataset.text = sentence;
}

function name(base, index) {
  return h(
    'span',
    { class: 'kv-name' },
    h('i', {}, GREEK[base] ?? base),
    ...(index ? [h('sub', {}, index.replace('-', '−'))] : []),
  );
}
