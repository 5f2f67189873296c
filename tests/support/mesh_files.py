"""A robot with a mesh of each kind, written by the tests: no mesh is in the repository."""

import json
import struct
from pathlib import Path

import numpy as np

CORNERS = np.array([(0, 0, 0), (0.1, 0, 0), (0, 0.1, 0), (0, 0, 0.2)])
FACES = [(0, 2, 1), (0, 1, 3), (0, 3, 2), (1, 2, 3)]


def stl():
    """A tetrahedron as binary STL, with zeros for the normals, as many programs write it."""
    faces = b"".join(struct.pack("<12fH", 0, 0, 0, *CORNERS[list(face)].ravel(), 0) for face in FACES)
    return bytes(80) + struct.pack("<I", len(FACES)) + faces


def obj():
    """The same as OBJ, with a line, as CAD programs leave some."""
    points = ["mtllib b.mtl", *(f"v {x} {y} {z}" for x, y, z in CORNERS), "usemtl blue"]
    return "\n".join([*points, *(f"f {a + 1} {b + 1} {c + 1}" for a, b, c in FACES), "l 1 2"]).encode()


def dae():
    """The same as COLLADA, in orange, whose y is up."""
    numbers, corners = " ".join(map(str, CORNERS.ravel())), " ".join(str(k) for face in FACES for k in face)
    return f"""<?xml version="1.0"?><COLLADA xmlns="http://www.collada.org/2005/11/COLLADASchema" version="1.4.1">
<asset><unit name="meter" meter="1"/><up_axis>Y_UP</up_axis></asset>
<library_effects><effect id="e"><profile_COMMON><technique sid="c"><lambert>
<diffuse><color>1 0.5 0 1</color></diffuse></lambert></technique></profile_COMMON></effect></library_effects>
<library_materials><material id="m"><instance_effect url="#e"/></material></library_materials>
<library_geometries><geometry id="g"><mesh><source id="p"><float_array id="a" count="12">{numbers}</float_array>
<technique_common><accessor source="#a" count="4" stride="3"><param name="X" type="float"/><param name="Y" type="float"/>
<param name="Z" type="float"/></accessor></technique_common></source><vertices id="v"><input semantic="POSITION" source="#p"/>
</vertices><triangles count="4" material="s"><input semantic="VERTEX" source="#v" offset="0"/><p>{corners}</p></triangles>
</mesh></geometry></library_geometries><library_visual_scenes><visual_scene id="w"><node><instance_geometry url="#g">
<bind_material><technique_common><instance_material symbol="s" target="#m"/></technique_common></bind_material>
</instance_geometry></node></visual_scene></library_visual_scenes><scene><instance_visual_scene url="#w"/></scene></COLLADA>""".encode()


def glb(uri=""):
    """The same as binary glTF; with a uri, its buffer is said to be elsewhere."""
    points = CORNERS[np.ravel(FACES)].astype("<f4").tobytes()
    limits = {"min": CORNERS.min(axis=0).tolist(), "max": CORNERS.max(axis=0).tolist()}
    head = {
        "asset": {"version": "2.0"},
        "scene": 0,
        "scenes": [{"nodes": [0]}],
        "nodes": [{"mesh": 0}],
        "meshes": [{"primitives": [{"attributes": {"POSITION": 0}}]}],
        "accessors": [{"bufferView": 0, "componentType": 5126, "count": 12, "type": "VEC3", **limits}],
        "bufferViews": [{"buffer": 0, "byteLength": len(points)}],
        "buffers": [{"byteLength": len(points), **({"uri": uri} if uri else {})}],
    }
    text = json.dumps(head).encode()
    text += b" " * (-len(text) % 4)
    chunks = struct.pack("<I4s", len(text), b"JSON") + text + struct.pack("<I4s", len(points), b"BIN\0") + points
    return struct.pack("<4sII", b"glTF", 2, 12 + len(chunks)) + chunks


def visual(name, more=""):
    """A <visual> of a mesh."""
    return f'<visual><origin xyz="0 0 0.05"/><geometry><mesh filename="{name}"/></geometry>{more}</visual>'


def crane(*visuals):
    """A URDF with one revolute joint between each two links, which show these visuals."""
    links = [f'<link name="link{i}">{visual}</link>' for i, visual in enumerate(visuals)]
    joints = [
        f'<joint name="j{i}" type="revolute"><parent link="link{i}"/><child link="link{i + 1}"/><origin xyz="0.2 0 0.1"/>'
        '<axis xyz="0 1 0"/><limit lower="-1" upper="1" effort="1" velocity="1"/></joint>'
        for i in range(len(visuals) - 1)
    ]
    return f'<robot name="crane">{"".join(links + joints)}</robot>'


def write(folder: Path, files):
    """Write files, {path: content}, into a folder."""
    for name, content in files.items():
        path = folder / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_bytes(content if isinstance(content, bytes) else content.encode())
