"""The chain of the Z-buffer: the edges of a polygon, and their entries in AEL from row to row."""

import answers
from chain import constant, exactly, expect
from chain_show_line import Entry, ShowLineChain
from kernel import Number


class ZBufferChain(ShowLineChain):
    def __init__(self, header, kernel):
        super().__init__(header, kernel)
        self.read_polygons()
        self.rows_end = self.area[3] + self.has("x-z3")
        self.current = self.y = None
        self.vertices, self.edges, self.first_rows, self.active, self.order = [], {}, {}, {}, []

    def operands_of(self, decision):
        of = decision["of"]
        ys = [self.current.box[1], self.current.box[3]] if self.current else []
        ys += [end[1] for edge in self.edges.values() for end in edge] + [vertex[1] for vertex in self.vertices]
        if self.has("x-z1"):
            ys += [self.sum_of(y, self.kernel.given(0.5)) for y in list(ys)]
        if of in ("first_centre", "last_centre"):
            columns = constant(self.area[0]), constant(self.area[2])
            rows = constant(self.area[1]), constant(self.rows_end)
            at_end = [(constant(x), constant(self.area[2] + 1)) for x in range(self.area[0], self.area[2] + 2)]
            spans = [columns, *(at_end if self.has("x-z3") else [])]
            farthest = constant(-(2**30)), constant(2**30)
            at = [(end.x, span) for end in self.ends for span in spans]
            at += [(y, span) for y in ys for span in [rows, *([farthest] if self.has("x-z6") else [])]]
            return [{"x": number, "low": low, "end": end} for number, (low, end) in at]
        self.pool = {*ys, *self.compared, *(number for end in self.ends for number in (end.x, end.z))}
        self.pool |= {vertex[0] for polygon in self.polygons for vertex in polygon.vertices}
        self.pool |= {vertex[1] for polygon in self.polygons for vertex in polygon.vertices}
        self.pool |= {number for entry in self.active.values() for number in (entry.x, entry.dx)}
        self.pool |= {self.kernel.given(side) for side in self.area} | {constant(side) for side in self.area} | {constant(1)}
        self.pool |= {self.y, self.sum_of(self.y, constant(1))} if self.y else set()
        if len(self.ends) == 2:
            start = self.start()
            self.pool |= {start, self.difference(self.ends[1].x, start)}
        if self.next_column is not None and self.is_printed:
            self.pool |= {self.next_column, self.last_column, Number(None, self.last_z)}
        return None

    def hear_clear(self, event):
        self.expect_told(event, "z", self.first_depth)

    def hear_polygon(self, event):
        self.current = self.polygon(event)
        self.vertices, self.edges, self.active, self.order, self.ends = [], {}, {}, [], []
        if self.is_printed:
            self.vertices = list(self.current.vertices)
            self.y = None

    def hear_depth(self, event):
        x, y, _ = self.current.vertex(len(self.vertices))
        self.expect_told(event, ("point", 0), x)
        self.expect_told(event, ("point", 1), y)
        self.vertices.append((x, y, self.kernel.told(event["z"], self.current.depth([x.exact, y.exact]))))

    def hear_edge(self, event):
        """S: from the upper end to the lower one; a level edge goes from left to right."""
        i = event["edge"]
        expect(len(self.vertices) == len(self.current.vertices), "a vertex has no depth")
        expect(0 <= i < len(self.vertices) and i not in self.edges, "S has another edge")
        upper, lower = self.vertices[i], self.vertices[(i + 1) % len(self.vertices)]
        if self.is_printed:
            number = self.kernel.number
            is_level = answers.same_rounded(number(upper[1].used), number(lower[1].used), number)
        else:
            is_level = upper[1].used == lower[1].used
        k = 0 if is_level else 1
        if lower[k].used < upper[k].used:
            upper, lower = lower, upper
        for name, end in (("from", upper), ("to", lower)):
            for axis in range(3):
                self.expect_told(event, (name, axis), end[axis])
        self.edges[i] = upper, lower
        if not self.is_printed:
            self.rows_of(event, upper[1], lower[1])

    def rows_of(self, event, upper_y, lower_y):
        number, low, end = self.kernel.number, self.area[1], self.rows_end
        first = answers.first_centre(number(upper_y.used), low, end, number)
        if lower_y.used == self.current.box[3].used:
            last = answers.last_centre(number(lower_y.used), low, end, number)
        else:
            y = number(lower_y.used) + number(0.5) if self.has("x-z1") else number(lower_y.used)
            last = answers.first_centre(y, low, end, number) - 1
        expect(event["rows"] == [first, last], "the edge crosses the rows", first, "to", last)
        self.first_rows[event["edge"]] = first

    def scanline(self, row):
        if not self.has("x-z6"):
            return self.kernel.given(row + 0.5)
        y = self.current.box[1]
        number = self.kernel.number
        first = answers.first_centre(number(y.used), -(2**30), 2**30, number)
        return self.sum_of(y, self.kernel.given(row - first))

    def hear_scanline(self, event):
        self.row, self.pairs = event["row"], 0
        if self.is_printed:
            self.y = self.current.box[1] if self.y is None else self.sum_of(self.y, constant(1))
        else:
            self.y = self.scanline(self.row)
        self.expect_told(event, "y", self.y)

    def hear_ael_add(self, event):
        i = event["edge"]
        expect(i in self.edges and i not in self.active, "S has no such edge")
        (x1, y1, z1), (x2, y2, z2) = [[number.exact for number in end] for end in self.edges[i]]
        dx = exactly(lambda: (x2 - x1) / (y2 - y1))
        dz = exactly(lambda: (z2 - z1) / (y2 - y1))
        rows = 0 if self.is_printed else exactly(lambda: self.scanline(self.first_rows[i]).exact - y1)
        x = x1 if self.is_printed else exactly(lambda: x1 + rows * dx)
        z = z1 if self.is_printed else exactly(lambda: z1 + rows * dz)
        told = self.kernel.told
        self.active[i] = Entry(*(told(event[name], exact) for name, exact in (("x", x), ("z", z), ("dx", dx), ("dz", dz))))
        self.order.append(i)

    def hear_ael_sort(self, event):
        expect(sorted(event["edges"]) == sorted(self.order), "AEL has the entries", *self.order)
        self.order = event["edges"]

    def hear_ael_drop(self, event):
        for i in event["edges"]:
            expect(i in self.active, "AEL has no entry of edge", i)
            del self.active[i]
            self.order.remove(i)

    def hear_ael_step(self, event):
        i = event["edge"]
        expect(i in self.active, "AEL has no entry of edge", i)
        entry = self.active[i]
        entry.x = self.kernel.told(event["x"], exactly(lambda: entry.x.exact + entry.dx.exact))
        entry.z = self.kernel.told(event["z"], exactly(lambda: entry.z.exact + entry.dz.exact))
