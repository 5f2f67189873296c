// For pages without a kernel: fetch the viewer once, and only where the page holds one.
// A classic script and not a module, because browsers load no modules from file://.
(() => {
  const bundle = new URL('viewer.js', document.currentScript.src);
  const begin = () => {
    if (!document.querySelector('[data-kinlib-viewer]')) return;
    const script = document.createElement('script');
    script.src = bundle;
    script.onload = () => kinlib.startViewers();
    document.head.append(script);
  };
  if (document.readyState === 'loading') document.addEventListener('DOMContentLoaded', begin);
  else begin();
})();
