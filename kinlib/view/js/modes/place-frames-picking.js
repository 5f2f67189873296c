// Picking in the picture: the handle under the pointer, and drags along an axis or around a dial.
// The camera is orthographic, so lines in space are lines in the picture, and ratios along a line are preserved.
import { Vector3 } from 'three';
import { roundStep } from '../render/stage.js';
import { perpendicularTo } from '../scene/parts.js';
import { add, cross, dot, minus, norm, rotatePerpendicular } from '../vectors.js';

const HANDLE_RADIUS_PX = 18; // around a handle
const POINT_RADIUS_PX = 14; // around a point, at which an origin on an axis snaps
const AXIS_DISTANCE_PX = 12;
const RING_STEP_DEG = 5; // on the dial, away from named directions
const DIRECTION_SNAP_DEG = 8; // around a named direction
const DEGREE = Math.PI / 180;

/**
 * @param selected () -> { part, z, origin, x } of the selected frame
 * @param setPart (value, final, advance) sets the selected part, see place-frames.js
 */
export function framePicker({ stage, data, selected, setPart }) {
  const { canvas } = stage;
  const { size } = stage.data;
  const radius = 0.3 * size;
  const grid = roundStep(size / 200);
  let hovered = null;
  let dragging = false;

  const toPixels = (point) => {
    const { x, y } = stage.camera.project(new Vector3(...point), new Vector3());
    return [x, y];
  };
  const distance = (p, q) => Math.hypot(p[0] - q[0], p[1] - q[1]);
  const nearest = (list, pointer, reach) =>
    list
      .map((item) => ({ ...item, off: distance(toPixels(item.at), pointer) }))
      .filter(({ off }) => off < reach)
      .sort((a, b) => a.off - b.off)[0];

  /** The point of an axis that is nearest to the pointer, rounded to the grid. */
  function onAxis(axis, pointer) {
    const start = toPixels(axis.point);
    const way = minus(toPixels(add(axis.point, axis.along)), start);
    const length = dot(way, way);
    if (length < 1) return null; // seen end-on
    const [low, high] = ['from', 'to'].map((end) => dot(minus(axis[end], axis.point), axis.along));
    const raw = dot(minus(pointer, start), way) / length;
    const share = Math.round(Math.max(low, Math.min(high, raw)) / grid) * grid;
    const at = add(axis.point, axis.along, share);
    return { value: at, at, off: distance(toPixels(at), pointer), share };
  }

  function originAt(pointer, only) {
    const points = only
      ? data.points.filter(({ at }) => norm(cross(minus(at, only.point), only.along)) < 1e-9)
      : data.points;
    const point = nearest(points, pointer, only ? 10 : POINT_RADIUS_PX);
    if (point) return { ...point, value: point.at };
    const found = (only ? [only] : data.axes)
      .map((axis) => ({ axis, ...onAxis(axis, pointer) }))
      .filter(({ value, off }) => value && (only || off < AXIS_DISTANCE_PX))
      .sort((a, b) => a.off - b.off)[0];
    if (!found) return found;
    const number = data.axes.indexOf(found.axis) + 1;
    return { ...found, text: `on axis ${number}, ${Number(found.share.toPrecision(4))} m from joint ${number}` };
  }

  /** The named directions perpendicular to z. */
  const namedDirections = (z) => data.x.filter(({ along }) => Math.abs(dot(along, z)) < 1e-9);

  function xAt(pointer, duringDrag) {
    const { z, origin } = selected();
    if (!z || !origin) return null;
    const u = namedDirections(z)[0]?.along ?? perpendicularTo(z);
    const v = cross(z, u);
    const hub = toPixels(origin);
    const [p, q] = [u, v].map((along) => minus(toPixels(add(origin, along, radius)), hub));
    const det = p[0] * q[1] - p[1] * q[0];
    const tips = namedDirections(z).map((one) => ({ ...one, at: add(origin, one.along, radius), value: one.along }));
    const tip = nearest(tips, pointer, duringDrag ? 0 : HANDLE_RADIUS_PX);
    const edgeOn = Math.abs(det) < (0.04 * radius ** 2) / stage.camera.scale ** 2;
    if (tip || edgeOn) return tip ?? null;
    const off = minus(pointer, hub);
    const [a, b] = [(off[0] * q[1] - off[1] * q[0]) / det, (p[0] * off[1] - p[1] * off[0]) / det];
    const out = Math.hypot(a, b);
    if (!duringDrag && (out < 0.5 || out > 1.35)) return null;
    const angle = Math.atan2(b, a) / DEGREE;
    const close = tips
      .map((one) => ({
        ...one,
        miss: Math.abs(((Math.atan2(dot(one.along, v), dot(one.along, u)) / DEGREE - angle + 540) % 360) - 180),
      }))
      .filter(({ miss }) => miss < DIRECTION_SNAP_DEG)
      .sort((one, other) => one.miss - other.miss)[0];
    if (close) return close;
    const value = rotatePerpendicular(u, z, Math.round(angle / RING_STEP_DEG) * RING_STEP_DEG * DEGREE);
    return {
      value,
      at: add(origin, value, radius),
      text: `along (${value.map((number) => Number(number.toFixed(3))).join(', ')})`,
    };
  }

  const FIND_HANDLE = {
    z: (pointer) => {
      const found = nearest(data.z, pointer, HANDLE_RADIUS_PX);
      return found && { ...found, value: found.along };
    },
    origin: (pointer) => originAt(pointer),
    x: (pointer) => xAt(pointer),
  };
  /** The axis through the origin; if there are several, the one along z. */
  function axisOfOrigin() {
    const { origin, z } = selected();
    const through = data.axes.filter(({ point, along }) => norm(cross(minus(origin, point), along)) < 1e-9);
    return through.find(({ along }) => z && norm(cross(along, z)) < 1e-9) ?? through[0];
  }
  /** Whether the pointer is on the origin of the frame or on the tip of its x, whichever is selected. */
  function isOnDraggedPart(pointer) {
    const { part, origin, x } = selected();
    if (part === 'origin' && origin && axisOfOrigin()) return distance(toPixels(origin), pointer) < HANDLE_RADIUS_PX;
    return part === 'x' && origin && x ? distance(toPixels(add(origin, x, radius)), pointer) < HANDLE_RADIUS_PX : false;
  }
  const dragged = (pointer) => (selected().part === 'x' ? xAt(pointer, true) : originAt(pointer, axisOfOrigin()));
  const pointerOf = (event) => {
    const box = canvas.getBoundingClientRect();
    return [event.clientX - box.left, event.clientY - box.top];
  };

  function release(event) {
    if (!dragging) return;
    dragging = false;
    event.stopImmediatePropagation();
    setPart(selected()[selected().part], true);
  }
  const listeners = {
    pointerdown(event) {
      if (event.button || !isOnDraggedPart(pointerOf(event))) return;
      dragging = true;
      event.stopImmediatePropagation(); // otherwise the camera would rotate
      canvas.focus({ preventScroll: true });
      canvas.setPointerCapture(event.pointerId);
    },
    pointermove(event) {
      const found = dragging
        ? dragged(pointerOf(event))
        : !event.buttons && FIND_HANDLE[selected().part](pointerOf(event));
      const free = found ? 'pointer' : '';
      canvas.style.cursor = dragging ? 'grabbing' : free;
      if (dragging && found) setPart(found.value, false);
      if (found?.text !== hovered?.text || dragging) {
        hovered = found || null;
        stage.draw();
      }
      if (dragging) event.stopImmediatePropagation();
    },
    pointerup: release,
    pointercancel: release, // the browser has started to scroll the page
    pointerleave() {
      hovered = null;
      stage.draw();
    },
    tap({ detail: { x, y } }) {
      const found = FIND_HANDLE[selected().part]([x, y]);
      if (found) setPart(found.value, true, true);
    },
  };
  for (const [name, listener] of Object.entries(listeners)) canvas.addEventListener(name, listener, { capture: true });
  return {
    radius,
    toPixels,
    namedDirections,
    hovered: () => hovered,
    clearHover: () => {
      hovered = null;
    },
    dispose: () => {
      for (const [name, listener] of Object.entries(listeners))
        canvas.removeEventListener(name, listener, { capture: true });
    },
  };
}
