// Solids between two points, merged into one mesh per body, so that an arm needs few draw calls.
import {
  BoxGeometry,
  BufferGeometry,
  CapsuleGeometry,
  Color,
  ConeGeometry,
  CylinderGeometry,
  Float32BufferAttribute,
  LatheGeometry,
  Matrix4,
  Quaternion,
  SphereGeometry,
  Vector2,
  Vector3,
} from 'three';
import { RoundedBoxGeometry } from 'three/examples/jsm/geometries/RoundedBoxGeometry.js';
import { add, minus, norm } from '../vectors.js';

const UP = new Vector3(0, 1, 0);
const ONE = new Vector3(1, 1, 1);

/** For each shape, its geometry along the y axis, centred at the origin. */
const MAKERS = {
  rod: (length, r) => new CylinderGeometry(r, r, length, 12),
  cylinder: (length, r) => new CylinderGeometry(r, r, length, 40),
  cone: (length, r) => new ConeGeometry(r, length, 16),
  box: (length, r) => new BoxGeometry(2 * r, length, 2 * r),
  sphere: (_, r) => new SphereGeometry(r, 20, 12),
  frustum: (length, r, { end }) => new CylinderGeometry(end, r, length, 24, 1, true),
  drum: (length, r) => new LatheGeometry(roundedProfile(length, r), 28),
  block: (_, __, { sizes }) => new RoundedBoxGeometry(...sizes.map((half) => 2 * half), 1, 0.16 * Math.min(...sizes)),
  capsule: (length, r) => new CapsuleGeometry(r, length, 8, 20),
};

/** The outline of a cylinder with rounded edges, from the middle of its lower end to that of its upper one. */
function roundedProfile(length, r) {
  const edge = Math.min(0.16 * r, 0.3 * length);
  const corner = (angle) => [r - edge + edge * Math.cos(angle), length / 2 - edge + edge * Math.sin(angle)];
  const upper = [0, 1].map((share) => corner((share * Math.PI) / 2));
  const half = [...upper, [0, length / 2]];
  const lower = half.map(([x, y]) => [x, -y]).reverse();
  return [...lower, ...half].map(([x, y]) => new Vector2(x, y));
}

/** The geometry of a part { shape, from, to, radius, ... }, in metres, between its two points. */
function makeSolid(part) {
  const from = new Vector3(...part.from);
  const along = new Vector3(...part.to).sub(from);
  const length = along.length();
  const geometry = MAKERS[part.shape](length, part.radius, part);
  const turned = new Quaternion();
  if (part.axes) turned.setFromRotationMatrix(new Matrix4().makeBasis(...part.axes.map((v) => new Vector3(...v))));
  else if (length > 0) turned.setFromUnitVectors(UP, along.clone().divideScalar(length));
  const middle = from.addScaledVector(along, 0.5);
  return geometry.applyMatrix4(new Matrix4().compose(middle, turned, ONE));
}

/** A dashed line as a row of rods, because lines in WebGL are only one pixel wide. */
export function dashedLine({ from, to, dash, gap, ...rest }) {
  const start = new Vector3(...from);
  const along = new Vector3(...to).sub(start);
  const length = along.length();
  const count = Math.max(1, Math.round((length + gap) / (dash + gap)));
  const scale = length / (count * (dash + gap) - gap);
  return Array.from({ length: count }, (_, k) => {
    const at = (s) =>
      start
        .clone()
        .addScaledVector(along, (s * scale) / length)
        .toArray();
    return { ...rest, shape: 'rod', from: at(k * (dash + gap)), to: at(k * (dash + gap) + dash) };
  });
}

/** An arrow: a rod, dashed if it has a dash, and a cone of length head and radius tip at its end. */
export function arrow({ head, tip, dash, gap, ...line }) {
  const way = minus(line.to, line.from);
  const neck = add(line.to, way, -head / norm(way));
  const stem = { ...line, to: neck };
  const drawn = dash ? dashedLine({ ...stem, dash, gap }) : [{ ...stem, shape: 'rod' }];
  return [...drawn, { ...line, shape: 'cone', from: neck, radius: tip }];
}

/** A name beside a point, away from another one if there is one; where there is little room, more weight comes first. */
export function label(at, text, colour, weight, { sub = '', ...more } = {}) {
  return { label: true, at, text, sub, colour, weight, italic: true, ...more };
}

/** Merge parts into one geometry with a colour per vertex and, if outlined, the normals of its outline. */
export function mergeParts(parts, outlined) {
  const position = [];
  const normal = [];
  const outlineNormal = [];
  const colour = [];
  const index = [];
  const ink = new Color();
  for (const part of parts) {
    const geometry = makeSolid(part);
    const first = position.length / 3;
    const points = geometry.attributes.position.array;
    for (const value of points) position.push(value);
    for (const value of geometry.attributes.normal.array) normal.push(value);
    if (outlined)
      for (const value of outlineNormals(points, geometry.attributes.normal.array)) outlineNormal.push(value);
    ink.set(part.colour);
    if (outlined) ink.convertLinearToSRGB(); // its material does not convert colours
    for (let k = 0; k < points.length; k += 3) colour.push(ink.r, ink.g, ink.b);
    const corners = geometry.index?.array ?? Array.from({ length: points.length / 3 }, (_, k) => k);
    for (const corner of corners) index.push(first + corner);
    geometry.dispose();
  }
  const whole = new BufferGeometry();
  whole.setAttribute('position', new Float32BufferAttribute(position, 3));
  whole.setAttribute('normal', new Float32BufferAttribute(normal, 3));
  if (outlined) whole.setAttribute('outlineNormal', new Float32BufferAttribute(outlineNormal, 3));
  whole.setAttribute('color', new Float32BufferAttribute(colour, 3));
  whole.setIndex(index);
  return whole;
}

/** The offset direction of each vertex of the outline: the mean normal of all vertices at the same position. */
function outlineNormals(points, normals) {
  const sums = new Map();
  const all = [];
  for (let k = 0; k < points.length; k += 3) {
    const key = `${Math.round(1e6 * points[k])},${Math.round(1e6 * points[k + 1])},${Math.round(1e6 * points[k + 2])}`;
    if (!sums.has(key)) sums.set(key, [0, 0, 0]);
    const sum = sums.get(key);
    for (let c = 0; c < 3; c += 1) sum[c] += normals[k + c];
    all.push(sum);
  }
  return all.flatMap(([x, y, z]) => {
    const length = Math.hypot(x, y, z) || 1;
    return [x / length, y / length, z / length];
  });
}
