// A closed chain on the curves of its configuration space: a slider moves it along one, a click on the map to another.

import { playButton } from '../controls/play-button.js';
import { formatNumber, h, moveSlider, NO_SHORTCUTS, renderSymbol, slider, uniqueId } from '../dom.js';
import { disc, strokeLines } from '../render/pen.js';

const MAP_SIZE_PX = 260;
const MAP_MARGIN_PX = 38;
const DEGREE = Math.PI / 180;

/**
 * @param kit.data { curves: [[[q...], ...], ...], columns: [column, column], names: [name, name], all: [name...],
 *   closed: [bool...], labels: [text...], angles: [whether each joint value is an angle, in radians] }
 */
export function configurationCurve({ stage, data, state }) {
  const { curves, columns, names } = data;
  const id = uniqueId('curve');
  let at = nearest(curves, state.q());
  const go = (which, sample) => state.set(curves[which][sample]);
  const driver = slider(0, (sample) => go(at.which, sample), { id });
  const select = h(
    'select',
    {
      ...NO_SHORTCUTS,
      'aria-label': 'Assembly mode',
      onchange: () => {
        const which = Number(select.value);
        go(which, nearest([curves[which]], state.q()).sample);
      },
    },
    ...curves.map((_, k) => h('option', { value: k }, data.labels[k])),
  );
  const canvas = h('canvas', {
    class: 'kv-map',
    tabindex: 0,
    role: 'img',
    ...NO_SHORTCUTS,
    onclick: (event) => {
      const box = canvas.getBoundingClientRect();
      const point = [event.clientX - box.left, event.clientY - box.top];
      const found = closest(
        curves.map((samples) => samples.map(place)),
        point,
      );
      go(found.which, found.sample);
    },
    onkeydown: (event) => {
      const step = { ArrowRight: 1, ArrowUp: 1, ArrowLeft: -1, ArrowDown: -1 }[event.key];
      if (!step) return;
      event.preventDefault();
      const many = curves[at.which].length;
      go(at.which, (at.sample + step + many) % many);
    },
  });
  let from = 0;
  const motion = playButton(
    () => {
      from = at.sample;
    },
    (_, share) => {
      const many = curves[at.which].length;
      // an open curve is traversed forwards and backwards
      const sample = data.closed[at.which]
        ? (from + Math.round(share * (many - 1))) % many
        : Math.round((0.5 - 0.5 * Math.cos(2 * Math.PI * share)) * (many - 1));
      if (sample !== at.sample) go(at.which, sample);
    },
  );
  const numbers = data.all.map(() => h('output'));
  const values = h(
    'p',
    { class: 'kv-values' },
    ...data.all.flatMap((name, k) => [h('span', {}, renderSymbol(name), ' = ', numbers[k])]),
  );
  const bounds = columns.map((column) => {
    const values = curves.flat().map((q) => q[column]);
    const [low, high] = [Math.min(...values), Math.max(...values)];
    const room = 0.06 * (high - low) || 0.5;
    return [low - room, high + room];
  });

  /** A joint value with its unit, angles also in degrees. */
  function valueText(value, k) {
    const unit = data.angles[k] ? ` rad (${formatNumber(value / DEGREE, 1)}°)` : ' m';
    return formatNumber(value, 3) + unit;
  }
  const endText = (value, k) =>
    data.angles[k] ? `${formatNumber(value / DEGREE, 0)}°` : `${formatNumber(value, 1)} m`;

  function place(q) {
    const [x, y] = columns.map((column, k) => (q[column] - bounds[k][0]) / (bounds[k][1] - bounds[k][0]));
    return [
      MAP_MARGIN_PX + x * (MAP_SIZE_PX - MAP_MARGIN_PX - 8),
      MAP_SIZE_PX - MAP_MARGIN_PX - y * (MAP_SIZE_PX - MAP_MARGIN_PX - 8),
    ];
  }

  function paint(q) {
    const ratio = Math.min(devicePixelRatio || 1, 2);
    canvas.width = MAP_SIZE_PX * ratio;
    canvas.height = MAP_SIZE_PX * ratio;
    canvas.style.width = `${MAP_SIZE_PX}px`;
    const context = canvas.getContext('2d');
    const { theme } = stage;
    context.scale(ratio, ratio);
    context.fillStyle = theme.paper;
    context.fillRect(0, 0, MAP_SIZE_PX, MAP_SIZE_PX);
    context.strokeStyle = theme.grid;
    context.strokeRect(MAP_MARGIN_PX, 8, MAP_SIZE_PX - MAP_MARGIN_PX - 8, MAP_SIZE_PX - MAP_MARGIN_PX - 8);
    curves.forEach((samples, which) => {
      const [colour, width, dash] = which === at.which ? [theme.axis, 2.5, []] : [theme.quiet, 1.5, [5, 3]];
      context.setLineDash(dash);
      strokeLines(context, [samples.map(place)], colour, width);
    });
    context.setLineDash([]);
    disc(context, ...place(q), 6, theme.normal, theme.ink, 1.5);
    context.fillStyle = theme.ink;
    context.font = 'italic 600 13px sans-serif';
    context.textAlign = 'center';
    context.fillText(names[0].replace('_', ''), (MAP_SIZE_PX + MAP_MARGIN_PX - 8) / 2, MAP_SIZE_PX - 9);
    context.save(); // rotated, to be read along the vertical axis
    context.translate(MAP_MARGIN_PX / 2 - 2, (MAP_SIZE_PX - MAP_MARGIN_PX + 8) / 2);
    context.rotate(-Math.PI / 2);
    context.fillText(names[1].replace('_', ''), 0, 4);
    context.restore();
    context.font = '11px sans-serif';
    context.fillStyle = theme.quiet;
    const [[left, right], [bottom, top]] = bounds.map((pair, k) => pair.map((value) => endText(value, columns[k])));
    for (const [text, x, y] of [
      [left, MAP_MARGIN_PX + 10, MAP_SIZE_PX - 12],
      [right, MAP_SIZE_PX - 24, MAP_SIZE_PX - 12],
      [bottom, MAP_MARGIN_PX / 2 - 1, MAP_SIZE_PX - MAP_MARGIN_PX - 2],
      [top, MAP_MARGIN_PX / 2 - 1, 18],
    ]) {
      context.fillText(text, x, y);
    }
  }

  return {
    element: h(
      'div',
      { class: 'kv-curve' },
      h('div', { class: 'kv-row kv-driver' }, h('label', { for: id }, 'driver'), driver),
      h('div', { class: 'kv-buttons' }, motion.button, ...(curves.length > 1 ? [select] : [])),
      canvas,
      values,
    ),
    replacesSliders: true,
    update(q) {
      at = nearest(curves, q, at);
      driver.max = curves[at.which].length - 1;
      moveSlider(driver, at.sample, data.all.map((name, k) => `${name} ${valueText(q[k], k)}`).join(', '));
      select.value = at.which;
      numbers.forEach((number, k) => {
        number.textContent = valueText(q[k], k);
      });
      canvas.setAttribute(
        'aria-label',
        `Configuration space, ${names.join(' against ')}: ${curves.length} curves; ` +
          `the linkage is on curve ${at.which + 1}, where ` +
          `${columns.map((column, k) => `${names[k]} = ${valueText(q[column], column)}`).join(' and ')}.`,
      );
      paint(q);
    },
    applyTheme: () => paint(state.q()),
    dispose: motion.stop,
  };
}

/** The sample nearest to q on all curves; if two are equally near, the one on the same curve as before. */
function nearest(curves, q, before) {
  const found = closest(curves, q);
  if (before === undefined || found.which === before.which) return found;
  const own = closest([curves[before.which]], q);
  return own.distance <= found.distance + 1e-12 ? { ...own, which: before.which } : found;
}

function closest(lists, point) {
  const best = { which: 0, sample: 0, distance: Infinity };
  for (const [which, samples] of lists.entries()) {
    for (const [sample, values] of samples.entries()) {
      const distance = values.reduce((sum, value, k) => sum + (value - point[k]) ** 2, 0);
      if (distance < best.distance) Object.assign(best, { which, sample, distance });
    }
  }
  return best;
}
