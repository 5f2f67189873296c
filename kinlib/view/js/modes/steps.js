// The player of steps in three dimensions: what a stop says and shows, and the motion from each to the next.
// See kinlib/view/viewer/steps.py for its data.
import { Matrix4, Vector3 } from 'three';
import { renderMathText, setSentence } from '../controls/math-text.js';
import { stepControls } from '../controls/step-controls.js';
import { button, h, NO_SHORTCUTS } from '../dom.js';
import { listen, save } from '../model.js';
import { haloText, strokeLines } from '../render/pen.js';
import { describeLinkage } from '../scene/describe.js';
import { matrixOf } from '../scene/kinematic-tree.js';
import { column, originOf, solids } from '../scene/solids.js';
import { add, minus } from '../vectors.js';
import { configurationMap } from './configuration-map.js';
import { dhTable } from './dh-table.js';
import { createHighlighter } from './highlighter.js';

const IDENTITY = [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1];
const ARC_SEGMENTS = 24;
const WITHIN = 1e-9;

export function steps({ model, stage, data }) {
  const { size } = stage.data;
  const variant = () => data.variants[model.get('variant')];
  const stops = () => variant().stops;
  const last = () => stops().length - 1;
  const at = () => Math.min(model.get('at'), last());
  const passed = () => Math.floor(at() + WITHIN);
  const stop = () => stops()[passed()];
  const isWalk = Boolean(stop().motion); // motions of a frame, one after the other
  const countText = () =>
    isWalk ? `${Number(at().toFixed(1))} of ${last()} motions` : `${data.name} ${passed() + 1} of ${last() + 1}`;
  const controls = stepControls({
    model,
    last,
    name: data.name ?? 'value',
    label: data.label,
    pace: data.pace,
    between: isWalk,
    ends: data.map && [0, 0.25, 0.5, 0.75, 1].map((share) => Math.round(share * last())),
    closed: () => variant().closed,
    textOf: () => stop().title ?? countText(),
  });
  const select = h(
    'select',
    {
      ...NO_SHORTCUTS,
      'aria-label': data.choice && data.choice[0].toUpperCase() + data.choice.slice(1),
      onchange: () => save(model, 'variant', select.value),
    },
    ...Object.keys(data.variants).map((name) => h('option', { value: name }, describeChoice(name, data.choice))),
  );
  const count = h('span', { class: 'kv-small' });
  const others = h('p', { class: 'kv-note' });
  const text = h('p', { class: isWalk ? 'kv-motion-text' : '' });
  const product = h('div', { class: 'kv-product', hidden: !isWalk });
  const factorsOf = (symbols) =>
    symbols.map((symbol, k) =>
      button(renderMathText(symbol), () => controls.go(k + 1), {
        class: 'kv-factor',
        title: `Go to the end of motion ${k + 1}`,
      }),
    );
  const table = h('div', { hidden: true });
  const map = data.map && configurationMap({ model, stage, data, variant, at, go: controls.go });
  const said = h('div', {
    class: isWalk || data.label ? '' : 'kv-step',
    'aria-live': 'polite',
    'aria-atomic': String(!isWalk),
  });
  said.append(product, text, others);
  const named = data.label && !data.map ? [h('label', { for: controls.id }, `${data.label}: `), count] : [count];
  const element = h(
    'section',
    { class: 'kv-player', role: 'group', 'aria-label': 'Steps', onkeydown: controls.onkeydown },
    h('div', { class: 'kv-head' }, ...(select.options.length > 1 ? [select] : []), h('span', {}, ...named)),
    h('div', { class: 'kv-buttons' }, ...controls.buttons),
    controls.bar,
    ...(data.map ? [map.element] : [said, table]),
  );

  function write() {
    const now = stop();
    controls.update();
    select.value = model.get('variant');
    const shown = data.label ? now.title : countText();
    count.textContent = data.map ? '' : shown;
    others.replaceChildren(...(now.others ? [h('b', {}, 'Also valid: '), ...renderMathText(now.others)] : []));
    const current = Math.ceil(at() - WITHIN); // the motion that is being made, or has just been made
    setSentence(text, stops()[isWalk ? current : passed()].text ?? '');
    [...product.children].forEach((factor, i) => {
      factor.classList.toggle('kv-done', i < current);
      if (i === current - 1) factor.setAttribute('aria-current', 'step');
      else factor.removeAttribute('aria-current');
    });
    const { convention, rows } = variant().table ?? {};
    if (!rows) return;
    const read = now.row ?? (done('row').length ? rows.length : 0);
    table.hidden = !read;
    table.replaceChildren(dhTable(convention, rows, { read, lit: now.row, label: 'DH table so far' }));
  }

  let drawn; // the stop whose parts are drawn
  function move() {
    const [here, there] = [stop(), stops()[Math.min(passed() + 1, last())]];
    const share = at() - passed();
    if (here.q) stage.setQ(here.q.map((value, k) => value + share * (there.q[k] - value)));
    else if (here.pose) {
      const { axis, angle = 0, distance = 0 } = here.motion;
      const along = new Vector3(Number(axis === 'x'), 0, Number(axis !== 'x'));
      const moved = new Matrix4()
        .makeRotationAxis(along, share * angle)
        .setPosition(along.multiplyScalar(share * distance));
      stage.tree.arms[0].tool.matrix.copy(matrixOf(here.pose).multiply(moved));
      stage.tree.arms[0].tool.matrixWorldNeedsUpdate = true;
      stage.tree.root.updateMatrixWorld(true);
    }
    if (drawn !== here) {
      const kit = { size, theme: stage.theme };
      stage.setLayer('stop', solids([...done('ways'), ...(here.parts ?? [])], kit), { through: true });
      highlighter.mark(marksOf(here));
      // at a frame that stays, its own labels are shown; between two of them, the labels of the moving frame
      drawn = here;
    }
    if (isWalk) {
      const ways = (share ? (here.ways ?? []) : []).map((way) => ({
        ...way,
        name: '',
        to: add(way.from, minus(way.to, way.from), share),
      }));
      stage.setLayer('way', solids(ways, { size, theme: stage.theme }), { through: true });
    }
    stage.showLayer('moving names', !(here.reached && !share));
    map?.update();
    stage.draw();
  }

  /** The strokes over what a stop is about: strong lines, and the origin and axes of strong frames, as far as it names them. */
  function marksOf({ marked = '', parts }) {
    const strokesOf = ({ pose, length }) =>
      [...'Oxyz'].map((letter, k) => {
        const from = originOf(pose);
        return { letter, from, to: k ? add(from, column(pose, k - 1), length * size) : from };
      });
    return (marked ? parts : [])
      .filter(({ strong }) => strong)
      .flatMap((part) => (part.kind === 'line' ? { ...part, letter: 'line' } : strokesOf(part)))
      .filter(({ letter }) => marked.includes(letter));
  }

  /** What the motions that are done have left. */
  const done = (kind) =>
    stops()
      .slice(0, passed())
      .flatMap((one) => one[kind] ?? []);

  /** The angles of motions as sectors, from the initial to the current direction of x or z. */
  function drawTurns(context, camera) {
    const now = isWalk && at() > passed() ? stop() : stops()[passed() - 1];
    for (const [k, { pose, motion }] of isWalk ? stops().entries() : []) {
      const share = Math.max(0, Math.min(1, at() - k));
      const turn = { ...motion, pose };
      if (share > 0.001 && Math.abs(turn.angle) > 0.01) drawTurn(context, camera, turn, share, stops()[k] === now);
    }
  }
  function drawTurn(context, camera, { pose, axis, angle, distance, name }, share, isNow) {
    const column = (k) => new Vector3(pose[k], pose[4 + k], pose[8 + k]);
    // a rotation about z takes x towards y; a rotation about x takes z towards -y
    const [from, to, up] =
      axis === 'z' ? [column(0), column(1), column(2)] : [column(2), column(1).negate(), column(0)];
    const radius = 0.62 * data.length * size;
    const pointAt = (phi, r) => {
      const point = column(3)
        .addScaledVector(from, r * Math.cos(phi))
        .addScaledVector(to, r * Math.sin(phi));
      const { x, y } = camera.project(point.addScaledVector(up, (distance * phi) / angle), new Vector3());
      return [x, y];
    };
    const points = Array.from({ length: ARC_SEGMENTS + 1 }, (_, i) =>
      pointAt((angle * share * i) / ARC_SEGMENTS, radius),
    );
    const colour = axis === 'z' ? stage.theme.axis : stage.theme.normal;
    context.save();
    context.globalAlpha = isNow ? 0.3 : 0.12;
    context.fillStyle = colour;
    context.beginPath();
    for (const point of [pointAt(0, 0), ...points]) context.lineTo(...point);
    if (!distance) context.fill(); // the line of a screw motion is a helix, which has no sector
    context.globalAlpha = isNow ? 1 : 0.55;
    strokeLines(context, [points], colour, 2);
    context.font = 'italic 600 15px "Cambria Math", Cambria, "DejaVu Serif", Georgia, serif';
    context.textAlign = 'center';
    context.textBaseline = 'middle';
    const letter = { theta: 'θ', alpha: 'α' }[name] ?? '';
    haloText(context, letter, ...pointAt((angle * share) / 2, 1.2 * radius), colour, stage.theme.paper);
    context.restore();
  }

  const highlighter = createHighlighter(stage);
  stage.overlays.add(drawTurns);
  const changed = () => {
    write();
    move();
  };
  const changedVariant = () => {
    stage.setLayer('still', solids(variant().still ?? [], { size, theme: stage.theme }));
    product.replaceChildren(...factorsOf(stops().flatMap(({ motion }) => motion?.symbol ?? [])));
    changed();
  };
  const stopListening = listen(model, { at: changed, variant: changedVariant });
  return {
    element,
    replacesSliders: true,
    update: move, // the joint values follow from the stop
    describe: () => {
      const onTheWay = at() - passed() > WITHIN ? 'On the way to the next stop. ' : '';
      return stop().alt === undefined ? describeLinkage(stage.data, stage.tree) : `${onTheWay}${stop().alt}`;
    },
    applyTheme() {
      const kit = { size, theme: stage.theme };
      const frame = { kind: 'frame', arm: 0, body: 'tool', pose: IDENTITY, letters: 'Oxyz', length: data.length };
      const moving = isWalk ? solids([frame], kit) : [];
      stage.setLayer(
        'moving',
        moving.filter((part) => !part.label),
        { through: true },
      );
      stage.setLayer(
        'moving names',
        moving.filter((part) => part.label),
      );
      drawn = undefined;
      changedVariant();
    },
    dispose() {
      controls.stop();
      stopListening();
      stage.overlays.delete(drawTurns);
      highlighter.dispose();
    },
  };
}

const describeChoice = (name, choice) => (choice === 'convention' ? `${name} convention` : name);
