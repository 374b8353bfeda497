#!/usr/bin/env python3
"""Rebuilds the picture or the lines of a run from the events of its trace and compares them with the hash in the last line.

    picture.py TRACE...        .jsonl or .jsonl.gz

It is written from trace/FORMAT.md only, shares no code with the program, and uses only the events that paint or draw.
The exit status is 1 if a trace differs from its last line.
"""

import gzip
import hashlib
import json
import sys


class Wrong(Exception):
    """A trace that differs from its last line, or that FORMAT.md does not allow."""


class Number(str):
    """A number as the trace writes it."""


def read_json(line):
    return json.loads(line, parse_int=Number, parse_float=Number, parse_constant=refuse_constant)


def refuse_constant(name):
    raise Wrong(f"{name} is no JSON")


def expect(holds, what):
    if not holds:
        raise Wrong(what)


class Picture:
    """The picture that polygons paint."""

    result = "picture"

    def __init__(self, scene):
        self.x, self.y, self.width, self.height = (int(scene["window"][key]) for key in ("x", "y", "width", "height"))
        self.rows = [[colour_of(scene["background"])] * self.width for _ in range(self.height)]
        self.polygon_colour = None  # the colour of the Z-buffer's current polygon

    def take(self, event):
        name = event["e"]
        if name == "clear":
            for row in range(self.y, self.y + self.height):
                self.paint(row, self.x, self.x + self.width, event["color"])
        elif name == "fill":
            x, y, width, height = map(int, event["rect"])
            expect(width >= 0 and height >= 0, "a rectangle without size")
            for row in range(y, y + height):
                self.paint(row, x, x + width, event["color"])
        elif name in ("draw", "paint"):
            for row, first, end in event["runs"]:
                self.paint(int(row), int(first), int(end), event["color"])
        elif name == "polygon":
            self.polygon_colour = event["color"]
        elif name == "span":
            expect(self.polygon_colour, "a span of no polygon")
            for first, end in event["runs"]:
                self.paint(int(event["row"]), int(first), int(end), self.polygon_colour)

    def paint(self, row, first, end, colour):
        if first >= end:
            return
        expect(self.y <= row < self.y + self.height, f"row {row} is outside of the area")
        expect(self.x <= first and end <= self.x + self.width, f"columns {first} to {end} are outside of the area")
        self.rows[row - self.y][first - self.x : end - self.x] = [colour_of(colour)] * (end - first)

    def bytes(self):
        return b"".join(pixel for row in self.rows for pixel in row)


def colour_of(text):
    expect(len(text) == 7 and text[0] == "#", f"{text} is no colour")
    return bytes.fromhex(text[1:])


class Lines:
    """The lines that curves draw."""

    result = "lines"

    def __init__(self, scene):
        self.curves = len(scene["curves"])
        self.curve = None
        self.lines = []  # [curve, segment, from, its columns, to, its columns]

    def take(self, event):
        if event["e"] == "curve":
            self.curve = event["curve"]
            expect(0 <= int(self.curve) < self.curves, "a curve that is not there")
        elif event["e"] == "draw_line":
            expect(self.curve is not None, "a line of no curve")
            self.draw(
                self.curve, event["segment"], event["from"], event["fromColumns"], event["to"], event["toColumns"]
            )

    def draw(self, curve, segment, start, start_columns, end, end_columns):
        is_point = start_columns == end_columns
        if self.lines:
            last = self.lines[-1]
            if last[0] == curve and last[5] == start_columns:
                if last[3] == last[5]:
                    self.lines.pop()
                elif last[1] == segment:
                    last[4:] = end, end_columns
                    return
                elif is_point:
                    return
        self.lines.append([curve, segment, start, start_columns, end, end_columns])

    def bytes(self):
        return "".join(
            f"[{curve},{point(start)},{point(end)}]\n" for curve, _, start, _, end, _ in self.lines
        ).encode()


def point(values):
    """Writes a point as the events do: a fraction is a string."""
    return "[" + ",".join(v if isinstance(v, Number) else json.dumps(v) for v in values) + "]"


def check(lines):
    """Returns the number of events. Raises Wrong if the events of a trace differ from its last line."""
    lines = iter(lines)
    header = read_json(next(lines, "{}"))
    expect(header.get("format") == "vidno-trace/1", "not a trace")
    what = (Lines if header["method"] == "floating-horizon" else Picture)(header["scene"])
    events = 0
    for line in lines:
        told = read_json(line)
        if "e" not in told:
            expect(next(lines, None) is None, "there is more after the last line")
            check_end(told["end"], events, what)
            return events
        what.take(told)
        events += 1
    raise Wrong("the last line is missing")


def check_end(end, events, what):
    expect(int(end["events"]) == events, f"{events} events, and the last line says {end['events']}")
    if end.get("partial"):
        return
    found = "sha256:" + hashlib.sha256(what.bytes()).hexdigest()
    expect(found == end[what.result], f"the events paint {found}, and the last line says {end[what.result]}")


def lines_of(name):
    with (gzip.open if name.endswith(".gz") else open)(name, "rt", encoding="utf-8", newline="\n") as file:
        yield from file


def main(names):
    wrong = 0
    for name in names:
        try:
            check(lines_of(name))
        except (Wrong, KeyError, TypeError, ValueError, EOFError, OSError) as fault:
            wrong += 1
            print(f"{name}: {fault!r}", file=sys.stderr)
    print(f"{len(names)} traces, {wrong} are not what they say")
    return 1 if wrong else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
