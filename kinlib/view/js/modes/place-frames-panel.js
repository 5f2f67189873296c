// The panel for placing frames: the choice of frame, its three parts as lists for keyboards and screen readers, the
// verdict on the rules, and the DH table.

import { renderMathText, setSentence } from '../controls/math-text.js';
import { button, copyToClipboard, h, NO_SHORTCUTS, named } from '../dom.js';
import { roundStep } from '../render/stage.js';
import { perpendicularTo } from '../scene/parts.js';
import { add, columnOf, near, openPart, PARTS, rotatePerpendicular } from '../vectors.js';
import { dhTable } from './dh-table.js';

const ROTATION_STEP_DEG = 15; // for one press of a button
const INSTRUCTIONS = {
  z: 'Choose the direction of z_{i}: tap one end of an axis.',
  origin: 'Choose O_{i}: tap a ring or any point of an axis. You can then drag it along the axis.',
  x: 'Choose the direction of x_{i}: tap the dial around O_{i} or drag the tip of x_{i}. It snaps to named directions.',
};
const MISSING = {
  z: 'Choose the direction of z_{i} first, because x_{i} must be perpendicular to it.',
  origin: 'Place O_{i} first, because x_{i} starts there.',
};
const NO_KERNEL =
  'Checking needs Python, and this page has none. Copy your frames and check them in a notebook ' +
  'with kl.check_frames, or in the sheet.';
const SYMBOLS = { z: 'z_', origin: 'O_', x: 'x_' };
const withIndex = (text, i) => text.replaceAll('{i}', `${i}`);

export function placeFramesPanel({
  model,
  data,
  selected,
  size,
  picker,
  setPart,
  selectPart,
  undo,
  clear,
  requestVerdict,
  breaches,
  changedFrames,
  history,
}) {
  const frames = () => model.get('frames');
  const tabs = frames().map((_, i) => button('', () => selectPart(i), { class: 'kv-tab' }));
  const bar = h(
    'div',
    {
      class: 'kv-tabs',
      role: 'group',
      'aria-label': 'Frames',
      onkeydown: (event) => {
        const by = { ArrowRight: 1, ArrowLeft: -1 }[event.key];
        if (!by) return;
        event.preventDefault();
        selectPart((selected().i + by + tabs.length) % tabs.length);
        tabs[selected().i].focus();
      },
    },
    ...tabs,
  );
  const instruction = h('p', { class: 'kv-how', 'aria-live': 'polite' });
  const step = roundStep(size / 25);
  const withPartSelected = (part, act) => {
    if (selected().part !== part) selectPart(selected().i, part);
    act();
  };
  const moveOrigin = (by) =>
    withPartSelected('origin', () => {
      const { origin, z } = selected();
      if (origin && z) setPart(add(origin, z, by * step));
    });
  const rotateX = (by) =>
    withPartSelected('x', () => {
      const { x, z } = selected();
      if (z)
        setPart(
          x
            ? rotatePerpendicular(x, z, (by * ROTATION_STEP_DEG * Math.PI) / 180)
            : (picker.namedDirections(z)[0]?.along ?? perpendicularTo(z)),
        );
    });
  const lists = { z: groupDirections(data.z), origin: data.points.map(({ at: point, text }) => [point, text]) };
  const rows = Object.fromEntries(
    Object.keys(PARTS).map((part) => {
      const choose = button('', () => selectPart(selected().i, part), { class: 'kv-part' });
      const select = h('select', {
        ...NO_SHORTCUTS,
        onfocus: () => selected().part !== part && selectPart(selected().i, part),
        onchange: () => {
          const value = JSON.parse(select.value);
          if (value) withPartSelected(part, () => setPart(value));
        },
      });
      const nudge = {
        z: [],
        origin: [
          button('−', () => moveOrigin(-1), named(`Move the origin by −${step} m along z`)),
          button('+', () => moveOrigin(1), named(`Move the origin by ${step} m along z`)),
        ],
        x: [
          button('↺', () => rotateX(1), named(`Rotate x by ${ROTATION_STEP_DEG} degrees about z`)),
          button('↻', () => rotateX(-1), named(`Rotate x by −${ROTATION_STEP_DEG} degrees about z`)),
        ],
      }[part];
      return [part, { choose, select, nudge, element: h('div', { class: 'kv-place' }, choose, select, ...nudge) }];
    }),
  );
  const check = button('Check the rules', requestVerdict, { class: 'kv-main' });
  const back = button('↶ Undo', undo, named('Undo the last change'));
  const clearButton = button('Clear', clear, named('Clear this frame'));
  const copy = button('Copy', () => copyFrames(), named('Copy the frames as Python'));
  const verdictBox = h('div', { class: 'kv-verdict', 'aria-live': 'polite' });
  const element = h(
    'section',
    { class: 'kv-player kv-assign', role: 'group', 'aria-label': 'Frames by hand' },
    h(
      'div',
      { class: 'kv-head' },
      h('span', { class: 'kv-title' }, 'Place the frames'),
      h('span', { class: 'kv-small' }, `${data.convention} convention`),
    ),
    bar,
    instruction,
    ...Object.values(rows).map((row) => row.element),
    h('div', { class: 'kv-buttons' }, check, back, clearButton, copy),
    verdictBox,
  );

  async function copyFrames() {
    copy.textContent = (await copyToClipboard(formatPython(frames()))) ? 'Copied' : 'No access to the clipboard';
    setTimeout(() => {
      copy.textContent = 'Copy';
    }, 1500);
  }

  function updatePart(part, { select, choose, nudge }, state) {
    const { i } = state;
    const value = state[part];
    const list =
      part === 'x'
        ? (state.z ? picker.namedDirections(state.z) : []).map(({ along, text }) => [along, text])
        : lists[part];
    const found = value && list.findIndex(([other]) => near(other, value));
    const own =
      value && found < 0
        ? [
            [
              value,
              `at (${value
                .map((number) => Number(number.toFixed(4)))
                .join(', ')
                .replaceAll('-', '−')})`,
            ],
          ]
        : [];
    const entries = [...(value ? [] : [[null, 'not chosen yet']]), ...own, ...list];
    const key = JSON.stringify(entries);
    if (select.dataset.key !== key)
      select.replaceChildren(...entries.map(([entry, text]) => h('option', { value: JSON.stringify(entry) }, text)));
    select.dataset.key = key;
    select.selectedIndex = value && !own.length ? found : 0;
    select.setAttribute(
      'aria-label',
      { z: `Direction of z ${i}`, origin: `Origin of frame ${i}`, x: `Direction of x ${i}` }[part],
    );
    choose.replaceChildren(...renderMathText(`${SYMBOLS[part]}${i}`));
    choose.setAttribute('aria-label', `Place ${SYMBOLS[part].replace('_', ' ')}${i} in the picture`);
    choose.setAttribute('aria-pressed', String(state.part === part));
    for (const one of nudge) one.disabled = !state.z || (part === 'origin' && !value);
  }

  function update() {
    const state = selected();
    const { i, part, waiting } = state;
    const broken = breaches();
    tabs.forEach((tab, k) => {
      const wrong = broken.some(({ frame }) => frame === k);
      const [mark, word] = wrong ? ['✕', 'breaks a rule'] : progressOf(frames()[k]);
      tab.replaceChildren(h('span', {}, `${k} `), h('span', { class: wrong ? 'kv-wrong' : 'kv-mark' }, mark));
      tab.setAttribute('aria-label', `Frame ${k}, ${word}`);
      tab.setAttribute('aria-pressed', String(k === i));
      tab.tabIndex = k === i ? 0 : -1;
    });
    const missing = part === 'x' && ['z', 'origin'].find((needed) => !state[needed]);
    const text = withIndex(missing ? MISSING[missing] : INSTRUCTIONS[part], i);
    setSentence(instruction, text);
    for (const name of Object.keys(rows)) updatePart(name, rows[name], state);
    check.setAttribute('aria-disabled', String(waiting));
    back.disabled = !history.length;
    showVerdict(broken, waiting);
  }

  function showVerdict(broken, waiting) {
    const { asked, breaches: all = [], table = [], off = 0 } = model.get('verdict');
    const left = frames()
      .map((T, k) => (openPart(T) ? k : null))
      .filter((k) => k !== null);
    const key = JSON.stringify([asked, model.get('asked'), broken, waiting, left, changedFrames().length]);
    if (verdictBox.dataset.key === key) return;
    verdictBox.dataset.key = key;
    verdictBox.replaceChildren(...verdictNodes());

    function verdictNodes() {
      if (waiting) return [h('p', {}, model.withoutKernel ? 'Waiting for Python …' : 'Checking in Python …')];
      if (model.withoutKernel && model.get('asked') > (asked ?? 0)) return [h('p', {}, NO_KERNEL)];
      if (!asked) return [];
      if (broken.length) return brokenRules(broken);
      if (changedFrames().length) {
        const changed = all.length ? 'The frames that broke a rule have changed.' : 'The frames have changed.';
        return [h('p', {}, `${changed} Check again.`)];
      }
      if (left.length) {
        const names = left.map((k) => `frame ${k}`).join(', ');
        return [h('p', {}, `No rule is broken so far. Not complete yet: ${names}.`)];
      }
      const difference = off < 1e-12 ? 'less than 1e−12' : off.toExponential(0).replace('-', '−');
      const reversed = table.some((row) => row.join().includes('−q'));
      return [
        h('p', { class: 'kv-right' }, '✓ Every rule holds: this is a valid frame assignment.'),
        h(
          'p',
          {},
          `The DH table of your frames describes this arm: the poses differ by ${difference}.`,
          reversed ? ' Where a z axis is antiparallel to its joint axis, q has a minus sign.' : '',
        ),
        dhTable(data.convention, table),
      ];
    }
  }

  function brokenRules(broken) {
    const items = broken.map((one) =>
      button(
        [h('b', { class: 'kv-wrong' }, `✕ joint ${one.joint}: `), ...renderMathText(one.text)],
        () => selectPart(one.frame, partOfRule(one.rule)),
        { class: 'kv-breach' },
      ),
    );
    return [
      h('p', { class: 'kv-title' }, `${broken.length} broken ${broken.length > 1 ? 'rules' : 'rule'}`),
      h('ul', {}, ...items.map((item) => h('li', {}, item))),
    ];
  }

  return {
    element,
    update,
    showNoAnswer: () => verdictBox.replaceChildren(h('p', {}, 'No answer from Python yet. Is the kernel running?')),
  };
}

/** Each direction once, with all its names, because axes may be parallel. */
function groupDirections(all) {
  const found = [];
  for (const { along, text } of all) {
    const same = found.find(([other]) => near(other, along));
    if (same) same[1] += `; ${text}`;
    else found.push([along, text]);
  }
  return found;
}

const partOfRule = (rule) => ['z', 'origin'].find((part) => rule.startsWith(part)) ?? 'x';

/** The mark of a frame that breaks no rule, and its name for screen readers. */
function progressOf(T) {
  if (!openPart(T)) return ['●', 'placed'];
  return columnOf(T, 2) ? ['◐', 'started'] : ['○', 'not started'];
}

/** The frames as Python code: pose((x, y, z), origin) of kinlib.robots, and `...` for incomplete frames. */
function formatPython(frames) {
  const number = (value) => `${Number(value.toFixed(12))}`;
  const vector = (values) => `(${values.map(number).join(', ')})`;
  const lines = frames.map((T) =>
    openPart(T)
      ? '    ...,'
      : `    pose((${[0, 1, 2].map((k) => vector(columnOf(T, k))).join(', ')}), ${vector(columnOf(T, 3))}),`,
  );
  return `[\n${lines.join('\n')}\n]`;
}
