"""`python -m misstep COMMAND ...`."""

from misstep.cli import main

if __name__ == "__main__":
    raise SystemExit(main())
