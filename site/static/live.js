// Makes the code of a page run where it is read: each cell gets a Run button, and one worker with the Python of the lab
// runs the cells and answers the widgets. Without a lab, without this script or without WebAssembly, the page stays as it
// was built. On the page of a sheet the answers are typed here, checked here, and downloaded in the notebook of the sheet.
(() => {
  'use strict';
  const note = document.querySelector('[data-kinlib-lab]'); // the template writes it if the site has a lab
  if (!note || typeof Worker !== 'function' || typeof DecompressionStream !== 'function') return;

  const LAB = new URL(note.dataset.kinlibLab, location.href);
  const STATIC = new URL('.', document.currentScript.src);
  const KEY = `kinlib-live:${location.pathname}`; // in localStorage: the code that the reader has changed
  const MAX_TEXT = 100_000; // characters that one cell may print
  const STALLED_S = 20; // without a byte, until a message says so
  const PASSING_MS = 300; // what is in view for less is passed by
  const MB = 1e6;
  const MARKED = 'marked.umd.js';
  const KATEX = 'katex/katex.min.js';

  const { kinlibElement: h, kinlibStore: store } = window; // of course.js

  const PYTHON_SIZE = `${note.dataset.megabytes} MB`;
  const CONSENT = 'kinlib-python'; // in localStorage, once the reader has agreed
  const DIFFERENCES = [
    'Press Run below a cell, or Shift + Enter in it. The first run loads Python, which this browser keeps; until then nothing is loaded.',
    'The results that you see first were computed when the page was built; your own replace them.',
    'Before a cell runs, the cells above it run, if they have not run yet or have changed.',
    'Code that you change is kept in this browser, and handed in nowhere.',
  ];
  const SHEET = note.dataset.kinlibSheet; // the address of the notebook, on the page of a sheet
  const SHEET_INTRODUCTION = [
    'Work on this sheet here: write your id, type an answer below each problem, and press Check.',
    !SHEET || store.write(KEY, store.read(KEY) ?? {})
      ? 'Your answers are kept in this browser.'
      : 'This browser keeps no answers: do not close this page before the end.',
    'When you are done, download the notebook with your answers at the end of this page, and hand it in.',
    `The first check loads Python, ${PYTHON_SIZE}, which this browser keeps.`,
  ].join(' ');
  const SAMPLE_ID = /^(student = )"([^"\\\n]*)"$/m; // in the cell that opens the sheet
  const ANSWER_NAME = /^(\w+) = \.\.\.$/m; // in the cell of an answer: what is checked
  const SOLVED = 'application/vnd.misstep.solved+json';
  const ANSWER = 'application/vnd.misstep.answer+json'; // what a check stores for the grader
  const WIDGET = 'application/vnd.jupyter.widget-view+json';
  const PREVIEW = 'You have changed the code: the result below is that of the original. Run the cell.';
  const STOPPED = 'Stopped. All variables are lost: the next run starts Python again, and first runs the cells above.';
  const NOT_RUN =
    'Not run, because a cell above ended with an error. Mend that cell; or press the button here again to leave it out.';
  const NOT_CHECKED = 'Not checked, because your answer ended with an error. Mend it, and press Check again.';
  const STALE = 'This card belongs to an answer that you have changed since. Press Check.';
  const NEEDS_LAB = 'This output has a widget that this page cannot show: ';

  const labLink = () => h('a', { href: note.dataset.kinlibRun }, 'open this lecture in the lab');
  const loaded = {};
  const load = (name) => {
    loaded[name] ??= new Promise((resolve, reject) => {
      if (name === 'viewer.js' && typeof kinlib !== 'undefined') return resolve();
      document.head.append(h('script', { src: new URL(name, STATIC), onload: resolve, onerror: reject }));
    });
    return loaded[name];
  };

  // --- what the reader typed: { original code: changed code } ---

  let typed = store.read(KEY) ?? {};

  function keep(key, text) {
    typed = store.read(KEY) ?? typed; // another tab may have changed other cells
    if (text === null) delete typed[key];
    else typed[key] = text;
    if (!store.write(KEY, typed)) store.sayNotStored();
  }

  addEventListener('storage', ({ key }) => {
    if (key !== KEY) return;
    typed = store.read(KEY) ?? typed;
    for (const cell of cells)
      if (cell.key in typed && typed[cell.key] !== cell.source()) {
        cell.edit(typed[cell.key], false);
        if (cell.role === 'open') showMyNumbers(); // of the id that was typed in the other tab
      }
  });

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

  /** Whether the reader has agreed, here or in another tab. */
  function hasAgreed() {
    agreed ||= store.read(CONSENT) === true;
    return agreed;
  }

  /** Say how much will be loaded, and go on with `then` if the reader agrees. */
  function ask(cell, then, refused = () => {}, place = (box) => cell.place(box)) {
    const before = document.activeElement;
    document.querySelector('.kinlib-live-ask')?.remove();
    const button = (label, onclick) => h('button', { type: 'button', class: 'kinlib-button', onclick }, label);
    const box = h(
      'div',
      { class: 'kinlib-live-ask', role: 'group', 'aria-label': 'Load Python?' },
      h('p', {}, `To run code, this page loads Python: ${PYTHON_SIZE}, once. The browser keeps it for all pages.`),
      button('Load Python and run', () => {
        agreed = true;
        store.write(CONSENT, true); // or the reader is asked on each page
        close(then);
      }),
      button('Not now', () => close(refused)),
    );
    function close(next) {
      box.remove();
      if (before?.isConnected && before !== document.body) before.focus();
      else cell.runButton.focus();
      next();
    }
    place(box);
    box.querySelector('button').focus();
  }

  // --- one worker for all cells of the page ---

  let worker = null;
  let stalled;
  let queue = []; // the cells to run, the current one first
  let executed = new Map(); // each cell that this Python has run, with the code that it had
  let widgets = null;
  let inView; // what observes the problems of a sheet
  let shown = ''; // the id whose numbers each problem gets when the reader comes to it

  function startPython(cell) {
    if (worker) return;
    cell.place(statusBox);
    widgets = new window.KinlibWidgets({
      send: (message) => worker?.postMessage(message),
      output: (data) => displayed(data, true),
      fill(element, html) {
        element.innerHTML = siteLinks(html);
        typeset(element);
      },
      load,
    });
    worker = new Worker(new URL('live/worker.js', LAB), { type: 'module' });
    if (SHEET) for (const script of [MARKED, KATEX]) load(script); // for the first problem, while Python starts
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
    executed = new Map();
    inView?.disconnect();
    shown = '';
    for (const { kinlibModel } of document.querySelectorAll('[data-kinlib-viewer], [data-kinlib-film]'))
      kinlibModel?.connect(null);
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
    loading: ({ name }) => showPhase(`Python is loading ${name}`, false),
    loaded: () => showPhase(''),
    begin: () => queue[0]?.begin(),
    stream: (data) => cellOf(data)?.show(data),
    display: (data) => cellOf(data)?.show(data),
    error: (data) => cellOf(data)?.show(data),
    comm: (data) => widgets.receive(data, cellOf(data)),
    heard: ({ id }) => widgets.model(id)?.heard(),
    end() {
      const cell = queue.shift();
      if (!cell) return;
      cell.finish(cell.failed ? 'Ended with an error.' : 'Done.', true);
      if (cell.failed && queue.length) {
        const stopped = queue.filter((other) => other.dependsOn(cell));
        queue = queue.filter((other) => !stopped.includes(other));
        for (const other of stopped) {
          const why = other.answeredIn(cell) ? NOT_CHECKED : NOT_RUN;
          other.finish(other.asked ? why : '');
          if (other.role === 'check') other.dropCard();
        }
      }
      runNext();
    },
  };

  /** The cell to which an output belongs: that of the widget that Python is listening to, or the one that runs. */
  const cellOf = ({ widget }) => (widget ? widgets.model(widget)?.cell : queue[0]);

  function runNext() {
    const [cell] = queue;
    if (!cell || cell.sent) return;
    cell.sent = true;
    if (cell.role === 'open') executed.clear(); // other numbers for all problems
    executed.set(cell, cell.source());
    cell.madeFrom = madeFrom(cell);
    const unset = cell.role === 'answer' ? ANSWER_NAME.exec(cell.original)?.[1] : '';
    worker.postMessage({ source: cell.source(), cell: cell.key, files: cell.files ?? [], unset });
  }

  /** Show each problem of a sheet when the reader comes to it: some need more of Python than others. */
  function showInView() {
    inView?.disconnect();
    const onScroll = (entries) => {
      for (const { isIntersecting, target } of entries) {
        const cell = cells.find(({ element }) => element === target);
        clearTimeout(cell.passing);
        if (isIntersecting)
          cell.passing = setTimeout(() => (isCurrent(cells[0]) && isCurrent(cell)) || run(cell), PASSING_MS);
      }
    };
    inView = new IntersectionObserver(onScroll);
    for (const { role, element } of cells) if (role === 'show') inView.observe(element);
  }

  /** The code from which a problem or a card is made: that of the opening cell, and for a card that of its answers. */
  function madeFrom({ role, problem }) {
    const answers = cells.filter((cell) => role === 'check' && cell.role === 'answer' && cell.problem === problem);
    return [cells[0], ...answers].map((cell) => cell.source()).join('\0');
  }

  /** Cover each problem that does not have the numbers of the id at the top, and mark each card of an earlier answer. */
  function markStale() {
    for (const cell of cells) {
      if (cell.role === 'show') cell.cover(cell.madeFrom !== madeFrom(cell));
      if (cell.role !== 'check') continue;
      if (cell.madeFrom !== undefined && cell.madeFrom.split('\0')[0] !== cells[0].source()) {
        cell.dropCard(); // of another id
        cell.status.textContent = '';
      }
      cell.markCard(cell.madeFrom !== madeFrom(cell));
    }
  }

  /** The id at the top of the sheet, or nothing while it is that of the example. */
  function ownId(first = cells[0]) {
    const id = SAMPLE_ID.exec(first.source())?.[2] ?? '';
    return id === SAMPLE_ID.exec(first.original)?.[2] ? '' : id;
  }

  /** Show the numbers of the id at the top, if the reader has typed one and has agreed to load Python. */
  function showMyNumbers() {
    for (const cell of cells) if (cell.role === 'check' && cell.madeFrom === undefined) cell.restore();
    if (!ownId() || !hasAgreed()) return;
    shown = ownId();
    run(cells.find(({ role }) => role === 'show'));
    showInView();
    markStale();
  }

  const isCurrent = (cell) => executed.get(cell) === cell.source();

  /** Run a cell, and before it the cells above on which it depends, unless this Python has run them as they are. */
  function run(cell, refused) {
    if (queue.includes(cell)) return;
    if (!hasAgreed()) {
      ask(cell, () => run(cell, refused), refused);
      return;
    }
    cell.refused = refused;
    startPython(cell);
    const [opening] = cells;
    const again = opening.role === 'open' && cell !== opening && !isCurrent(opening); // then all others run again
    const before = cells
      .slice(0, cells.indexOf(cell))
      .filter((other) => cell.dependsOn(other) && !queue.includes(other))
      .filter((other) => again || !isCurrent(other) || (other.failed && cell.answeredIn(other)));
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
      // on the page of a sheet: open, show, answer, check or tally, and the number of the problem
      [, this.id, this.role, this.problem] = element.className.match(/kinlib-cell-((\w+?)(?:-(\d+))?)(?:\s|$)/) ?? [];
      if (!SHEET) this.role = 'cell';
      this.runLabel = this.role === 'check' ? 'Check' : 'Run';
      this.pre = element.querySelector('.cell_input pre');
      this.original = this.pre.textContent.replace(/\n$/, '');
      this.output = element.querySelector(':scope > .cell_output');
      this.status = h('span', { class: 'kinlib-live-note' });
      const button = (label, action) =>
        h(
          'button',
          { type: 'button', class: 'kinlib-button', onclick: action, 'aria-label': `${label} ${this.name}` },
          label,
        );
      this.runButton = button(this.runLabel, () => (queue.includes(this) ? this.stop() : run(this)));
      this.editButton = button('Edit', () => this.edit());
      this.resetButton = button('Reset', () => this.reset());
      this.resetButton.hidden = true;
      this.editButton.hidden = ['show', 'check', 'tally'].includes(this.role); // these are graded as they are
      this.tools = h(
        'div',
        { class: 'kinlib-live-tools' },
        this.runButton,
        this.editButton,
        this.resetButton,
        this.status,
      );
      this.pre.closest('.cell_input').after(this.tools);
      if (!this.editButton.hidden) this.pre.addEventListener('click', () => getSelection().isCollapsed && this.edit());
      element.addEventListener('keydown', (event) => this.onKey(event));
      if (typeof typed[key] === 'string') {
        this.edit(typed[key], false);
        this.status.textContent = SHEET ? '' : PREVIEW;
      } else if (this.role === 'answer') this.edit(this.original, false);
      if (this.role === 'open') this.askForId();
    }

    /** A field for the id of the student, from which the numbers of the sheet come. */
    askForId() {
      const field = h('input', { id: 'your-id-field', autocomplete: 'off', value: ownId(this) });
      let edited = false; // since the numbers were asked for: then nothing is written into the field
      field.addEventListener('input', () => {
        edited = true;
      });
      const use = () => {
        edited = false;
        const typed = field.value.trim();
        if (typed)
          this.edit(
            this.source().replace(SAMPLE_ID, (_, before) => before + JSON.stringify(typed)),
            false,
          );
        if (!typed || !ownId()) said.textContent = 'Type your own id first.';
        else if (!hasAgreed()) ask(this, use);
        else showMyNumbers();
      };
      field.addEventListener('keydown', (event) => {
        if (event.key !== 'Enter') return;
        event.preventDefault();
        event.stopPropagation();
        use();
      });
      const button = h('button', { type: 'button', class: 'kinlib-button', onclick: use }, 'Show my numbers');
      const said = h('span', { class: 'kinlib-live-note', role: 'status' });
      this.sayId = (text) => {
        said.textContent = text;
        if (!edited) field.value = ownId(); // typed in another tab, or in the cell
      };
      const row = h(
        'p',
        { class: 'kinlib-live-id', id: 'your-id' },
        h('label', { for: 'your-id-field' }, 'Your id'),
        ' ',
        field,
        ' ',
        button,
        ' ',
        said,
      );
      this.element.before(row);
      this.element.replaceWith(
        h('details', { class: 'kinlib-opening' }, h('summary', {}, 'The code that opens the sheet')),
      );
      row.nextElementSibling.append(this.element);
      const skip = document.querySelector('.skip-to-content');
      skip?.replaceChildren('Skip to your id');
      skip?.addEventListener('click', (event) => {
        event.preventDefault();
        field.focus();
      });
    }

    /** Cover a problem whose numbers belong to another id, and say what to do; or uncover it. */
    cover(isCovered) {
      if (!this.output || !SHEET) return;
      this.coverBox?.remove();
      this.output.dataset.lookedAt = ''; // until now the style sheet has hidden it
      this.output.hidden = isCovered && !this.isExample;
      this.coverBox = null;
      if (!isCovered) return;
      const example = SAMPLE_ID.exec(cells[0].original)?.[2];
      const id = ownId();
      const toField = () => document.querySelector('#your-id input').focus();
      const link = h('button', { type: 'button', class: 'kinlib-button', onclick: toField }, 'at the top');
      const own = h('strong', {}, id);
      const later = ['This problem will have the numbers of the id ', own, ': press Show my numbers ', link, '.'];
      const coming = ['The numbers of the id ', own, ' appear here when you come to this problem.'];
      const asked = id === shown ? coming : later;
      const todo = id
        ? asked
        : ['This problem has numbers of your own: type your id ', link, ', and press Show my numbers.'];
      const look = () => {
        this.isExample = true;
        this.cover(true);
      };
      const button = h('button', { type: 'button', class: 'kinlib-button', onclick: look }, 'Look at an example');
      this.coverBox = h('div', { class: 'kinlib-live-cover' });
      if (this.isExample)
        this.coverBox.append(h('p', {}, `An example, with the numbers of the id “${example}”, not with yours.`));
      else this.coverBox.append(h('p', {}, ...todo), ...(this.madeFrom === undefined && !id ? [button] : []));
      this.output.before(this.coverBox);
    }

    /** Say of a card that it belongs to an earlier answer. */
    markCard(isStale) {
      if (!this.output || this.madeFrom === undefined) return;
      this.output.classList.toggle('kinlib-stale', isStale);
      if (!queue.includes(this) && isStale) this.status.textContent = STALE;
      else if (this.status.textContent === STALE) this.status.textContent = '';
    }

    /** Remove a card whose answer does not run any more. */
    dropCard() {
      this.output?.replaceChildren();
      this.output?.classList.remove('kinlib-stale');
      this.madeFrom = undefined;
    }

    /** Put a message where it is seen, also if the code is folded. */
    place(message) {
      if (this.role === 'open') document.getElementById('your-id').after(message);
      else if (this.output) this.output.before(message);
      else this.tools.after(message);
    }

    /** Whether a cell above has to run before this one. */
    dependsOn(other) {
      if (!SHEET || other.role === 'open' || this.role === 'tally') return true;
      if (this.role === 'show') return false;
      return other.problem === this.problem || (other.role === 'answer' && other.source() !== other.original);
    }

    /** Whether this is the check of the answer in another cell. */
    answeredIn(other) {
      return this.role === 'check' && other.role === 'answer' && other.problem === this.problem;
    }

    /** What a screen reader calls the cell. */
    get name() {
      if (!SHEET || !this.problem) return `cell ${this.number}`;
      return this.role === 'answer' ? `your answer to problem ${this.problem}` : `problem ${this.problem}`;
    }

    nameButton(label) {
      this.runButton.textContent = label;
      this.runButton.setAttribute('aria-label', `${label} ${this.name}`);
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
      if (this.area) this.area.value = text;
      else {
        this.area = h('textarea', {
          class: 'kinlib-live-code',
          'aria-label': this.role === 'answer' ? `Your answer to problem ${this.problem}` : `Code of ${this.name}`,
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
      }
      this.onInput();
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
      this.status.textContent = changed && !executed.has(this) && !SHEET ? PREVIEW : '';
      if (SHEET && this.isReady) markStale();
    }

    reset() {
      this.area.remove();
      this.area = null;
      this.pre.hidden = false;
      this.editButton.hidden = false;
      this.resetButton.hidden = true;
      if (this.role === 'answer') this.edit();
      this.status.textContent = executed.has(this) ? 'The original code. Run the cell to see its result.' : '';
      keep(this.key, null);
      this.runButton.focus();
    }

    wait(asked, above) {
      Object.assign(this, { asked, sent: false, failed: false, fresh: true, length: 0, leftovers: [] });
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
      for (const cell of stopPython()) if (cell.role === 'check') cell.dropCard(); // of the answer before
      this.status.textContent = STOPPED;
      if (running && running !== this) running.status.textContent = STOPPED;
      spoken.textContent = STOPPED;
    }

    finish(text, ran = false) {
      if (ran && this.fresh) this.clear(); // it has displayed nothing
      for (const child of this.leftovers) child.remove();
      if (this.role === 'show' && ran && !this.failed) {
        this.isExample = false;
        this.cover(this.madeFrom !== madeFrom(this));
        cells[0].sayId(`These are the numbers of the id “${ownId()}”.`);
      }
      if (this.role === 'check' && ran) this.markCard(false);
      this.status.textContent = text;
      this.nameButton(this.runLabel);
      this.element.removeAttribute('aria-busy');
      if (this.failed) this.element.closest('.kinlib-opening')?.setAttribute('open', '');
      if (!ran || this.failed) this.refused?.();
      this.refused = null;
      if (ran && this.asked) spoken.textContent = `${this.name[0].toUpperCase()}${this.name.slice(1)}: ${text}`;
    }

    /** Remove the outputs of the run before: until there is a new one, they stay as a preview. */
    clear() {
      this.fresh = false;
      // a viewer that is made again from the same data goes on as the reader has left it
      this.kept = [...this.element.querySelectorAll('[data-kinlib-viewer], [data-kinlib-film]')].filter(
        (viewer) => viewer.kinlibModel,
      );
      if (!this.output) {
        this.output = h('div', { class: 'cell_output docutils container' });
        this.tools.after(this.output);
      }
      this.leftovers = [...this.output.childNodes].filter((child) =>
        this.kept.some((viewer) => child.contains(viewer)),
      );
      for (const child of [...this.output.childNodes]) if (!this.leftovers.includes(child)) child.remove();
      this.element.querySelector('details.below-input, details.hide.above-output')?.setAttribute('open', '');
    }

    show(data) {
      if (this.fresh) this.clear();
      if (data.kind === 'error') this.failed = true;
      const text = data.text ?? '';
      this.length += text.length;
      if (data.kind === 'stream' && this.length - text.length > MAX_TEXT) return;
      if (data.kind === 'stream') this.showStream(data);
      else if (data.kind === 'error') this.output.append(errorCard(data));
      else this.showDisplay(data.data);
    }

    /** Show what Python displays; a viewer that goes on is moved, with the focus that is in it. */
    showDisplay(data) {
      const focused = this.element.contains(document.activeElement) ? document.activeElement : null;
      this.output.append(displayed(data, this.asked, this.kept));
      if (focused !== document.activeElement) focused?.focus({ preventScroll: true });
      record(data[SOLVED]);
      if (SHEET && data[ANSWER]) keep(this.storedKey, JSON.stringify({ sources: madeFrom(this), data }));
    }

    get storedKey() {
      return `stored ${this.id}`;
    }

    /** The output of the last check, as Jupyter saves it; null if there was none, or if the answer has changed since. */
    stored() {
      const { sources, data } = JSON.parse(store.read(KEY)?.[this.storedKey] ?? typed[this.storedKey] ?? '{}');
      return sources === madeFrom(this) ? { output_type: 'display_data', data, metadata: {} } : null;
    }

    /** Show the card of the last check again after the page was loaded, if its answer is still the same. */
    restore() {
      const stored = this.stored();
      if (!stored) return;
      this.clear();
      this.output.append(displayed(stored.data, false));
      this.madeFrom = madeFrom(this);
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

  function displayed(data, asked, kept) {
    const box = h('div', { class: 'output' });
    const image = IMAGES.find((type) => data[type]);
    const widget = data[WIDGET]?.model_id;
    const isQuestion = /data-misstep-(question|explain)=/.test(data['text/html']);
    if (widgets?.canShow(widget) && !isQuestion) box.append(widgets.view(widget, kept));
    else if (data['text/html']) {
      box.innerHTML = siteLinks(data['text/html']);
      startContent(box, asked).then(() => pressAnswers(box, widget));
    } else if (data['text/markdown']) showMarkdown(box, data['text/markdown']);
    else if (data['image/svg+xml']) box.innerHTML = data['image/svg+xml'];
    else if (image) box.append(h('img', { src: `data:${image};base64,${data[image]}`, alt: data['text/plain'] ?? '' }));
    else if (data['text/latex']) {
      box.textContent = data['text/latex'];
      typeset(box);
    } else {
      box.append(h('pre', {}, data['text/plain'] ?? ''));
      if (widget) box.append(h('p', {}, NEEDS_LAB, labLink()));
    }
    return box;
  }

  const FORMULA = /\$\$[\s\S]+?\$\$|\$[^$\n]+\$/g;

  /** Show Markdown, for example the statement of a problem. Its formulas are kept from marked, and typeset afterwards. */
  async function showMarkdown(box, text) {
    await load(MARKED);
    const formulas = text.match(FORMULA) ?? [];
    const html = window.marked.parse(text.replace(FORMULA, () => '\0'));
    let next = 0;
    box.innerHTML = siteLinks(html.replace(/[\0\ufffd]/g, () => h('i', {}, formulas[next++]).innerHTML));
    typeset(box);
  }

  /** What the reader answers to a question of the page is pressed in the widget of this question, too. */
  function pressAnswers(box, widget) {
    const section = box.querySelector('[data-misstep-question]');
    const buttons = widgets?.buttons(widget) ?? [];
    if (!section || !buttons.length) return;
    const press = () => 'committed' in section.dataset && widgets.press(buttons[section.dataset.committed]);
    press();
    new MutationObserver(press).observe(section, { attributeFilter: ['data-committed'] });
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
    await typeset(box).catch(() => {}); // before the questions take their replies out of the box, until they are asked
    document.dispatchEvent(new CustomEvent('kinlib-content', { detail: { root: box, again } }));
    if (!box.querySelector('[data-kinlib-viewer], [data-kinlib-film]')) return;
    await load('viewer.js');
    kinlib.startViewers(box);
  }

  // --- the page of a sheet ---

  /** Add the problems that are solved to the record of progress (course.js). */
  function record(solved) {
    if (solved) document.dispatchEvent(new CustomEvent('kinlib-solved', { detail: [solved].flat() }));
  }

  /** The notebook of the sheet with what the reader has typed and the answers that were checked, which is handed in. */
  async function download() {
    const notebook = await (await fetch(SHEET)).json();
    const unchecked = [];
    for (const cell of cells) {
      const handedIn = notebook.cells.find(({ id }) => id === cell.id);
      const stored = cell.role === 'check' && cell.stored();
      if (cell.source() === cell.original && !stored) {
        if (cell.role === 'check') unchecked.push(cell.problem);
        continue;
      }
      handedIn.source = cell.source();
      handedIn.outputs = stored ? [stored] : [];
      handedIn.execution_count = null;
    }
    downloaded.textContent = unchecked.length
      ? `Not checked, or changed after the check, and so not graded: problem ${unchecked.join(', ')}. Press Check there, and download again.`
      : 'All answers are checked and stored in the notebook.';
    const file = new Blob([JSON.stringify(notebook, null, 1)], { type: 'application/x-ipynb+json' });
    const link = h('a', { href: URL.createObjectURL(file), download: SHEET.split('/').pop() });
    link.click();
    setTimeout(() => URL.revokeObjectURL(link.href), 10_000);
  }

  async function typeset(box) {
    if (!/\$|\\[([]/.test(box.textContent)) return;
    await load(KATEX);
    await load('katex/auto-render.min.js');
    const delimiters = [
      { left: '$$', right: '$$', display: true },
      { left: '$', right: '$', display: false },
    ];
    renderMathInElement(box, { delimiters, throwOnError: false });
    for (const { parentElement } of box.querySelectorAll('.katex')) keepPunctuation(parentElement, box);
  }

  /** Keep a short formula and the punctuation after it on one line: a browser may break a line after any formula. */
  function keepPunctuation(formula, box) {
    const following = formula.nextSibling;
    const [mark] = /^[.,;:?!)\]’”]+/.exec(following?.data ?? '') ?? [];
    if (!mark || formula.offsetWidth > box.offsetWidth / 2) return;
    const together = h('span', { class: 'together' });
    formula.before(together);
    together.append(formula, mark);
    following.deleteData(0, mark.length);
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
  if (SHEET) {
    for (const cell of cells) cell.isReady = true;
    for (const cell of cells) if (cell.role === 'check') cell.restore();
    document.querySelector('.kinlib-sample')?.remove(); // each problem says it itself
    markStale();
    showMyNumbers();
  }
  document.addEventListener('kinlib-needs-python', (event) => {
    const cell = cells.find(({ element }) => element.contains(event.target));
    if (!cell) return;
    event.preventDefault();
    run(cell, event.detail.refused);
  });
  // your_robot.js writes what its form says into a cell, and runs it and others
  document.addEventListener('kinlib-run', ({ detail }) => {
    const some = cells.filter(({ element }) => detail.elements.some((each) => element.contains(each)));
    const start = () => {
      detail.start?.();
      if (detail.source) some[0].edit(detail.source, false);
      for (const cell of some) cell.status.textContent = '';
      some[0].files = detail.files;
      for (const cell of some) run(cell);
    };
    if (hasAgreed()) start();
    else ask(some[0], start, undefined, detail.place);
  });
  const button = h('button', { type: 'button', class: 'kinlib-button', onclick: download }, 'Download with my answers');
  const downloaded = h('p', { role: 'status' });
  if (SHEET) cells.at(-1).element.after(h('p', {}, button), downloaded);
  note.replaceChildren(
    ...(SHEET
      ? [SHEET_INTRODUCTION]
      : [
          h(
            'details',
            {},
            h('summary', {}, `The code runs on this page. The first run loads ${PYTHON_SIZE}.`),
            h('ul', {}, ...DIFFERENCES.map((text) => h('li', {}, text))),
            h('p', {}, 'To have all of it:', ' ', labLink()),
          ),
        ]),
  );
})();
