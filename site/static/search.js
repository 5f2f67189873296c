// The box and the results of search.html, by Pagefind. templates/page.html says how much each kind of page counts.
(() => {
  'use strict';
  const FILLER =
    /^(?:an?|and|are|at|be|by|can|compute|convert|do|does|find|for|from|get|how|i|in|is|it|me|my|not|of|on|or|own|that|the|this|to|use|vs|what|when|where|which|why|with)$/i;

  /** Leave out the words that say nothing, because Pagefind wants each word on a page; kl.fk and Chain.fk are looked for as fk. */
  function processTerm(query) {
    const words = query.split(/\s+|(?<=\w)[.(](?=\w)/).filter((word) => word && word !== 'kl');
    const telling = words.filter((word) => !FILLER.test(word));
    return (telling.length ? telling : words).join(' ');
  }

  const search = new window.PagefindUI({
    element: '#search',
    autofocus: true,
    debounceTimeoutMs: 100,
    excerptLength: 24,
    pageSize: 10,
    processTerm,
    ranking: { pageLength: 0.3, termFrequency: 0.2 }, // the glossary and the lectures are long
    resetStyles: false,
    showImages: false,
    showSubResults: true,
    translations: {
      zero_results: 'Nothing contains all words of “[SEARCH_TERM]”. Try fewer words, or one from the glossary.',
    },
  });
  document.querySelector('#search input').setAttribute('aria-label', 'Words to find'); // Pagefind gives it a title only
  const query = new URLSearchParams(location.search).get('q')?.trim();
  if (query) search.triggerSearch(query);
})();
