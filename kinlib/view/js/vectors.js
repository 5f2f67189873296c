// Vectors as arrays of three numbers, and frames that are being placed: 4x4 in rows, with null for missing parts.

export const add = (p, q, s = 1) => p.map((value, k) => value + s * q[k]);
export const minus = (p, q) => add(p, q, -1);
export const dot = (p, q) => p.reduce((sum, value, k) => sum + value * q[k], 0);
export const middle = (p, q) => p.map((value, k) => (value + q[k]) / 2);
export const norm = (p) => Math.hypot(...p);
export const cross = ([a, b, c], [x, y, z]) => [b * z - c * y, c * x - a * z, a * y - b * x];
export const near = (p, q, off = 1e-9) => norm(minus(p, q)) < off;

/** Rotate a vector about a unit axis perpendicular to it. */
export function rotatePerpendicular(along, axis, angle) {
  const side = cross(axis, along);
  return along.map((value, k) => tidy(value * Math.cos(angle) + side[k] * Math.sin(angle)));
}

/** A column of a frame, or null if it is missing: 0 to 2 for x, y, z, and 3 for the origin. */
export function columnOf(T, k) {
  const values = [0, 1, 2].map((row) => T[row][k]);
  return values.some((value) => value === null) ? null : values;
}

export const PARTS = { z: 2, origin: 3, x: 0 };

/** The first missing part of a frame; null if it is complete. */
export function openPart(T) {
  return Object.keys(PARTS).find((part) => !columnOf(T, PARTS[part])) ?? null;
}

/** The frame with one part set. y follows from z and x; an x that is not perpendicular to a new z is removed. */
export function withPart(T, part, value) {
  const next = T.map((row) => [...row]);
  const put = (k, vector) =>
    [0, 1, 2].forEach((row) => {
      next[row][k] = vector ? tidy(vector[row]) : null;
    });
  put(PARTS[part], value);
  const [z, x] = [columnOf(next, 2), columnOf(next, 0)];
  const square = z && x && Math.abs(dot(z, x)) < 1e-9;
  if (part === 'z' && x && !square) put(0, null);
  put(1, square ? cross(z, x) : null);
  return next;
}

/** Replace a rounding error around 0, and -0, by 0. */
function tidy(value) {
  return Math.abs(value) < 1e-15 ? 0 : value;
}
