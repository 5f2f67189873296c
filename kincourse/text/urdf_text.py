"""URDF files as sheets print them: short, with one element per line, and right angles written as 1.5708."""

from collections.abc import Iterable, Sequence
from dataclasses import dataclass

import numpy as np

from kincourse.sampling.arms import ArmSampler
from kinlib.arrays.validation import Array
from kinlib.rigid.rpy import origin
from misstep.display.text import number

RIGHT_ANGLE_RAD = np.pi / 2


@dataclass(frozen=True, eq=False)
class UrdfJoint:
    """A joint of a URDF file: its origin in the frame of the parent link, in metres and radians, and its axis in its own frame.

    further  its further elements, such as a limit
    """

    name: str
    xyz: Array | Sequence[float]
    rpy: Array | Sequence[float] = (0.0, 0.0, 0.0)
    axis: Array | Sequence[float] = (0.0, 0.0, 1.0)
    kind: str = "continuous"
    further: Sequence[str] = ()

    @property
    def pose(self) -> Array:
        """The pose (4, 4) of the joint frame in the frame of the parent link, at q = 0."""
        return origin(self.xyz, self.rpy)

    def element(self, parent: str, child: str) -> str:
        """The joint as a URDF element between two links."""
        rpy_attribute = f' rpy="{format_values(self.rpy)}"' if np.any(self.rpy) else ""
        lines = [
            f'<joint name="{self.name}" type="{self.kind}">',
            f'  <parent link="{parent}"/> <child link="{child}"/>',
            f'  <origin xyz="{format_values(self.xyz)}"{rpy_attribute}/>',
            *([f'  <axis xyz="{format_values(self.axis)}"/>'] if self.kind != "fixed" else []),
            *(f"  {element}" for element in self.further),
            "</joint>",
        ]
        return "\n".join(lines)


def serial_urdf(joints: Sequence[UrdfJoint], links: Sequence[str]) -> str:
    """Write the URDF of an open chain: links from base to tip, and a joint between each two."""
    ends = zip(joints, links[:-1], links[1:], strict=True)
    return robot_urdf(links, [joint.element(parent, child) for joint, parent, child in ends])


def robot_urdf(links: Iterable[str], elements: Iterable[str]) -> str:
    """Write a URDF of links and further elements."""
    return "\n".join(['<robot name="yours">', *(f'<link name="{link}"/>' for link in links), *elements, "</robot>"])


def fence_urdf(text: str) -> str:
    """Put a URDF into a fenced code block of Markdown."""
    return f"```xml\n{text}\n```"


def format_values(values: Array | Iterable[float]) -> str:
    """Write numbers as a URDF attribute does, separated by spaces, with at most four decimals."""
    return " ".join(number(round(value, 4)) if abs(value) != RIGHT_ANGLE_RAD else f"{value:.4f}" for value in values)


def random_right_angles(sampler: ArmSampler, turns: int) -> Array:
    """Draw roll, pitch and yaw in radians, (3,): `turns` of them are right angles of either sign, the others 0."""
    chosen = sampler.shuffled([0, 1, 2])[:turns]
    return np.array([sampler.choice((-1, 1)) * RIGHT_ANGLE_RAD if k in chosen else 0.0 for k in range(3)])


def random_oblique_angles(sampler: ArmSampler) -> Array:
    """Draw roll, pitch and yaw in radians, (3,): one is a right angle, one is oblique, and one is 0.

    With right angles alone, the transpose of a rotation is often its square, which hides how the answer came about.
    """
    sizes = np.array(sampler.shuffled([RIGHT_ANGLE_RAD, sampler.choice((0.5, 0.8, 1.1)), 0.0]))
    return sizes * [sampler.choice((-1, 1)) for _ in range(3)]
