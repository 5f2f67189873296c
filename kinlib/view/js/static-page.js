// Viewers on a page without a kernel: their state is in the page as JSON, and StaticModel replaces the kernel's model.
import { widget } from './viewer.js';

class StaticModel {
  withoutKernel = true; // for modes that would send a request to Python
  #state;
  #listeners = new Map();

  constructor(state) {
    this.#state = { ...state };
  }

  get(name) {
    return this.#state[name];
  }

  set(name, value) {
    this.#state[name] = value;
    for (const listener of this.#listeners.get(`change:${name}`) ?? []) listener();
  }

  on(event, listener) {
    this.#listeners.set(event, [...(this.#listeners.get(event) ?? []), listener]);
  }

  off(event, listener) {
    this.#listeners.set(
      event,
      (this.#listeners.get(event) ?? []).filter((other) => other !== listener),
    );
  }

  save_changes() {} // there is no kernel to synchronise with
}

/** Start the viewers of a page: each one replaces its static figure when that is about to be scrolled into view. */
export function startViewers(root = document) {
  const observer = new IntersectionObserver(
    (entries) => {
      for (const { isIntersecting, target } of entries) {
        if (!isIntersecting) continue;
        observer.unobserve(target);
        startViewer(target);
      }
    },
    { rootMargin: '300px' },
  );
  for (const element of root.querySelectorAll('[data-kinlib-viewer]:not([data-started])')) {
    element.dataset.started = '';
    observer.observe(element);
  }
}

function startViewer(element) {
  const state = JSON.parse(element.querySelector('script[type="application/json"]').textContent);
  const model = new StaticModel(state);
  // a question elsewhere on the page sets data-uncovered, before the viewer has started or afterwards
  const uncover = () => 'uncovered' in element.dataset && model.set('covered', false);
  uncover();
  new MutationObserver(uncover).observe(element, { attributeFilter: ['data-uncovered'] });
  element.querySelector('[data-kinlib-drawing]')?.remove();
  widget.render({ model, el: element });
}
