// A film: drawings that follow each other, with a button to play and stop them, a slider, and the caption of each scene.
import { button, h, moveSlider, slider, uniqueId } from './dom.js';
import { listen } from './model.js';
import { isDark, onThemeChange } from './theme.js';

/** @param model frames: [svg], order: [the frame at each tick], scenes: [{ end, caption, alt }], rate: ticks per second, at */
export function renderFilm({ model, el }) {
  const scenes = model.get('scenes');
  const rate = model.get('rate');
  const frames = model.get('frames');
  const order = model.get('order');
  const last = order.length - 1;
  const id = uniqueId('film');
  const calm = matchMedia('(prefers-reduced-motion: reduce)');
  const at = () => model.get('at');
  const sceneOf = (index) => scenes.find(({ end }) => index <= end) ?? scenes.at(-1);
  let playing = 0;

  // Each frame has an image of its own, because an image whose source changes is blank for a moment.
  const images = frames.map(() => h('img', { hidden: true, alt: '' }));
  const load = (index) => {
    const k = order[index];
    if (images[k] && !images[k].src) images[k].src = `data:image/svg+xml,${encodeURIComponent(frames[k])}`;
  };
  const caption = h('p', { class: 'kv-film-caption', 'aria-live': 'polite' });
  const time = h('output', { for: id });
  const play = button('▶ Play', () => (playing ? stop() : start()), { class: 'kv-play' });
  const leaf = (index) => {
    stop();
    set(index);
  };
  const bar = slider(last, leaf, { id, 'aria-label': 'Time' });
  const picture = h('div', { class: 'kv-film-picture', role: 'img' }, ...images);
  const root = h(
    'div',
    { class: 'kv kv-film', role: 'group', 'aria-label': 'A short film' },
    picture,
    caption,
    h('div', { class: 'kv-film-bar' }, play, bar, time),
  );
  root.viewer = { model };

  function set(index) {
    model.set('at', index);
    update();
  }
  function update() {
    const index = at();
    const scene = sceneOf(index);
    for (const next of [index, index + 1, index + 2]) load(next);
    images.forEach((image, k) => {
      image.hidden = k !== order[index];
    });
    picture.setAttribute('aria-label', scene.alt);
    if (caption.textContent !== scene.caption) caption.textContent = scene.caption;
    time.textContent = `${(index / rate).toFixed(0)} of ${(last / rate).toFixed(0)} s`;
    moveSlider(bar, index, time.textContent);
  }
  function start() {
    if (at() >= last) set(0);
    play.textContent = '❚❚ Pause';
    for (const index of order.keys()) load(index);
    if (calm.matches) step();
    else playing = setInterval(() => (at() >= last || !root.isConnected ? stop() : set(at() + 1)), 1000 / rate);
  }
  /** For readers who prefer reduced motion: from the end of one scene to the end of the next, without what is between. */
  function step() {
    const next = scenes.findIndex(({ end }) => end > at());
    if (next < 0 || !root.isConnected) return stop();
    const before = next ? scenes[next - 1].end : 0;
    set(scenes[next].end);
    playing = setTimeout(step, Math.max(2000, (1000 * (scenes[next].end - before)) / rate));
  }
  function stop() {
    clearInterval(playing);
    clearTimeout(playing);
    playing = 0;
    play.textContent = '▶ Play';
    model.save_changes();
  }
  function applyTheme() {
    root.dataset.theme = isDark(root) ? 'dark' : 'light';
    picture.style.colorScheme = root.dataset.theme;
  }

  el.append(root);
  stop();
  applyTheme();
  update();
  const stops = [listen(model, { at: update }), onThemeChange(applyTheme)];
  // JupyterLab attaches the element only now; and what nobody sees need not move.
  const observer = new IntersectionObserver((entries) => {
    applyTheme();
    if (playing && !entries.at(-1).isIntersecting) stop();
  });
  observer.observe(root);
  return () => {
    stop();
    for (const end of stops) end();
    observer.disconnect();
  };
}
