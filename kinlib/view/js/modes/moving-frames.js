// Frames that one slider moves. Their poses for each value are in the data, so that no kernel is needed.
import { h, moveSlider, slider, uniqueId } from '../dom.js';
import { listen, save } from '../model.js';
import { frameText } from '../scene/describe.js';
import * as parts from '../scene/parts.js';
import { arrow } from '../scene/shapes.js';
import { minus, norm } from '../vectors.js';
import { originOf } from './frame-drawing.js';

const IDENTITY = [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1];

/**
 * @param kit.data { label, values: [text], captions: [text], names: [text], arrows: bool,
 *   poses: [[16 numbers per frame] per value] }
 */
export function movingFrames({ model, stage, data }) {
  const id = uniqueId('value');
  const { size } = stage.data;
  const at = () => model.get('at');
  const input = slider(data.values.length - 1, (index) => save(model, 'at', index), { id });
  const value = h('output', { for: id });
  const caption = h('p', { class: 'kv-values', 'aria-live': 'polite' });
  const texts = () => data.names.map((name, k) => frameText(name, stage.tree.pose(k))).join(' ');

  function move() {
    data.poses[at()].forEach((pose, k) => {
      const { tool } = stage.tree.arms[k];
      tool.matrix.set(...pose);
      tool.matrixWorldNeedsUpdate = true;
    });
    stage.tree.root.updateMatrixWorld(true);
    if (data.arrows) stage.setLayer('arrows', data.poses[at()].slice(1).flatMap(arrowTo), { through: true });
    moveSlider(input, at(), data.values[at()]);
    value.textContent = data.values[at()];
    caption.textContent = data.captions[at()];
    stage.draw();
  }

  /** An arrow to the origin of frame k + 1 from that of frame k. */
  function arrowTo(pose, k) {
    const from = originOf(data.poses[at()][k]);
    const to = originOf(pose);
    const length = norm(minus(to, from));
    if (length < 1e-6 * size) return [];
    const look = { arm: 0, body: 0, colour: stage.theme.quiet, radius: 0.004 * size, tip: 0.016 * size };
    return arrow({ ...look, from, to, head: Math.min(length, 0.06 * size) });
  }

  const stopListening = listen(model, { at: move });
  return {
    element: h('div', { class: 'kv-curve' }, h('label', { for: id }, `${data.label}: `, value), input, caption),
    replacesSliders: true,
    describe: () => `${data.captions[at()]} ${texts()}`.trim(),
    update: move,
    applyTheme() {
      stage.setLayer(
        'moving frames',
        data.names.flatMap((name, arm) =>
          parts
            .triads([{ name, body: 'tool', pose: IDENTITY }], size, stage.theme, { short: true, length: data.length })
            .map((part) => ({ ...part, arm })),
        ),
        { through: true },
      );
      move();
    },
    dispose: stopListening,
  };
}
