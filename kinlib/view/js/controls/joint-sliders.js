// One slider and one number field per joint, a play button and a reset button. A handler only sets q. Everything is
// drawn when q changes, so that it makes no difference whether the page or Python changed it.
import { button, formatNumber, h, NO_SHORTCUTS, renderSymbol, stepsOf, uniqueId } from '../dom.js';
import { playButton, ROUND_MS } from './play-button.js';
import { typedNumber } from './typed-number.js';

const DEGREE = Math.PI / 180;

/** @param state { sliders, limits, start(), q(), set(q), choose(link) } @returns { element, update(q), dispose() } */
export function jointSliders(state) {
  const rows = state.sliders.map((slider) => sliderRow(slider, state));
  const motion = sweepJoints(state);
  const reset = () => {
    motion.stop();
    state.set(state.start());
  };
  const element = h(
    'fieldset',
    { class: 'kv-joints' },
    h('legend', {}, 'Joint values'),
    h('p', { class: 'kv-unit kv-hint' }, 'Move a slider, or drag a link.'),
    ...rows.map(({ element: line }) => line),
    h('div', { class: 'kv-buttons' }, motion.button, button('↺ Reset', reset)),
  );
  return {
    element,
    update(q) {
      for (const { update } of rows) update(q);
    },
    dispose: motion.stop,
  };
}

function sliderRow(slider, state) {
  const { column, name, unit, low, high } = slider;
  const id = uniqueId('q');
  const isAngle = unit === 'rad';
  const step = isAngle ? DEGREE : 0.01;
  const unitName = isAngle ? 'radians' : 'metres';
  const ends = (state.limits[column] ?? [null]).map((end) => end !== null && formatNumber(end, 2));
  const limits = ends.includes(false) ? '' : `: ${ends.join(' to ')} ${unit}`;
  const label = `Joint ${column + 1}${slider.title ? ` (${slider.title})` : ''}, ${unitName}`;
  const set = (value) => {
    const q = [...state.q()];
    if (!Number.isFinite(value) || value === q[column]) return;
    q[column] = value;
    state.set(q);
  };
  const range = h('input', {
    ...NO_SHORTCUTS,
    id,
    type: 'range',
    min: low,
    max: high,
    step: 'any',
    'aria-label': label,
    oninput: () => set(Number(range.value)),
    onkeydown: (event) => {
      const steps = stepsOf(event, { PageDown: -10, PageUp: 10 });
      if (!steps) return;
      const value = Math.abs(steps) === Infinity ? Math.sign(steps) * Infinity : state.q()[column] + steps * step;
      set(Math.max(low, Math.min(high, value)));
    },
  });
  const field = typedNumber(isAngle, label, () => state.q()[column], set);
  const degrees = h('span', { class: 'kv-degrees', 'aria-hidden': 'true' });
  let last;
  return {
    element: h(
      'div',
      {
        class: 'kv-row',
        onpointerenter: () => state.choose(column + 1),
        onpointerleave: () => state.choose(null),
        onfocusin: () => state.choose(column + 1),
        onfocusout: () => state.choose(null),
      },
      ...(slider.title ? [h('span', { class: 'kv-joint' }, `${slider.title}${limits}`)] : []),
      h('label', { for: id, title: label }, renderSymbol(name)),
      range,
      field.element,
      h('span', { class: 'kv-unit' }, unit),
      degrees,
      field.hint,
    ),
    update(q) {
      const value = q[column];
      if (value === last) return;
      last = value;
      if (Number(range.value) !== value) range.value = value;
      range.style.setProperty('--share', `${Math.max(0, Math.min(100, (100 * (value - low)) / (high - low)))}%`);
      field.show(value);
      const text = isAngle ? `${formatNumber(value / DEGREE, 0)}°` : '';
      degrees.textContent = text;
      range.setAttribute(
        'aria-valuetext',
        isAngle
          ? `${formatNumber(value, 2)} radians, ${formatNumber(value / DEGREE, 0)} degrees`
          : `${formatNumber(value, 3)} metres`,
      );
    },
  };
}

/** Move one joint after the other to its upper limit, to its lower limit and back. */
function sweepJoints(state) {
  let from = [];
  return playButton(
    () => {
      from = [...state.q()];
    },
    (time, share) => {
      const moving = state.sliders[Math.floor(time / ROUND_MS) % state.sliders.length];
      const rest = from[moving.column];
      const wave = Math.sin(2 * Math.PI * share);
      const q = [...from];
      q[moving.column] =
        rest + (wave > 0 ? wave * Math.max(0, moving.high - rest) : -wave * Math.min(0, moving.low - rest));
      if (q.some((value, k) => value !== state.q()[k])) state.set(q);
    },
  );
}
