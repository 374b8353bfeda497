"""The chain of Weiler and Atherton's algorithm: rows that regions meet, depths at their vertices, and the points between these."""

import itertools
import math
from fractions import Fraction

import answers
from chain import NotTold, constant, expect
from chain_lines import LinesChain, middle
from kernel import Number, parsed

MOST_CHOICES = 64
MANY_POINTS = "on which lines a point lies, where several points are rounded to one"


class WeilerAthertonChain(LinesChain):
    def __init__(self, header, kernel):
        super().__init__(header, kernel)
        self.coordinates = {number for polygon in self.polygons for vertex in polygon.vertices for number in vertex[:2]}
        self.regions, self.depths, self.row = [], [], None

    def answer_of(self, of, candidates):
        """The columns of a row under filtered and exact, if all numbers that may be meant give the same."""
        if of != "columns" or isinstance(candidates, NotTold):
            return None
        low, end = self.area[0], self.area[2]
        found = [answers.between_centres(n["left"].exact, n["right"].exact, low, end, Fraction) for n in candidates]
        return (found[0], False) if all(each == found[0] for each in found) else None

    # Events

    def hear_clipped(self, event):
        self.regions.append(event["inside"])

    def hear_pop_list(self, event):
        self.regions = []

    def hear_depth(self, event):
        polygon = self.polygon(event)
        if event["at"] == "DS1":
            places = self.vertices_told(event["point"]) if self.is_small() else []
        else:
            places = self.means_told(event) if self.is_small() else []
        self.depths = self.depths[-64:] if event["at"] == "DS1" else self.depths[-1:]
        self.depths.append([self.kernel.told(event["z"], polygon.depth(place)) for place in places])

    def is_small(self):
        try:
            return bool(self.lines())
        except NotTold:
            return False

    def means_told(self, event):
        """The means of the vertices of a region that the trace may mean by a point."""
        means = set()
        for region in self.regions:
            told = [point for loop in region for point in loop]
            places = [self.vertices_told(point) for point in told]
            if not told or not self.kernel.is_always_right and not self.has_mean_in_use(told, event["point"]):
                continue
            if math.prod(map(len, places)) > MOST_CHOICES or not all(places):
                return []
            for choice in itertools.product(*places):
                mean = tuple(sum(place[i] for place in choice) / len(choice) for i in (0, 1))
                if not self.kernel.is_always_right or all(self.is_near(event["point"][i], Number(mean[i], mean[i])) for i in (0, 1)):
                    means.add(mean)
        return list(means)

    def has_mean_in_use(self, points, mean):
        for i in (0, 1):
            total = self.kernel.number(0)
            for point in points:
                total = total + self.kernel.number(float(point[i]))
            if (total / self.kernel.number(len(points))).value != float(mean[i]):
                return False
        return True

    def hear_behind(self, event):
        self.lines()
        z, clip_z = self.depths[-2:]
        if not z or not clip_z:
            raise NotTold(MANY_POINTS)
        found = [{"a": a, "b": b} for a, b in zip(z, clip_z)]
        exact = [text and parsed(text) for _, _, text in event.get("operands", [])]
        if self.kernel.name == "bits" and exact not in [[n["a"].exact, n["b"].exact] for n in found]:
            raise NotTold(MANY_POINTS)
        return found

    def hear_order(self, event):
        """At a pixel's centre, in the row that was met last."""
        y = Fraction(self.row) + Fraction(1, 2)
        centres = [self.kernel.given(x + 0.5) for x in range(self.area[0], self.area[2])]
        xs = [x for x in centres if self.kernel.tells(event["point"][0], x)]
        expect(xs, "the point is no pixel's centre")
        expect(self.kernel.tells(event["point"][1], self.kernel.given(self.row + 0.5)), "the point is in another row")
        polygon, other = self.polygon(event), self.by_id[event["other"]]
        told = self.kernel.told
        self.depths = [[told(event["z"], polygon.depth([x.exact, y])) for x in xs],
                       [told(event["otherZ"], other.depth([x.exact, y])) for x in xs]]  # fmt: skip
        return [{"a": a, "b": b} for a, b in zip(*self.depths)]

    def hear_row(self, event):
        self.row = event["row"]
        met = self.on_rows(self.row)
        ends = [[number for number in met if self.is_near(event[name], number)] for name in ("left", "right")]
        for name, found in zip(("left", "right"), ends):
            expect(found, "no line of the scene meets the row at", name)
        return [{"left": a, "right": b} | self.columns_of_area() for a in ends[0] for b in ends[1]]

    # Decisions that no event reports

    def expect_known(self, of, operands):
        n = {name: (used, exact) for name, used, exact in operands}
        if "line.a" in n:
            given = [n[name] for name in ("line.a", "line.b", "line.x", "line.y")]
            known = any(all(self.is_same(number, each) for number, each in zip(line, given)) for line in self.lines())
            expect(known, "the line is neither an edge, nor a side of the area, nor one in which two planes meet")
        for name in ("p", "q", "pivot", "a", "b"):
            if name + ".x" in n:
                self.expect_point(name, n[name + ".x"], n[name + ".y"])
        if of == "parallel":
            return self.expect_parallels(n)
        for name in ("a", "b", "x"):
            if name in n:
                self.expect_number(name, n[name])
        if of in ("first_centre", "last_centre"):
            ends = {name: constant(each) for name, each in zip(("low", "end"), (self.area[0], self.area[2]))}
            expect(all(self.is_same(ends[name], n[name]) for name in ends), "low and end are those of the area")

    def expect_parallels(self, n):
        """Two planes of polygons, or two lines."""
        known, axes = (self.planes.values(), "abcd") if "p.c" in n else (self.lines(), "ab")
        for name in "pq":
            is_known = any(all(map(self.is_same, each, [n[f"{name}.{axis}"] for axis in axes])) for each in known)
            expect(is_known, f"{name} is neither a plane of a polygon nor a line of the scene")

    @staticmethod
    def is_same(number, operand):
        used, exact = operand
        return parsed(exact) == number.exact and (number.used is None or parsed(used) == number.used or used == "nan")

    def expect_point(self, name, x, y):
        if x[1] is None or y[1] is None:
            raise NotTold("the point is undefined")
        exact, used = (Fraction(x[1]), Fraction(y[1])), (parsed(x[0]), parsed(y[0]))
        meets = self.meets()
        if used in meets.get(exact, ()):
            return
        for at in list(meets):  # the middle of a piece
            other = 2 * exact[0] - at[0], 2 * exact[1] - at[1]
            for p in meets[at] if other in meets else ():
                for q in meets[other]:
                    ends = Number(p[0], at[0]), Number(p[1], at[1]), Number(q[0], other[0]), Number(q[1], other[1])
                    between = self.both(middle, *ends, self.kernel.given(2))
                    if (between[0].used, between[1].used) == used:
                        return
        centres = [self.kernel.given(math.floor(each) + 0.5) for each in exact]
        is_centre = all(map(self.is_same, centres, (x, y)))
        if not is_centre and not self.kernel.is_always_right:
            raise NotTold(MANY_POINTS)
        expect(is_centre, f"{name} is no point where two lines meet, and in no middle of two")

    def is_coordinate(self, used, exact):
        """Of a point where lines meet, or of the middle of two."""
        for uses in self.coordinates_met():
            if used in uses.get(exact, ()):
                return True
            for p in uses:
                q = 2 * exact - p
                if q in uses and (self.kernel.is_always_right or used in self.middles_in_use(uses[p], uses[q])):
                    return True
        return False

    def middles_in_use(self, ps, qs):
        zero, two = self.kernel.given(0), self.kernel.given(2)
        return {self.both(middle, Number(p, None), zero, Number(q, None), zero, two)[0].used for p in ps for q in qs}

    def expect_number(self, name, operand):
        """A coordinate of a point, a depth, or where a line meets a row."""
        if operand[1] is None:
            raise NotTold("the number is undefined")
        used, exact = parsed(operand[0]), parsed(operand[1])
        if any(self.is_same(each, operand) for each in self.coordinates):
            return
        if any(self.is_same(each, operand) for depths in self.depths for each in depths):
            return
        if self.row is not None and any(self.is_same(each, operand) for each in self.on_rows(self.row)):
            return
        rows = range(self.area[1], self.area[3])
        if any(self.is_same(self.kernel.given(row + 0.5), operand) for row in rows):
            return
        for row in rows:
            if any(self.is_same(each, operand) for each in self.on_rows(row)):
                return
        if self.is_coordinate(used, exact):
            return
        planes_c = [plane[2] for plane in self.planes.values()] + [constant(0)]
        if any(self.is_same(each, operand) for each in planes_c):
            return
        raise NotTold("of which point or depth the number is")
