// The form of the page Your robot: a URDF or a known arm, a table as it was pasted, and what the text does not say. It writes
// the answers into the cell of the notebook that compares the two, and runs that cell; live.js shows what Python answers.
(() => {
  'use strict';
  const h = window.kinlibElement; // of course.js
  const cellWith = (text) =>
    [...document.querySelectorAll('article div.cell')].find((cell) =>
      cell.querySelector('.cell_input pre')?.textContent.includes(text),
    );
  const compare = cellWith('found = examine(');
  const picture = cellWith('found.picture()');
  const practise = [cellWith('sheet = practise('), cellWith('sheet.check(')];
  const known = cellWith('known_arms()')?.querySelectorAll('tbody tr') ?? [];
  if (!h || !compare || !document.querySelector('[data-kinlib-lab]')) return;

  const MAX_BYTES = 20_000_000; // as in kincourse/your_robot.py
  const MAX_TABLE = 100_000;
  const MAX_LINKS = 2000;
  const EXAMPLE = compare.querySelector('.cell_input pre').textContent.match(/"""\n?([\s\S]*?)"""/)?.[1] ?? '';
  let urdf = '';

  const option = (value, text = value) => h('option', { value }, text);
  const select = (label, ...options) => {
    const field = h('select', {}, ...options);
    return { field, row: h('label', {}, `${label} `, field) };
  };
  const names = [...known].map((row) => row.cells[0].textContent.trim());
  const arm = select('Arm', option('', 'of a URDF file'), ...names.map((name) => option(name)));
  const base = select('from link');
  const tip = select('to link');
  const convention = select(
    'Convention',
    option('', 'as the text says'),
    option('standard'),
    option('modified', 'modified (Craig)'),
  );
  const lengths = select('Lengths in', option('', 'as the text says'), option('m'), option('cm'), option('mm'));
  const angles = select('Angles in', option('', 'as the text says'), option('rad'), option('deg', 'degrees'));
  const order = h('input', { placeholder: 'as the text says', size: 18, 'aria-label': 'Order of the columns' });

  const said = h('p', { role: 'status', class: 'kinlib-live-note' });
  const file = h('input', { type: 'file', accept: '.urdf,.xml', 'aria-label': 'A URDF file' });
  const urdfText = h('textarea', {
    rows: 3,
    spellcheck: 'false',
    'aria-label': 'The text of a URDF file',
    placeholder: 'Drop a URDF file here, choose one above, or paste its text',
  });
  const table = h('textarea', {
    rows: 9,
    spellcheck: 'false',
    'aria-label': 'A DH table',
    placeholder:
      'Paste a table: from a PDF, a web page, a spreadsheet, LaTeX, or code such as RevoluteDH(a=0.4, d=0.1)',
  });
  const links = h('p', { hidden: true }, base.row, ' ', tip.row, ' ', h('span', {}));
  const button = (label, onclick) => h('button', { type: 'button', class: 'kinlib-button', onclick }, label);

  /** The links of a file with the joint above each of them; null if it is no URDF. */
  function treeOf(text) {
    const robot = new DOMParser().parseFromString(text, 'text/xml').querySelector('robot');
    if (!robot) return null;
    const parents = new Map();
    for (const joint of robot.querySelectorAll(':scope > joint')) {
      const child = joint.querySelector('child')?.getAttribute('link');
      const isFixed = joint.getAttribute('type') === 'fixed';
      if (child) parents.set(child, { parent: joint.querySelector('parent')?.getAttribute('link'), isFixed });
    }
    const all = [...robot.querySelectorAll(':scope > link')].map((link) => link.getAttribute('name') ?? '');
    return { all: all.slice(0, MAX_LINKS), parents };
  }

  /** How many joints lie between a link and one above it, and the name of the root; NaN if there is a loop or no way. */
  function way({ parents }, from, to) {
    let joints = 0;
    let link = to;
    for (let steps = 0; link !== from; steps += 1) {
      const above = parents.get(link);
      if (!above || steps > MAX_LINKS) return { root: link, joints: from === undefined && !above ? joints : NaN };
      joints += above.isFixed ? 0 : 1;
      link = above.parent;
    }
    return { root: link, joints };
  }

  function setUrdf(text) {
    urdf = text;
    const tree = text.trim() ? treeOf(text) : null;
    links.hidden = !tree;
    said.textContent = text.trim() && !tree ? 'This text is no URDF file: it has no element <robot>.' : '';
    if (!tree) return;
    arm.field.value = '';
    const inner = new Set([...tree.parents.values()].map(({ parent }) => parent));
    const tips = tree.all.filter((link) => !inner.has(link));
    const count = (link) => way(tree, undefined, link).joints || 0;
    const longest = tips.reduce((best, link) => (count(link) > count(best) ? link : best), tips[0] ?? tree.all[0]);
    tip.field.replaceChildren(
      ...[...tree.all]
        .sort((one, other) => tips.includes(other) - tips.includes(one))
        .map((link) => option(link, `${link} (${count(link)} joints from the root)`)),
    );
    tip.field.value = longest;
    base.field.replaceChildren(...tree.all.map((link) => option(link)));
    base.field.value = way(tree, undefined, longest).root;
    const say = () => {
      const { joints } = way(tree, base.field.value, tip.field.value);
      links.lastChild.textContent = Number.isNaN(joints)
        ? 'There is no way between these links: choose a base above the tip.'
        : `${joints} joints lie between them.`;
    };
    base.field.onchange = say;
    tip.field.onchange = say;
    say();
  }

  async function readFile(chosen) {
    if (!chosen) return;
    if (chosen.size > MAX_BYTES) {
      said.textContent = `${chosen.name} has ${Math.round(chosen.size / 1e6)} MB; a URDF file may have at most 20 MB.`;
      return;
    }
    const text = await chosen.text();
    urdfText.value = text.length > 4000 ? `${text.slice(0, 4000)}\n...` : text;
    setUrdf(text);
  }

  file.addEventListener('change', () => readFile(file.files[0]));
  urdfText.addEventListener('input', () => setUrdf(urdfText.value));
  arm.field.addEventListener('change', () => {
    if (arm.field.value) links.hidden = true;
  });

  /** A text as a literal of Python. */
  const literal = (text) => JSON.stringify(text.replace(/\0/g, '')).replace(/\u007f/g, '\\u007f');

  function check() {
    const given = arm.field.value || urdf;
    if (!given.trim() && !table.value.trim()) {
      said.textContent = 'Choose an arm or a URDF file, or paste a table.';
      return;
    }
    if (table.value.length > MAX_TABLE || given.length > MAX_BYTES) {
      said.textContent = 'This text is too long: a table may have 100,000 characters, and a URDF file 20 million.';
      return;
    }
    said.textContent = '';
    const how = {
      ...(arm.field.value || links.hidden ? {} : { base: base.field.value, tip: tip.field.value }),
      convention: convention.field.value,
      length_unit: lengths.field.value,
      angle_unit: angles.field.value,
      order: order.value.trim(),
    };
    const options = Object.entries(how)
      .filter(([, value]) => value)
      .map(([name, value]) => `, ${name}=${literal(value)}`);
    const source = [
      'from kincourse.your_robot import examine',
      `arm = ${literal(given)}`,
      `table = ${literal(table.value)}`,
      `found = examine(arm, table${options.join('')})`,
      'found',
    ].join('\n');
    for (const cell of [compare, picture]) cell.querySelector('.cell_output')?.replaceChildren(); // of another robot
    for (const section of answer) section.hidden = false;
    run(compare, source);
    run(picture);
    answer[0].scrollIntoView({ behavior: 'smooth', block: 'start' });
  }

  const run = (cell, source) =>
    document.dispatchEvent(
      new CustomEvent('kinlib-run', { detail: { element: cell.querySelector('.cell_input'), source } }),
    );

  // The sections of the notebook with these cells show the answer, without their code; what they say of the code is left out.
  const answer = [compare, picture].map((cell) => cell.closest('section'));
  for (const section of answer) {
    section.classList.add('your-robot-result');
    section.hidden = true;
  }
  for (const about of answer[0].querySelectorAll(':scope > p')) about.remove();
  const form = h(
    'form',
    { class: 'your-robot', onsubmit: (event) => event.preventDefault() },
    h('fieldset', {}, h('legend', {}, '1. The arm'), h('p', {}, arm.row, ' ', file), urdfText, links),
    h(
      'fieldset',
      {},
      h('legend', {}, '2. Your table'),
      table,
      h('p', {}, convention.row, ' ', lengths.row, ' ', angles.row, ' ', h('label', {}, 'Columns ', order)),
      h(
        'p',
        {},
        button('Example', () => {
          arm.field.value = 'UR5e';
          table.value = EXAMPLE.trim();
          convention.field.value = 'standard';
          links.hidden = true;
        }),
      ),
    ),
    h('p', {}, button('Check', check), ' Python runs in this page; nothing that you give leaves your browser.'),
    said,
  );
  for (const zone of [urdfText, form]) {
    zone.addEventListener('dragover', (event) => event.preventDefault());
    zone.addEventListener('drop', (event) => {
      event.preventDefault();
      event.stopPropagation();
      readFile(event.dataTransfer.files[0]);
    });
  }
  const place =
    document.querySelector('article h1').parentElement.querySelector('ul') ?? document.querySelector('article h1');
  place.after(form);
  const start = () => {
    for (const cell of practise) run(cell);
  };
  practise[0].before(h('p', {}, button('Start with the robot of the form', start)));

  // Each corrected table gets a button that copies it.
  const addCopies = () => {
    for (const pre of compare.querySelectorAll('.cell_output details > pre:not([data-copy])')) {
      pre.dataset.copy = '';
      const copy = button('Copy', async () => {
        await navigator.clipboard.writeText(pre.textContent);
        copy.textContent = 'Copied';
      });
      pre.before(copy);
    }
  };
  new MutationObserver(addCopies).observe(compare, { childList: true, subtree: true });
  addCopies();
})();
