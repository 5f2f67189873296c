"""The command line of the course: `kincourse new-sheet robot.urdf --out FOLDER`, or `python -m kincourse ...`."""

from collections.abc import Sequence

from misstep.cli import run_command

COMMANDS = {
    "new-sheet": ("kincourse.new_sheet", "write a sheet of exercises for a robot of your own"),
    "pictures": ("kincourse.still_pictures", "draw the picture below the title of each lecture"),
}


def main(arguments: Sequence[str] | None = None) -> int:
    """Run the command that the arguments name, and return its exit code: 0 done, 2 invalid request."""
    return run_command("kincourse", "Tools for lecturers.", COMMANDS, arguments)


if __name__ == "__main__":
    raise SystemExit(main())
