// A planar arm that the reader moves: one picture for the argument from sine and cosine to the product of exponentials.
// planarArm.widget is the view of a widget in notebooks; planarArm.start() shows all arms of a page without a kernel.
// An arm has one state, and one function draws all of it: each input changes the state and calls render().
globalThis.planarArm = (() => {
  // --- mathematics: degrees in the state, radians only here ---

  const radians = (degrees) => (degrees * Math.PI) / 180;
  const degrees = (angle) => (angle * 180) / Math.PI;
  const cos = (angle) => Math.cos(radians(angle));
  const sin = (angle) => Math.sin(radians(angle));
  const clamp = (value, least, most) => Math.min(most, Math.max(least, value));
  const wrap = (angle) => (((angle % 360) + 540) % 360) - 180 || 0; // prettier than -0
  const add = (a, b) => a.map((value, k) => value + b[k]);
  const distance = (a, b) => Math.hypot(...a.map((value, k) => value - b[k]));
  const between = (a, b, share) => a.map((value, k) => value + (b[k] - value) * share);
  const direction = (a, b) => degrees(Math.atan2(b[1] - a[1], b[0] - a[0]));
  const sums = (q) => q.map((_, i) => q.slice(0, i + 1).reduce((sum, value) => sum + value)); // q1, q1 + q2, ...
  const pairs = (points) => points.slice(1).map((end, i) => [points[i], end]);

  /** The joints and the tool of an arm whose link i makes the angle headings[i] with the x axis. */
  const joints = (headings, lengths) =>
    lengths.reduce((all, l, i) => all.concat([add(all[i], [l * cos(headings[i]), l * sin(headings[i])])]), [[0, 0]]);

  /** Rotate a point by an angle about an axis, a line through `point` with the unit vector `along` (Rodrigues). */
  function rotate(p, { point, along: [x, y, z] }, angle) {
    const r = p.map((value, k) => value - point[k]);
    const across = [y * r[2] - z * r[1], z * r[0] - x * r[2], x * r[1] - y * r[0]];
    const parallel = (x * r[0] + y * r[1] + z * r[2]) * (1 - cos(angle));
    return r.map((value, k) => point[k] + value * cos(angle) + across[k] * sin(angle) + [x, y, z][k] * parallel);
  }

  /** The joint values with which the tool of two links is as near as possible to a point. */
  function reach([l1, l2], [x, y], elbow) {
    const r = clamp(Math.hypot(x, y), Math.abs(l1 - l2), l1 + l2);
    const q2 = elbow * degrees(Math.acos(clamp((r * r - l1 * l1 - l2 * l2) / (2 * l1 * l2), -1, 1)));
    return [degrees(Math.atan2(y, x)) - degrees(Math.atan2(l2 * sin(q2), l1 + l2 * cos(q2))), q2];
  }

  // --- words ---

  const minus = (value) => `${value}`.replace('-', '−');
  const number = (value) => minus((Math.abs(value) < 0.005 ? 0 : value).toFixed(2));
  const degree = (angle) => minus(`${Math.round(angle)}°`);
  const place = (point) => `(${point.map(number).join(', ')})`;
  const list = (words) => [words.slice(0, -1).join(', '), ...words.slice(-1)].filter(Boolean).join(' and ');
  /** A letter with an index, for example q and 1, as HTML. */
  const letter = (name, index) => `<i>${name}</i><sub>${index}</sub>`;

  // --- the scenes ---

  /** Axes about which the links rotate, and the joints and the tool at home. */
  const PINS = {
    axes: [0, 3, 5].map((x) => ({ point: [x, 0, 0], along: [0, 0, 1] })),
    home: [0, 3, 5, 6].map((x) => [x, 0, 0]),
  };
  const SPACE = {
    axes: [0, 0, 2.4].map((x, i) => ({ point: [x, 0, i && 1.8], along: i ? [0, 1, 0] : [0, 0, 1] })),
    home: [0, 0, 2.4, 4.2].map((x, i) => [x, 0, i && 1.8]),
  };
  const TILT = 24; // how far from above the spatial arm is seen
  const MARKS = { A: [4, 3], B: [4, 1], C: [4, -2] };
  const WALL = 4;
  const BREAKS = 'an order that breaks the arm';

  /** What the picture shows at least: x from, x to, y from, y to. */
  const WINDOWS = {
    drag: [-5.6, 5.6, -4.4, 5.4],
    terms: [-5.6, 5.6, -5.4, 5.4],
    reference: [-6.3, 6.5, -5.2, 6.2],
    pins: [-4, 7.4, -3, 6.4],
    space: [-3.6, 4.8, -2.4, 4.9],
    wall: [-4.6, 5.6, -3.4, 5.2],
  };
  const SVG = 'http://www.w3.org/2000/svg';
  const ARROWS = { ArrowRight: [1, 0], ArrowLeft: [-1, 0], ArrowUp: [0, 1], ArrowDown: [0, -1] };
  const still = matchMedia('(prefers-reduced-motion: reduce)');

  const set = (node, attributes) => {
    for (const [name, value] of Object.entries(attributes)) node.setAttribute(name, value);
    return node;
  };
  function element(name, attributes = {}, ...children) {
    const made = set(document.createElement(name), attributes);
    made.append(...children);
    return made;
  }

  /** Show an arm in an element; store gets { q, done } when they have changed. Returns the function that ends the view. */
  function show({ scene, lengths, goal, q, done }, host, store) {
    const isPlane = scene !== 'space';
    const machine = isPlane ? PINS : SPACE;
    const state = {
      q: [...q],
      done: new Set(done),
      term: null, // the term that is lit, such as x1
      hidden: false, // the arm of scene "drag"
      cross: null, // where the reader expects the tool
      answer: null, // the line from which joint 2 is said to be measured
      order: [], // the joints that were pressed
      share: 1, // how much of the last rotation has been made
      view: -62,
      says: '',
    };
    const stage = set(document.createElementNS(SVG, 'svg'), { role: 'group', 'aria-label': 'Picture of the arm' });
    const paint = set(stage.appendChild(document.createElementNS(SVG, 'g')), { 'aria-hidden': 'true' });
    const handles = stage.appendChild(document.createElementNS(SVG, 'g'));
    const panel = element('div', { class: 'planar-panel' });
    const alternative = element('p');
    const words = element('details', {}, element('summary', {}, 'The picture in words'), alternative);
    const live = element('p', { class: 'planar-live', 'aria-live': 'polite' });
    const root = element('div', { class: 'planar-arm', 'data-lm-suppress-shortcuts': 'true' });
    root.append(stage, panel, words, live);
    host.append(root);

    /** Keep what was done, beyond this view, and draw. */
    function save() {
      store({ q: [...state.q], done: [...state.done] });
      render();
    }
    function setJoint(i, value) {
      state.q[i] = Math.round(wrap(value));
      state.done.add(`link ${i + 1}`);
      if (!state.hidden) state.cross = null;
    }
    function light(term = null) {
      if (state.term === term) return;
      state.term = term;
      render();
    }

    // --- the picture is written anew each time; only what is held by a hand or has the focus stays ---

    let parts; // of the picture, as SVG
    let unit; // pixels
    let origin;
    let size;
    const X = (x) => origin[0] + x * unit;
    const Y = (y) => origin[1] - y * unit;
    const at = (point) => [X(point[0]), Y(point[1])];
    const offset = ([x, y], r, angle) => [x + r * cos(angle), y - r * sin(angle)];
    const heading = (a, b) => -direction(a, b); // of two points of the picture, whose y is down
    const width = () => clamp(unit * 0.36, 12, 26);
    const anchor = (angle) => (Math.abs(cos(angle)) < 0.4 && ' mid') || (cos(angle) < 0 && ' end') || '';

    function draw(name, attributes, content = '') {
      const written = Object.entries(attributes).map(([key, value]) => ` ${key}="${value}"`);
      parts.push(`<${name}${written.join('')}>${content}</${name}>`);
    }
    const line = ([x1, y1], [x2, y2], style, more = {}) => draw('line', { x1, y1, x2, y2, class: style, ...more });
    const dot = ([cx, cy], r, style) => draw('circle', { cx, cy, r, class: style });
    const rect = (x, y, w, h, style) => draw('rect', { x, y, width: Math.max(0, w), height: h, rx: 6, class: style });
    const path = (points, style) => draw('polyline', { points: points.join(' '), class: style });
    const shape = (points, style) => draw('polygon', { points: points.join(' '), class: style });
    const arc = (centre, r, from, by) => Array.from({ length: 61 }, (_, k) => offset(centre, r, from + (by * k) / 60));

    /** A label; "*q*_1" becomes a letter of mathematics with an index. */
    function label([x, y], content, style = '') {
      const index = (digit) =>
        digit ? `<tspan class="sub" dy="5">${digit}</tspan><tspan dy="-5">&#8203;</tspan>` : '';
      const letters = (_, name, digit) => `<tspan class="mi">${name}</tspan>${index(digit)}`;
      draw('text', { x, y, class: style }, content.replace(/\*(.+?)\*(?:_(\d+))?/g, letters));
    }

    function head(tip, angle, length, half, style) {
      const neck = offset(tip, -length, angle);
      shape([tip, offset(neck, half, angle + 90), offset(neck, half, angle - 90)], `head ${style}`);
    }

    /** Something to take with mouse, finger or keys: grab(point), drag(point, grip), key(dx, dy), and what is said of it. */
    const handlesByName = new Map();
    function handle(name, kind, attributes, { says, now, value, ...spec }) {
      const aria = { role: 'slider', 'aria-label': says, 'aria-valuenow': Math.round(now), 'aria-valuetext': value };
      const range = { 'aria-valuemin': -180, 'aria-valuemax': 180, tabindex: 0 };
      const node = handlesByName.get(name) ?? document.createElementNS(SVG, kind);
      if (!node.isConnected) handles.append(node); // never again: a node that moves in the document loses the focus
      handlesByName.set(name, node);
      set(node, { class: 'hit', ...attributes, ...aria, ...range }).spec = spec;
      parts.handles.add(node);
    }

    // --- input ---

    const world = (event) => {
      const box = stage.getBoundingClientRect();
      return [(event.clientX - box.left - origin[0]) / unit, -(event.clientY - box.top - origin[1]) / unit];
    };
    let held = null;
    stage.addEventListener('pointerdown', (event) => {
      const { spec } = event.target;
      if (!spec || event.button) return;
      event.target.focus({ preventScroll: true, focusVisible: false });
      stage.setPointerCapture(event.pointerId);
      held = { spec, grip: spec.grab(world(event)) };
      if (event.pointerType === 'mouse') event.preventDefault();
    });
    stage.addEventListener('pointermove', (event) => {
      if (!held) return light(event.target.dataset.term);
      held.spec.drag(world(event), held.grip);
      render();
    });
    stage.addEventListener('lostpointercapture', () => {
      held = null;
      save();
    });
    root.addEventListener('keydown', (event) => {
      const step = ARROWS[event.key];
      const { spec } = event.target;
      if (!step || !spec) return;
      event.preventDefault();
      event.stopPropagation(); // JupyterLab would select another cell
      spec.key(...step.map((value) => value * (event.shiftKey ? 10 : 1)));
      save();
    });

    // --- parts of the picture ---

    const points = () => joints(sums(state.q), lengths);
    const phi = () => wrap(sums(state.q).at(-1));

    function grid() {
      for (let k = -20; k <= 20; k++) {
        line([X(k), 0], [X(k), size[1]], k ? 'grid' : 'axis');
        line([0, Y(k)], [size[0], Y(k)], k ? 'grid' : 'axis');
      }
      label([size[0] - 14, Y(0) - 8], '*x*', 'end');
      label([X(0) + 9, 20], '*y*');
      for (const value of [-4, -2, 2, 4]) {
        label([X(value), Y(0) + 17], minus(value), 'soft mid');
        label([X(0) - 7, Y(value) + 5], minus(value), 'soft end');
      }
    }

    /** Links [[a, b], ...] in the picture, the farthest first; they need not be connected. The last one carries the pen. */
    function arm(links, faint = () => '', order = [...links.keys()]) {
      const w = width();
      const [x, y] = links[0][0];
      rect(x - w, y - w, 2 * w, 2 * w, 'base');
      for (const i of order) {
        const [a, b] = links[i];
        const angle = heading(a, b);
        const tip = i === links.length - 1 ? Math.min(0.45 * unit, distance(a, b)) : 0;
        const end = offset(b, -tip, angle);
        line(a, end, `edge${faint(i)}`, { 'stroke-width': w + 4 });
        line(a, end, `link c${i + 1}${faint(i)}`, { 'stroke-width': w });
        if (tip) shape([b, offset(end, w / 2, angle + 90), offset(end, w / 2, angle - 90)], `pen${faint(i)}`);
        dot(a, w * 0.42, `joint${faint(i)}`);
      }
      for (const [i, [a, b]] of links.entries()) label(between(a, b, 0.42), String(i + 1), `on${faint(i)}`);
    }

    /** A label beyond the tool, on one side of the direction of the last link. */
    function beyond(chain, name, style, turn = -50) {
      const [a, b] = chain.slice(-2).map(at);
      const angle = heading(a, b) + turn;
      const [x, y] = offset(b, 22, angle);
      label([x, y + 5 - 6 * sin(angle)], name, style + (x > size[0] - 90 ? ' end' : anchor(angle)));
    }

    function gap(a, b) {
      line(at(a), at(b), 'gap');
      if (distance(at(a), at(b)) < 110) return; // the label would cover an end
      label(add(at(between(a, b, 0.5)), [0, 5]), `${number(distance(a, b))} apart`, 'mid');
    }

    /** The angle of each joint, from the direction of the link before it (a dashed line). */
    function angles(chain) {
      for (const [i, q] of state.q.entries()) {
        if (['x', 'y'].some((axis) => state.term === `${axis}${i + 1}`)) continue; // the sum of angles is there
        const [centre, from, by] = [at(chain[i]), i ? sums(state.q)[i - 1] : 0, wrap(q)];
        const r = width() * 1.75 + 2 * i;
        line(centre, offset(centre, r * 1.75, from), 'drop');
        path(arc(centre, r, from, by), `arc c${i + 1}`);
        if (Math.abs(by) > 12)
          head(offset(centre, r, from + by), from + by + (by < 0 ? -66 : 66), 10, 4.5, `c${i + 1}`);
        // A large angle has room for its label; that of a small one is put on the other side of the dashed line.
        const beside = from - (by < 0 ? -24 : 24);
        const side = Math.abs(by) > 76 || scene === 'terms' ? from + by / 2 : beside;
        const [x, y] = offset(centre, r + 12, side);
        const name = `*q*_${i + 1} = ${degree(by)}`;
        label([x, y + (sin(side) < -0.5 ? 13 : 5)], name, `num c${i + 1}${anchor(side)}`);
      }
    }

    function linkHandles(chain) {
      pairs(chain).forEach(([a, b], i) => {
        const [[x1, y1], [x2, y2]] = [at(a), at(b)];
        const area = { x1, y1, x2, y2, 'stroke-width': Math.max(36, width() + 12) };
        handle(`link ${i + 1}`, 'line', area, {
          says: `Link ${i + 1}, rotates about joint ${i + 1}`,
          now: state.q[i],
          value: `q${i + 1} = ${Math.round(state.q[i])} degrees`,
          grab: (p) => state.q[i] - direction(a, p),
          drag: (p, grip) => setJoint(i, grip + direction(a, p)),
          key: (dx, dy) => setJoint(i, state.q[i] + dx + dy),
        });
      });
    }

    function pointHandle(name, says, point, move) {
      const area = { cx: X(point[0]), cy: Y(point[1]), r: 24 };
      handle(name, 'circle', area, {
        says,
        now: point[0],
        value: `x = ${point[0].toFixed(1)}, y = ${point[1].toFixed(1)}`,
        grab: (p) => [point[0] - p[0], point[1] - p[1]],
        drag: (p, grip) => move(add(p, grip)),
        key: (dx, dy) => move(add(point, [dx * 0.1, dy * 0.1])),
      });
    }

    /** The terms of x and y as arrows beside the axes, on the side where the arm is not. */
    function terms(chain) {
      const margin = width() + 12;
      const outside = margin + lengths.length * 16;
      const side = [0, 1].map((k) => (chain.reduce((sum, p) => sum + p[k], 0) < 0 ? 1 : -1) * (k ? -1 : 1));
      pairs(chain).forEach(([a, b], i) => {
        const middle = at(between(a, b, 0.5));
        for (const [k, axis] of ['x', 'y'].entries()) {
          const term = `${axis}${i + 1}`;
          const isHot = state.term === term;
          const style = `c${i + 1}${isHot ? ' hot' : ''}${state.term && !isHot ? ' faint' : ''}`;
          const beside = (p, away) => (k ? [X(0) + side[0] * away, p[1]] : [p[0], Y(0) + side[1] * away]);
          const [from, to] = [a, b].map((p) => beside(at(p), margin + i * 16));
          const value = b[k] - a[k];
          const where = add(beside(middle, outside + (k ? 4 : 16 * i)), [0, 5]);
          if (isHot) triangle(i, a, b);
          line(at(b), to, 'drop');
          line(from, offset(to, -Math.min(distance(from, to), 12), heading(from, to)), `seg ${style}`);
          head(to, heading(from, to), Math.min(distance(from, to) || 1, 12), 6, style);
          const ends = k ? (side[0] < 0 && 'end') || '' : 'mid';
          if (Math.abs(value) > 0.04) label(where, number(value), `num ${ends} ${style}`);
          line(from, to, 'over', { stroke: 'transparent', 'stroke-width': 15, 'data-term': term });
        }
      });
    }

    /** The right triangle of a link, with the angle between the link and the x axis. */
    function triangle(i, a, b) {
      const sum = wrap(sums(state.q)[i]);
      const r = width() * 1.9;
      path([at(a), at([b[0], a[1]]), at(b)], `arc c${i + 1}`);
      path(arc(at(a), r, 0, sum), `arc c${i + 1} hot`);
      const names = lengths.slice(0, i + 1).map((_, k) => `*q*_${k + 1}`);
      const name = `${names.join(' + ')} = ${degree(sum)}`;
      label(add(offset(at(a), r + 16, sum / 2), [8, 5]), name, `num c${i + 1}`);
    }

    // --- rotations about fixed axes, of scenes "pins" and "space" ---

    /** A point of link k after the rotations that were pressed: joint j moves the links k >= j. */
    const moved = (p, k) =>
      state.order.reduce((point, j, n) => {
        const share = n === state.order.length - 1 ? state.share : 1;
        return j <= k ? rotate(point, machine.axes[j - 1], share * goal[j - 1]) : point;
      }, p);
    const movedLinks = () => [1, 2, 3].map((k) => [moved(machine.home[k - 1], k), moved(machine.home[k], k)]);
    const target = () => [3, 2, 1].reduce((p, j) => rotate(p, machine.axes[j - 1], goal[j - 1]), machine.home[3]);
    const shown = (p) => place(isPlane ? p.slice(0, 2) : p);
    /** The links after which the arm is broken. */
    const torn = (links) => [1, 2].filter((k) => distance(links[k - 1][1], links[k][0]) > 0.05);

    let running = null; // the time at which a rotation began
    /** Rotate about an axis, or go home if j is 0. One rotation at a time; readers who want no motion see only its end. */
    function press(j) {
      if (running) rotated(1);
      if (j === 0) state.order = [];
      if (j === 0 || state.order.includes(j)) return render();
      state.order.push(j);
      const start = performance.now();
      running = start;
      const tick = () => {
        if (running !== start) return;
        const t = still.matches || document.hidden ? 1 : clamp((performance.now() - start) / 900, 0, 1);
        rotated(t * t * (3 - 2 * t));
        requestAnimationFrame(tick);
      };
      tick();
    }

    function rotated(share) {
      state.share = share;
      if (share === 1) running = null;
      if (share < 1 || state.order.length < 3) return render();
      const [links, order] = [movedLinks(), state.order.join(', ')];
      const miss = distance(links[2][1], target());
      const isTorn = torn(links).length > 0;
      const moved = 'the links meet, but an axis had moved before the rotation about it';
      state.done.add(isTorn ? BREAKS : order);
      state.says =
        miss > 0.01
          ? `Order ${order}: ${isTorn ? 'the links no longer meet' : moved}, and the tool misses its goal by ${number(miss)}.`
          : `Order ${order}: the links fit together, and the tool is at its goal, ${shown(target())}.`;
      save();
    }

    /** The arm at home, the arm after the rotations, tears and goal, as `project` shows them; `depth` is away from the eye. */
    function rotations(project, depth) {
      path(machine.home.map(project), 'home');
      const links = movedLinks();
      const isAtRest = (i) => isPlane && state.order.length && !state.order.some((j) => j <= i + 1);
      const order = [...links.keys()].sort((a, b) => depth(add(...links[b])) - depth(add(...links[a])));
      const ends = links.map((link) => link.map(project));
      arm(ends, (i) => (isAtRest(i) ? ' faint' : ''), order);
      for (const k of torn(links)) line(ends[k - 1][1], ends[k][0], 'gap');
      dot(project(target()), 10, 'mark');
      label(add(project(target()), [14, -8]), 'goal');
    }

    function pins() {
      grid();
      rotations(at, () => 0);
      for (const [i, { point }] of machine.axes.entries()) {
        dot(at(point), 8, `pin c${i + 1}`);
        label(add(at(point), [0, width() + 18]), `pin ${i + 1}`, `num mid c${i + 1}`);
      }
    }

    function space() {
      const back = ([x, y]) => x * sin(state.view) + y * cos(state.view); // away from the eye
      const right = ([x, y]) => x * cos(state.view) - y * sin(state.view);
      const project = (p) => at([right(p), back(p) * sin(TILT) + p[2] * cos(TILT)]);
      for (let i = -4; i <= 4; i += 2) {
        line(project([i, -4, 0]), project([i, 4, 0]), 'grid');
        line(project([-4, i, 0]), project([4, i, 0]), 'grid');
      }
      for (const [i, { point, along }] of machine.axes.entries()) {
        const end = (m) => project(point.map((value, k) => value + along[k] * m));
        line(end(i ? -1.7 : -0.7), end(i ? 1.7 : 3.1), `screw c${i + 1}`);
        label(add(end(i ? 1.7 : 3.1), [0, -10]), `axis ${i + 1}`, `num mid c${i + 1}`);
      }
      rotations(project, back);
      const whole = { x: 4, y: 4, width: size[0] - 8, height: size[1] - 8, class: 'hit orbit' };
      handle('view', 'rect', whole, {
        says: 'View, rotates about the vertical',
        now: wrap(state.view),
        value: `view from ${Math.round(wrap(state.view))} degrees`,
        grab: (p) => state.view - p[0] * 30,
        drag: (p, grip) => Object.assign(state, { view: grip + p[0] * 30 }),
        key: (dx) => Object.assign(state, { view: state.view + dx * 5 }),
      });
    }

    // --- what is drawn beside the arm of the other scenes ---

    function cross(tool) {
      const [x, y] = at(state.cross);
      const away = state.hidden ? 0 : heading(at(tool), [x, y]);
      for (const h of [-12, 12]) line([x - 12, y - h], [x + 12, y + h], 'cross');
      label(add(offset([x, y], 20, away), [0, 6]), 'your cross', anchor(away));
      if (!state.hidden) return gap(state.cross, tool);
      pointHandle('cross', 'Your cross, moves in the plane', state.cross, (p) => {
        state.cross = p.map((value) => clamp(value, -5, 5));
      });
    }

    function toolHandle(tool) {
      dot(at(tool), 15, `ring${state.done.has('tool') ? '' : ' pulse'}`);
      pointHandle('tool', 'Tool, moves in the plane', tool, (p) => {
        state.q = reach(lengths, p, state.q[1] < 0 ? -1 : 1).map(wrap);
        state.cross = null;
        state.done.add('tool');
      });
    }

    /** The arm of the wrong answer, each of whose angles begins at the x axis, as a ghost. */
    function ghost(tool) {
      const wrong = joints(state.q, lengths);
      for (const style of ['under', 'ghost']) path(wrong.slice(1).map(at), style);
      dot(at(wrong[3]), 5, 'ghost-tip');
      beyond(wrong, 'your answer', 'soft', 60);
      gap(tool, wrong[3]);
    }

    const touched = () => Object.keys(MARKS).filter((name) => state.done.has(name));
    function wall(tool) {
      rect(X(WALL), 0, size[0] - X(WALL), size[1], 'wall');
      label([X(WALL) + 12, 26], 'wall');
      for (const [mark, where] of Object.entries(MARKS)) {
        const isTouched = state.done.has(mark);
        dot(at(where), 9, `mark${isTouched ? ' ok' : ''}`);
        label(add(at(where), [18, 6]), isTouched ? `${mark} ✓` : mark);
      }
      const name = Object.keys(MARKS).find((one) => distance(tool, MARKS[one]) < 0.13);
      state.says = tool[0] > WALL + 0.13 ? 'The pen is inside the wall.' : '';
      if (!name) return;
      if (Math.abs(phi()) < 3) state.done.add(name);
      const all = ' All three are. From poses of the tool you have found joint values: this is inverse kinematics.';
      state.says =
        Math.abs(phi()) < 3
          ? `Mark ${name} is touched.${touched().length === 3 ? all : ''}`
          : `At mark ${name}, but φ = ${degree(phi())}: the pen must be perpendicular to the wall.`;
    }

    function picture() {
      if (scene === 'space') return space();
      if (scene === 'pins') return pins();
      grid();
      const chain = points();
      const tool = chain.at(-1);
      if (scene === 'wall') wall(tool);
      if (state.answer === 'the x axis') ghost(tool);
      if (state.hidden) return cross(tool);
      arm(pairs(chain.map(at)));
      if (scene === 'terms' || state.answer === 'link 1') terms(chain);
      if (scene !== 'reference' || state.answer === 'link 1') angles(chain);
      linkHandles(chain);
      if (scene === 'drag' || scene === 'reference') beyond(chain, 'tool', 'tool');
      if (scene === 'drag') toolHandle(tool);
      if (state.cross) cross(tool); // over the arm
    }

    // --- below the picture ---

    const updates = []; // what brings each part of the panel up to date
    const keep = (node, properties) => {
      updates.push(() => Object.assign(node, properties()));
      return node;
    };
    const row = (...children) => panel.appendChild(element('div', { class: 'row' }, ...children));

    const button = (innerHTML, onclick, attributes = {}) =>
      Object.assign(element('button', { type: 'button', ...attributes }), { innerHTML, onclick });

    function sliders() {
      const slider = (_, i) => {
        const input = element('input', { type: 'range', min: -180, max: 180, class: `c${i + 1}` });
        input.onchange = save;
        input.oninput = () => {
          setJoint(i, Number(input.value));
          render();
        };
        keep(input, () => ({ value: state.q[i], ariaValueText: `${Math.round(state.q[i])} degrees` }));
        const value = keep(element('b'), () => ({ textContent: degree(state.q[i]) }));
        const name = Object.assign(element('span'), { innerHTML: `${letter('q', i + 1)} ` });
        return element('label', { class: `c${i + 1}` }, name, input, value);
      };
      row(...state.q.map(slider));
    }

    const written = (html) => keep(row(), () => ({ innerHTML: `<span>${html()}</span>` })); // a row would part q and its index
    const says = (text) =>
      keep(panel.appendChild(element('p', { class: 'note' })), () => ({ textContent: text(), hidden: !text() }));

    function tasks(names) {
      const item = (name) => keep(element('li', {}, name), () => ({ className: state.done.has(name) ? 'done' : '' }));
      panel.append(element('ul', { class: 'tasks' }, ...names.map(item)));
    }

    /** x = l1 cos q1 + ..., whose terms light their arrows; the short form writes c12 for cos(q1 + q2). */
    function formula(axis, isShort) {
      const k = axis === 'x' ? 0 : 1;
      const f = ['cos', 'sin'][k];
      const made = lengths.flatMap((_, i) => {
        const indices = lengths.slice(0, i + 1).map((__, n) => n + 1);
        const sum = indices.map((n) => letter('q', n)).join(' + ');
        const angle = isShort ? `<i>${f[0]}</i><sub>${indices.join('')}</sub>` : `${f} ${i ? `(${sum})` : sum}`;
        const key = `${axis}${i + 1}`;
        const [on, off] = [() => light(key), () => light()];
        const term = button(`${letter('l', i + 1)} ${angle}`, on);
        Object.assign(term, { onpointerenter: on, onfocus: on, onpointerleave: off, onblur: off });
        keep(term, () => {
          const [a, b] = pairs(points())[i];
          const className = `term c${i + 1}${state.term === key ? ' hot' : ''}`;
          return { className, ariaLabel: `${axis} part of link ${i + 1}: ${number(b[k] - a[k])}` };
        });
        return i ? [' + ', term] : [term];
      });
      const result = keep(element('b', { class: 'tool' }), () => ({ textContent: number(points().at(-1)[k]) }));
      return row(element('i', {}, axis), ' = ', ...made, ' = ', result);
    }

    const PANELS = {
      drag() {
        sliders();
        tasks(['tool', 'link 1', 'link 2']);
        const hide = button('', () => {
          const any = (least, most) => 5 * Math.round((least + Math.random() * (most - least)) / 5);
          if (state.hidden) state.done.add('cross');
          else {
            state.q = [any(20, 150), any(30, 110) * (Math.random() < 0.5 ? -1 : 1)];
            state.cross = [-2, -2];
          }
          state.hidden = !state.hidden;
          save();
        });
        row(keep(hide, () => ({ textContent: state.hidden ? 'Show the arm' : 'Hide the arm' })));
        says(() => {
          if (state.hidden)
            return 'The arm is hidden. Move the cross to the place where the tool must be, then show the arm.';
          if (!state.cross) return '';
          return `From your cross to the tool it is ${distance(state.cross, points()[2]).toFixed(1)}. A formula gives the exact place.`;
        });
      },
      terms() {
        sliders();
        formula('x', false);
        formula('y', false);
      },
      reference() {
        const REPLIES = {
          'the x axis':
            'The dashed ghost is the arm of your answer. Drag link 1: joints 2 and 3 are locked, but links 2 and 3 of the real arm rotate with link 1. In the ghost they keep their directions. Choose again.',
          'link 1':
            'Right. Each joint rotates all links after it, so the angles add up along the arm. Choose the other answer too, and drag link 1.',
        };
        const choices = Object.keys(REPLIES).map((answer) => {
          const choice = button(`from ${answer}`, () => {
            state.answer = answer;
            state.done.add(answer);
            save();
          });
          return keep(choice, () => ({ ariaPressed: state.answer === answer }));
        });
        row(...choices);
        says(() => REPLIES[state.answer] ?? '');
        sliders();
        const names = lengths.map((_, i) => letter('q', i + 1)).join(' + ');
        const sum = () => `<i>φ</i> = ${names} = <b class="tool">${degree(phi())}</b>`;
        for (const part of [formula('x', true), formula('y', true), written(sum)])
          keep(part, () => ({ hidden: state.answer !== 'link 1' }));
      },
      pins: () => orders('pin'),
      space: () => orders('axis'),
      wall() {
        sliders();
        written(
          () => `<i>φ</i> = <b class="tool">${degree(phi())}</b>, tool at <b class="tool">${place(points()[3])}</b>`,
        );
        tasks(Object.keys(MARKS));
        says(() => state.says);
      },
    };

    function orders(name) {
      const buttons = [3, 2, 1].map((j) => {
        const made = button(`${name} ${j}: ${degree(goal[j - 1])}`, () => press(j), { class: `c${j}` });
        return keep(made, () => ({ ariaDisabled: state.order.includes(j) }));
      });
      buttons.push(button('Home', () => press(0)));
      row(...buttons);
      tasks(['3, 2, 1', BREAKS]);
      says(() => (state.order.length === 3 && state.share === 1 ? state.says : ''));
    }

    // --- the text alternative, true of the present state ---

    function describe() {
      if (scene === 'pins' || scene === 'space') {
        const begin = isPlane
          ? 'Pins at (0, 0), (3, 0) and (5, 0).'
          : 'A spatial arm: axis 1 is vertical, axes 2 and 3 are horizontal.';
        const links = movedLinks();
        const made = state.order.length ? `Rotated in the order ${state.order.join(', ')}.` : 'The arm is at home.';
        const broken = torn(links).map((k) => `after link ${k}`);
        const whole = broken.length ? `The arm is broken ${list(broken)}.` : 'The links fit together.';
        return `${begin} ${made} The tool is at ${shown(links[2][1])}; its goal is ${shown(target())}. ${whole}`;
      }
      const values = state.q.map((q, i) => `q${i + 1} = ${degree(q)}`).join(', ');
      const cross = state.cross ? ` Your cross is at ${place(state.cross)}.` : '';
      if (state.hidden) return `The arm is hidden. ${values}.${cross}`;
      const chain = points();
      const more = {
        drag: cross,
        reference:
          state.answer === 'the x axis' &&
          ` A dashed ghost, with all angles measured from the x axis, has its tool at ${place(joints(state.q, lengths)[3])}.`,
        wall: ` The wall is at x = ${WALL}. φ = ${degree(phi())}. Touched: ${list(touched()) || 'no mark'}.`,
      };
      return `A planar arm of ${lengths.length} links, with its base at the origin. ${values}. Joints after the first: ${list(chain.slice(1, -1).map(place))}. The tool is at ${place(chain.at(-1))}.${more[scene] || ''}`;
    }

    let later;
    function render() {
      const box = stage.getBoundingClientRect();
      if (!box.width) return; // in a tab that is not shown yet
      const [x0, x1, y0, y1] = WINDOWS[scene];
      size = [box.width, box.height];
      unit = Math.min(size[0] / (x1 - x0), size[1] / (y1 - y0));
      origin = [size[0] / 2 - (unit * (x0 + x1)) / 2, size[1] / 2 + (unit * (y0 + y1)) / 2];
      parts = Object.assign([], { handles: new Set() });
      picture();
      paint.innerHTML = parts.join('');
      for (const node of [...handles.children]) if (!parts.handles.has(node)) node.remove();
      for (const update of updates) update();
      clearTimeout(later);
      later = setTimeout(() => {
        alternative.textContent = describe();
        // A slider says its own value; the live region speaks after buttons and movements only.
        if (!running && !held && document.activeElement?.role !== 'slider') live.textContent = describe();
      }, 350);
    }

    PANELS[scene]();
    const observer = new ResizeObserver(render);
    observer.observe(stage);
    render();
    return () => {
      observer.disconnect();
      clearTimeout(later);
      running = null;
      root.remove();
    };
  }

  /** The view of a widget in a notebook: Python keeps what was done. */
  function render({ model, el }) {
    const names = ['scene', 'lengths', 'goal', 'q', 'done'];
    return show(Object.fromEntries(names.map((name) => [name, model.get(name)])), el, ({ q, done }) => {
      model.set('q', q);
      model.set('done', done);
      model.save_changes();
    });
  }

  /** Show all arms of a page without a kernel: this browser keeps what was done, if it stores anything (site/static/course.js). */
  function start() {
    const store = window.kinlibStore;
    for (const host of document.querySelectorAll('[data-planar-arm]')) {
      const state = JSON.parse(host.querySelector('script').textContent);
      const key = `planar-arm ${state.scene}`;
      host.replaceChildren();
      show({ ...state, ...store.read(key) }, host, (kept) => store.write(key, kept));
    }
  }

  return { widget: { render }, start };
})();

// Only a page loads this file as a script; a widget is a module.
if (document.currentScript) document.addEventListener('DOMContentLoaded', planarArm.start);
