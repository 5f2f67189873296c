// Viewers on a page of the site: their state is in the page as JSON, and PageModel is their model. Where the page has a
// Python of its own (site/static/live.js), the model is connected with the widget in Python as soon as its cell has run.
import { widget } from './viewer.js';

class PageModel {
  #element;
  #state;
  #python = null;
  #changed = new Set(); // what the reader has set: it counts more than what Python has made
  #unsaved = new Set();
  #listeners = new Map();

  constructor(element, state) {
    this.#element = element;
    this.#state = { ...state };
  }

  get withoutKernel() {
    return this.#python === null;
  }

  get(name) {
    return this.#state[name];
  }

  set(name, value) {
    this.#changed.add(name);
    this.#unsaved.add(name);
    this.#apply(name, value);
  }

  #apply(name, value) {
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

  save_changes() {
    if (!this.#python) return; // later, when the model is connected
    for (const name of this.#unsaved) this.#python.set(name, this.#state[name]);
    this.#unsaved.clear();
    this.#python.save_changes();
  }

  /**
   * Ask the page for Python. Returns whether it has one: then the model is connected, or `refused` is called.
   * @param refused a function without arguments
   */
  wake(refused) {
    const detail = { refused };
    return !this.#element.dispatchEvent(
      new CustomEvent('kinlib-needs-python', { bubbles: true, cancelable: true, detail }),
    );
  }

  /** Connect with a widget in Python, which was made of the same data; null if Python is gone. */
  connect(python) {
    this.#python = python;
    if (!python) return;
    for (const name of Object.keys(this.#state)) if (!this.#changed.has(name)) this.#apply(name, python.get(name));
    python.onUpdate = (state) => {
      if (this.#python !== python) return;
      for (const [name, value] of Object.entries(state)) this.#apply(name, value);
    };
    this.#unsaved = new Set(this.#changed);
    this.save_changes();
  }
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
  for (const element of root.querySelectorAll(':is([data-kinlib-viewer], [data-kinlib-film]):not([data-started])')) {
    element.dataset.started = '';
    observer.observe(element);
  }
}

/** Start a viewer in an element, by default from the JSON in it. Returns its model. */
export function startViewer(
  element,
  state = JSON.parse(element.querySelector('script[type="application/json"]').textContent),
) {
  const drawing = element.querySelector('[data-kinlib-drawing]');
  const fold = drawing?.querySelector(':scope > details'); // covers it where no script runs
  fold?.querySelector('summary').remove();
  const model = new PageModel(element, { ...state, drawing: (fold ?? drawing)?.innerHTML });
  drawing?.remove();
  // a question elsewhere on the page sets data-uncovered, before the viewer has started or afterwards
  const uncover = () => {
    if (!('uncovered' in element.dataset)) return;
    model.set('covered', false);
    model.save_changes();
  };
  uncover();
  new MutationObserver(uncover).observe(element, { attributeFilter: ['data-uncovered'] });
  element.kinlibModel = model;
  element.dispose = widget.render({ model, el: element });
  return model;
}
