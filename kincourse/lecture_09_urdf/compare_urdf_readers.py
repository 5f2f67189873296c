"""What four readers of URDF files do with the same small files, for the table of lecture 09.

A reader that is installed is asked. For the others, as in the lab in the browser, the table shows what was recorded.
Pinocchio reads with urdfdom, the parser of ROS.
"""

import os
import re
import sys
import tempfile
import warnings
from collections.abc import Callable, Iterator, Sequence
from contextlib import contextmanager, nullcontext
from importlib.util import find_spec
from pathlib import Path

ARM = """<robot name="camera">
  <link name="base"/> <link name="mast"/> <link name="camera"/>
  <joint name="pan" type="revolute"> <parent link="base"/> <child link="mast"/>
    <origin xyz="0 0 0.5"/> <axis xyz="0 0 1"/>
    <limit lower="-2" upper="2" effort="10" velocity="1"/> </joint>
  <joint name="tilt" type="revolute"> <parent link="mast"/> <child link="camera"/>
    <origin xyz="0 0 0.2" rpy="-1.5708 0 0"/> <axis xyz="0 0 1"/>
    <limit lower="-1" upper="1" effort="10" velocity="1"/> </joint>
</robot>"""
"""A camera that pans and tilts: a valid file."""

FOUR_BAR = """<robot name="four-bar">
  <link name="ground"/> <link name="crank"/> <link name="coupler"/> <link name="rocker"/>
  <joint name="A" type="continuous"> <parent link="ground"/> <child link="crank"/> <axis xyz="0 0 1"/> </joint>
  <joint name="B" type="continuous"> <parent link="crank"/> <child link="coupler"/>
    <origin xyz="1 0 0"/> <axis xyz="0 0 1"/> </joint>
  <joint name="C" type="continuous"> <parent link="coupler"/> <child link="rocker"/>
    <origin xyz="2 0 0"/> <axis xyz="0 0 1"/> </joint>
  <joint name="D" type="continuous"> <parent link="ground"/> <child link="rocker"/>
    <origin xyz="3 0 0"/> <axis xyz="0 0 1"/> </joint>
</robot>"""
"""A four-bar linkage, whose rocker has two parents: not a tree."""


def _tilt_with(old: str, new: str) -> str:
    """The file of the camera with a change in its second joint."""
    pan, tilt = ARM.split('  <joint name="tilt"')
    return f'{pan}  <joint name="tilt"{tilt.replace(old, new)}'


_ALL = ("reads pan, tilt",) * 3
FILES = {
    "no change": (ARM, _ALL),
    "limit without effort and velocity": (
        _tilt_with(' effort="10" velocity="1"', ""),
        ("refuses", "reads pan, tilt", "refuses"),
    ),
    "child that is not a link": (_tilt_with('child link="camera"', 'child link="Camera"'), ("refuses",) * 3),
    "link that no joint holds": (
        ARM.replace('<link name="camera"/>', '<link name="camera"/> <link name="lens"/>'),
        ("refuses", "reads pan, tilt", "refuses"),
    ),
    "roll of -90, in degrees": (_tilt_with("-1.5708", "-90"), _ALL),
    "lower and upper swapped": (_tilt_with('lower="-1" upper="1"', 'lower="1" upper="-1"'), _ALL),
    "axis of length 0": (
        _tilt_with('axis xyz="0 0 1"', 'axis xyz="0 0 0"'),
        ("reads pan, tilt", "reads pan, tilt", "reads pan"),
    ),
    "axis of length 2": (_tilt_with('axis xyz="0 0 1"', 'axis xyz="0 0 2"'), _ALL),
    "axis in the frame of the base": (_tilt_with('axis xyz="0 0 1"', 'axis xyz="0 1 0"'), _ALL),
    "tilt mimics pan": (_tilt_with("/> </joint>", '/> <mimic joint="pan"/> </joint>'), _ALL),
    "second parent: a four-bar": (FOUR_BAR, ("reads A, B, D, D", "reads A, B, C, D", "reads A, B, D")),
}
"""The file of the camera with one change each, and the four-bar; and what Pinocchio 4.1.0, pytransform3d 3.17.0 and the Robotics
Toolbox 1.5.0 do with it. A test asks them again."""


def _by_kinlib(text: str) -> Sequence[str]:
    from kinlib.urdf.chains import load_urdf

    return load_urdf(text).joint_names


def _by_pinocchio(text: str) -> Sequence[str]:
    import pinocchio

    return list(pinocchio.buildModelFromXML(text).names)[1:]


def _by_pytransform3d(text: str) -> Sequence[str]:
    from pytransform3d.urdf import UrdfTransformManager

    manager = UrdfTransformManager()
    manager.load_urdf(text)
    names = re.findall(r'<joint name="(\w+)"', text)
    for name in names:
        manager.get_joint_limits(name)  # KeyError if it does not know the joint
    return names


def _by_roboticstoolbox(text: str) -> Sequence[str]:
    from roboticstoolbox import Robot

    path = Path(tempfile.gettempdir()) / "robot.urdf"
    path.write_text(text, "utf-8")
    links = Robot.URDF(str(path)).links
    pattern = r'<joint name="(\w+)".*?<parent link="(\w+)"/> <child link="(\w+)"'
    names = {(parent, child): name for name, parent, child in re.findall(pattern, text, re.DOTALL)}
    return [names[link.parent.name, link.name] for link in links if link.isjoint]


READERS: dict[str, Callable[[str], Sequence[str]]] = {
    "kinlib": _by_kinlib,
    "pinocchio": _by_pinocchio,
    "pytransform3d": _by_pytransform3d,
    "roboticstoolbox": _by_roboticstoolbox,
}
"""The readers by the name of their module: each takes the text of a file, and returns the joints that move."""


def ask(reader: str, text: str) -> str:
    """Return what a reader does with a file: "refuses", or "reads" and the joints that can be moved.

    >>> ask("kinlib", ARM), ask("kinlib", FOUR_BAR)
    ('reads pan, tilt', 'refuses')
    """
    with nullcontext() if reader == "kinlib" else _quiet():
        try:
            return f"reads {', '.join(READERS[reader](text))}"
        except Exception:  # each reader has exceptions of its own
            return "refuses"


def compare_readers() -> str:
    """Return a table of text: a row for each file, and a column for each reader.

    >>> print(compare_readers().splitlines()[-1])
    second parent: a four-bar          refuses            reads A, B, D, D   reads A, B, C, D   reads A, B, D
    """
    others = list(READERS)[1:]
    rows = [("the camera's file with this change", *READERS)]
    for label, (text, recorded) in FILES.items():
        said = dict(zip(others, recorded, strict=True))
        rows.append((label, *(ask(reader, text) if find_spec(reader) else said[reader] for reader in READERS)))
    return "\n".join("".join([f"{row[0]:<35}", *(f"{cell:<19}" for cell in row[1:])]).rstrip() for row in rows)


@contextmanager
def _quiet() -> Iterator[None]:
    """Discard warnings, what a parser in C++ writes to its error stream, and the temporary files that are left behind."""
    sys.stderr.flush()
    kept, folder = os.dup(2), tempfile.tempdir
    with tempfile.TemporaryDirectory() as own, Path(os.devnull).open("w", encoding="utf-8") as nothing:
        os.dup2(nothing.fileno(), 2)
        tempfile.tempdir = own
        try:
            with warnings.catch_warnings():
                warnings.simplefilter("ignore")
                yield
        finally:
            os.dup2(kept, 2)
            os.close(kept)
            tempfile.tempdir = folder
