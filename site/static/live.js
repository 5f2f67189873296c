// Makes the code of a lecture run where it is read: each cell gets a Run button, and one worker with the Python of the
// lab runs the cells. Without a lab, without this script or without WebAssembly, the page stays as it was built.
(() => {
  'use strict';
  const note = document.querySelector('[data-kinlib-lab]'); // the template writes it if the site has a lab
  if (!note || typeof Worker !== 'function' || typeof WebAssembly !== 'object') return;

  const LAB = new URL(note.dataset.kinlibLab, location.href);
  const STATIC = new URL('.', document.currentScript.src);
  const KEY = `kinlib-live:${location.pathname}`; // in localStorage: the code that the reader has changed
  const MAX_TEXT = 100_000; // characters that one cell may print
  const STALLED_S = 20; // without a byte, until a message says so
  const MB = 1e6;

  const h = window.kinlibElement; // of course.js

  const PYTHON_SIZE = `${note.dataset.megabytes} MB`;
  const INTRODUCTION =
    'The code runs on this page: press Run below a cell, or Shift + Enter in it. ' +
    `The first run loads Python, ${PYTHON_SIZE}, which this browser keeps. Until then nothing is loaded. `;
  const CONSENT = 'kinlib-python'; // in localStorage, once the reader has agreed
  const DIFFERENCES = [
    'The results that you see first were computed when the page was built; your own replace them.',
    'Before a cell runs, the cells above it run, if they have not run yet.',
    'Code that you change is kept in this browser, and handed in nowhere.',
    'Sliders of 3-D pictures and questions do not change variables in Python; in the lab they do.',
  ];
  const PREVIEW = 'You have changed the code: the result below is that of the original. Run the cell.';
  const STOPPED = 'Stopped. All variables are lost: the next run starts Python again, and first runs the cells above.';
  const NOT_RUN = 'Not run, because a cell above ended with an error. Run it again to go on without that cell.';
  const NEEDS_LAB = 'This output has buttons that need Python all the time: ';

  const labLink = () => h('a', { href: note.dataset.kinlibRun }, 'open this lecture in the lab');
  const load = (name) =>
    new Promise((resolve, reject) => {
      document.head.append(h('script', { src: new URL(name, STATIC), onload: resolve, onerror: reject }));
    });

  // --- what the reader typed: { original code: changed code } ---

  let typed = {};
  try {
    typed = JSON.parse(localStorage.getItem(KEY)) ?? {};
  } catch {
    /* no storage, or nothing in it that can be read */
  }

  function keep(key, text) {
    if (text === null) delete typed[key];
    else typed[key] = text;
    try {
      if (Object.keys(typed).length) localStorage.setItem(KEY, JSON.stringify(typed));
      else localStorage.removeItem(KEY);
    } catch {
      /* what is typed is then lost when the page is closed */
    }
  }

  // --- the status of Python, below the cell that was run ---

  const bar = h('progress', { max: 1, 'aria-label': 'Python is loading' });
  const amount = h('span', { class: 'kinlib-live-amount' });
  const phase = h('span', { role: 'status' });
  const statusBox = h('div', { class: 'kinlib-live-status', hidden: true }, phase, amount, bar);
  const spoken = h('p', { class: 'visually-hidden', role: 'status' });
  note.after(statusBox, spoken);

  function showPhase(text, loading = true) {
    if (phase.textContent !== text) phase.textContent = text; // otherwise it would be announced again
    statusBox.hidden = !text;
    bar.hidden = amount.hidden = !loading;
  }

  // --- the reader is asked before Python is loaded for the first time ---

  let agreed = false;
  try {
    agreed = localStorage.getItem(CONSENT) === 'yes';
  } catch {
    /* the reader is asked on each page */
  }

  /** Say how much will be loaded, and go on with `then` if the reader agrees. */
  function ask(cell, then) {
    document.querySelector('.kinlib-live-ask')?.remove();
    const button = (label, onclick) => h('button', { type: 'button', class: 'kinlib-button', onclick }, label);
    const box = h(
      'div',
      { class: 'kinlib-live-ask', role: 'group', 'aria-label': 'Load Python?' },
      h('p', {}, `To run code, this page loads Python: ${PYTHON_SIZE}, once. The browser keeps it for all lectures.`),
      button('Load Python and run', () => {
        agreed = true;
        try {
          localStorage.setItem(CONSENT, 'yes');
        } catch {
          /* as above */
        }
        close(then);
      }),
      button('Not now', () => close()),
    );
    function close(next) {
      box.remove();
      cell.runButton.focus();
      next?.();
    }
    cell.tools.after(box);
    box.querySelector('button').focus();
  }

  // --- one worker for all cells of the page ---

  let worker = null;
  let stalled;
  let queue = []; // the cells to run, the current one first
  let executed = new Set();

  function startPython(cell) {
    if (worker) return;
    cell.tools.after(statusBox);
    worker = new Worker(new URL('live/worker.js', LAB), { type: 'module' });
    worker.onmessage = ({ data }) => ANSWERS[data.kind](data);
    worker.onerror = (event) => ANSWERS.failed({ text: event.message ?? 'its files could not be loaded' });
    bar.removeAttribute('value');
    amount.textContent = '';
    showPhase('Python is loading');
    watchBytes();
  }

  function watchBytes() {
    clearTimeout(stalled);
    stalled = setTimeout(
      () => showPhase(`No data has arrived for ${STALLED_S} seconds. Check the connection; loading goes on by itself.`),
      STALLED_S * 1000,
    );
  }

  function stopPython() {
    worker?.terminate();
    worker = null;
    executed = new Set();
    clearTimeout(stalled);
    const waiting = queue;
    queue = [];
    for (const cell of waiting) cell.finish('');
    showPhase('');
    return waiting;
  }

  const ANSWERS = {
    bytes({ received, total }) {
      watchBytes();
      if (received >= total) {
        clearTimeout(stalled);
        bar.removeAttribute('value');
        amount.textContent = '';
        showPhase('Python is starting');
      } else {
        bar.value = received / total;
        const megabytes = `${Math.floor(received / MB)} of ${Math.ceil(total / MB)} MB`;
        amount.textContent = ` ${megabytes}`;
        showPhase('Python is loading');
      }
    },
    ready() {
      showPhase('');
      if (!queue.length) spoken.textContent = 'Python is ready.';
    },
    failed({ text }) {
      const waiting = stopPython();
      for (const cell of waiting) cell.finish('Python could not start.');
      showPhase(`Python could not start: ${text}. Check the connection, then press Run again.`, false);
    },
    begin: () => queue[0]?.begin(),
    stream: (data) => queue[0]?.show(data),
    display: (data) => queue[0]?.show(data),
    error: (data) => queue[0]?.show(data),
    end() {
      const cell = queue.shift();
      if (!cell) return;
      cell.finish(cell.failed ? 'Ended with an error.' : 'Done.', true);
      if (cell.failed && queue.length) {
        const waiting = queue;
        queue = [];
        for (const other of waiting) other.finish(other.asked ? NOT_RUN : '');
      }
      runNext();
    },
  };

  function runNext() {
    const [cell] = queue;
    if (!cell || cell.sent) return;
    cell.sent = true;
    executed.add(cell);
    worker.postMessage({ source: cell.source() });
  }

  /** Run a cell, and before it all cells above that this Python has not run yet. */
  function run(cell) {
    if (queue.includes(cell)) return;
    if (!agreed) {
      ask(cell, () => run(cell));
      return;
    }
    startPython(cell);
    const before = cells
      .slice(0, cells.indexOf(cell))
      .filter((other) => !executed.has(other) && !queue.includes(other));
    for (const each of [...before, cell]) each.wait(each === cell, before.length);
    queue.push(...before, cell);
    runNext();
  }

  // --- cells ---

  class Cell {
    constructor(element, number, key) {
      this.element = element;
      this.number = number;
      this.key = key;
      this.pre = element.querySelector('.cell_input pre');
      this.original = this.pre.textContent.replace(/\n$/, '');
      this.output = element.querySelector(':scope > .cell_output');
      this.status = h('span', { class: 'kinlib-live-note' });
      const button = (label, action) =>
        h(
          'button',
          { type: 'button', class: 'kinlib-button', onclick: action, 'aria-label': `${label} cell ${number}` },
          label,
        );
      this.runButton = button('Run', () => (queue.includes(this) ? this.stop() : run(this)));
      this.editButton = button('Edit', () => this.edit());
      this.resetButton = button('Reset', () => this.reset());
      this.resetButton.hidden = true;
      this.tools = h(
        'div',
        { class: 'kinlib-live-tools' },
        this.runButton,
        this.editButton,
        this.resetButton,
        this.status,
      );
      this.pre.closest('.cell_input').after(this.tools);
      this.pre.addEventListener('click', () => getSelection().isCollapsed && this.edit());
      element.addEventListener('keydown', (event) => this.onKey(event));
      if (typeof typed[key] === 'string') {
        this.edit(typed[key], false);
        this.status.textContent = PREVIEW;
      }
    }

    nameButton(label) {
      this.runButton.textContent = label;
      this.runButton.setAttribute('aria-label', `${label} cell ${this.number}`);
    }

    source() {
      return this.area ? this.area.value : this.original;
    }

    onKey(event) {
      if (event.key !== 'Enter' || event.altKey) return;
      if (event.shiftKey || event.ctrlKey || event.metaKey) {
        event.preventDefault();
        run(this);
        if (event.shiftKey && agreed) {
          const next = cells[cells.indexOf(this) + 1];
          (next?.area ?? next?.runButton)?.focus();
        }
      } else if (event.target === this.area) {
        const line = this.area.value.slice(0, this.area.selectionStart).split('\n').pop();
        const indent = line.match(/^ */)[0] + (line.trimEnd().endsWith(':') ? '    ' : '');
        if (!indent) return;
        event.preventDefault();
        document.execCommand('insertText', false, `\n${indent}`); // the browser can undo it
      }
    }

    /** Replace the code by a field to type in. */
    edit(text = this.original, focus = true) {
      if (!this.area) {
        this.area = h('textarea', {
          class: 'kinlib-live-code',
          'aria-label': `Code of cell ${this.number}`,
          spellcheck: 'false',
          autocapitalize: 'off',
          autocomplete: 'off',
          autocorrect: 'off',
          wrap: 'off',
          oninput: () => this.onInput(),
        });
        this.area.value = text;
        this.pre.hidden = true;
        this.pre.after(this.area);
        this.editButton.hidden = true;
        this.fit();
        this.resetButton.hidden = text === this.original;
      }
      if (focus) this.area.focus();
    }

    fit() {
      this.area.rows = this.area.value.split('\n').length;
    }

    onInput() {
      this.fit();
      const changed = this.area.value !== this.original;
      keep(this.key, changed ? this.area.value : null);
      this.resetButton.hidden = !changed;
      this.status.textContent = changed && !executed.has(this) ? PREVIEW : '';
    }

    reset() {
      this.area.remove();
      this.area = null;
      this.pre.hidden = false;
      this.editButton.hidden = false;
      this.resetButton.hidden = true;
      this.status.textContent = executed.has(this) ? 'The original code. Run the cell to see its result.' : '';
      keep(this.key, null);
      this.runButton.focus();
    }

    wait(asked, above) {
      Object.assign(this, { asked, sent: false, failed: false, fresh: true, length: 0 });
      this.status.textContent =
        asked && above ? `Waiting for Python. Cells above that run first: ${above}.` : 'Waiting for Python.';
      this.nameButton('Stop');
      this.element.setAttribute('aria-busy', 'true');
    }

    begin() {
      this.status.textContent = 'Running.';
    }

    stop() {
      const running = queue[0];
      stopPython();
      this.status.textContent = STOPPED;
      if (running && running !== this) running.status.textContent = STOPPED;
      spoken.textContent = STOPPED;
    }

    finish(text, ran = false) {
      if (ran && this.fresh) this.clear(); // it has displayed nothing
      this.status.textContent = text;
      this.nameButton('Run');
      this.element.removeAttribute('aria-busy');
      if (ran && this.asked) spoken.textContent = `Cell ${this.number}: ${text}`;
    }

    /** Remove the outputs of the run before: until there is a new one, they stay as a preview. */
    clear() {
      this.fresh = false;
      if (!this.output) {
        this.output = h('div', { class: 'cell_output docutils container' });
        this.tools.after(this.output);
      }
      this.output.replaceChildren();
      this.element.querySelector('details.below-input, details.hide.above-output')?.setAttribute('open', '');
    }

    show(data) {
      if (this.fresh) this.clear();
      if (data.kind === 'error') this.failed = true;
      const text = data.text ?? '';
      this.length += text.length;
      if (data.kind === 'stream' && this.length - text.length > MAX_TEXT) return;
      if (data.kind === 'stream') this.showStream(data);
      else this.output.append(data.kind === 'error' ? errorCard(data) : displayed(data.data, this.asked));
    }

    showStream({ name, text }) {
      const cut = 'the rest of this output is left out';
      const shown = this.length > MAX_TEXT ? `${text.slice(0, MAX_TEXT)}\n[${cut}]\n` : text;
      let pre = this.output.lastElementChild?.querySelector(`:scope > [data-stream="${name}"]`);
      if (!pre) {
        pre = h('pre', { 'data-stream': name });
        this.output.append(h('div', { class: 'output stream' }, pre));
      }
      pre.append(shown);
    }
  }

  // --- outputs ---

  function errorCard({ name, text, line, traceback }) {
    const place = line ? `in line ${line} of this cell` : '';
    return h(
      'div',
      { class: 'output kinlib-live-error' },
      h('p', {}, h('strong', {}, `✗ ${name}`), ` ${place}`),
      h('pre', {}, text),
      h('details', {}, h('summary', {}, 'Traceback'), h('pre', { tabindex: 0 }, traceback)),
    );
  }

  const IMAGES = ['image/png', 'image/jpeg'];

  function displayed(data, asked) {
    const box = h('div', { class: 'output' });
    const image = IMAGES.find((type) => data[type]);
    if (data['text/html']) {
      box.innerHTML = siteLinks(data['text/html']);
      startContent(box, asked);
    } else if (data['image/svg+xml']) box.innerHTML = data['image/svg+xml'];
    else if (image) box.append(h('img', { src: `data:${image};base64,${data[image]}`, alt: data['text/plain'] ?? '' }));
    else if (data['text/latex']) {
      box.textContent = data['text/latex'];
      typeset(box);
    } else {
      box.append(h('pre', {}, data['text/plain'] ?? ''));
      if (data['application/vnd.jupyter.widget-view+json']) box.append(h('p', {}, NEEDS_LAB, labLink()));
    }
    return box;
  }

  /** Links between notebooks lead to the pages of the site. */
  function siteLinks(html) {
    const root = document.documentElement.dataset.content_root;
    const id = (section) =>
      decodeURIComponent(section ?? '')
        .toLowerCase()
        .replace(/[^a-z0-9]+/g, '-')
        .replace(/^[-0-9]+|-+$/g, '');
    return html
      .replace(/href="(?:\.\.\/)+notebooks\/(\w+)\.ipynb(?:#([^"]*))?"/g, (_, name, section) => {
        return `href="${root}lectures/${name}.html${section ? `#${id(section)}` : ''}"`;
      })
      .replace(/href="(?:\.\.\/)+exercises\/(\w+)\/\1\.ipynb"/g, `href="${root}sheets/$1.html"`)
      .replace(/href="(?!\w+:)([\w./]+)\.ipynb(?:#([^"]*))?"/g, (_, path, section) => {
        return `href="${root}lectures/${path}.html${section ? `#${id(section)}` : ''}"`;
      });
  }

  /** Start the questions, sliders and viewers of an output. A self-check that was run again can be answered again. */
  async function startContent(box, again) {
    typeset(box);
    await Promise.resolve(); // until the box is on the page
    document.dispatchEvent(new CustomEvent('kinlib-content', { detail: { root: box, again } }));
    if (!box.querySelector('[data-kinlib-viewer]')) return;
    if (typeof kinlib === 'undefined') await load('viewer.js');
    kinlib.startViewers(box);
  }

  let katex;

  async function typeset(box) {
    if (!/\$|\\[([]/.test(box.textContent)) return;
    katex ??= load('katex/katex.min.js').then(() => load('katex/auto-render.min.js'));
    await katex;
    const delimiters = [
      { left: '$$', right: '$$', display: true },
      { left: '$', right: '$', display: false },
    ];
    renderMathInElement(box, { delimiters, throwOnError: false });
  }

  // --- start ---

  const seen = new Map();
  const cells = [...document.querySelectorAll('article div.cell')]
    .filter((element) => element.querySelector('.cell_input pre'))
    .map((element, index) => {
      const source = element.querySelector('.cell_input pre').textContent;
      seen.set(source, (seen.get(source) ?? 0) + 1);
      return new Cell(element, index + 1, `${source}#${seen.get(source)}`);
    });
  note.replaceChildren(
    INTRODUCTION,
    h(
      'details',
      {},
      h('summary', {}, 'What is different from the lab'),
      h('ul', {}, ...DIFFERENCES.map((text) => h('li', {}, text))),
      h('p', {}, 'To have all of it:', ' ', labLink()),
    ),
  );
})();
