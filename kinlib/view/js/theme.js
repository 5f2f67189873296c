// The theme is light or dark like the page behind the viewer. JupyterLab, VS Code, Sphinx and plain pages each declare
// their theme in another way, but all of them paint a background, so its luminance decides.
import COLOURS from '../colours.json';

/** The colours of kinlib/view/colours.json on the page behind an element, and how dark shadows are. */
export function themeOf(element) {
  const dark = isDark(element);
  const colours = Object.entries(COLOURS).map(([name, pair]) => [name, pair[Number(dark)]]);
  return { ...Object.fromEntries(colours), isDark: dark, shade: dark ? 0.4 : 0.1 };
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
