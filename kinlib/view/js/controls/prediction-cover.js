// Covers a viewer whose motion is to be predicted, until the reader has committed to a prediction in a question above.
// The reader may also uncover it without an answer; then nothing is recorded.
import { button, h } from '../dom.js';
import { save } from '../model.js';

/** @param model with covered @returns { element, update() } */
export function predictionCover(model) {
  const element = h(
    'div',
    { class: 'kv-cover', role: 'group', 'aria-label': 'Prediction' },
    h('p', { class: 'kv-title' }, 'Commit to your prediction above first'),
    h('p', {}, 'The picture appears here afterwards.'),
    button('Show anyway', uncover, { class: 'kv-quiet' }),
  );
  /** The button disappears, and the focus goes on to the whole viewer. */
  function uncover() {
    save(model, 'covered', false);
    element.parentElement.tabIndex = -1;
    element.parentElement.focus({ preventScroll: true });
  }
  return {
    element,
    update() {
      element.hidden = !model.get('covered');
    },
  };
}
