"""Run a lecture in a JupyterLab that is already open, as a browser does: `run_lecture.py 127.0.0.1:8888 TOKEN NOTEBOOK`.

The environment of the lab runs this, so that it needs nothing which the lab does not bring along.
"""

import json
import re
import sys
import urllib.request
import uuid

import websocket

FRONT_ENDS = ("@jupyter-widgets/jupyterlab-manager", "anywidget")
"""What JupyterLab loads in the browser to show sliders and the viewer."""


def main(address: str, token: str, notebook: str) -> None:
    def ask(path: str, data: object = None) -> str:
        request = urllib.request.Request(f"http://{address}/{path}", headers={"Authorization": f"token {token}"})
        request.data = json.dumps(data).encode() if data else None
        with urllib.request.urlopen(request, timeout=120) as answer:
            return answer.read().decode()

    page = ask(f"lab/tree/{notebook}")
    settings = json.loads(re.search(r'id="jupyter-config-data"[^>]*>(.*?)</script>', page, re.DOTALL)[1])
    loaded = {extension["name"] for extension in settings["federated_extensions"]}
    if missing := set(FRONT_ENDS) - loaded:
        sys.exit(f"JupyterLab must load {sorted(missing)}; it loads {sorted(loaded)}.")

    cells = json.loads(ask(f"api/contents/{notebook}"))["content"]["cells"]
    code = [cell["source"] for cell in cells if cell["cell_type"] == "code"]
    kernel = {"name": "python3"}
    session = json.loads(
        ask("api/sessions", {"path": notebook, "name": notebook, "type": "notebook", "kernel": kernel})
    )
    channel = f"ws://{address}/api/kernels/{session['kernel']['id']}/channels?token={token}"
    kernel = websocket.create_connection(channel, timeout=120)
    for source in code:
        execute(kernel, source)
    print(f"{len(code)} cells of {notebook} have run.")


def execute(kernel: websocket.WebSocket, source: str) -> None:
    """Run one cell, and wait until it has ended. Ends the program if the cell raises an error."""
    number = uuid.uuid4().hex
    header = {"msg_id": number, "msg_type": "execute_request", "username": "", "session": "fresh", "version": "5.3"}
    message = {"header": header, "parent_header": {}, "metadata": {}, "channel": "shell", "buffers": []}
    kernel.send(json.dumps({**message, "content": {"code": source, "silent": False, "allow_stdin": False}}))
    while True:
        answer = kernel.recv()
        answer = json.loads(answer) if isinstance(answer, str) else {"parent_header": {}}
        if answer["parent_header"].get("msg_id") != number:
            continue
        if answer["msg_type"] == "error":
            sys.exit(f"{source}\n{answer['content']['ename']}: {answer['content']['evalue']}")
        if answer["msg_type"] == "status" and answer["content"]["execution_state"] == "idle":
            return


if __name__ == "__main__":
    main(*sys.argv[1:])
