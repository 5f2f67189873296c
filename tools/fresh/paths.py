"""The paths: for each set of commands that documents give, a new environment with what they install, and what must come of it."""

import json
import re
import shutil
import urllib.request
from collections.abc import Callable
from pathlib import Path

from fresh_copy import Failure, NotTried, Place, free_port

LECTURE = "notebooks/00_start_here.ipynb"
SHEET = "solutions/03_poe_space/03_poe_space.ipynb"
PYODIDE = "cdn.jsdelivr.net"
CHROMIUM = ("chromium", "chromium-browser", "google-chrome")
FRONT_ENDS = ("@jupyter-widgets/jupyterlab-manager", "anywidget")
"""What JupyterLab loads in the browser to show sliders and the viewer."""

PATHS: dict[str, Callable[[Place], None]] = {}


def path(function: Callable[[Place], None]) -> Callable[[Place], None]:
    """Register a path by its name. The commands of documents that it runs stand in it as they stand there."""
    PATHS[function.__name__] = function
    return function


def rehearse(name: str, python: Path) -> tuple[str, str]:
    """Run a path on a Python. Returns the result, and the reason if it did not pass."""
    place = Place(python)
    try:
        PATHS[name](place)
    except NotTried as reason:
        return "not tried", str(reason)
    except (Failure, OSError) as error:
        return "FAILED", str(error)
    finally:
        place.remove()
    return "passed", ""


# --- a student ---


@path
def lab(place: Place) -> None:
    """JupyterLab opens, loads what shows sliders and the viewer, and runs lecture 00."""
    run_lecture(place, "python course.py open", "--no-browser --LabApp.open_browser=False")


@path
def binder(place: Place) -> None:
    """The same with what Binder installs; its builder runs pip in the folder of the file."""
    place.run("python -m venv .venv")
    place.run("pip install -r .binder/requirements.txt", replace={"pip": ".venv/bin/python -m pip"})
    run_lecture(place, ".venv/bin/python -m jupyter lab", "--no-browser --allow-root")


def run_lecture(place: Place, command: str, options: str) -> None:
    address = f"127.0.0.1:{free_port()}"
    options += f" --ServerApp.port={address.split(':')[1]} --ServerApp.port_retries=0 --IdentityProvider.token=fresh"
    with place.started(command, address, also=f"{options} --allow-root"):
        urllib.request.urlopen(f"http://{address}/lab/tree/{LECTURE}?token=fresh", timeout=120).close()
    listed = place.run(".venv/bin/python -m jupyter labextension list")
    if missing := [name for name in FRONT_ENDS if not re.search(rf"{name} v\S+ .*enabled.*OK", listed)]:
        raise Failure(f"JupyterLab must load {missing}:\n{listed}")
    place.run(f".venv/bin/python -m jupyter execute {LECTURE}")


# --- a reader of the site ---


@path
def site(place: Place) -> None:
    """The site and its lab are built, complete, and served; after the PDF is printed, they are complete for publication."""
    place.run("python course.py site", KINLIB_LAB="offline")
    place.run(".venv/bin/python site/check.py")
    port = free_port()
    with place.started("python course.py serve", f"127.0.0.1:{port}", also=str(port)):
        for page in ("index.html", "lectures/00_start_here.html", "lab/notebooks/index.html"):
            with urllib.request.urlopen(f"http://127.0.0.1:{port}/{page}", timeout=30) as answer:
                if b"</html>" not in answer.read():
                    raise Failure(f"{page} is not complete.")
    if not any(map(shutil.which, CHROMIUM)):
        raise NotTried("there is no Chromium on the path to print the PDF; all else passed")
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


@path
def empty_lab(place: Place) -> None:
    """The group `site` alone resolves, and builds a lab with a single notebook: what JupyterLite loads is there."""
    place.run(f"python -c '{PREPARE}'")
    (place.folder / "empty_lab.py").write_text(EMPTY_LAB, "utf-8")
    place.run(".venv/bin/python empty_lab.py", KINLIB_LAB="offline", PYTHONPATH="site")
    if not (place.folder / "build/lab/offline/html/files" / LECTURE).is_file():
        raise Failure(f"The lab must contain {LECTURE}.")


PREPARE = 'import sys; sys.path.insert(0, "tools"); import set_up; set_up.prepare("site", newest=False)'


# --- a contributor ---


@path
def quick_tests(place: Place) -> None:
    """The quick tests pass, and so do the checks that run no code."""
    place.run("python course.py test --quick")
    place.run(".venv/bin/python -m nox --list")
    place.run(".venv/bin/python -m nox -s format")
    place.run(".venv/bin/python -m nox -s lint")


@path
def release(place: Place) -> None:
    """The wheels are built and checked, and the documents of the packages are true of them, as in release.yml."""
    place.run("python -m venv builder")
    place.run("python -m pip install -c constraints.txt nox", replace={"python": "builder/bin/python"})
    place.run("python -m nox -s distributions", replace={"python": "builder/bin/python"})
    place.run("python -m venv tried")
    place.run("python -m pip install dist/*.whl", replace={"python": "tried/bin/python"})
    course, checkout = place.folder, place.enter("empty") / "checkout"
    checkout.symlink_to(course)
    place.run(
        'for package in kinlib misstep kincourse; do python -m doctest "checkout/$package/README.md"; done',
        replace={"python": f"{course}/tried/bin/python"},
    )


# --- an instructor ---


@path
def grade(place: Place) -> None:
    """What the instructor's guide installs grades a sheet, with and without a gradebook, and makes sheets."""
    place.run("python -m venv .venv")
    place.run(".venv/bin/pip install ./kinlib './misstep[grading,release]' ./kincourse")
    activate = "source .venv/bin/activate"
    place.run("misstep release", replace={"misstep": f"{activate} && misstep"})
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


@path
def hub(place: Place) -> None:
    """What the page on Hubs installs has a Hub that reads its configuration, and a server for a student."""
    place.run("python -m venv .venv")
    place.run(
        "sudo /opt/hub/bin/pip install -c constraints.txt -r deploy/hub.txt ./kinlib './misstep[grading]' ./kincourse",
        replace={"sudo /opt/hub/bin/pip": ".venv/bin/pip"},
    )
    shown = place.run(".venv/bin/jupyterhub -f deploy/jupyterhub_config.py --show-config")
    if "jupyterhub-singleuser" not in shown:
        raise Failure(f"The configuration must name the program of a student's server:\n{shown}")
    place.run(".venv/bin/jupyterhub-singleuser --version")
    run_lecture(place, ".venv/bin/python -m jupyter lab", "--no-browser")


@path
def container(place: Place) -> None:
    """What the container installs grades a sheet; its engine is another matter."""
    place.run("python -m venv .venv")
    place.run(
        "/opt/venv/bin/pip install --no-cache-dir -c /opt/course/constraints.txt -r /opt/course/hub.txt"
        " /opt/course/kinlib '/opt/course/misstep[grading,release]' /opt/course/kincourse",
        replace={"/opt/venv/bin/pip": ".venv/bin/pip", "/opt/course/hub.txt": "deploy/hub.txt", "/opt/course/": "./"},
    )
    place.run('python -c "import matplotlib.pyplot"', replace={"python": ".venv/bin/python"})
    (place.folder / "submissions" / "your id").mkdir(parents=True)
    shutil.copy(place.folder / SHEET, place.folder / "submissions" / "your id")
    place.run(f".venv/bin/misstep grade {SHEET} submissions --out results")
