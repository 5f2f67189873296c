// The controls of a player: Back, Play, Next and a slider. `at` is the stop that is shown; a fraction is the way to the next.
import { button, moveSlider, named, slider, stepsOf, uniqueId } from '../dom.js';

const ease = (x) => x * x * (3 - 2 * x);
const uneased = (y) => 0.5 - Math.sin(Math.asin(1 - 2 * y) / 3);
const NEAR = 1e-9;

/**
 * @param model with at
 * @param last () -> the number of the last stop
 * @param textOf (stop) -> what is said of it
 * @param name of a stop; pace in milliseconds from one to the next, 0 for no Play; between: whether the way between is shown
 * @param closed () -> whether Play goes round and round (true), to and fro (false), or to the end (undefined)
 * @param ends the stops of Back and Next, and of Play if the reader prefers reduced motion; by default all
 * @param prepare called before Play starts
 */
export function stepControls({
  model,
  last,
  textOf,
  name = 'step',
  label,
  pace = 0,
  between = false,
  closed = () => undefined,
  ends,
  prepare = () => {},
}) {
  const id = uniqueId('stop');
  const calm = matchMedia('(prefers-reduced-motion: reduce)');
  const at = () => model.get('at');
  let flight = 0;
  const set = (value, keep = true) => {
    const wanted = Math.max(0, Math.min(last(), value));
    if (wanted !== at()) model.set('at', wanted);
    if (keep) model.save_changes();
  };

  function stop() {
    cancelAnimationFrame(flight);
    if (flight) model.save_changes();
    flight = 0;
    play.textContent = '▶ Play';
  }
  /** Where Play is, in stops, when it has run so long. */
  function reached(from, way, goal, gone) {
    const turns = closed();
    if (turns === true) return (from + gone) % last();
    if (turns === false) return last() - Math.abs(((from + gone) % (2 * last())) - last());
    return way > 0 ? Math.min(goal, from + gone) : Math.max(goal, from - gone);
  }
  function fly(goal) {
    stop();
    const whole = Math.floor(at() + NEAR);
    const from = between ? whole + uneased(Math.max(0, at() - whole)) : at();
    const way = Math.sign(goal - from);
    let begun;
    const tick = (now) => {
      begun ??= now;
      const place = reached(from, way, goal, Math.max(0, now - begun) / pace);
      const passed = way > 0 ? Math.floor(place + NEAR) : Math.ceil(place - NEAR);
      const arrived = closed() === undefined && place === goal;
      if (!bar.isConnected || arrived) {
        if (arrived) set(goal);
        return stop();
      }
      const low = Math.floor(place + NEAR);
      if (calm.matches) set(ends?.find((end) => end >= passed) ?? passed, false);
      else set(between ? low + ease(Math.max(0, place - low)) : passed, false);
      flight = requestAnimationFrame(tick);
    };
    play.textContent = '❚❚ Pause';
    flight = requestAnimationFrame(tick);
  }
  /** Go to a stop, with its motion if the way is shown. */
  function go(goal) {
    const wanted = Math.max(0, Math.min(last(), goal));
    if (between && !(calm.matches && Math.abs(wanted - at()) <= 1)) return fly(wanted);
    stop();
    set(wanted);
  }
  const back = () => go(ends ? ([0, ...ends].findLast((end) => end < at()) ?? 0) : Math.ceil(at() - NEAR) - 1);
  const next = () => go(ends?.find((end) => end > at()) ?? Math.floor(at() + NEAR) + 1);
  const play = button('▶ Play', () => {
    if (flight) return stop();
    prepare();
    if (at() >= last() && closed() === undefined) set(0);
    fly(last());
  });
  play.className = 'kv-play';
  const backward = button('◀ Back', back, named(`One ${name} back`));
  const forward = button('Next ▶', next, named(`Next ${name}`));
  const drag = (value) => {
    stop();
    set(value);
  };
  const bar = slider(last(), drag, {
    id,
    step: between ? 'any' : 1,
    'aria-label': label ?? `${name[0].toUpperCase()}${name.slice(1)}`,
  });
  return {
    id,
    buttons: [backward, ...(pace ? [play] : []), forward],
    bar,
    go,
    stop,
    /** Let keys go to other stops, except from a list of choices. */
    onkeydown(event) {
      if (event.target.tagName === 'SELECT') return;
      const by = stepsOf(event, { PageDown: 5, PageUp: -5 });
      if (!by) return;
      stop();
      set(by > 0 ? Math.floor(at() + NEAR) + by : Math.ceil(at() - NEAR) + by);
    },
    update() {
      bar.max = last();
      moveSlider(bar, at(), textOf(at()));
      // aria-disabled, because a disabled button would lose the focus
      backward.setAttribute('aria-disabled', String(at() <= 0));
      forward.setAttribute('aria-disabled', String(at() >= last()));
    },
  };
}
