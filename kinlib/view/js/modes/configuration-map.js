// The configuration space of a closed chain, two joint values against each other: its curves, and the point where it is.
import { formatNumber, h, NO_SHORTCUTS, renderSymbol, stepsOf } from '../dom.js';
import { disc, strokeLines } from '../render/pen.js';

const SIZE_PX = 260;
const MARGIN_PX = 38;
const INSIDE_PX = SIZE_PX - MARGIN_PX - 8;
const DEGREE = Math.PI / 180;

/** @param data.map { columns: [column, column], all: [name...], angles: [whether each joint value is an angle] } */
export function configurationMap({ model, stage, data, variant, at, go }) {
  const { columns, all, angles } = data.map;
  const curves = Object.entries(data.variants).map(([name, { stops }]) => [name, stops.map(({ q }) => q)]);
  const names = columns.map((column) => all[column]);
  const bounds = columns.map((column) => {
    const values = curves.flatMap(([, samples]) => samples.map((q) => q[column]));
    const [low, high] = [Math.min(...values), Math.max(...values)];
    const room = 0.06 * (high - low) || 0.5;
    return [low - room, high + room];
  });
  const place = (q) => {
    const [x, y] = columns.map((column, k) => (q[column] - bounds[k][0]) / (bounds[k][1] - bounds[k][0]));
    return [MARGIN_PX + x * INSIDE_PX, 8 + (1 - y) * INSIDE_PX];
  };
  const canvas = h('canvas', {
    class: 'kv-map',
    tabindex: 0,
    role: 'img',
    ...NO_SHORTCUTS,
    onclick(event) {
      const box = canvas.getBoundingClientRect();
      const off = ([x, y]) => Math.hypot(event.clientX - box.left - x, event.clientY - box.top - y);
      const [, name, stop] = curves
        .flatMap(([curve, samples]) => samples.map((q, k) => [off(place(q)), curve, k]))
        .reduce((best, one) => (one[0] < best[0] ? one : best));
      model.set('variant', name);
      go(stop);
    },
    onkeydown(event) {
      const by = stepsOf(event);
      if (!by || !Number.isFinite(by)) return;
      event.stopPropagation();
      const many = variant().stops.length;
      go((at() + by + many) % many);
    },
  });
  const numbers = all.map(() => h('output'));
  const values = all.flatMap((name, k) => [h('span', {}, renderSymbol(name), ' = ', numbers[k])]);

  /** A joint value with its unit, angles also in degrees. */
  const valueText = (value, k) =>
    formatNumber(value, 3) + (angles[k] ? ` rad (${formatNumber(value / DEGREE, 1)}°)` : ' m');
  const endText = (value, k) => (angles[k] ? `${formatNumber(value / DEGREE, 0)}°` : `${formatNumber(value, 1)} m`);

  function paint(q) {
    const ratio = Math.min(devicePixelRatio || 1, 2);
    canvas.width = SIZE_PX * ratio;
    canvas.height = SIZE_PX * ratio;
    canvas.style.width = `${SIZE_PX}px`;
    const context = canvas.getContext('2d');
    const { theme } = stage;
    context.scale(ratio, ratio);
    context.fillStyle = theme.paper;
    context.fillRect(0, 0, SIZE_PX, SIZE_PX);
    context.strokeStyle = theme.grid;
    context.strokeRect(MARGIN_PX, 8, INSIDE_PX, INSIDE_PX);
    for (const [name, samples] of curves) {
      const [colour, width, dash] = name === model.get('variant') ? [theme.axis, 2.5, []] : [theme.quiet, 1.5, [5, 3]];
      context.setLineDash(dash);
      strokeLines(context, [samples.map(place)], colour, width);
    }
    context.setLineDash([]);
    disc(context, ...place(q), 6, theme.normal, theme.ink, 1.5);
    context.fillStyle = theme.ink;
    context.font = 'italic 600 13px sans-serif';
    context.textAlign = 'center';
    context.fillText(names[0].replace('_', ''), MARGIN_PX + INSIDE_PX / 2, SIZE_PX - 9);
    context.save(); // rotated, to be read along the vertical axis
    context.translate(MARGIN_PX / 2 - 2, 8 + INSIDE_PX / 2);
    context.rotate(-Math.PI / 2);
    context.fillText(names[1].replace('_', ''), 0, 4);
    context.restore();
    context.font = '11px sans-serif';
    context.fillStyle = theme.quiet;
    const [across, up] = bounds.map((pair, k) => pair.map((value) => endText(value, columns[k])));
    context.fillText(across[0], MARGIN_PX + 10, SIZE_PX - 12);
    context.fillText(across[1], SIZE_PX - 24, SIZE_PX - 12);
    context.fillText(up[0], MARGIN_PX / 2 - 1, SIZE_PX - MARGIN_PX - 2);
    context.fillText(up[1], MARGIN_PX / 2 - 1, 18);
  }

  return {
    element: h('div', { class: 'kv-curve' }, canvas, h('p', { class: 'kv-values' }, ...values)),
    update() {
      const { q } = variant().stops[Math.round(at())];
      numbers.forEach((number, k) => {
        number.textContent = valueText(q[k], k);
      });
      const now = columns.map((column, k) => `${names[k]} = ${valueText(q[column], column)}`).join(' and ');
      const which = Object.keys(data.variants).indexOf(model.get('variant')) + 1;
      const count =
        curves.length > 1
          ? `${curves.length} curves; the linkage is on curve ${which}`
          : 'one curve; the linkage is on it';
      const text = `Configuration space, ${names.join(' against ')}: ${count}`;
      canvas.setAttribute('aria-label', `${text}, where ${now}.`);
      paint(q);
    },
  };
}
