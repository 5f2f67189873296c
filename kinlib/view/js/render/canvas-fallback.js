// Without WebGL the same parts are drawn as strokes on the 2-D canvas, the farther ones first. Everything still moves.
import { Vector3 } from 'three';
import { strokeLines } from './pen.js';

const ROUND = new Set(['capsule', 'sphere', 'rod']);

export function drawWithoutWebGL(context, solids, camera, theme) {
  const strokes = solids.map((part) => {
    const [p, q] = ends(part).map((point) => camera.project(point, new Vector3()));
    return { p, q, part, width: Math.max(1, (2 * part.radius) / camera.scale), depth: p.z + q.z };
  });
  strokes.sort((a, b) => b.depth - a.depth);
  for (const { p, q, part, width } of strokes) {
    if (part.shape === 'cone') tip(context, p, q, width, part.colour);
    else stroke(context, p, q, width, part, theme);
  }
}

function stroke(context, p, q, width, { shape, colour }, theme) {
  context.lineCap = ROUND.has(shape) ? 'round' : 'butt';
  for (const [ink, grown] of [
    [theme.outline, width > 6 ? 2 : 0],
    [colour, 0],
  ]) {
    const end = [q.x + (ROUND.has(shape) ? 0.01 : 0), q.y]; // a canvas draws no line of length 0
    strokeLines(context, [[[p.x, p.y], end]], ink, width + grown);
  }
}

function tip(context, p, q, width, colour) {
  const length = Math.hypot(q.x - p.x, q.y - p.y) || 1;
  const [nx, ny] = [(-(q.y - p.y) / length) * (width / 2), ((q.x - p.x) / length) * (width / 2)];
  context.fillStyle = colour;
  context.beginPath();
  context.moveTo(q.x, q.y);
  context.lineTo(p.x + nx, p.y + ny);
  context.lineTo(p.x - nx, p.y - ny);
  context.fill();
}

function ends(part) {
  if (part.rod) return [-0.5, 0.5].map((y) => part.rod.localToWorld(new Vector3(0, y, 0)));
  return [part.from, part.to].map((point) => part.body.localToWorld(new Vector3(...point)));
}
