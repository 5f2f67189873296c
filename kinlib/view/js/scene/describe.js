// Text alternatives, computed from what is drawn. describeArm and describeTree say what describe_arm says,
// and describeLinkage what describe_linkage says in kinlib/view.
import { Vector3 } from 'three';

const JOINT_KINDS = { R: 'revolute', P: 'prismatic', H: 'helical' };
const ROUNDING = 1e-5;

/** Three significant digits, and 0 for rounding errors, as Python writes them. */
function numberText(value) {
  return Math.abs(value) > ROUNDING ? `${Number(value.toPrecision(3))}` : '0';
}

const vectorText = (values) => `(${values.map(numberText).join(', ')})`;

/** A direction as x, -z, or by its components. */
function directionText(axis) {
  const k = axis.findIndex((value) => Math.abs(Math.abs(value) - 1) < ROUNDING);
  const along = k >= 0 && axis.every((value, other) => other === k || Math.abs(value) < ROUNDING);
  return along ? `${axis[k] < 0 ? '-' : ''}${'xyz'[k]}` : vectorText(axis);
}

const configurationText = (q) =>
  q.some((value) => Math.abs(value) > ROUNDING) ? `at q = ${vectorText(q)}` : 'at home';

/** A frame: its name, its origin and the directions of its axes; T is a list of rows. */
export function frameText(name, T) {
  const column = (k) => [T[0][k], T[1][k], T[2][k]];
  const axes = [0, 1, 2].map((k) => `${'xyz'[k]} along ${directionText(column(k))}`).join(', ');
  return `Frame {${name}} at ${vectorText(column(3))}, ${axes}.`;
}

/** A joint as it is at q: its number, its name if it has one, its kind, its axis and its place. */
function jointText({ kind, axis, point, number, name }, i, tree, k) {
  const { matrixWorld } = tree.body(k, i + 1);
  const along = directionText(new Vector3(...axis).transformDirection(matrixWorld).toArray());
  const at = vectorText(new Vector3(...point).applyMatrix4(matrixWorld).toArray());
  return `joint ${number ?? i + 1} ${name ? `${name} ` : ''}${JOINT_KINDS[kind]} along ${along} at ${at}`;
}

/** The arm of a scene as it is at q: the axis of each joint, and the end-effector. */
export function describeArm(data, tree, q) {
  const arm = data.arms[0];
  const joints = arm.joints.map((joint, i) => jointText(joint, i, tree, 0));
  const kinds = arm.joints.map(({ kind }) => kind).join('');
  const text = joints.join('; ');
  const head = `${data.name}, ${joints.length} joint${joints.length === 1 ? '' : 's'} (${kinds}), ${configurationText(q)}.`;
  return `${head} ${text[0].toUpperCase()}${text.slice(1)}. ${endEffectorText(tree)}`;
}

/** A robot with branches as it is at q: the joints of each branch that no earlier one has, and the end of each. */
export function describeTree(data, tree, q) {
  const count = (n, noun, ending) => `${n} ${noun}${n === 1 ? '' : ending}`;
  const branches = data.arms.map(({ joints, tip }, k) => {
    const own = joints.flatMap((joint, i) => (joint.hidden ? [] : [jointText(joint, i, tree, k)]));
    return `To ${tip}: ${[...own, `its end is at ${placeText(tree, k)} m`].join('; ')}.`;
  });
  const head = `${data.name}, ${count(q.length, 'independent joint', 's')}, ${count(data.arms.length, 'branch', 'es')}`;
  return [`${head}, ${configurationText(q)}.`, ...branches].join(' ');
}

const placeText = (tree, k) => vectorText([0, 1, 2].map((row) => tree.pose(k)[row][3]));

/** Where the ends of all branches are. */
export const tipsText = (data, tree) =>
  data.arms.map(({ tip }, k) => `${tip} is at ${placeText(tree, k)} m.`).join(' ');

export const endEffectorText = (tree) => `The end-effector is at ${placeText(tree, 0)} m.`;

/** A linkage as it is at q on its curve, where it is closed: its bodies, and where its joints are. */
export function describeLinkage(data, tree) {
  const joints = data.pins.map(({ name, joins, arm, body, at }) => {
    const place = new Vector3(...at).applyMatrix4(tree.body(arm, body).matrixWorld).toArray();
    return `${name} joins ${joins.join(' and ')} at ${vectorText(data.planar ? place.slice(0, 2) : place)}`;
  });
  return `${data.name} with the bodies ${data.bodies.join(', ')}. ${joints.join('; ')}. All lengths in metres. It is closed.`;
}
