// Runs precompile.py in Pyodide: node precompile.mjs PYODIDE TARGET WARM_UP { "packages": [...], "archives": { name: keeps its sources } }
// The modules that the file WARM_UP loads from the archives of the folder PYODIDE are compiled into archives in the folder TARGET.
import { readFileSync } from 'node:fs';
import { pathToFileURL } from 'node:url';

const [source, target, warmUp, settings] = process.argv.slice(2);
const { packages, archives } = JSON.parse(settings);
const { loadPyodide } = await import(pathToFileURL(`${source}/pyodide.mjs`));
const python = await loadPyodide({ indexURL: `${source}/`, packages, stdout: () => {} });
python.globals.set('post', () => {});
python.runPython(readFileSync(warmUp, 'utf8'));
python.mountNodeFS('/source', source);
python.mountNodeFS('/target', target);
python.runPython(readFileSync(new URL('precompile.py', import.meta.url), 'utf8'));
const compile = python.globals.get('compile_loaded');
for (const [name, keepsSources] of Object.entries(archives)) compile(`/source/${name}`, `/target/${name}`, keepsSources);
