"""The command line: `misstep COMMAND ...`, or `python -m misstep COMMAND ...`.

Each command is a module with `add_arguments(parser)` and `run(options) -> int`, which returns the exit code. It is imported
only when it is used. A command raises ValueError for a request that is impossible; its message is for the user, as is that of an
OSError. A course that has commands of its own calls `run_command` with them.
"""

import argparse
import importlib
import sys
from collections.abc import Mapping, Sequence

COMMANDS = {
    "export": ("misstep.grading.prairielearn", "write the problems of the course for PrairieLearn"),
    "grade": ("misstep.grading.command", "grade the submissions of a sheet, without running them"),
    "preview": ("misstep.release.preview", "show a problem, and each mistake with its card"),
    "release": ("misstep.release.student_notebook", "write the students' notebooks from the instructors' notebooks"),
}
"""For each command its module, and what it does."""


def main(arguments: Sequence[str] | None = None) -> int:
    """Run the command that the arguments name, and return its exit code: 0 done, 2 invalid request."""
    return run_command("misstep", "Sheets that check themselves.", COMMANDS, arguments)


def run_command(
    program: str, description: str, commands: Mapping[str, tuple[str, str]], arguments: Sequence[str] | None = None
) -> int:
    """Run the command of a program that the arguments name, and return its exit code."""
    arguments = sys.argv[1:] if arguments is None else arguments
    parser = argparse.ArgumentParser(prog=program, description=description)
    subparsers = parser.add_subparsers(metavar="command", dest="command", required=True)
    try:
        for name, (module, purpose) in commands.items():
            subparser = subparsers.add_parser(name, help=purpose, description=f"{purpose[0].upper()}{purpose[1:]}.")
            if name in arguments[:1]:
                command = importlib.import_module(module)
                command.add_arguments(subparser)
                subparser.set_defaults(run=command.run)
        options = parser.parse_args(arguments)
        code: int = options.run(options)
    except ModuleNotFoundError as missing:
        parser.error(f"{missing}. Install what this command requires: pip install 'kincourse[grading]'")
    except (OSError, ValueError) as error:
        print(f"{program} {arguments[0]}: {error}", file=sys.stderr)
        return 2
    return code
