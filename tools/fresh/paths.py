"""The paths: for each set of commands that documents give, a new environment with what they install, and what must come of it."""

import json
import re
import shutil
import urllib.request
from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path as FilePath

from fresh_copy import Failure, NotTried, Place, free_port, reachable

LECTURE = "notebooks/00_start_here.ipynb"
SHEET = "solutions/03_poe_space/03_poe_space.ipynb"
PYODIDE = "cdn.jsdelivr.net"
CHROMIUM = ("chromium", "chromium-browser", "google-chrome")


@dataclass(frozen=True)
class Path:
    """A path by its name, what it does in a place, and the commands of documents that it runs."""

    name: str
    run: Callable[[Place], None]
    commands: tuple[str, ...]


PATHS: dict[str, Path] = {}


def path(*commands: str) -> Callable[[Callable[[Place], None]], Callable[[Place], None]]:
    """Register a path with the commands of documents that it runs; one of them not run is a failure of the path."""

    def register(function: Callable[[Place], None]) -> Callable[[Place], None]:
        PATHS[function.__name__] = Path(function.__name__, function, commands)
        return function

    return register


def rehearse(name: str, python: FilePath) -> tuple[str, str]:
    """Run a path on a Python. Returns the result, and the reason if it did not pass."""
    place, path = Place(python), PATHS[name]
    try:
        path.run(place)
    except NotTried as reason:
        return "not tried", str(reason)
    except (Failure, OSError) as error:
        return "FAILED", str(error)
    finally:
        place.remove()
    if forgotten := [command for command in path.commands if command not in place.done]:
        return "FAILED", f"It did not run {forgotten}."
    return "passed", ""


# --- a student ---


@path("python course.py open")
def lab(place: Place) -> None:
    """JupyterLab opens, loads what shows sliders and the viewer, and runs lecture 00."""
    run_lecture(place, "python course.py open", "--no-browser --LabApp.open_browser=False")


@path("pip install -r .binder/requirements.txt")
def binder(place: Place) -> None:
    """The same with what Binder installs; its builder runs pip in the folder of the file."""
    place.run("python -m venv .venv")
    place.run("pip install -r .binder/requirements.txt", replace={"pip": ".venv/bin/python -m pip"})
    run_lecture(place, ".venv/bin/python -m jupyter lab", "--no-browser --allow-root")


def run_lecture(place: Place, command: str, options: str) -> None:
    address, token = f"127.0.0.1:{free_port()}", "fresh"
    options += f" --ServerApp.port={address.split(':')[1]} --ServerApp.port_retries=0 --IdentityProvider.token={token}"
    with place.started(command, address, also=f"{options} --allow-root"):
        print(place.run(f".venv/bin/python tools/fresh/run_lecture.py {address} {token} {LECTURE}").strip())


# --- a reader of the site ---


@path("python course.py site", "python course.py serve", ".venv/bin/python site/check.py")
def site(place: Place) -> None:
    """The site and its lab are built, complete, and served."""
    place.run("python course.py site", KINLIB_LAB="offline")
    place.run(".venv/bin/python site/check.py")
    port = free_port()
    with place.started("python course.py serve", f"127.0.0.1:{port}", also=str(port)):
        for page in ("index.html", "lectures/00_start_here.html", "lab/notebooks/index.html"):
            with urllib.request.urlopen(f"http://127.0.0.1:{port}/{page}", timeout=30) as answer:
                if b"</html>" not in answer.read():
                    raise Failure(f"{page} is not complete.")


@path(".venv/bin/python site/pdf.py", ".venv/bin/python site/check.py --published")
def pdf(place: Place) -> None:
    """The site is complete for publication after its PDF is printed."""
    if not any(map(shutil.which, CHROMIUM)):
        raise NotTried("there is no Chromium on the path")
    place.run("python course.py site", KINLIB_LAB="offline")
    place.run(".venv/bin/python site/pdf.py")
    place.run(".venv/bin/python site/check.py --published")


EMPTY_LAB = """
import pathlib, sys
from kinsite import npm_packages
from kinsite.browser_lab import lab
npm_packages.install()
sheet = pathlib.Path("notebooks/00_start_here.ipynb").resolve()
lab.contents = lambda: [sheet]
print(lab.build())
"""


@path()
def empty_lab(place: Place) -> None:
    """The group `site` alone resolves, and builds a lab with a single notebook: what JupyterLite loads is there."""
    place.run(f"python -c '{PREPARE}'")
    (place.folder / "empty_lab.py").write_text(EMPTY_LAB, "utf-8")
    place.run(".venv/bin/python empty_lab.py", KINLIB_LAB="offline", PYTHONPATH="site")
    if not (place.folder / "build/lab/offline/html/files" / LECTURE).is_file():
        raise Failure(f"The lab must contain {LECTURE}.")


PREPARE = 'import sys; sys.path.insert(0, "tools"); import set_up; set_up.prepare("site", newest=False)'


# --- a contributor ---


@path("python course.py test --quick", ".venv/bin/python -m nox --list", ".venv/bin/python -m nox -s format")
def quick_tests(place: Place) -> None:
    """The quick tests pass, and so do the checks that run no code."""
    place.run("python course.py test --quick")
    place.run(".venv/bin/python -m nox --list")
    place.run(".venv/bin/python -m nox -s format")
    place.run(".venv/bin/python -m nox -s lint")


@path(
    "python -m pip install -c constraints.txt nox", "python -m nox -s distributions", "python -m pip install dist/*.whl",
    'for package in kinlib misstep kincourse; do python -m doctest "checkout/$package/README.md"; done',
)  # fmt: skip
def release(place: Place) -> None:
    """The wheels are built and checked, and the documents of the packages are true of them, as in release.yml."""
    place.run("python -m venv builder")
    place.run("python -m pip install -c constraints.txt nox", replace={"python": "builder/bin/python"})
    place.run("python -m nox -s distributions", replace={"python": "builder/bin/python"})
    place.run("python -m venv tried")
    place.run("python -m pip install dist/*.whl", replace={"python": "tried/bin/python"})
    course, checkout = place.folder, place.enter("empty") / "checkout"
    checkout.symlink_to(course)
    place.run(PATHS["release"].commands[3], replace={"python": f"{course}/tried/bin/python"})


# --- an instructor ---


@path(
    ".venv/bin/pip install ./kinlib './misstep[grading,release]' ./kincourse", "source .venv/bin/activate", "misstep grade",
    "misstep release", "kincourse new-sheet robot.urdf --out solutions/my_robot",
    "nbgrader generate_assignment 03_poe_space --force",
)  # fmt: skip
def grade(place: Place) -> None:
    """What the instructor's guide installs grades a sheet, with and without a gradebook, and makes sheets."""
    place.run("python -m venv .venv")
    place.run(PATHS["grade"].commands[0])
    activated = {"source .venv/bin/activate": "source .venv/bin/activate && misstep release"}
    place.run("source .venv/bin/activate", replace=activated)
    place.done.append("misstep release")
    for folder in ("submissions", "submitted"):
        student = place.folder / folder / "your id" / "03_poe_space"
        student.mkdir(parents=True)
        shutil.copy(place.folder / SHEET, student)
    programs = {"misstep": ".venv/bin/misstep"}
    place.run("misstep grade", also=f"{SHEET} submissions --out results", replace=programs)
    points = re.search(r"^your id,([\d.]+)", (place.folder / "results/grades.csv").read_text("utf-8"), re.MULTILINE)
    cells = json.loads((place.folder / SHEET).read_text("utf-8"))["cells"]
    total = sum(cell["metadata"].get("nbgrader", {}).get("points", 0) for cell in cells)
    if points is None or float(points[1]) != total:
        raise Failure(f"The official solution of sheet 03 must have {total} points, has {points and points[1]}.")
    place.run(
        "nbgrader generate_assignment 03_poe_space --force",
        replace={"nbgrader": "PATH=.venv/bin:$PATH .venv/bin/nbgrader"},
    )
    place.run("misstep grade", also=f"{SHEET} submitted --out books --gradebook .", replace=programs)
    robot = place.run(".venv/bin/python -c 'import kinlib as kl; print(kl.to_urdf(kl.robots.puma560()))'")
    (place.folder / "robot.urdf").write_text(robot, "utf-8")
    place.run("kincourse new-sheet robot.urdf --out solutions/my_robot", replace={"kincourse": ".venv/bin/kincourse"})


HUB = "sudo /opt/hub/bin/pip install -c constraints.txt -r deploy/hub.txt ./kinlib './misstep[grading]' ./kincourse"


@path(HUB)
def hub(place: Place) -> None:
    """What the page on Hubs installs has a Hub that reads its configuration, and a server for a student."""
    place.run("python -m venv .venv")
    place.run(HUB, replace={"sudo /opt/hub/bin/pip": ".venv/bin/pip"})
    shown = place.run(".venv/bin/jupyterhub -f deploy/jupyterhub_config.py --show-config")
    if "jupyterhub-singleuser" not in shown:
        raise Failure(f"The configuration must name the program of a student's server:\n{shown}")
    place.run(".venv/bin/jupyterhub-singleuser --version")
    run_lecture(place, ".venv/bin/python -m jupyter lab", "--no-browser")


CONTAINER = (
    "/opt/venv/bin/pip install --no-cache-dir -c /opt/course/constraints.txt -r /opt/course/hub.txt"
    " /opt/course/kinlib '/opt/course/misstep[grading,release]' /opt/course/kincourse"
)


@path(CONTAINER, 'python -c "import matplotlib.pyplot"')
def container(place: Place) -> None:
    """What the container installs grades a sheet; its engine is another matter."""
    place.run("python -m venv .venv")
    here = {"/opt/venv/bin/pip": ".venv/bin/pip", "/opt/course/hub.txt": "deploy/hub.txt", "/opt/course/": "./"}
    place.run(CONTAINER, replace=here)
    place.run('python -c "import matplotlib.pyplot"', replace={"python": ".venv/bin/python"})
    (place.folder / "submissions" / "your id").mkdir(parents=True)
    shutil.copy(place.folder / SHEET, place.folder / "submissions" / "your id")
    place.run(f".venv/bin/misstep grade {SHEET} submissions --out results")


# --- an author of another course ---

SITE_OF_A_COURSE = (
    ".venv/bin/python -m pip install -e '.[site]'",
    ".venv/bin/python -m pip wheel --no-deps --wheel-dir build/wheels . misstep",
    ".venv/bin/python -m misstep release",
    ".venv/bin/python -m sphinx -W . build/site",
)


@path(
    "python -m pip install ./misstep", "misstep new-course my_course", "python -m venv .venv",
    ".venv/bin/python -m pip install path/to/repository/misstep", ".venv/bin/python -m pip install -e '.[instructor]'",
    ".venv/bin/python -m pytest", ".venv/bin/python -m misstep census --course my_course --students 10",
    *SITE_OF_A_COURSE,
)  # fmt: skip
def new_course(place: Place) -> None:
    """From the engine alone to a course of its own, tested, released, and with a site."""
    place.run("python -m venv engine")
    place.run("python -m pip install ./misstep", replace={"python": "engine/bin/python"})
    engine = place.folder / "misstep"
    program = place.folder / "engine/bin/misstep"
    place.enter("courses")
    place.run("misstep new-course my_course", replace={"misstep": str(program)})
    place.enter("courses/my_course")
    place.run("python -m venv .venv")
    repository = {"path/to/repository/misstep": str(engine)}
    place.run(".venv/bin/python -m pip install path/to/repository/misstep", replace=repository)
    for command in PATHS["new_course"].commands[4:7]:
        place.run(command)
    if place.run("python -c 'import sys; print(sys.version_info >= (3, 12))'").strip() == "False":
        raise NotTried("the site of a new course needs Python 3.12")
    settings = place.folder / "jupyter_lite_config.json"
    if not reachable(PYODIDE):
        settings.write_text(settings.read_text("utf-8").replace('"enabled": true', '"enabled": false'), "utf-8")
    for command in SITE_OF_A_COURSE:
        place.run(command, replace={". misstep": f". {engine}"} if "wheel" in command else None)
    check_site_of_a_course(place)


def check_site_of_a_course(place: Place) -> None:
    built = place.folder / "build" / "site"
    if "data-misstep-question" not in (built / "notebooks/01_ohm.html").read_text("utf-8"):
        raise Failure("The page of the lecture must show its question.")
    sheet = re.sub("<[^>]+>", "", (built / "exercises/01_ohm/01_ohm.html").read_text("utf-8"))
    if "resistance_1 = ..." not in sheet or "1 / (1 /" in sheet:
        raise Failure("The page of the sheet must show the blank cells of students, and no solution.")
    notebooks = {path.name for path in (built / "lite/files").rglob("*.ipynb")}
    if notebooks != {"01_ohm.ipynb"}:
        raise Failure(f"The lab must have the notebooks of the pages; it has {sorted(notebooks)}.")
    if not reachable(PYODIDE):
        raise NotTried(f"{PYODIDE} cannot be reached, so the site has no wheels for the browser")
    lock = json.loads((built / "lite/static/pyodide-lock/pyodide-lock.json").read_text("utf-8"))
    if not {"my_course", "my-course"} & set(lock["packages"]) or "misstep" not in lock["packages"]:
        raise Failure("The Python of the browser must have the wheels of the course and the engine.")


# --- what no path runs ---

NOT_REHEARSED = {
    "sudo ": "changes the machine; the line that installs the Hub is run without it",
    "cd /srv/hub": "changes the machine",
    "useradd": "changes the machine",
    "chmod": "changes the machine",
    "rm -rf": "changes the machine",
    "apt-get": "changes the machine",
    "python3 -m venv /opt/venv": "changes the machine; done in another folder",
    "podman": "needs a container engine; container.yml runs it",
    "docker": "needs a container engine; container.yml runs it",
    "${{ matrix.engine }}": "needs a container engine; container.yml runs it",
    "mkdir": "a preparation of container.yml",
    "cp ": "a preparation of container.yml",
    "grep ": "a check of a workflow",
    "kubectl": "needs a cluster",
    "helm": "needs a cluster",
    "npx lighthouse": "needs 185 MB and a person who reads the report",
    "npm ": "a test of the viewer runs it",
    "npm run": "a test of the viewer runs it",
    "python course.py test": "the whole suite; test.yml runs it on each system and Python",
    '"$python" course.py test': "the whole suite; .ci/run runs it",
    "nox -s ": "takes long or changes files; evidence.yml runs what proves something",
    ".venv/bin/python -m nox -s ": "takes long or changes files; evidence.yml runs what proves something",
    ".venv/bin/python -m mutmut": "shows one change of a mutation run",
    "python tools/fresh": "the rehearsal itself",
    "kincourse new-lecture": "adds a lecture; a test of kincourse does so",
    "misstep grade ": "the same program with files that a person has; graded with other files",
    "misstep census": "the census takes long; a new course runs one",
    "python evidence/checks/judge_outside.py": "judges for minutes; a test judges a third of each sheet",
    "misstep new-course": "run with a name",
    "misstep unnamed": "needs the results of a graded class; a test of misstep has some",
    ".venv/bin/misstep release": "the same program as `misstep release`",
    "python -m kincourse": "the same program as `kincourse`",
    "pip install pandas": "an example of a package of students",
    ".venv/bin/pip install pandas": "an example of a package of students",
    "pip install my_course": "a course that is published",
    ".venv/bin/python -m jupyterlab": "needs a person; another path opens JupyterLab",
    ".venv/bin/python -m http.server": "the standard library's server",
    ".venv/bin/python -m misstep grade": "run in the tests of the new course",
    ".venv/bin/python -m misstep new-problem": "a test of the guide of the engine runs it",
    ".venv/bin/python -m misstep check": "a test of the guide of the engine runs it",
    ".venv/bin/python -m misstep preview": "opens a page that a person reads; tests of misstep make it",
    "dask": "needs several machines",
    "pip install ./kinlib './misstep[grading,cluster]'": "needs several machines",
}
"""Commands of documents that no path runs, by how they begin, with the reason."""
