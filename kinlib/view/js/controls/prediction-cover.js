// Covers a viewer whose motion is to be predicted, until the reader commits to a prediction, here or in a question
// above. The reader may also uncover it without an answer; then nothing is recorded.
import { h, NO_SHORTCUTS, uniqueId } from '../dom.js';

/** @param model with covered, prediction { text, options } and choice @returns { element, update() } */
export function predictionCover(model) {
  const element = h('div', { class: 'kv-cover', role: 'group', 'aria-label': 'Prediction' });
  let drawn;
  const uncover = (choice) => {
    if (choice !== undefined) model.set('choice', choice);
    model.set('covered', false);
    model.save_changes();
  };
  function content() {
    const { text, options = [] } = model.get('prediction') ?? {};
    const anyway = h(
      'button',
      { type: 'button', ...NO_SHORTCUTS, class: 'kv-quiet', onclick: () => uncover() },
      'Show anyway',
    );
    if (!text) {
      return [
        h('p', { class: 'kv-title' }, 'Commit to your prediction above first'),
        h('p', {}, 'The arm appears here afterwards.'),
        anyway,
      ];
    }
    const group = uniqueId('prediction');
    const commit = h(
      'button',
      {
        type: 'button',
        ...NO_SHORTCUTS,
        disabled: true,
        onclick: () => {
          uncover(Number(element.querySelector('input:checked').value));
        },
      },
      'Commit',
    );
    return [
      h('p', { class: 'kv-title' }, 'Predict'),
      h('p', {}, text),
      ...options.map((option, k) =>
        h(
          'label',
          {},
          h('input', {
            ...NO_SHORTCUTS,
            type: 'radio',
            name: group,
            value: k,
            onchange: () => {
              commit.disabled = false;
            },
          }),
          ' ',
          option,
        ),
      ),
      h('div', { class: 'kv-buttons' }, commit, anyway),
    ];
  }
  return {
    element,
    update() {
      const covered = model.get('covered');
      if (covered === drawn) return;
      drawn = covered;
      element.hidden = !covered;
      element.replaceChildren(...(covered ? content() : []));
    },
  };
}
