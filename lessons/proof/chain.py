"""The chain of a trace: it follows the events and derives the operands of each decision from the scene and from what was decided before.

A chain hears the events in order. For a decision it gives the operands by name, each a Number. It raises Contradiction if an event
cannot follow, and NotTold if the trace leaves out what the operands are derived from.
"""

from fractions import Fraction

import answers
from kernel import Number


class Contradiction(Exception):
    """What the trace claims is not so."""


class NotTold(Exception):
    """The trace does not tell enough to judge a claim."""


def expect(is_so, *what):
    if not is_so:
        raise Contradiction(" ".join(map(str, what)))


def exactly(compute):
    """The exact result; None where it is undefined, by a division by zero or from something undefined."""
    try:
        return compute()
    except (ZeroDivisionError, TypeError):
        return None


def named(name, place):
    return {name + ".x": place[0], name + ".y": place[1]}


def least(numbers):
    """The first of those that are least in use."""
    return min(numbers, key=lambda number: number.used)


def greatest(numbers):
    """The last of those that are greatest in use."""
    return max(reversed(numbers), key=lambda number: number.used)


class Polygon:
    """A polygon of the scene, where the edition puts it on the screen."""

    def __init__(self, chain, given):
        self.id, self.chain = given["id"], chain
        self.vertices = [chain.on_screen([float(each) for each in vertex]) for vertex in given["vertices"]]
        xs, ys = [v[0] for v in self.vertices], [v[1] for v in self.vertices]
        self.box = [least(xs), least(ys), greatest(xs), greatest(ys)]
        points = [tuple(number.exact for number in vertex) for vertex in self.vertices]
        if chain.has("x-w6"):
            points = points[:3]
        pairs = list(zip(points, points[1:] + points[:1]))
        # Newell's sum; for three points it is the cross product of two sides.
        self.normal = [sum(p[i] * q[k] - p[k] * q[i] for p, q in pairs) for i, k in ((1, 2), (2, 0), (0, 1))]
        self.origin = points[0]
        self.is_edge_on = self.normal[2] == 0

    def vertex(self, i):
        return self.vertices[i % len(self.vertices)]

    def depth(self, at):
        """The exact depth of the plane at a place of exact coordinates."""
        (a, b, c), (x, y, z) = self.normal, self.origin
        depth = exactly(lambda: z - (a * (at[0] - x) + b * (at[1] - y)) / c)
        return -depth if depth is not None and self.chain.has("depth-sign-reversed") else depth


class Window:
    """The operands that a window gives."""

    def __init__(self, kernel, window):
        x, y, width, height = map(float, window)
        self.kernel, self.sides = kernel, (x, y, x + width, y + height)
        self.corners = [self.point(i, j) for i in (x, x + width) for j in (y, y + height)]  # lb, lt, rb, rt
        self.centre = self.point(x + width / 2, y + height / 2)

    def point(self, x, y):
        return self.kernel.given(x), self.kernel.given(y)

    def operands(self, box):
        """Of a box and this window."""
        names = ("xmin", "ymin", "xmax", "ymax")
        sides = {f"window.{name}": constant(side) for name, side in zip(names, self.sides)}
        return {f"box.{name}": number for name, number in zip(names, box)} | sides


def constant(value):
    return Number(Fraction(value), Fraction(value))


class Chain:
    """What all chains share. A decision that no event reports may compare any two of the numbers in `pool`."""

    def __init__(self, header, kernel):
        self.kernel, self.edition, scene = kernel, header["edition"], header["scene"]
        self.defects = set(self.edition.removeprefix("printed:").split("+"))
        area = scene["window"]
        self.area = [area["x"], area["y"], area["x"] + area["width"], area["y"] + area["height"]]
        self.scene = scene
        self.pool = set()

    def has(self, deviation):
        is_defect = deviation.startswith("x-")
        is_printed = self.edition == "printed" and is_defect
        return is_printed or deviation in self.defects or (deviation == "x-w9" and self.edition == "one-list")

    def read_polygons(self):
        self.polygons = [Polygon(self, given) for given in self.scene["polygons"]]
        self.by_id = {polygon.id: polygon for polygon in self.polygons}

    def on_screen(self, vertex):
        x, y, z = map(self.kernel.given, vertex)
        if self.has("y-flipped"):
            height = self.kernel.given(self.area[1] + self.area[3])
            used = self.kernel.number(height.used) - self.kernel.number(y.used)
            y = Number(getattr(used, "value", used), height.exact - y.exact)
        return x, y, z

    def polygon(self, event):
        polygon = self.by_id.get(event["polygon"])
        expect(polygon is not None, "the scene has no polygon", event["polygon"])
        return polygon

    def expect_told(self, event, field, number):
        """The event tells the number in use."""
        told = event[field] if isinstance(field, str) else event[field[0]][field[1]]
        expect(self.kernel.tells(told, number), f"{field} is {told}, but {number.used} follows from the events before")

    def hear(self, event):
        """The operands of the event's decision, if it reports one."""
        rule = getattr(self, "hear_" + event["e"], None)
        return rule(event) if rule else None

    def operands_of(self, decision):
        """The possible operands of a decision that no event reports, heard after the last event. None: any numbers of the pool."""
        return None

    def answer_of(self, of, candidates):
        """The answer of a decision without operands, and whether its operands have drifted; None if the chain does not know."""
        return None

    def expect_known(self, of, operands):
        for name, used, exact in operands:
            is_known = any(number.difference(used, exact) is None for number in self.pool)
            expect(is_known, f"{name} = {used}, exactly {exact}, is no number of the scene or of what was computed from it")

    def row_operands(self, outline, row):
        vertices = {f"v{i}.{axis}": v[k] for i, v in enumerate(outline) for k, axis in enumerate("xy")}
        return vertices | ({} if row is None else {"row": constant(row)}) | self.columns_of_area(row is None)

    def columns_of_area(self, of_rows=False):
        return {"low": constant(self.area[1 if of_rows else 0]), "end": constant(self.area[3 if of_rows else 2])}

    def rows_in_use(self, outline):
        used = [(None, self.kernel.number(y.used)) for _, y in outline]
        heights = [y for _, y in used]
        return answers.between_centres(min(heights), max(heights), self.area[1], self.area[3], self.kernel.number)
