// The camera is orthographic, so that parallel lines stay parallel and lengths can be compared, as in a drawing.
// Dragging rotates the view, shift-drag or two fingers pan it, the wheel or a pinch zooms; the keyboard does the same.
// As long as the picture does not have the focus, the wheel and a finger scroll the page.
import { OrthographicCamera, Vector3 } from 'three';

export const VIEWS = {
  '3-D': { azimuth: -60, elevation: 22 },
  front: { azimuth: -90, elevation: 0 },
  side: { azimuth: 0, elevation: 0 },
  top: { azimuth: -90, elevation: 90 },
};
const DEGREE = Math.PI / 180;
const FLIGHT_MS = 350; // duration of the animation from one named view to the next
const prefersReducedMotion = () => matchMedia('(prefers-reduced-motion: reduce)').matches;

export class Camera {
  /** @param room { centre, radius, look?, constant? }: the sphere in view, see kinlib/view/viewer/scene.py */
  constructor(room, changed) {
    this.room = room;
    this.changed = changed;
    this.threeCamera = new OrthographicCamera();
    this.threeCamera.up.set(0, 0, 1);
    this.width = 100; // until the picture has its size
    this.height = 78;
    Object.assign(this, { ...this.directionOf('3-D'), zoom: 1, target: new Vector3(...this.room.centre) });
    this.radius = this.room.radius;
    this.update();
  }

  /** The direction of a named view. The scene may define a 3-D view of its own in place of the usual one. */
  directionOf(name) {
    const [azimuth, elevation] = this.room.look ?? [];
    return name === '3-D' && this.room.look ? { azimuth, elevation } : VIEWS[name];
  }

  /** Zoom out as far as needed to keep points in view, because a moving arm must not leave the picture. */
  keepInView(points, margin) {
    if (this.room.constant) return; // the arm does not leave its home configuration
    const centre = new Vector3(...this.room.centre);
    const { width, height } = this;
    const half = [0, 1].map((k) => {
      const direction = new Vector3().setFromMatrixColumn(this.threeCamera.matrixWorld, k);
      const reach = Math.max(0, ...points.map((point) => Math.abs(point.clone().sub(centre).dot(direction))));
      return (reach * Math.min(width, height)) / (k ? height : width);
    });
    const far = Math.max(...half) + margin;
    if (far <= this.radius) return;
    this.radius = far;
    this.update();
  }

  resize(width, height) {
    Object.assign(this, { width, height });
    this.update();
  }

  /** Metres per pixel. */
  get scale() {
    return (2 * this.radius) / (Math.min(this.width, this.height) * this.zoom);
  }

  update() {
    const { threeCamera, scale, width, height, target } = this;
    const [a, e] = [this.azimuth * DEGREE, this.elevation * DEGREE];
    const away = new Vector3(Math.cos(e) * Math.cos(a), Math.cos(e) * Math.sin(a), Math.sin(e));
    // computed rather than fixed to z, because in the top view z is the direction of view
    threeCamera.up.set(-Math.sin(e) * Math.cos(a), -Math.sin(e) * Math.sin(a), Math.cos(e));
    const distance = 12 * this.radius;
    threeCamera.position.copy(target).addScaledVector(away, distance);
    threeCamera.lookAt(target);
    threeCamera.left = (-width * scale) / 2;
    threeCamera.right = (width * scale) / 2;
    threeCamera.top = (height * scale) / 2;
    threeCamera.bottom = (-height * scale) / 2;
    threeCamera.near = 0.01 * this.radius;
    threeCamera.far = 2 * distance;
    threeCamera.updateProjectionMatrix();
    threeCamera.updateMatrixWorld(true);
    this.changed();
  }

  /** Where a point in space appears, in pixels from the upper left corner; z increases away from the camera. */
  project(point, out = new Vector3()) {
    out.copy(point).project(this.threeCamera);
    return out.set(((out.x + 1) * this.width) / 2, ((1 - out.y) * this.height) / 2, out.z);
  }

  rotate(right, up) {
    this.azimuth -= right;
    this.elevation = Math.max(-90, Math.min(90, this.elevation + up));
    this.update();
  }

  pan(right, up) {
    const { elements } = this.threeCamera.matrixWorld;
    this.target.addScaledVector(new Vector3(elements[0], elements[1], elements[2]), -right * this.scale);
    this.target.addScaledVector(new Vector3(elements[4], elements[5], elements[6]), -up * this.scale);
    this.update();
  }

  zoomBy(factor) {
    this.zoom = Math.max(0.2, Math.min(20, this.zoom * factor));
    this.update();
  }

  /** Go to a named view, animated, or at once if the reader prefers reduced motion. */
  flyTo(name) {
    const goal = { ...this.directionOf(name), zoom: 1, centre: new Vector3(...this.room.centre) };
    const start = { azimuth: this.azimuth, elevation: this.elevation, zoom: this.zoom, centre: this.target.clone() };
    const turn = ((((goal.azimuth - start.azimuth) % 360) + 540) % 360) - 180; // the shorter of the two rotations
    const begun = performance.now();
    cancelAnimationFrame(this.flight);
    const fly = (now) => {
      const share = prefersReducedMotion() ? 1 : Math.min(1, Math.max(0, (now - begun) / FLIGHT_MS));
      const eased = share * share * (3 - 2 * share);
      this.azimuth = start.azimuth + eased * turn;
      this.elevation = start.elevation + eased * (goal.elevation - start.elevation);
      this.zoom = start.zoom * (goal.zoom / start.zoom) ** eased;
      this.target.lerpVectors(start.centre, goal.centre, eased);
      this.update();
      if (share < 1) this.flight = requestAnimationFrame(fly);
    };
    fly(begun);
  }
}

/**
 * Let pointer, wheel and keyboard move the camera. Returns a function that removes the listeners.
 * @param grab (x, y) takes hold of something in the picture: returns a function of the next places, or null
 */
export function orbitControls(camera, element, grab) {
  const fingers = new Map();
  let pressed = [0, 0];
  let held = null;
  const placeOf = ({ clientX, clientY }) => {
    const box = element.getBoundingClientRect();
    return [clientX - box.left, clientY - box.top];
  };
  const middle = () => {
    const all = [...fingers.values()];
    const [x, y] = [0, 1].map((k) => all.reduce((sum, p) => sum + p[k], 0) / all.length);
    return { x, y, spread: all.length > 1 ? Math.hypot(all[0][0] - all[1][0], all[0][1] - all[1][1]) : 0 };
  };
  const listeners = {
    pointerdown(event) {
      pressed = [event.clientX, event.clientY];
      element.focus({ preventScroll: true });
      element.setPointerCapture(event.pointerId);
      held = fingers.size || event.shiftKey || event.button ? null : grab(...placeOf(event));
      fingers.set(event.pointerId, [event.clientX, event.clientY]);
    },
    pointermove(event) {
      if (!fingers.has(event.pointerId)) return;
      const before = middle();
      fingers.set(event.pointerId, [event.clientX, event.clientY]);
      if (held) {
        held(...placeOf(event));
        return;
      }
      const now = middle();
      const [dx, dy] = [now.x - before.x, now.y - before.y];
      if (fingers.size > 1 && before.spread > 0) camera.zoomBy(now.spread / before.spread);
      if (fingers.size > 1 || event.shiftKey || event.buttons === 2) camera.pan(dx, -dy);
      else camera.rotate(0.4 * dx, 0.4 * dy);
    },
    pointerup(event) {
      fingers.delete(event.pointerId);
      held = null;
      if (Math.hypot(event.clientX - pressed[0], event.clientY - pressed[1]) > 4) return;
      const [x, y] = placeOf(event);
      const detail = { x, y };
      element.dispatchEvent(new CustomEvent('tap', { detail })); // pressed but not dragged: modes use it for picking
    },
    pointercancel(event) {
      fingers.delete(event.pointerId);
      held = null;
    },
    wheel(event) {
      if (document.activeElement !== element && !event.ctrlKey) return;
      event.preventDefault();
      camera.zoomBy(Math.exp(-event.deltaY * (event.ctrlKey ? 0.01 : 0.0015)));
    },
    keydown(event) {
      const act = keyActions(camera)[`${event.shiftKey ? 'Shift ' : ''}${event.key}`] ?? keyActions(camera)[event.key];
      if (!act || event.ctrlKey || event.metaKey || event.altKey) return;
      event.preventDefault();
      act();
    },
    contextmenu: (event) => event.preventDefault(),
  };
  const entries = Object.entries(listeners);
  for (const [name, listener] of entries) element.addEventListener(name, listener, { passive: false });
  return () => {
    cancelAnimationFrame(camera.flight);
    for (const [name, listener] of entries) element.removeEventListener(name, listener);
  };
}

const keyActions = (camera) => ({
  ArrowLeft: () => camera.rotate(-6, 0),
  ArrowRight: () => camera.rotate(6, 0),
  ArrowUp: () => camera.rotate(0, 6),
  ArrowDown: () => camera.rotate(0, -6),
  'Shift ArrowLeft': () => camera.pan(-20, 0),
  'Shift ArrowRight': () => camera.pan(20, 0),
  'Shift ArrowUp': () => camera.pan(0, 20),
  'Shift ArrowDown': () => camera.pan(0, -20),
  '+': () => camera.zoomBy(1.15),
  '=': () => camera.zoomBy(1.15),
  '-': () => camera.zoomBy(1 / 1.15),
  0: () => camera.flyTo('3-D'),
  1: () => camera.flyTo('front'),
  2: () => camera.flyTo('side'),
  3: () => camera.flyTo('top'),
});
