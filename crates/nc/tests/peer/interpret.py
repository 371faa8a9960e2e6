"""Runs a program through LinuxCNC's own interpreter (module `gcode`) and prints what it makes of it.

    interpret.py PROGRAM PARAMETERS        one line per event, mm and deg, with all digits
    interpret.py --time PROGRAM PARAMETERS only the seconds that the interpreter took
"""

import sys
import time

import gcode

MM = 25.4


class Silent:
    """Takes the canonical calls and does nothing."""

    def __init__(self, parameters):
        self.parameter_file = parameters
        self.lines = []

    def ignore(self, *_):
        pass

    next_line = straight_feed = straight_traverse = arc_feed = set_feed_rate = dwell = comment = ignore
    set_plane = set_g5x_offset = set_g92_offset = set_xy_rotation = tool_offset = change_tool = ignore

    def get_tool(self, _pocket):
        return (-1,) + (0.0,) * 12 + (0,)

    def get_axis_mask(self):
        return 0x1FF

    def get_block_delete(self):
        return False

    def get_external_length_units(self):
        return 1.0

    def get_external_angular_units(self):
        return 1.0

    def check_abort(self):
        return False

    def __getattr__(self, name):
        if name.startswith("_"):
            raise AttributeError(name)
        return self.ignore


class Canon(Silent):
    """Keeps the events; lengths come in inch."""

    def event(self, name, *values):
        self.lines.append(" ".join([name] + [repr(value) for value in values]))

    def place(self, name, x, y, z, a, b, c, u, v, w):
        self.event(name, x * MM, y * MM, z * MM, a, b, c, u * MM, v * MM, w * MM)

    def straight_feed(self, *place):
        self.place("feed", *place)

    def straight_traverse(self, *place):
        self.place("rapid", *place)

    def set_feed_rate(self, feed):
        self.event("rate", feed * MM)

    def dwell(self, seconds):
        self.event("dwell", seconds)

    def comment(self, text):
        if not text.startswith("interpreter:"):
            self.event("comment", text)


def main():
    arguments = sys.argv[1:]
    timed = arguments[0] == "--time"
    program, parameters = arguments[-2:]
    canon = (Silent if timed else Canon)(parameters)
    start = time.perf_counter()
    result, line = gcode.parse(program, canon, "G21", "")
    seconds = time.perf_counter() - start
    if result > gcode.MIN_ERROR:
        sys.exit(f"line {line}: {gcode.strerror(result)}")
    print(seconds if timed else "\n".join(canon.lines))


main()
