// For pages without a kernel: fetch the viewer once, and only where the page holds one.
// A classic script and not a module, because browsers load no modules from file://.
(() => {
  const bundle = new URL('viewer.js', document.currentScript.src);
  const begin = () => {
    if (!document.querySelector('[data-kinlib-viewer], [data-kinlib-film]')) return;
    const script = document.createElement('script');
    script.src = bundle;
    script.onload = () => kinlib.startViewers();
    document.head.append(script);
  };
  // The text first: where 3-D pictures are computed without a graphics card, nothing else is painted meanwhile.
  const beginAfterPaint = () => {
    if (!globalThis.PerformanceObserver?.supportedEntryTypes?.includes('paint')) return begin();
    new PerformanceObserver((_, observer) => {
      observer.disconnect();
      begin();
    }).observe({ type: 'paint', buffered: true });
  };
  if (document.readyState === 'loading') document.addEventListener('DOMContentLoaded', beginAfterPaint);
  else beginAfterPaint();
})();
