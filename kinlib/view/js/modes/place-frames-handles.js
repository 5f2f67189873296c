// The handles that can be picked: ends of axes for z, rings on points for the origin, a dial for x.
import { disc, strokeLines } from '../render/pen.js';
import { add, near, rotatePerpendicular } from '../vectors.js';

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
      const chosen = z && near(along, z);
      disc(context, x, y, 10, chosen ? theme.axis : theme.paper, theme.axis, 2);
      drawArrow(context, x, y, angle, chosen ? theme.paper : theme.axis);
    }
  },
  origin({ context, theme, data, picker, origin }) {
    for (const { at } of data.points)
      disc(context, ...picker.toPixels(at), 6.5, origin && near(at, origin) ? theme.ink : theme.paper, theme.ink, 2);
    if (origin) disc(context, ...picker.toPixels(origin), 11, null, theme.normal, 3);
  },
  x({ context, theme, picker, z, origin, x }) {
    if (!z || !origin) return;
    const u = picker.namedDirections(z)[0]?.along ?? x;
    if (!u) return;
    const tip = (along) => picker.toPixels(add(origin, along, picker.radius));
    const dial = Array.from({ length: 73 }, (_, k) => tip(rotatePerpendicular(u, z, (TURN * k) / 72)));
    context.setLineDash([2, 4]);
    strokeLines(context, [dial], theme.x, 2);
    context.setLineDash([]);
    for (const { along } of picker.namedDirections(z))
      disc(context, ...tip(along), 7, x && near(along, x) ? theme.x : theme.paper, theme.x, 2);
    if (x) disc(context, ...tip(x), 12, null, theme.normal, 3);
  },
};

/** A cross at a joint where a rule is broken. */
function drawCross(context, x, y, theme) {
  disc(context, x, y, 11, theme.x, theme.x, 2);
  const strokes = [-4.5, 4.5].map((half) => [
    [x - 4.5, y - half],
    [x + 4.5, y + half],
  ]);
  strokeLines(context, strokes, theme.paper, 2.5);
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
  disc(context, x, y, 13, null, theme.normal, 3);
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
