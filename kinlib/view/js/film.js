// A film: drawings that follow each other, with a button to play and stop them, a slider, and the caption of each scene.
import { playButton } from './controls/play-button.js';
import { h, moveSlider, slider, uniqueId } from './dom.js';
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

  // Each frame has an image of its own, because an image whose source changes is blank for a moment.
  const images = frames.map(() => h('img', { hidden: true, alt: '' }));
  const load = (index) => {
    const k = order[index];
    if (images[k] && !images[k].src) images[k].src = `data:image/svg+xml,${encodeURIComponent(frames[k])}`;
  };
  const caption = h('p', { class: 'kv-film-caption', 'aria-live': 'polite' });
  const time = h('output', { for: id });
  let from = 0;
  const motion = playButton(
    () => {
      from = at() < last ? at() : 0;
      for (const index of order.keys()) load(index);
    },
    (elapsed) => {
      const now = Math.min(last, from + Math.floor((elapsed * rate) / 1000));
      // readers who prefer reduced motion see the end of each scene for as long as it takes
      const index = calm.matches ? sceneOf(now).end : now;
      if (index !== at()) set(index);
      return now < last;
    },
    () => model.save_changes(),
  );
  const leaf = (index) => {
    motion.stop();
    set(index);
    model.save_changes();
  };
  const bar = slider(last, leaf, { id, 'aria-label': 'Time' });
  const picture = h('div', { class: 'kv-film-picture', role: 'img' }, ...images);
  const root = h(
    'div',
    { class: 'kv kv-film', role: 'group', 'aria-label': 'A short film' },
    picture,
    caption,
    h('div', { class: 'kv-film-bar' }, motion.button, bar, time),
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
  function applyTheme() {
    root.dataset.theme = isDark(root) ? 'dark' : 'light';
    picture.style.colorScheme = root.dataset.theme;
  }

  el.append(root);
  applyTheme();
  update();
  const stops = [listen(model, { at: update }), onThemeChange(applyTheme)];
  // JupyterLab attaches the element only now; and what nobody sees need not move.
  const observer = new IntersectionObserver((entries) => {
    applyTheme();
    if (!entries.at(-1).isIntersecting) motion.stop();
  });
  observer.observe(root);
  return () => {
    motion.stop();
    for (const end of stops) end();
    observer.disconnect();
  };
}
