// The Python of a page: starts when the reader asks for it, runs one cell after the other, and between them gives widgets
// what the page has changed. live.js starts this worker, and ends it to stop a cell. It is in the folder of the lab, so that the lab's service worker stores what it loads.
const PYTHON = new URL('../static/pyodide/', self.location.href).href;

const messages = []; // { source, cell, files, unset } runs a cell that reads files, { comm, data } is for a widget
let wake = () => {};
// listen before anything is awaited: the messages that arrive while Python starts must not be lost
self.onmessage = ({ data }) => {
  messages.push(data);
  wake();
};

const PACKED = ['pyodide.asm.wasm', 'python_stdlib.zip'].map((name) => PYTHON + name); // loaded compressed as a whole

const originalFetch = self.fetch;
const beside = (name) => originalFetch(new URL(name, self.location.href));
const unpacked = (stream) => new Response(stream.pipeThrough(new DecompressionStream('gzip')));

/** Count the bytes of every response, also of those that Python itself requests, and report them with the total. */
function countBytes({ modules, total }) {
  let received = modules; // these are not fetched
  self.fetch = async (request, settings) => {
    const address = String(request);
    const isPacked = PACKED.includes(address);
    const response = await originalFetch(isPacked ? `${address}.packed` : request, settings);
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
    const type = address.endsWith('.wasm') ? 'application/wasm' : 'application/zip';
    return new Response(unpacked(counted).body, { headers: { 'Content-Type': type } });
  };
}

/** The bytes of the packages: a line with the size of each file, and their contents one after the other. */
async function loadPackages() {
  const response = await self.fetch(new URL('packages.packed', self.location.href));
  if (!response.ok) throw new Error('packages.packed could not be loaded');
  return new Uint8Array(await unpacked(response.body).arrayBuffer());
}

/** Write the files of the packages where Python looks for them. */
function writePackages(python, bytes) {
  const folder = python.runPython('import site; site.getsitepackages()[0]');
  let at = bytes.indexOf(10) + 1; // the end of the line
  const sizes = JSON.parse(new TextDecoder().decode(bytes.subarray(0, at)));
  const folders = new Set(Object.keys(sizes).map((name) => name.replace(/[^/]*$/, '')));
  for (const name of folders) python.FS.mkdirTree(`${folder}/${name}`);
  for (const [name, size] of Object.entries(sizes)) {
    const content = bytes.subarray(at, at + size);
    python.FS.writeFile(`${folder}/${name}`, content, { canOwn: true }); // without a copy
    at += size;
  }
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
  if (!self.DecompressionStream) throw new Error('this browser cannot unpack files; update it, or use another one');
  const files = await (await beside('load.json')).json();
  countBytes(files);
  const shell = beside('shell.py').then((response) => response.text());
  const packages = loadPackages();
  const { loadPyodide } = await import(`${PYTHON}pyodide.mjs`);
  const lockFileURL = new URL('live-lock.json', self.location.href).href;
  const python = await loadPyodide({ indexURL: PYTHON, lockFileURL });
  writePackages(python, await packages);
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
    const { source, cell, files, unset } = message;
    for (const { path, bytes } of files) {
      const whole = `${python.FS.cwd()}/${path}`;
      python.FS.mkdirTree(whole.replace(/[^/]*$/, ''));
      python.FS.writeFile(whole, bytes);
    }
    postMessage({ kind: 'begin' });
    try {
      await python.loadPackagesFromImports(source, { messageCallback() {} });
    } catch {
      /* the code is not Python, which running it reports */
    }
    await run(source, cell, unset ?? '');
  }
}

start().catch((error) => postMessage({ kind: 'failed', text: String(error) }));
