// The bodies of an arm, or of the arms of a closed chain, as nested groups. The group of joint i is transformed by
// exp([S_i] q_i), and what it contains is given in its home position: the scene graph is the product of exponentials.
import { Group, Matrix4, Vector3 } from 'three';
import { screwExp } from './screw-exp.js';

export class KinematicTree {
  /** @param arms [{ columns, joints: [{ screw }], home }], on one common base, which is body 0 of each */
  constructor(arms) {
    this.root = new Group();
    this.arms = arms.map((arm) => {
      const bodies = [this.root];
      for (const { screw } of arm.joints) {
        const body = new Group();
        body.matrixAutoUpdate = false;
        body.userData.screw = screw;
        bodies.at(-1).add(body);
        bodies.push(body);
      }
      const tool = new Group();
      tool.matrixAutoUpdate = false;
      tool.matrix.set(...arm.home);
      bodies.at(-1).add(tool);
      return { bodies, tool, columns: arm.columns, points: arm.links && arm.joints.map(({ point }) => point) };
    });
  }

  body(arm, index) {
    const { bodies, tool } = this.arms[arm];
    return index === 'tool' ? tool : bodies[index];
  }

  setQ(q) {
    for (const { bodies, columns } of this.arms) {
      columns.forEach((column, i) => {
        const body = bodies[i + 1];
        screwExp(body.userData.screw, q[column], body.matrix);
        body.matrixWorldNeedsUpdate = true;
      });
    }
    this.root.updateMatrixWorld(true);
  }

  /** The positions of the joints and the tools in the space frame. */
  jointPositions() {
    return this.arms
      .filter(({ points }) => points)
      .flatMap(({ bodies, tool, points }) => [
        ...points.map((point, i) => new Vector3(...point).applyMatrix4(bodies[i + 1].matrixWorld)),
        new Vector3().setFromMatrixPosition(tool.matrixWorld),
      ]);
  }

  /** T_sb of an arm, as a list of rows. */
  pose(arm = 0) {
    return rows(this.arms[arm].tool.matrixWorld);
  }
}

export function rows(matrix) {
  const e = matrix.elements;
  return [0, 1, 2, 3].map((row) => [0, 1, 2, 3].map((column) => e[4 * column + row]));
}

export function matrixOf(numbers) {
  return new Matrix4().set(...numbers);
}
