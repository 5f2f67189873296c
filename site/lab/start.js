// Runs before JupyterLab: shows the page of the notebook as a preview, loads the files of Python at once and says how
// many megabytes there are, and starts the service worker that stores them. JupyterLab draws itself after some seconds,
// and its kernel requests the same files only then.
(() => {
  'use strict';
  const LAB = new URL('..', location.href);
  const MB = 1e6;
  const STALLED_S = 20; // without a byte, until a message says so
  const CONTROL_MS = 3000; // how long to wait for the service worker, without which files are not stored
  const RETRY_MS = 5000;
  const POLL_MS = 200;
  const KERNEL_MS = 15000; // how long the preview waits for a kernel

  const path = new URLSearchParams(location.search).get('path') ?? '';
  const [, folder, name] = path.match(/^(notebooks|exercises)\/(?:.*\/)?(\w+)\.ipynb$/) ?? [];
  const page = name && new URL(`../${folder === 'notebooks' ? 'lectures' : 'sheets'}/${name}.html`, LAB).href;
  const json = async (address) => (await fetch(new URL(address, LAB))).json();
  const sleep = (milliseconds) => new Promise((resolve) => setTimeout(resolve, milliseconds));
  performance.setResourceTimingBufferSize(2000); // what JupyterLab has loaded, to store it

  // --- the preview ---

  const preview = document.querySelector('.kinlib-preview');
  if (page) showPreview().catch(() => {}); // offline there is none

  async function showPreview() {
    const link = preview.querySelector('a');
    link.href = page;
    link.textContent = folder === 'notebooks' ? 'Back to the lecture' : 'Back to the page of the sheet';
    const built = new DOMParser().parseFromString(await (await fetch(page)).text(), 'text/html');
    keepTitle(built.title);
    const article = built.querySelector('article[role=main]');
    for (const part of article.querySelectorAll('.kinlib-bar, .kinlib-ran, .headerlink')) part.remove();
    const styles = [...built.querySelectorAll('link[rel=stylesheet]')].map((style) => style.outerHTML).join('');
    const frame = document.createElement('iframe');
    frame.title = 'Preview of the notebook';
    frame.sandbox = 'allow-same-origin'; // it runs no script
    frame.srcdoc =
      `<!doctype html><html lang="en"><base href="${page}">${styles}<body data-theme="auto" ` +
      `style="max-width:50rem;margin:0 auto;padding:0 1rem">${article.outerHTML}</body></html>`;
    preview.lastElementChild.replaceWith(frame);
  }

  /** Call the tab as the page is called: JupyterLite gives all notebooks the name of the course. */
  function keepTitle(title) {
    const keep = () => {
      if (document.title !== title) document.title = title;
    };
    keep();
    new MutationObserver(keep).observe(document.querySelector('title'), { childList: true });
  }

  const hasKernel = new Promise((resolve) => {
    document.addEventListener('kinlib-python', ({ detail }) => detail === 'chosen' && resolve());
  });

  async function hidePreview() {
    while (!document.querySelector('.jp-Notebook .jp-Cell, .jp-Dialog, .jp-FileBrowser')) await sleep(POLL_MS);
    // if a cell is run before the notebook has a kernel, JupyterLab asks which one, and the cell waits
    if (document.querySelector('.jp-Notebook')) await Promise.race([hasKernel, sleep(KERNEL_MS)]);
    preview.remove();
  }

  // --- the progress of Python ---

  const card = document.querySelector('.kinlib-python');
  const [phase, amount, bar] = card.children;
  let bytes = [0, 1]; // received, and in all
  let ready = false;
  let stalled;

  function showPhase(text) {
    if (phase.textContent !== text) phase.textContent = text; // otherwise it would be announced again
    card.hidden = !text;
  }

  function showBytes(received, total) {
    clearTimeout(stalled);
    bytes = [received, total];
    if (ready) return; // what is still loaded then is for later
    if (received >= total) {
      bar.removeAttribute('value');
      amount.textContent = '';
      showPhase('Python is starting. You can read and type meanwhile.');
      return;
    }
    bar.value = received / total;
    amount.textContent = ` ${Math.floor(received / MB)} of ${Math.ceil(total / MB)} MB`;
    showPhase('Python is loading. You can read and type meanwhile.');
    stalled = setTimeout(
      () => showPhase(`No data has arrived for ${STALLED_S} seconds. Check the connection; loading goes on by itself.`),
      STALLED_S * 1000,
    );
  }

  // the extension of the course reports what the kernel does, because it can ask JupyterLab
  document.addEventListener('kinlib-python', ({ detail }) => {
    ready = detail === 'ready';
    showBytes(...bytes);
    if (ready) showPhase('');
  });

  async function loadPython() {
    const sizes = await json('static/pyodide/sizes.json');
    const total = Object.values(sizes).reduce((sum, size) => sum + size, 0);
    let received = 0;
    showBytes(0, total);
    // Python itself first, as it is requested first
    const isCore = (file) => !/\.(whl|zip|json)$/.test(file) || file === 'python_stdlib.zip';
    const names = Object.keys(sizes).sort((one, other) => isCore(other) - isCore(one));
    for (const file of names) {
      const address = new URL(`static/pyodide/${file}`, LAB).href;
      const before = received;
      for (let loaded = await caches.match(address); !loaded; ) {
        received = before;
        try {
          const response = await fetch(address, { priority: 'low' });
          for await (const chunk of chunks(response.body)) {
            received += chunk.byteLength;
            showBytes(received, total);
          }
          loaded = true;
        } catch {
          await sleep(RETRY_MS);
        }
      }
      received = before + sizes[file];
    }
    showBytes(1, 1);
  }

  async function* chunks(body) {
    const reader = body.getReader(); // Safari cannot iterate over a stream
    for (let { value, done } = await reader.read(); !done; { value, done } = await reader.read()) yield value;
  }

  // --- what a later visit needs without a network ---

  async function startServiceWorker() {
    const { serviceWorker } = navigator;
    if (serviceWorker) serviceWorker.getRegistrations = async () => []; // JupyterLite would end those of the pages, too
    // the same address as JupyterLite's, which finds it registered already
    await serviceWorker?.register(new URL('service-worker.js?enableCache=false', LAB));
    if (!serviceWorker || serviceWorker.controller) return;
    await new Promise((resolve) => serviceWorker.addEventListener('controllerchange', resolve, { once: true }));
  }

  /** Request again what was loaded before the service worker was there, and the notebooks that were not opened. */
  async function storeRest() {
    if (!navigator.serviceWorker?.controller) return;
    const loaded = performance.getEntriesByType('resource').map((entry) => entry.name);
    const own = [location.href, ...loaded].filter((address) => address.startsWith(LAB.href));
    for (const address of new Set(own.filter((one) => !one.includes('/api/')))) await fetch(address);
    await storeFolder('');
    card.dataset.stored = ''; // for tests
  }

  async function storeFolder(folder) {
    const { content } = await json(`api/contents/${folder}all.json`);
    for (const entry of content) {
      if (entry.type === 'directory') await storeFolder(`${entry.path}/`);
      else await fetch(new URL(`files/${entry.path}`, LAB));
    }
  }

  const hidden = hidePreview();
  (async () => {
    await Promise.race([startServiceWorker().catch(() => {}), sleep(CONTROL_MS)]);
    await loadPython();
    await hidden;
    await storeRest();
  })().catch(() => {}); // what is not loaded or stored now, JupyterLab requests by itself
})();
