// The stage holds the layers of parts, the floor, the lights and the camera, and paints them when something changes.
// A layer is a named set of parts that can be shown or hidden; parts.js defines what a part is.
import {
  BackSide,
  BufferGeometry,
  Color,
  DirectionalLight,
  DoubleSide,
  Float32BufferAttribute,
  GreaterDepth,
  HemisphereLight,
  LineBasicMaterial,
  LineSegments,
  Mesh,
  MeshBasicMaterial,
  MeshLambertMaterial,
  NotEqualStencilFunc,
  Raycaster,
  ReplaceStencilOp,
  Scene,
  ShaderMaterial,
  Vector2,
  Vector3,
  Vector4,
} from 'three';
import { KinematicTree } from '../scene/kinematic-tree.js';
import { drawLabels, fontOf } from '../scene/labels.js';
import { mergeMeshes } from '../scene/meshes.js';
import { mergeParts } from '../scene/shapes.js';
import { Camera } from './camera.js';
import { hasWebGL, prepareScene, renderScene } from './webgl.js';

const MAX_SHADED_CORNERS = 300_000; // without a graphics card, the shadow of more takes too long

export class Stage {
  /** @param data the scene, see kinlib/view/viewer/scene.py; @param canvas the 2-D canvas of the picture */
  constructor(data, canvas, theme) {
    this.data = data;
    this.canvas = canvas;
    this.context = canvas.getContext('2d');
    this.theme = theme;
    this.tree = new KinematicTree(data.arms);
    this.layers = new Map();
    /** whether there is no WebGL; undefined before the first attempt to start it */
    this.withoutWebGL = undefined;
    this.scene = new Scene();
    this.scene.add(this.tree.root);
    this.camera = new Camera(data.room, () => this.draw());
    this.solid = new MeshLambertMaterial({ vertexColors: true });
    /** the materials of bodies: as they are, chosen, and faded because another link is chosen */
    this.casts = ['plain', 'chosen', 'faded'].map(() => castMaterial());
    this.meshCasts = this.casts.map(({ uniforms }) => Object.assign(castMaterial(uniforms, 0.5), { side: DoubleSide }));
    /** the bodies whose meshes have been read, see scene/meshes.js */
    this.meshes = [];
    this.ground = { value: data.floor };
    this.hidden = new MeshBasicMaterial({
      vertexColors: true,
      transparent: true,
      opacity: 0.3,
      depthFunc: GreaterDepth,
      depthWrite: false,
    });
    this.hidden.userData.order = 3;
    this.edge = new MeshBasicMaterial({ side: BackSide });
    this.edge.onBeforeCompile = (shader) => {
      shader.uniforms.width = this.edge.userData.width;
      shader.vertexShader = shader.vertexShader
        .replace('#include <common>', '#include <common>\nattribute vec3 outlineNormal;\nuniform float width;')
        .replace('#include <begin_vertex>', 'vec3 transformed = position + width * outlineNormal;');
    };
    this.edge.userData.width = { value: 0 };
    // The shadow falls straight down and so shows x and y. The stencil keeps overlapping shadows from adding up.
    this.shade = new MeshBasicMaterial({
      color: 0x000000,
      transparent: true,
      depthWrite: false,
      stencilWrite: true,
      stencilRef: 1,
      stencilFunc: NotEqualStencilFunc,
      stencilZPass: ReplaceStencilOp,
    });
    this.shade.userData.order = -2;
    this.shade.onBeforeCompile = (shader) => {
      shader.uniforms.ground = this.ground;
      shader.vertexShader = shader.vertexShader
        .replace('#include <common>', '#include <common>\nuniform float ground;')
        .replace(
          '#include <project_vertex>',
          `vec4 fallen = modelMatrix * vec4(transformed, 1.0);
          fallen.z = ground;
          vec4 mvPosition = viewMatrix * fallen;
          gl_Position = projectionMatrix * mvPosition;`,
        );
    };
    this.#addLights();
    this.#addFloor();
    this.setTheme(theme);
    /** called when the first picture is drawn, or WebGL turns out to be unavailable */
    this.onReady = () => {};
    /** returns the boxes in the picture, in pixels, that labels must not cover */
    this.reservedBoxes = () => [];
    /** functions (2-D context, camera) that modes draw with over the finished picture */
    this.overlays = new Set();
  }

  #addLights() {
    this.sky = new HemisphereLight(0xffffff, 0x8d96a8, 2.1);
    this.sky.position.set(0, 0, 1);
    const sun = new DirectionalLight(0xffffff, 1.7);
    sun.position.set(1, -1.6, 2.4);
    this.scene.add(this.sky, sun);
  }

  /** A grid on the floor that fades out, with a step of 1, 2 or 5 times a power of ten. */
  #addFloor() {
    const { centre, radius } = this.data.room;
    const step = roundStep(radius / 4);
    const reach = 1.25 * radius;
    const [cx, cy] = [0, 1].map((k) => Math.round(centre[k] / step) * step);
    const count = Math.ceil(reach / step);
    const position = [];
    const alpha = [];
    const point = (x, y) => {
      position.push(x, y, this.data.floor);
      alpha.push(Math.max(0, 1 - (Math.hypot(x - cx, y - cy) / reach) ** 2));
    };
    for (let i = -count; i <= count; i += 1) {
      for (let k = -count; k < count; k += 1) {
        point(cx + i * step, cy + k * step);
        point(cx + i * step, cy + (k + 1) * step);
        point(cx + k * step, cy + i * step);
        point(cx + (k + 1) * step, cy + i * step);
      }
    }
    const geometry = new BufferGeometry();
    geometry.setAttribute('position', new Float32BufferAttribute(position, 3));
    geometry.setAttribute(
      'color',
      new Float32BufferAttribute(
        alpha.flatMap((a) => [1, 1, 1, a]),
        4,
      ),
    );
    this.grid = new LineSegments(
      geometry,
      new LineBasicMaterial({ vertexColors: true, transparent: true, depthWrite: false }),
    );
    this.grid.renderOrder = -1;
    this.gridStep = step;
    this.scene.add(this.grid);
  }

  /** Use the colours of a theme. The layers have to be built again by their makers. */
  setTheme(theme) {
    this.theme = theme;
    this.grid.material.color = new Color(theme.grid);
    this.shade.opacity = theme.shade;
    this.edge.color = new Color(theme.edge);
    const tints = [null, [theme.chosen, 0.75], [theme.paper, 0.6]];
    for (const [k, { uniforms }] of this.casts.entries()) {
      uniforms.dark.value = Number(theme.isDark);
      const [colour, share] = tints[k] ?? [theme.paper, 0];
      const { r, g, b } = new Color(colour).convertLinearToSRGB();
      uniforms.tint.value.set(r, g, b, share);
    }
    this.draw();
  }

  /**
   * Set a layer, replacing the one of the same name. A part names its body, and its arm if there are several.
   * If parts is a function, it is called when the layer is first shown, because most layers never are.
   */
  setLayer(name, parts, options = {}) {
    this.removeLayer(name);
    if (typeof parts === 'function') this.layers.set(name, { ...EMPTY, make: () => parts(), options });
    else this.#buildLayer(name, parts, options);
  }

  #buildLayer(name, parts, { outlined = false, through = false }) {
    const meshes = [];
    const bodyOf = (part) => this.tree.body(part.arm ?? 0, part.body);
    const solids = parts.filter((part) => part.shape);
    for (const [body, group] of groupBy(solids, bodyOf)) {
      const geometry = mergeParts(group, outlined);
      meshes.push([body, new Mesh(geometry, outlined ? this.casts[0] : this.solid)]);
      if (outlined) meshes.push([body, new Mesh(geometry, this.edge)], [body, new Mesh(geometry, this.shade)]);
      if (through) meshes.push([body, new Mesh(geometry, this.hidden)]);
    }
    for (const [body, mesh] of meshes) {
      body.add(mesh);
      mesh.renderOrder = mesh.material.userData.order ?? 0;
      mesh.frustumCulled = mesh.material !== this.shade; // the shader moves the shadow away from its geometry
    }
    const flat = parts.filter((part) => !part.shape).map((part) => ({ ...part, body: bodyOf(part) }));
    this.layers.set(name, {
      meshes: meshes.map(([, mesh]) => mesh),
      labels: flat.filter((part) => part.label),
      shown: true,
    });
    this.draw();
  }

  /** Move the floor to a height. */
  setFloor(height) {
    this.ground.value = height;
    this.grid.position.z = height - this.data.floor;
  }

  /** Set the layer of the meshes that have been read, in the colours of the theme. Their own edges are enough. */
  buildMeshes() {
    this.removeLayer('meshes');
    const corners = this.meshes.flatMap(({ pieces }) => pieces).reduce((sum, { index }) => sum + index.length, 0);
    this.shade.visible = corners <= MAX_SHADED_CORNERS;
    const meshes = this.meshes.flatMap(({ arm, body, pieces }) => {
      const geometry = mergeMeshes(pieces, this.theme);
      const shadow = new Mesh(geometry, this.shade);
      Object.assign(shadow, { renderOrder: this.shade.userData.order, frustumCulled: false });
      const drawn = [new Mesh(geometry, this.meshCasts[0]), shadow];
      this.tree.body(arm, body).add(...drawn);
      return drawn;
    });
    this.layers.set('meshes', { meshes, labels: [], shown: true });
  }

  /** The nearest link at a place of the picture, in pixels: { arm, link, body, point }, the point in the coordinates of the body. */
  pick(x, y) {
    const ray = new Raycaster();
    const place = new Vector2((2 * x) / this.width - 1, 1 - (2 * y) / this.height);
    ray.setFromCamera(place, this.camera.threeCamera);
    const meshes = ['arm', 'meshes'].flatMap((name) => this.layers.get(name)?.meshes ?? []);
    const solid = meshes.filter(({ material }) => this.casts.includes(material) || this.meshCasts.includes(material));
    const [hit] = ray.intersectObjects(solid, false);
    if (!hit) return null;
    const body = hit.object.parent;
    const arm = this.tree.arms.findIndex(({ bodies }) => bodies.includes(body));
    return { arm, link: this.tree.arms[arm].bodies.indexOf(body), body, point: body.worldToLocal(hit.point.clone()) };
  }

  /** Show a link of the first arm in one colour and the others faded; none if it is null. */
  choose(link) {
    const chosen = link === null ? null : this.tree.body(0, link);
    for (const [name, casts] of [
      ['arm', this.casts],
      ['meshes', this.meshCasts],
    ])
      for (const mesh of this.layers.get(name)?.meshes ?? []) {
        const other = chosen === mesh.parent ? casts[1] : casts[2];
        if (casts.includes(mesh.material)) mesh.material = chosen ? other : casts[0];
      }
    this.draw();
  }

  showLayer(name, shown) {
    const { make, options } = this.layers.get(name) ?? {};
    if (make && shown) this.#buildLayer(name, make(), options);
    const layer = this.layers.get(name);
    if (!layer) return;
    layer.shown = shown;
    for (const mesh of layer.meshes) mesh.visible = shown;
    this.draw();
  }

  removeLayer(name) {
    for (const mesh of this.layers.get(name)?.meshes ?? []) {
      mesh.removeFromParent();
      mesh.geometry.dispose();
    }
    this.layers.delete(name);
  }

  setQ(q) {
    this.tree.setQ(q);
    this.camera.keepInView(this.tree.jointPositions(), 0.3 * this.data.size);
    const { centre, radius } = this.data.room;
    const isNear = (point) => point.distanceTo(new Vector3(...centre)) < 3 * radius; // a long rail would make the arm tiny
    this.camera.keepInView(this.#cornersOfFile().filter(isNear), 0.05 * this.data.size);
    this.draw();
  }

  /** The corners of boxes around what the file of a robot shows: its meshes, and the bodies that are not by rule. */
  #cornersOfFile() {
    const own = this.data.arms.flatMap(({ rule = [] }, arm) =>
      rule.flatMap((byRule, body) => (byRule ? [] : [this.tree.body(arm, body)])),
    );
    const drawn = (this.layers.get('arm')?.meshes ?? []).filter(({ parent }) => own.includes(parent));
    return [...drawn, ...(this.layers.get('meshes')?.meshes ?? [])].flatMap(({ geometry, matrixWorld }) => {
      if (!geometry.boundingBox) geometry.computeBoundingBox();
      const { min, max } = geometry.boundingBox;
      const corner = (k) => new Vector3(...[0, 1, 2].map((i) => ((k >> i) & 1 ? max : min).getComponent(i)));
      return Array.from({ length: 8 }, (_, k) => corner(k).applyMatrix4(matrixWorld));
    });
  }

  resize(width, height) {
    const ratio = Math.min(devicePixelRatio || 1, 2);
    Object.assign(this, { width, height, ratio });
    this.canvas.width = Math.round(width * ratio);
    this.canvas.height = Math.round(height * ratio);
    this.camera.resize(width, height);
    this.paint(); // resizing clears a canvas
  }

  /** Schedule a repaint: changes within one frame are painted once, and a hidden stage when it is visible again. */
  draw() {
    this.stale = true;
    if (this.waiting || !this.visible) return;
    this.waiting = requestAnimationFrame(() => {
      this.waiting = 0;
      this.paint();
    });
  }

  setVisible(visible) {
    this.visible = visible;
    if (visible && this.stale) this.draw();
  }

  /** Paint now. Until WebGL is ready, which takes a while, and without it, the page shows the drawing. */
  paint() {
    if (!this.width || !this.visible || this.withoutWebGL) return;
    this.tree.root.updateMatrixWorld(true);
    if (this.withoutWebGL === undefined) {
      cancelAnimationFrame(this.starting);
      this.starting = requestAnimationFrame(() => setTimeout(() => this.#startWebGL()));
      return; // still stale: who scrolls past before WebGL has started may come back
    }
    this.stale = false;
    this.#drawPicture();
    if (!this.canvas.dataset.pictures) performance.mark('kinlib-viewer-picture');
    this.canvas.dataset.pictures = Number(this.canvas.dataset.pictures ?? 0) + 1;
  }

  async #startWebGL() {
    if (this.preparing || this.withoutWebGL !== undefined || !this.visible) return;
    this.preparing = true;
    const available = hasWebGL();
    if (available) await prepareScene(this.scene, this.camera.threeCamera, this);
    this.withoutWebGL = !available;
    if (!available) this.canvas.dataset.pictures = 0;
    this.paint();
    this.onReady();
  }

  #drawPicture() {
    const { context, camera, theme, ratio, width, height } = this;
    context.setTransform(ratio, 0, 0, ratio, 0, 0);
    context.fillStyle = theme.paper;
    context.fillRect(0, 0, width, height);
    const shown = [...this.layers.values()].filter((layer) => layer.shown);
    const all = (kind) => shown.flatMap((layer) => layer[kind]);
    this.edge.userData.width.value = 1.1 * camera.scale;
    this.calls = renderScene(this.scene, camera.threeCamera, context, { width, height, ratio });
    const taken = [...this.reservedBoxes()];
    this.names = drawLabels(context, all('labels'), taken, camera, theme);
    context.font = fontOf({}, 11);
    context.textAlign = 'left';
    context.textBaseline = 'alphabetic';
    context.fillStyle = theme.quiet;
    context.fillText(`grid ${Number(this.gridStep.toPrecision(3))} m`, 10, height - 10);
    for (const overlay of this.overlays) overlay(context, camera);
  }

  dispose() {
    cancelAnimationFrame(this.waiting);
    for (const name of [...this.layers.keys()]) this.removeLayer(name);
    for (const thing of [
      this.grid.geometry,
      this.grid.material,
      this.solid,
      ...this.casts,
      ...this.meshCasts,
      this.hidden,
      this.edge,
      this.shade,
    ])
      thing.dispose();
    this.visible = false;
  }
}

/** The material of bodies: half-Lambert light from the upper left of the picture, as in kinlib/view/drawing/shades.py. */
function castMaterial(uniforms, rim = 0) {
  return new ShaderMaterial({
    vertexColors: true,
    uniforms: uniforms ?? {
      dark: { value: 0 },
      tint: { value: new Vector4() },
      light: { value: new Vector3(-0.42, 0.78, 0.52).normalize() },
    },
    vertexShader: `varying vec3 n, ink;
      void main() {
        n = normalMatrix * normal;
        ink = color;
        gl_Position = projectionMatrix * modelViewMatrix * vec4(position, 1.0);
      }`,
    fragmentShader: `uniform vec3 light;
      uniform float dark;
      uniform vec4 tint;
      varying vec3 n, ink;
      void main() {
        vec3 base = mix(ink, tint.rgb, tint.a);
        float k = dot(normalize(n), light) * 0.5 + 0.5;
        vec3 cool = base * mix(vec3(0.50, 0.56, 0.66), vec3(0.34, 0.38, 0.46), dark);
        vec3 lit = mix(cool, base, smoothstep(0.15, 0.75, k));
        lit *= 1.0 - ${rim.toFixed(1)} * pow(1.0 - abs(normalize(n).z), 3.0) * (1.0 - dark); // in place of an outline
        gl_FragColor = vec4(lit + (1.0 - lit) * 0.45 * smoothstep(0.85, 1.0, k), 1.0);
      }`,
  });
}

const EMPTY = { meshes: [], labels: [], shown: false };

function groupBy(parts, key) {
  const groups = new Map();
  for (const part of parts) {
    const own = key(part);
    if (groups.has(own)) groups.get(own).push(part);
    else groups.set(own, [part]);
  }
  return groups;
}

/** The smallest step of 1, 2 or 5 times a power of ten that is at least a rough one. */
export function roundStep(rough) {
  const power = 10 ** Math.floor(Math.log10(rough));
  return [1, 2, 5, 10].map((digit) => digit * power).find((step) => step >= 0.999 * rough);
}
