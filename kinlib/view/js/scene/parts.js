// The parts of each layer of an arm: solids and labels, fixed to the bodies and given in the home configuration.
// A part is { body, shape, from, to, radius, colour }, a label { body, at, from, text, sub, colour, weight }.
import { add, minus, norm } from '../vectors.js';
import { arrow, dashedLine, label } from './shapes.js';

/** Radii, as fractions of the arm's size. */
const JOINT = 0.05;
const LINK = 0.026;
const ROD = 0.0066;

const unit = (p) => p.map((value) => value / (norm(p) || 1));

/** Where a joint is drawn: joints with the same point and axis are drawn side by side along the axis. */
function jointCentre(joint, size) {
  return add(joint.point, joint.axis, 3.3 * JOINT * size * joint.shift);
}

export function links(arm, size, colours) {
  return arm.links.flatMap((path, body) =>
    path
      .slice(1)
      .map((to, k) => ({ body, shape: 'capsule', from: path[k], to, radius: LINK * size, colour: colours.link })),
  );
}

export function joints(arm, size, colours) {
  const r = JOINT * size;
  return arm.joints.flatMap((joint, i) => {
    if (joint.hidden) return []; // another branch of the robot shows it
    const centre = jointCentre(joint, size);
    const at = (share) => add(centre, joint.axis, share * r);
    if (joint.kind === 'P') {
      // the sleeve belongs to the previous link; a rod translates in it
      return [{ body: i, shape: 'box', from: at(-1.6), to: at(1.6), radius: 0.92 * r, colour: colours.joint }];
    }
    const body = { body: i + 1, shape: 'cylinder', from: at(-1.5), to: at(1.5), radius: r, colour: colours.joint };
    const caps = [-1, 1].map((end) => ({
      ...body,
      from: at(1.5 * end),
      to: at(1.62 * end),
      radius: 0.55 * r,
      colour: colours.cap,
    }));
    if (joint.kind === 'H') {
      const thread = { shape: 'helix', radius: 1.02 * r, turns: Math.sign(joint.travel) * 3, wire: 0.09 * r };
      return [
        { ...body, radius: 0.96 * r },
        ...caps,
        { ...body, ...thread, from: at(-1.3), to: at(1.3), colour: colours.ink },
      ];
    }
    // a mark on the rim, because the rotation of a cylinder about its own axis is otherwise invisible
    const side = perpendicularTo(joint.axis);
    const mark = {
      ...body,
      shape: 'rod',
      from: add(at(-1.5), side, r),
      to: add(at(1.5), side, r),
      radius: 0.13 * r,
      colour: colours.ink,
    };
    return [body, ...caps, mark];
  });
}

/** The rod of a prismatic or helical joint, as long as the joint's translation. */
export function rods(arm, size, colours) {
  return arm.joints.flatMap((joint, i) =>
    joint.travel === 0 || joint.hidden
      ? []
      : [
          {
            body: i,
            joint: i,
            start: joint.point,
            axis: joint.axis,
            travel: joint.travel,
            radius: 0.75 * LINK * size,
            colour: colours.rod,
          },
        ],
  );
}

/** The dashes and the tip of a joint axis. */
export const axisDashes = (size) => ({ dash: 0.035 * size, gap: 0.018 * size, head: 0.05 * size, tip: 0.014 * size });

/** Screw axes: dashed, with a tip and a name; on the body before the joint, which does not move its own axis. */
export function axes(arm, size, { letter, colour, onBody = (i) => i }) {
  return arm.joints.flatMap((joint, i) => {
    if (joint.hidden) return [];
    const body = onBody(i);
    const centre = jointCentre(joint, size);
    const from = add(centre, joint.axis, -0.26 * size);
    const to = add(centre, joint.axis, 0.36 * size);
    return [
      ...arrow({ body, from, to, radius: 0.0048 * size, colour, ...axisDashes(size) }),
      label(to, letter, colour, 3, { body, from: centre, sub: `${joint.number ?? i + 1}` }),
    ];
  });
}

/** Frames as three thin rods with a letter at each tip. Frames that share an origin get rods of different length. */
export function triads(frames, size, colours, { numbered = false, short = false, length = 0.17 } = {}) {
  const ranks = new Map();
  return frames.flatMap(({ name, body, pose, rank: given }) => {
    const origin = [pose[3], pose[7], pose[11]];
    const key = origin.map((value) => (value / size).toFixed(4)).join();
    const rank = given ?? ranks.get(key) ?? 0;
    ranks.set(key, rank + 1);
    const long = (length + 0.055 * rank) * size;
    const own = numbered && /^\d+$/.test(name);
    const thick = own ? 0.85 : 1.15;
    const made = ['x', 'y', 'z'].flatMap((letter, k) => {
      const colour = colours[letter];
      const to = add(origin, [pose[k], pose[4 + k], pose[8 + k]], long);
      const radius = thick * ROD * size;
      return [
        ...arrow({ body, from: origin, to, radius, tip: 2.3 * radius, head: 0.035 * size, colour }),
        label(to, letter, colour, letter === 'y' ? 1 : 2, {
          body,
          from: origin,
          sub: own || (short && name.length < 3) ? name : '',
        }),
      ];
    });
    made.push({ body, shape: 'sphere', from: origin, to: origin, radius: 1.6 * ROD * size, colour: colours.ink });
    if (!own) {
      // opposite to the axes, where nothing else is drawn
      const middle = [0, 1, 2].map((row) => origin[row] + pose[4 * row] + pose[4 * row + 1] + pose[4 * row + 2]);
      made.push(label(origin, `{${name}}`, colours.ink, 4, { body, italic: false, from: short ? middle : undefined }));
    }
    return made;
  });
}

/** Common normals, orange and dashed. One of length 0 is drawn as a short line along its direction. */
export function normals(arm, size, colours) {
  return arm.normals.flatMap(({ body, from, to, along }, i) => {
    const short = norm(minus(to, from)) < 1e-6 * size;
    const half = short ? 0.09 * size : 0;
    const ends = { from: add(from, along, -half), to: add(to, along, half) };
    const middle = add(ends.from, minus(ends.to, ends.from), 0.5);
    const line = { body, ...ends, radius: 0.0075 * size, colour: colours.normal, dash: 0.02 * size, gap: 0.011 * size };
    const name = label(short ? ends.to : middle, 'a', colours.normal, 2, { body, sub: `${i + 1}` });
    return [...dashedLine(line), name];
  });
}

/** Lengths of the links: a dimension line beside each segment, drawn on the 2-D canvas. */
export function dimensions(arm, size, colours) {
  return arm.links.flatMap((path, body) =>
    path.slice(1).flatMap((to, k) => {
      const length = norm(minus(to, path[k]));
      if (length < 0.02 * size) return [];
      return [
        { body, dimension: true, from: path[k], to, text: `${Number(length.toPrecision(4))}`, colour: colours.ink },
      ];
    }),
  );
}

const PIECES = {
  bar: ({ at, along }, size, colours) => ({
    shape: 'capsule',
    from: at,
    to: add(at, along),
    radius: 0.022 * size,
    colour: colours.link,
  }),
  cylinder: ({ at, along }, size, colours) => centred('cylinder', at, along, 0.05 * size, 0.034 * size, colours.joint),
  box: ({ at, along }, size, colours) => centred('box', at, along, 0.07 * size, 0.04 * size, colours.joint),
  slider: ({ at, along }, size, colours) => centred('box', at, along, 0.05 * size, 0.028 * size, colours.rod),
  ball: ({ at }, size, colours) => ({ shape: 'sphere', from: at, to: at, radius: 0.04 * size, colour: colours.joint }),
};

function centred(shape, at, along, half, radius, colour) {
  return { shape, from: add(at, along, -half), to: add(at, along, half), radius, colour };
}

/** The parts of a linkage: bars and joints with their names, and a foot under each joint on the ground. */
export function pieces({ pieces: all = [], floor }, size, colours) {
  return all.flatMap((piece) => {
    const { arm, body, kind, at, name, foot } = piece;
    const made = [{ arm, body, ...PIECES[kind](piece, size, colours) }];
    if (name) {
      const [text, sub = ''] = name.replace(/^joint /, '').split('_');
      made.push(label(at, text, colours.ink, 3, { arm, body, sub }));
    }
    if (foot && at[2] > floor) {
      const ground = [at[0], at[1], floor];
      made.push({ arm, body, shape: 'capsule', from: ground, to: at, radius: 0.016 * size, colour: colours.rod });
      made.push({
        arm,
        body,
        shape: 'cylinder',
        from: ground,
        to: add(ground, [0, 0, 0.012 * size]),
        radius: 0.06 * size,
        colour: colours.rod,
      });
    }
    return made;
  });
}

/** The axes of a linkage's joints, through each joint. */
export function pieceAxes({ pieces: all = [] }, size, colours) {
  return all
    .filter(({ name, kind }) => name && kind !== 'ball')
    .flatMap(({ arm, body, at, along }) =>
      dashedLine({
        arm,
        body,
        from: add(at, along, -0.3 * size),
        to: add(at, along, 0.3 * size),
        radius: 0.005 * size,
        colour: colours.axis,
        dash: 0.035 * size,
        gap: 0.018 * size,
      }),
    );
}

/** A unit vector perpendicular to an axis; the same axis always gives the same vector. */
export function perpendicularTo(axis) {
  const least = axis.map(Math.abs).indexOf(Math.min(...axis.map(Math.abs)));
  const other = [0, 1, 2].map((k) => (k === least ? 1 : 0));
  const along = axis[least];
  return unit(
    minus(
      other,
      axis.map((value) => value * along),
    ),
  );
}

/** The pedestal of an arm whose base is above the floor: a column on a round plate. */
export function pedestal({ floor, foot }, size, colours) {
  if (!foot) return [];
  const top = [foot[0], foot[1], foot[2]];
  const ground = [foot[0], foot[1], floor];
  const plate = {
    body: 0,
    shape: 'cylinder',
    from: ground,
    to: add(ground, [0, 0, 0.018 * size]),
    radius: 0.1 * size,
    colour: colours.rod,
  };
  if (foot[2] - floor < 0.05 * size) return [plate];
  return [plate, { body: 0, shape: 'capsule', from: ground, to: top, radius: 0.03 * size, colour: colours.rod }];
}
