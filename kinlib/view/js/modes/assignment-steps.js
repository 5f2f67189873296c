// The steps of a frame assignment, forwards and backwards, each with its explanation and with its objects highlighted.

import { renderMathText } from '../controls/math-text.js';
import { h, NO_SHORTCUTS } from '../dom.js';
import { describeArm, frameText } from '../scene/describe.js';
import { matrixOf, rows } from '../scene/kinematic-tree.js';
import { dashedLine } from '../scene/shapes.js';
import { dhTable } from './dh-table.js';
import { axis, column, createHighlighter, drawPaleArm, frame, lengths, originOf } from './frame-drawing.js';
import { add } from './vectors.js';

const KEY_STEPS = {
  ArrowRight: 1,
  ArrowDown: 1,
  ArrowLeft: -1,
  ArrowUp: -1,
  PageDown: 5,
  PageUp: -5,
  Home: -Infinity,
  End: Infinity,
};

/** @param kit.data { conventions: { standard, modified } }, each { axes, normals, frames, table, steps } */
export function assignmentSteps({ model, stage, data }) {
  const highlighter = createHighlighter(stage);
  const { size } = stage.data;
  const now = () => data.conventions[model.get('convention')];
  const last = now().steps.length - 1;
  const go = (step) => {
    const wanted = Math.max(0, Math.min(last, step));
    if (wanted === model.get('step')) return;
    model.set('step', wanted);
    model.save_changes();
  };
  const button = (text, label, act) =>
    h('button', { type: 'button', ...NO_SHORTCUTS, 'aria-label': label, title: label, onclick: act }, text);
  const first = button('|◀', 'First step', () => go(0));
  const back = button('◀ Back', 'One step back', () => go(model.get('step') - 1));
  const next = button('Next ▶', 'Next step', () => go(model.get('step') + 1));
  const end = button('▶|', 'Last step', () => go(last));
  const slider = h('input', {
    ...NO_SHORTCUTS,
    type: 'range',
    min: 0,
    max: last,
    step: 1,
    'aria-label': 'Step',
    oninput: () => go(Number(slider.value)),
  });
  const select = h(
    'select',
    {
      ...NO_SHORTCUTS,
      'aria-label': 'Convention',
      onchange: () => {
        model.set('convention', select.value);
        model.save_changes();
      },
    },
    ...Object.keys(data.conventions).map((name) => h('option', { value: name }, `${name} convention`)),
  );
  const count = h('span', { class: 'kv-small' });
  const title = h('p', { class: 'kv-title' });
  const text = h('p', {});
  const others = h('p', { class: 'kv-note' });
  const explanation = h('div', { class: 'kv-step', 'aria-live': 'polite', 'aria-atomic': 'true' }, title, text, others);
  const table = h('div', {});
  const element = h(
    'section',
    {
      class: 'kv-player',
      role: 'group',
      'aria-label': 'Steps of the assignment',
      onkeydown: (event) => {
        const by = KEY_STEPS[event.key];
        if (!by || event.target === select || event.ctrlKey || event.metaKey || event.altKey) return;
        event.preventDefault();
        go(model.get('step') + by);
      },
    },
    h('div', { class: 'kv-head' }, select, count),
    h('div', { class: 'kv-buttons' }, first, back, next, end),
    slider,
    explanation,
    table,
  );

  function write() {
    const { steps, table: rows } = now();
    const step = steps[model.get('step')];
    select.value = model.get('convention');
    count.textContent = `step ${model.get('step') + 1} of ${last + 1}`;
    title.replaceChildren(...renderMathText(step.title));
    text.replaceChildren(...renderMathText(step.text));
    others.replaceChildren(...(step.others ? [h('b', {}, 'Also valid: '), ...renderMathText(step.others)] : []));
    slider.value = model.get('step');
    slider.style.setProperty('--share', `${(100 * model.get('step')) / last}%`);
    slider.setAttribute('aria-valuetext', `${model.get('step') + 1} of ${last + 1}: ${step.title}`);
    for (const [control, off] of [
      [first, 0],
      [back, 0],
      [next, last],
      [end, last],
    ]) {
      // aria-disabled, because a disabled button would lose the focus
      control.setAttribute('aria-disabled', String(model.get('step') === off));
    }
    const read = step.row ?? (steps.slice(0, model.get('step')).some(({ row }) => row) ? rows.length : 0);
    table.hidden = !read;
    table.replaceChildren(dhTable(model.get('convention'), rows, { read, lit: step.row, label: 'DH table so far' }));
  }

  function draw() {
    const { axes, normals, frames, steps } = now();
    const step = steps[model.get('step')];
    const { theme } = stage;
    const kit = { size, theme };
    const long = lengths(frames, step.parts, size);
    const shown = frames.map((pose, i) => ({ pose, letters: pose ? step.parts[i] : '', i }));
    stage.setLayer(
      'steps',
      [
        ...axes.flatMap(([from, to], i) => axis(i, from, to, { ...kit, strong: step.axes[i] })),
        ...normals.flatMap((normal, i) => (step.normals[i] === null ? [] : common(normal, i, kit, step.normals[i]))),
        ...step.segments.flatMap(({ name, from, to }) => segment(name, from, to, kit)),
        ...shown.flatMap(({ pose, letters, i }) =>
          letters ? frame(i, pose, letters, { ...kit, strong: step.strong[i], length: long[i], body: i }) : [],
        ),
      ],
      { through: true },
    );
    highlighter.mark([
      ...(step.axes.every(Boolean) ? [] : axes.filter((_, i) => step.axes[i]).map(([from, to]) => ({ from, to }))),
      ...normals.filter((_, i) => step.normals[i] && !step.strong.every(Boolean)).map((normal) => ends(normal, size)),
      ...shown.flatMap(({ pose, i }) =>
        pose ? [...step.highlighted[i]].map((letter) => named(pose, letter, long[i] * size)) : [],
      ),
      ...step.segments.map(({ from, to }) => ({ from, to })),
    ]);
  }

  const changed = () => {
    write();
    draw();
  };
  const names = ['change:step', 'change:convention'];
  for (const name of names) model.on(name, changed);
  return {
    element,
    replacesSliders: true,
    describe() {
      const { steps, frames } = now();
      const { parts, text: what } = steps[model.get('step')];
      const whole = frames.flatMap((pose, i) =>
        pose && /O.*[zx].*[zx]/.test(parts[i]) ? [frameText(i, rows(matrixOf(pose)))] : [],
      );
      const count = `step ${model.get('step') + 1} of ${steps.length}`;
      const axes = model.get('step') === 0 ? ` ${describeArm(stage.data, stage.tree, model.get('q'))}` : '';
      return `${stage.data.name}, ${model.get('convention')} convention, ${count}. ${what}${axes} ${whole.join(' ')}`;
    },
    applyTheme() {
      drawPaleArm(stage);
      changed();
    },
    dispose() {
      for (const name of names) model.off(name, changed);
      highlighter.dispose();
    },
  };
}

/** A common normal; one of length 0 is drawn as a short line along its direction. */
function ends({ from, to, along }, size) {
  const half = Math.hypot(...add(to, from, -1)) < 1e-6 * size ? 0.16 * size : 0;
  return { from: add(from, along, -half), to: add(to, along, half) };
}

function common(normal, i, { size, theme }, strong) {
  const { from, to } = ends(normal, size);
  const middle = from.map((value, k) => (value + to[k]) / 2);
  const line = {
    body: i + 1,
    from,
    to,
    radius: (strong ? 0.0105 : 0.006) * size,
    colour: theme.normal,
    dash: 0.02 * size,
    gap: 0.011 * size,
  };
  const name = {
    body: i + 1,
    label: true,
    at: middle,
    text: `normal ${i + 1}–${i + 2}`,
    sub: '',
    colour: theme.normal,
    italic: true,
    weight: 3,
  };
  return [...dashedLine(line), ...(strong ? [name] : [])];
}

/** A length of a DH row: d along an axis or a along a common normal. */
function segment(name, from, to, { size, theme }) {
  const colour = name.startsWith('d') ? theme.axis : theme.normal;
  const [base, sub] = name.split('_');
  const at = from.map((value, k) => (value + to[k]) / 2);
  return [
    { body: 0, shape: 'capsule', from, to, radius: 0.012 * size, colour },
    { body: 0, label: true, at, text: base, sub, colour, italic: true, weight: 5 },
  ];
}

function named(pose, letter, length) {
  const from = originOf(pose);
  return letter === 'O' ? { from } : { from, to: add(from, column(pose, 'xyz'.indexOf(letter)), length) };
}
