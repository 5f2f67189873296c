// The entry of a bundle of its own, static/meshes.js, which comes with a viewer whose robot has meshes: it reads files by the loaders
// of three.js and returns arrays, so it shares nothing with the viewer. What files refer to is not loaded.
import { BufferGeometry, DefaultLoadingManager, LoadingManager, Mesh, MeshBasicMaterial, SRGBColorSpace } from 'three';
import { ColladaLoader } from 'three/addons/loaders/ColladaLoader.js';
import { GLTFLoader } from 'three/addons/loaders/GLTFLoader.js';
import { OBJLoader } from 'three/addons/loaders/OBJLoader.js';
import { STLLoader } from 'three/addons/loaders/STLLoader.js';
import { mergeVertices } from 'three/addons/utils/BufferGeometryUtils.js';

const nothingElse = (url) => (url.startsWith('blob:') ? url : 'data:,'); // a blob is a part of the file itself
DefaultLoadingManager.setURLModifier(nothingElse);
const manager = new LoadingManager();
manager.setURLModifier(nothingElse);

const textOf = (bytes) => new TextDecoder().decode(bytes);
const bufferOf = (bytes) => bytes.buffer.slice(bytes.byteOffset, bytes.byteOffset + bytes.byteLength);

const READERS = {
  stl: (bytes) => new Mesh(new STLLoader().parse(bufferOf(bytes)), new MeshBasicMaterial()),
  obj(bytes) {
    const [shape, ...materials] = textOf(bytes).split(/^newmtl /m); // Python has appended the file of materials
    // the loader makes lines of a whole object that has one
    const root = new OBJLoader().parse(shape.replace(/^[lp] .*$/gm, ''));
    const colours = Object.fromEntries(
      materials.map((text) => [
        text.split('\n')[0].trim(),
        text
          .match(/^\s*Kd +([\d. ]+)/m)?.[1]
          .trim()
          .split(/ +/),
      ]),
    );
    root.traverse(({ material }) => {
      for (const one of [material ?? []].flat()) {
        one.userData.isGiven = Object.hasOwn(colours, one.name) && colours[one.name]?.length === 3;
        if (one.userData.isGiven) one.color.setRGB(...colours[one.name].map(Number), SRGBColorSpace);
      }
    });
    return root;
  },
  dae(bytes) {
    const { scene } = new ColladaLoader(manager).parse(textOf(bytes), '') ?? {};
    if (!scene) throw new Error('it is not a COLLADA file');
    scene.quaternion.identity(); // as RViz does: in a URDF, z of the file is z of the link, whatever its up axis is
    return scene;
  },
  glb: async (bytes) => (await new GLTFLoader(manager).parseAsync(bufferOf(bytes), '')).scene,
};

/**
 * Read a file. Returns its pieces, { position, normal, index, colour }: a colour is #rrggbb, or null if the file has none.
 * @param kind the ending of its name; @param bytes a Uint8Array
 */
export async function read(kind, bytes) {
  const root = await READERS[kind](bytes);
  root.updateMatrixWorld(true);
  const pieces = [];
  root.traverse(({ isMesh, geometry, material, matrixWorld }) => {
    if (!isMesh || !geometry.attributes.position?.count) return;
    const own = new BufferGeometry();
    const flat = geometry.index ? geometry.toNonIndexed() : geometry;
    own.setAttribute('position', flat.attributes.position.clone());
    // many programs write zeros for the normals of an STL file, and it would be black
    if (flat.attributes.normal && kind !== 'stl') own.setAttribute('normal', flat.attributes.normal.clone());
    else own.computeVertexNormals();
    own.applyMatrix4(matrixWorld);
    if (!own.attributes.position.array.every(Number.isFinite))
      throw new Error('it has coordinates that are not numbers');
    const { boundingSphere } = own.computeBoundingSphere() ?? own;
    const { attributes, index } = mergeVertices(own, 1e-5 * boundingSphere.radius);
    const all = [{ start: 0, count: index.count, materialIndex: 0 }];
    const materials = [material].flat();
    for (const { start, count, materialIndex } of materials.length > 1 ? flat.groups : all) {
      const { color, userData } = materials[materialIndex] ?? {};
      const given = (kind === 'dae' || kind === 'glb' || userData?.isGiven) && color;
      pieces.push({
        position: attributes.position.array,
        normal: attributes.normal.array,
        index: index.array.slice(start, start + count),
        colour: given ? `#${given.getHexString(SRGBColorSpace)}` : null,
      });
    }
  });
  if (!pieces.some(({ index }) => index.length)) throw new Error('it has no triangles');
  return pieces;
}
