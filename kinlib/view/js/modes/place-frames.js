// Frames placed by hand on bare joint axes, part by part, by mouse, touch or keyboard. The frames are a trait, so that
// Python reads them. Python also checks the rules, and a broken rule is highlighted in the picture.
import { listen, save } from '../model.js';
import { describeArm, frameText } from '../scene/describe.js';
import { solids } from '../scene/solids.js';
import { add, columnOf, minus, near, norm, openPart, withPart } from '../vectors.js';
import { createHighlighter } from './highlighter.js';
import { pickHandles } from './place-frames-handles.js';
import { placeFramesPanel } from './place-frames-panel.js';
import { framePicker } from './place-frames-picking.js';

const SILENCE_MS = 6000; // without an answer from Python, until the panel says so

/** The choices for z: both directions along each axis and along z of {b}, each with the position of its handle. */
const choicesOfZ = ({ axes, tool }) =>
  [...axes, tool].flatMap(({ along, from, to }, i) => {
    const name = i < axes.length ? `axis ${i + 1}` : 'z of {b}';
    const opposite = along.map((value) => 0 - value);
    return [
      { at: to, along, text: `along ${name}` },
      { at: from, along: opposite, text: `opposite to ${name}` },
    ];
  });

/** @param kit.data { convention, axes, tool, points, x }, see kinlib/view/viewer/place_frames.py */
export function placeFrames({ model, stage, data: given }) {
  const data = { ...given, z: choicesOfZ(given) };
  const { size } = stage.data;
  const frames = () => model.get('frames');
  const selection = { i: 0, part: 'z', waiting: false };
  const snapshot = () => frames().map((T) => JSON.stringify(T));
  let judgedFrames = model.get('verdict').asked ? snapshot() : null; // the frames that the last verdict is about
  let sentFrames = null;
  const changedFrames = () => (judgedFrames ? snapshot().flatMap((T, i) => (T === judgedFrames[i] ? [] : [i])) : []);
  const history = [];
  const selected = () => {
    const T = frames()[selection.i];
    return { ...selection, z: columnOf(T, 2), origin: columnOf(T, 3), x: columnOf(T, 0) };
  };

  function setFrames(next, final = true) {
    model.set('frames', next);
    if (final) model.save_changes();
  }
  let framesBeforeDrag = null;
  /**
   * Set the selected part.
   * @param final whether the value is final, not an intermediate one of a drag
   * @param advance whether to select the next incomplete part afterwards
   */
  function setPart(value, final = true, advance = false) {
    const { i, part } = selection;
    if (part === 'x' && !columnOf(frames()[i], 2)) return;
    framesBeforeDrag ??= frames();
    if (final) {
      history.push(framesBeforeDrag);
      framesBeforeDrag = null;
    }
    if (advance) selectNext(withPart(frames()[i], part, value));
    setFrames(
      frames().map((T, k) => (k === i ? withPart(T, part, value) : T)),
      final,
    );
    if (advance) redraw(); // picking the present value changes no trait
  }
  /** Select the next missing part of this frame or, if there is none, the next incomplete frame. */
  function selectNext(T) {
    const here = openPart(T);
    const others = frames()
      .map((_, k) => k)
      .filter((k) => k !== selection.i && openPart(frames()[k]));
    const there = others.find((k) => k > selection.i) ?? others[0];
    if (here) selection.part = here;
    else if (there !== undefined) Object.assign(selection, { i: there, part: openPart(frames()[there]) });
    picker.clearHover();
  }
  function selectPart(i, part) {
    Object.assign(selection, { i, part: part ?? openPart(frames()[i]) ?? 'z' });
    picker.clearHover();
    redraw();
  }
  function undo() {
    if (history.length) setFrames(history.pop());
  }
  function clear() {
    history.push(frames());
    const bare = [...Array(3).fill([null, null, null, null]), [0, 0, 0, 1]];
    selection.part = 'z';
    setFrames(frames().map((T, k) => (k === selection.i ? bare.map((row) => [...row]) : T)));
  }
  function requestVerdict() {
    sentFrames = snapshot();
    clearTimeout(selection.timer);
    save(model, 'asked', model.get('asked') + 1);
    // a page of the site may have to load Python first, which it says itself
    selection.waiting = !model.withoutKernel || model.wake(onRefused);
    if (!model.withoutKernel) selection.timer = setTimeout(() => panel.showNoAnswer(), SILENCE_MS);
    panel.update();
  }
  function onRefused() {
    selection.waiting = false;
    model.set('asked', model.get('verdict').asked ?? 0);
    panel.update();
  }

  const highlighter = createHighlighter(stage);
  const picker = framePicker({ stage, data, selected, setPart });
  const handles = pickHandles({
    stage,
    data,
    picker,
    selected,
    broken: () => breaches().map(({ joint }) => data.axes[joint - 1].point),
  });
  /** The broken rules of the last verdict, each with its joint, without those of frames that have changed since. */
  const breaches = () => {
    const standard = data.convention === 'standard';
    const anew = changedFrames();
    return (model.get('verdict').breaches ?? []).flatMap((one) => {
      const i = one.frame;
      const other = i + (standard ? -1 : 1); // the x of a row is that of one frame, and its z that of the other
      if (!one.rule.startsWith('x ')) {
        const joint = standard ? Math.min(i + 1, data.axes.length) : Math.max(i, 1); // the one along whose axis z is
        return anew.includes(i) ? [] : [{ ...one, joint }];
      }
      return anew.includes(i) || anew.includes(other) ? [] : [{ ...one, joint: Math.max(i, other) }];
    });
  };
  const panel = placeFramesPanel({
    model,
    data,
    selected,
    picker,
    size,
    setPart,
    selectPart,
    undo,
    clear,
    requestVerdict,
    breaches,
    changedFrames,
    history,
  });

  /** The placed parts of a frame; a z without an origin is drawn on the joint axis that it is parallel to. */
  function drawnFrame(T) {
    const [x, y, z, origin] = [0, 1, 2, 3].map((k) => columnOf(T, k));
    const joint =
      z &&
      data.axes.find(({ along }) => Math.abs(Math.abs(along[0] * z[0] + along[1] * z[1] + along[2] * z[2]) - 1) < 1e-9);
    const at = origin ?? joint?.point ?? [0, 0, 0];
    const columns = [x ?? [0, 0, 0], y ?? [0, 0, 0], z ?? [0, 0, 0], at];
    const letters = `${origin ? 'O' : ''}${z ? 'z' : ''}${x && origin ? 'xy' : ''}`;
    return { letters, pose: [0, 1, 2].flatMap((row) => columns.map((column) => column[row])) };
  }

  function draw() {
    const placed = frames().map(drawnFrame);
    const here = (i) => columnOf(frames()[i], 3) ?? [NaN];
    const long = placed.map(
      (_, i) => 0.2 + 0.07 * placed.filter((_, k) => k < i && near(here(k), here(i), 1e-6 * size)).length,
    );
    stage.setLayer(
      'placed frames',
      placed.flatMap((part, i) => {
        const strong = i === selection.i;
        const made = solids([{ ...part, kind: 'frame', sub: `${i}`, strong, length: long[i] }], {
          size,
          theme: stage.theme,
        });
        return made.filter(({ text }) => text !== 'y' || strong);
      }),
      { through: true },
    );
    highlighter.mark(
      breaches().flatMap(({ frame: i, rule, joint }) => {
        const T = frames()[i];
        const from = columnOf(T, 3);
        const ray = (k) => ({ from, to: add(from, columnOf(T, k), long[i] * size), isWrong: true });
        const line = { ...data.axes[joint - 1], isWrong: true };
        if (rule === 'origin on axis') return [{ from, isWrong: true }, line];
        if (rule === 'right-handed') return [ray(0), ray(1), ray(2)];
        return rule.startsWith('z') ? [ray(2), line] : [ray(0), line];
      }),
    );
  }

  function redraw() {
    draw();
    panel.update();
  }
  function onVerdict() {
    selection.waiting = false;
    judgedFrames = sentFrames ?? snapshot();
    sentFrames = null;
    clearTimeout(selection.timer);
    redraw();
  }
  const stopListening = listen(model, { frames: redraw, verdict: onVerdict });
  const first = frames().findIndex((T) => openPart(T));
  if (first >= 0) Object.assign(selection, { i: first, part: openPart(frames()[first]) });
  panel.update();
  return {
    element: panel.element,
    replacesSliders: true,
    describe() {
      const whole = frames().flatMap((T, i) => (openPart(T) ? [] : [frameText(i, T)]));
      const arm = describeArm(stage.data, stage.tree, model.get('q'));
      return `${arm} ${whole.join(' ') || 'No frame is placed yet.'}`;
    },
    applyTheme() {
      handles.reserveHandles();
      stage.setLayer(
        'bare axes',
        data.axes.flatMap(({ from, to }, i) => {
          const line = {
            kind: 'line',
            from,
            to,
            colour: 'axis',
            width: 2,
            dashed: true,
            tip: true,
            name: `axis ${i + 1}`,
          };
          // its name is a little beyond the handle at its end
          const off = minus(to, from);
          const beyond = add(to, off, (0.06 * size) / norm(off));
          const made = solids([line], { size, theme: stage.theme });
          return made.map((part) => (part.label ? { ...part, at: beyond } : part));
        }),
        { through: true },
      );
      draw();
    },
    dispose() {
      clearTimeout(selection.timer);
      stopListening();
      for (const one of [highlighter, picker, handles]) one.dispose();
    },
  };
}
