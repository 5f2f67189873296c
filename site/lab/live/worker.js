// The Python of a page: starts when the reader asks for it, runs one cell after the other, and between them gives widgets
// what the page has changed. live.js starts this worker, and ends it to stop a cell. It is in the folder of the lab, so that the lab's service worker stores what it loads.
const PYTHON = new URL('../static/pyodide/', self.location.href).href;

const messages = []; // { source, cell } runs a cell, { comm, data } is for a widget
let wake = () => {};
// listen before anything is awaited: the messages that arrive while Python starts must not be lost
self.onmessage = ({ data }) => {
  messages.push(data);
  wake();
};

const originalFetch = self.fetch;
const beside = (name) => originalFetch(new URL(name, self.location.href));

/**
 * Count the bytes of every response, also of those that Python itself requests, and report them with the total.
 * The WebAssembly of Python is loaded compressed, because not every server compresses it.
 */
function countBytes({ modules, total }) {
  let received = modules; // these are not fetched
  self.fetch = async (address, settings) => {
    const isPacked = String(address).endsWith('.wasm') && 'DecompressionStream' in self;
    const response = await originalFetch(isPacked ? `${address}.packed` : address, settings);
    if (!response.body || !response.ok) return response;
    const counter = new TransformStream({
      transform(chunk, controller) {
        received += chunk.byteLength;
        postMessage({ kind: 'bytes', received, total });
        controller.enqueue(chunk);
      },
    });
    const counted = response.body.pipeThrough(counter);
    if (!isPacked) return new Response(counted, { headers: response.headers });
    const unpacked = counted.pipeThrough(new DecompressionStream('gzip'));
    return new Response(unpacked, { headers: { 'Content-Type': 'application/wasm' } });
  };
}

/** Read a file of Python at once, because nothing can be awaited within an import; a worker may wait for it. */
function readNow(name) {
  const request = new XMLHttpRequest();
  request.open('GET', PYTHON + name, false);
  request.responseType = 'arraybuffer';
  request.send();
  if (request.status !== 200) throw new Error(`${name} could not be loaded`);
  return new Uint8Array(request.response);
}

async function start() {
  const files = await (await beside('load.json')).json();
  countBytes(files);
  const shell = beside('shell.py').then((response) => response.text());
  const { loadPyodide } = await import(`${PYTHON}pyodide.mjs`);
  const lockFileURL = `${PYTHON}live-lock.json`;
  const python = await loadPyodide({ indexURL: PYTHON, lockFileURL, packages: files.packages });
  python.globals.set('post', (text) => postMessage(JSON.parse(text)));
  python.globals.set('LATER', python.toPy(files.later));
  python.globals.set('read_now', readNow);
  python.runPython(await shell);
  const [run, hear] = ['run', 'hear'].map((name) => python.globals.get(name));
  postMessage({ kind: 'ready' });
  for (;;) {
    while (!messages.length) {
      await new Promise((resolve) => {
        wake = resolve;
      });
    }
    const message = messages.shift();
    if (message.comm) {
      hear(JSON.stringify(message));
      continue;
    }
    const { source, cell } = message;
    postMessage({ kind: 'begin' });
    try {
      await python.loadPackagesFromImports(source, { messageCallback() {} });
    } catch {
      /* the code is not Python, which running it reports */
    }
    await run(source, cell);
  }
}

start().catch((error) => postMessage({ kind: 'failed', text: String(error) }));
