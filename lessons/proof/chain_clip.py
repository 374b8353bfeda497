"""The chain through PolygonClip and FillPolygon: vertices clipped at the sides of a window, and the rows that an outline meets."""

import answers
from chain import Chain, exactly, expect, named


class ClipChain(Chain):
    def __init__(self, header, kernel):
        super().__init__(header, kernel)
        self.outline, self.clipped, self.rows, self.runs = [], [], [], []

    # PolygonClip

    def hear_clip_begin(self, event):
        self.clipped = [vertex[:2] for vertex in self.polygon(event).vertices]

    def hear_clip_side(self, event):
        lb, lt, rb, rt = self.window.corners
        corners = [lb, lt, rt, rb]
        if self.has("clip-order-reversed"):
            corners.reverse()
        self.pivot, self.before = corners[event["side"] - 1], corners[event["side"] - 2]
        for name, place in (("from", self.before), ("to", self.pivot)):
            for i in (0, 1):
                self.expect_told(event, (name, i), place[i])
        self.signs, self.kept, self.crossed, self.judged = [], [], False, True

    def hear_clip_sign(self, event):
        i = len(self.signs) - 1  # the last vertex of the list comes first
        expect((event["at"] == "PL3") == (i == -1) and i < len(self.clipped) and self.judged, "a sign of another vertex was expected")
        vertex = self.clipped[i]
        for k in (0, 1):
            self.expect_told(event, ("vertex", k), vertex[k])
        self.signs.append(event["sign"])
        self.judged, self.crossed = i == -1, False
        return named("pivot", self.pivot) | named("a", vertex) | named("b", self.before)

    def ends(self):
        """The last two vertices that got a sign."""
        i = len(self.signs) - 2
        return self.clipped[i - 1], self.clipped[i]

    def hear_clip_cross(self, event):
        """The edge meets the line of the side."""
        p, q = [tuple(number.exact for number in place) for place in self.ends()]
        pivot, before = [tuple(number.exact for number in place) for place in (self.pivot, self.before)]
        cp, cq = [exactly(lambda v=v: answers.turn(pivot, v, before)) for v in (p, q)]
        exact = [exactly(lambda k=k: p[k] + (q[k] - p[k]) * cp / (cp - cq)) for k in (0, 1)]
        self.kept.append([self.kernel.told(event["vertex"][k], exact[k]) for k in (0, 1)])
        self.crossed = True

    def end_vertex(self, keeps):
        expect(not self.judged, "a vertex needs a sign")
        expect(keeps == (self.signs[-1] != 1), "the sign decides whether the vertex stays")
        opposite = self.signs[-2] * self.signs[-1] < 0
        expect(self.crossed == opposite or self.has("x-w7"), "the signs of both ends decide whether an edge crosses the side")
        self.judged = True

    def hear_clip_keep(self, event):
        self.end_vertex(True)
        self.kept.append(self.ends()[1])

    def hear_clip_drop(self, event):
        self.end_vertex(False)

    def hear_clip_list(self, event):
        expect(len(self.signs) == len(self.clipped) + 1 and self.judged, "a vertex has no sign")
        expect(event["count"] == len(self.kept), "the new list has", len(self.kept), "vertices")
        self.clipped = self.kept

    def hear_clip_result(self, event):
        expect(len(event["vertices"]) == len(self.clipped), "the list has", len(self.clipped), "vertices")

    # FillPolygon

    def begin_fill(self, outline):
        self.outline, self.runs = outline, []
        self.rows = list(range(*self.rows_in_use(outline))) if outline else []

    def hear_row(self, event):
        expect(self.rows and event["row"] == self.rows.pop(0), "another row was expected")
        if event["first"] < event["end"]:
            self.runs.append([event["row"], event["first"], event["end"]])
        return self.row_operands(self.outline, event["row"])

    def hear_draw(self, event):
        expect(not self.rows, "the outline also has row", *self.rows[:1])
        expect(event["runs"] == self.runs, "the rows give other runs")
