"""Widgets: the 3-D viewer, its modes, and a slider through pictures.

scene.py says what an arm is, as data; the JavaScript in kinlib/view/js draws it. Each mode has a Python and a JavaScript side:

assignment_player.py  js/modes/assignment-steps.js
dh_row_player.py      js/modes/dh-row.js
linkage_driver.py     js/modes/configuration-curve.js
moving_frames.py      js/modes/moving-frames.js
place_frames.py       js/modes/place-frames.js
"""
