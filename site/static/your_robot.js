// The form of the page Your robot: a URDF or a known arm, a table as it was pasted, and what the text does not say. It writes
// the answers into the cell of the notebook that compares the two, and runs that cell; live.js shows what Python answers.
(() => {
  'use strict';
  const { kinlibElement: h, kinlibStore: store } = window; // of course.js
  const cellWith = (text) =>
    [...document.querySelectorAll('article div.cell')].find((cell) =>
      cell.querySelector('.cell_input pre')?.textContent.includes(text),
    );
  const [compare, picture] = ['found = examine(', 'found.picture()'].map(cellWith);
  const practise = [cellWith('sheet = practise('), cellWith('sheet.check(')];
  const known = cellWith('KnownArms()')?.querySelectorAll('tbody tr') ?? [];
  if (!h || !compare || !document.querySelector('[data-kinlib-lab]')) return;

  const MAX_BYTES = 4_000_000; // as in kinlib/urdf/xml_elements.py
  const MAX_LINKS = 2000;
  const MAX_FILES = 5000; // of a folder or an archive that is dropped
  const MAX_MESHES = 80_000_000; // bytes together, as in kinlib/view/viewer/meshes.py
  const KEY = `kinlib-your-robot:${location.pathname}`; // in localStorage: what the form says
  const HOW = ['convention', 'length_unit', 'angle_unit', 'order'];
  const PLACE = 'robot/urdf/robot.urdf'; // where Python finds a dropped file, with its meshes around it
  const EXAMPLE = compare.querySelector('.cell_input pre').textContent.match(/"""\n?([\s\S]*?)"""/)?.[1] ?? '';
  let urdf = '';
  let meshes = []; // [{ path, file }] of a folder or an archive
  const inWords = (joints) => `${joints} joint${joints === 1 ? '' : 's'}`;
  const option = (value, text = value) => h('option', { value }, text);
  const form = h('form', { class: 'your-robot', onsubmit: (event) => event.preventDefault() });
  form.innerHTML = `
    <fieldset><legend>1. The arm</legend>
      <p><label>Arm <select name="arm"><option value="">of a URDF file</option></select></label>
        <input type="file" name="file" accept=".urdf,.xml,.zip" aria-label="A URDF file, or a zip archive with its meshes">
        <label hidden>File <select name="which"></select></label></p>
      <p role="status" class="kinlib-live-note"></p>
      <textarea name="urdf" rows="3" spellcheck="false" aria-label="The text of a URDF file" placeholder="Drop a URDF file here, or a folder or zip archive with its meshes; choose one above; or paste its text"></textarea>
      <p hidden><label>from link <select name="base"></select></label> <label>to link <select name="tip"></select></label>
        <span></span></p></fieldset>
    <fieldset><legend>2. Your table</legend>
      <textarea name="table" rows="9" spellcheck="false" aria-label="A DH table" placeholder="Paste a table: from a PDF, a web page, a spreadsheet, LaTeX, or code such as RevoluteDH(a=0.4, d=0.1)"></textarea>
      <p><label>Convention <select name="convention"><option value="">as the text says</option>
          <option value="standard">standard</option><option value="modified">modified (Craig)</option></select></label>
        <label>Lengths in <select name="length_unit"><option value="">as the text says</option>
          <option>m</option><option>cm</option><option>mm</option></select></label>
        <label>Angles in <select name="angle_unit"><option value="">as the text says</option>
          <option>rad</option><option value="deg">degrees</option></select></label>
        <label>Columns <input name="order" placeholder="as the text says" size="18"></label></p>
      <p><button type="button" name="example" class="kinlib-button">Example</button></p></fieldset>
    <p><button type="button" name="check" class="kinlib-button">Check</button>
      Python runs in this page; nothing that you give leaves your browser.</p>
    <p role="status" class="kinlib-live-note"></p>`;
  const { arm, file, which, urdf: urdfText, base, tip, table, example, check } = form.elements;
  arm.append(...[...known].map((row) => option(row.cells[0].textContent.trim())));
  const [aboutFile, said] = form.querySelectorAll('[role="status"]'); // each beside its field
  const links = base.closest('p');
  const button = (label, onclick) => h('button', { type: 'button', class: 'kinlib-button', onclick }, label);

  /** A file as a document, without prefixes such as drake:, which makers write and do not declare. */
  const parsed = (text) =>
    new DOMParser().parseFromString(text.replace(/(<\/?|\s)[\w-]+:(?=[\w-]+[\s=>/])/g, '$1'), 'text/xml');

  /** The links of a file with the joint above each of them; null if it is no URDF. */
  function treeOf(text) {
    const robot = parsed(text).querySelector('robot');
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
    meshes = [];
    const tree = text.trim() ? treeOf(text) : null;
    links.hidden = !tree;
    aboutFile.textContent = text.trim() && !tree ? 'This text is no URDF file: it has no element <robot>.' : '';
    if (!tree) return;
    arm.value = '';
    const inner = new Set([...tree.parents.values()].map(({ parent }) => parent));
    const isEnd = (link) => !inner.has(link);
    tip.replaceChildren(
      option('', 'the end of the arm, without a gripper'),
      ...[...tree.all]
        .sort((one, other) => isEnd(other) - isEnd(one))
        .map((link) => option(link, `${link} (${inWords(way(tree, undefined, link).joints || 0)} from the root)`)),
    );
    base.replaceChildren(...tree.all.map((link) => option(link)));
    base.value = way(tree, undefined, tree.all[0]).root;
    const say = () => {
      const { joints } = way(tree, base.value, tip.value);
      const between = Number.isNaN(joints)
        ? 'There is no way between these links: choose a base above the tip.'
        : `Between them: ${inWords(joints)}.`;
      links.lastChild.textContent = tip.value ? between : 'The answer names it.';
    };
    base.onchange = say;
    tip.onchange = say;
    say();
  }

  function showUrdf(text) {
    urdfText.value = text.length > 4000 ? `${text.slice(0, 4000)}\n...` : text;
    setUrdf(text);
  }

  /** The files below dropped files and folders, each with its path and a function that reads it. */
  async function filesBelow(entries, folder = '') {
    const found = [];
    for (const entry of entries) {
      const path = `${folder}${entry.name}`;
      if (entry.isFile) {
        const file = await new Promise((resolve, reject) => entry.file(resolve, reject));
        found.push({ path, size: file.size, read: async () => file });
        continue;
      }
      const reader = entry.createReader();
      for (let some = [null]; some.length && found.length < MAX_FILES; ) {
        some = await new Promise((resolve, reject) => reader.readEntries(resolve, reject));
        found.push(...(await filesBelow(some, `${path}/`)));
      }
    }
    return found;
  }

  /** The files of a zip archive, by the table at its end. */
  async function filesOfArchive(archive) {
    const view = async (from, to) => new DataView(await archive.slice(from, to).arrayBuffer());
    const tail = await view(-66_000);
    let end = tail.byteLength - 22;
    while (end >= 0 && tail.getUint32(end, true) !== 0x06054b50) end -= 1;
    if (end < 0) throw new Error('it is no zip archive');
    const [length, start] = [12, 16].map((place) => tail.getUint32(end + place, true));
    const table = await view(start, start + length);
    const found = [];
    for (let at = 0; at + 46 <= table.byteLength && found.length < MAX_FILES; ) {
      const [method, name, extra, comment] = [10, 28, 30, 32].map((place) => table.getUint16(at + place, true));
      const [packed, size, offset] = [20, 24, 42].map((place) => table.getUint32(at + place, true));
      const path = new TextDecoder().decode(new Uint8Array(table.buffer, at + 46, name));
      const read = async () => {
        const head = await view(offset, offset + 30);
        const from = offset + 30 + head.getUint16(26, true) + head.getUint16(28, true);
        const body = archive.slice(from, from + packed);
        if (!method) return body;
        let left = size; // an archive may lie about its sizes
        const limit = new TransformStream({
          transform(chunk, controller) {
            left -= chunk.byteLength;
            if (left < 0) throw new Error(`${path} is larger than the archive says`);
            controller.enqueue(chunk);
          },
        });
        const unpacked = body.stream().pipeThrough(new DecompressionStream('deflate-raw')).pipeThrough(limit);
        return new Response(unpacked).blob();
      };
      found.push({ path, size, read });
      at += 46 + name + extra + comment;
    }
    return found;
  }

  /** Where Python looks for a mesh beside PLACE; '' if that is nowhere. */
  function placeOf(name) {
    const parts = PLACE.split('/').slice(0, -1);
    for (const part of name.replace(/^(package|model):\/\//, '').split('/')) {
      if (part === '..') parts.pop();
      else if (part && part !== '.') parts.push(part);
    }
    return parts[0] === 'robot' && !/^(file:\/\/|\/)/.test(name) ? parts.join('/') : '';
  }

  /** Read the meshes that a URDF names: of the files, those whose paths end most like the names. */
  async function readMeshes(text, files) {
    const named = [...parsed(text).querySelectorAll('visual mesh')].map((mesh) => mesh.getAttribute('filename') ?? '');
    const wanted = [...new Set(named)].filter(placeOf);
    const common = (name, { path }) => {
      const [one, other] = [name, path].map((each) => each.split('/').reverse());
      return [...one, ''].findIndex((part, k) => part !== other[k]);
    };
    const bytesOf = async (one) => new Uint8Array(await (await one.read()).arrayBuffer());
    const read = [];
    let found = 0;
    let left = MAX_MESHES;
    for (const name of wanted) {
      const [best] = files.filter((one) => common(name, one)).sort((a, b) => common(name, b) - common(name, a));
      left -= best?.size ?? 0;
      if (!best || left <= 0) continue;
      const bytes = await bytesOf(best);
      read.push({ path: placeOf(name), bytes });
      found += 1;
      // the materials of an OBJ file, which are beside it
      const [, library] = /^mtllib +([^/]+?)\s*$/m.exec(new TextDecoder().decode(bytes.subarray(0, 10_000))) ?? [];
      const beside = files.find(({ path, size }) => path === best.path.replace(/[^/]*$/, library) && size < 1e6);
      if (beside) read.push({ path: placeOf(name).replace(/[^/]*$/, library), bytes: await bytesOf(beside) });
    }
    if (wanted.length)
      aboutFile.textContent = `${found} of ${wanted.length} meshes were found${found < wanted.length ? '. Drop a folder or a zip archive that contains all' : ''}.`;
    return read;
  }

  /** Take the URDF among files, the chosen one or the first, and the meshes that it names. */
  async function take(files, chosen) {
    // macOS adds a file "._robot.urdf" to an archive for each file, which is none
    const own = files.filter(({ path }) => !/(^|\/)(__MACOSX\/|\._)/.test(path));
    const possible = own.filter(({ path }) => /\.(urdf|xml)$/i.test(path) && !/package\.xml$/.test(path));
    possible.sort((one, other) => one.path.endsWith('.xml') - other.path.endsWith('.xml'));
    const one = chosen ?? possible[0] ?? own.find(({ path }) => /\.xacro$/i.test(path)) ?? own[0]; // Python says more
    if (!one) throw new Error('there is no file in it');
    if (one.size > MAX_BYTES)
      throw new Error(`${one.path} has ${Math.round(one.size / 1e6)} MB, and the limit is 4 MB`);
    which.parentElement.hidden = possible.length < 2;
    which.replaceChildren(...possible.map(({ path }) => option(path)));
    which.value = one.path;
    which.onchange = () => reading(() => take(files, possible[which.selectedIndex]));
    showUrdf(await (await one.read()).text());
    meshes = await readMeshes(urdf, files);
    keep();
  }

  /** Do something with files, and say why it fails. */
  const reading = (action) =>
    action().catch((error) => {
      file.value = '';
      which.parentElement.hidden = true;
      showUrdf(''); // and not the robot before it, which would be checked
      aboutFile.textContent = `This cannot be read: ${error.message}.`;
    });

  const takeFile = async (one) =>
    take(
      /\.zip$/i.test(one.name)
        ? await filesOfArchive(one)
        : [{ path: one.name, size: one.size, read: async () => one }],
    );
  file.addEventListener('change', () => file.files[0] && reading(() => takeFile(file.files[0])));
  urdfText.addEventListener('input', () => setUrdf(urdfText.value));
  urdfText.addEventListener('paste', (event) => {
    const { length } = event.clipboardData.getData('text');
    if (length <= MAX_BYTES) return;
    event.preventDefault(); // before the browser puts it into the field
    aboutFile.textContent = `Not pasted: it has ${length.toLocaleString('en')} characters, and the limit is 4 million.`;
  });
  arm.addEventListener('change', () => {
    if (arm.value) links.hidden = true;
  });

  /** A text as a literal of Python. */
  const literal = (text) => JSON.stringify(text.replace(/\0/g, '')).replace(/\u007f/g, '\\u007f');

  check.onclick = () => {
    const given = arm.value || urdf;
    const isEmpty = !given.trim() && !table.value.trim();
    said.textContent = isEmpty ? 'Choose an arm or a URDF file, or paste a table.' : '';
    if (isEmpty) for (const section of answer) section.hidden = true; // it answers something else
    if (isEmpty) return;
    const names = [...HOW];
    if (!arm.value && !links.hidden) names.push('base', 'tip');
    const how = names.map((name) => [name, form.elements[name].value.trim()]).filter(([, value]) => value);
    const options = how.map(([name, value]) => `, ${name}=${literal(value)}`);
    const source = [
      'from kincourse.your_robot import examine',
      `arm = ${literal(meshes.length && given === urdf ? PLACE : given)}`,
      `table = ${literal(table.value)}`,
      `found = examine(arm, table${options.join('')})`,
      'found',
    ].join('\n');
    const files = meshes.length ? [{ path: PLACE, bytes: new TextEncoder().encode(urdf) }, ...meshes] : [];
    run([compare, picture], source, files, () => {
      for (const cell of [compare, picture]) cell.querySelector('.cell_output')?.replaceChildren(); // of another robot
      for (const section of answer) section.hidden = false;
      answer[0].scrollIntoView({ behavior: 'smooth', block: 'start' });
    });
  };

  const KEPT = ['arm', 'table', ...HOW, 'base', 'tip'];

  /** Keep what the form says in this browser, as sheets keep their answers. */
  function keep() {
    const values = KEPT.map((name) => [name, form.elements[name].value]);
    const all = { ...Object.fromEntries(values), urdf, hadMeshes: meshes.length > 0 };
    if (!store.write(KEY, all)) store.sayNotStored();
  }

  /** Run cells; the question whether Python may be loaded stands below the button, and `start` is called after it. */
  const run = (some, source, files = [], start = undefined) => {
    const elements = some.map((cell) => cell.querySelector('.cell_input'));
    const place = start && ((question) => said.before(question));
    document.dispatchEvent(new CustomEvent('kinlib-run', { detail: { elements, source, files, start, place } }));
  };

  // The sections of the notebook with these cells show the answer, without their code; what they say of the code is left out.
  const answer = [compare, picture].map((cell) => cell.closest('section'));
  for (const section of answer) {
    section.classList.add('your-robot-result');
    section.hidden = true;
  }
  for (const about of answer[0].querySelectorAll(':scope > p:has(~ .cell)')) about.remove();
  example.onclick = () => {
    arm.value = 'UR5e';
    table.value = EXAMPLE.trim();
    for (const name of HOW) form.elements[name].value = '';
    links.hidden = true;
    keep();
  };
  form.addEventListener('input', keep);
  form.addEventListener('dragover', (event) => event.preventDefault());
  form.addEventListener('drop', (event) => {
    event.preventDefault();
    const entries = [...event.dataTransfer.items].map((item) => item.webkitGetAsEntry()).filter(Boolean);
    const [first] = event.dataTransfer.files;
    const isOne = entries.length < 2 && !entries[0]?.isDirectory;
    if (first) reading(isOne ? () => takeFile(first) : async () => take(await filesBelow(entries)));
  });
  const title = document.querySelector('article h1');
  (title.parentElement.querySelector(':scope > p') ?? title).after(form);
  const before = store.read(KEY) ?? {};
  if (before.urdf) showUrdf(before.urdf);
  for (const name of KEPT) if (before[name]) form.elements[name].value = before[name];
  links.hidden ||= Boolean(arm.value);
  base.onchange?.();
  if (before.hadMeshes) aboutFile.textContent = 'Meshes are not kept: to see them, drop the folder or archive again.';
  const start = button('Start with the robot of the form', () => run(practise));
  practise[0].before(h('p', {}, start));

  // Each corrected table gets a button that copies it.
  const addCopies = () => {
    const note = compare.querySelector('.kinlib-live-note');
    if (compare.querySelector('.your-robot-unread') && note.textContent === 'Done.') note.textContent = 'Not compared.';
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
