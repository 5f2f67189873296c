// The angles of motions as sectors over the picture, from the initial to the current direction of x (or z).
import { Vector3 } from 'three';
import { haloText, strokeLines } from '../render/pen.js';

const ARC_SEGMENTS = 24;

/** @param shares () -> the completed fraction of each motion of each track, from 0 to 1 */
export function angleSectors(stage, tracks, shares, radius) {
  const overlay = (context, camera) => {
    for (const [track, { motions, stops }] of tracks.entries()) {
      for (const [k, motion] of motions.entries()) {
        const share = shares()[track][k];
        const angle = motion.angle * share;
        if (Math.abs(angle) < 0.01) continue;
        const pose = stops[k];
        const translates = motion.travel !== 0;
        const pointAt = (phi, r) =>
          camera.project(
            arm(pose, motion.axis, phi, r).add(along(pose, motion.axis, translates ? motion.travel * phi : 0)),
            new Vector3(),
          );
        const points = Array.from({ length: ARC_SEGMENTS + 1 }, (_, i) => pointAt((angle * i) / ARC_SEGMENTS, radius));
        const hub = pointAt(0, 0);
        const colour = motion.axis === 'z' ? stage.theme.axis : stage.theme.normal;
        const now = share < 1 || shares()[track][k + 1] === 0 || k === motions.length - 1;
        context.save();
        context.globalAlpha = now ? 0.3 : 0.12;
        context.fillStyle = colour;
        context.beginPath();
        context.moveTo(hub.x, hub.y);
        for (const { x, y } of points) context.lineTo(x, y);
        if (!translates) context.fill(); // the line of a screw motion is a helix, which has no sector
        context.globalAlpha = now ? 1 : 0.55;
        strokeLines(context, [points.map(({ x, y }) => [x, y])], colour, 2);
        drawAngleName(
          context,
          translates ? '' : motion.symbol,
          pointAt(angle / 2, 1.2 * radius),
          colour,
          stage.theme.halo,
        );
        context.restore();
      }
    }
  };
  stage.overlays.add(overlay);
  return { dispose: () => stage.overlays.delete(overlay) };
}

/** The tip of x after a rotation about z, or of z after a rotation about x. */
function arm(pose, axis, angle, radius) {
  const column = (k) => new Vector3(pose[k], pose[4 + k], pose[8 + k]);
  // a rotation about z takes x towards y; a rotation about x takes z towards -y
  const [from, to, sign] = axis === 'z' ? [column(0), column(1), 1] : [column(2), column(1), -1];
  return column(3)
    .addScaledVector(from, radius * Math.cos(angle))
    .addScaledVector(to, sign * radius * Math.sin(angle));
}

function along(pose, axis, way) {
  const k = axis === 'z' ? 2 : 0;
  return new Vector3(pose[k], pose[4 + k], pose[8 + k]).multiplyScalar(way);
}

function drawAngleName(context, symbol, { x, y }, colour, halo) {
  const letter = { 'R_z(theta)': 'θ', 'R_x(alpha)': 'α' }[symbol];
  if (!letter) return;
  context.font = 'italic 600 15px "Cambria Math", Cambria, "DejaVu Serif", Georgia, serif';
  context.textAlign = 'center';
  context.textBaseline = 'middle';
  haloText(context, letter, x, y, colour, halo);
}
