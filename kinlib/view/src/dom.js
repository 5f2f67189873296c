/** Make an element: h('button', { type: 'button', onclick }, 'Play'). What is not a property is an attribute. */
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

/** JupyterLab takes the arrow keys from whatever has the focus, unless that element itself carries this. */
export const NO_SHORTCUTS = { 'data-lm-suppress-shortcuts': 'true' };

/** A name with an index: q_1 is q with a subscript 1. */
export function renderSymbol(name) {
  const [base, sub] = name.split('_');
  return h('span', { class: 'kv-name' }, h('i', {}, base), ...(sub ? [h('sub', {}, sub)] : []));
}

/** A number for people: rounded, and never -0. */
export function formatNumber(value, digits) {
  const text = value.toFixed(digits);
  return Number(text) === 0 ? (0).toFixed(digits) : text;
}

let count = 0;
/** An id that no other viewer on the page has, whichever copy of this module made it. */
export function uniqueId(name) {
  count += 1;
  return `kv-${name}-${count}-${Math.random().toString(36).slice(2, 7)}`;
}
