// Drawing functions for the modes about frames: a pale arm, joint axes, frames axis by axis, and a highlighter.
import { Color, Vector3 } from 'three';
import { strokeLines } from '../render/pen.js';
import * as parts from '../scene/parts.js';
import { arrow, label } from '../scene/shapes.js';
import { add, minus, norm } from '../vectors.js';

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
  const along = minus(to, from);
  const ink = strong ? colour : mixColours(colour, theme.paper, 0.45);
  const radius = (strong ? 0.006 : 0.0042) * size;
  const at = add(to, along, (beyond * size) / norm(along));
  return [
    ...arrow({ body: i, from, to, radius, colour: ink, ...parts.axisDashes(size) }),
    label(at, `axis ${i + 1}`, strong ? colour : theme.quiet, 2.5, { body: i, from }),
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
      const to = add(origin, along, length * size);
      const radius = look.rod * size;
      return [
        ...arrow({ body, from: origin, to, radius, tip: 2.3 * radius, head: 0.045 * size, colour: ink }),
        label(to, letter, theme[letter], strong ? 4 : 2, { body, from: origin, sub: `${i}` }),
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
    const here = (k) => drawn[k] && poses[k] && norm(minus(originOf(poses[k]), originOf(pose))) < 1e-6 * size;
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
      const colour = HIGHLIGHT_COLOURS[dark ? 'dark' : 'light'][wrong ? 'wrong' : 'named'];
      const ends = [
        [p.x, p.y],
        [q.x + 0.01, q.y],
      ]; // a canvas draws no line of length 0
      strokeLines(context, [ends], colour, (from === to ? 1.7 : 1) * HIGHLIGHT_WIDTH_PX);
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
