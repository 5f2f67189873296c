// exp([S] q) for a normalised screw axis S = (omega, v): Rodrigues' formula and its extension to rigid motions.
// Source: Modern Robotics, (3.88). Matrix4 holds JavaScript numbers, which are doubles.
import { Matrix4 } from 'three';

export function screwExp([x, y, z, a, b, c], q, out = new Matrix4()) {
  if (x === 0 && y === 0 && z === 0) {
    return out.set(1, 0, 0, a * q, 0, 1, 0, b * q, 0, 0, 1, c * q, 0, 0, 0, 1);
  }
  const cos = Math.cos(q);
  const sin = Math.sin(q);
  const half = Math.sin(q / 2);
  const k = 2 * half * half; // 1 - cos q, without cancellation for small q
  const climb = x * a + y * b + z * c;
  // p = (I q + (1 - cos q) W + (q - sin q) W^2) v = sin q v + (1 - cos q) omega x v + (q - sin q) (omega . v) omega
  const along = (q - sin) * climb;
  // biome-ignore format: one row of the matrix per line
  return out.set(
    cos + x * x * k, x * y * k - z * sin, x * z * k + y * sin, sin * a + k * (y * c - z * b) + along * x,
    y * x * k + z * sin, cos + y * y * k, y * z * k - x * sin, sin * b + k * (z * a - x * c) + along * y,
    z * x * k - y * sin, z * y * k + x * sin, cos + z * z * k, sin * c + k * (x * b - y * a) + along * z,
    0, 0, 0, 1,
  );
}
