"""What pip is told about certificates, indexes and proxies, in the words of uv, which reads nothing of pip's."""

import ast
import os
import re
import ssl
import subprocess
import sys
from collections.abc import Mapping
from pathlib import Path

UV_NAMES = {
    "index-url": "UV_DEFAULT_INDEX",
    "extra-index-url": "UV_INDEX",
    "trusted-host": "UV_INSECURE_HOST",
    "timeout": "UV_HTTP_TIMEOUT",
    "default-timeout": "UV_HTTP_TIMEOUT",
    "client-cert": "SSL_CLIENT_CERT",
}
"""Options of pip whose values mean the same in a variable of uv."""

SECTIONS = ("global", "install", ":env:")
"""Where pip finds a setting: two sections of its files, and the variables PIP_...; a later one wins."""


def read_pip_settings() -> dict[str, str]:
    """Return the settings of pip by the names of its options, from all its files and variables."""
    command = (sys.executable, "-m", "pip", "config", "list")
    listed = subprocess.run(command, capture_output=True, text=True, errors="replace", check=False).stdout
    found = re.findall(r"^(global|install|:env:)\.([\w-]+)=(.+)$", listed, re.MULTILINE)
    return {name: ast.literal_eval(value) for _, name, value in sorted(found, key=lambda row: SECTIONS.index(row[0]))}


def is_offline(pip: Mapping[str, str]) -> bool:
    """Whether pip may ask no index, but only the folders of find-links. uv has an option for it, and no variable."""
    return pip.get("no-index", "").lower() in ("1", "true", "yes", "on")


def variables(pip: Mapping[str, str]) -> dict[str, str]:
    """Return the variables that make uv use the certificates, indexes and proxy of pip. Those that are set already stay."""
    settings = {uv_name: " ".join(pip[name].split()) for name, uv_name in UV_NAMES.items() if name in pip}
    if "find-links" in pip:  # pip ignores a folder that does not exist, uv refuses it
        places = map(os.path.expanduser, pip["find-links"].split())
        settings["UV_FIND_LINKS"] = ",".join(place for place in places if "://" in place or Path(place).exists())
    if "extra-index-url" in pip:
        settings["UV_INDEX_STRATEGY"] = "unsafe-best-match"  # as pip does: the best version of all indexes
    if "proxy" in pip:
        settings |= dict.fromkeys(("HTTP_PROXY", "HTTPS_PROXY"), pip["proxy"])
    if "cert" in pip:
        cert = Path(pip["cert"]).expanduser()
        settings["SSL_CERT_DIR" if cert.is_dir() else "SSL_CERT_FILE"] = str(cert)
    elif os.name == "nt" or sys.platform == "darwin" or any(ssl.get_default_verify_paths()[:2]):
        settings["UV_SYSTEM_CERTS"] = "1"  # as pip does; by itself, uv knows only the certificates that it brings along
    return {name: value for name, value in settings.items() if name not in os.environ}
