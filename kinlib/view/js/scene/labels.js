// Labels are drawn on the 2-D canvas over the solids, each beside its point, where it covers as little as possible.
// A label that has to be placed far from its point gets a thin leader line.
import { Vector3 } from 'three';
import { haloText, strokeLines } from '../render/pen.js';

const FONT_SIZE_PX = 14;
const RING_RADII_PX = [12, 19, 29, 42, 58, 78, 100];
const RING_ANGLES_DEG = [0, 30, -30, 60, -60, 95, -95, 135, -135, 180];
const OUTSIDE_MARGIN_PX = 40; // points farther outside the picture get no label
const FONT = '"Segoe UI", "Helvetica Neue", "DejaVu Sans", Arial, sans-serif';

const at = new Vector3();
const back = new Vector3();

export function fontOf(label, size = FONT_SIZE_PX) {
  return `${label.italic ? 'italic ' : ''}600 ${size}px ${FONT}`;
}

/**
 * Place labels and draw them.
 * @param labels [{ at, from?, body, text, sub, colour, weight }]
 * @param taken boxes that labels must not cover
 * @returns the box of each label, with its name
 */
export function drawLabels(context, labels, taken, camera, { halo, leader }) {
  const order = labels
    .map((label) => measureLabel(context, label, camera))
    .sort((a, b) => b.label.weight - a.label.weight);
  const anchors = order.map(({ x, y }) => [x, y]);
  const placed = [];
  for (const item of order) {
    const box = placeLabel(item, taken, anchors, camera);
    if (!box) continue;
    taken.push(box);
    placed.push({ ...box, name: item.label.text + item.label.sub });
    if (item.label.lastPlace.ring > 1) drawLeader(context, [item.x, item.y], box, leader);
    drawText(context, item, box, halo);
  }
  return placed;
}

function measureLabel(context, label, camera) {
  at.set(...label.at).applyMatrix4(label.body.matrixWorld);
  camera.project(at, at);
  const [x, y] = [at.x, at.y];
  let away = Math.PI / 4; // up and to the right if the label has no direction of its own
  let [dx, dy] = [0, 0];
  if (label.from) {
    back.set(...label.from).applyMatrix4(label.body.matrixWorld);
    camera.project(back, back);
    [dx, dy] = [x - back.x, back.y - y];
    if (Math.hypot(dx, dy) > 3) away = Math.atan2(dy, dx);
  }
  if (label.width === undefined) {
    context.font = fontOf(label);
    label.main = context.measureText(label.text).width;
    context.font = fontOf(label, 0.72 * FONT_SIZE_PX);
    label.width = label.main + (label.sub ? context.measureText(label.sub).width + 0.5 : 0);
  }
  return { label, x, y, away };
}

/** The free place of least cost. The place of the last frame costs less, so that labels do not jump. */
function placeLabel(item, taken, anchors, camera) {
  const { label, x, y, away } = item;
  if (
    x < -OUTSIDE_MARGIN_PX ||
    y < -OUTSIDE_MARGIN_PX ||
    x > camera.width + OUTSIDE_MARGIN_PX ||
    y > camera.height + OUTSIDE_MARGIN_PX
  )
    return null;
  const [w, h] = [label.width / 2 + 1, 0.5 * FONT_SIZE_PX];
  let best = null;
  let least = label.weight > 1 ? Infinity : 12; // a label y may be left out, because x and z determine it
  for (const [ring, radius] of RING_RADII_PX.entries()) {
    for (const [turn, degrees] of RING_ANGLES_DEG.entries()) {
      const angle = away + (degrees * Math.PI) / 180;
      // a label at the border is moved back into the picture
      const cx = Math.max(w + 2, Math.min(camera.width - w - 2, x + Math.cos(angle) * (radius + w - 4)));
      const cy = Math.max(h + 2, Math.min(camera.height - h - 2, y - Math.sin(angle) * radius));
      const box = { left: cx - w, right: cx + w, top: cy - h, bottom: cy + h };
      if (taken.some((other) => overlap(box, other))) continue;
      let cost = 2.2 * ring + Math.abs(degrees) / 60;
      if (cost - 0.8 > least) continue;
      // a place that covers another label's point costs more
      for (const [px, py] of anchors) {
        if (px > box.left - 4 && px < box.right + 4 && py > box.top - 4 && py < box.bottom + 4) cost += 2;
      }
      if (label.lastPlace?.ring === ring && label.lastPlace.turn === turn) cost -= 0.8;
      if (cost < least) [best, least] = [{ ...box, ring, turn }, cost];
    }
  }
  label.lastPlace = best && { ring: best.ring, turn: best.turn };
  return best;
}

function drawLeader(context, [x, y], box, colour) {
  const end = [Math.max(box.left, Math.min(box.right, x)), Math.max(box.top, Math.min(box.bottom, y))];
  strokeLines(context, [[[x, y], end]], colour, 1);
}

function drawText(context, { label }, box, halo) {
  const middle = (box.top + box.bottom) / 2;
  const pieces = [
    [label.text, FONT_SIZE_PX, box.left + 1, middle],
    [label.sub, 0.72 * FONT_SIZE_PX, box.left + 1.5 + label.main, middle + 4],
  ];
  context.textAlign = 'left';
  context.textBaseline = 'middle';
  context.lineJoin = 'round';
  for (const [text, size, left, y] of pieces) {
    if (!text) continue;
    context.font = fontOf(label, size);
    context.strokeStyle = halo;
    context.lineWidth = 3.5;
    context.strokeText(text, left, y);
  }
  for (const [text, size, left, y] of pieces) {
    if (!text) continue;
    context.font = fontOf(label, size);
    context.fillStyle = label.colour;
    context.fillText(text, left, y);
  }
}

const DIMENSION_OFFSETS_PX = [22, -22, 40, -40];

/** Draw dimension lines with ticks, each with its length. Returns the boxes of the numbers. */
export function drawDimensions(context, dimensions, camera, halo) {
  const taken = [];
  for (const { body, from, to, text, colour } of dimensions) {
    const p = camera.project(at.set(...from).applyMatrix4(body.matrixWorld), new Vector3());
    const q = camera.project(back.set(...to).applyMatrix4(body.matrixWorld), new Vector3());
    const length = Math.hypot(q.x - p.x, q.y - p.y);
    if (length < 22) continue; // seen end-on, where a number could not be read as this length
    const flip = q.x - p.x > 0 ? 1 : -1;
    const [nx, ny] = [(-(q.y - p.y) / length) * flip, ((q.x - p.x) / length) * flip];
    context.font = fontOf({}, 12);
    const half = context.measureText(text).width / 2 + 2;
    const boxes = DIMENSION_OFFSETS_PX.map((off) => {
      const [x, y] = [(p.x + q.x) / 2 + off * nx, (p.y + q.y) / 2 + off * ny];
      return { off, x, y, left: x - half, right: x + half, top: y - 8, bottom: y + 8 };
    });
    const { off, ...box } = boxes.find((one) => !taken.some((other) => overlap(one, other))) ?? boxes[0];
    taken.push(box);
    drawDimensionLine(context, p, q, [nx, ny], off, colour);
    context.textAlign = 'center';
    context.textBaseline = 'middle';
    haloText(context, text, box.x, box.y, colour, halo, 5);
  }
  return taken;
}

function drawDimensionLine(context, p, q, [nx, ny], off, colour) {
  const beside = ({ x, y }, far) => [x + far * nx, y + far * ny];
  const ticks = [p, q].map((end) => [beside(end, off - 5), beside(end, off + 5)]);
  strokeLines(context, [...ticks, [beside(p, off), beside(q, off)]], colour, 1);
}

function overlap(a, b) {
  return a.left < b.right + 2 && b.left < a.right + 2 && a.top < b.bottom + 1 && b.top < a.bottom + 1;
}
