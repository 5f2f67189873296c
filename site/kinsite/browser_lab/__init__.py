"""The lab in the browser: JupyterLite, Pyodide, and the wheels of the course."""
