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
  function joints(headings, lengths) {
    const points = [[0, 0]];
    for (const [i, l] of lengths.entries()) points.push(add(points[i], [l * cos(headings[i]), l * sin(headings[i])]));
    return points;
  }

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

  const number = (value) => (Math.abs(value) < 0.005 ? 0 : value).toFixed(2).replace('-', '−');
  const degree = (angle) => `${Math.round(angle)}°`.replace('-', '−');
  const place = (point) => `(${point.map(number).join(', ')})`;
  const list = (words) => (words.length > 1 ? `${words.slice(0, -1).join(', ')} and ${words.at(-1)}` : words.join());

  // --- the scenes: what the reader may touch, and what is drawn beside the arm ---

  const PLANE = {
    axes: [0, 3, 5].map((x) => ({ point: [x, 0, 0], along: [0, 0, 1] })),
    home: [
      [0, 0, 0],
      [3, 0, 0],
      [5, 0, 0],
      [6, 0, 0],
    ],
  };
  const SPACE = {
    axes: [
      { point: [0, 0, 0], along: [0, 0, 1] },
      { point: [0, 0, 1.8], along: [0, 1, 0] },
      { point: [2.4, 0, 1.8], along: [0, 1, 0] },
    ],
    home: [
      [0, 0, 0],
      [0, 0, 1.8],
      [2.4, 0, 1.8],
      [4.2, 0, 1.8],
    ],
  };
  const MARKS = { A: [4, 3], B: [4, 1], C: [4, -2] };
  const WALL = 4;

  /** What the picture shows at least: x from, x to, y from, y to. */
  const WINDOWS = {
    drag: [-5.6, 5.6, -4.4, 5.4],
    terms: [-5.6, 5.6, -5.4, 5.4],
    reference: [-6.3, 6.5, -5.2, 6.2],
    pins: [-4, 7.4, -3, 6.4],
    space: [-3.6, 4.8, -2.4, 4.9],
    wall: [-4.6, 5.6, -3.4, 5.2],
  };

  // --- elements ---

  const SVG = 'http://www.w3.org/2000/svg';
  const ARROWS = { ArrowRight: [1, 0], ArrowLeft: [-1, 0], ArrowUp: [0, 1], ArrowDown: [0, -1] };
  const still = matchMedia('(prefers-reduced-motion: reduce)');

  function element(name, attributes = {}, ...children) {
    const made = document.createElement(name);
    for (const [key, value] of Object.entries(attributes)) {
      if (typeof value === 'function') made.addEventListener(key, value);
      else made.setAttribute(key, value);
    }
    made.append(...children);
    return made;
  }

  /** A letter with an index, for example q and 1, as HTML. */
  const letter = (name, index) => `<i>${name}</i><sub>${index}</sub>`;

  /** Show an arm in an element. The model has scene, q (degrees) and done; returns the function that ends the view. */
  function show(model, host) {
    const scene = model.get('scene');
    const lengths = model.get('lengths');
    const goal = model.get('goal');
    const machine = scene === 'space' ? SPACE : PLANE;
    const state = {
      q: [...model.get('q')],
      done: new Set(model.get('done')),
      term: null, // the term that is lit, such as x1
      lit: null, // what lit it: 'picture' or 'text'
      hidden: false,
      cross: null,
      answer: null, // the line from which joint 2 is said to be measured
      order: [], // the joints that were pressed
      share: 1, // how much of the last rotation has been made
      view: -62,
      says: '',
    };
    const stage = document.createElementNS(SVG, 'svg');
    const paint = stage.appendChild(document.createElementNS(SVG, 'g'));
    const handles = stage.appendChild(document.createElementNS(SVG, 'g'));
    const panel = element('div', { class: 'planar-panel' });
    const alternative = element('p', {});
    const live = element('p', { class: 'planar-live', 'aria-live': 'polite' });
    stage.setAttribute('role', 'group');
    stage.setAttribute('aria-label', 'Picture of the arm');
    paint.setAttribute('aria-hidden', 'true');
    const words = element('details', {}, element('summary', {}, 'The picture in words'), alternative);
    const root = element(
      'div',
      { class: 'planar-arm', 'data-lm-suppress-shortcuts': 'true' },
      stage,
      panel,
      words,
      live,
    );
    host.append(root);

    const save = () => {
      model.set('q', [...state.q]);
      model.set('done', [...state.done]);
      model.save_changes();
    };
    const mark = (task) => state.done.add(task);

    // --- a painter: the same key keeps the same element, so that focus and dragging survive ---

    const nodes = new Map();
    const specs = new WeakMap();
    let used;
    let last;
    let unit; // pixels
    let origin;
    let size;

    function put(parent, key, name, attributes, content) {
      let node = nodes.get(key);
      if (!node) {
        node = document.createElementNS(SVG, name);
        nodes.set(key, node);
        if (parent === handles) parent.append(node); // a handle never moves in the document: it would lose the focus
      }
      for (const [attribute, value] of Object.entries(attributes)) {
        if (node.getAttribute(attribute) !== String(value)) node.setAttribute(attribute, value);
      }
      if (content !== undefined && node.dataset.content !== content) node.innerHTML = node.dataset.content = content;
      if (parent === paint) {
        const next = last ? last.nextSibling : paint.firstChild;
        if (node !== next) paint.insertBefore(node, next);
        last = node;
      }
      used.add(key);
      return node;
    }

    const draw = (key, name, attributes, content) => put(paint, key, name, attributes, content);
    const X = (x) => origin[0] + x * unit;
    const Y = (y) => origin[1] - y * unit;
    const at = (point) => [X(point[0]), Y(point[1])];
    const offset = ([x, y], r, angle) => [x + r * cos(angle), y - r * sin(angle)];
    const text = (points) => points.map((p) => p.map((value) => value.toFixed(1))).join(' ');
    const line = (key, [x1, y1], [x2, y2], style, more = {}) =>
      draw(key, 'line', { x1, y1, x2, y2, class: style, ...more });
    const dot = (key, [cx, cy], r, style) => draw(key, 'circle', { cx, cy, r, class: style });
    const path = (key, points, style, more = {}) =>
      draw(key, 'polyline', { points: text(points), class: style, ...more });
    const shape = (key, points, style) => draw(key, 'polygon', { points: text(points), class: style });
    const width = () => clamp(unit * 0.36, 12, 26);
    const arcPoints = (centre, r, from, by) => {
      const n = Math.max(2, Math.ceil(Math.abs(by) / 6));
      return Array.from({ length: n + 1 }, (_, k) => offset(centre, r, from + (by * k) / n));
    };

    /** A label; "*q*_1" becomes a letter of mathematics with an index. */
    function label(key, [x, y], content, style = '') {
      const index = (digit) =>
        digit ? `<tspan class="sub" dy="5">${digit}</tspan><tspan dy="-5">&#8203;</tspan>` : '';
      const marked = content.replace(
        /\*(.+?)\*(?:_(\d+))?/g,
        (_, name, digit) => `<tspan class="mi">${name}</tspan>${index(digit)}`,
      );
      draw(key, 'text', { x: x.toFixed(1), y: y.toFixed(1), class: style }, marked);
    }

    function arrow(key, a, b, style, half = 6) {
      const head = Math.min(distance(a, b) || 1, half * 2);
      const angle = degrees(Math.atan2(a[1] - b[1], b[0] - a[0]));
      const neck = offset(b, -head, angle);
      line(key, a, neck, `seg ${style}`);
      shape(`${key}>`, [b, offset(neck, half, angle + 90), offset(neck, half, angle - 90)], `head ${style}`);
    }

    /** Something to take with mouse, finger or keys: drag(point, grip), key(dx, dy), and what is said of it. */
    function handle(key, name, attributes, { says, now, value, ...spec }) {
      const aria = { role: 'slider', 'aria-label': says, 'aria-valuenow': Math.round(now), 'aria-valuetext': value };
      const range = { 'aria-valuemin': -180, 'aria-valuemax': 180, tabindex: 0 };
      specs.set(put(handles, `handle ${key}`, name, { ...aria, ...range, class: 'hit', ...attributes }), spec);
    }

    // --- input ---

    const world = (event) => {
      const box = stage.getBoundingClientRect();
      return [(event.clientX - box.left - origin[0]) / unit, -(event.clientY - box.top - origin[1]) / unit];
    };
    let held = null;
    stage.addEventListener('pointerdown', (event) => {
      const spec = specs.get(event.target);
      if (!spec || event.button) return;
      finish();
      event.target.focus({ preventScroll: true, focusVisible: false });
      stage.setPointerCapture(event.pointerId);
      held = { spec, grip: spec.grab?.(world(event)) };
      if (event.pointerType === 'mouse') event.preventDefault();
    });
    stage.addEventListener('pointermove', (event) => {
      if (held) {
        held.spec.drag(world(event), held.grip);
        render();
        return;
      }
      const term = event.target.dataset?.term;
      if (term) light(term, 'picture');
      else if (state.lit === 'picture') light(null);
    });
    for (const name of ['pointerup', 'pointercancel', 'lostpointercapture']) {
      stage.addEventListener(name, () => {
        if (!held) return;
        held = null;
        save();
        render();
      });
    }
    root.addEventListener('keydown', (event) => {
      const step = ARROWS[event.key];
      const spec = specs.get(event.target);
      if (!step || !spec) return;
      event.preventDefault();
      event.stopPropagation(); // JupyterLab would select another cell
      finish();
      const scale = event.shiftKey ? 10 : 1;
      spec.key(step[0] * scale, step[1] * scale);
      save();
      render();
    });

    // --- animation: one at a time; for readers who want no motion only its end is shown ---

    let running = null;
    function finish() {
      if (!running) return;
      const { frame, at: moment } = running;
      running = null;
      cancelAnimationFrame(frame);
      moment(1);
    }
    function animate(milliseconds, moment) {
      finish();
      if (still.matches || document.hidden) {
        moment(1);
        render();
        return;
      }
      const own = { at: moment };
      running = own;
      const start = performance.now();
      const tick = (now) => {
        if (running !== own) return;
        const t = clamp((now - start) / milliseconds, 0, 1);
        moment(t * t * (3 - 2 * t));
        if (t < 1) own.frame = requestAnimationFrame(tick);
        else running = null;
        render();
      };
      own.frame = requestAnimationFrame(tick);
    }
    function setJoint(i, value) {
      state.q[i] = Math.round(wrap(value));
      mark(`link ${i + 1}`);
      state.cross = state.hidden ? state.cross : null;
    }
    const light = (term, by = null) => {
      if (state.term === term) return;
      state.term = term;
      state.lit = by;
      render();
    };

    // --- parts of the picture ---

    const points = () => joints(sums(state.q), lengths);
    const phi = () => wrap(sums(state.q).at(-1));

    function grid() {
      const [left, right] = [-origin[0] / unit, (size[0] - origin[0]) / unit];
      const [low, high] = [(origin[1] - size[1]) / unit, origin[1] / unit];
      for (let x = Math.ceil(left); x <= right; x++)
        line(`grid x ${x}`, [X(x), 0], [X(x), size[1]], x ? 'grid' : 'axis');
      for (let y = Math.ceil(low); y <= high; y++) line(`grid y ${y}`, [0, Y(y)], [size[0], Y(y)], y ? 'grid' : 'axis');
      label('x', [size[0] - 14, Y(0) - 8], '*x*', 'end');
      label('y', [X(0) + 9, 20], '*y*');
      for (const value of [-4, -2, 2, 4]) {
        const shown = String(value).replace('-', '−');
        if (value > left && value < right) label(`number x ${value}`, [X(value), Y(0) + 17], shown, 'soft mid');
        if (value > low && value < high) label(`number y ${value}`, [X(0) - 7, Y(value) + 5], shown, 'soft end');
      }
    }

    /** Links [[a, b], ...] in the plane; they need not be connected. The last one carries the pen. */
    function arm(links, faint = () => false) {
      const w = width();
      draw('base', 'rect', { x: X(0) - w, y: Y(0) - w, width: 2 * w, height: 2 * w, rx: 6, class: 'base' });
      links.forEach(([a, b], i) => {
        const style = faint(i) ? ' faint' : '';
        const heading = direction(a, b);
        const end = i === links.length - 1 ? between(b, a, 0.45 / distance(a, b)) : b;
        line(`edge ${i}`, at(a), at(end), `edge${style}`, { 'stroke-width': w + 4 });
        line(`link ${i}`, at(a), at(end), `link c${i + 1}${style}`, { 'stroke-width': w });
        if (end !== b) {
          shape(
            'pen',
            [at(b), offset(at(end), w / 2, heading + 90), offset(at(end), w / 2, heading - 90)],
            `pen${style}`,
          );
        }
        dot(`joint ${i}`, at(a), w * 0.42, `joint${style}`);
      });
      for (const [i, [a, b]] of links.entries()) {
        label(`name ${i}`, at(between(a, b, 0.42)), String(i + 1), faint(i) ? 'on faint' : 'on');
      }
    }

    function ghost(ghosts, name, first) {
      path('under', ghosts.slice(first).map(at), 'under');
      path('ghost', ghosts.slice(first).map(at), 'ghost');
      dot('ghost tip', at(ghosts.at(-1)), 5, 'ghost-tip');
      beyond('ghost name', ghosts, name, 'soft', 60);
    }

    /** A label beyond the tool, on one side of the direction of the last link. */
    function beyond(key, chain, name, style, turn = -50) {
      const [a, b] = chain.slice(-2);
      const heading = direction(a, b) + turn;
      const [x, y] = offset(at(b), 22, heading);
      let anchor = x > size[0] - 90 ? ' end' : '';
      if (cos(heading) < 0.4) anchor = cos(heading) < -0.4 ? ' end' : ' mid';
      label(key, [x, y + 5 - 6 * sin(heading)], name, style + anchor);
    }

    function gap(a, b) {
      if (distance(a, b) < 0.05) return;
      line('gap', at(a), at(b), 'gap');
      label('gap name', add(at(between(a, b, 0.6)), [8, 5]), `${number(distance(a, b))} apart`);
    }

    /** The angle of joint i, from the direction of the link before it (a dashed line). */
    function angleOf(i, centre, from, by) {
      const r = width() * 1.75 + 2 * i;
      const arc = arcPoints(at(centre), r, from, by);
      line(`reference ${i}`, at(centre), offset(at(centre), r * 1.75, from), 'drop');
      path(`angle ${i}`, arc, `arc c${i + 1}${state.term === `q${i + 1}` ? ' hot' : ''}`);
      if (Math.abs(by) > 12) {
        const back = from + by + (by < 0 ? 90 : -90);
        shape(
          `angle head ${i}`,
          [arc.at(-1), offset(arc.at(-1), 11, back - 24), offset(arc.at(-1), 11, back + 24)],
          `head c${i + 1}`,
        );
      }
      // A large angle has room for its label; that of a small one is put on the other side of the dashed line.
      const beside = from - (by < 0 ? -24 : 24);
      const side = Math.abs(by) > 76 || scene === 'terms' ? from + by / 2 : beside;
      const [x, y] = offset(at(centre), r + 12, side);
      let anchor = '';
      if (cos(side) < 0.35) anchor = cos(side) < -0.35 ? ' end' : ' mid';
      label(
        `angle name ${i}`,
        [x, y + (sin(side) < -0.5 ? 13 : 5)],
        `*q*_${i + 1} = ${degree(by)}`,
        `num c${i + 1}${anchor}`,
      );
    }
    const angles = (chain) => {
      state.q.forEach((q, i) => {
        if (!'xy'.includes(state.term?.[0] ?? '-') || state.term[1] !== String(i + 1)) {
          angleOf(i, chain[i], i ? sums(state.q)[i - 1] : 0, wrap(q));
        }
      });
    };

    function linkHandles(chain) {
      pairs(chain).forEach(([a, b], i) => {
        const [[x1, y1], [x2, y2]] = [at(a), at(b)];
        handle(
          `link ${i + 1}`,
          'line',
          { x1, y1, x2, y2, 'stroke-width': Math.max(36, width() + 12) },
          {
            says: `Link ${i + 1}, rotates about joint ${i + 1}`,
            now: state.q[i],
            value: `q${i + 1} = ${Math.round(state.q[i])} degrees`,
            grab: (p) => state.q[i] - direction(a, p),
            drag: (p, grip) => setJoint(i, grip + direction(a, p)),
            key: (dx, dy) => setJoint(i, state.q[i] + dx + dy),
          },
        );
      });
    }

    /** A handle that moves in two directions. */
    function pointHandle(key, says, point, move) {
      handle(
        key,
        'circle',
        { cx: X(point[0]), cy: Y(point[1]), r: 24 },
        {
          says,
          now: point[0],
          value: `x = ${point[0].toFixed(1)}, y = ${point[1].toFixed(1)}`,
          grab: (p) => [point[0] - p[0], point[1] - p[1]],
          drag: (p, grip) => move(add(p, grip)),
          key: (dx, dy) => move(add(point, [dx * 0.1, dy * 0.1])),
        },
      );
    }

    /** The terms of x and y as arrows beside the axes, on the side where the arm is not. */
    function terms(chain) {
      const margin = width() + 12;
      const dim = state.term && state.term[0] !== 'q';
      const mean = (k) => chain.reduce((sum, p) => sum + p[k], 0);
      const [sideX, sideY] = [mean(0) < 0 ? 1 : -1, mean(1) < 0 ? -1 : 1];
      pairs(chain).forEach(([a, b], i) => {
        const [x, y] = [X(0) + sideX * (margin + i * 16), Y(0) + sideY * (margin + i * 16)];
        const [middleX, middleY] = at(between(a, b, 0.5));
        line(`drop x ${i}`, at(b), [X(b[0]), y], 'drop');
        line(`drop y ${i}`, at(b), [x, Y(b[1])], 'drop');
        if (state.term === `x${i + 1}` || state.term === `y${i + 1}`) triangle(i, a, b);
        const outside = margin + lengths.length * 16;
        const parts = [
          [
            `x${i + 1}`,
            b[0] - a[0],
            [X(a[0]), y],
            [X(b[0]), y],
            [middleX, Y(0) + sideY * (outside + 16 * i) + 5],
            'mid',
          ],
          [
            `y${i + 1}`,
            b[1] - a[1],
            [x, Y(a[1])],
            [x, Y(b[1])],
            [X(0) + sideX * (outside + 4), middleY + 5],
            sideX < 0 ? 'end' : '',
          ],
        ];
        for (const [term, value, from, to, where, anchor] of parts) {
          let style = `c${i + 1}`;
          if (state.term === term) style += ' hot';
          else if (dim) style += ' faint';
          arrow(term, from, to, style);
          if (Math.abs(value) > 0.04) label(`number ${term}`, where, number(value), `num ${anchor} ${style}`);
          line(`over ${term}`, from, to, 'over', { stroke: 'transparent', 'stroke-width': 15, 'data-term': term });
        }
      });
    }

    /** The right triangle of a link, with the angle between the link and the x axis. */
    function triangle(i, a, b) {
      const sum = wrap(sums(state.q)[i]);
      const r = width() * 1.9;
      path(`triangle ${i}`, [at(a), at([b[0], a[1]]), at(b)], `arc c${i + 1}`);
      path(`sum ${i}`, arcPoints(at(a), r, 0, sum), `arc c${i + 1} hot`);
      const name = `${state.q
        .slice(0, i + 1)
        .map((_, k) => `*q*_${k + 1}`)
        .join(' + ')} = ${degree(sum)}`;
      label(`sum name ${i}`, add(offset(at(a), r + 16, sum / 2), [8, 5]), name, `num c${i + 1}`);
    }

    // --- the rotations about fixed axes, of scenes "pins" and "space" ---

    /** A point of link k after the rotations that were pressed: joint j moves the links k >= j. */
    const moved = (p, k) =>
      state.order.reduce((point, j, n) => {
        const share = n === state.order.length - 1 ? state.share : 1;
        return j <= k ? rotate(point, machine.axes[j - 1], share * goal[j - 1]) : point;
      }, p);
    const movedLinks = () => [1, 2, 3].map((k) => [moved(machine.home[k - 1], k), moved(machine.home[k], k)]);
    const tool = () => moved(machine.home[3], 3);
    const truth = () => [3, 2, 1].reduce((p, j) => rotate(p, machine.axes[j - 1], goal[j - 1]), machine.home[3]);
    const torn = () => [1, 2].filter((k) => distance(moved(machine.home[k], k), moved(machine.home[k], k + 1)) > 0.05);

    function press(j) {
      if (j === 0) {
        finish();
        state.order = [];
        state.says = '';
      } else if (!state.order.includes(j)) {
        finish();
        state.order.push(j);
        animate(900, (t) => {
          state.share = t;
          if (t === 1 && state.order.length === 3) judge();
        });
      }
      render();
    }

    function judge() {
      const order = state.order.join(', ');
      const miss = distance(tool(), truth());
      mark(order);
      save();
      state.says =
        miss > 0.01
          ? `Order ${order}: the links no longer meet, and the tool misses its goal by ${number(miss)}.`
          : `Order ${order}: the links fit together, and the tool is at its goal, ${place(truth().slice(0, scene === 'pins' ? 2 : 3))}.`;
    }

    function tears(project) {
      for (const k of torn()) {
        const [a, b] = [moved(machine.home[k], k), moved(machine.home[k], k + 1)].map(project);
        line(`tear ${k}`, a, b, 'gap');
      }
    }

    const SCENES = {
      drag() {
        grid();
        const chain = points();
        if (!state.hidden) {
          arm(pairs(chain));
          angles(chain);
          beyond('tool', chain, 'tool', 'tool');
        }
        if (state.cross) {
          const [x, y] = at(state.cross);
          line('cross a', [x - 12, y - 12], [x + 12, y + 12], 'cross');
          line('cross b', [x - 12, y + 12], [x + 12, y - 12], 'cross');
          label('cross name', [x + 18, y + 6], 'your cross');
          if (!state.hidden) gap(state.cross, chain[2]);
        }
        if (state.hidden) {
          pointHandle('cross', 'Your cross, moves in the plane', state.cross, (p) => {
            state.cross = p.map((value) => clamp(value, -5, 5));
          });
          return;
        }
        linkHandles(chain);
        dot('ring', at(chain[2]), 15, `ring${state.done.has('tool') ? '' : ' pulse'}`);
        pointHandle('tool', 'Tool, moves in the plane', chain[2], (p) => {
          state.q = reach(lengths, p, state.q[1] < 0 ? -1 : 1).map(wrap);
          state.cross = null;
          mark('tool');
        });
      },
      terms() {
        grid();
        const chain = points();
        arm(pairs(chain));
        terms(chain);
        angles(chain);
        linkHandles(chain);
      },
      reference() {
        grid();
        const chain = points();
        const wrong = joints(state.q, lengths); // as if each angle began at the x axis
        if (state.answer === 'the x axis') {
          ghost(wrong, 'your answer', 1);
          gap(chain[3], wrong[3]);
        }
        arm(pairs(chain));
        if (state.answer === 'link 1') {
          terms(chain);
          angles(chain);
        }
        linkHandles(chain);
        beyond('tool', chain, 'tool', 'tool');
      },
      pins() {
        grid();
        path('home', machine.home.map(at), 'home');
        const links = movedLinks();
        arm(links, (i) => !state.order.some((j) => j <= i + 1) && state.order.length > 0);
        machine.axes.forEach(({ point }, i) => {
          dot(`pin ${i}`, at(point), 8, `pin c${i + 1}`);
          label(`pin name ${i}`, add(at(point), [0, width() + 18]), `pin ${i + 1}`, `num mid c${i + 1}`);
        });
        tears(at);
        dot('goal', at(truth()), 10, 'mark');
        label('goal name', add(at(truth()), [14, -8]), 'goal');
      },
      space() {
        const tilt = 24;
        const back = ([x, y]) => x * sin(state.view) + y * cos(state.view); // away from the eye
        const project = (p) =>
          at([p[0] * cos(state.view) - p[1] * sin(state.view), back(p) * sin(tilt) + p[2] * cos(tilt)]);
        for (let i = -4; i <= 4; i += 2) {
          line(`floor x ${i}`, project([i, -4, 0]), project([i, 4, 0]), 'grid');
          line(`floor y ${i}`, project([-4, i, 0]), project([4, i, 0]), 'grid');
        }
        machine.axes.forEach(({ point, along }, i) => {
          const end = (m) => project(point.map((value, k) => value + along[k] * m));
          const [from, to] = i ? [-1.7, 1.7] : [-0.7, 3.1];
          line(`axis ${i}`, end(from), end(to), `screw c${i + 1}`);
          label(`axis name ${i}`, add(end(to), [0, -10]), `axis ${i + 1}`, `num mid c${i + 1}`);
        });
        path('home', machine.home.map(project), 'home');
        const links = movedLinks();
        const depth = ([a, b]) => back(add(a, b));
        const w = width() * 0.8;
        for (const i of [0, 1, 2].sort((a, b) => depth(links[b]) - depth(links[a]))) {
          const [a, b] = links[i].map(project);
          line(`edge ${i}`, a, b, 'edge', { 'stroke-width': w + 4 });
          line(`link ${i}`, a, b, `link c${i + 1}`, { 'stroke-width': w });
          dot(`joint ${i}`, a, w * 0.42, 'joint');
          label(`name ${i}`, between(a, b, 0.5), String(i + 1), 'on');
        }
        tears(project);
        dot('pen', project(tool()), w * 0.5, 'pen');
        dot('goal', project(truth()), 10, 'mark');
        label('goal name', add(project(truth()), [14, -8]), 'goal');
        handle(
          'view',
          'rect',
          { x: 4, y: 4, width: size[0] - 8, height: size[1] - 8, class: 'hit orbit' },
          {
            says: 'View, rotates about the vertical',
            now: wrap(state.view),
            value: `view from ${Math.round(wrap(state.view))} degrees`,
            grab: (p) => [p[0], state.view],
            drag: (p, grip) => {
              state.view = grip[1] + (p[0] - grip[0]) * 30;
            },
            key: (dx) => {
              state.view += dx * 5;
            },
          },
        );
      },
      wall() {
        grid();
        const chain = points();
        draw('wall', 'rect', {
          x: X(WALL),
          y: 0,
          width: Math.max(0, size[0] - X(WALL)),
          height: size[1],
          class: 'wall',
        });
        label('wall name', [X(WALL) + 12, 26], 'wall');
        for (const [name, where] of Object.entries(MARKS)) {
          const touched = state.done.has(name);
          dot(`mark ${name}`, at(where), 9, `mark${touched ? ' ok' : ''}`);
          label(`mark name ${name}`, add(at(where), [18, 6]), touched ? `${name} ✓` : name);
        }
        arm(pairs(chain));
        angles(chain);
        linkHandles(chain);
        touch(chain[3]);
      },
    };

    function touch(tip) {
      const name = Object.keys(MARKS).find((one) => distance(tip, MARKS[one]) < 0.13);
      if (tip[0] > WALL + 0.13) state.says = 'The pen is inside the wall.';
      else if (!name) state.says = '';
      else if (Math.abs(phi()) > 3)
        state.says = `At mark ${name}, but φ = ${degree(phi())}: the pen must be perpendicular to the wall.`;
      else {
        mark(name);
        const touched = Object.keys(MARKS).filter((one) => state.done.has(one));
        const all = ' From poses of the tool you have found joint values: this is inverse kinematics.';
        state.says = `Mark ${name} is touched.${touched.length === 3 ? ` All three are.${all}` : ''}`;
      }
    }

    // --- below the picture ---

    /** A slider for a joint value. */
    function slider(i) {
      const input = element('input', { type: 'range', min: -180, max: 180, class: `c${i + 1}` });
      const value = element('b', {});
      input.addEventListener('input', () => {
        finish();
        setJoint(i, Number(input.value));
        render();
      });
      input.addEventListener('change', save);
      updates.push(() => {
        input.value = Math.round(state.q[i]);
        input.setAttribute('aria-valuetext', `${Math.round(state.q[i])} degrees`);
        value.textContent = degree(state.q[i]);
      });
      const name = element('span', {});
      name.innerHTML = `${letter('q', i + 1)} `;
      return element('label', { class: `c${i + 1}` }, name, input, value);
    }

    const updates = []; // what brings each part of the panel up to date
    const button = (content, press_, attributes = {}) => {
      const made = element('button', { type: 'button', click: press_, ...attributes });
      made.innerHTML = content;
      return made;
    };
    const row = (...children) => panel.appendChild(element('div', { class: 'row' }, ...children));
    const says = (text_) => {
      const note = panel.appendChild(element('p', { class: 'note' }));
      updates.push(() => {
        if (note.textContent !== text_()) note.textContent = text_();
        note.hidden = !text_();
      });
    };
    const numbers = () => row(...state.q.map((_, i) => slider(i)));
    const tasks = (names) => {
      const items = names.map((name) => element('li', {}, name));
      panel.append(element('ul', { class: 'tasks' }, ...items));
      updates.push(() => {
        items.forEach((item, k) => {
          item.classList.toggle('done', state.done.has(names[k]));
        });
      });
    };

    /** x = l1 cos q1 + ..., whose terms light their arrows; the short form writes c12 for cos(q1 + q2). */
    function formula(axis, short) {
      const f = axis === 'x' ? 'cos' : 'sin';
      const term = (i) => {
        const indices = lengths.slice(0, i + 1).map((_, k) => k + 1);
        const sum = indices.map((k) => letter('q', k)).join(' + ');
        const angle = short ? `<i>${f[0]}</i><sub>${indices.join('')}</sub>` : `${f} ${i ? `(${sum})` : sum}`;
        const key = `${axis}${i + 1}`;
        const made = button(`${letter('l', i + 1)} ${angle}`, () => light(key, 'text'), { class: `term c${i + 1}` });
        for (const name of ['pointerenter', 'focus']) made.addEventListener(name, () => light(key, 'text'));
        for (const name of ['pointerleave', 'blur']) made.addEventListener(name, () => light(null));
        updates.push(() => {
          const [a, b] = pairs(points())[i];
          const value = axis === 'x' ? b[0] - a[0] : b[1] - a[1];
          made.classList.toggle('hot', state.term === key);
          made.setAttribute('aria-label', `${axis} part of link ${i + 1}: ${number(value)}`);
        });
        return made;
      };
      const result = element('b', { class: 'tool' });
      updates.push(() => {
        result.textContent = number(points().at(-1)[axis === 'x' ? 0 : 1]);
      });
      const name = element('i', {}, axis);
      return row(name, ' = ', ...lengths.flatMap((_, i) => (i ? [' + ', term(i)] : [term(i)])), ' = ', result);
    }

    const PANELS = {
      drag() {
        numbers();
        tasks(['tool', 'link 1', 'link 2']);
        const hide = button('', () => {
          finish();
          const any = (least, most) => 5 * Math.round((least + Math.random() * (most - least)) / 5);
          if (!state.hidden) {
            state.q = [any(20, 150), any(30, 110) * (Math.random() < 0.5 ? -1 : 1)];
            state.cross = [-2, -2];
          }
          state.hidden = !state.hidden;
          if (!state.hidden) mark('cross');
          save();
          render();
        });
        updates.push(() => {
          hide.textContent = state.hidden ? 'Show the arm' : 'Hide the arm';
        });
        row(hide);
        says(() => {
          if (state.hidden)
            return 'The arm is hidden. Move the cross to the place where the tool must be, then show the arm.';
          if (!state.cross) return '';
          return `From your cross to the tool it is ${distance(state.cross, points()[2]).toFixed(1)}. A formula gives the exact place.`;
        });
      },
      terms() {
        numbers();
        formula('x', false);
        formula('y', false);
      },
      reference() {
        const choices = ['the x axis', 'link 1'].map((line_) =>
          button(`from ${line_}`, () => {
            state.answer = line_;
            mark(line_);
            save();
            render();
          }),
        );
        row(...choices);
        updates.push(() => {
          choices.forEach((choice, k) => {
            choice.setAttribute('aria-pressed', state.answer === ['the x axis', 'link 1'][k]);
          });
        });
        says(() => {
          if (state.answer === 'the x axis')
            return 'The dashed ghost is the arm of your answer. Drag link 1: joints 2 and 3 are locked, but links 2 and 3 of the real arm rotate with link 1. In the ghost they keep their directions. Choose again.';
          if (state.answer)
            return 'Right. Each joint rotates all links after it, so the angles add up along the arm. Choose the other answer too, and drag link 1.';
          return '';
        });
        numbers();
        const after = [formula('x', true), formula('y', true)];
        const heading = row();
        updates.push(() => {
          heading.innerHTML = `<i>φ</i> = ${state.q.map((_, i) => letter('q', i + 1)).join(' + ')} = <b class="tool">${degree(phi())}</b>`;
          for (const part of [...after, heading]) part.hidden = state.answer !== 'link 1';
        });
      },
      pins: () => orders('pin'),
      space: () => orders('axis'),
      wall() {
        numbers();
        const result = row();
        updates.push(() => {
          result.innerHTML = `<i>φ</i> = <b class="tool">${degree(phi())}</b>, tool at <b class="tool">${place(points()[3])}</b>`;
        });
        tasks(['A', 'B', 'C']);
        says(() => state.says);
      },
    };

    function orders(name) {
      const buttons = [3, 2, 1].map((j) =>
        button(`${name} ${j}: ${degree(goal[j - 1])}`, () => press(j), { class: `c${j}` }),
      );
      row(
        ...buttons,
        button('Home', () => press(0)),
      );
      updates.push(() => {
        buttons.forEach((one, k) => {
          one.setAttribute('aria-disabled', state.order.includes(3 - k));
        });
      });
      tasks(scene === 'pins' ? ['3, 2, 1', '1, 2, 3'] : ['3, 2, 1']);
      says(() => (state.order.length === 3 && state.share === 1 ? state.says : ''));
    }

    // --- the text alternative, true of the present state ---

    function describe() {
      const values = state.q.map((q, i) => `q${i + 1} = ${degree(q)}`).join(', ');
      if (scene === 'pins' || scene === 'space') {
        const begin =
          scene === 'pins'
            ? 'Pins at (0, 0), (3, 0) and (5, 0).'
            : 'A spatial arm: axis 1 is vertical, axes 2 and 3 are horizontal.';
        const made = state.order.length ? `Rotated in the order ${state.order.join(', ')}.` : 'The arm is at home.';
        const shown = (p) => place(scene === 'pins' ? p.slice(0, 2) : p);
        const whole = torn().length ? `The arm is broken after link ${list(torn())}.` : 'The links fit together.';
        return `${begin} ${made} The tool is at ${shown(tool())}; its goal is ${shown(truth())}. ${whole}`;
      }
      if (state.hidden) return `The arm is hidden. ${values}. Your cross is at ${place(state.cross)}.`;
      const chain = points();
      const joint = chain.slice(1, -1).map(place);
      let more = state.cross ? ` Your cross is at ${place(state.cross)}.` : '';
      if (scene === 'reference' && state.answer === 'the x axis') {
        const wrong = joints(state.q, lengths)[3];
        more = ` A dashed ghost, with all angles measured from the x axis, has its tool at ${place(wrong)}.`;
      }
      if (scene === 'wall') {
        const touched = Object.keys(MARKS).filter((name) => state.done.has(name));
        more = ` The wall is at x = ${WALL}. φ = ${degree(phi())}. Touched: ${list(touched) || 'no mark'}.`;
      }
      return `A planar arm of ${lengths.length} links, with its base at the origin. ${values}. Joints after the first: ${list(joint)}. The tool is at ${place(chain.at(-1))}.${more}`;
    }

    let later;
    function render() {
      const box = stage.getBoundingClientRect();
      if (!box.width) return; // in a tab that is not shown yet
      const [x0, x1, y0, y1] = WINDOWS[scene];
      size = [box.width, box.height];
      unit = Math.min(size[0] / (x1 - x0), size[1] / (y1 - y0));
      origin = [size[0] / 2 - (unit * (x0 + x1)) / 2, size[1] / 2 + (unit * (y0 + y1)) / 2];
      used = new Set();
      last = null;
      SCENES[scene]();
      for (const [key, node] of nodes) {
        if (used.has(key)) continue;
        node.remove();
        nodes.delete(key);
      }
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

  /** The model of an arm on a page without a kernel: it remembers in this browser, where that is allowed. */
  function pageModel(state) {
    const key = `planar-arm ${state.scene}`;
    try {
      Object.assign(state, JSON.parse(localStorage.getItem(key) ?? '{}'));
    } catch {
      // The browser refuses storage: the arm begins anew on each visit.
    }
    return {
      get: (name) => state[name],
      set: (name, value) => {
        state[name] = value;
      },
      save_changes: () => {
        try {
          localStorage.setItem(key, JSON.stringify({ q: state.q, done: state.done }));
        } catch {
          // As above.
        }
      },
    };
  }

  return {
    widget: { render: ({ model, el }) => show(model, el) },
    start: () => {
      for (const host of document.querySelectorAll('[data-planar-arm]')) {
        const state = JSON.parse(host.querySelector('script').textContent);
        host.replaceChildren();
        show(pageModel(state), host);
      }
    },
  };
})();

// Only a page loads this file as a script; a widget is a module.
if (document.currentScript) document.addEventListener('DOMContentLoaded', planarArm.start);
