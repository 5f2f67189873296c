// The viewer combines the stage, the controls and the readout. Every change takes the same path: the page or Python
// sets a trait of the model, and the page is drawn when the model reports the change.
import { Vector3 } from 'three';
import { dragLink } from './controls/drag-link.js';
import { jointSliders } from './controls/joint-sliders.js';
import { layerToggles, viewButtons } from './controls/layer-toggles.js';
import { poseReadout } from './controls/pose-readout.js';
import { predictionCover } from './controls/prediction-cover.js';
import { formatNumber, h, NO_SHORTCUTS } from './dom.js';
import { listen, save } from './model.js';
import { placeFrames } from './modes/place-frames.js';
import { steps } from './modes/steps.js';
import { renderPictures } from './pictures.js';
import { orbitControls } from './render/camera.js';
import { Stage } from './render/stage.js';
import { describeArm, describeLinkage, describeTree, endEffectorText, frameText, tipsText } from './scene/describe.js';
import { matrixOf, rows } from './scene/kinematic-tree.js';
import { availableLayers, buildLayers, framesIn, isSingleFrame, showLayers } from './scene/layers.js';
import { lowestOf, readMeshes } from './scene/meshes.js';
import { createTrail } from './scene/trail.js';
import { isDark, onThemeChange, themeOf } from './theme.js';
import css from './viewer.css';

const HEIGHT_PER_WIDTH = 0.78; // of the picture
const MODES = { assign: placeFrames, steps }; // what a viewer can do in addition to showing an arm
const SPEECH_DELAY_MS = 700; // a screen reader announces the pose when nothing has moved for this long

function render({ model, el }) {
  const data = model.get('scene');
  const q = () => model.get('q');
  const state = {
    sliders: data.sliders ?? [],
    limits: data.limits ?? [],
    q,
    set: (values) => save(model, 'q', values),
    start: () => model.get('start'),
    choose: (link) => data.arms.length === 1 && stage.choose(link),
  };

  const canvas = h('canvas', { class: 'kv-canvas', tabindex: 0, role: 'img', ...NO_SHORTCUTS });
  const message = h('p', { class: 'kv-message', role: 'status', hidden: true });
  const announcement = h('p', { class: 'kv-screen-reader', 'aria-live': 'polite' });
  const still = h('div', { class: 'kv-still' }); // until WebGL has drawn the first picture, and without WebGL
  const frame = h('div', { class: 'kv-picture' }, canvas, still);
  const root = h('div', { class: 'kv', role: 'group', 'aria-label': `Viewer of ${data.name}` });
  root.viewer = { model }; // for tests and for scripts on the page
  el.append(root);
  root.append(frame);
  const stage = new Stage(data, canvas, themeOf(root));
  root.viewer.stage = stage;
  stage.onReady = () => {
    still.hidden = !stage.withoutWebGL;
    if (Object.keys(model.get('meshes') ?? {}).length) root.viewer.meshes ??= addMeshes();
    if (!stage.withoutWebGL) return;
    root.classList.add('kv-flat');
    save(model, 'flat', true); // Python draws it then, where there is one
    update();
  };
  const pose = poseReadout();
  const panel = jointSliders(state);
  const cover = predictionCover(model);
  const hidden = new Set(); // the names of frames that the reader has switched off in a group of frames
  const switches = layerToggles({
    available: availableLayers(data, model.get('shown')),
    shown: () => model.get('shown'),
    setShown: (names) => save(model, 'shown', names),
    framesIn: (layers) => framesIn(data, layers),
    hidden,
    changed: () => updateLayers(),
  });
  const modeData = model.get('mode') ?? {};
  const mode = MODES[modeData.kind]?.({ model, stage, data: modeData, state, showMessage }) ?? {};
  const viewBar = viewButtons(stage.camera);
  frame.append(viewBar);
  stage.reservedBoxes = () => {
    const left = viewBar.offsetLeft;
    return viewBar.offsetTop < canvas.offsetTop
      ? []
      : [
          {
            left,
            right: left + viewBar.offsetWidth,
            top: viewBar.offsetTop,
            bottom: viewBar.offsetTop + viewBar.offsetHeight,
          },
        ];
  };
  const side = h(
    'div',
    { class: 'kv-side' },
    ...(mode.element ? [mode.element] : []),
    ...(mode.replacesSliders ? [] : [panel.element]),
    ...(model.get('readout') ? [pose.element] : []),
  );
  const inside = h('div', { class: 'kv-inside' }, h('div', { class: 'kv-left' }, frame, switches.element), side);
  root.append(cover.element, inside, message, announcement);

  let trail = null;
  let speaking = 0;
  const notes = [...(model.get('notes') ?? [])]; // about the meshes of the robot
  const tip = new Vector3();

  function showMessage(text) {
    if (message.textContent === text) return; // a screen reader would read it out again
    message.textContent = text;
    message.hidden = !text || model.get('covered');
  }

  function update() {
    const values = q();
    stage.setQ(values);
    const T = stage.tree.pose();
    pose.update(values, T);
    panel.update(values);
    mode.update?.(values, T);
    trail?.add(tip.set(T[0][3], T[1][3], T[2][3]));
    showMessage(
      [stage.withoutWebGL && (model.withoutKernel ? STILL : NO_WEBGL), limitMessage(data.limits, values), ...notes]
        .filter(Boolean)
        .join(' '),
    );
    describeLater();
  }

  function describeLater() {
    clearTimeout(speaking);
    speaking = setTimeout(describe, SPEECH_DELAY_MS);
  }

  function describe() {
    const isArm = Boolean(data.arms[0].links);
    const isTree = Boolean(data.arms[0].tip);
    const describeRobot = isTree ? describeTree : describeArm;
    const text = mode.describe?.() ?? (isArm ? describeRobot : describeLinkage)(data, stage.tree, q());
    canvas.setAttribute('aria-label', `${text}${shownFrames()} ${KEYBOARD_HELP}`);
    if (isArm && !mode.describe && root.contains(document.activeElement))
      announcement.textContent = isTree ? tipsText(data, stage.tree) : endEffectorText(stage.tree);
  }

  /** The frames that the reader has switched on one by one. */
  function shownFrames() {
    return model
      .get('shown')
      .filter(isSingleFrame)
      .map((layer) => {
        const { name, body, pose } = data.arms[0].frames[layer][0];
        return ` ${frameText(name, rows(matrixOf(pose).premultiply(stage.tree.body(0, body).matrixWorld)))}`;
      })
      .join('');
  }

  function updateLayers() {
    const shown = model.get('shown');
    showLayers(stage, shown, hidden);
    switches.update();
    describe();
    const wanted = shown.includes('trail');
    if (wanted && !trail) {
      trail = createTrail(stage);
      update();
    } else if (!wanted && trail) {
      trail.dispose();
      trail = null;
    }
  }

  /** Replace bodies by their meshes as soon as these have been read. */
  async function addMeshes() {
    const found = await readMeshes(model, data.arms);
    stage.meshes = found.bodies;
    notes.push(...found.notes);
    const standsOnMesh = found.bodies.some(({ arm, body }) => arm === 0 && body === 0);
    const lowest = lowestOf(found.bodies, stage.tree);
    stage.setFloor(standsOnMesh ? lowest : Math.min(lowest, data.floor));
    buildLayers(stage, model.get('shown'));
    updateLayers();
    update();
  }

  function applyTheme() {
    const theme = isDark(root) ? 'dark' : 'light';
    if (root.dataset.theme === theme) return; // pages change their classes for other reasons, too
    root.dataset.theme = theme;
    stage.setTheme(themeOf(root));
    buildLayers(stage, model.get('shown'));
    stage.setQ(q());
    mode.applyTheme?.();
  }

  function updateCover() {
    cover.update();
    inside.hidden = model.get('covered');
    message.hidden = inside.hidden || !message.textContent; // the message could reveal what is to be predicted
  }

  function updateDrawing() {
    still.innerHTML = model.get('drawing') ?? '';
  }

  const changes = { q: update, shown: updateLayers, covered: updateCover, drawing: updateDrawing };
  for (const trait of ['at', 'variant', 'frames']) changes[trait] = describeLater; // of the modes
  const stopListening = listen(model, changes);
  applyTheme();
  updateLayers();
  updateCover();
  updateDrawing();
  update();
  describe();
  performance.mark('kinlib-viewer-answers');
  const stopTheme = onThemeChange(applyTheme);
  const stopOrbit = orbitControls(stage.camera, canvas, dragLink(stage, state));
  const resizeObserver = new ResizeObserver(() => {
    applyTheme(); // JupyterLab attaches the element only now, so its background was unknown before
    const width = frame.clientWidth;
    if (width) stage.resize(width, Math.round(Math.max(260, Math.min(HEIGHT_PER_WIDTH * width, 560))));
  });
  resizeObserver.observe(frame);
  const visibilityObserver = new IntersectionObserver((entries) => stage.setVisible(entries.at(-1).isIntersecting), {
    rootMargin: '200px',
  });
  visibilityObserver.observe(frame);
  return () => {
    for (const stop of [
      stopListening,
      stopTheme,
      stopOrbit,
      () => resizeObserver.disconnect(),
      () => visibilityObserver.disconnect(),
      panel.dispose,
    ])
      stop();
    clearTimeout(speaking);
    mode.dispose?.();
    trail?.dispose();
    stage.dispose();
  };
}

const NO_WEBGL = 'WebGL is not available in this browser, so a flat drawing is shown.';
const STILL = 'WebGL is not available in this browser, so a flat drawing of the start is shown, which does not move.';
const KEYBOARD_HELP =
  'Arrow keys rotate the view, shift and arrow keys pan it, plus and minus zoom, 0 to 3 select the named views.';

/** A message about joint values beyond the joint limits, or an empty string. */
function limitMessage(limits, q) {
  const beyond = (limits ?? []).flatMap(([low, high], k) =>
    (low !== null && q[k] < low - 1e-9) || (high !== null && q[k] > high + 1e-9)
      ? [`Joint ${k + 1} is at ${formatNumber(q[k], 3)}, outside its limits ${low ?? '−∞'} to ${high ?? '∞'}.`]
      : [],
  );
  return beyond.length ? `${beyond.join(' ')} The arm cannot reach this configuration.` : '';
}

function addStyleSheet() {
  if (document.getElementById('kinlib-viewer-style')) return;
  const sheet = h('style', { id: 'kinlib-viewer-style' });
  sheet.textContent = css;
  document.head.append(sheet);
}

/** Render, and show an error in place of the picture, not only in the console. */
function renderOrExplain(context) {
  try {
    addStyleSheet();
    return context.model.get('scene') ? render(context) : renderPictures(context);
  } catch (error) {
    context.el.append(
      h('p', { class: 'kv-failed', role: 'alert' }, `The viewer cannot show this arm: ${error.message}`),
    );
    return undefined;
  }
}

export const widget = { render: renderOrExplain };
