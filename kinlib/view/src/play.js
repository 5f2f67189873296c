// Play: a button that moves something round after round, until it is pressed again.
import { h, KEYS } from './dom.js';

/** Milliseconds for one round. */
export const ROUND = 4000;
const STATIONS = 4; // in a round, for who prefers reduced motion

/** @param begin called as it starts; @param tick(time, share of the round) moves things; @returns { button, stop } */
export function player(begin, tick) {
  let frame = 0;
  let begun = 0;
  const calm = matchMedia('(prefers-reduced-motion: reduce)');
  const button = h(
    'button',
    { type: 'button', class: 'kv-play', ...KEYS, onclick: () => (frame ? stop() : start()) },
    '▶ Play',
  );
  function stop() {
    cancelAnimationFrame(frame);
    frame = 0;
    button.textContent = '▶ Play';
  }
  function start() {
    begin();
    begun = performance.now();
    button.textContent = '❚❚ Pause';
    frame = requestAnimationFrame(step);
  }
  function step(now) {
    const time = Math.max(0, now - begun);
    const share = (time % ROUND) / ROUND;
    tick(time, calm.matches ? Math.floor(share * STATIONS) / STATIONS : share);
    if (button.isConnected) frame = requestAnimationFrame(step);
    else stop();
  }
  return { button, stop };
}
