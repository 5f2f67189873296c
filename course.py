"""Open the course, test it, or build and serve its site: python course.py open. All of it is in tools/set_up.py.

This file is also valid for Python 2, so that an old Python can say what it lacks.
"""

import os
import sys

if sys.version_info < (3, 11):
    sys.exit(
        "The course needs Python 3.11 or newer; this is %s. Try: python3.13 course.py open" % sys.version.split()[0]
    )

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "tools"))
from set_up import main

if __name__ == "__main__":
    main(*sys.argv[1:])
