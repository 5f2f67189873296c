// Drawing functions for the modes about frames: a pale arm, joint axes, frames axis by axis, and a highlighter.
import { Color, Vector3 } from 'three';
import * as parts from '../scene/parts.js';
import { dashedLine } from '../scene/shapes.js';
import { add } from './vectors.js';

const HIGHLIGHT_WIDTH_PX = 17;
const HIGHLIGHT_COLOURS = {
  light: { named: '#ffec99', wrong: '#ffb3ad' },
  dark: { named: '#5c4a00', wrong: '#661a1a' },
};
const STRONG = { rod: 0.0105, origin: 0.017 };
const PALE = { rod: 0.0062, origin: 0.0105 };

export const column = (pose, k) => [pose[k], pose[4 + k], pose[8 + k]];
export const originOf = (pose) => column(pose, 3);

/** A colour between two others. */
export function mixColours(colour, other, share) {
  return `#${new Color(colour).lerp(new Color(other), share).getHexString()}`;
}

/** Draw the arm in pale colours, so that what is drawn on it stands out. */
export function drawPaleArm(stage) {
  const { data, theme } = stage;
  const pale = (colour, share = 0.62) => mixColours(colour, theme.paper, share);
  const colours = {
    ...theme,
    link: pale(theme.link),
    joint: pale(theme.joint, 0.35),
    cap: pale(theme.cap, 0.35),
    rod: pale(theme.rod),
    ink: theme.quiet,
  };
  const made = data.arms.flatMap((arm) => [
    ...parts.links(arm, data.size, colours),
    ...parts.joints(arm, data.size, colours),
  ]);
  stage.setLayer('arm', [...parts.pedestal(data, data.size, colours), ...made], { outlined: true });
}

/** A joint axis between two points, dashed, with a tip and its number. */
export function axis(i, from, to, { size, theme, strong = true, colour = theme.axis, beyond = 0 }) {
  const along = add(to, from, -1);
  const length = Math.hypot(...along);
  const neck = add(from, along, 1 - (0.05 * size) / length);
  const ink = strong ? colour : mixColours(colour, theme.paper, 0.45);
  const line = {
    body: i,
    from,
    to: neck,
    radius: (strong ? 0.006 : 0.0042) * size,
    colour: ink,
    dash: 0.035 * size,
    gap: 0.018 * size,
  };
  return [
    ...dashedLine(line),
    { body: i, shape: 'cone', from: neck, to, radius: 0.014 * size, colour: ink },
    {
      body: i,
      label: true,
      at: add(to, along, (beyond * size) / length),
      from,
      text: `axis ${i + 1}`,
      sub: '',
      colour: strong ? colour : theme.quiet,
      italic: true,
      weight: 2.5,
    },
  ];
}

/** The parts of a frame that are placed, given as letters of O, x, y, z. */
export function frame(i, pose, letters, { size, theme, strong = true, length = 0.2, body = 0 }) {
  const look = strong ? STRONG : PALE;
  const origin = originOf(pose);
  const made = ['x', 'y', 'z']
    .filter((letter) => letters.includes(letter))
    .flatMap((letter) => {
      const along = column(pose, 'xyz'.indexOf(letter));
      const ink = strong ? theme[letter] : mixColours(theme[letter], theme.paper, 0.35);
      const neck = add(origin, along, (length - 0.045) * size);
      const tip = add(origin, along, length * size);
      return [
        { body, shape: 'rod', from: origin, to: neck, radius: look.rod * size, colour: ink },
        { body, shape: 'cone', from: neck, to: tip, radius: 2.3 * look.rod * size, colour: ink },
        {
          body,
          label: true,
          at: tip,
          from: origin,
          text: letter,
          sub: `${i}`,
          colour: theme[letter],
          italic: true,
          weight: strong ? 4 : 2,
        },
      ];
    });
  if (letters.includes('O')) {
    made.push({
      body,
      shape: 'sphere',
      from: origin,
      to: origin,
      radius: look.origin * size,
      colour: strong ? theme.ink : theme.quiet,
    });
  }
  return made;
}

/** How long the rods of each frame are: frames that share an origin get rods of different length. */
export function lengths(poses, drawn, size) {
  return poses.map((pose, i) => {
    const here = (k) =>
      drawn[k] && poses[k] && Math.hypot(...add(originOf(poses[k]), originOf(pose), -1)) < 1e-6 * size;
    const rank = pose ? [...poses.keys()].slice(0, i).filter(here).length : 0;
    return 0.2 + 0.07 * rank;
  });
}

/** A highlighter: broad transparent strokes over the picture. @returns { mark(strokes), dispose() } */
export function createHighlighter(stage) {
  let strokes = [];
  const [p, q] = [new Vector3(), new Vector3()];
  const overlay = (context, camera) => {
    const dark = stage.theme.dark;
    context.save();
    context.globalCompositeOperation = dark ? 'screen' : 'multiply';
    context.lineCap = 'round';
    for (const { from, to = from, wrong } of strokes) {
      camera.project(p.set(...from), p);
      camera.project(q.set(...to), q);
      context.strokeStyle = HIGHLIGHT_COLOURS[dark ? 'dark' : 'light'][wrong ? 'wrong' : 'named'];
      context.lineWidth = from === to ? 1.7 * HIGHLIGHT_WIDTH_PX : HIGHLIGHT_WIDTH_PX;
      context.beginPath();
      context.moveTo(p.x, p.y);
      context.lineTo(q.x + 0.01, q.y); // a canvas draws no line of length 0
      context.stroke();
    }
    context.restore();
  };
  stage.overlays.add(overlay);
  return {
    mark(wanted) {
      strokes = wanted;
      stage.draw();
    },
    dispose: () => stage.overlays.delete(overlay),
  };
}
