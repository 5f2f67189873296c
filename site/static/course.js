// Brings the pages to life: questions that take an answer and explain it, sliders between pictures, and what was read and
// answered, which is kept in this browser and sent to nobody. Without it the pages still tell everything.
(() => {
  'use strict';
  const KEY = 'kinlib-course';
  const LETTERS = 'ABCDEFGH';
  const NO_MEMORY =
    'This browser keeps nothing for this page (private window, or storage full). Your answers last until you leave it.';

  // --- memory: { answers: { '03/order': 1 }, read: ['lectures/03_poe_space'], solved: ['03_poe_space/1'] } ---
  // What is solved, the lab notes there: site/lab/extension.

  let lasting = true;
  let memory = recall();

  function recall() {
    try {
      return sound(JSON.parse(localStorage.getItem(KEY)));
    } catch {
      return sound(null); // no storage, or nothing of ours in it
    }
  }

  /** What was kept, whatever else it may be. */
  function sound(kept) {
    const { answers, read, solved } = kept ?? {};
    const list = (names) => (Array.isArray(names) ? names.map(String) : []);
    return { answers: answers && typeof answers === 'object' ? answers : {}, read: list(read), solved: list(solved) };
  }

  function keep(change) {
    if (lasting) memory = { ...memory, ...recall() }; // another tab may have been at work
    change(memory);
    try {
      localStorage.setItem(KEY, JSON.stringify(memory));
    } catch {
      if (lasting) document.body.append(h('p', { class: 'visually-hidden', role: 'status' }, NO_MEMORY));
      lasting = false;
    }
  }

  function h(tag, attributes = {}, ...children) {
    const element = document.createElement(tag);
    for (const [name, value] of Object.entries(attributes)) {
      if (name.startsWith('on')) element.addEventListener(name.slice(2), value);
      else if (value !== false) element.setAttribute(name, value === true ? '' : value);
    }
    element.append(...children);
    return element;
  }

  const copied = (element) => [...element.childNodes].map((node) => node.cloneNode(true));
  const all = (selector, root = document) => [...root.querySelectorAll(selector)];
  const named = (attribute, name) => all(`[${attribute}="${CSS.escape(name)}"]`);

  // --- questions ---

  function question(section) {
    const name = section.dataset.kinlibQuestion;
    const right = Number(section.dataset.right);
    const predicts = section.dataset.kind === 'predict';
    const reply = h('div', { class: 'kinlib-reply', role: 'status' });
    const options = all('.kinlib-options > li', section).map((item) => ({
      item,
      text: copied(item.querySelector('summary') ?? item.querySelector('.kinlib-option')),
      why: item.querySelector('.kinlib-why'),
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
      if ('committed' in section.dataset) return; // the first one stands
      keep(({ answers }) => {
        answers[name] = k;
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
        button.append(h('span', { class: 'kinlib-verdict' }, tone === 'right' ? '✓ right' : '✗ not it'));
      });
      if (predicts) {
        buttons[k].append(h('span', { class: 'kinlib-verdict' }, '● your prediction'));
        reply.replaceChildren(h('p', {}, `You said ${LETTERS[k]}. Now look, and then compare.`));
      } else {
        reply.replaceChildren(
          ...verdict(
            k,
            right,
            (index) => options[index].why,
            (index) => options[index].text,
          ),
        );
      }
    }

    const before = memory.answers[name];
    if (Number.isInteger(before) && before in options) show(before);
  }

  /** What there is to say of option k: why it is right, or why it is not and what is. */
  function verdict(k, right, why, text) {
    const said = (index) => [...copied(why(index))].slice(1); // without the "Right." or "Not it." before it
    if (k === right)
      return [
        h('p', { class: 'kinlib-title', 'data-tone': 'right' }, `✓ ${LETTERS[k]} is right`),
        h('p', {}, ...said(k)),
      ];
    return [
      h('p', { class: 'kinlib-title', 'data-tone': 'wrong' }, `✗ ${LETTERS[k]} is not it`),
      h('p', {}, ...said(k)),
      h('p', {}, h('strong', {}, `Right is ${LETTERS[right]}: `), ...text(right).map((node) => node.cloneNode(true))),
      h('p', {}, ...said(right)),
    ];
  }

  function explanation(section) {
    const name = section.dataset.kinlibExplain;
    const asked = named('data-kinlib-question', name)[0];
    if (!asked) return;
    const details = section.querySelector('details');
    const items = all('.kinlib-options > li', section);
    const summary = section.querySelector('summary');
    const waits = h('p', {}, 'You have not committed to your prediction yet. What came of it appears here.');
    const reply = h('div', { role: 'status' });
    const told = h('p', {}, ...copied(summary));
    section.prepend(told, waits, reply);
    details.hidden = true;

    function show() {
      if (!('committed' in asked.dataset)) return;
      waits.hidden = true;
      reply.replaceChildren(
        ...verdict(
          Number(asked.dataset.committed),
          Number(asked.dataset.right),
          (index) => items[index].querySelector('.kinlib-why'),
          (index) => copied(items[index].querySelector('p')),
        ),
      );
    }
    document.addEventListener('kinlib-committed', ({ detail }) => detail === name && show());
    show();
  }

  // --- what waits for a prediction ---

  const committed = (name) => named('data-kinlib-question', name).some((section) => 'committed' in section.dataset);

  function viewer(element) {
    const name = element.dataset.kinlibAfter;
    const uncover = () => {
      element.dataset.uncovered = '';
    }; // the viewer looks for it, awake or when it wakes
    if (committed(name)) uncover();
    document.addEventListener('kinlib-committed', ({ detail }) => detail === name && uncover());
  }

  function slides(element) {
    const frames = all(':scope > [data-value]', element);
    const name = element.dataset.kinlibAfter;
    const begin = Number(element.dataset.start);
    const value = h('output', {});
    const range = h('input', {
      type: 'range',
      min: 0,
      max: frames.length - 1,
      step: 1,
      value: begin,
      oninput: () => show(Number(range.value)),
    });
    const stage = h('div', {}, ...frames);
    const bar = h('label', {}, h('span', {}, element.dataset.label), range, value);
    const anyway = h('button', { type: 'button', class: 'kinlib-button', onclick: () => uncover() }, 'Show anyway');
    const cover = h(
      'div',
      {},
      h('p', { class: 'kinlib-title' }, 'Commit to your prediction above first'),
      h('p', {}, 'The picture appears here as soon as you have.'),
      anyway,
    );
    element.classList.add('kinlib-slides');
    element.append(cover, stage, bar);

    function show(k) {
      frames.forEach((frame, index) => {
        frame.hidden = index !== k;
      });
      value.textContent = frames[k].dataset.value;
      range.setAttribute('aria-valuetext', frames[k].dataset.value);
    }

    function uncover() {
      cover.hidden = true;
      stage.hidden = bar.hidden = false;
      bar.style.display = '';
    }

    show(begin);
    cover.hidden = true;
    if (!name || committed(name) || !named('data-kinlib-question', name).length) return;
    cover.hidden = false;
    stage.hidden = true;
    bar.style.display = 'none';
    document.addEventListener('kinlib-committed', ({ detail }) => detail === name && uncover());
  }

  // --- progress ---

  function done(element) {
    const name = element.dataset.kinlibDone;
    const status = h('span', { role: 'status' });
    const button = h('button', {
      type: 'button',
      class: 'kinlib-button',
      onclick: () => {
        keep((kept) => {
          kept.read = kept.read.includes(name) ? kept.read.filter((other) => other !== name) : [...kept.read, name];
        });
        show();
      },
    });
    const more = element.dataset.progress ? h('a', { href: element.dataset.progress }, 'Your progress') : '';
    element.append(button, status, more);
    element.hidden = false;

    function show() {
      const read = memory.read.includes(name);
      button.textContent = read ? 'Not read after all' : 'Mark this lecture as read';
      status.textContent = read ? '✓ You have read this lecture.' : '';
      marks();
    }
    show();
  }

  /** A tick beside each lecture that was read, in the table of contents. */
  function marks() {
    for (const link of all('.sidebar-tree a.reference')) {
      const target = new URL(link.href, location.href).pathname.replace(/\.html$/, '');
      link.classList.toggle(
        'kinlib-read',
        memory.read.some((name) => target.endsWith(`/${name}`)),
      );
    }
  }

  function progress(element) {
    const status = h('p', { role: 'status' });
    const file = h('input', {
      type: 'file',
      accept: 'application/json,.json',
      class: 'visually-hidden',
      'aria-label': 'A copy to read back',
      tabindex: -1,
      onchange: readBack,
    });
    element.append(
      h(
        'div',
        { class: 'kinlib-buttons' },
        h('button', { type: 'button', class: 'kinlib-button', onclick: copyOut }, 'Save a copy'),
        h('button', { type: 'button', class: 'kinlib-button', onclick: () => file.click() }, 'Read a copy back'),
        h('button', { type: 'button', class: 'kinlib-button', onclick: forget }, 'Forget everything'),
        file,
      ),
      status,
    );
    fill();

    function fill() {
      for (const row of all('tr[data-lecture]', element)) {
        const names = row.dataset.questions.split(' ');
        const answered = names.filter((name) => name in memory.answers);
        row.querySelector('[data-read]').textContent = memory.read.includes(row.dataset.lecture) ? '✓ read' : 'not yet';
        row.querySelector('[data-answered]').textContent = `${answered.length} of ${names.length}`;
        const mine = `${row.dataset.lecture.replace('lectures/', '')}/`;
        const solved = memory.solved.filter((name) => name.startsWith(mine)).length;
        if (row.dataset.problems > 0)
          row.querySelector('[data-solved]').textContent = `${solved} of ${row.dataset.problems}`;
        const keys = row.dataset.keys.split(' ');
        row.querySelector('[data-right]').textContent = names.filter(
          (name, k) => memory.answers[name] === Number(keys[k]),
        ).length;
      }
      marks();
    }

    function copyOut() {
      const link = h('a', {
        href: URL.createObjectURL(new Blob([JSON.stringify(memory, null, 1)], { type: 'application/json' })),
        download: 'kinlib-progress.json',
      });
      link.click();
      URL.revokeObjectURL(link.href);
      status.textContent = 'Saved as kinlib-progress.json.';
    }

    async function readBack() {
      try {
        const copy = JSON.parse(await file.files[0].text());
        if (!copy.answers || typeof copy.answers !== 'object' || !Array.isArray(copy.read))
          throw new TypeError('another file');
        const { answers, read, solved } = sound(copy);
        keep((kept) => {
          kept.answers = { ...kept.answers, ...answers };
          kept.read = [...new Set([...kept.read, ...read])];
          kept.solved = [...new Set([...kept.solved, ...solved])];
        });
        status.textContent = 'Read back, and added to what was here.';
      } catch {
        status.textContent =
          'This is no copy of your progress. It should be a file named kinlib-progress.json, saved on this page.';
      }
      file.value = '';
      fill();
    }

    function forget() {
      if (!confirm('Forget which lectures you have read, what you have answered and what you have solved?')) return;
      memory = sound(null);
      try {
        localStorage.removeItem(KEY);
      } catch {
        /* nothing was kept */
      }
      status.textContent = 'Forgotten.';
      fill();
    }
  }

  // --- what is wider than the page can be scrolled with the keys ---

  function scrollable() {
    for (const element of all('article pre, article .table-wrapper, article div.math, article .kinlib-progress')) {
      const wide = element.scrollWidth > element.clientWidth + 1;
      if (wide) element.setAttribute('tabindex', '0');
      else element.removeAttribute('tabindex');
    }
  }

  document.documentElement.classList.remove('no-js');
  all('[data-kinlib-question]').forEach(question);
  all('[data-kinlib-explain]').forEach(explanation);
  all('[data-kinlib-viewer][data-kinlib-after]').forEach(viewer);
  all('[data-kinlib-slides]').forEach(slides);
  all('[data-kinlib-done]').forEach(done);
  all('[data-kinlib-progress]').forEach(progress);
  marks();
  scrollable();
  addEventListener('resize', scrollable);
})();
