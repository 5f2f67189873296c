"""The meshes of a URDF: the files that its links name are found beside it or in given folders, and their bytes go to the page.

A URDF may come from anywhere, so no file is opened outside of the folders that were given, whatever a name, a symbolic link or
package://../../ leads to, nothing is downloaded, and sizes are limited. What a mesh contains is read by the page alone.
"""

import os
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

import numpy as np

from kinlib.arrays.validation import Array
from kinlib.urdf.robot_tree import Tree
from kinlib.urdf.xml_elements import Element
from kinlib.view.figures.bodies import shapes, visual_pose
from kinlib.view.figures.tree import Branch, home_poses, links_of_bodies

MAX_FILE_BYTES, MAX_ALL_BYTES = 40_000_000, 80_000_000
"""The largest mesh, and the largest sum of all meshes of a robot, that a page is given."""

FOLDERS_OF_URDF = {"urdf", "robots"}
"""A URDF in a folder of this name is in the package that is the folder above it."""

KINDS = (".stl", ".obj", ".dae", ".glb")

Packages = Mapping[str, str | os.PathLike[str]] | Sequence[str | os.PathLike[str]]


@dataclass(frozen=True, eq=False)
class Meshes:
    """The meshes of a robot.

    files  the bytes of each file by a short name
    arms   for each body of each branch its meshes: {"file", "name", "pose" at home in {s}, "scale", "colour"}
    notes  a sentence for each file that is not shown
    """

    files: dict[str, bytes] = field(default_factory=dict)
    arms: list[list[list[dict[str, Any]]]] = field(default_factory=list)
    notes: list[str] = field(default_factory=list)


def read_meshes(tree: Tree, found: list[Branch], packages: Packages = ()) -> Meshes:
    """Read the files of the meshes that the links of a tree show.

    packages  folders of packages, or {name: folder}. Those in ROS_PACKAGE_PATH, and the package that contains the URDF, are found
              without it
    """
    home, library = home_poses(tree), _Library(tree.folder, packages)
    arms = [[[*_shown(links, home, library)] for links in bodies] for bodies in links_of_bodies(tree, found)]
    return Meshes(library.files, arms, library.notes())


def _shown(links: list[Element], home: Mapping[str, Array], library: "_Library") -> Iterator[dict[str, Any]]:
    shown = [(link, visual, shape) for link in links for visual, shape in shapes(link)]
    for link, visual, mesh in (one for one in shown if one[2].tag == "mesh"):
        try:
            name, pose = mesh.text("filename"), visual_pose(visual, home[link.text("name")]) + 0.0
            scale = mesh.numbers("scale", 3) if "scale" in mesh.attributes else [1.0, 1.0, 1.0]
            if not np.all(scale):
                raise mesh.error("its scale must not be 0.")
        except ValueError as error:
            library.refused.setdefault(str(error), []).append(f"in line {mesh.line}")
            continue
        if file := library.find(name):
            place = {"pose": pose.ravel().tolist(), "scale": scale}
            yield {"file": file, "name": name, "colour": _colour(visual), **place}


def _colour(visual: Element) -> str | None:
    """Return the colour of a visual as #rrggbb, by its own material or by that of the robot of the same name."""
    own = [child for child in visual.children if child.tag == "material"]
    robot = visual.parent.parent if visual.parent else None
    others = [child for child in robot.children if child.tag == "material"] if robot and own else []
    named = [other for other in others if other.attributes.get("name") == own[0].attributes.get("name")]
    for colour in (child for material in own + named for child in material.children if child.tag == "color"):
        try:
            values = np.clip(colour.numbers("rgba", 4), 0, 1)
        except ValueError:
            continue
        return "#" + "".join(f"{round(255 * x):02x}" for x in values[:3])
    return None


def _real(path: str | os.PathLike[str]) -> Path:
    """Return a path without symbolic links; unlike Path.resolve, this does not fail where links go round in circles."""
    return Path(os.path.realpath(path))


class _Library:
    """The folders in which meshes may be, and what has been read of them."""

    def __init__(self, folder: Path | None, packages: Packages) -> None:
        self.folder = _real(folder) if folder else None
        named = packages.items() if isinstance(packages, Mapping) else [(_real(path).name, path) for path in packages]
        self.packages = [(str(name), _real(path)) for name, path in named]
        paths = [Path(path) for path in os.environ.get("ROS_PACKAGE_PATH", "").split(os.pathsep) if path]
        self.packages += [(path.name, _real(path)) for path in paths]
        # The packages that contain the file: folders above it with a package.xml, and that of a folder "urdf".
        above = [self.folder, *self.folder.parents] if self.folder else []
        usual = [path.parent for path in above[:1] if path.name in FOLDERS_OF_URDF]
        self.own = [path for path in above if path == self.folder or path in usual or (path / "package.xml").is_file()]
        self.files: dict[str, bytes] = {}
        self.refused: dict[str, list[str]] = {}
        self._names: dict[str, str] = {}

    def find(self, name: str) -> str:
        """Return the short name of the file of a mesh, which is read if it has not been, or "" with a note."""
        if name not in self._names:
            try:
                content, kind = self._read(name)
                self._names[name] = f"{len(self.files)}{kind}"
                self.files[self._names[name]] = content
            except (OSError, ValueError) as error:
                self._names[name] = ""
                why = str(error) if type(error) is ValueError else "it cannot be opened."
                self.refused.setdefault(why, []).append(name[-200:])
        return self._names[name]

    def notes(self) -> list[str]:
        """Return a sentence for each reason for which meshes are not shown, with some of their names."""
        sentences = []
        for why, names in self.refused.items():
            listed = ", ".join(names[:3]) + (f" and {len(names) - 3} more" if len(names) > 3 else "")
            meshes = "A mesh is" if len(names) == 1 else f"{len(names)} meshes are"
            sentences.append(f"{meshes} not shown, {listed}: {why}")
        return sentences

    def _read(self, name: str) -> tuple[bytes, str]:
        kind = Path(name).suffix.lower()
        if kind not in KINDS:
            raise ValueError(f"a file of a mesh must end in {', '.join(KINDS[:-1])} or {KINDS[-1]}.")
        outside = False
        for root, path in self._places(name):
            if "\0" in str(path) or not (real := _real(path)).is_file():
                continue
            if not real.is_relative_to(root):
                outside = True
                continue
            size = real.stat().st_size
            if size > MAX_FILE_BYTES:
                raise ValueError(f"it has {size / 1e6:.0f} MB; at most {MAX_FILE_BYTES / 1e6:.0f} MB are read.")
            if size + sum(map(len, self.files.values())) > MAX_ALL_BYTES:
                raise ValueError(
                    f"the meshes before it have almost {MAX_ALL_BYTES / 1e6:.0f} MB, the most that is shown."
                )
            with real.open("rb") as file:
                return file.read(MAX_FILE_BYTES), kind
        if outside:
            raise ValueError(
                "it is outside of the folder of the file. If it may be read, pass packages=[...] with a folder that contains it."
            )
        raise ValueError("it was not found. Pass packages=[...] with the folder of its package.")

    def _places(self, name: str) -> Iterator[tuple[Path, Path]]:
        """Yield where a file may be, each place with the folder that it must not leave."""
        if name.startswith("package://"):
            package, _, rest = name.removeprefix("package://").partition("/")
            if package in ("", ".", ".."):
                return
            for own, root in [*self.packages, *((path.name, path) for path in self.own)]:
                if own == package:
                    yield root, root / rest
            for root in [path for _, path in self.packages] + ([self.folder] if self.folder else []):
                yield root, root / package / rest
            return
        if "://" in name and not name.startswith("file://"):
            raise ValueError("it is an address, and nothing is downloaded. Download it, and write its path.")
        path = name.removeprefix("file://")
        if self.folder:
            for root in self.own:
                yield root, self.folder / path
        for _, root in self.packages:
            yield root, root / path
