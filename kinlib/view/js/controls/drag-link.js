// A link of the robot is dragged with the pointer: its joint, or the nearest one before it that has a slider, follows.
import { Vector3 } from 'three';

const PROBE = 1e-4; // radians or metres, to see how far the point moves in the picture
const MAX_STEP = 0.3; // in one step towards the pointer, so that a joint does not jump to its other side
const STEPS_A_MOVE = 4;
const MIN_PIXELS = 8; // per radian or metre; an axis towards the viewer's eye moves its point too little to follow

/** Return what takes hold of the link at a place of the picture: a function of the next places, or null if there is no link. */
export function dragLink(stage, state) {
  return (x, y) => {
    const found = state.sliders.length ? stage.pick(x, y) : null;
    const columns = found ? stage.tree.arms[found.arm].columns.slice(0, found.link) : [];
    const column = columns.findLast((own) => state.sliders.some((slider) => slider.column === own));
    if (column === undefined) return null;
    const { low, high } = state.sliders.find((slider) => slider.column === column);
    const place = new Vector3();
    const inPicture = (q) => {
      stage.tree.setQ(q);
      const { x: right, y: down } = stage.camera.project(found.body.localToWorld(place.copy(found.point)), place);
      return [right, down];
    };
    return (right, down) => {
      const q = [...state.q()];
      for (let step = 0; step < STEPS_A_MOVE; step += 1) {
        const here = inPicture(q);
        const [along, across] = inPicture(q.with(column, q[column] + PROBE)).map((p, k) => (p - here[k]) / PROBE);
        const size = along ** 2 + across ** 2;
        if (size < MIN_PIXELS ** 2) break;
        const wanted = ((right - here[0]) * along + (down - here[1]) * across) / size;
        const next = q[column] + Math.max(-MAX_STEP, Math.min(MAX_STEP, wanted));
        q[column] = Math.max(low, Math.min(high, next));
      }
      state.set(q);
    };
  };
}
