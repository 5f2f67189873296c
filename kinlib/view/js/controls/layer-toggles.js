// Toggle buttons for the layers, a list of frame choices, and buttons for the named views.

import { button, h, NO_SHORTCUTS } from '../dom.js';
import { VIEWS } from '../render/camera.js';
import { FRAME_LAYERS, FRAMES, frameChoiceOf, isSingleFrame, TOGGLES, without } from '../scene/layers.js';

/**
 * @param state { available, shown(), setShown(names), framesIn(layers), hidden: the names of frames that are switched off, changed() }
 * @returns { element, update() }
 */
export function layerToggles({ available, shown, setShown, framesIn, hidden, changed }) {
  const singleFrames = available
    .filter(isSingleFrame)
    .map((name) => [name, `{${name.slice(6)}}`, `Frame {${name.slice(6)}}`]);
  const buttons = [...singleFrames, ...Object.entries(TOGGLES)]
    .filter(([name]) => available.includes(name))
    .map(([name, text, spoken]) => {
      const toggle = () => setShown(shown().includes(name) ? without(shown(), [name]) : [...shown(), name]);
      return { name, chip: button(text, toggle, { class: 'kv-chip', 'aria-label': spoken }) };
    });
  const select = h(
    'select',
    {
      ...NO_SHORTCUTS,
      'aria-label': 'Frames',
      onchange: () => setShown([...without(shown(), FRAME_LAYERS), ...FRAMES[select.value].layers]),
    },
    ...Object.entries(FRAMES)
      .filter(([, { layers }]) => layers.every((layer) => available.includes(layer)))
      .map(([value, { name }]) => h('option', { value }, name)),
  );
  const choices = select.options.length > 1 ? [select] : [];
  const frames = h('span', { class: 'kv-frames', role: 'group', 'aria-label': 'Each of them' });
  function listFrames() {
    const names = framesIn(shown().filter((name) => FRAME_LAYERS.includes(name)));
    frames.hidden = names.length < 3;
    if (frames.dataset.names !== names.join()) {
      const box = (name) => {
        const input = h('input', {
          type: 'checkbox',
          ...NO_SHORTCUTS,
          'aria-label': `Show {${name}}`,
          onchange: () => choose(name, input.checked),
        });
        input.checked = !hidden.has(name);
        return h('label', {}, input, `{${name}}`);
      };
      frames.replaceChildren(...names.map(box));
    }
    frames.dataset.names = names.join();
  }
  function choose(name, isShown) {
    if (isShown) hidden.delete(name);
    else hidden.add(name);
    changed();
  }
  return {
    element: h(
      'div',
      { class: 'kv-toggles', role: 'group', 'aria-label': 'Show' },
      ...choices,
      frames,
      ...buttons.map(({ chip }) => chip),
    ),
    update() {
      for (const { name, chip } of buttons) chip.setAttribute('aria-pressed', String(shown().includes(name)));
      select.value = frameChoiceOf(shown());
      listFrames();
    },
  };
}

export function viewButtons(camera) {
  return h(
    'div',
    { class: 'kv-views', role: 'group', 'aria-label': 'View' },
    ...Object.keys(VIEWS).map((name) => button(name, () => camera.flyTo(name))),
  );
}
