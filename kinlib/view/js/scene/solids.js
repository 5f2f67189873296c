// Lines, frames and names as solids and labels, see kinlib/view/figures/parts.py. Each part names its body, the base by default.
import { Color } from 'three';
import { add, middle, minus, norm } from '../vectors.js';
import { arrow, dashedLine, label } from './shapes.js';

const RADII = [0, 0.0042, 0.006, 0.0105, 0.016]; // of the widths of lines, as fractions of the size of the scene
const LABEL_WEIGHTS = [0, 2.5, 2.5, 3, 5];

export const column = (pose, k) => [pose[k], pose[4 + k], pose[8 + k]];
export const originOf = (pose) => column(pose, 3);

/** A colour between two others. */
export function mixColours(colour, other, share) {
  return `#${new Color(colour).lerp(new Color(other), share).getHexString()}`;
}

/** The solids and labels of parts. @param kit { size, theme } */
export function solids(parts, kit) {
  return parts.flatMap((part) => MAKERS[part.kind](part, kit));
}

const MAKERS = {
  name: ({ at, text, body = 0, arm, weight = 9 }, { theme }) => [
    label(at, text, theme.ink, weight, { body, arm, italic: false }),
  ],
  line({ from, to, colour, name, width, dashed, tip, strong = true, body = 0, arm }, { size, theme }) {
    const ink = strong ? theme[colour] : mixColours(theme[colour], theme.paper, 0.45);
    const [base, sub] = name ? name.split('_') : [];
    const stem = { body, arm, from, to, radius: (strong ? 1 : 0.7) * RADII[width] * size, colour: ink };
    const short = { head: Math.min(norm(minus(to, from)), 0.06 * size), tip: 0.016 * size };
    const axis = { dash: 0.035 * size, gap: 0.018 * size, head: 0.05 * size, tip: 0.014 * size };
    const made = [];
    if (tip) made.push(...arrow({ ...stem, ...(dashed ? axis : short) }));
    else if (dashed) made.push(...dashedLine({ ...stem, dash: 0.02 * size, gap: 0.011 * size }));
    else if (norm(minus(to, from))) made.push({ ...stem, shape: width > 3 ? 'capsule' : 'rod' });
    const text = { body, arm, sub, from: tip ? from : undefined };
    const named = strong ? theme[colour] : theme.quiet;
    if (name) made.push(label(tip ? to : middle(from, to), base, named, LABEL_WEIGHTS[width], text));
    return made;
  },
  frame({ pose, letters, sub = '', name = '', length, strong = true, thin, grey, body = 0, arm }, { size, theme }) {
    const origin = originOf(pose);
    const on = { body, arm };
    const radius = (strong && !thin ? 0.0105 : 0.0066) * size;
    const weight = strong ? 4 : 2;
    const made = [...'xyz']
      .filter((letter) => letters.includes(letter))
      .flatMap((letter) => {
        const ink = grey ? theme.grey : theme[letter];
        const colour = strong ? ink : mixColours(ink, theme.paper, 0.35);
        const to = add(origin, column(pose, 'xyz'.indexOf(letter)), length * size);
        // y gives way first, because x and z determine it
        const about = { ...on, from: origin, sub };
        const text = label(to, letter, ink, letter === 'y' ? weight - 1 : weight, about);
        const stem = { ...on, from: origin, to, radius, colour };
        return [...arrow({ ...stem, tip: 2.3 * radius, head: 0.04 * size }), ...(sub || strong ? [text] : [])];
      });
    const ball = { ...on, shape: 'sphere', from: origin, to: origin, radius: 1.6 * radius };
    if (letters.includes('O')) made.push({ ...ball, colour: strong ? theme.ink : theme.quiet });
    // opposite to the axes, where nothing else is drawn
    const away = [0, 1, 2].map((row) => origin[row] + pose[4 * row] + pose[4 * row + 1] + pose[4 * row + 2]);
    if (name) made.push(label(origin, `{${name}}`, theme.ink, 7, { ...on, italic: false, from: away }));
    return made;
  },
};
