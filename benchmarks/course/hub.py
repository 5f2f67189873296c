"""A class on one JupyterHub: memory and time for each student, and what is lost when a student's server is killed.

Each of 30 simulated students starts a server, gets the notebooks by nbgitpuller, runs lecture 03 and moves its viewer, solves
sheet 03 and saves it. The server of every third student is killed in the middle of the sheet, and started again. Then all sheets
are collected and graded. The students speak to the Hub as a browser does, but the time of a browser itself is not in the numbers.

    python -m benchmarks hub                 30 students
    python -m benchmarks hub --quick         2 students

The Hub is the one of deploy/jupyterhub_config.py, with simulated accounts. It runs in an environment of its own, whose folder is
the value of KINLIB_HUB; site/pages/hub.md says how to make it. Memory is the proportional set size (PSS): a page that several
processes share counts once.
"""

import asyncio
import csv
import json
import os
import secrets
import signal
import socket
import subprocess
import sys
import tempfile
import time
from collections.abc import Iterator, Sequence
from contextlib import contextmanager, suppress
from dataclasses import dataclass, field
from pathlib import Path
from statistics import median
from urllib.parse import quote, urlencode
from uuid import uuid4

from submissions import handed_in, mistaken, right
from tornado.httpclient import AsyncHTTPClient, HTTPRequest
from tornado.websocket import websocket_connect

from benchmarks.measure import MissingRequirementError, Row

ROOT = Path(__file__).parents[2]
DEPLOY = ROOT / "deploy"
LECTURE, SHEET = "notebooks/03_poe_space.ipynb", "exercises/03_poe_space/03_poe_space.ipynb"

STUDENTS, ARRIVAL_S = 30, 10.0
"""The size of the class, and how many seconds after the one before each student arrives."""

TIMEOUT_S = 600
"""How long to wait for any answer; on a busy machine, 30 servers take their time."""

MAX_MEMORY_MB, MAX_FIRST_RESULT_S, MAX_VIEWER_S, MAX_PROCESSOR_S = 500.0, 60.0, 1.0, 60.0
"""Targets: memory, time from the start to the first result, time of the viewer, and processor time of a student."""

CONFIG = """
import os
load_subconfig({deploy!r})
c.JupyterHub.spawner_class = "simple"
c.SimpleLocalProcessSpawner.home_dir_template = {homes!r}
c.JupyterHub.authenticator_class = "dummy"
c.JupyterHub.bind_url = "http://127.0.0.1:{ports[0]}"
c.JupyterHub.hub_port = {ports[1]}
c.ConfigurableHTTPProxy.api_url = "http://127.0.0.1:{ports[2]}"
c.Spawner.start_timeout = c.Spawner.http_timeout = {timeout}
c.JupyterHub.services = [{{"name": "class", "api_token": {token!r}}}]
scopes = ["admin:users", "admin:servers", "access:servers"]
c.JupyterHub.load_roles = [{{"name": "class", "scopes": scopes, "services": ["class"]}}]
if os.getuid() == 0:
    c.Spawner.args += ["--allow-root"]
"""


@dataclass
class Student:
    """A student of the class: what she does, and what is measured meanwhile."""

    name: str
    lines: dict[int, str]
    hub: "Hub"
    first_result_s: float = 0.0
    start_processor_s: float = 0.0
    viewer_s: float = 0.0
    again_s: float = 0.0
    processor_s: float = 0.0
    failed_starts: int = 0
    lost: int = 0
    score: float = -1.0
    memory: dict[str, list[float]] = field(default_factory=dict)

    async def study(self, delay: float, is_killed: bool) -> None:
        """Do everything: the lecture, the sheet, and in between lose the server if it is to be killed."""
        await asyncio.sleep(delay)
        begun = time.perf_counter()
        await self.hub.request("POST", f"/hub/api/users/{self.name}")
        await self.start()
        query = urlencode({"repo": self.hub.sheets, "branch": "main", "targetpath": "sheets"})
        pulled = await self.request("GET", f"/git-pull/api?{query}")
        if '"finished"' not in pulled:
            raise RuntimeError(f"nbgitpuller answered: {pulled[-500:]}")
        lecture = await self.read(LECTURE)
        first, *others = [cell for cell in lecture["cells"] if cell["cell_type"] == "code"]
        kernel = await self.open(LECTURE)
        await kernel.run(first)
        self.first_result_s = time.perf_counter() - begun
        self.start_processor_s = sum(map(processor_seconds, self.processes()))
        for cell in others:
            await kernel.run(cell)
        self.viewer_s = await kernel.move_viewer()
        kernel.close()
        await self.solve(is_killed)

    async def solve(self, is_killed: bool) -> None:
        """Solve the first half of the sheet, save it, lose the server, and solve the other half in what was saved."""
        sheet = handed_in(self.name, self.lines)
        sheet["cells"] = [cell for cell in sheet["cells"] if cell["id"] != "own"]
        kernel = await self.open(SHEET)
        half = len(sheet["cells"]) // 2
        await kernel.run_all(sheet["cells"][:half])
        await self.save(sheet)
        if is_killed:
            kernel.close()
            self.processor_s += sum(map(processor_seconds, self.processes()))
            begun = time.perf_counter()
            while servers := [process for process in self.processes() if is_server(process)]:
                os.kill(int(servers[0].name), signal.SIGKILL)
                await asyncio.sleep(0.1)
            await self.start()
            saved = await self.read(SHEET)
            self.lost = sum(a["source"] != b["source"] for a, b in zip(saved["cells"], sheet["cells"], strict=True))
            sheet = saved
            kernel = await self.open(SHEET)
            self.again_s = time.perf_counter() - begun
            await kernel.run_all(sheet["cells"][:half])
        await kernel.run_all(sheet["cells"][half:])
        self.score = float(await kernel.value("print(sheet.tally().score)"))
        await self.save(sheet)
        kernel.close()

    async def start(self) -> None:
        """Start the server, and wait until it answers. If the Hub is too busy to start it, ask again, as a student does.

        Raises RuntimeError if it does not start.
        """
        for _ in range(TIMEOUT_S):
            # The Hub looks whether a server that it knows still lives: it is refused only if it does, or is about to start.
            response = await self.hub.fetch("POST", f"/hub/api/users/{self.name}/server")
            self.failed_starts += response.code >= 500
            user = {"pending": "spawn", "server": None}
            while user["pending"]:
                await asyncio.sleep(0.5)
                user = json.loads(await self.hub.request("GET", f"/hub/api/users/{self.name}"))
            if user["server"]:
                return
        raise RuntimeError(f"the server of {self.name} did not start")

    async def request(self, method: str, path: str, data: object = None) -> str:
        """Send a request to the student's server."""
        return await self.hub.request(method, f"/user/{self.name}{path}", data)

    async def read(self, path: str) -> dict:
        """Read a notebook from the server."""
        return json.loads(await self.request("GET", f"/api/contents/sheets/{path}?type=notebook"))["content"]

    async def save(self, sheet: dict) -> None:
        """Save the sheet on the server."""
        data = {"type": "notebook", "format": "json", "content": sheet}
        await self.request("PUT", f"/api/contents/sheets/{SHEET}", data)

    async def open(self, path: str) -> "Kernel":
        """Start a kernel for a notebook, as JupyterLab does when it opens one."""
        data = {"path": f"sheets/{path}", "name": path, "type": "notebook", "kernel": {"name": "python3"}}
        session = json.loads(await self.request("POST", "/api/sessions", data))
        address = f"/user/{self.name}/api/kernels/{session['kernel']['id']}/channels"
        return Kernel(await self.hub.websocket(address))

    def processes(self) -> list[Path]:
        """List the folders in /proc of this student's processes."""
        home = f"HOME={self.hub.homes / self.name}\0".encode()
        found = []
        for folder in Path("/proc").glob("[0-9]*"):
            with suppress(OSError):
                if home in (folder / "environ").read_bytes():
                    found.append(folder)
        return found

    def measure(self) -> None:
        """Measure the memory of each process, in MB, and the processor time of all."""
        for process in self.processes():
            kind = "server" if is_server(process) else "kernel"
            self.memory.setdefault(kind, []).append(memory_mb(process))
            self.processor_s += processor_seconds(process)


class Kernel:
    """A connection to a kernel through the websocket of the student's server."""

    def __init__(self, connection) -> None:
        self.connection, self.session, self.viewers = connection, uuid4().hex, []

    async def run_all(self, cells: Sequence[dict]) -> None:
        """Run code cells one after the other."""
        for cell in cells:
            if cell["cell_type"] == "code":
                await self.run(cell)

    async def run(self, cell: dict) -> None:
        """Run a cell, and put its outputs into it.

        Raises RuntimeError if it fails.
        """
        cell["outputs"] = []
        async for kind, content in self.send("execute_request", code="".join(cell["source"]), silent=False):
            if kind == "comm_open" and "scene" in content["data"].get("state", {}):
                self.viewers.append((content["comm_id"], content["data"]["state"]["q"]))
            if kind == "error":
                raise RuntimeError(f"{content['ename']}: {content['evalue']} in {''.join(cell['source'])[:80]!r}")
            if kind in {"stream", "display_data", "execute_result"}:
                content.pop("transient", None)
                cell["outputs"].append({"output_type": kind, **content})

    async def value(self, code: str) -> str:
        """Run code, and return what it prints."""
        cell = {"source": code}
        await self.run(cell)
        return "".join(output["text"] for output in cell["outputs"])

    async def move_viewer(self) -> float:
        """Move the first joint of the last viewer, as its slider does. Returns the seconds until the kernel has the new value.

        Raises RuntimeError if the kernel does not confirm the value.
        """
        viewer, q = self.viewers[-1]
        state = {"q": [0.5, *q[1:]]}
        begun = time.perf_counter()
        data = {"method": "update", "state": state, "buffer_paths": []}
        updates = [content async for kind, content in self.send("comm_msg", comm_id=viewer, data=data)]
        seconds = time.perf_counter() - begun
        if not any(update.get("data", {}).get("state", {}).get("q") == state["q"] for update in updates):
            raise RuntimeError(f"the viewer did not take {state}")
        return seconds

    async def send(self, kind: str, **content):
        """Send a message, and yield the kinds and contents of the answers until the kernel is idle again."""
        header = {"msg_id": uuid4().hex, "msg_type": kind, "username": "", "session": self.session, "version": "5.3"}
        message = {"header": header, "parent_header": {}, "metadata": {}, "content": content, "channel": "shell"}
        await self.connection.write_message(json.dumps(message))
        while True:
            text = await asyncio.wait_for(self.connection.read_message(), TIMEOUT_S)
            if text is None:
                raise RuntimeError("the server closed the connection to its kernel")
            answer = json.loads(text)
            if answer.get("parent_header", {}).get("msg_id") != header["msg_id"]:
                continue
            yield answer["msg_type"], answer["content"]
            if answer["msg_type"] == "status" and answer["content"]["execution_state"] == "idle":
                return

    def close(self) -> None:
        """Close the connection. The kernel goes on, as when a student closes the tab."""
        self.connection.close()


@dataclass(frozen=True)
class Hub:
    """A running JupyterHub, and the token with which everything is allowed."""

    address: str
    token: str
    homes: Path
    sheets: str
    process: int

    async def fetch(self, method: str, path: str, data: object = None):
        """Send a request, and return the response, whatever its status."""
        body = json.dumps(data) if data is not None else "" if method in {"POST", "PUT"} else None
        request = HTTPRequest(
            f"{self.address}{path}", method, self.headers, body, connect_timeout=TIMEOUT_S, request_timeout=TIMEOUT_S
        )
        return await AsyncHTTPClient().fetch(request, raise_error=False)

    async def request(self, method: str, path: str, data: object = None) -> str:
        """Send a request, and return the body of the response.

        Raises RuntimeError if the status is an error.
        """
        response = await self.fetch(method, path, data)
        if response.error:
            raise RuntimeError(f"{method} {path}: {response.code} {(response.body or b'').decode()[:300]}")
        return response.body.decode()

    async def websocket(self, path: str):
        """Open a websocket."""
        request = HTTPRequest(
            f"{self.address.replace('http', 'ws', 1)}{path}", headers=self.headers, connect_timeout=TIMEOUT_S
        )
        return await websocket_connect(request, max_message_size=100_000_000)

    @property
    def headers(self) -> dict[str, str]:
        """The header that names the token."""
        return {"Authorization": f"token {self.token}"}


def rows(quick: bool = False) -> Iterator[Row]:
    """Yield the rows of the table of all benchmarks.

    Raises MissingRequirementError if KINLIB_HUB names no environment with JupyterHub.
    """
    students, overhead, differing = run(2 if quick else STUDENTS)
    count, killed = len(students), [student for student in students if student.again_s]
    whole = [student for student in students if not student.again_s]
    server, kernel = ([mb for one in students for mb in one.memory[kind]] for kind in ("server", "kernel"))
    first = [student.first_result_s for student in students]
    values = {
        "memory of a student": (
            median(sum(map(sum, student.memory.values())) for student in whole),
            "MB",
            MAX_MEMORY_MB,
        ),
        "memory of a server": (median(server), "MB", MAX_MEMORY_MB),
        "memory of a kernel": (median(kernel), "MB", MAX_MEMORY_MB),
        "memory of the Hub and its proxy": (overhead, "MB", MAX_MEMORY_MB),
        "start to first result, median": (median(first), "s", MAX_FIRST_RESULT_S),
        "start to first result, worst": (max(first), "s", MAX_FIRST_RESULT_S),
        "viewer moved to kernel informed, median": (
            median(student.viewer_s for student in students),
            "s",
            MAX_VIEWER_S,
        ),
        "processor time to first result": (
            median(student.start_processor_s for student in students),
            "s",
            MAX_PROCESSOR_S,
        ),
        "processor time of a student": (median(student.processor_s for student in whole), "s", MAX_PROCESSOR_S),
        f"starts that failed at first, {count} students": (sum(one.failed_starts for one in students), "starts", 0),
        f"cells lost, {len(killed)} servers killed": (sum(student.lost for student in killed), "cells", 0),
        "killed to open again, median": (median(student.again_s for student in killed), "s", MAX_FIRST_RESULT_S),
        f"grades that students did not see, {count} sheets": (differing, "sheets", 0),
    }
    for name, (value, unit, target) in values.items():
        yield Row(name, unit, value, target, at_most=True)


def run(count: int) -> tuple[list[Student], float, int]:
    """Let a class work. Returns the students, the memory of the Hub and its proxy in MB, and how many grades differ."""
    with tempfile.TemporaryDirectory() as name, hub(Path(name)) as running:
        students = []
        for number in range(count):
            student = f"student{number:02}"
            answers = mistaken if number % 2 else right
            students.append(Student(student, answers(student), running))
        asyncio.run(study_together(students))
        for student in students:
            student.measure()
        overhead = sum(map(memory_mb, below(running.process)))
        return students, overhead, grade(students, Path(name))


async def study_together(students: Sequence[Student]) -> None:
    """Let all students study at the same time; each arrives a little after the one before."""
    AsyncHTTPClient.configure(None, max_clients=10 * len(students), max_body_size=100_000_000)
    async with asyncio.TaskGroup() as group:
        for number, student in enumerate(students):
            group.create_task(student.study(ARRIVAL_S * number, is_killed=number % 3 == 1))


def grade(students: Sequence[Student], folder: Path) -> int:
    """Collect the sheets as an instructor does, grade them, and count those with another score than the student saw."""
    homes, submissions, results = (folder / name for name in ("homes", "submissions", "results"))
    solution = ROOT / "solutions" / "03_poe_space" / "03_poe_space.ipynb"
    for words in (
        [DEPLOY / "collect.py", homes, f"sheets/{SHEET}", submissions],
        ["-m", "misstep", "grade", solution, submissions, "--out", results],
    ):
        subprocess.run([sys.executable, *map(str, words)], check=True, cwd=ROOT, stdout=sys.stderr)
    with (results / "grades.csv").open(encoding="utf-8", newline="") as file:
        points = {row["student"]: float(row["points"]) for row in csv.DictReader(file)}
    return sum(points.get(student.name) != student.score for student in students)


@contextmanager
def hub(folder: Path) -> Iterator[Hub]:
    """Start a JupyterHub with a repository of sheets.

    Raises MissingRequirementError if KINLIB_HUB names no environment with JupyterHub.
    """
    programs = Path(os.environ.get("KINLIB_HUB", "")) / "bin"
    if not (programs / "jupyterhub").is_file() or not (programs / "configurable-http-proxy").is_file():
        raise MissingRequirementError("KINLIB_HUB must name an environment with JupyterHub, see site/pages/hub.md")
    ports, token = free_ports(3), secrets.token_hex()
    (folder / "homes").mkdir()
    sheets = repository(folder / "released")
    config = folder / "config.py"
    config.write_text(
        CONFIG.format(
            deploy=str(DEPLOY / "jupyterhub_config.py"),
            homes=f"{folder}/homes/{{username}}",
            ports=ports,
            token=token,
            timeout=TIMEOUT_S,
        )
    )
    environment = {**os.environ, "PATH": f"{programs}:{os.environ['PATH']}", "COURSE_SHEETS": sheets}
    with (folder / "log").open("wb") as log:
        process = subprocess.Popen(
            [programs / "jupyterhub", "-f", config], cwd=folder, env=environment, stdout=log, stderr=log
        )
    running = Hub(f"http://127.0.0.1:{ports[0]}", token, folder / "homes", sheets, process.pid)
    try:
        asyncio.run(wait_for(running))
        yield running
    except BaseException:
        print((folder / "log").read_text("utf-8", "replace")[-3000:], file=sys.stderr)
        raise
    finally:
        process.terminate()
        with suppress(subprocess.TimeoutExpired):
            process.wait(60)


async def wait_for(running: Hub) -> None:
    """Wait until the Hub answers.

    Raises RuntimeError if it does not.
    """
    for _ in range(TIMEOUT_S):
        with suppress(OSError):
            if (await running.fetch("GET", "/hub/api/")).code == 200:
                return
        await asyncio.sleep(0.5)
    raise RuntimeError("the Hub does not answer")


def repository(folder: Path) -> str:
    """Make a git repository of the lecture and the sheet, as an instructor does. Returns its address."""
    for path in (LECTURE, SHEET):
        (folder / path).parent.mkdir(parents=True, exist_ok=True)
        (folder / path).write_bytes((ROOT / path).read_bytes())
    person = ["-c", "user.name=instructor", "-c", "user.email=instructor@example.org"]
    for words in (["init", "--initial-branch", "main"], ["add", "."], [*person, "commit", "--message", "Sheet 03"]):
        subprocess.run(["git", *words], cwd=folder, check=True, stdout=subprocess.DEVNULL)  # noqa: S607 - git has no fixed path
    return f"file://{quote(str(folder))}"


def free_ports(count: int) -> list[int]:
    """Find ports on which nothing listens."""
    listening = [socket.create_server(("127.0.0.1", 0)) for _ in range(count)]
    ports = [one.getsockname()[1] for one in listening]
    for one in listening:
        one.close()
    return ports


def memory_mb(process: Path) -> float:
    """The proportional set size of a process, in MB."""
    lines = (process / "smaps_rollup").read_text().splitlines()
    return next(int(line.split()[1]) for line in lines if line.startswith("Pss:")) * 1024 / 1e6


def is_server(process: Path) -> bool:
    """Whether a process is the server of a student; the others are kernels."""
    return b"jupyterhub-singleuser" in (process / "cmdline").read_bytes()


def processor_seconds(process: Path) -> float:
    """The processor time of a process and of its children that have ended, in seconds."""
    fields = (process / "stat").read_text().rpartition(")")[2].split()
    return sum(map(int, fields[11:15])) / os.sysconf("SC_CLK_TCK")


def below(process: int) -> list[Path]:
    """List the folders in /proc of the Hub and of its proxy."""
    folder = Path(f"/proc/{process}")
    children = (folder / "task" / str(process) / "children").read_text().split()
    proxies = [Path(f"/proc/{child}") for child in children]
    return [folder, *(one for one in proxies if b"configurable-http-proxy" in (one / "cmdline").read_bytes())]
