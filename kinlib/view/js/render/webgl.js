// One WebGL renderer for all viewers of this module. Each viewer has a 2-D canvas, to which its picture is copied, so
// that a page with many viewers needs one context, and a picture remains when its context is lost.
// In JupyterLab every widget loads its own copy of this module, so a list on the page limits the number of contexts.
import { WebGLRenderer } from 'three';

const MAX_CONTEXTS = 2;
const POLL_MS = 10;
const RENDERERS = Symbol.for('kinlib.renderers');
let renderer = null;
let refused = false;
let smooth = true; // without a graphics card, smooth edges take half of the time

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
    renderer = new WebGLRenderer({ antialias: smooth, alpha: true, stencil: true });
    renderer.domElement.addEventListener('webglcontextlost', forget, { once: true });
  }
  // the most recently used renderer is released last
  globalThis[RENDERERS] = [...liveRenderers().filter((other) => other !== release), release];
  return renderer;
}

/** Whether WebGL is available. Tested late and only once, because the test starts WebGL and takes a while. */
export function hasWebGL() {
  if (renderer) return true;
  if (refused) return false;
  const probe = document.createElement('canvas').getContext('webgl2');
  refused = !probe;
  const named = probe?.getExtension('WEBGL_debug_renderer_info');
  const name = named && probe.getParameter(named.UNMASKED_RENDERER_WEBGL);
  smooth = !/swiftshader|llvmpipe|software|basic render/i.test(name);
  probe?.getExtension('WEBGL_lose_context')?.loseContext();
  return !refused;
}

/** Let WebGL compile what a scene needs. Without this, the page would stand still until its first picture is ready. */
export async function prepareScene(scene, camera, size) {
  const gl = acquireRenderer();
  setSize(gl, size);
  gl.render(scene, camera);
  const context = gl.getContext();
  const done = context.fenceSync(context.SYNC_GPU_COMMANDS_COMPLETE, 0);
  context.flush();
  const waits = () => context.getSyncParameter(done, context.SYNC_STATUS) === context.UNSIGNALED;
  while (!context.isContextLost() && waits()) await new Promise((resolve) => setTimeout(resolve, POLL_MS));
  context.deleteSync(done);
}

/** Render a scene and copy it onto a 2-D canvas, over what is there. Returns the number of draw calls. */
export function renderScene(scene, camera, context, size) {
  const gl = acquireRenderer();
  setSize(gl, size);
  gl.render(scene, camera);
  context.drawImage(gl.domElement, 0, 0, size.width, size.height);
  return gl.info.render.calls;
}

function setSize(gl, { width, height, ratio }) {
  const present = gl.domElement;
  if (present.width === Math.floor(width * ratio) && present.height === Math.floor(height * ratio)) return;
  gl.setPixelRatio(ratio);
  gl.setSize(width, height, false);
}
