// A button that starts a periodic motion and stops it when it is pressed again.
import { button } from '../dom.js';

/** Period of the motion. */
export const ROUND_MS = 4000;
const REDUCED_MOTION_STEPS = 4; // per period, if the reader prefers reduced motion

/**
 * @param begin is called when the motion starts
 * @param tick (time in milliseconds, fraction of the period) draws one frame
 * @returns { button, stop }
 */
export function playButton(begin, tick) {
  let frame = 0;
  let begun = 0;
  const calm = matchMedia('(prefers-reduced-motion: reduce)');
  const play = button('▶ Play', () => (frame ? stop() : start()), { class: 'kv-play' });
  function stop() {
    cancelAnimationFrame(frame);
    frame = 0;
    play.textContent = '▶ Play';
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
    tick(time, calm.matches ? Math.floor(share * REDUCED_MOTION_STEPS) / REDUCED_MOTION_STEPS : share);
    if (play.isConnected) frame = requestAnimationFrame(step);
    else stop();
  }
  return { button: play, stop };
}
