"""Tasks on the pose of the tool of any robot: at home, at given joint values, and with a mistake that is to be found."""

from functools import partial, reduce

import numpy as np

from kincourse.answers.pose import PoseAnswer
from kincourse.expressions.poses import pose, with_position
from kincourse.expressions.screws import exponentials, forward_kinematics, joint_values
from kincourse.robot_sheets.sampling import random_arm, random_configuration, random_tilted_base, random_tool, rebased
from kincourse.robot_sheets.task import task
from kincourse.sampling.arms import ArmSampler, shows_transposes
from kinlib.arrays.validation import Array
from kinlib.chains.chain import Chain
from kinlib.rigid.lie import exp
from kinlib.view import draw_arm, draw_frames
from misstep.answers.choice import Choice
from misstep.answers.number import Numbers
from misstep.display.text import matrix, number
from misstep.mistakes import mistake
from misstep.problem import Problem

NO_MISTAKE = "made no mistake"

HOME_ADVICE = "With space screws $M$ is the last factor."
ORDER_ADVICE = "The factor of the joint at the base is to the left of all others, because this joint moves all others."

READ_VALUES_SOLUTION = """\
turns = given.screws[:, :3].any(axis=1)
q = np.where(turns, np.radians(given.values), given.values)
"""

SPACE_FORM_SOLUTION = READ_VALUES_SOLUTION + "pose_{k} = kl.Chain(given.screws, given.home).fk(q)"

WHICH_MISTAKE_SOLUTION = f"""\
{READ_VALUES_SOLUTION}from kincourse.robot_sheets.motion_tasks import poses_by_mistake

poses = poses_by_mistake(given.screws, given.home, q, given.values)
letter = next(letter for letter, text in given.options.items() if np.allclose(poses[text], given.X))
letter_{{k}} = letter, poses["{NO_MISTAKE}"][:3, 3]
"""

POSE = "pose", "Answer with a pose, an array of shape (4, 4)."
MOVED_POSE = "pose", f"{POSE[1]} `given.values` are in degrees and metres."
LETTER = "letter", "Answer with a pair: a letter in quotes, and a position. `given.values` are in degrees and metres."


@task(
    "The home pose in your lab",
    2,
    "03_poe_space#The home pose",
    POSE,
    "pose_{k} = given.T_sr @ given.T_rf @ given.T_fb",
)
def home_pose(robot: Chain, sampler: ArmSampler) -> Problem:
    """The home pose of the robot with another base and a tool on its flange."""
    T_sr, T_rf, T_fb = random_tilted_base(sampler, robot), robot.home, random_tool(sampler, robot)
    while not shows_transposes(rebased(robot, T_sr, T_fb)):
        T_sr, T_fb = random_tilted_base(sampler, robot), random_tool(sampler, robot)
    M = pose("T_{sr}", T_sr) @ pose("T_{rf}", T_rf) @ pose("T_{fb}", T_fb)
    unrotated = with_position(M.value, T_sr[:3, 3] + T_rf[:3, 3] + T_fb[:3, 3])
    M = M.mistaken_for(("positions added", "add the positions without rotating them", unrotated))
    return Problem(
        statement=f"In its file, {robot.name} has a base frame {{r}} and a flange with the frame {{f}}, whose pose at $q = 0$ is "
        "$T_{rf}$. In your lab its base has the pose $T_{sr}$. A tool with the frame {b} is mounted on the flange at $T_{fb}$. Give the "
        "home pose $M = T_{sb}(0)$.\n\n"
        f"$$T_{{sr}} = {matrix(T_sr)}$$\n\n$$T_{{rf}} = {matrix(T_rf)}$$\n\n$$T_{{fb}} = {matrix(T_fb)}$$",
        figure=partial(draw_frames, {"s": np.eye(4), "r": T_sr, "f": T_sr @ T_rf}),
        given={"T_sr": T_sr, "T_rf": T_rf, "T_fb": T_fb},
        answer=PoseAnswer(M),
        advice={
            "leave out $T_{sr}$": "This is the pose of the tool in {r}: $T_{sr}$ must be the first factor.",
            "leave out $T_{fb}$": "This is the pose of the flange: $T_{fb}$ must be the last factor.",
            "reversed": "$T_{sr}\\,T_{rf}\\,T_{fb}$: neighbouring letters cancel.",
        },
    ).without_duplicates()


@task("Where is the tool?", 3, "03_poe_space#The product", MOVED_POSE, SPACE_FORM_SOLUTION)
def where_is_the_tool(robot: Chain, sampler: ArmSampler) -> Problem:
    """Forward kinematics by the space form, at a configuration within the joint limits."""
    arm = random_arm(sampler, robot)
    at = random_configuration(sampler, arm)
    return Problem(
        statement=f"The joint values of {robot.name} are {at.words}. Its screws in {{s}} and the home pose of its tool are below. Give "
        f"$T(q)$.\n\n$$S = {matrix(arm.screws)}$$\n\n$$M = {matrix(arm.home)}$$",
        figure=partial(draw_arm, arm),
        given={"screws": arm.screws, "home": arm.home, "values": at.typed},
        answer=PoseAnswer(arm.fk(at.q)),
        solution=forward_kinematics(
            exponentials(arm.screws, joint_values(arm.joint_types, at.typed)), pose("M", arm.home)
        ).named("T"),
        advice={"reversed": ORDER_ADVICE, "first factor": HOME_ADVICE},
    ).without_duplicates()


@task("Which mistake is this?", 2, "03_poe_space#The order of the factors", LETTER, WHICH_MISTAKE_SOLUTION)
def which_mistake(robot: Chain, sampler: ArmSampler) -> Problem:
    """The mistake that leads to a given wrong pose, or none if the pose is right."""
    arm = random_arm(sampler, robot)
    at = random_configuration(sampler, arm)
    ways = poses_by_mistake(arm.screws, arm.home, at.q, at.typed)
    right_pose = ways.pop(NO_MISTAKE)
    distinct = Problem("", PoseAnswer(right_pose), [mistake(*way, "") for way in ways.items()]).without_duplicates()
    drawn = sampler.shuffled(range(len(distinct.mistakes)))[:4]
    wrong = [distinct.mistakes[i] for i in sorted(drawn)]
    letters = "abcdef"[: len(wrong) + 1]
    descriptions = dict(zip(letters, [*(one.name for one in wrong), NO_MISTAKE], strict=True))
    poses = dict(zip(letters, [*(one.value for one in wrong), right_pose], strict=True))
    right = sampler.choice(letters)
    listed = "\n".join(f"- `'{letter}'`: {text}" for letter, text in descriptions.items())
    problem = Problem(
        statement=f"The joint values of {robot.name} are {at.words}. A student computed the pose $X$ of its tool by the space form. Check "
        f"$X$: what did this student do?\n\n$$S = {matrix(arm.screws)}$$\n\n$$M = {matrix(arm.home)}$$\n\n$$X = {matrix(poses[right])}$$"
        f"\n\n{listed}\n\nAnswer with a letter and the position of the tool that is right, such as `('a', [0.1, 0.2, 0.3])`.",
        figure=partial(draw_arm, arm),
        given={"screws": arm.screws, "home": arm.home, "values": at.typed, "X": poses[right], "options": descriptions},
        answer=Choice(right, descriptions),
        mistakes=[
            mistake(descriptions[letter], letter, _difference_message(poses[letter], poses[right]))
            for letter in letters
            if letter != right
        ],
    )
    return problem.with_reason(Numbers(right_pose[:3, 3], unit="m"), "the position")


def poses_by_mistake(screws: Array, home: Array, q: Array, typed: Array) -> dict[str, Array]:
    """Return the poses to which common mistakes lead, and the right one, by what was done.

    typed  the joint values with angles in degrees
    """
    e, in_degrees, back = (exp(screws * values[:, None]) for values in (q, typed, -q))
    ways = {
        "multiplied the exponentials from the last joint to the first": [*e[::-1], home],
        "put $M$ in front": [home, *e],
        "left out $M$": [*e],
        "added the twists and took one exponential": [exp(q @ screws), home],
        "used degrees as radians": [*in_degrees, home],
        "left all joint values at 0": [home],
        "took every joint value with the opposite sign": [*back, home],
        NO_MISTAKE: [*e, home],
    }
    return {name: reduce(np.matmul, factors) for name, factors in ways.items()}


def _difference_message(theirs: Array, right: Array) -> str:
    """How the pose of an option differs from the pose that was computed, as a message."""
    far = float(np.linalg.norm(theirs[:3, 3] - right[:3, 3]))
    rotated = not np.allclose(theirs[:3, :3], right[:3, :3], atol=1e-6)
    if far < 1e-6:
        return "This would give the position of $X$, but another orientation."
    return f"This would give a position {number(far)} m from that of $X$" + (
        ", and another orientation." if rotated else "."
    )
