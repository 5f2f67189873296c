// The path of the tool since the trail was switched on, drawn over the picture.
import { Vector3 } from 'three';
import { strokeLines } from '../render/pen.js';

const MAX_POINTS = 900; // the oldest one is dropped first

export function createTrail(stage) {
  const points = [];
  const overlay = (context, camera) => {
    if (points.length < 2) return;
    const path = points.map((point) => camera.project(point, new Vector3())).map(({ x, y }) => [x, y]);
    context.globalAlpha = 0.85;
    strokeLines(context, [path], stage.theme.trail, 3);
    context.globalAlpha = 1;
  };
  stage.overlays.add(overlay);
  return {
    /** Add a position of the tool. Steps too short to see are left out. */
    add(point) {
      if (points.at(-1)?.distanceTo(point) < 0.002 * stage.data.size) return;
      points.push(point.clone());
      if (points.length > MAX_POINTS) points.shift();
    },
    dispose() {
      stage.overlays.delete(overlay);
      stage.draw();
    },
  };
}
