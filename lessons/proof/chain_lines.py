"""The lines of a scene, and the points where these meet.

A trace does not name the two lines on which a vertex of a region lies. They are among the edges of the polygons, the sides of the area,
and the lines in which two planes meet. A vertex is derived if two of these meet there.
"""

import collections
import math
from fractions import Fraction

from chain import Chain, NotTold, exactly
from kernel import Number

MOST_LINES = 300


def line_through(px, py, qx, qy):
    return py - qy, qx - px, px, py


def line_of_planes(pa, pb, pc, pd, qa, qb, qc, qd, x, y):
    """The line where two planes meet, through its point nearest to x, y."""
    a, b = qa / qc - pa / pc, qb / qc - pb / pc
    t = (-(pa * x + pb * y + pd) / pc - -(qa * x + qb * y + qd) / qc) / (a * a + b * b)
    return a, b, x - a * t, y - b * t


def meet(a, b, x, y, c, d, u, v):
    height = c * (x - u) + d * (y - v)
    divisor = a * d - b * c
    return x + b * height / divisor, y - a * height / divisor


def on_row(a, b, x, y, row):
    return (x - b * (row - y) / a,)


def middle(px, py, qx, qy, two):
    return (px + qx) / two, (py + qy) / two


class LinesChain(Chain):
    def __init__(self, header, kernel):
        super().__init__(header, kernel)
        self.read_polygons()
        self.planes, self.met_rows = {}, {}
        self.known_lines = self.known_meets = self.known_coordinates = None

    def hear_plane(self, event):
        polygon = self.polygon(event)
        if polygon.is_edge_on:
            return
        (a, b, c), (x, y, z) = polygon.normal, polygon.origin
        exact = a, b, c, -(a * x + b * y + c * z)
        self.known_lines, self.known_meets, self.known_coordinates, self.met_rows = None, None, None, {}
        self.planes[polygon.id] = [self.kernel.told(told, each) for told, each in zip(event["plane"], exact)]

    def both(self, formula, *numbers):
        """The results of a formula, in use and exactly. None if there is no exact one and the run is exact."""
        exact = exactly(lambda: formula(*[number.exact for number in numbers]))
        if self.kernel.is_always_right:
            return [Number(each, each) for each in exact] if exact else None
        used = formula(*[self.kernel.number(number.used) for number in numbers])
        return [Number(u.value, e) for u, e in zip(used, exact or [None] * len(used))]

    def is_near(self, told, number):
        """Can the trace tell this of the number? filtered tells a double near it."""
        if self.kernel.name != "filtered":
            return self.kernel.tells(told, number)
        return number.exact is not None and abs(number.exact - Fraction(told)) <= Fraction(1, 2**40) * max(1, abs(number.exact))

    def lines(self):
        """a, b, x, y of each line a (u - x) + b (v - y) = 0."""
        if self.known_lines is not None:
            return self.known_lines
        x1, y1, x2, y2 = map(self.kernel.given, self.area)
        outlines = [polygon.vertices for polygon in self.polygons] + [[(x1, y1), (x2, y1), (x2, y2), (x1, y2)]]
        ends = {tuple(sorted((p[:2], q[:2]), key=lambda at: (at[0].used, at[1].used)))
                for outline in outlines for p, q in zip(outline, outline[1:] + outline[:1])}  # fmt: skip
        found = [self.both(line_through, *p, *q) for p, q in ends]
        planes = [polygon for polygon in self.polygons if polygon.id in self.planes]
        if len(found) + len(planes) * (len(planes) - 1) // 2 > MOST_LINES:
            raise NotTold(f"the scene has more than {MOST_LINES} lines to try")
        for i, later in enumerate(planes):
            for earlier in planes[:i]:
                operands = *self.planes[later.id], *self.planes[earlier.id], *later.vertices[0][:2]
                line = self.both(line_of_planes, *operands)
                found += [line] if line else []
        self.known_lines = found
        return found

    def meets(self):
        """The points where two lines meet: by exact coordinates, those in use."""
        if self.known_meets is None:
            self.known_meets = collections.defaultdict(set)
            for line in self.lines():
                for other in self.lines():
                    point = None if line is other else self.both(meet, *line, *other)
                    if point and None not in (point[0].exact, point[1].exact):
                        self.known_meets[point[0].exact, point[1].exact].add((point[0].used, point[1].used))
            for polygon in self.polygons:
                for x, y, _ in polygon.vertices:
                    self.known_meets[x.exact, y.exact].add((x.used, y.used))
            self.by_use, self.by_cell = collections.defaultdict(set), collections.defaultdict(list)
            for exact, uses in self.known_meets.items():
                self.by_cell[cell_of(exact)].append(exact)
                for used in uses:
                    self.by_use[used].add(exact)
        return self.known_meets

    def coordinates_met(self):
        """The x and the y of these points, each by its exact value, with those in use."""
        if self.known_coordinates is None:
            self.known_coordinates = collections.defaultdict(set), collections.defaultdict(set)
            for at, places in self.meets().items():
                for i, uses in enumerate(self.known_coordinates):
                    uses[at[i]] |= {place[i] for place in places}
        return self.known_coordinates

    def on_rows(self, row):
        """Where lines meet the line of a row's centres."""
        if row not in self.met_rows:
            centre = self.kernel.given(row + 0.5)
            met = [self.both(on_row, *line, centre) for line in self.lines()]
            self.met_rows[row] = {each[0] for each in met if each}
        return self.met_rows[row]

    def vertices_told(self, point):
        """The vertices that the trace may mean by a point."""
        self.meets()
        if self.kernel.is_exact:
            return [point_of(point)] if point_of(point) in self.known_meets else []
        if self.kernel.is_always_right:
            x, y = cell_of(point)
            around = [at for i in (-1, 0, 1) for j in (-1, 0, 1) for at in self.by_cell[x + i, y + j]]
            return [at for at in around if all(self.is_near(point[i], Number(None, at[i])) for i in (0, 1))]
        return list(self.by_use[tuple(map(float, point))])


def cell_of(point):
    return tuple(math.floor(each * 2**16) for each in point)


def point_of(point):
    return tuple(map(Fraction, point))
