"""What four readers of URDF files do with the same small files, for the table of lecture 09.

kinlib is asked. For the others, which few readers have installed, the table shows what was recorded; the tests ask them again.
Pinocchio reads with urdfdom, the parser of ROS.
"""

from kinlib.urdf.chains import load_urdf

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
"""The file of the camera with one change each, and the four-bar; and what each of the OTHERS does with it."""

OTHERS = ("pinocchio", "pytransform3d", "roboticstoolbox")
"""Pinocchio 4.1.0, pytransform3d 3.17.0 and the Robotics Toolbox 1.5.0, by the names of their modules."""


def ask_kinlib(text: str) -> str:
    """Return what kinlib does with a file: "refuses", or "reads" and the joints that can be moved.

    >>> ask_kinlib(ARM), ask_kinlib(FOUR_BAR)
    ('reads pan, tilt', 'refuses')
    """
    try:
        return f"reads {', '.join(load_urdf(text).joint_names)}"
    except ValueError:
        return "refuses"


def compare_readers() -> str:
    """Return a table of text: a row for each file, and a column for each reader.

    >>> print(compare_readers().splitlines()[-1])
    second parent: a four-bar          refuses            reads A, B, D, D   reads A, B, C, D   reads A, B, D
    """
    rows = [("the camera's file with this change", "kinlib", *OTHERS)]
    rows += [(label, ask_kinlib(text), *recorded) for label, (text, recorded) in FILES.items()]
    return "\n".join("".join([f"{row[0]:<35}", *(f"{cell:<19}" for cell in row[1:])]).rstrip() for row in rows)
