// The panel of assign mode: which frame, its three parts as lists for keys and screen readers, the rules, the table.
import { h, NO_SHORTCUTS } from '../dom.js';
import { renderMathText } from '../math-text.js';
import { perpendicularTo } from '../parts.js';
import { roundStep } from '../stage.js';
import { dhTable } from './dh-table.js';
import { add, columnOf, near, openPart, PARTS, rotatePerpendicular } from './vectors.js';

const ROTATION_STEP_DEG = 15; // degrees for one press
const INSTRUCTIONS = {
  z: 'Which way does z_{i} point? Tap one end of an axis.',
  origin: 'Where is O_{i}? Tap a ring, or anywhere on an axis. Then drag it along.',
  x: 'Which way does x_{i} point? Tap the dial round the origin, or drag the tip of x. It snaps to named directions.',
};
const MISSING = {
  z: 'First give z_{i} a direction: x is square to it.',
  origin: 'First put O_{i} somewhere: x starts there.',
};
const SYMBOLS = { z: 'z_', origin: 'O_', x: 'x_' };
const withIndex = (text, i) => text.replaceAll('{i}', `${i}`);

export function placeFramesPanel({
  model,
  data,
  target,
  size,
  picks,
  place,
  go,
  undo,
  clear,
  ask,
  breaches,
  touched,
  past,
}) {
  const frames = () => model.get('frames');
  const button = (text, label, act) =>
    h('button', { type: 'button', ...NO_SHORTCUTS, 'aria-label': label, title: label, onclick: act }, text);
  const tabs = frames().map((_, i) =>
    h('button', { type: 'button', class: 'kv-tab', ...NO_SHORTCUTS, onclick: () => go(i) }),
  );
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
        go((target().i + by + tabs.length) % tabs.length);
        tabs[target().i].focus();
      },
    },
    ...tabs,
  );
  const how = h('p', { class: 'kv-how', 'aria-live': 'polite' });
  const step = roundStep(size / 25);
  const at = (part, act) => {
    if (target().part !== part) go(target().i, part);
    act();
  };
  const slide = (by) =>
    at('origin', () => {
      const { origin, z } = target();
      if (origin && z) place(add(origin, z, by * step));
    });
  const turn = (by) =>
    at('x', () => {
      const { x, z } = target();
      if (z)
        place(
          x
            ? rotatePerpendicular(x, z, (by * ROTATION_STEP_DEG * Math.PI) / 180)
            : (picks.named(z)[0]?.along ?? perpendicularTo(z)),
        );
    });
  const lists = { z: groupDirections(data.z), origin: data.points.map(({ at: point, text }) => [point, text]) };
  const rows = Object.fromEntries(
    Object.keys(PARTS).map((part) => {
      const choose = h('button', {
        type: 'button',
        class: 'kv-part',
        ...NO_SHORTCUTS,
        onclick: () => go(target().i, part),
      });
      const select = h('select', {
        ...NO_SHORTCUTS,
        onfocus: () => target().part !== part && go(target().i, part),
        onchange: () => {
          const value = JSON.parse(select.value);
          if (value) at(part, () => place(value));
        },
      });
      const nudge = {
        z: [],
        origin: [
          button('−', `Slide the origin ${step} m back along z`, () => slide(-1)),
          button('+', `Slide the origin ${step} m along z`, () => slide(1)),
        ],
        x: [
          button('↺', `Turn x by ${ROTATION_STEP_DEG} degrees about z`, () => turn(1)),
          button('↻', `Turn x by ${ROTATION_STEP_DEG} degrees the other way`, () => turn(-1)),
        ],
      }[part];
      return [part, { choose, select, nudge, element: h('div', { class: 'kv-place' }, choose, select, ...nudge) }];
    }),
  );
  const check = h('button', { type: 'button', class: 'kv-main', ...NO_SHORTCUTS, onclick: ask }, 'Check the rules');
  const back = button('↶ Undo', 'Undo the last change', undo);
  const wipe = button('Clear', 'Take this frame away', clear);
  const copy = button('Copy', 'Copy the frames as Python', () => copyFrames());
  const said = h('div', { class: 'kv-verdict', 'aria-live': 'polite' });
  const element = h(
    'section',
    { class: 'kv-player kv-assign', role: 'group', 'aria-label': 'Frames by hand' },
    h(
      'div',
      { class: 'kv-head' },
      h('span', { class: 'kv-title' }, 'Place the frames'),
      h('span', { class: 'kv-told' }, `${data.convention} convention`),
    ),
    bar,
    how,
    ...Object.values(rows).map((row) => row.element),
    h('div', { class: 'kv-buttons' }, check, back, wipe, copy),
    said,
  );

  async function copyFrames() {
    const text = asPython(frames());
    try {
      await navigator.clipboard.writeText(text);
      copy.textContent = 'Copied';
    } catch {
      said.replaceChildren(
        h('p', {}, 'The clipboard is closed to this page. Copy this:'),
        h('pre', { tabindex: 0 }, text),
      );
      return;
    }
    setTimeout(() => {
      copy.textContent = 'Copy';
    }, 1500);
  }

  function fill(part, { select, choose, nudge }, state) {
    const { i } = state;
    const value = state[part];
    const list =
      part === 'x' ? (state.z ? picks.named(state.z) : []).map(({ along, text }) => [along, text]) : lists[part];
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
    const state = target();
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
    if (how.dataset.text !== text) how.replaceChildren(...renderMathText(text));
    how.dataset.text = text;
    for (const name of Object.keys(rows)) fill(name, rows[name], state);
    check.setAttribute('aria-disabled', String(waiting));
    back.disabled = !past.length;
    showVerdict(broken, waiting);
  }

  function showVerdict(broken, waiting) {
    const { asked, breaches: all = [], table = [], off = 0 } = model.get('verdict');
    const left = frames()
      .map((T, k) => (openPart(T) ? k : null))
      .filter((k) => k !== null);
    const key = JSON.stringify([asked, model.get('asked'), broken, waiting, left, touched().length]);
    if (said.dataset.key === key) return;
    said.dataset.key = key;
    if (model.withoutKernel && model.get('asked') > (asked ?? 0)) {
      said.replaceChildren(
        h(
          'p',
          {},
          'Judging takes Python, and this page has none. Copy your frames, and check them in the notebook: kl.check_frames, or the sheet.',
        ),
      );
    } else if (waiting) said.replaceChildren(h('p', {}, 'Asking Python …'));
    else if (!asked) said.replaceChildren();
    else if (broken.length) {
      said.replaceChildren(
        h('p', { class: 'kv-title' }, `${broken.length} broken ${broken.length > 1 ? 'rules' : 'rule'}`),
        h(
          'ul',
          {},
          ...broken.map((one) =>
            h(
              'li',
              {},
              h(
                'button',
                { type: 'button', class: 'kv-breach', ...NO_SHORTCUTS, onclick: () => go(one.frame, partOf(one.rule)) },
                h('b', { class: 'kv-wrong' }, `✕ joint ${one.joint}: `),
                ...renderMathText(one.text),
              ),
            ),
          ),
        ),
      );
    } else if (touched().length) {
      said.replaceChildren(
        h(
          'p',
          {},
          all.length
            ? 'Nothing of what was broken is left as it was. Check again.'
            : 'The frames have changed. Check again.',
        ),
      );
    } else if (left.length)
      said.replaceChildren(
        h('p', {}, `So far no rule is broken. Still open: ${left.map((k) => `frame ${k}`).join(', ')}.`),
      );
    else {
      said.replaceChildren(
        h('p', { class: 'kv-right' }, '✓ Every rule holds. This is a right assignment.'),
        h(
          'p',
          {},
          `The table read off your frames is this arm: its poses differ by ${off < 1e-12 ? 'less than 1e−12' : off.toExponential(0).replace('-', '−')}.` +
            (table.some((row) => row.join().includes('−q'))
              ? ' Where a z points against its axis, q stands with a minus.'
              : ''),
        ),
        dhTable(data.convention, table),
      );
    }
  }

  return {
    element,
    update,
    showNoAnswer: () => said.replaceChildren(h('p', {}, 'No answer from Python yet. Is the kernel running?')),
  };
}

/** Each direction once, with all its names: axes may be parallel. */
function groupDirections(all) {
  const found = [];
  for (const { along, text } of all) {
    const same = found.find(([other]) => near(other, along));
    if (same) same[1] += `; ${text}`;
    else found.push([along, text]);
  }
  return found;
}

const partOf = (rule) => ['z', 'origin'].find((part) => rule.startsWith(part)) ?? 'x';

/** The mark of a frame that breaks no rule, and its name for screen readers. */
function progressOf(T) {
  if (!openPart(T)) return ['●', 'placed'];
  return columnOf(T, 2) ? ['◐', 'started'] : ['○', 'not started'];
}

/** The frames as code: pose((x, y, z), origin) of kinlib.robots, with what is open left out. */
function asPython(frames) {
  const number = (value) => `${Number(value.toFixed(12))}`;
  const vector = (values) => `(${values.map(number).join(', ')})`;
  const lines = frames.map((T) =>
    openPart(T)
      ? '    ...,'
      : `    pose((${[0, 1, 2].map((k) => vector(columnOf(T, k))).join(', ')}), ${vector(columnOf(T, 3))}),`,
  );
  return `[\n${lines.join('\n')}\n]`;
}
