// Labels are drawn on the 2-D canvas over the solids, each at the nearest free place around its point. One that finds no place
// gives way, and one that is placed far from its point gets a thin leader line.
import { Vector3 } from 'three';
import { haloText, strokeLines } from '../render/pen.js';

const FONT_SIZE_PX = 14;
const SUB_SIZE_PX = 0.72 * FONT_SIZE_PX;
const RING_RADII_PX = [12, 19, 29, 42, 58, 78, 100];
const RING_ANGLES_DEG = [0, 30, -30, 60, -60, 95, -95, 135, -135, 180];
const OUTSIDE_MARGIN_PX = 40; // points farther outside the picture get no label
const FONT = '"Segoe UI", "Helvetica Neue", "DejaVu Sans", Arial, sans-serif';
const PLACES = RING_RADII_PX.flatMap((radius, ring) =>
  RING_ANGLES_DEG.map((degrees) => ({ radius, ring, angle: (degrees * Math.PI) / 180 })),
);

export function fontOf(label, size = FONT_SIZE_PX) {
  return `${label.italic ? 'italic ' : ''}600 ${size}px ${FONT}`;
}

/**
 * Place labels, those with more weight first, and draw them.
 * @param labels [{ at, from?, body, text, sub, colour, weight }]
 * @param taken boxes that labels must not cover
 * @returns the box of each label, with its name
 */
export function drawLabels(context, labels, taken, camera, theme) {
  const placed = [];
  for (const label of [...labels].sort((a, b) => b.weight - a.weight)) {
    const { x, y, away } = anchorOf(label, camera);
    const box = placeLabel(context, label, [x, y], away, taken, camera);
    if (!box) continue;
    taken.push(box);
    placed.push({ ...box, name: label.text + label.sub });
    const end = [Math.max(box.left, Math.min(box.right, x)), Math.max(box.top, Math.min(box.bottom, y))];
    if (label.place.ring > 1) strokeLines(context, [[[x, y], end]], theme.quiet, 1);
    drawText(context, label, box, theme.paper);
  }
  return placed;
}

/** Where a label's point is in the picture, and in which direction the label should be: away from another point. */
function anchorOf({ at, from, body }, camera) {
  const onPage = (point) => camera.project(new Vector3(...point).applyMatrix4(body.matrixWorld), new Vector3());
  const { x, y } = onPage(at);
  const back = from ? onPage(from) : { x, y };
  const far = Math.hypot(x - back.x, y - back.y) > 3;
  return { x, y, away: far ? Math.atan2(back.y - y, x - back.x) : Math.PI / 4 };
}

/** The first free place, or the one of the last picture if that is free, so that labels do not jump. */
function placeLabel(context, label, [x, y], away, taken, { width, height }) {
  const out = OUTSIDE_MARGIN_PX;
  if (x < -out || y < -out || x > width + out || y > height + out) return null;
  if (label.width === undefined) {
    context.font = fontOf(label);
    label.main = context.measureText(label.text).width;
    context.font = fontOf(label, SUB_SIZE_PX);
    label.width = label.main + (label.sub ? context.measureText(label.sub).width + 0.5 : 0);
  }
  const [w, h] = [label.width / 2 + 1, 0.5 * FONT_SIZE_PX];
  const boxAt = ({ radius, angle }) => {
    // a label at the border is moved back into the picture
    const cx = Math.max(w + 2, Math.min(width - w - 2, x + Math.cos(away + angle) * (radius + w - 4)));
    const cy = Math.max(h + 2, Math.min(height - h - 2, y - Math.sin(away + angle) * radius));
    return { left: cx - w, right: cx + w, top: cy - h, bottom: cy + h };
  };
  const isFree = (place) => !taken.some((other) => overlap(boxAt(place), other));
  label.place = [...(label.place ? [label.place] : []), ...PLACES].find(isFree);
  return label.place && boxAt(label.place);
}

function drawText(context, label, { left, top, bottom }, halo) {
  const middle = (top + bottom) / 2;
  context.textAlign = 'left';
  context.textBaseline = 'middle';
  context.lineJoin = 'round';
  context.font = fontOf(label);
  haloText(context, label.text, left + 1, middle, label.colour, halo);
  context.font = fontOf(label, SUB_SIZE_PX);
  if (label.sub) haloText(context, label.sub, left + 1.5 + label.main, middle + 4, label.colour, halo);
}

function overlap(a, b) {
  return a.left < b.right + 2 && b.left < a.right + 2 && a.top < b.bottom + 1 && b.top < a.bottom + 1;
}
