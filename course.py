"""Open the course, test it, or build and serve its site. This needs nothing but Python 3.11 or newer and pip.

    python course.py open        start JupyterLab on the first lecture
    python course.py test        run every test
    python course.py site        build the course site into build/site/html
    python course.py serve       serve it on http://127.0.0.1:8000, to this machine only

The first run makes an environment in .venv, with the versions in constraints.txt; later runs use it again.
Further arguments are passed on to JupyterLab or pytest: "open --no-browser", "test -k lie".
"""

import hashlib
import os
import shutil
import signal
import subprocess
import sys
import venv
from pathlib import Path

ROOT = Path(__file__).resolve().parent
VENV = ROOT / ".venv"
PYTHON = VENV / ("Scripts/python.exe" if os.name == "nt" else "bin/python")
SITE = ROOT / "build" / "site" / "html"
STAMP = VENV / "stamp.txt"  # what the environment was made from; does not exist while it is being made

LAB = (
    "-m",
    "jupyterlab",
    f"--ServerApp.root_dir={ROOT}",
    "--LabApp.default_url=/lab/tree/notebooks/00_start_here.ipynb",
    f"--LabApp.app_settings_dir={ROOT / 'site' / 'lab'}",  # the settings of the lab in the browser: no news, frequent saving
)
PROGRAMS = {
    "open": LAB,
    "test": ("-m", "pytest", "--numprocesses=auto", "--dist=loadscope", "--no-loadscope-reorder"),
    "site": ("site/build.py",),
    "serve": ("-m", "http.server", "--bind=127.0.0.1", f"--directory={SITE}"),
}
NEEDS = {  # command: what it installs, about how many MB that is
    "open": (("--group", "lab", "-e", "."), 400),
    "test": (("--group", "test", "-e", ".[grading,site]"), 1600),
    "site": (("-e", ".[site]"), 500),
    "serve": (("-e", ".[site]"), 500),
}
AGAIN = "The same command continues from here."


def main(command="help", *words):
    if command not in PROGRAMS:
        print(__doc__)
        known = command in ("help", "-h", "--help")
        sys.exit(0 if known else f"The command must be one of {', '.join(PROGRAMS)}; got {command!r}.")
    if sys.version_info < (3, 11):
        sys.exit(
            f"The course needs Python 3.11 or newer; this is {sys.version.split()[0]}. Try: python3.13 course.py {command}"
        )
    if Path(sys.prefix).resolve() == VENV.resolve():  # an environment cannot make itself anew
        run([sys._base_executable, ROOT / "course.py", command, *words])
    if command == "serve" and not SITE.exists():
        sys.exit("The site is not built yet. Try: python course.py site")
    prepare(command)
    arguments = [*PROGRAMS[command], *words]
    if command == "open" and getattr(os, "geteuid", lambda: 1)() == 0:
        print("You are root. JupyterLab refuses root unless it is told otherwise, so it is started with --allow-root.")
        arguments.append("--allow-root")
    run([PYTHON, *arguments])


def prepare(command):
    """Make .venv, unless its stamp says that this Python made it in this folder from the same files."""
    packages, megabytes = NEEDS[command]
    texts = [
        sys.version,
        str(ROOT),
        *((ROOT / name).read_text("utf-8") for name in ("pyproject.toml", "constraints.txt")),
    ]
    source = hashlib.sha256("\n".join(texts).encode()).hexdigest()
    made_from, *made_for = STAMP.read_text("utf-8").split() if STAMP.exists() else [""]
    if made_from == source and {command, "test"} & set(made_for):
        return
    print(f"Installing the course in {VENV}, about {megabytes} MB. This happens once.", flush=True)
    if made_from != source:
        shutil.rmtree(VENV, ignore_errors=True)
        made_for = []
        # pip itself comes with the next step, because Debian's Python lacks the module that would copy it.
        venv.create(VENV, symlinks=os.name != "nt", with_pip=False)
        install(sys.executable, "-m", "pip", "--python", PYTHON, "install", "--upgrade", "pip")
    STAMP.unlink(missing_ok=True)
    install(PYTHON, "-m", "pip", "install", "--progress-bar=off", *packages)
    STAMP.write_text(" ".join([source, *made_for, command]), "utf-8")


def install(*command):
    """Run pip with the pins, in words that say what to do if it fails."""
    settings = {"PIP_USER": "0", "PIP_ROOT_USER_ACTION": "ignore", "PIP_DISABLE_PIP_VERSION_CHECK": "1"}
    pinned = [*command, "--quiet", "-c", "constraints.txt"]
    if subprocess.call(pinned, cwd=ROOT, env=environment(settings)) == 0:
        return
    if subprocess.call([sys.executable, "-m", "pip", "--version"], stdout=subprocess.DEVNULL) != 0:
        sys.exit("This Python has no pip. Try: python -m ensurepip; on Debian or Ubuntu: sudo apt install python3-pip")
    free = shutil.disk_usage(ROOT).free / 1e6
    if free < 2000:
        sys.exit(f"course.py could not install the course: {free:.0f} MB are left on the disk. Make room. {AGAIN}")
    sys.exit(
        "course.py could not install the course; pip says why above. Check the network, and behind a proxy the settings of "
        f"pip: python -m pip config list. If JupyterLab is open, close it. {AGAIN}"
    )


def environment(settings):
    # PYTHONPATH is left out because it adds packages of another Python; for example, ROS sets it and breaks pytest
    return {**{name: value for name, value in os.environ.items() if name != "PYTHONPATH"}, **settings}


def run(command):
    """Become another program, or on Windows, which cannot do that, wait for it."""
    os.chdir(ROOT)
    sys.stdout.flush()
    if os.name != "nt":
        os.execve(command[0], [str(word) for word in command], environment({}))
    signal.signal(signal.SIGINT, lambda *_: None)  # Ctrl-C goes to the program that we start, which ends in its own way
    sys.exit(subprocess.call(command, env=environment({})))


if __name__ == "__main__":
    main(*sys.argv[1:])
