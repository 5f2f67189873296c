// Makes the pages interactive: questions that accept an answer and explain it, sliders between pictures, and a record
// of what was read and answered, which is stored in this browser only. The pages are complete without this script.
(() => {
  'use strict';
  const KEY = 'kinlib-course';
  const LETTERS = 'ABCDEFGH';

  const NO_STORAGE = [
    'This browser stores nothing for this page, because the window is private or the storage is full.',
    'Your answers are lost when you leave the page.',
  ].join(' ');

  const CONFIRM_DELETE =
    'Delete the record of the lectures that you have read, the questions that you have answered and the problems ' +
    'that you have solved, and also all ids, answers and code that you have typed on the pages?';
  const OURS = /^(kinlib|planar-arm)/; // the keys in localStorage of all scripts of the course

  // --- what this browser keeps; the other scripts of a page, which load after this one, use it, too ---

  window.kinlibStore = { read, write, sayNotStored };

  /** What was written under a key; undefined if that is nothing, or if it cannot be read. */
  function read(key) {
    try {
      return JSON.parse(localStorage.getItem(key)) ?? undefined;
    } catch {
      return undefined;
    }
  }

  /** Write a value under a key. Returns whether the browser has stored it. */
  function write(key, value) {
    try {
      localStorage.setItem(key, JSON.stringify(value));
      return true;
    } catch {
      return false;
    }
  }

  let storageWorks = true;
  function sayNotStored() {
    if (storageWorks) showNotice(NO_STORAGE);
    storageWorks = false;
  }

  // --- progress: { answers: { '03/order': 1 }, read: ['lectures/03_poe_space'], solved: ['03_poe_space/1'] } ---
  // The lab adds to `solved`: site/lab/extension.

  let progress = validProgress(read(KEY));

  /** A valid record, whatever was stored. */
  function validProgress(record) {
    const { answers, read, solved } = record ?? {};
    const list = (names) => (Array.isArray(names) ? names.map(String) : []);
    return { answers: answers && typeof answers === 'object' ? answers : {}, read: list(read), solved: list(solved) };
  }

  function updateProgress(change) {
    if (storageWorks) progress = { ...progress, ...validProgress(read(KEY)) }; // another tab may have changed the record
    change(progress);
    if (!write(KEY, progress)) sayNotStored();
  }

  /** Show a message at the lower edge of the window until it is closed. */
  function showNotice(text) {
    const close = h('button', { type: 'button', class: 'kinlib-button', onclick: () => notice.remove() }, 'Close');
    const notice = h('div', { class: 'kinlib-notice', role: 'status' }, h('p', {}, text), close);
    document.body.append(notice);
  }

  // live.js, which loads after this script, uses this function.
  window.kinlibElement = h;

  /** Create an element. */
  function h(tag, attributes = {}, ...children) {
    const element = document.createElement(tag);
    for (const [name, value] of Object.entries(attributes)) {
      if (name.startsWith('on')) element.addEventListener(name.slice(2), value);
      else if (value !== false) element.setAttribute(name, value === true ? '' : value);
    }
    element.append(...children);
    return element;
  }

  const cloneChildren = (element) => [...element.childNodes].map((node) => node.cloneNode(true));
  const all = (selector, root = document) => [...root.querySelectorAll(selector)];
  const elementsNamed = (attribute, name) => all(`[${attribute}="${CSS.escape(name)}"]`);

  // --- questions ---

  function startQuestion(section, again = false) {
    const name = section.dataset.misstepQuestion;
    const right = Number(section.dataset.right);
    const predicts = section.dataset.kind === 'predict';
    const reply = h('div', { class: 'kinlib-reply', role: 'status' });
    const options = all('.misstep-options > li', section).map((item) => ({
      item,
      text: cloneChildren(item.querySelector('summary') ?? item.querySelector('.misstep-option')),
      why: item.querySelector('.misstep-why'),
    }));
    const buttons = options.map(({ text }, k) =>
      h(
        'button',
        {
          type: 'button',
          class: 'kinlib-choice',
          'aria-pressed': 'false',
          onclick: () => commit(k),
        },
        h('b', {}, LETTERS[k]),
        h('span', {}, ...text),
      ),
    );
    for (const [k, { item }] of options.entries()) item.replaceChildren(buttons[k]);
    section.append(reply);
    section.dataset.started = '';

    function commit(k) {
      if ('committed' in section.dataset) return; // the first answer counts
      updateProgress(({ answers }) => {
        answers[name] ??= k; // the first answer counts, also if the question is shown again
      });
      show(k);
      document.dispatchEvent(new CustomEvent('kinlib-committed', { detail: name }));
    }

    function show(k) {
      section.dataset.committed = k;
      buttons.forEach((button, index) => {
        button.setAttribute('aria-disabled', 'true');
        button.setAttribute('aria-pressed', String(index === k));
        if (predicts || (index !== k && index !== right)) return;
        const tone = index === right ? 'right' : 'wrong';
        button.dataset.verdict = tone;
        button.append(h('span', { class: 'kinlib-verdict' }, tone === 'right' ? '✓ correct' : '✗ not correct'));
      });
      if (predicts) {
        buttons[k].append(h('span', { class: 'kinlib-verdict' }, '● your prediction'));
        reply.replaceChildren(h('p', {}, `You predicted ${LETTERS[k]}. The answer is below.`));
      } else {
        reply.replaceChildren(
          ...explainAnswer(
            k,
            right,
            (index) => options[index].why,
            (index) => options[index].text,
          ),
        );
      }
    }

    const before = again && !predicts ? null : progress.answers[name];
    if (Number.isInteger(before) && before in options) show(before);
  }

  /** The explanation of option k: why it is correct, or why not and which one is. If k is null, only which one is. */
  function explainAnswer(k, right, why, text) {
    // each text begins with a verdict, which is left out here; the lesson that follows may be all that there is to say
    const said = (index) => {
      const words = cloneChildren(why(index)).slice(1);
      return words.length ? [h('p', {}, ...words)] : [];
    };
    if (k === right)
      return [h('p', { class: 'kinlib-title', 'data-tone': 'right' }, `✓ ${LETTERS[k]} is correct`), ...said(k)];
    const wrong = () => [
      h('p', { class: 'kinlib-title', 'data-tone': 'wrong' }, `✗ ${LETTERS[k]} is not correct`),
      ...said(k),
    ];
    return [
      ...(k === null ? [h('p', { class: 'kinlib-title' }, 'Shown without a prediction')] : wrong()),
      h(
        'p',
        {},
        h('strong', {}, `The correct answer is ${LETTERS[right]}: `),
        ...text(right).map((node) => node.cloneNode(true)),
      ),
      ...said(right),
    ];
  }

  /** What stands in place of a picture or an explanation until a prediction is made: a line without a frame. */
  function waitingLine(what, onclick) {
    return h(
      'p',
      {},
      `The ${what} appears here when you have committed to your prediction above. `,
      h('button', { type: 'button', class: 'kinlib-button', onclick }, 'Show anyway'),
    );
  }

  /** Open the explanation of a prediction with the answer, or when the reader asks to see it without one. */
  function startExplanation(section) {
    const name = section.dataset.misstepExplain;
    const asked = () => elementsNamed('data-misstep-question', name)[0]; // another one after its cell was run again
    if (!asked()) return;
    const items = all('.misstep-options > li', section);
    const lesson = section.querySelector('.misstep-lesson');
    const reply = h('div', { role: 'status', tabindex: -1 });
    const waits = waitingLine('explanation', () => {
      show(null);
      reply.focus({ preventScroll: true }); // the button is gone
    });
    section.classList.add('kinlib-waiting');
    section.replaceChildren(waits, reply);

    function show(k) {
      section.classList.remove('kinlib-waiting');
      waits.remove();
      reply.replaceChildren(
        ...explainAnswer(
          k,
          Number(asked().dataset.right),
          (index) => items[index].querySelector('.misstep-why'),
          (index) => cloneChildren(items[index].querySelector('p')),
        ),
      );
      section.append(lesson);
      makeWideContentFocusable();
    }
    const showComparison = () => show(Number(asked().dataset.committed));
    document.addEventListener('kinlib-committed', ({ detail }) => {
      if (detail === name && section.isConnected) showComparison();
    });
    if ('committed' in asked().dataset) showComparison();
  }

  // --- pictures that are covered until a prediction is made ---

  const committed = (name) =>
    elementsNamed('data-misstep-question', name).some((section) => 'committed' in section.dataset);

  /** Whether a picture waits for a question of this page. In a frame, it may be alone. */
  const waits = ({ dataset: { kinlibAfter } }) => elementsNamed('data-misstep-question', kinlibAfter).length > 0;

  function uncoverViewerLater(element) {
    const name = element.dataset.kinlibAfter;
    const uncover = () => {
      element.dataset.uncovered = ''; // the viewer observes this attribute, and reads it when it starts
    };
    if (committed(name) || !waits(element)) uncover();
    document.addEventListener('kinlib-committed', ({ detail }) => detail === name && uncover());
  }

  // --- progress ---

  function startReadButton(element) {
    const name = element.dataset.kinlibDone;
    const status = h('span', { role: 'status' });
    const button = h('button', {
      type: 'button',
      class: 'kinlib-button',
      onclick: () => {
        updateProgress((record) => {
          record.read = record.read.includes(name)
            ? record.read.filter((other) => other !== name)
            : [...record.read, name];
        });
        show();
      },
    });
    const more = element.dataset.progress ? h('a', { href: element.dataset.progress }, 'Your progress') : '';
    element.append(button, status, more);
    element.hidden = false;

    function show() {
      const read = progress.read.includes(name);
      button.textContent = read ? 'Mark this lecture as not read' : 'Mark this lecture as read';
      status.textContent = read ? '✓ You have read this lecture.' : '';
      markReadLectures();
    }
    show();
  }

  /** Tick the lectures that were read in the table of contents. */
  function markReadLectures() {
    for (const link of all('.sidebar-tree a.reference')) {
      const target = new URL(link.href, location.href).pathname.replace(/\.html$/, '');
      link.classList.toggle(
        'kinlib-read',
        progress.read.some((name) => target.endsWith(`/${name}`)),
      );
    }
  }

  function startProgressTable(element) {
    const status = h('p', { role: 'status' });
    const file = h('input', {
      type: 'file',
      accept: 'application/json,.json',
      class: 'visually-hidden',
      'aria-label': 'Saved copy to load',
      tabindex: -1,
      onchange: loadCopy,
    });
    element.append(
      h(
        'div',
        { class: 'kinlib-buttons' },
        h('button', { type: 'button', class: 'kinlib-button', onclick: saveCopy }, 'Save a copy'),
        h('button', { type: 'button', class: 'kinlib-button', onclick: () => file.click() }, 'Load a copy'),
        h('button', { type: 'button', class: 'kinlib-button', onclick: deleteProgress }, 'Delete everything'),
        file,
      ),
      status,
    );
    fillTable();

    function fillTable() {
      for (const row of all('tr[data-lecture]', element)) {
        const names = row.dataset.questions.split(' ');
        const answered = names.filter((name) => name in progress.answers);
        row.querySelector('[data-read]').textContent = progress.read.includes(row.dataset.lecture)
          ? '✓ read'
          : 'not yet';
        row.querySelector('[data-answered]').textContent = `${answered.length} of ${names.length}`;
        const mine = `${row.dataset.lecture.replace('lectures/', '')}/`;
        const solved = progress.solved.filter((name) => name.startsWith(mine)).length;
        if (row.dataset.problems > 0)
          row.querySelector('[data-solved]').textContent = `${solved} of ${row.dataset.problems}`;
        const keys = row.dataset.keys.split(' ');
        row.querySelector('[data-right]').textContent = names.filter(
          (name, k) => progress.answers[name] === Number(keys[k]),
        ).length;
      }
      markReadLectures();
    }

    function saveCopy() {
      const link = h('a', {
        href: URL.createObjectURL(new Blob([JSON.stringify(progress, null, 1)], { type: 'application/json' })),
        download: 'kinlib-progress.json',
      });
      link.click();
      URL.revokeObjectURL(link.href);
      status.textContent = 'Saved as kinlib-progress.json.';
    }

    async function loadCopy() {
      try {
        const copy = JSON.parse(await file.files[0].text());
        if (!copy.answers || typeof copy.answers !== 'object' || !Array.isArray(copy.read))
          throw new TypeError('not a record of progress');
        const { answers, read, solved } = validProgress(copy);
        updateProgress((record) => {
          record.answers = { ...record.answers, ...answers };
          record.read = [...new Set([...record.read, ...read])];
          record.solved = [...new Set([...record.solved, ...solved])];
        });
        status.textContent = 'Loaded, and added to the progress in this browser.';
      } catch {
        status.textContent =
          'This file is not a copy of your progress. Choose a file kinlib-progress.json that was saved on this page.';
      }
      file.value = '';
      fillTable();
    }

    function deleteProgress() {
      if (!confirm(CONFIRM_DELETE)) return;
      progress = validProgress(null);
      if (write(KEY, progress))
        for (const key of Object.keys(localStorage)) if (OURS.test(key)) localStorage.removeItem(key);
      status.textContent = 'Deleted.';
      fillTable();
    }
  }

  // --- content that is wider than the page can be scrolled with the keyboard ---

  let measuring = false;

  function makeWideContentFocusable() {
    if (measuring) return;
    measuring = true;
    // after the next frame everything has its place, so that measuring costs nothing
    requestAnimationFrame(() => setTimeout(measure));
  }

  function measure() {
    measuring = false;
    for (const element of all('article pre, article .table-wrapper, article div.math, article .kinlib-progress')) {
      const wide = element.scrollWidth > element.clientWidth;
      if (wide) element.setAttribute('tabindex', '0');
      else element.removeAttribute('tabindex');
    }
  }

  function startContent(root, again = false) {
    for (const section of all('[data-misstep-question]', root)) startQuestion(section, again);
    all('[data-misstep-explain]', root).forEach(startExplanation);
    all(':is([data-kinlib-viewer], [data-kinlib-film])[data-kinlib-after]', root).forEach(uncoverViewerLater);
    makeWideContentFocusable();
  }

  // --- a link to a folded section, or into it, opens it ---

  function openFolds() {
    const target = location.hash && document.getElementById(decodeURIComponent(location.hash.slice(1)));
    if (!target) return;
    const own = target.querySelector(':scope > details.kinlib-side');
    for (let fold = own ?? target.closest('details'); fold; fold = fold.parentElement.closest('details'))
      fold.open = true;
    holdInPlace(target);
  }

  let release = () => {};

  /** Go to what a link leads to, and stay there while viewers above it start and change their height, until the reader scrolls. */
  function holdInPlace(target) {
    release();
    const listening = new AbortController();
    const heights = new ResizeObserver(() => target.scrollIntoView({ behavior: 'instant' }));
    release = () => {
      heights.disconnect();
      listening.abort();
    };
    const options = { passive: true, signal: listening.signal };
    for (const kind of ['wheel', 'touchmove', 'keydown', 'pointerdown'])
      addEventListener(kind, () => release(), options);
    heights.observe(document.querySelector('article')); // furo's body has the height of the window
  }

  // --- the bar of a phone: the page and the section that is read ---

  function startBar() {
    const bar = document.querySelector('.mobile-header .brand');
    const title = document.querySelector('article h1');
    if (!bar || !title) return;
    const course = bar.textContent;
    const heading = (element) => {
      const copy = element.cloneNode(true);
      for (const extra of all('.katex-html, annotation, .headerlink', copy)) extra.remove();
      return copy.textContent.trim();
    };
    const sections = all('article h2');
    let waiting = false;

    function show() {
      waiting = false;
      const edge = bar.closest('header').offsetHeight;
      const passed = sections.filter((section) => section.getBoundingClientRect().top < edge + 40).at(-1);
      if (title.getBoundingClientRect().bottom > edge) bar.replaceChildren(course);
      else bar.replaceChildren(heading(title), ...(passed ? [h('span', {}, heading(passed))] : []));
    }
    const onScroll = () => {
      if (!waiting) requestAnimationFrame(show);
      waiting = true;
    };
    addEventListener('scroll', onScroll, { passive: true });
    show();
  }

  // --- addresses of single things, and their links to copy ---

  /** A button that copies a text, and says so. `text` is called when it is pressed. */
  function copyButton(label, text, className = 'kinlib-button') {
    const button = h('button', { type: 'button', class: className, onclick: copy }, label);
    async function copy() {
      try {
        await navigator.clipboard.writeText(text());
        button.textContent = 'Copied';
      } catch {
        button.textContent = 'Not copied: this browser forbids it';
      }
      setTimeout(() => {
        button.textContent = label;
      }, 2000);
    }
    return button;
  }

  const addressOf = (hash) => location.href.split('#')[0] + hash;

  /** The joint values of a viewer that has started, as the end of an address; nothing if it shows no single arm. */
  function configurationHash(viewer) {
    const model = viewer?.querySelector('.kv')?.viewer.model;
    if (!model?.get('scene')?.arms?.[0]?.links) return '';
    return `#q=${model.get('q').map((value) => Number(value.toFixed(4)))}`;
  }

  /** Buttons that copy code, without the prompts of a console. */
  function addCopyButtons() {
    const code = '.cell_input .highlight, [class*="highlight-python"] .highlight, .highlight-console .highlight';
    for (const block of all(code)) {
      const written = () => block.querySelector('textarea')?.value ?? block.querySelector('pre').textContent;
      const text = () => written().replace(/^(>>>|\.\.\.|\$) /gm, '');
      block.append(copyButton('Copy', text, 'kinlib-copy'));
    }
  }

  // --- the configuration of an arm in the address of its page: #q=0.5,1,-1.3 ---

  const CONFIGURATION = /^#q=([-+\d.,e]+)$/;

  /** The joint values of the address, if they are as many as the arm has. */
  function configurationOf(count) {
    const values = CONFIGURATION.exec(location.hash)?.[1].split(',').map(Number) ?? [];
    return values.length === count && values.every(Number.isFinite) ? values : null;
  }

  /** Before the viewer starts, put the values of the address into its state; afterwards, follow the address. */
  function startConfiguration() {
    const [element, ...others] = all('[data-kinlib-viewer]').filter((viewer) => !waits(viewer));
    const script = element?.querySelector('script[type="application/json"]');
    if (!script || others.length) return;
    const state = JSON.parse(script.textContent);
    if (!state.q || !state.scene?.arms?.[0]?.links) return;
    const model = () => element.querySelector('.kv')?.viewer.model;
    const follow = () => {
      const q = configurationOf(state.q.length);
      if (!q) return;
      if (model()) model().set('q', q);
      else script.textContent = JSON.stringify({ ...state, q });
    };
    follow();
    addEventListener('hashchange', follow);
    const hash = () => configurationHash(element) || `#q=${state.q}`;
    element.after(
      h(
        'p',
        {},
        copyButton('Copy a link to this configuration', () => addressOf(hash())),
      ),
    );
  }

  // --- what was read opens again without a network ---

  /** Let service-worker.js store this page and its Python; what was loaded before it was there is loaded again. */
  async function keepForLater() {
    const root = new URL(document.documentElement.dataset.content_root ?? '.', location.href);
    const folder = new URL('.', location.href);
    const isFrame = window !== window.top || document.querySelector('base');
    if (!navigator.serviceWorker || isFrame || folder.href === root.href) return;
    const isKept = navigator.serviceWorker.controller;
    const script = new URL('service-worker.js', root);
    const scopes = [folder, new URL('lab/live/', root)]; // the worker with Python is in the second; not the rest of the lab
    await Promise.all(scopes.map((scope) => navigator.serviceWorker.register(script, { scope })));
    if (isKept) return;
    await navigator.serviceWorker.ready;
    if (!navigator.serviceWorker.controller) {
      await new Promise((resolve) => {
        navigator.serviceWorker.addEventListener('controllerchange', resolve, { once: true });
      });
    }
    const loaded = performance.getEntriesByType('resource').map(({ name }) => name);
    const own = [location.href, ...loaded].filter((address) => address.startsWith(root.href));
    for (const address of new Set(own.map((one) => one.replace(/#.*/, '')))) await fetch(address);
  }

  document.documentElement.classList.remove('no-js');
  startConfiguration();
  addCopyButtons();
  startContent(document);
  startBar();
  // live.js adds outputs of cells that the reader runs; a self-check that was run again can be answered again
  document.addEventListener('kinlib-content', ({ detail }) => startContent(detail.root, detail.again));
  // and the problems of a sheet that were solved on its page
  document.addEventListener('kinlib-solved', ({ detail }) => {
    const names = detail.map(({ sheet, problem }) => `${sheet}/${problem}`);
    updateProgress((record) => {
      record.solved = [...new Set([...record.solved, ...names])];
    });
  });
  all('[data-kinlib-done]').forEach(startReadButton);
  all('[data-kinlib-progress]').forEach(startProgressTable);
  markReadLectures();
  addEventListener('load', () => keepForLater().catch(() => {})); // a browser may refuse to store
  openFolds();
  addEventListener('hashchange', openFolds);
  addEventListener('beforeprint', () => {
    for (const image of all('img[loading]')) image.loading = 'eager'; // on paper nothing is scrolled into view
  });
  addEventListener('resize', makeWideContentFocusable);
  document.addEventListener('toggle', makeWideContentFocusable, true);
})();
