// Draws each formula when the reader comes near, so that a long lecture opens fast on a phone: kinsite/late_formulas.py
// has put its visible form into a template, and until then, or without this script, its MathML is shown.
(() => {
  'use strict';
  const NEAR = '1500px'; // above and below the window

  const near = new IntersectionObserver(
    (entries) => draw(entries.filter((entry) => entry.isIntersecting).map((entry) => entry.target)),
    { rootMargin: NEAR },
  );

  class LateFormula extends HTMLElement {
    connectedCallback() {
      near.observe(this);
    }

    disconnectedCallback() {
      near.unobserve(this);
    }
  }

  function draw(formulas) {
    for (const formula of formulas) formula.replaceWith(formula.firstElementChild.content);
    if (formulas.length) document.dispatchEvent(new Event('kinlib-drawn')); // for course.js
  }

  const drawAll = () => draw(document.querySelectorAll('kinlib-formula'));

  customElements.define('kinlib-formula', LateFormula);
  // MathML has not exactly the height of the drawn formula: where the reader returns to a position, or is led to one,
  // everything above must have its final height
  if (location.hash || performance.getEntriesByType('navigation')[0]?.type !== 'navigate') drawAll();
  addEventListener('hashchange', drawAll);
  addEventListener('beforeprint', drawAll);
})();
