// The Python of a lecture's page: starts with the first cell that is run, and runs one cell after the other. live.js starts this worker, and
// ends it to stop a cell. It is in the folder of the lab, so that the lab's service worker stores what it loads.
const PYTHON = new URL('../static/pyodide/', self.location.href).href;

const cells = [];
let wake = () => {};
// listen before anything is awaited: the messages that arrive while Python starts must not be lost
self.onmessage = ({ data }) => {
  cells.push(data);
  wake();
};

const originalFetch = self.fetch;
const beside = (name) => originalFetch(new URL(name, self.location.href));

/** Count the bytes of every response, also of those that Python itself requests, and report them with the total. */
function countBytes({ modules, total }) {
  let received = modules; // these are not fetched
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
  const files = await (await beside('load.json')).json();
  countBytes(files);
  const shell = beside('shell.py').then((response) => response.text());
  const { loadPyodide } = await import(`${PYTHON}pyodide.mjs`);
  const python = await loadPyodide({ indexURL: PYTHON, packages: files.packages });
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
