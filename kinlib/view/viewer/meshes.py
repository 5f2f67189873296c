"""The meshes of a URDF: the files that its links name are found beside it or in given folders, and their bytes go to the page.

A URDF may come from anywhere, so no file is opened outside of the folders that were given, whatever a name, a symbolic link or
package://../../ leads to, nothing is downloaded, and sizes are limited. What a mesh contains is read by the page alone.
"""

import os
import re
from collections.abc import Iterator, Mapping, Sequence
from pathlib import Path
from typing import Any
from urllib.parse import unquote

import numpy as np

from kinlib.arrays.validation import Array
from kinlib.urdf.links_and_joints import origin_of
from kinlib.urdf.xml_elements import Element
from kinlib.view.figures.bodies import shapes, visual_colour

MAX_FILE_BYTES, MAX_ALL_BYTES = 40_000_000, 80_000_000
"""The largest mesh, and the largest sum of all meshes of a robot, that a page is given."""

KINDS = (".stl", ".obj", ".dae", ".glb")

Mesh = dict[str, Any]
"""A mesh of a body: {"file", "name", "pose" at home in {s}, "scale", "colour"}."""

Packages = Mapping[str, str | os.PathLike[str]] | Sequence[str | os.PathLike[str]] | os.PathLike[str]


def read_meshes(
    arms: Sequence[Sequence[Sequence[tuple[Element, Array]]]], folder: Path | None, packages: Packages = ()
) -> tuple[dict[str, bytes], list[list[list[Mesh]]], list[str]]:
    """Read the files of the meshes that links show.

    Returns the bytes of each file by a short name, for each body of each arm its meshes, and for each reason why some are not shown
    a sentence with their names.

    arms      for each arm the links of each of its bodies, with their poses in {s} at home
    folder    where the URDF is, if it was read from a file
    packages  a folder or folders of packages, or {name: folder}. Those in the environment variables of ROS, and the package that
              contains the URDF, are found without it
    """
    known, files, refused = dict[str, str](), dict[str, bytes](), dict[str, list[str]]()
    folder = _real(folder) if folder else None
    paths = [packages] if isinstance(packages, str | os.PathLike) else packages
    named = [*paths.items()] if isinstance(paths, Mapping) else [(_real(path).name, path) for path in paths]
    for variable, below in (("ROS_PACKAGE_PATH", ""), ("AMENT_PREFIX_PATH", "share")):  # of ROS 1 and of ROS 2
        named += [(Path(at).name, Path(at, below)) for at in os.environ.get(variable, "").split(os.pathsep) if at]
    roots = [(str(name), _real(path)) for name, path in named]

    def file_of(name: str) -> str:
        if name not in known:
            known[name] = ""
            try:
                content = _content([*_places(name, folder, roots), *_places(unquote(name), folder, roots)], name, files)
                known[name] = f"{len(files)}{Path(name).suffix.lower()}"
                files[known[name]] = content
            except (OSError, ValueError) as error:
                why = str(error) if type(error) is ValueError else "it could not be opened."
                refused.setdefault(why, []).append(name[-200:])
        return known[name]

    def shown(link: Element, T: Array) -> Iterator[Mesh]:
        for visual, mesh in (one for one in shapes(link) if one[1].tag == "mesh"):
            try:
                name, pose = mesh.text("filename"), (T @ origin_of(visual) + 0.0).ravel().tolist()
                scale = mesh.numbers("scale", 3) if "scale" in mesh.attributes else [1.0, 1.0, 1.0]
                if not np.all(scale):
                    raise mesh.error("its scale must not be 0.")
                if file := file_of(name):
                    yield {"file": file, "name": name, "pose": pose, "scale": scale, "colour": visual_colour(visual)}
            except ValueError as error:
                refused.setdefault(str(error), []).append(f"in line {mesh.line}")

    meshes = [[[mesh for link in links for mesh in shown(*link)] for links in bodies] for bodies in arms]
    notes = []
    for why, names in refused.items():
        listed = ", ".join(names[:3]) + (f" and {len(names) - 3} more" if len(names) > 3 else "")
        many = len(names) > 1
        head = f"{len(names)} meshes are" if many else "A mesh is"
        notes.append(f"{head} not shown, {listed}: {re.sub('^it ', 'each ', why) if many else why}")
    return files, meshes, notes


def _real(path: str | os.PathLike[str]) -> Path:
    """Return a path without symbolic links; unlike Path.resolve, this does not fail where links go round in circles."""
    return Path(os.path.realpath(path))


def _places(name: str, folder: Path | None, packages: list[tuple[str, Path]]) -> Iterator[tuple[Path, Path]]:
    """Yield where a file may be, each place with the folder that it must not leave."""
    # The packages that contain the URDF: folders above it with a package.xml, and that of a folder "urdf" or "robots".
    above = [folder, *folder.parents] if folder else []
    usual = [path.parent for path in above[:1] if path.name in {"urdf", "robots"}]
    own = [path for path in above if path == folder or path in usual or (path / "package.xml").is_file()]
    scheme, _, path = name.rpartition("://")
    roots = [root for _, root in packages]
    if scheme in ("package", "model"):
        package, _, rest = path.lstrip("/").partition("/")
        if package in ("", ".", ".."):
            return
        yield from (
            (root, root / rest) for known, root in [*packages, *((at.name, at) for at in own)] if known == package
        )
        yield from ((root, root / package / rest) for root in [*roots, *above[:1]])
        yield from ((root, root / rest) for root in own)  # a copy of a package often has another name
        return
    if scheme not in ("", "file"):
        raise ValueError("it is an address, and nothing is downloaded. Download it, and write its path.")
    yield from ((root, folder / path) for root in [*own, *roots] if folder)
    yield from ((root, root / path) for root in roots)


def _content(places: Sequence[tuple[Path, Path]], name: str, files: Mapping[str, bytes]) -> bytes:
    """Return the bytes of a mesh, at the first of the places where it is. Raises ValueError if it must not be read or is not there."""
    if Path(name).suffix.lower() not in KINDS:
        raise ValueError(f"a file of a mesh must end in {', '.join(KINDS[:-1])} or {KINDS[-1]}.")
    there = [(root, real) for root, path in places if "\0" not in str(path) and (real := _real(path)).is_file()]
    for root, real in there:
        if not real.is_relative_to(root):
            continue
        size = real.stat().st_size
        if size > MAX_FILE_BYTES:
            raise ValueError(f"it has {size / 1e6:.0f} MB; at most {MAX_FILE_BYTES / 1e6:.0f} MB are read.")
        if size + sum(map(len, files.values())) > MAX_ALL_BYTES:
            raise ValueError(f"the meshes before have almost {MAX_ALL_BYTES / 1e6:.0f} MB, the most that is shown.")
        content = real.read_bytes()
        # The materials of an OBJ file are in a file beside it, and the page gets both as one.
        for material in re.findall(rb"^mtllib +(.+?)\s*$", content, re.MULTILINE)[:1]:
            beside = _real(real.parent / os.fsdecode(material))
            if beside.is_relative_to(root) and beside.suffix == ".mtl" and beside.is_file():
                with beside.open("rb") as file:
                    content += b"\n" + file.read(MAX_FILE_BYTES)
        return content
    if there:
        raise ValueError(
            "it is outside of the folder of the file. If it may be read, pass packages=[...] with a folder that contains it."
        )
    package = name.partition("package://")[2].partition("/")[0]
    given = f'{{"{package:.60}": folder}}' if package else "[...]"
    raise ValueError(f"it was not found. Add the folder of its package: packages={given} in Python.")
