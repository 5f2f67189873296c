// The search: ranks the entries of search-data.js with MiniSearch, and lists what it finds.
// A match in the title of a section counts more than one in the title of its page, and that more than one in the text.
((root) => {
  'use strict';
  const WEIGHTS = { title: 8, page: 3, text: 1 };
  // How much a match counts on each kind of page: lectures explain a term, other pages use it.
  const KINDS = {
    lecture: 4,
    students: 4,
    term: 3,
    robot: 2.5,
    notation: 2,
    sheet: 1.5,
    instructors: 1.5,
    mistake: 0.25,
    function: 0.7,
    misstep: 0.02, // for authors of other courses
    table: 0.3,
    contributing: 0.2,
    performance: 0.1,
    independent_checks: 0.1,
  };
  const LABELS = { term: 'glossary', table: 'robot', independent_checks: 'independent checks' };
  const ABBREVIATIONS = {
    dh: 'denavit-hartenberg',
    mdh: 'modified denavit-hartenberg',
    poe: 'product of exponentials',
    fk: 'forward kinematics',
    rpy: 'roll-pitch-yaw',
    exp: 'exponential',
    log: 'logarithm',
    hat: 'skew-symmetric matrix',
    dof: 'degree of freedom',
  };
  // What other words are used for the same thing by those who search.
  const SYNONYMS = {
    'rotation matrix': 'SO(3)',
    'inverse kinematics': 'forward kinematics',
    'exp map': 'exponential',
    'hat operator': 'skew-symmetric matrix',
    'home position': 'home',
    'from urdf': 'your robot',
    'dh table is wrong': 'your robot',
    'dh parameters': 'your robot',
    'paste urdf': 'your robot',
    internet: 'offline',
    plagiarism: 'alike',
  };
  const STOP_WORDS = new Set(
    (
      'a an and any are as at be by can did do does for from have how i in is it its me my of on or shall should that the ' +
      'there these this to was what when where which who why will with you your compute find get make mean need use ' +
      'der die das und ein eine ist wie was'
    ).split(' '),
  );
  const GREEK =
    'alpha beta gamma delta epsilon zeta eta theta iota kappa lambda mu nu xi omicron pi rho sigma sigma tau upsilon phi chi psi omega';
  const LETTERS = Object.fromEntries(GREEK.split(' ').map((name, k) => [String.fromCharCode(0x3b1 + k), name]));
  // ω, q, [S], T_ab, Ad_T, J(q), e^[S]q: the notation says what it stands for
  const SYMBOL = /^(?:[a-z\u0391-\u03c9]|\[.\]|\w{1,2}_\w{1,3}|\w\(\w\)|e\^.+)$/i;
  const CODE = /^(?:\w+\.)*(\w+)(?:\(.*)?$/; // kl.robots.rpr, assign_frames, equivalent(a, b)
  const OWN = /\b(?:i|me|my)\b/i; // who asks about the own file or answer asks how to use the site
  const NOTATION = 'notation.html'; // it explains how letters with numbers are meant, such as c_12
  const COVERAGE = 4; // how much more a place counts that has more of the words
  const MOST = 60; // results in the list
  const EXCERPT = 180; // characters

  /** Write symbols by their names: ω as omega, SE(3) as SE3, [S] as the matrix of S. */
  function spell(text) {
    return text
      .replace(/[\u0391-\u03c9]/g, (letter) => LETTERS[letter.toLowerCase()] ?? letter)
      .replace(/\b(s[eo])\s?\((\d)\)/gi, '$1$2')
      .replace(/\[(\w)\]/g, 'skew-symmetric matrix $1');
  }

  /** A word as it is indexed: in lower case, without accents, the s of a plural, ing and ed; null if it says nothing. */
  function normalize(word) {
    if (STOP_WORDS.has(word.toLowerCase())) return null;
    const plain = word.normalize('NFD').replace(/\p{M}/gu, '').toLowerCase();
    return plain.length > 3 ? plain.replace(/(?<![su])s$|(?<=\w{4})(?:ing|ed)$/, '') : plain;
  }

  /** The words of a text that say something. */
  const wordsOf = (text) =>
    text
      .split(/[\s\p{P}]+/u)
      .map(normalize)
      .filter(Boolean);

  /** The index of the entries. What is shown of an entry is not spelled, so the index does not store it. */
  function makeIndex(entries, Engine) {
    const index = new Engine({
      idField: 'url',
      fields: Object.keys(WEIGHTS),
      extractField: (entry, field) => (field === 'url' ? entry.url : spell(entry[field] ?? '')),
      processTerm: normalize,
    });
    index.addAll(entries);
    index.entries = new Map(entries.map((entry) => [entry.url, entry]));
    return index;
  }

  /** How much more an entry counts whose title is what was searched; case tells the group SE(3) from its algebra se(3). */
  function titleBoost({ title, kind }, query, name) {
    if (kind === 'function') return 1; // a word of the language is no name of a function
    const [own, other] = [title, query].map((text) => spell(text).replaceAll('-', ' '));
    if (own === other) return 20;
    if (own.toLowerCase() === other.toLowerCase()) return 8;
    if (normalize(title) === name) return 3;
    const words = wordsOf(other);
    return kind === 'term' && wordsOf(own).every((word) => words.includes(word)) ? 3 : 1;
  }

  /** The functions of a name, those of the owner that is named with it first, and then what else has the name. */
  function findFunctions(index, wanted) {
    const [, name] = CODE.exec(wanted) ?? [];
    if (!name || !/[_.(]/.test(wanted) || /^s[eo]\(/i.test(wanted)) return [];
    const isFunction = ({ id }) => index.entries.get(id).kind === 'function' && index.entries.get(id).title === name;
    const exact = index.search(name, { fields: ['title'], filter: isFunction });
    if (!exact.length) return [];
    const boostDocument = (id) => KINDS[index.entries.get(id).kind] ?? 1;
    const rest = index.search(name, { boost: WEIGHTS, boostDocument, filter: (result) => !isFunction(result) });
    const owner = wanted.replace(/\(.*/, ''); // Chain.fk: the fk of Chain before others
    const depth = ({ id }) => id.split('#')[0].split('.').length + 10 * id.includes('.symbolic.');
    const place = (result) => depth(result) - 100 * result.id.endsWith(`.${owner}`);
    return [...exact.sort((one, other) => place(one) - place(other)), ...rest];
  }

  /** The entries, best first; one that has few of the words counts little, and one that has less than half is left out. */
  function find(index, query) {
    const wanted = query.trim();
    const functions = findFunctions(index, wanted);
    if (functions.length) return functions;
    const lower = wanted.toLowerCase();
    const same = Object.entries(SYNONYMS).find(([words]) => lower.includes(words));
    const options = {
      boost: WEIGHTS,
      prefix: (term) => term.length > 2,
      fuzzy: (term) => (term.length > 5 ? 0.2 : false),
    };
    const written = wanted.replace(/\w+/g, (word) => ABBREVIATIONS[word.toLowerCase()] ?? word);
    const best = new Map();
    for (const form of new Set([wanted, written, ...(same ? [same[1]] : [])])) {
      const boostDocument = (id) => {
        const entry = index.entries.get(id);
        const symbol = entry.kind === 'notation' && SYMBOL.test(wanted) ? 100 : 1;
        const use = entry.kind === 'students' && OWN.test(wanted) ? 4 : 1;
        return symbol * use * (KINDS[entry.kind] ?? 1) * titleBoost(entry, form, normalize(form));
      };
      for (const result of index.search(spell(form), { ...options, boostDocument })) {
        result.share = Math.min(1, result.queryTerms.length / wordsOf(spell(form)).length);
        result.score *= result.share ** COVERAGE;
        if (!(best.get(result.id)?.score > result.score)) best.set(result.id, result);
      }
    }
    const found = [...best.values()].sort((one, other) => other.score - one.score);
    const most = Math.max(...found.map(({ share }) => share));
    const places = found.filter(({ share }) => share >= most / 2);
    if (!SYMBOL.test(wanted) || places[0]?.id.startsWith(NOTATION)) return places;
    return [{ id: NOTATION, terms: [] }, ...places.filter(({ id }) => id !== NOTATION)];
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
  data.onload = () => {
    const index = makeIndex(root.kinlibSearchData, root.MiniSearch);
    show(find(index, query).map((result) => ({ ...index.entries.get(result.id), ...result })));
  };
  data.onerror = () => {
    status.textContent = 'The index of the search could not be loaded. Check the connection, then reload the page.';
  };
  document.head.append(data);

  function show(found) {
    status.textContent = found.length
      ? `Search finished: ${found.length} ${found.length === 1 ? 'place' : 'places'} for “${query}”` +
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
