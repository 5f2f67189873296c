// The widgets of Python on a page: the page's end of the comm protocol of Jupyter, and a view for each kind of widget that
// the course uses, in the style of the page. live.js passes the messages between this script and its worker.
(() => {
  'use strict';
  const h = window.kinlibElement; // of course.js
  const REFERENCE = /^IPY_MODEL_/;

  /** The page's half of a widget. Changes that are made while Python is busy are sent together. */
  class Model {
    #send;
    #unsent = {};
    #busy = false;
    #listeners = new Map();
    onUpdate = () => {}; // called with what Python has set

    constructor(id, state, cell, send) {
      Object.assign(this, { id, state, cell });
      this.#send = (data) => send({ comm: id, data });
    }

    get(name) {
      return this.state[name];
    }

    set(name, value) {
      this.state[name] = value;
      this.#unsent[name] = value;
      this.#emit(name);
    }

    save_changes() {
      if (this.#busy || !Object.keys(this.#unsent).length) return;
      this.#busy = true;
      this.#send({ method: 'update', state: this.#unsent, buffer_paths: [] });
      this.#unsent = {};
    }

    send(content) {
      this.#send({ method: 'custom', content });
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

    #emit(name) {
      for (const listener of this.#listeners.get(`change:${name}`) ?? []) listener();
    }

    /** A message of Python. */
    receive({ method, state, content }) {
      if (method === 'custom') for (const listener of this.#listeners.get('msg:custom') ?? []) listener(content);
      if (method !== 'update') return;
      Object.assign(this.state, state);
      for (const name of Object.keys(state)) this.#emit(name);
      this.onUpdate(state);
    }

    /** Python has dealt with the last change. */
    heard() {
      this.#busy = false;
      this.save_changes();
    }
  }

  /** Call a function now, and whenever one of the traits changes. */
  function follow(model, names, update) {
    for (const name of names) model.on(`change:${name}`, update);
    update();
  }

  /** All widgets of one Python. `page` has send(message), output(data), fill(element, html) and load(script). */
  class Widgets {
    #models = new Map();

    constructor(page) {
      this.page = page;
    }

    /** A message about a widget; `cell` is what runs, if something does. */
    receive({ type, id, data }, cell) {
      if (type === 'comm_open') this.#models.set(id, new Model(id, data.state, cell, this.page.send));
      else if (type === 'comm_close') this.#models.delete(id);
      else this.#models.get(id)?.receive(data);
    }

    model(reference) {
      return this.#models.get(String(reference).replace(REFERENCE, ''));
    }

    /** Whether there is a view for a widget and for all that are in it. */
    canShow(id) {
      const model = this.model(id);
      return Boolean(
        model && VIEWS[model.get('_model_name')] && (model.get('children') ?? []).every((one) => this.canShow(one)),
      );
    }

    /** The view of a widget. `kept` are viewers of the output before, which may go on with this widget. */
    view(id, kept = []) {
      const model = this.model(id);
      return VIEWS[model.get('_model_name')](model, this, kept);
    }

    /** The buttons of a widget, in their order. */
    buttons(id) {
      const model = this.model(id);
      if (!model) return [];
      return model.get('_model_name') === 'ButtonModel'
        ? [model]
        : (model.get('children') ?? []).flatMap((one) => this.buttons(one));
    }

    press(button) {
      button.send({ event: 'click' });
    }
  }

  // --- views ---

  const box = (kind) => (model, widgets, kept) => {
    const element = h('div', { class: `kinlib-widget kinlib-${kind}` });
    const shown = new Map(); // a child that stays keeps its view
    follow(model, ['children'], () => {
      const children = model
        .get('children')
        .map((id) => shown.get(id) ?? shown.set(id, widgets.view(id, kept)).get(id));
      if (children.length !== element.children.length || children.some((child, k) => child !== element.children[k]))
        element.replaceChildren(...children);
    });
    return element;
  };

  function html(model, { page }) {
    const element = h('div', { class: 'kinlib-widget' });
    follow(model, ['value'], () => page.fill(element, model.get('value')));
    return element;
  }

  function label(model) {
    const element = h('span', {});
    follow(model, ['value'], () => {
      element.textContent = model.get('value');
    });
    return element;
  }

  function button(model, widgets) {
    const element = h('button', { type: 'button', class: 'kinlib-button', onclick: () => widgets.press(model) });
    follow(model, ['description', 'tooltip', 'disabled'], () => {
      element.textContent = model.get('description');
      element.title = model.get('tooltip') ?? '';
      element.disabled = model.get('disabled');
    });
    return element;
  }

  /** A slider whose trait `name` has a number; `text` is what it shows of it. */
  const slider = (name, limits, text) => (model) => {
    const value = h('output', {});
    const range = h('input', {
      type: 'range',
      oninput: () => {
        model.set(name, Number(range.value));
        model.save_changes();
      },
    });
    follow(model, [name, 'min', 'max', 'step', '_options_labels', 'disabled'], () => {
      Object.assign(range, limits(model), { disabled: model.get('disabled') });
      range.value = model.get(name);
      value.textContent = text(model);
      range.setAttribute('aria-valuetext', text(model));
    });
    return h(
      'label',
      { class: 'kinlib-widget kinlib-widget-slider' },
      h('span', {}, model.get('description')),
      range,
      value,
    );
  };
  const ownLimits = (model) => ({ min: model.get('min'), max: model.get('max'), step: model.get('step') });
  const number = slider('value', ownLimits, (model) => String(Number(model.get('value').toPrecision(6))));
  const selection = slider(
    'index',
    (model) => ({ min: 0, max: model.get('_options_labels').length - 1, step: 1 }),
    (model) => model.get('_options_labels')[model.get('index')],
  );

  const field = (tag) => (model) => {
    const input = h(tag, {
      spellcheck: 'false',
      rows: 6,
      oninput: () => {
        model.set('value', input.value);
        model.save_changes();
      },
    });
    follow(model, ['value', 'disabled'], () => {
      if (input.value !== model.get('value')) input.value = model.get('value');
      input.disabled = model.get('disabled');
    });
    return h('label', { class: 'kinlib-widget kinlib-widget-field' }, h('span', {}, model.get('description')), input);
  };

  function outputs(model, { page }) {
    const element = h('div', { class: 'kinlib-widget' });
    follow(model, ['outputs'], () => {
      element.replaceChildren(
        ...model.get('outputs').map(({ data, text }) => page.output(data ?? { 'text/plain': text })),
      );
    });
    return element;
  }

  const MADE_OF = ['scene', 'mode', 'start', 'order', 'scenes']; // what the reader does not change, of viewers and of films
  const madeOf = (model) => JSON.stringify(MADE_OF.map((name) => model.get(name)));

  /** A widget that brings its own script; those of kinlib have theirs on the page. */
  function own(model, { page }, kept) {
    const element = h('div', {});
    if (model.get('_anywidget_id')?.startsWith('kinlib.')) {
      const before = kept.findIndex(({ kinlibModel }) => madeOf(kinlibModel) === madeOf(model));
      if (before >= 0) {
        const [viewer] = kept.splice(before, 1);
        viewer.kinlibModel.connect(model);
        return viewer;
      }
      element.dataset[model.get('scene') ? 'kinlibViewer' : 'kinlibFilm'] = element.dataset.started = '';
      page.load('viewer.js').then(() => kinlib.startViewer(element, { ...model.state }).connect(model));
    } else {
      const script = URL.createObjectURL(new Blob([model.get('_esm')], { type: 'text/javascript' }));
      import(script).then(({ default: made }) => made.render({ model, el: element }));
      element.append(h('style', {}, model.get('_css') ?? ''));
    }
    return element;
  }

  const VIEWS = {
    AnyModel: own,
    BoxModel: box('column'),
    ButtonModel: button,
    FloatSliderModel: number,
    HBoxModel: box('row'),
    HTMLMathModel: html,
    HTMLModel: html,
    IntSliderModel: number,
    LabelModel: label,
    OutputModel: outputs,
    SelectionSliderModel: selection,
    TextModel: field('input'),
    TextareaModel: field('textarea'),
    VBoxModel: box('column'),
  };

  window.KinlibWidgets = Widgets;
})();
