"""The 3-D viewer: a robot that moves in the page, in JupyterLab, in the browser lab and on a page without a kernel.

`explore` makes one, and `show` shows one with a single call, in a notebook or, from a script, in the web browser.

Python describes the robot once, as data (kinlib.view.viewer.scene). The page moves it by its screws and computes the pose from
its scene graph, so a slider needs no answer from Python. Both sides share the traits below, and either side can set them.
"""

import sys
import webbrowser
from collections.abc import Callable, Collection, Mapping, Sequence
from os import PathLike
from pathlib import Path
from tempfile import mkdtemp
from typing import Any

import anywidget
import numpy as np
import traitlets
from numpy.typing import ArrayLike

from kinlib.arrays import validation
from kinlib.arrays.validation import Array, JointValues
from kinlib.chains.chain import Chain
from kinlib.dh.assignment import FrameAssignment
from kinlib.dh.table import DHTable, table_frames
from kinlib.mechanisms.mechanism import Mechanism
from kinlib.urdf.robot_tree import Tree
from kinlib.view.drawing.picture import Gallery, Picture, page, save
from kinlib.view.figures.arm import ARM_LAYERS, draw_arm
from kinlib.view.figures.bodies import body_of
from kinlib.view.figures.branches import branches, joint_share
from kinlib.view.figures.joint_bodies import body_motions
from kinlib.view.figures.linkage import draw_linkage
from kinlib.view.viewer.meshes import Packages, read_meshes
from kinlib.view.viewer.pictures import Pictures
from kinlib.view.viewer.scene import LAYERS, scene
from kinlib.view.viewer.widget import STATIC, Covered


class Viewer(Covered):
    """A viewer: the traits that it shares with the page, and its HTML for pages without a kernel. Make one with `explore`.

    q        (n,) joint values; the page and Python can both set them
    start    (n,) the joint values that the button "Reset" restores
    shown    the layers that are drawn, any of kinlib.view.viewer.scene.LAYERS
    readout  whether the pose of the end-effector is shown beside the picture
    mode     {"kind", ...}: the data of a mode in kinlib/view/js/modes; empty for a robot with sliders
    flat     whether the page has no WebGL and asks for `drawing`, the current picture as HTML
    meshes   the bytes of files of meshes by name, and `loaders` the script that reads them, if there are some
    notes    what is not shown, in sentences

    It is made of a scene, a function that draws its picture, the joint values at the start, the robot that has them, and further
    traits.

    >>> arm = explore(kl.robots.rpr(), frames={"1": np.eye(4)})
    >>> arm.html()[:25], arm.own_frames(), arm.picture().alt[:3]
    ('<div data-kinlib-viewer><', ['frame 1'], 'RPR')
    >>> arm.save("arm.jpg")
    Traceback (most recent call last):
    ValueError: path must end in .svg or .html or .png; got 'arm.jpg'.
    """

    scene = traitlets.Dict().tag(sync=True)
    q = traitlets.Any().tag(sync=True)
    start = traitlets.Any().tag(sync=True)
    shown = traitlets.List(traitlets.Unicode()).tag(sync=True)
    readout = traitlets.Bool(False).tag(sync=True)
    mode = traitlets.Dict().tag(sync=True)
    flat = traitlets.Bool(False).tag(sync=True)
    drawing = traitlets.Unicode().tag(sync=True)
    meshes = traitlets.Dict().tag(sync=True)
    loaders = traitlets.Unicode().tag(sync=True)
    notes = traitlets.List(traitlets.Unicode()).tag(sync=True)
    set_by_reader: Sequence[str] = ("q", "shown")

    def __init__(
        self,
        scene: dict[str, Any],
        draw: Callable[[Any], Picture],
        start: ArrayLike = (),
        *,
        robot: Chain | Tree | None = None,
        after: Any = None,
        **traits: Any,
    ) -> None:
        self._draw, self.robot = draw, robot
        mode = traits.get("mode", {})
        super().__init__((scene, mode, start), after=after, scene=scene, q=start, start=start, **traits)
        self.observe(self._send_drawing, ["flat", *self.set_by_reader])

    def _send_drawing(self, _: Any) -> None:
        if self.flat:
            self.drawing = self.picture().html()

    @traitlets.validate("q", "start")
    def _validate_values(self, proposal: Any) -> list[float]:
        values: list[float] = np.asarray(proposal["value"], dtype=float).tolist()
        if self.robot:
            self.robot.in_order(values)
        validation.array(values, "q")
        return values

    @traitlets.validate("shown")
    def _validate_shown(self, proposal: Any) -> list[str]:
        names: list[str] = proposal["value"]
        layers = [*LAYERS, *self.own_frames()]
        if unknown := set(names) - set(layers):
            raise ValueError(f"show may contain {', '.join(layers)}; got {', '.join(map(repr, sorted(unknown)))}.")
        return names

    def own_frames(self) -> list[str]:
        """Return the layers of the frames that were given to `explore`."""
        return [layer for arm in self.scene.get("arms", []) for layer in arm.get("frames", {}) if layer not in LAYERS]

    def picture(self) -> Picture:
        """Return the drawing that is shown before the script starts, without WebGL, and in print."""
        return self._draw(self)

    @property
    def alt(self) -> str:
        """The text alternative of the current picture."""
        return self.picture().alt

    def save(self, path: str | PathLike[str]) -> None:
        """Save the viewer as a page of its own that needs no kernel and no network, .html, or its current drawing, .svg or .png.

        Raises ValueError for another ending, for a folder that does not exist, and if the viewer is covered until a question
        is answered.
        """
        if self.covered:
            raise ValueError(
                "The viewer must be uncovered before it is saved; it waits for a question that the file does not have. "
                "Answer the question, or make the viewer without `after`."
            )

        def whole_page() -> str:
            script = (STATIC / "viewer.js").read_text("utf-8")
            return page(self.alt, f"{self.html()}<script>{script}\nkinlib.startViewers();</script>")

        save(path, {**self.picture().contents(), "html": whole_page})

    def html(self, whole: bool = True) -> str:
        """Return the viewer for a page without a kernel: its state as JSON, and a drawing that loader.js replaces.

        whole  whether meshes are part of it
        """
        # The page does not need what anywidget and ipywidgets synchronize for themselves.
        theirs = {*anywidget.AnyWidget.class_trait_names(sync=True), "flat", "drawing"}
        if not whole:
            theirs |= {"meshes", "loaders"}
        own = [name for name in self.trait_names(sync=True) if name not in theirs and not name.startswith("_")]
        return self.on_page("viewer", self.get_state(sorted(own)), self.picture().html())


def opening(robot: Chain | Tree) -> Array:
    """Return 0 for each (independent) joint of a robot, or the middle of its limits if 0 is outside of them.

    >>> opening(kl.robots.rpr().changed(limits=[[-1, 1], [0.5, 1.5], [0, 1]]))
    array([0., 1., 0.])
    """
    if robot.limits is None:
        return np.zeros(robot.n)
    low, high = robot.limits.T
    q, bounded = np.clip(0.0, low, high), np.isfinite(low) & np.isfinite(high)
    return np.asarray(np.where((q != 0) & bounded, (np.nan_to_num(low) + np.nan_to_num(high)) / 2, q))


def explore(
    robot: Chain | Tree,
    joints: Sequence[int] | None = None,
    *,
    show: Collection[str] | None = None,
    after: Any = None,
    start: JointValues | None = None,
    frames: Mapping[str, ArrayLike] | None = None,
    packages: Packages = (),
    visuals: tuple[Tree, str] | None = None,
) -> Viewer:
    """Show a robot in three dimensions, with sliders for its joints and, for an arm, the pose of its end-effector.

    A reader can also drag a link: its own joint follows the pointer, or the nearest one before it that has a slider.

    robot    an arm, or a tree, which has a slider for each independent joint
    joints   the joints that get a slider, counted from 1; all by default, but better only those that matter
    show     the layers that are drawn at first, any of kinlib.view.viewer.scene.LAYERS; the reader can switch them. By default
             screw axes, {s} and {b}, or less if there are so many that they would hide the robot
    after    a question; the robot stays covered until a prediction is committed
    start    (n,) the first joint values, or a mapping from joint names to values; by default home, or within the limits of a
             tree. Afterwards `q` is synchronized with the page
    frames   {"0": T_00, "1": T_01, ...} frames on the links of an arm, which the reader switches on one by one; poses (4, 4) in {s}
             at `start`. Frame i is fixed to link i and moves with it; frames beyond the last link are fixed to that one. A name
             with a prime, "1'", is a second frame on the same link, in grey. They replace {s}, {b} and the DH frames. Their
             layers are "frame 0", "frame 1", ...; the first one is shown by default
    packages a folder or folders of packages, or {name: folder}, in which the meshes of a tree are looked for; its own package and
             those of the environment variables of ROS are found without it. What is not found is said, and drawn by rule
    visuals  the file of which an arm is a part, as a tree, and the name of the link whose frame is {s}: the arm looks as the file says

    Raises ValueError if the robot does not have one of the joints, values do not have shape (n,) or contain NaN, a
    layer is unknown, a frame is not a pose or is not named by its link, or no joint moves by one value.

    >>> arm = explore(kl.robots.youbot(), joints=[3])
    >>> arm.q = [0, 0, np.pi / 2, 0, 0]
    >>> arm.alt[-43:]
    'The end-effector is at (0.188, 0, 0.499) m.'
    """
    validation.instance(robot, "robot", Chain, Tree)
    home = opening(robot) if start is None else validation.single(robot.in_order(start), "q")
    found = branches(robot, visuals)
    usual = ["axes", "base", "tool"] if joint_share(found) == 1 else ["base"]
    usual = ["axes", f"frame {next(iter(frames))}"] if frames else usual
    layers = usual if show is None else list(show)
    whole = scene(robot, found, home, joints=joints, frames=frames)
    file = visuals[0] if visuals else robot if isinstance(robot, Tree) else None
    files, meshes, notes = read_meshes([branch.links for branch in found], file.folder if file else None, packages)
    for arm, own in zip(whole["arms"], meshes, strict=True):
        arm["meshes"] = own
    loaders = (STATIC / "meshes.js").read_text("utf-8") if files else ""
    read = {"meshes": files, "loaders": loaders, "notes": notes}

    def draw(viewer: Viewer) -> Picture:
        drawn, own = [name for name in viewer.shown if name in ARM_LAYERS], {}
        if isinstance(robot, Chain):
            moved, given = body_motions(robot, np.array(viewer.q)), whole["arms"][0]["frames"]
            for frame in (given[layer][0] for layer in viewer.own_frames() if layer in viewer.shown):
                own[frame["name"]] = moved[frame["body"]] @ np.reshape(frame["pose"], (4, 4))
        return draw_arm(robot, viewer.q, show=drawn, frames=own)

    shows_pose = isinstance(robot, Chain)
    return Viewer(whole, draw, home, robot=robot, shown=layers, readout=shows_pose, after=after, **read)


def show(
    shown: Chain | DHTable | FrameAssignment | Tree | Mechanism | Picture | Gallery | Viewer | Pictures,
    q: JointValues | None = None,
    *,
    path: str | PathLike[str] = "",
    packages: Packages = (),
) -> None:
    """Show a robot in three dimensions with sliders, a closed chain as a drawing, or anything that this package draws.

    In a notebook it is displayed below the cell. Elsewhere the web browser opens it as a page in a temporary folder.

    shown  a chain, a table or a frame assignment, which are drawn with their frames, a tree, a closed chain, or what a function of
           kinlib.view returns
    q      (n,) joint values, or a mapping from joint names to values; by default some that show the shape of an arm, and
            some within the limits of a tree. A closed chain needs them
    path   the file to save to instead of showing it: .html, or a drawing as .svg or .png
    packages  a folder or folders of packages, or {name: folder}, in which the meshes of a tree are looked for, see `kinlib.view.explore`

    Raises ValueError if q does not have n values or is given without a robot, for anything else to show, for another ending, and
    for a folder that does not exist.

    >>> from tempfile import TemporaryDirectory
    >>> with TemporaryDirectory() as folder:
    ...     show(kl.robots.youbot(), [0, 0, 1, 0, 0], path=f"{folder}/youbot.html")
    ...     Path(folder, "youbot.html").read_text("utf-8")[:15]
    '<!DOCTYPE html>'
    """
    if isinstance(shown, DHTable | FrameAssignment):
        table = shown if isinstance(shown, DHTable) else shown.table
        chain = table.to_chain()
        start = chain.in_order(body_of(chain).pose if q is None else q)
        frames = table_frames(table, start)
        shown = explore(chain, start=start, frames=frames, show=["axes", *(f"frame {name}" for name in frames)])
    elif isinstance(shown, Chain):
        shown = explore(shown, start=body_of(shown).pose if q is None else q)
    elif isinstance(shown, Tree):
        shown = explore(shown, start=q, packages=packages)
    elif isinstance(shown, Mechanism):
        if q is None:
            raise ValueError(
                f"q must be given with a closed chain, the values of {', '.join(shown.names)}, because at 0 its loops need not "
                "close. Pass one of its assembly_modes(hold={...}), or .q of what assemble returns."
            )
        shown = draw_linkage(shown, q)
    elif q is not None:
        raise ValueError(
            f"q must be given with a robot only; got it with a {type(shown).__name__}, which has been drawn already."
        )
    if not isinstance(shown, Picture | Gallery | Viewer | Pictures):
        raise ValueError(
            f"show takes a Chain, DHTable, FrameAssignment, Tree or Mechanism, or what a function of kinlib.view returns; got "
            f"{validation.describe(shown)}."
        )
    # Only a kernel displays HTML, not a script or a terminal.
    shell: Any = getattr(sys.modules.get("IPython"), "get_ipython", lambda: None)()
    if path:
        shown.save(path)
    elif shell is not None and type(shell).__name__ != "TerminalInteractiveShell":
        from IPython.display import display

        display(shown)
    else:
        file = Path(mkdtemp(prefix="kinlib-")) / "shown.html"
        shown.save(file)
        if not webbrowser.open(file.as_uri()):
            print(f"No web browser was found. Open this file in one: {file}")
