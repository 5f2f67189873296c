// A button that starts a motion and stops it when it is pressed again.
import { button } from '../dom.js';

/** Period of the motion. */
export const ROUND_MS = 4000;
const REDUCED_MOTION_STEPS = 4; // per period, if the reader prefers reduced motion

/**
 * @param begin is called when the motion starts
 * @param tick (time in milliseconds, fraction of the period) draws one frame; if it returns false, the motion has ended
 * @param ended is called when the motion stops
 * @returns { button, stop }
 */
export function playButton(begin, tick, ended = () => {}) {
  let frame = 0;
  let begun = 0;
  const calm = matchMedia('(prefers-reduced-motion: reduce)');
  const play = button('▶ Play', () => (frame ? stop() : start()), { class: 'kv-play' });
  function stop() {
    cancelAnimationFrame(frame);
    frame = 0;
    play.textContent = '▶ Play';
    ended();
  }
  function start() {
    begin();
    begun = performance.now();
    play.textContent = '❚❚ Pause';
    frame = requestAnimationFrame(step);
  }
  function step(now) {
    const time = Math.max(0, now - begun);
    const share = (time % ROUND_MS) / ROUND_MS;
    const shown = calm.matches ? Math.floor(share * REDUCED_MOTION_STEPS) / REDUCED_MOTION_STEPS : share;
    if (tick(time, shown) !== false && play.isConnected) frame = requestAnimationFrame(step);
    else stop();
  }
  return { button: play, stop };
}
