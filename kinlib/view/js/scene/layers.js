// The layers of an arm on the stage: which ones exist, what each contains, and how they follow the theme.
import * as parts from './parts.js';
import { mixColours, solids } from './solids.js';

/** Layers that the reader can switch on and off, with their names on the page. */
export const TOGGLES = {
  axes: 'screw axes',
  'body axes': 'body axes',
  'home axes': 'axes at home',
  dimensions: 'lengths',
  trail: 'trail',
};

/** The choices in the list of frames, and the layers that each one shows. */
export const FRAMES = {
  none: { name: 'no frames', layers: [] },
  poe: { name: 'PoE: {s} and {b}', layers: ['base', 'tool'] },
  links: { name: 'PoE with links', layers: ['base', 'tool', 'links'] },
  standard: { name: 'standard DH', layers: ['standard'] },
  modified: { name: 'modified DH', layers: ['modified'] },
};

/** The choice in the list of frames that corresponds to a set of layers. */
export function frameChoiceOf(shown) {
  return (
    ['modified', 'standard', 'links'].find((name) => shown.includes(name)) ??
    (shown.includes('base') || shown.includes('tool') ? 'poe' : 'none')
  );
}

export function without(shown, layers) {
  return shown.filter((name) => !layers.includes(name));
}

export const FRAME_LAYERS = ['base', 'tool', 'links', 'standard', 'modified'];

/** The names of the layers that contain frames. An arm can have frames of its own, each in a layer "frame i". */
const frameLayers = ({ arms }) => [...new Set(arms.flatMap((arm) => Object.keys(arm.frames ?? {})))];

/** The lengths of the axes of {s} and {b}, as a fraction of the scene's size; those of other frames are shorter. */
const LENGTHS = { base: 0.24, tool: 0.24 };

/** The layers with one frame each, which are switched on one by one. */
export const isSingleFrame = (layer) => layer.startsWith('frame ');

/** The layers that contain something in this scene and therefore get a button. */
export function availableLayers({ arms, offered }, shown) {
  const whole = arms.some((arm) => arm.links);
  const worth = {
    axes: true,
    'body axes': shown.includes('body axes'),
    'home axes': shown.includes('home axes'),
    dimensions: whole,
    trail: whole,
  };
  const found = [...Object.keys(TOGGLES).filter((name) => worth[name]), ...frameLayers({ arms })];
  return offered ? found.filter((name) => offered.includes(name)) : found; // a mode may restrict them
}

/** Axes and frames lie inside the arm, so their hidden parts are drawn through it. */
const SEEN = { through: true };

/** Build every layer of the arms in the colours of the stage's theme. */
export function buildLayers(stage, shown) {
  const { data, theme } = stage;
  const { size } = data;
  const each = (make) =>
    data.arms.flatMap((arm, k) => (arm.links ? make(arm).map((part) => ({ ...part, arm: k })) : []));
  // an arm without a body is pale, so that the frames that are drawn on it stand out
  const pale = (name, share) => mixColours(theme[name], theme.paper, share);
  const colours = { link: pale('link', 0.62), joint: pale('joint', 0.35), cap: pale('cap', 0.35), ink: theme.quiet };
  const limbs = (arm) => [...parts.links(arm, size, colours), ...parts.joints(arm, size, colours)];
  // where the meshes of a body have been read, they are shown in place of its body by rule
  const isRead = (part) => stage.meshes.some(({ arm, body }) => arm === part.arm && body === part.body);
  const solid = each((arm) => (arm.body ? parts.body(arm, theme) : limbs(arm))).filter(
    (part) => !(data.arms[part.arm].rule?.[part.body] && isRead(part)),
  );
  stage.setLayer('arm', [...solid, ...parts.linkage(data, theme)], { outlined: true });
  if (stage.meshes.length) stage.buildMeshes();
  const made = {
    'pin axes': () => parts.pinAxes(data, size),
    axes: () => each((arm) => parts.axes(arm, size, 'S', 'axis')),
    'body axes': () => each((arm) => parts.axes(arm, size, 'B', 'axis')),
    'home axes': () => each((arm) => parts.axes(arm, size, 'S', 'grey', () => 0)),
    dimensions: () => each((arm) => parts.dimensions(arm, size)),
  };
  for (const name of frameLayers(data)) {
    const length = isSingleFrame(name) ? 0.21 : (LENGTHS[name] ?? 0.17);
    const numbered = !['base', 'tool'].includes(name);
    // a layer for each frame, so that the reader can choose among them
    const triads = each((arm) => parts.triads(arm.frames?.[name] ?? [], size, length, numbered));
    const names = each((arm) => arm.frames?.[name] ?? []).map((frame) => frame.name);
    for (const [k, frame] of names.entries()) made[`frames ${name} ${frame}`] = () => [triads[k]];
  }
  for (const [name, make] of Object.entries(made)) stage.setLayer(name, () => solids(make(), { size, theme }), SEEN);
  showLayers(stage, shown);
}

/** The names of the frames in some layers, each once. */
export function framesIn({ arms }, layers) {
  return [
    ...new Set(
      arms.flatMap(({ frames = {} }) => layers.flatMap((name) => (frames[name] ?? []).map((one) => one.name))),
    ),
  ];
}

/** Show the named layers, without the frames that are hidden, and hide the others. */
export function showLayers(stage, shown, hidden = new Set()) {
  stage.showLayer('pin axes', shown.includes('axes'));
  for (const name of ['axes', 'body axes', 'home axes', 'dimensions']) stage.showLayer(name, shown.includes(name));
  for (const layer of frameLayers(stage.data))
    for (const name of framesIn(stage.data, [layer]))
      stage.showLayer(`frames ${layer} ${name}`, shown.includes(layer) && !hidden.has(name));
}
