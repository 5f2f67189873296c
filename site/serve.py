"""Serve the site that was built on this machine, to this machine only: `python course.py serve`."""

import sys
from functools import partial
from http import HTTPStatus
from http.server import SimpleHTTPRequestHandler, ThreadingHTTPServer
from pathlib import Path

BUILT = Path(__file__).resolve().parents[1] / "build" / "site" / "html"
PORT = 8000


class Pages(SimpleHTTPRequestHandler):
    """Files, and the site's own page where there is none, as GitHub Pages shows it."""

    def send_error(self, code: int, message: str | None = None, explain: str | None = None) -> None:
        """Show the page for addresses that do not exist."""
        missing = Path(self.directory) / "404.html"
        if code != HTTPStatus.NOT_FOUND or not missing.exists():
            return super().send_error(code, message, explain)
        self.send_response(code)
        self.send_header("Content-Type", "text/html; charset=utf-8")
        self.end_headers()
        if self.command != "HEAD":
            self.wfile.write(missing.read_bytes())
        return None

    def log_message(self, *_: object) -> None:
        """Stay quiet."""


def serve(folder: Path, port: int) -> ThreadingHTTPServer:
    """A server of a folder on the loopback interface; port 0 takes any that is free."""
    return ThreadingHTTPServer(("127.0.0.1", port), partial(Pages, directory=str(folder)))


if __name__ == "__main__":
    if not (BUILT / "index.html").exists():
        sys.exit("The site is not built yet. Try: python course.py site")
    port = int(sys.argv[1]) if len(sys.argv) > 1 else PORT
    try:
        with serve(BUILT, port) as server:
            print(f"The course is at http://127.0.0.1:{server.server_address[1]}/ until you press Ctrl-C.", flush=True)
            server.serve_forever()
    except OSError as error:
        sys.exit(f"Port {port} is not free ({error}). Try another one: python course.py serve {port + 1}")
    except KeyboardInterrupt:
        print()
