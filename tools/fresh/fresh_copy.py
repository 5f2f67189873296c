"""A copy of the repository in an empty folder, where the commands of the documents are run as a newcomer runs them."""

import os
import re
import shutil
import socket
import subprocess
import sys
import tempfile
import time
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path

from documents import ROOT

SUPPORTED = tuple(re.findall(r"Python :: (3\.\d+)", (ROOT / "pyproject.toml").read_text("utf-8")))
OTHER_TOOLS = ("PYTHON", "VIRTUAL_ENV", "PYTEST_", "JUPYTER", "IPYTHON", "KINLIB_", "UV_PROJECT", "NOX")
"""What a variable of the environment begins with that must not reach a newcomer's commands."""
GENERATED = (".venv", ".uv", "build", "node_modules", "__pycache__", ".*_cache", ".hypothesis")
"""Folders that a copy does not contain, because it makes its own."""
START_S = 300
"""How long a server may take until it answers."""


class Failure(Exception):
    """A command did not do what its document says."""


class NotTried(Exception):
    """Something that this machine lacks, so that nothing is known about the path."""


class Place:
    """A fresh copy of the repository, and a Python in which nothing of the course is installed.

    folder  where commands are run; `enter` changes it
    """

    def __init__(self, python: Path):
        self.python = python
        self.root = Path(tempfile.mkdtemp(prefix="fresh-"))
        self.folder = self.root / "course"
        copy_repository(self.folder)
        kept = {name: value for name, value in os.environ.items() if not name.startswith(OTHER_TOOLS)}
        jupyter = {name: str(self.root / name) for name in ("JUPYTER_DATA_DIR", "JUPYTER_CONFIG_DIR", "IPYTHONDIR")}
        self.environment = {**kept, **jupyter, "PYTHONNOUSERSITE": "1", "MPLCONFIGDIR": str(self.root / "matplotlib")}

    def run(self, command: str, *, also: str = "", replace: dict[str, str] | None = None, **variables: str) -> str:
        """Run a command of a document, and return what it prints.

        also      further arguments, such as those that open no browser
        replace   parts of the command that differ here, such as the folder of an environment

        Raises Failure if its exit code is not 0.
        """
        line = self.translated(command, also, replace)
        done = subprocess.run(
            ["bash", "-euo", "pipefail", "-c", line], cwd=self.folder, env={**self.environment, **variables},
            stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True, errors="replace", check=False,
        )  # fmt: skip
        if done.returncode:
            raise Failure(f"{command}\n{done.stdout[-3000:]}")
        return done.stdout

    def translated(self, command: str, also: str = "", replace: dict[str, str] | None = None) -> str:
        """Put this Python for `python` into a command, and what replaces its other parts."""
        for old, new in (replace or {}).items():
            if old not in command:
                raise Failure(f"{command}\nIt must contain {old!r}, which differs here.")
            command = command.replace(old, new)
        return re.sub(r"(?<![\w./-])python3?(?= )", str(self.python), f"{command} {also}".strip())

    @contextmanager
    def started(self, command: str, address: str, *, also: str = "") -> Iterator[None]:
        """Run a command that serves an address, until the block ends. Raises Failure if it ends by itself or does not answer."""
        log = self.root / "server.log"
        with log.open("w") as stream:
            server = subprocess.Popen(
                ["bash", "-c", f"exec {self.translated(command, also)}"],
                cwd=self.folder, env=self.environment, stdout=stream, stderr=subprocess.STDOUT,
            )  # fmt: skip
        try:
            host, port = address.split(":")
            deadline = time.monotonic() + START_S
            while not answers(host, int(port)):
                if server.poll() is not None or time.monotonic() > deadline:
                    raise Failure(f"{command}\nNothing answers at {address}.\n{log.read_text('utf-8')[-3000:]}")
                time.sleep(0.5)
            yield
        finally:
            server.terminate()
            server.wait()

    def enter(self, name: str) -> Path:
        """Change to another folder beside the copy, and return it."""
        self.folder = self.root / name
        self.folder.mkdir(exist_ok=True)
        return self.folder

    def remove(self) -> None:
        """Delete the copy and its environments."""
        shutil.rmtree(self.root, ignore_errors=True)


def copy_repository(target: Path) -> None:
    """Copy the files that git has, or would have after the next commit; of an archive without git, what is not generated."""
    listed = subprocess.run(
        ["git", "ls-files", "-z", "--cached", "--others", "--exclude-standard"],
        cwd=ROOT, capture_output=True, text=True, check=False,
    )  # fmt: skip
    if listed.returncode:
        shutil.copytree(ROOT, target, ignore=shutil.ignore_patterns(*GENERATED), dirs_exist_ok=True)
        return
    for name in filter(None, listed.stdout.split("\0")):
        if (ROOT / name).is_file():
            (target / name).parent.mkdir(parents=True, exist_ok=True)
            shutil.copy(ROOT / name, target / name)


def answers(host: str, port: int) -> bool:
    """Whether a server listens."""
    with socket.socket() as connection:
        connection.settimeout(1)
        return connection.connect_ex((host, port)) == 0


def free_port() -> int:
    """Find a port on which nothing listens."""
    with socket.socket() as one:
        one.bind(("127.0.0.1", 0))
        return int(one.getsockname()[1])


def reachable(host: str) -> bool:
    """Whether the name of a host is known here; without a network, or with registries only, it is not."""
    try:
        return bool(socket.getaddrinfo(host, 443))
    except OSError:
        return False


def pythons() -> dict[str, Path]:
    """Find the Pythons of this machine that the course supports, by their versions."""
    folders = [*os.environ["PATH"].split(os.pathsep), *sorted(map(str, Path.home().glob(".pyenv/versions/*/bin")))]
    own = f"{sys.version_info.major}.{sys.version_info.minor}"
    found = {own: Path(sys._base_executable)} if own in SUPPORTED else {}
    for version in SUPPORTED:
        for folder in folders:
            program = Path(folder) / f"python{version}"
            if (
                program.is_file()
                and subprocess.run([program, "-c", ""], capture_output=True, check=False).returncode == 0
            ):
                found.setdefault(version, program)
    return dict(sorted(found.items()))
