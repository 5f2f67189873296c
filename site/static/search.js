// The search, as this course needs it: lectures before pages of robots, and formulas told once. It stands after Sphinx's
// searchtools.js, whose Scorer and Search these are.
(() => {
  'use strict';
  const FIRST = { lectures: 8, sheets: 2, mistakes: 1 };
  Scorer.score = ([page, , , , score]) => score + (FIRST[page.split('/')[0]] ?? 0);

  // A formula stands in a page three times: for the eye, for who listens, and as it was written.
  const textOf = Search.htmlToText;
  Search.htmlToText = (html, anchor) => {
    const page = new DOMParser().parseFromString(html, 'text/html');
    for (const again of page.querySelectorAll('.katex-html, .katex annotation, [data-kinlib-viewer] script'))
      again.remove();
    return textOf(page.documentElement.outerHTML, anchor);
  };
})();
