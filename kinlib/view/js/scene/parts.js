// The parts of each layer of an arm: solids and labels, fixed to the bodies and given in the home configuration.
// A part is { body, shape, from, to, radius, colour }, a label { body, at, from, text, sub, colour, weight }.
import { add, middle, minus, norm } from '../vectors.js';
import { label } from './shapes.js';
import { mixColours } from './solids.js';

/** Radii, as fractions of the arm's size. */
const JOINT = 0.05;
const LINK = 0.026;

const unit = (p) => p.map((value) => value / (norm(p) || 1));

/** Primitives of one body: drums, tubes and boxes, see kinlib/view/figures/bodies.py; on says which body it is. */
function primitives(all, on, colours) {
  return all.flatMap(({ kind, points, sizes, colour, axes }) => {
    // a colour of a file; on a dark page, black would not be seen
    const own = () => mixColours(colour, colours.body, colours.isDark ? 0.12 : 0);
    const look = { ...on, colour: colours[colour] ?? own() };
    if (kind === 'box') return [{ ...look, shape: 'block', from: points[0], to: points[0], sizes, axes }];
    if (kind === 'drum') return [{ ...look, shape: 'drum', from: points[0], to: points[1], radius: sizes[0] }];
    const balls = points.map((at, i) => ({ ...look, shape: 'sphere', from: at, to: at, radius: sizes[i] }));
    const cones = points.slice(1).map((to, i) => {
      return { ...look, shape: 'frustum', from: points[i], to, radius: sizes[i], end: sizes[i + 1] };
    });
    return [...balls, ...cones];
  });
}

/** The solids of an arm's body, link by link. */
export const body = (arm, colours) => arm.body.flatMap((link, k) => primitives(link, { body: k }, colours));

/** Where a joint is drawn: joints with the same point and axis are drawn side by side along the axis. */
function jointCentre(joint, size) {
  return add(joint.point, joint.axis, 3.3 * JOINT * size * joint.shift);
}

/** The links of an arm without a body, straight from joint to joint. */
export const links = ({ links: lines }, size, { link: colour }) =>
  lines.map(([from, to], body) => ({ body, shape: 'capsule', from, to, radius: LINK * size, colour }));

export function joints(arm, size, colours) {
  const r = JOINT * size;
  return arm.joints.flatMap((joint, i) => {
    if (joint.hidden) return []; // another branch of the robot shows it
    const centre = jointCentre(joint, size);
    const at = (share) => add(centre, joint.axis, share * r);
    if (joint.kind === 'P') {
      // the sleeve belongs to the previous link
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

/** Screw axes, on the body before the joint, which does not move its own axis. */
export function axes(arm, size, letter, colour, onBody = (i) => i) {
  return arm.joints.flatMap((joint, i) => {
    const centre = jointCentre(joint, size);
    const [from, to] = [-0.26, 0.36].map((share) => add(centre, joint.axis, share * size));
    const name = `${letter}_${joint.number ?? i + 1}`;
    const looks = { colour, width: 1, dashed: true, tip: true, name };
    return joint.hidden ? [] : [{ kind: 'line', body: onBody(i), from, to, ...looks }];
  });
}

/** Frames; those that share an origin get axes of different length. DH frames are named by their indices. */
export function triads(frames, size, length, numbered) {
  const ranks = new Map();
  return frames.map(({ name, body, pose, rank: given, grey }) => {
    const key = [pose[3], pose[7], pose[11]].map((value) => (value / size).toFixed(4)).join();
    const rank = given ?? ranks.get(key) ?? 0;
    ranks.set(key, rank + 1);
    const own = numbered && /^\d+'?$/.test(name);
    const names = { sub: own ? name : '', name: own ? '' : name };
    return { kind: 'frame', body, pose, letters: 'Oxyz', thin: true, length: length + 0.055 * rank, ...names, grey };
  });
}

/** Lengths of the links: the distance from joint to joint, in the middle of each line. */
export function dimensions(arm, size) {
  return arm.links.flatMap(([from, to], body) => {
    const length = from ? norm(minus(to, from)) : 0;
    const text = `${Number(length.toPrecision(4))}`;
    return length < 0.02 * size ? [] : [{ kind: 'name', body, at: middle(from, to), text, weight: 3 }];
  });
}

/** The solids of a linkage, and its joints with their names. */
export function linkage({ solids = [], pins = [] }, colours) {
  const names = pins.map(({ arm, body: own, at, name }) => {
    const [text, sub = ''] = name.replace(/^joint /, '').split('_');
    return label(at, text, colours.ink, 3, { arm, body: own, sub });
  });
  return [...solids.flatMap(({ arm, body: own, parts }) => primitives(parts, { arm, body: own }, colours)), ...names];
}

/** The axes of a linkage's joints, through each joint. */
export function pinAxes({ pins = [] }, size) {
  return pins
    .filter(({ axis }) => axis)
    .map(({ arm, body: own, at, axis }) => {
      const [from, to] = [-0.3, 0.3].map((share) => add(at, axis, share * size));
      return { kind: 'line', arm, body: own, from, to, colour: 'axis', width: 1, dashed: true };
    });
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
