// The meshes of a maker's file, see kinlib/view/viewer/meshes.py: read by a bundle that comes with them, and merged body by body.
import { BufferAttribute, BufferGeometry, Color, Matrix3, Matrix4, Vector3 } from 'three';

const MAX_CORNERS = 3_000_000; // of a million triangles

/** The bytes that a kernel has sent, or that a page has as base64. */
function bytesOf(data) {
  if (typeof data !== 'string') return new Uint8Array(data.buffer, data.byteOffset, data.byteLength);
  const letters = atob(data);
  const bytes = new Uint8Array(letters.length);
  for (let k = 0; k < bytes.length; k += 1) bytes[k] = letters.charCodeAt(k);
  return bytes;
}

let loaders; // of all viewers

/** Read the meshes of a model's arms. Returns { bodies, notes }: bodies of merged pieces, and what could not be read. */
export async function readMeshes(model, arms) {
  loaders ??= import(URL.createObjectURL(new Blob([model.get('loaders')], { type: 'text/javascript' })));
  const { read } = await loaders;
  const files = {};
  const notes = [];
  let room = MAX_CORNERS;
  for (const [file, data] of Object.entries(model.get('meshes'))) {
    const name = arms.flatMap(({ meshes }) => meshes.flat()).find((mesh) => mesh.file === file)?.name ?? file;
    await new Promise((done) => setTimeout(done)); // the page answers between two files
    try {
      const pieces = await read(file.split('.').at(-1), bytesOf(data));
      room -= pieces.reduce((sum, { index }) => sum + index.length, 0);
      if (room < 0) throw new Error('the files before it already have a million triangles');
      files[file] = pieces;
    } catch (error) {
      notes.push(`The mesh ${name} could not be read: ${error.message}.`);
    }
  }
  const bodies = arms.flatMap(({ meshes }, arm) =>
    meshes.flatMap((placed, body) => {
      const pieces = placed.flatMap((mesh) => (files[mesh.file] ?? []).map((piece) => moved(piece, mesh)));
      return pieces.length ? [{ arm, body, pieces }] : [];
    }),
  );
  return { bodies, notes };
}

/** A piece of a file where it is at home in {s}. */
function moved({ position, normal, index, colour }, { pose, scale, colour: given }) {
  const matrix = new Matrix4().set(...pose).scale(new Vector3(...scale));
  const turned = new Matrix3().getNormalMatrix(matrix);
  const own = new Vector3();
  const [points, normals] = [new Float32Array(position.length), new Float32Array(normal.length)];
  for (let k = 0; k < position.length; k += 3) {
    own.fromArray(position, k).applyMatrix4(matrix).toArray(points, k);
    own.fromArray(normal, k).applyNormalMatrix(turned).toArray(normals, k);
  }
  return { position: points, normal: normals, index, colour: colour ?? given };
}

/** Merge the pieces of a body. On a dark page, black parts are lighter, because they would not be seen. */
export function mergeMeshes(pieces, theme) {
  const length = pieces.reduce((sum, { position }) => sum + position.length, 0);
  const geometry = new BufferGeometry();
  const [position, normal, colour] = ['position', 'normal', 'color'].map((name) => {
    geometry.setAttribute(name, new BufferAttribute(new Float32Array(length), 3));
    return geometry.attributes[name].array;
  });
  const index = new Uint32Array(pieces.reduce((sum, piece) => sum + piece.index.length, 0));
  let [first, start] = [0, 0];
  for (const piece of pieces) {
    position.set(piece.position, first);
    normal.set(piece.normal, first);
    const ink = new Color(piece.colour ?? theme.body);
    if (theme.isDark) ink.lerp(new Color(theme.body), 0.12);
    const { r, g, b } = ink.convertLinearToSRGB(); // the material does not convert colours
    for (let k = first; k < first + piece.position.length; k += 3) colour.set([r, g, b], k);
    for (const corner of piece.index) index[start++] = first / 3 + corner;
    first += piece.position.length;
  }
  return geometry.setIndex(new BufferAttribute(index, 1));
}

/** The lowest point of bodies as the tree has moved them. */
export function lowestOf(bodies, tree) {
  let least = Number.POSITIVE_INFINITY;
  for (const { arm, body, pieces } of bodies) {
    const e = tree.body(arm, body).matrixWorld.elements;
    for (const { position: p } of pieces)
      for (let k = 0; k < p.length; k += 3)
        least = Math.min(least, e[2] * p[k] + e[6] * p[k + 1] + e[10] * p[k + 2] + e[14]);
  }
  return least;
}
