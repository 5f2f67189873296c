"""`python -m kincourse COMMAND ...`."""

from kincourse.cli import main

if __name__ == "__main__":
    raise SystemExit(main())
