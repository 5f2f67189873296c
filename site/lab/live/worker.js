// The Python of a lecture's page: starts at once, then runs one cell after the other. live.js starts this worker, and
// ends it to stop a cell. It is in the folder of the lab, so that the lab's service worker stores what it loads.
const PYTHON = new URL('../static/pyodide/', self.location.href).href;

const cells = [];
let wake = () => {};
// listen before anything is awaited: the messages that arrive while Python starts must not be lost
self.onmessage = ({ data }) => {
  cells.push(data);
  wake();
};

const PACKAGES = ['ipython', 'kincourse'];
const originalFetch = self.fetch;
const json = async (name) => (await originalFetch(PYTHON + name)).json();

/** Count the bytes of every response, also of those that Python itself requests, and report them with the total. */
async function countBytes() {
  const [lock, sizes] = await Promise.all([json('pyodide-lock.json'), json('sizes.json')]);
  const canonical = (name) => name.toLowerCase().replace(/[-_.]+/g, '-');
  const entries = new Map(Object.entries(lock.packages).map(([name, entry]) => [canonical(name), entry]));
  const files = new Set([...entries.values()].map((entry) => entry.file_name));
  const needed = new Set(Object.keys(sizes).filter((name) => !files.has(name))); // Python itself
  const add = (name) => {
    const { file_name, depends } = entries.get(canonical(name));
    if (!needed.has(file_name)) {
      needed.add(file_name);
      depends.forEach(add);
    }
  };
  PACKAGES.forEach(add);
  // modules are not fetched
  let received = sizes['pyodide.mjs'] + (sizes['pyodide.asm.mjs'] ?? sizes['pyodide.asm.js']);
  const total = [...needed].reduce((sum, name) => sum + sizes[name], 0);
  self.fetch = async (...request) => {
    const response = await originalFetch(...request);
    if (!response.body) return response;
    const counter = new TransformStream({
      transform(chunk, controller) {
        received += chunk.byteLength;
        postMessage({ kind: 'bytes', received, total });
        controller.enqueue(chunk);
      },
    });
    const { status, statusText, headers } = response;
    return new Response(response.body.pipeThrough(counter), { status, statusText, headers });
  };
}

async function start() {
  await countBytes();
  const shell = originalFetch(new URL('shell.py', self.location.href)).then((response) => response.text());
  const { loadPyodide } = await import(`${PYTHON}pyodide.mjs`);
  const python = await loadPyodide({ indexURL: PYTHON, packages: PACKAGES });
  python.globals.set('post', (text) => postMessage(JSON.parse(text)));
  python.runPython(await shell);
  const run = python.globals.get('run');
  postMessage({ kind: 'ready' });
  for (;;) {
    while (!cells.length) {
      await new Promise((resolve) => {
        wake = resolve;
      });
    }
    const { source } = cells.shift();
    postMessage({ kind: 'begin' });
    try {
      await python.loadPackagesFromImports(source);
    } catch {
      /* the code is not Python, which running it reports */
    }
    await run(source);
  }
}

start().catch((error) => postMessage({ kind: 'failed', text: String(error) }));
