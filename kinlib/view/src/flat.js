// Without WebGL: the same parts as strokes, the farther ones first. Less to look at, and all of it still moves.
import { Vector3 } from 'three';

const ENDS = { round: new Set(['capsule', 'sphere', 'rod']) };

export function drawFlat(context, solids, eye, theme) {
  const strokes = solids.map((part) => {
    const [p, q] = ends(part).map((point) => eye.project(point, new Vector3()));
    return { p, q, width: Math.max(1, (2 * part.radius) / eye.scale), colour: part.colour, round: ENDS.round.has(part.shape) };
  });
  strokes.sort((a, b) => b.p.z + b.q.z - a.p.z - a.q.z);
  for (const { p, q, width, colour, round } of strokes) {
    for (const [ink, grown] of [[theme.outline, width > 6 ? 2 : 0], [colour, 0]]) {
      context.strokeStyle = ink;
      context.lineWidth = width + grown;
      context.lineCap = round ? 'round' : 'butt';
      context.beginPath();
      context.moveTo(p.x, p.y);
      context.lineTo(q.x + (round ? 0.01 : 0), q.y); // a point is a very short line
      context.stroke();
    }
  }
}

function ends(part) {
  if (part.rod) return [-0.5, 0.5].map((y) => part.rod.localToWorld(new Vector3(0, y, 0)));
  return [part.from, part.to].map((point) => part.body.localToWorld(new Vector3(...point)));
}
