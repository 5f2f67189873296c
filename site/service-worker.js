// A page that was read opens again without a network, and so does the Python that was loaded on it. What the network has comes
// first, so nothing old is shown. The lab has a service worker of its own.
(() => {
  const CACHE = 'kinlib-pages';

  self.addEventListener('install', () => self.skipWaiting());
  self.addEventListener('activate', (event) => event.waitUntil(self.clients.claim()));
  self.addEventListener('fetch', (event) => {
    const { method, url } = event.request;
    if (method === 'GET' && new URL(url).origin === self.location.origin) event.respondWith(answer(event));
  });

  async function answer(event) {
    const cache = await caches.open(CACHE);
    const { origin, pathname } = new URL(event.request.url); // a version behind "?" would be one more copy
    try {
      const response = await fetch(event.request);
      if (response.status === 200) event.waitUntil(cache.put(origin + pathname, response.clone()).catch(() => {}));
      return response;
    } catch (error) {
      const stored = await cache.match(origin + pathname);
      if (stored) return stored;
      throw error;
    }
  }
})();
