// One WebGL renderer for all viewers of this module. Each viewer shows a flat canvas, and gets its picture copied there:
// a page with many viewers needs one context, and a picture once drawn stays when its context is gone.
// In JupyterLab every widget brings its own copy of this module, so a list on the page keeps the copies few.
import { WebGLRenderer } from 'three';

const MAX_CONTEXTS = 6; // browsers drop the oldest context beyond 16, with its picture
const RENDERERS = Symbol.for('kinlib.renderers');
let renderer = null;
let refused = false;

function liveRenderers() {
  globalThis[RENDERERS] ??= [];
  return globalThis[RENDERERS];
}

function release() {
  renderer?.dispose();
  renderer?.forceContextLoss();
  forget();
}

function forget() {
  renderer = null;
  globalThis[RENDERERS] = liveRenderers().filter((other) => other !== release);
}

function acquireRenderer() {
  if (!renderer) {
    while (liveRenderers().length >= MAX_CONTEXTS) liveRenderers()[0]();
    renderer = new WebGLRenderer({ antialias: true, alpha: true, stencil: true });
    renderer.domElement.addEventListener('webglcontextlost', forget, { once: true });
  }
  globalThis[RENDERERS] = [...liveRenderers().filter((other) => other !== release), release]; // the last used is the last to go
  return renderer;
}

/** Whether this browser draws in three dimensions. Asked late and once: asking starts the machinery, and takes its time. */
export function hasWebGL() {
  if (renderer) return true;
  if (refused) return false;
  const probe = document.createElement('canvas').getContext('webgl2');
  refused = !probe;
  probe?.getExtension('WEBGL_lose_context')?.loseContext();
  return !refused;
}

/** Paint a scene onto a flat canvas, over what is there. Returns the number of draw calls. */
export function renderScene(scene, camera, context, { width, height, ratio }) {
  const gl = acquireRenderer();
  const size = gl.domElement;
  if (size.width !== Math.floor(width * ratio) || size.height !== Math.floor(height * ratio)) {
    gl.setPixelRatio(ratio);
    gl.setSize(width, height, false);
  }
  gl.render(scene, camera);
  context.drawImage(gl.domElement, 0, 0, width, height);
  return gl.info.render.calls;
}
