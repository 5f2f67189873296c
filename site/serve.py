"""Serve the built site to this machine only: `python course.py serve`."""

import sys
from functools import partial
from http import HTTPStatus
from http.server import SimpleHTTPRequestHandler, ThreadingHTTPServer
from pathlib import Path

BUILT = Path(__file__).resolve().parents[1] / "build" / "site" / "html"
PORT = 8000


class PageHandler(SimpleHTTPRequestHandler):
    """Serves files, and 404.html for an address that does not exist, as GitHub Pages does."""

    def send_error(self, code: int, message: str | None = None, explain: str | None = None) -> None:
        """Send 404.html for an address that does not exist."""
        not_found = Path(self.directory) / "404.html"
        if code != HTTPStatus.NOT_FOUND or not not_found.exists():
            return super().send_error(code, message, explain)
        self.send_response(code)
        self.send_header("Content-Type", "text/html; charset=utf-8")
        self.end_headers()
        if self.command != "HEAD":
            self.wfile.write(not_found.read_bytes())
        return None

    def log_message(self, *_: object) -> None:
        """Write no log of the requests."""


def serve(folder: Path, port: int) -> ThreadingHTTPServer:
    """Create a server of a folder on the loopback interface; port 0 means any free port."""
    return ThreadingHTTPServer(("127.0.0.1", port), partial(PageHandler, directory=str(folder)))


if __name__ == "__main__":
    if not (BUILT / "index.html").exists():
        sys.exit("The site is not built yet. Try: python course.py site")
    port = int(sys.argv[1]) if len(sys.argv) > 1 else PORT
    try:
        with serve(BUILT, port) as server:
            print(f"The course is at http://127.0.0.1:{server.server_address[1]}/ until you press Ctrl-C.", flush=True)
            server.serve_forever()
    except OSError as error:
        sys.exit(f"Port {port} is in use ({error}). Try another one: python course.py serve {port + 1}")
    except KeyboardInterrupt:
        print()
