// The handles that can be picked: ends of axes for z, rings on points for the origin, a dial for x.
import { add, cross } from '../vectors.js';

const TURN = 2 * Math.PI;

/**
 * @param picker see place-frames-picking.js
 * @param selected () -> { i, part, z, origin, x }
 * @param broken () -> the points of joints at which a rule is broken
 */
export function pickHandles({ stage, data, picker, selected, broken }) {
  const overlay = (context) => {
    const { part } = selected();
    context.save();
    for (const at of broken()) drawCross(context, ...picker.toPixels(at), stage.theme);
    DRAW_HANDLES[part]({ context, theme: stage.theme, data, picker, ...selected() });
    drawTooltip(context, picker, stage);
    context.restore();
  };
  stage.overlays.add(overlay);
  let otherBoxes = null;
  return {
    /** Keep labels from covering the handles. */
    reserveHandles() {
      otherBoxes ??= stage.reservedBoxes;
      stage.reservedBoxes = () => [
        ...otherBoxes(),
        ...{ z: data.z, origin: data.points, x: [] }[selected().part].map(({ at }) => box(picker.toPixels(at), 9)),
      ];
    },
    dispose: () => stage.overlays.delete(overlay),
  };
}

const box = ([x, y], half) => ({ left: x - half, right: x + half, top: y - half, bottom: y + half });

const DRAW_HANDLES = {
  z({ context, theme, data, picker, z }) {
    for (const { at, along } of data.z) {
      const [x, y] = picker.toPixels(at);
      const [dx, dy] = picker.toPixels(add(at, along, 1e-3 * picker.radius));
      const angle = Math.hypot(dx - x, dy - y) > 1e-5 ? Math.atan2(dy - y, dx - x) : null;
      drawDisc(context, x, y, 10, theme, theme.axis, z && same(along, z));
      drawArrow(context, x, y, angle, z && same(along, z) ? theme.paper : theme.axis);
    }
  },
  origin({ context, theme, data, picker, origin }) {
    for (const { at } of data.points)
      drawDisc(context, ...picker.toPixels(at), 6.5, theme, theme.ink, origin && same(at, origin));
    if (origin) drawCircle(context, ...picker.toPixels(origin), 11, theme.normal, 3);
  },
  x({ context, theme, picker, z, origin, x }) {
    if (!z || !origin) return;
    const u = picker.namedDirections(z)[0]?.along ?? x;
    if (!u) return;
    const v = cross(z, u);
    context.beginPath();
    for (let k = 0; k <= 72; k += 1) {
      const angle = (TURN * k) / 72;
      const at = add(add(origin, u, picker.radius * Math.cos(angle)), v, picker.radius * Math.sin(angle));
      context[k ? 'lineTo' : 'moveTo'](...picker.toPixels(at));
    }
    context.strokeStyle = theme.x;
    context.setLineDash([2, 4]);
    context.lineWidth = 2;
    context.stroke();
    context.setLineDash([]);
    for (const { along } of picker.namedDirections(z))
      drawDisc(context, ...picker.toPixels(add(origin, along, picker.radius)), 7, theme, theme.x, x && same(along, x));
    if (x) drawCircle(context, ...picker.toPixels(add(origin, x, picker.radius)), 12, theme.normal, 3);
  },
};

function drawDisc(context, x, y, radius, theme, colour, filled) {
  context.beginPath();
  context.arc(x, y, radius, 0, TURN);
  context.fillStyle = filled ? colour : theme.paper;
  context.fill();
  context.strokeStyle = colour;
  context.lineWidth = 2;
  context.stroke();
}

function drawCircle(context, x, y, radius, colour, width) {
  context.beginPath();
  context.arc(x, y, radius, 0, TURN);
  context.strokeStyle = colour;
  context.lineWidth = width;
  context.stroke();
}

/** A cross at a joint where a rule is broken. */
function drawCross(context, x, y, theme) {
  drawDisc(context, x, y, 11, theme, theme.x, true);
  context.strokeStyle = theme.paper;
  context.lineWidth = 2.5;
  context.beginPath();
  for (const side of [-1, 1]) {
    context.moveTo(x - 4.5, y - 4.5 * side);
    context.lineTo(x + 4.5, y + 4.5 * side);
  }
  context.stroke();
}

/** The direction of z as an arrow; a dot if z points towards the camera or away from it. */
function drawArrow(context, x, y, angle, colour) {
  context.save();
  context.translate(x, y);
  context.fillStyle = colour;
  context.beginPath();
  if (angle === null) context.arc(0, 0, 2.5, 0, TURN);
  else {
    context.rotate(angle);
    context.moveTo(6, 0);
    context.lineTo(-4, 4.5);
    context.lineTo(-4, -4.5);
  }
  context.fill();
  context.restore();
}

/** The name of the handle under the pointer, beside it. */
function drawTooltip(context, picker, stage) {
  const found = picker.hovered();
  if (!found) return;
  const [x, y] = picker.toPixels(found.at);
  const { theme, width } = stage;
  drawCircle(context, x, y, 13, theme.normal, 3);
  context.font = '600 13px "Segoe UI", "Helvetica Neue", "DejaVu Sans", Arial, sans-serif';
  const [first, second, ...more] = found.text.split('; ');
  const text = [first, ...(second ? [second] : []), ...(more.length ? ['…'] : [])].join('; ');
  const wide = context.measureText(text).width + 14;
  const left = Math.max(4, Math.min(width - wide - 4, x - wide / 2));
  const top = y > 52 ? y - 44 : y + 20;
  context.fillStyle = theme.ink;
  context.beginPath();
  context.roundRect(left, top, wide, 24, 5);
  context.fill();
  context.fillStyle = theme.paper;
  context.textAlign = 'left';
  context.textBaseline = 'middle';
  context.fillText(text, left + 7, top + 12);
}

function same(p, q) {
  return p.every((value, k) => Math.abs(value - q[k]) < 1e-9);
}
