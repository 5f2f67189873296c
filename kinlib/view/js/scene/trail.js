// The path of the tool since the trail was switched on.
import {
  CylinderGeometry,
  DynamicDrawUsage,
  InstancedMesh,
  Matrix4,
  MeshBasicMaterial,
  Quaternion,
  Vector3,
} from 'three';
import { strokeLines } from '../render/pen.js';

const MAX_SEGMENTS = 900; // the oldest segment is replaced first
const UP = new Vector3(0, 1, 0);

export class Trail {
  constructor(stage) {
    this.stage = stage;
    this.mesh = new InstancedMesh(
      new CylinderGeometry(1, 1, 1, 6),
      new MeshBasicMaterial({ color: stage.theme.trail }),
      MAX_SEGMENTS,
    );
    this.mesh.instanceMatrix.setUsage(DynamicDrawUsage);
    this.mesh.frustumCulled = false;
    this.points = [];
    this.mesh.count = 0;
    this.next = 0; // the number of the segment that is replaced next
    stage.scene.add(this.mesh);
    this.onPaint = (context, camera) => this.#drawWithoutWebGL(context, camera);
    stage.overlays.add(this.onPaint);
  }

  /** Add a position of the tool. Steps too short to see are left out. */
  add(point) {
    const { size } = this.stage.data;
    const last = this.points.at(-1);
    if (last?.distanceTo(point) < 0.002 * size) return;
    if (last) {
      const along = new Vector3().subVectors(point, last);
      const length = along.length();
      const turned = new Quaternion().setFromUnitVectors(UP, along.divideScalar(length));
      const middle = new Vector3().lerpVectors(last, point, 0.5);
      const scale = new Vector3(0.005 * size, 1.02 * length, 0.005 * size);
      this.mesh.setMatrixAt(this.next, new Matrix4().compose(middle, turned, scale));
      this.mesh.instanceMatrix.needsUpdate = true;
      this.next = (this.next + 1) % MAX_SEGMENTS;
      this.mesh.count = Math.min(MAX_SEGMENTS, this.mesh.count + 1);
    }
    this.points.push(point.clone());
    if (this.points.length > MAX_SEGMENTS) this.points.shift();
  }

  applyTheme() {
    this.mesh.material.color.set(this.stage.theme.trail);
  }

  #drawWithoutWebGL(context, camera) {
    if (!this.stage.withoutWebGL || this.points.length < 2) return;
    const path = this.points.map((point) => camera.project(point, new Vector3())).map(({ x, y }) => [x, y]);
    strokeLines(context, [path], this.stage.theme.trail, 2);
  }

  dispose() {
    this.stage.overlays.delete(this.onPaint);
    this.mesh.removeFromParent();
    this.mesh.geometry.dispose();
    this.mesh.material.dispose();
    this.mesh.dispose();
  }
}
