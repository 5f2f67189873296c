"""A JupyterHub for a class on one machine; site/pages/hub.md says how to install and run it.

Each student has an account of the system, and a server that runs under it.
"""

import os
import sys
from pathlib import Path
from urllib.parse import urlencode

c = get_config()  # noqa: F821 - JupyterHub defines get_config when it reads this file

SHEETS = os.environ.get("COURSE_SHEETS", "file:///srv/sheets")
"""The address of the git repository with the sheets that are released."""

MAX_DATA_BYTES = 2 * 1024**3
"""How much memory each process of a student may write to. A cell that needs more gets a MemoryError."""

IDLE_S = 3600
"""After so many seconds without use, a kernel ends, and then its server; the files stay."""

c.JupyterHub.bind_url = "http://127.0.0.1:8000"  # a web server with a certificate passes https on to it
c.Authenticator.allow_all = True  # everybody with an account and a password
c.Authenticator.admin_users = set(filter(None, os.environ.get("COURSE_ADMINS", "").split(",")))

programs = Path(sys.executable).parent
c.ConfigurableHTTPProxy.command = str(programs / "configurable-http-proxy")
c.Spawner.cmd = ["prlimit", f"--data={MAX_DATA_BYTES}", str(programs / "jupyterhub-singleuser")]
c.Spawner.args = [
    f"--MappingKernelManager.cull_idle_timeout={IDLE_S}",
    f"--ServerApp.shutdown_no_activity_timeout={IDLE_S}",
]
# Every start fetches the sheets that are new, and keeps what the student has written.
c.Spawner.default_url = "/git-pull?" + urlencode(
    {"repo": SHEETS, "branch": "main", "targetPath": "sheets", "urlpath": "lab/tree/sheets"}
)
c.Spawner.start_timeout = c.Spawner.http_timeout = 120
# Many students arrive in the same minute: more than so many starts at once would only make each of them slower.
c.JupyterHub.concurrent_spawn_limit = 4 * (os.cpu_count() or 1)
