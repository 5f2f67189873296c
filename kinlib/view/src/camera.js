// The eye: orthographic, so that parallel lines stay parallel and lengths compare, as in a drawing.
// Drag turns, shift-drag or two fingers move, wheel or pinch zooms; the same by keys. Until the picture has the focus,
// wheel and finger scroll the page.
import { OrthographicCamera, Vector3 } from 'three';

export const VIEWS = {
  '3-D': { azimuth: -60, elevation: 22 },
  front: { azimuth: -90, elevation: 0 },
  side: { azimuth: 0, elevation: 0 },
  top: { azimuth: -90, elevation: 90 },
};
const DEGREE = Math.PI / 180;
const FLIGHT = 350; // milliseconds from one named view to the next
const still = () => matchMedia('(prefers-reduced-motion: reduce)').matches;

export class Eye {
  /** @param room { centre, radius }: the ball that should be in view */
  constructor(room, changed) {
    this.room = room;
    this.changed = changed;
    this.camera = new OrthographicCamera();
    this.camera.up.set(0, 0, 1);
    this.width = 1;
    this.height = 1;
    this.home();
  }

  home() {
    Object.assign(this, { ...this.named('3-D'), zoom: 1, target: new Vector3(...this.room.centre) });
    this.radius = this.room.radius;
    this.place();
  }

  /** The direction of a named view. Where the room says so, its own first look takes the place of the usual one. */
  named(name) {
    const [azimuth, elevation] = this.room.look ?? [];
    return name === '3-D' && this.room.look ? { azimuth, elevation } : VIEWS[name];
  }

  /** Step back as far as it takes to keep points in view: an arm at play shall not leave the picture. */
  keep(points, margin) {
    if (this.room.snug) return; // an arm that stays at home
    const centre = new Vector3(...this.room.centre);
    const far = Math.max(0, ...points.map((point) => point.distanceTo(centre))) + margin;
    if (far <= this.radius) return;
    this.radius = far;
    this.place();
  }

  resize(width, height) {
    Object.assign(this, { width, height });
    this.place();
  }

  /** Metres of space a pixel. */
  get scale() {
    return (2 * this.radius) / (Math.min(this.width, this.height) * this.zoom);
  }

  place() {
    const { camera, scale, width, height, target } = this;
    const [a, e] = [this.azimuth * DEGREE, this.elevation * DEGREE];
    const away = new Vector3(Math.cos(e) * Math.cos(a), Math.cos(e) * Math.sin(a), Math.sin(e));
    // seen from right above, "up" is where the eye would fall back to
    camera.up.set(-Math.sin(e) * Math.cos(a), -Math.sin(e) * Math.sin(a), Math.cos(e));
    const distance = 12 * this.radius;
    camera.position.copy(target).addScaledVector(away, distance);
    camera.lookAt(target);
    camera.left = (-width * scale) / 2;
    camera.right = (width * scale) / 2;
    camera.top = (height * scale) / 2;
    camera.bottom = (-height * scale) / 2;
    camera.near = 0.01 * this.radius;
    camera.far = 2 * distance;
    camera.updateProjectionMatrix();
    camera.updateMatrixWorld(true);
    this.changed();
  }

  /** Where a point of space appears, in pixels from the upper left corner; z grows away from the eye. */
  project(point, out = new Vector3()) {
    out.copy(point).project(this.camera);
    return out.set(((out.x + 1) * this.width) / 2, ((1 - out.y) * this.height) / 2, out.z);
  }

  turn(right, up) {
    this.azimuth -= right;
    this.elevation = Math.max(-90, Math.min(90, this.elevation + up));
    this.place();
  }

  move(right, up) {
    const { elements } = this.camera.matrixWorld;
    this.target.addScaledVector(new Vector3(elements[0], elements[1], elements[2]), -right * this.scale);
    this.target.addScaledVector(new Vector3(elements[4], elements[5], elements[6]), -up * this.scale);
    this.place();
  }

  magnify(factor) {
    this.zoom = Math.max(0.2, Math.min(20, this.zoom * factor));
    this.place();
  }

  /** Go to a named view: on a short flight, or at once for who prefers reduced motion. */
  look(name) {
    const goal = { ...this.named(name), zoom: 1, centre: new Vector3(...this.room.centre) };
    const start = { azimuth: this.azimuth, elevation: this.elevation, zoom: this.zoom, centre: this.target.clone() };
    const turn = ((((goal.azimuth - start.azimuth) % 360) + 540) % 360) - 180; // the shorter way round
    const begun = performance.now();
    cancelAnimationFrame(this.flight);
    const fly = (now) => {
      const share = still() ? 1 : Math.min(1, Math.max(0, (now - begun) / FLIGHT));
      const eased = share * share * (3 - 2 * share);
      this.azimuth = start.azimuth + eased * turn;
      this.elevation = start.elevation + eased * (goal.elevation - start.elevation);
      this.zoom = start.zoom * (goal.zoom / start.zoom) ** eased;
      this.target.lerpVectors(start.centre, goal.centre, eased);
      this.place();
      if (share < 1) this.flight = requestAnimationFrame(fly);
    };
    fly(begun);
  }
}

/** Let hand and keys move the eye. Returns how to stop listening. */
export function steer(eye, element) {
  const fingers = new Map();
  let pressed = [0, 0];
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
      fingers.set(event.pointerId, [event.clientX, event.clientY]);
    },
    pointermove(event) {
      if (!fingers.has(event.pointerId)) return;
      const before = middle();
      fingers.set(event.pointerId, [event.clientX, event.clientY]);
      const now = middle();
      const [dx, dy] = [now.x - before.x, now.y - before.y];
      if (fingers.size > 1 && before.spread > 0) eye.magnify(now.spread / before.spread);
      if (fingers.size > 1 || event.shiftKey || event.buttons === 2) eye.move(dx, -dy);
      else eye.turn(0.4 * dx, 0.4 * dy);
    },
    pointerup(event) {
      fingers.delete(event.pointerId);
      if (Math.hypot(event.clientX - pressed[0], event.clientY - pressed[1]) > 4) return;
      const box = element.getBoundingClientRect();
      const detail = { x: event.clientX - box.left, y: event.clientY - box.top };
      element.dispatchEvent(new CustomEvent('tap', { detail })); // pressed and not dragged: for who picks
    },
    pointercancel: (event) => fingers.delete(event.pointerId),
    wheel(event) {
      if (document.activeElement !== element && !event.ctrlKey) return;
      event.preventDefault();
      eye.magnify(Math.exp(-event.deltaY * (event.ctrlKey ? 0.01 : 0.0015)));
    },
    keydown(event) {
      const act = keys(eye)[`${event.shiftKey ? 'Shift ' : ''}${event.key}`] ?? keys(eye)[event.key];
      if (!act || event.ctrlKey || event.metaKey || event.altKey) return;
      event.preventDefault();
      act();
    },
    contextmenu: (event) => event.preventDefault(),
  };
  const entries = Object.entries(listeners);
  for (const [name, listener] of entries) element.addEventListener(name, listener, { passive: false });
  return () => {
    cancelAnimationFrame(eye.flight);
    for (const [name, listener] of entries) element.removeEventListener(name, listener);
  };
}

const keys = (eye) => ({
  ArrowLeft: () => eye.turn(-6, 0),
  ArrowRight: () => eye.turn(6, 0),
  ArrowUp: () => eye.turn(0, 6),
  ArrowDown: () => eye.turn(0, -6),
  'Shift ArrowLeft': () => eye.move(-20, 0),
  'Shift ArrowRight': () => eye.move(20, 0),
  'Shift ArrowUp': () => eye.move(0, 20),
  'Shift ArrowDown': () => eye.move(0, -20),
  '+': () => eye.magnify(1.15),
  '=': () => eye.magnify(1.15),
  '-': () => eye.magnify(1 / 1.15),
  0: () => eye.look('3-D'),
  1: () => eye.look('front'),
  2: () => eye.look('side'),
  3: () => eye.look('top'),
});
