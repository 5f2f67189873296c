// The steps of a frame assignment, forwards and backwards, each with its explanation and with its objects highlighted.

import { renderMathText } from '../controls/math-text.js';
import { button, h, moveSlider, NO_SHORTCUTS, named, slider, stepsOf } from '../dom.js';
import { listen, save } from '../model.js';
import { describeArm, frameText } from '../scene/describe.js';
import { matrixOf, rows } from '../scene/kinematic-tree.js';
import { dashedLine, label } from '../scene/shapes.js';
import { add, middle, minus, norm } from '../vectors.js';
import { dhTable } from './dh-table.js';
import { axis, column, createHighlighter, drawPaleArm, frame, lengths, originOf } from './frame-drawing.js';

const LIST_KEYS = { ArrowDown: 1, ArrowUp: -1, PageDown: 5, PageUp: -5 };

/** @param kit.data { conventions: { standard, modified } }, each { axes, normals, frames, table, steps } */
export function assignmentSteps({ model, stage, data }) {
  const highlighter = createHighlighter(stage);
  const { size } = stage.data;
  const now = () => data.conventions[model.get('convention')];
  const last = now().steps.length - 1;
  const go = (step) => {
    const wanted = Math.max(0, Math.min(last, step));
    if (wanted !== model.get('step')) save(model, 'step', wanted);
  };
  const first = button('|◀', () => go(0), named('First step'));
  const back = button('◀ Back', () => go(model.get('step') - 1), named('One step back'));
  const next = button('Next ▶', () => go(model.get('step') + 1), named('Next step'));
  const end = button('▶|', () => go(last), named('Last step'));
  const bar = slider(last, go, { 'aria-label': 'Step' });
  const select = h(
    'select',
    {
      ...NO_SHORTCUTS,
      'aria-label': 'Convention',
      onchange: () => save(model, 'convention', select.value),
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
        const by = event.target === select ? 0 : stepsOf(event, LIST_KEYS);
        if (by) go(model.get('step') + by);
      },
    },
    h('div', { class: 'kv-head' }, select, count),
    h('div', { class: 'kv-buttons' }, first, back, next, end),
    bar,
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
    moveSlider(bar, model.get('step'), `${model.get('step') + 1} of ${last + 1}: ${step.title}`);
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
        pose ? [...step.highlighted[i]].map((letter) => highlighted(pose, letter, long[i] * size)) : [],
      ),
      ...step.segments.map(({ from, to }) => ({ from, to })),
    ]);
  }

  const changed = () => {
    write();
    draw();
  };
  const stopListening = listen(model, { step: changed, convention: changed });
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
      stopListening();
      highlighter.dispose();
    },
  };
}

/** A common normal; one of length 0 is drawn as a short line along its direction. */
function ends({ from, to, along }, size) {
  const half = norm(minus(to, from)) < 1e-6 * size ? 0.16 * size : 0;
  return { from: add(from, along, -half), to: add(to, along, half) };
}

function common(normal, i, { size, theme }, strong) {
  const { from, to } = ends(normal, size);
  const radius = (strong ? 0.0105 : 0.006) * size;
  const line = { body: i + 1, from, to, radius, colour: theme.normal, dash: 0.02 * size, gap: 0.011 * size };
  const name = label(middle(from, to), `normal ${i + 1}–${i + 2}`, theme.normal, 3, { body: i + 1 });
  return [...dashedLine(line), ...(strong ? [name] : [])];
}

/** A length of a DH row: d along an axis or a along a common normal. */
function segment(name, from, to, { size, theme }) {
  const colour = name.startsWith('d') ? theme.axis : theme.normal;
  const [base, sub] = name.split('_');
  return [
    { body: 0, shape: 'capsule', from, to, radius: 0.012 * size, colour },
    label(middle(from, to), base, colour, 5, { body: 0, sub }),
  ];
}

function highlighted(pose, letter, length) {
  const from = originOf(pose);
  return letter === 'O' ? { from } : { from, to: add(from, column(pose, 'xyz'.indexOf(letter)), length) };
}
