// The motions of a DH row, one after the other. Each track is an arm whose joints are the motions, so that the scene
// graph moves the frame. `done` counts the completed motions; during a motion it is a fraction.

import { renderMathText, setSentence } from '../controls/math-text.js';
import { button, formatNumber, h, moveSlider, named, slider, stepsOf } from '../dom.js';
import { listen } from '../model.js';
import { frameText, vectorText } from '../scene/describe.js';
import { dashedLine, label } from '../scene/shapes.js';
import { add, middle, minus } from '../vectors.js';
import { angleSectors } from './angle-sectors.js';
import { frame, mixColours, originOf } from './frame-drawing.js';

const FRAME_LENGTH = 0.34; // as a fraction of the size of the scene
const MOTION_MS = 1100;

/**
 * @param kit.data { tracks: [{ title, stops, axes, flags,
 *   motions: [{ screw, value, axis, angle, travel, symbol, text }] }] }
 */
export function dhRowMotions({ model, stage, data }) {
  const { tracks } = data;
  const { size } = stage.data;
  const last = tracks[0].motions.length;
  const done = () => model.get('done');
  const calm = matchMedia('(prefers-reduced-motion: reduce)');
  const shares = () => tracks.map(({ motions }) => motions.map((_, k) => Math.max(0, Math.min(1, done() - k))));
  const sectors = angleSectors(stage, tracks, shares, 0.62 * FRAME_LENGTH * size);
  let flight = 0;
  let drawnUpTo = -1;

  const set = (value, keep = true) => {
    model.set('done', Math.max(0, Math.min(last, value)));
    if (keep) model.save_changes();
  };
  function stop() {
    cancelAnimationFrame(flight);
    flight = 0;
    play.textContent = '▶ Play';
  }
  /** Go to a number of completed motions, animated, or at once if the reader prefers reduced motion. */
  function fly(goal) {
    stop();
    const wanted = Math.max(0, Math.min(last, goal));
    let from = done();
    let begun;
    const tick = (now) => {
      begun ??= now;
      if (!play.isConnected) return stop();
      const next =
        wanted > from ? Math.min(wanted, Math.floor(from + 1e-9) + 1) : Math.max(wanted, Math.ceil(from - 1e-9) - 1);
      const share = Math.min(1, Math.max(0, (now - begun) / MOTION_MS));
      if (share < 1) set(calm.matches ? from : from + (next - from) * share * share * (3 - 2 * share), false);
      else {
        set(next);
        [from, begun] = [next, now];
        if (next === wanted) return stop();
      }
      flight = requestAnimationFrame(tick);
    };
    if (calm.matches && Math.abs(wanted - from) <= 1) return set(wanted);
    play.textContent = '❚❚ Pause';
    flight = requestAnimationFrame(tick);
  }

  function playOrPause() {
    if (flight) {
      stop();
      model.save_changes();
    } else {
      if (done() >= last) set(0);
      fly(last);
    }
  }
  const drag = (value) => {
    stop();
    set(value);
  };
  const play = button('▶ Play', playOrPause, { class: 'kv-play' });
  const back = button('◀ Back', () => fly(Math.ceil(done() - 1e-9) - 1), named('One motion back'));
  const next = button('Next ▶', () => fly(Math.floor(done() + 1e-9) + 1), named('Next motion'));
  const bar = slider(last, drag, {
    step: 'any',
    'aria-label': 'Motions done',
    onkeydown: (event) => {
      const by = stepsOf(event);
      if (!by) return;
      stop();
      set(by > 0 ? Math.floor(done() + 1e-9) + by : Math.ceil(done() - 1e-9) + by);
    },
  });
  const lines = tracks.map(({ title, motions }) => {
    const factors = motions.map((motion, k) =>
      button(renderMathText(motion.symbol), () => fly(k + 1), {
        class: 'kv-factor',
        title: `Go to the end of motion ${k + 1}`,
      }),
    );
    const explanation = h('p', { class: 'kv-motion-text' });
    const head = title ? [h('p', { class: 'kv-title' }, `${title} convention`)] : [];
    return {
      factors,
      explanation,
      element: h('div', { class: 'kv-track' }, ...head, h('div', { class: 'kv-product' }, ...factors), explanation),
    };
  });
  const element = h(
    'section',
    { class: 'kv-player', role: 'group', 'aria-label': 'Motions of the row' },
    h('div', { class: 'kv-buttons' }, back, play, next),
    bar,
    h('div', { 'aria-live': 'polite' }, ...lines.map((line) => line.element)),
  );

  function write() {
    const count = done();
    const at = Math.min(last, Math.ceil(count - 1e-9));
    moveSlider(bar, count, `${formatNumber(count, Number.isInteger(count) ? 0 : 1)} of ${last} motions`);
    back.setAttribute('aria-disabled', String(count <= 0));
    next.setAttribute('aria-disabled', String(count >= last));
    lines.forEach(({ factors, explanation }, k) => {
      factors.forEach((factor, i) => {
        factor.classList.toggle('kv-done', i < at);
        if (i === at - 1) factor.setAttribute('aria-current', 'step');
        else factor.removeAttribute('aria-current');
      });
      const text = at ? tracks[k].motions[at - 1].text : 'No motion is complete yet: the frame is at its start.';
      setSentence(explanation, text);
    });
  }

  function move() {
    stage.tree.setQ(tracks.flatMap(({ motions }, k) => motions.map(({ value }, i) => value * shares()[k][i])));
    const reached = Math.floor(done() + 1e-9);
    if (reached !== drawnUpTo) drawReachedFrames(reached);
    // at a frame that stays, its own labels are shown; between two of them, the labels of the moving frame
    stage.showLayer('names', !tracks[0].flags.some(({ after }) => after === done()));
  }

  /** Draw the frames that have been reached, which stay, and the names of the completed translations. */
  function drawReachedFrames(reached) {
    drawnUpTo = reached;
    const kit = { size, theme: stage.theme, length: FRAME_LENGTH };
    stage.setLayer(
      'planted',
      tracks.flatMap(({ flags, stops, motions }, k) =>
        [
          ...flags
            .filter(({ after }) => after <= reached)
            .flatMap(({ name, pose, after }) =>
              frame(name.replace('-', '−').split(' ')[0], pose, 'Oxz', {
                ...kit,
                strong: after === reached,
                length: after ? FRAME_LENGTH : 0.9 * FRAME_LENGTH,
              }).concat(
                name.includes(' ') ? [label(originOf(pose), `{${name}}`, stage.theme.ink, 7, { italic: false })] : [],
              ),
            ),
          ...motions.flatMap(({ symbol, travel, axis, value }, i) =>
            i < reached && travel * value ? [way(symbol, axis, stops[i], stops[i + 1], stage.theme)] : [],
          ),
        ].map((part) => ({ ...part, arm: k, body: 0 })),
      ),
      { through: true },
    );
  }

  function applyTheme() {
    const { theme } = stage;
    const faint = mixColours(theme.ghost, theme.paper, 0.3);
    const pale = { ...theme, x: faint, y: faint, z: faint, quiet: faint };
    const on = (k) => (part) => ({ arm: k, body: 0, ...part });
    stage.setLayer(
      'still',
      tracks.flatMap(({ title, axes, stops, motions }, k) =>
        [
          ...motions.flatMap(({ axis, travel, value }, i) =>
            axis === 'x' && travel * value
              ? dashedLine({
                  from: originOf(stops[i]),
                  to: originOf(stops[i + 1]),
                  radius: 0.008 * size,
                  colour: theme.normal,
                  dash: 0.03 * size,
                  gap: 0.03 * size,
                })
              : [],
          ),
          ...axes.flatMap(({ from, to, name, joint }) => line(from, to, name, joint, { size, theme })),
          ...frame('', stops[last], 'Oxyz', { size, theme: pale, strong: false, length: 0.9 * FRAME_LENGTH }).filter(
            (part) => !part.label,
          ),
          ...(title
            ? [label(add(originOf(stops[0]), [0, 0, -0.5 * size]), title, theme.ink, 9, { italic: false })]
            : []),
        ].map(on(k)),
      ),
    );
    const moving = tracks.flatMap(({ stops }, k) =>
      frame('', stops[0], 'Oxyz', { size, theme, length: FRAME_LENGTH, body: last }).map((part) => ({
        ...part,
        arm: k,
      })),
    );
    stage.setLayer(
      'moving',
      moving.filter((part) => !part.label),
      { through: true },
    );
    stage.setLayer(
      'names',
      moving.filter((part) => part.label),
    );
    stage.setRods(
      'ways',
      tracks.flatMap(({ motions, stops }, k) =>
        motions.flatMap(({ axis, travel }, i) =>
          travel
            ? [
                {
                  arm: k,
                  body: i,
                  joint: i,
                  start: originOf(stops[0]),
                  axis: axis === 'x' ? [1, 0, 0] : [0, 0, 1],
                  travel,
                  radius: 0.022 * size,
                  colour: axis === 'x' ? theme.normal : theme.axis,
                },
              ]
            : [],
        ),
      ),
    );
    drawnUpTo = -1;
    move();
  }

  const changed = () => {
    write();
    move();
  };
  const stopListening = listen(model, { done: changed });
  write();
  return {
    element,
    replacesSliders: true,
    applyTheme,
    describe: () => describeRow(stage.tree, tracks, done()),
    update: move, // the joint values follow from `done`
    dispose() {
      stop();
      stopListening();
      sectors.dispose();
    },
  };
}

/** Where the frame of each track is, measured from the frame at which its row begins. */
function describeRow(tree, tracks, done) {
  const places = tracks.map(({ title, stops, flags }, k) => {
    const T = tree.pose(k).map((row, i) => [...row.slice(0, 3), row[3] - (originOf(stops[0])[i] ?? 0)]);
    const of = title ? `, ${title} convention,` : '';
    const moving = frameText('i', T).replace('Frame {i}', `The moving frame${of} is`);
    const reached = flags
      .filter(({ after }) => after <= done)
      .map(({ name, pose }) => `{${name}} at ${vectorText(minus(originOf(pose), originOf(stops[0])))}`);
    return `${moving} Reached: ${reached.join('; ')}.`;
  });
  const count = formatNumber(done, Number.isInteger(done) ? 0 : 1);
  return `Motions that move a frame: ${count} of ${tracks[0].motions.length} done. ${places.join(' ')}`;
}

function line(from, to, name, joint, { size, theme }) {
  const colour = joint ? theme.axis : mixColours(theme.axis, theme.paper, 0.45);
  return [
    ...dashedLine({ from, to, radius: (joint ? 0.009 : 0.006) * size, colour, dash: 0.06 * size, gap: 0.03 * size }),
    ...(name ? [label(to, name, theme.axis, 5, { from })] : []),
  ];
}

/** The name of a completed translation: d along z, a along x. */
function way(symbol, axis, start, end, theme) {
  const letter = symbol.match(/\(([ad])\)/)?.[1] ?? symbol.replace('_', '');
  return label(middle(originOf(start), originOf(end)), letter, axis === 'x' ? theme.normal : theme.axis, 6);
}
