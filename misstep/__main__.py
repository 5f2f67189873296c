"""The command line: `kinlib COMMAND ...`, or `python -m kinlib COMMAND ...`.

Each command lives in a module of its own, with `add_arguments(parser)` and `run(options) -> int`, the exit code. It is
imported when somebody asks for it, and not before.
"""

import argparse
import importlib
import sys
from collections.abc import Sequence

COMMANDS = {
    "grade": ("misstep.grading.command", "grade the submissions of a sheet, in a sandbox"),
    "new-sheet": ("kincourse.robot_sheets.new_sheet", "write a sheet of exercises for a robot of your own"),
}
"""For each command its module, and what it does, in a few words."""


def main(arguments: Sequence[str] | None = None) -> int:
    """Run the command that the arguments name, and give its exit code: 0 done, 2 asked for something that cannot be.

    >>> main(["new-sheet", "nowhere.urdf", "--out", "solutions/my_robot"])
    2
    """
    arguments = sys.argv[1:] if arguments is None else arguments
    parser = argparse.ArgumentParser(prog="kinlib", description="Tools for those who teach with kinlib.")
    commands = parser.add_subparsers(metavar="command", required=True)
    for name, (module, told) in COMMANDS.items():
        of_command = commands.add_parser(name, help=told, description=f"{told[0].upper()}{told[1:]}.")
        if name in arguments[:1]:
            try:
                command = importlib.import_module(module)
            except ModuleNotFoundError as missing:
                of_command.error(
                    f"{missing}. What this needs besides kinlib is an extra, for Linux: pip install 'misstep[grading]'"
                )
            command.add_arguments(of_command)
            of_command.set_defaults(run=command.run)
    options = parser.parse_args(arguments)
    code: int = options.run(options)
    return code


if __name__ == "__main__":
    raise SystemExit(main())
