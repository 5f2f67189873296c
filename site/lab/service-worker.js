// Stores every file of the lab that this browser has loaded: a second visit starts from here, and works offline.
// The build writes VERSION above, and JupyterLite's own service worker below, which answers Python's requests.
(() => {
  const CACHE = `kinlib-lab-${VERSION}`;
  const FOLDER = new URL('.', self.location.href).pathname;
  const NOT_FILES = /\/api\/(drive|stdin|service-worker)/; // JupyterLite answers these
  const pending = new Map(); // the page and Python may request the same file at the same time: it is loaded once

  // A new version of the site starts when no window of the old one is left, so that no window gets files of both.
  self.skipWaiting = async () => {};

  self.addEventListener('activate', (event) => {
    const deleteOld = async () => {
      const names = (await caches.keys()).filter((name) => name.startsWith('kinlib-lab-') && name !== CACHE);
      await Promise.all(names.map((name) => caches.delete(name)));
    };
    event.waitUntil(deleteOld());
  });

  self.addEventListener('fetch', (event) => {
    const { method, url } = event.request;
    const { origin, pathname } = new URL(url);
    if (method !== 'GET' || origin !== self.location.origin || !pathname.startsWith(FOLDER)) return;
    if (NOT_FILES.test(pathname)) return;
    event.stopImmediatePropagation();
    event.respondWith(answer(event, origin + pathname));
  });

  async function answer(event, address) {
    const cache = await caches.open(CACHE);
    const stored = await cache.match(address);
    if (stored) return stored;
    if (await cache.match(`${address}/`)) return redirected(event, `${address}/`);
    if (!pending.has(address)) {
      const loading = fetch(address, { cache: 'no-cache' });
      pending.set(address, loading);
      const store = async () => {
        try {
          const response = await loading;
          if (response.ok && !response.redirected) await cache.put(address, response.clone());
        } catch {
          /* the page that requested the file reports the error */
        } finally {
          pending.delete(address);
        }
      };
      event.waitUntil(store());
    }
    const response = await pending.get(address);
    if (response.redirected && event.request.mode === 'navigate') return redirected(event, response.url);
    return response.clone();
  }

  // A browser does not accept a redirect that was already followed as the answer when it opens a page: it follows it itself.
  function redirected(event, address) {
    return Response.redirect(address + new URL(event.request.url).search);
  }
})();
