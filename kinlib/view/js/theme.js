// The theme is light or dark like the page behind the viewer. JupyterLab, VS Code, Sphinx and plain pages each declare
// their theme in another way, but all of them paint a background, so its luminance decides.
import COLOURS from '../colours.json';

/** The colours that drawings have, too: 0 on white paper, 1 on a dark page. */
const drawn = (page) => Object.fromEntries(Object.entries(COLOURS).map(([name, pair]) => [name, pair[page]]));

const LIGHT = {
  ...drawn(0),
  paper: '#f6f8fa',
  halo: '#f6f8fa',
  grid: '#aab4be',
  quiet: '#59636e',
  link: '#7f9bb5',
  joint: '#f0cf94',
  cap: '#c9a15c',
  rod: '#b9c4cd',
  ghost: '#a9b2bb',
  outline: '#2f3b47',
  shade: 0.1,
  home: '#8c959f',
  trail: '#0b7285',
};

const DARK = {
  ...drawn(1),
  dark: true,
  paper: '#171b21',
  halo: '#171b21',
  grid: '#4a5562',
  quiet: '#9aa5b1',
  link: '#7d9cbb',
  joint: '#e3b968',
  cap: '#a97f38',
  rod: '#a5b1bc',
  ghost: '#6b7681',
  outline: '#05070a',
  shade: 0.4,
  home: '#8c959f',
  trail: '#3bc9db',
};

export function themeOf(element) {
  return isDark(element) ? DARK : LIGHT;
}

export function isDark(element) {
  for (let node = element.parentElement; node; node = node.parentElement) {
    const [r, g, b, alpha = 1] =
      getComputedStyle(node)
        .backgroundColor.match(/[\d.]+/g)
        ?.map(Number) ?? [];
    if (alpha > 0.5 && b !== undefined) return 0.2126 * r + 0.7152 * g + 0.0722 * b < 110;
  }
  return false; // a page without a background is white
}

/** Call back when the page changes its colours. Returns a function that stops it. */
export function onThemeChange(callback) {
  const watch = new MutationObserver(() => requestAnimationFrame(callback));
  const attributes = {
    attributes: true,
    attributeFilter: ['class', 'style', 'data-theme', 'data-mode', 'data-jp-theme-name'],
  };
  watch.observe(document.documentElement, attributes);
  watch.observe(document.body, attributes);
  const preference = matchMedia('(prefers-color-scheme: dark)');
  preference.addEventListener('change', callback);
  return () => {
    watch.disconnect();
    preference.removeEventListener('change', callback);
  };
}
