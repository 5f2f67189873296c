/** Make an element: h('button', { type: 'button', onclick }, 'Play'). Names that begin with on are event listeners. */
export function h(tag, settings = {}, ...children) {
  const element = document.createElement(tag);
  for (const [name, value] of Object.entries(settings)) {
    if (value === undefined || value === false) continue;
    if (name.startsWith('on')) element.addEventListener(name.slice(2), value);
    else element.setAttribute(name, value === true ? '' : value);
  }
  element.append(...children);
  return element;
}

/** Attributes that keep JupyterLab from handling the arrow keys while the element has the focus. */
const SUPPRESS = 'data-lm-suppress-shortcuts';
const SUPPRESSED = `[${SUPPRESS}]`;
export const NO_SHORTCUTS = { [SUPPRESS]: 'true' };

/** Ctrl+S saves the notebook wherever the focus is: JupyterLab, which listens after this, must find no such element. */
addEventListener(
  'keydown',
  (event) => {
    const held = (event.ctrlKey || event.metaKey) && event.key === 's' && event.target.closest?.(SUPPRESSED);
    if (!held) return;
    held.removeAttribute(SUPPRESS);
    setTimeout(() => held.setAttribute(SUPPRESS, 'true'));
  },
  true,
);

/** Make a button: button('▶ Play', start, { class: 'kv-play' }). */
export function button(content, onclick, settings = {}) {
  return h('button', { type: 'button', ...NO_SHORTCUTS, onclick, ...settings }, ...[content].flat());
}

/** The name of a control for screen readers, which is shown when the pointer rests on it. */
export const named = (name) => ({ 'aria-label': name, title: name });

/** Make a slider with the whole numbers from 0 to max. */
export function slider(max, oninput, settings = {}) {
  const range = { type: 'range', min: 0, max, step: 1, oninput: () => oninput(Number(input.value)) };
  const input = h('input', { ...NO_SHORTCUTS, ...range, ...settings });
  return input;
}

/** Move a slider, fill it up to its value, and say what it is at. */
export function moveSlider(input, value, text) {
  input.value = value;
  input.style.setProperty('--share', `${(100 * value) / Math.max(1, input.max)}%`);
  input.setAttribute('aria-valuetext', text);
}

const KEY_STEPS = { ArrowRight: 1, ArrowUp: 1, ArrowLeft: -1, ArrowDown: -1, Home: -Infinity, End: Infinity };

/** The steps that a pressed key asks for, with more keys of one's own; 0 for any other key, which is left to the page. */
export function stepsOf(event, more = {}) {
  const steps = { ...KEY_STEPS, ...more }[event.key];
  if (!steps || event.ctrlKey || event.metaKey || event.altKey) return 0;
  event.preventDefault();
  return steps;
}

/** Render a symbol with its index: q_1 becomes q with the subscript 1. */
export function renderSymbol(name) {
  const [base, sub] = name.split('_');
  return h('span', { class: 'kv-name' }, h('i', {}, base), ...(sub ? [h('sub', {}, sub)] : []));
}

/** Format a number with a fixed count of digits, and never as -0. */
export function formatNumber(value, digits) {
  const text = value.toFixed(digits);
  return Number(text) === 0 ? (0).toFixed(digits) : text;
}

/** Copy a text. Returns whether the page has access to the clipboard. */
export async function copyToClipboard(text) {
  try {
    await navigator.clipboard.writeText(text);
    return true;
  } catch {
    // the older interface, for pages without access to the clipboard
    const field = h('textarea', { style: 'position:fixed;opacity:0' });
    field.value = text;
    document.body.append(field);
    field.select();
    const done = document.execCommand('copy');
    field.remove();
    return done;
  }
}

let count = 0;
/** An id that is unique on the page, even if several copies of this module run there. */
export function uniqueId(name) {
  count += 1;
  return `kv-${name}-${count}-${Math.random().toString(36).slice(2, 7)}`;
}
