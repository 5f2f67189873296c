// Frames placed by hand on bare joint axes, part by part, by mouse, touch or keyboard. The frames are a trait, so that
// Python reads them. Python also checks the rules, and a broken rule is highlighted in the picture.
import { axis, drawPaleArm, frame, lengths, marker } from './frame-drawing.js';
import { pickHandles } from './place-frames-handles.js';
import { placeFramesPanel } from './place-frames-panel.js';
import { framePicker } from './place-frames-picking.js';
import { add, columnOf, openPart, withPart } from './vectors.js';

const SILENCE_MS = 6000; // without an answer from Python, until the panel says so

/** @param kit.data { convention, axes, z, points, x }, see kinlib/view/candidates.py */
export function placeFrames({ model, stage, data }) {
  const { size } = stage.data;
  const frames = () => model.get('frames');
  const now = { i: 0, part: 'z', waiting: false };
  const shot = () => frames().map((T) => JSON.stringify(T));
  let judgedOn = model.get('verdict').asked ? shot() : null; // the frames that the last verdict is about
  let sent = null;
  const touched = () => (judgedOn ? shot().flatMap((T, i) => (T === judgedOn[i] ? [] : [i])) : []);
  const past = [];
  const target = () => {
    const T = frames()[now.i];
    return { ...now, z: columnOf(T, 2), origin: columnOf(T, 3), x: columnOf(T, 0) };
  };

  function keep(next, kept = true) {
    model.set('frames', next);
    if (kept) model.save_changes();
  }
  let held = null; // the frames before the drag
  /**
   * Set the selected part.
   * @param kept whether the value is final, not an intermediate one of a drag
   * @param on whether to select the next incomplete part afterwards
   */
  function place(value, kept = true, on = false) {
    const { i, part } = now;
    if (part === 'x' && !columnOf(frames()[i], 2)) return;
    held ??= frames();
    if (kept) {
      past.push(held);
      held = null;
    }
    if (on) next(withPart(frames()[i], part, value));
    keep(
      frames().map((T, k) => (k === i ? withPart(T, part, value) : T)),
      kept,
    );
    if (on) changed(); // picking the present value changes no trait
  }
  /** Select the next missing part of this frame or, if there is none, the next incomplete frame. */
  function next(T) {
    const here = openPart(T);
    const others = frames()
      .map((_, k) => k)
      .filter((k) => k !== now.i && openPart(frames()[k]));
    const there = others.find((k) => k > now.i) ?? others[0];
    if (here) now.part = here;
    else if (there !== undefined) Object.assign(now, { i: there, part: openPart(frames()[there]) });
    picks.forget();
  }
  function go(i, part) {
    Object.assign(now, { i, part: part ?? openPart(frames()[i]) ?? 'z' });
    picks.forget();
    changed();
  }
  function undo() {
    if (past.length) keep(past.pop());
  }
  function clear() {
    past.push(frames());
    const bare = [...Array(3).fill([null, null, null, null]), [0, 0, 0, 1]];
    now.part = 'z';
    keep(frames().map((T, k) => (k === now.i ? bare.map((row) => [...row]) : T)));
  }
  function ask() {
    sent = shot();
    clearTimeout(now.timer);
    now.waiting = !model.withoutKernel;
    if (now.waiting) now.timer = setTimeout(() => side.showNoAnswer(), SILENCE_MS);
    model.set('asked', model.get('asked') + 1);
    model.save_changes();
    side.update();
  }

  const pen = marker(stage);
  const picks = framePicker({ stage, data, target, place });
  const marks = pickHandles({
    stage,
    data,
    picks,
    target,
    broken: () => breaches().map(({ joint }) => data.axes[joint - 1].point),
  });
  /** The broken rules of the last verdict, without those of frames that have changed since. */
  const breaches = () => {
    const other = ({ frame: i, rule }) => (rule.startsWith('x ') ? i + (data.convention === 'standard' ? -1 : 1) : i);
    const anew = touched();
    return (model.get('verdict').breaches ?? []).filter(
      (one) => !anew.includes(one.frame) && !anew.includes(other(one)),
    );
  };
  const side = placeFramesPanel({
    model,
    data,
    target,
    picks,
    size,
    place,
    go,
    undo,
    clear,
    ask,
    breaches,
    touched,
    past,
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
    const { theme } = stage;
    const parts = frames().map(drawnFrame);
    const long = lengths(
      parts.map(({ pose }) => pose),
      parts.map(({ letters }) => letters),
      size,
    );
    stage.setLayer(
      'hand',
      parts.flatMap(({ pose, letters }, i) =>
        frame(i, pose, letters, { size, theme, strong: i === now.i, length: long[i], body: 0 }).filter(
          (part) => !part.label || part.text !== 'y' || i === now.i,
        ),
      ),
      { through: true },
    );
    pen.mark(
      breaches().flatMap(({ frame: i, rule, joint }) => {
        const T = frames()[i];
        const from = columnOf(T, 3);
        const ray = (k) => ({ from, to: add(from, columnOf(T, k), long[i] * size), wrong: true });
        const line = { ...data.axes[joint - 1], wrong: true };
        if (rule === 'origin on axis') return [{ from, wrong: true }, line];
        if (rule === 'right-handed') return [ray(0), ray(1), ray(2)];
        return rule.startsWith('z') ? [ray(2), line] : [ray(0), line];
      }),
    );
  }

  function changed() {
    draw();
    side.update();
  }
  function judged() {
    now.waiting = false;
    judgedOn = sent ?? shot();
    sent = null;
    clearTimeout(now.timer);
    changed();
  }
  model.on('change:frames', changed);
  model.on('change:verdict', judged);
  const first = frames().findIndex((T) => openPart(T));
  if (first >= 0) Object.assign(now, { i: first, part: openPart(frames()[first]) });
  side.update();
  return {
    element: side.element,
    replacesSliders: true,
    applyTheme() {
      marks.reserveHandles();
      drawPaleArm(stage);
      stage.setLayer(
        'bare axes',
        data.axes.flatMap(({ from, to }, i) => axis(i, from, to, { size, theme: stage.theme, beyond: 0.06 })),
        { through: true },
      );
      draw();
    },
    dispose() {
      clearTimeout(now.timer);
      model.off('change:frames', changed);
      model.off('change:verdict', judged);
      for (const one of [pen, picks, marks]) one.dispose();
    },
  };
}
