// Adapts Sphinx's search to this course: lectures rank before pages of robots, and each formula is indexed once.
// It is loaded after Sphinx's searchtools.js, which defines Scorer and Search.
(() => {
  'use strict';
  const FIRST = { lectures: 8, sheets: 2, mistakes: 1 };
  Scorer.score = ([page, , , , score]) => score + (FIRST[page.split('/')[0]] ?? 0);

  // A page contains each formula three times: as it is displayed, for screen readers, and as TeX.
  const textOf = Search.htmlToText;
  Search.htmlToText = (html, anchor) => {
    const page = new DOMParser().parseFromString(html, 'text/html');
    for (const again of page.querySelectorAll('.katex-html, .katex annotation, [data-kinlib-viewer] script'))
      again.remove();
    return textOf(page.documentElement.outerHTML, anchor);
  };
})();
