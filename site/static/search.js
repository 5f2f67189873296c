// The search: ranks the entries of search-data.js with MiniSearch, and lists what it finds.
// A match in the title of a section counts more than one in the title of its page, and that more than one in the text.
((root) => {
  'use strict';
  const WEIGHTS = { title: 8, page: 3, text: 1 };
  // How much a match counts on each kind of page: lectures explain a term, other pages use it.
  const KINDS = {
    lecture: 4,
    term: 3,
    robot: 2.5,
    notation: 2,
    sheet: 1.5,
    mistake: 1.3,
    function: 0.7,
    table: 0.3,
    contributing: 0.2,
    performance: 0.1,
    census: 0.1,
    independent_checks: 0.1,
  };
  const LABELS = { term: 'glossary', table: 'robot', independent_checks: 'independent checks' };
  const ABBREVIATIONS = {
    dh: 'denavit-hartenberg',
    mdh: 'modified denavit-hartenberg',
    poe: 'product of exponentials',
    fk: 'forward kinematics',
    rpy: 'roll-pitch-yaw',
  };
  const MOST = 60; // results in the list
  const EXCERPT = 180; // characters

  /** A word as it is indexed: in lower case, without accents and without the s of a plural. */
  function normalize(word) {
    const plain = word.normalize('NFD').replace(/\p{M}/gu, '').toLowerCase();
    return plain.length > 3 ? plain.replace(/(?<![su])s$/, '') : plain;
  }

  function makeIndex(entries, Engine) {
    const index = new Engine({
      idField: 'url',
      fields: Object.keys(WEIGHTS),
      storeFields: ['title', 'page', 'kind', 'text'],
      processTerm: normalize,
    });
    index.addAll(entries);
    return index;
  }

  /** The entries that contain all words, or, if there are none, those that contain one of them. */
  function find(index, query) {
    const options = {
      boost: WEIGHTS,
      prefix: (term) => term.length > 2,
      fuzzy: (term) => (term.length > 5 ? 0.2 : false),
      boostDocument: (_, __, { kind, title }) =>
        (KINDS[kind] ?? 1) * (normalize(title) === normalize(query.trim()) ? 3 : 1),
    };
    const written = query.replace(/\w+/g, (word) => ABBREVIATIONS[word.toLowerCase()] ?? word);
    const queries = [...new Set([query, written])].map((text) => ({ queries: [text], combineWith: 'AND' }));
    const all = index.search({ queries, combineWith: 'OR' }, options);
    return all.length ? all : index.search(query, options);
  }

  /** The part of a text around the first word that was found, and that word apart. */
  function excerpt(text, words) {
    const places = words.map((word) => text.toLowerCase().search(new RegExp(`\\b${word}`))).filter((at) => at >= 0);
    const start = Math.max(0, (places.length ? Math.min(...places) : 0) - EXCERPT / 3);
    const from = start && text.indexOf(' ', start) + 1;
    const part = text.slice(from, from + EXCERPT).replace(/\s\S*$/, '');
    return `${from ? '… ' : ''}${part}${from + EXCERPT < text.length ? ' …' : ''}`;
  }

  root.kinlibSearch = { makeIndex, find };
  const box = root.document?.getElementById('search-results');
  if (!box) return;

  const query = new URLSearchParams(location.search).get('q')?.trim() ?? '';
  const status = document.createElement('p');
  status.setAttribute('role', 'status');
  const list = document.createElement('ol');
  box.append(status, list);
  for (const input of document.querySelectorAll('input[name="q"]')) input.value = query;
  if (!query) {
    status.textContent = 'Type a word into the search box, such as "screw axis".';
    return;
  }
  status.textContent = 'Searching …';
  const data = document.createElement('script'); // 200 kB, loaded only if there is something to find
  data.src = new URL('search-data.js', document.currentScript.src);
  data.onload = () => show(find(makeIndex(root.kinlibSearchData, root.MiniSearch), query));
  data.onerror = () => {
    status.textContent = 'The index of the search could not be loaded. Check the connection, then reload the page.';
  };
  document.head.append(data);

  function show(found) {
    status.textContent = found.length
      ? `Search finished: ${found.length} ${found.length === 1 ? 'place contains' : 'places contain'} “${query}”` +
        `${found.length > MOST ? `; the best ${MOST} are below.` : '.'}`
      : `Search finished: nothing contains “${query}”. ` +
        'The glossary lists the terms of the course and those of other books.';
    for (const { id, title, page, kind, text, terms } of found.slice(0, MOST)) {
      const link = document.createElement('a');
      link.href = id;
      link.textContent = title;
      const where = document.createElement('span');
      where.className = 'where';
      where.textContent = [LABELS[kind] ?? kind, ...(page === title ? [] : [page])].join(' · ');
      const context = document.createElement('p');
      context.className = 'context';
      context.textContent = excerpt(text, terms);
      const item = document.createElement('li');
      item.append(link, ' ', where, context);
      list.append(item);
    }
  }
})(globalThis);
