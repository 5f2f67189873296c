// A player of pictures: a film, or the pictures of several values. See kinlib/view/viewer/pictures.py for its data.
import { predictionCover } from './controls/prediction-cover.js';
import { stepControls } from './controls/step-controls.js';
import { h } from './dom.js';
import { listen } from './model.js';
import { isDark, onThemeChange } from './theme.js';

export function renderPictures({ model, el }) {
  const { label, rate, ends } = model.get('looks');
  const order = model.get('order');
  const at = () => model.get('at');
  const text = () => model.get('texts')[at()];
  const last = order.length - 1;
  // Each drawing has an image of its own, because an image whose source changes is blank for a moment.
  const images = model.get('frames').map(() => h('img', { hidden: true, alt: '' }));
  const load = (index) => {
    const k = order[index];
    if (images[k] && !images[k].src) images[k].src = `data:image/svg+xml,${encodeURIComponent(model.get('frames')[k])}`;
  };
  const controls = stepControls({
    model,
    last: () => last,
    textOf: () => text().label,
    name: rate ? 'scene' : 'value',
    label,
    pace: rate && 1000 / rate,
    ends,
    prepare: () => {
      for (const index of order.keys()) load(index);
    },
  });
  const caption = h('p', { class: 'kv-film-caption', 'aria-live': 'polite' });
  const value = h('output', { for: controls.id });
  const picture = h('div', { class: 'kv-film-picture', role: 'img' }, ...images);
  const named = rate ? [] : [h('label', { for: controls.id }, label)];
  const bar = h('div', { class: 'kv-film-bar' }, ...controls.buttons, ...named, controls.bar, value);
  const cover = predictionCover(model);
  const inside = h('div', {}, picture, caption, bar);
  const settings = { class: 'kv kv-film', role: 'group', 'aria-label': rate ? 'A short film' : `Pictures, ${label}` };
  const root = h('div', { ...settings, onkeydown: controls.onkeydown }, cover.element, inside);
  root.viewer = { model };

  function update() {
    const index = at();
    cover.update();
    inside.hidden = model.get('covered');
    for (const next of [index, index + 1, index + 2]) load(next);
    images.forEach((image, k) => {
      image.hidden = k !== order[index];
    });
    const { alt = '', caption: said = '', label: now } = text();
    picture.setAttribute('aria-label', alt);
    if (caption.textContent !== said) caption.textContent = said;
    caption.hidden = !said;
    value.textContent = now;
    controls.update();
  }
  function applyTheme() {
    root.dataset.theme = isDark(root) ? 'dark' : 'light';
    picture.style.colorScheme = root.dataset.theme;
  }

  el.append(root);
  applyTheme();
  update();
  const stops = [listen(model, { at: update, covered: update }), onThemeChange(applyTheme)];
  // JupyterLab attaches the element only now; and what nobody sees need not move.
  const observer = new IntersectionObserver((entries) => {
    applyTheme();
    if (!entries.at(-1).isIntersecting) controls.stop();
  });
  observer.observe(root);
  return () => {
    controls.stop();
    for (const end of stops) end();
    observer.disconnect();
  };
}
