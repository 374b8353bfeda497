"""The chain through ShowLine: the columns of a line, and the depth of each of its pixels."""

import answers
from chain import Chain, constant, exactly, expect
from kernel import FARTHEST, Number


class Entry:
    """An edge in AEL: where it is on the scanline, and by how much this changes."""

    def __init__(self, x, z, dx, dz):
        self.x, self.z, self.dx, self.dz = x, z, dx, dz


class ShowLineChain(Chain):
    def __init__(self, header, kernel):
        super().__init__(header, kernel)
        # With all of its defects the Z-buffer is the printed text, in which y is a number and not a row.
        self.is_printed = all(self.has(f"x-z{i}") for i in range(1, 8))
        start = kernel.given(-1) if self.has("x-z7") else kernel.given(0) if self.has("depths-not-cleared") else FARTHEST
        self.first_depth, self.stored = start, {}
        self.ends, self.compared, self.level_edge = [], [], None
        self.end = self.next_column = None

    def computed(self, number):
        return getattr(number, "value", number)

    def sum_of(self, a, b):
        """a + b as the run adds them, and exactly."""
        used = self.kernel.number(a.used) + self.kernel.number(b.used)
        return Number(self.computed(used), exactly(lambda: a.exact + b.exact))

    def difference(self, a, b):
        used = self.kernel.number(a.used) - self.kernel.number(b.used)
        return Number(self.computed(used), exactly(lambda: a.exact - b.exact))

    def answer_of(self, of, candidates):
        (n,) = candidates
        numbers = {name: self.kernel.number(number.used) for name, number in n.items()}
        if of == "nearer":  # x-z7: the last of equally near ones shows
            z, against = numbers["z"], numbers["against"]
            if self.is_printed and self.kernel.name == "depth" and z.value == 1:
                return None  # a depth greater than 1 does not show, and is stored as 1
            shown = z >= against and not (self.is_printed and z > self.kernel.number(1))
            return shown, any(number.used != number.exact for number in n.values())
        found = self.columns_in_use(numbers["left"], numbers["right"])
        return found, any(number.used != number.exact for number in n.values())

    def columns_in_use(self, left, right):
        """The columns of a line where the edition does not take the centres from one end to the other."""
        number, (low, _, end, _) = self.kernel.number, self.area
        if self.has("x-z5"):
            x = self.kernel.number(self.start().used)
            first = answers.pixel(x)
            past = first if right < x else first + answers.pixel(right - x) + 1
            return [first, max(first, min(past, end))]
        first, past = answers.between_centres(left, right, low, end, number)
        if self.has("boundary-outside"):
            if number(self.row + 0.5) in (number(self.current.box[1].used), number(self.current.box[3].used)):
                return [first, first]
            first += first < past and number(first + 0.5) == left
            past -= first < past and number(past - 0.5) == right
        return [first, past]

    def hear_horizontal(self, event):
        self.level_edge = event["edge"]

    def hear_call(self, event):
        if event["of"] != "ShowLine":
            return
        if event["at"] == "Z9":
            self.ends = [Entry(end[0], end[2], None, None) for end in self.edges[self.level_edge]]
        else:
            pair = self.order[2 * self.pairs : 2 * self.pairs + 2]
            expect(len(pair) == 2, "AEL has no further pair")
            self.ends = [Entry(self.active[i].x, self.active[i].z, None, None) for i in pair]
            self.pairs += 1
        self.end, self.shown, self.next_column = None, [], None

    def hear_line(self, event):
        for name, end in zip(("from", "to"), self.ends):
            self.expect_told(event, (name, 0), end.x)
            self.expect_told(event, (name, 1), end.z)
        self.next_column = None

    def start(self):
        """Where a line starts under x-z5: at its left end, or at that of the area."""
        return max(self.ends[0].x, self.kernel.given(self.area[0]), key=lambda number: number.used)

    def slope(self):
        """The change of the depth from column to column; a line that is one point in use has none."""
        left, right = self.ends
        if left.x.used == right.x.used and not self.has("x-z4"):
            return self.kernel.given(0).exact
        return exactly(lambda: (right.z.exact - left.z.exact) / (right.x.exact - left.x.exact))

    def hear_slope(self, event):
        self.dz = self.kernel.told(event["dz"], self.slope())
        if not self.is_printed:
            return
        left_end = constant(self.area[0])
        x, z = self.ends[0].x, self.ends[0].z.exact
        if x.used < left_end.used:
            z = exactly(lambda: z + (left_end.exact - x.exact) * self.dz.exact)
            x = left_end
        self.next_column = self.last_column = x
        self.z = self.last_z = z

    def hear_columns(self, event):
        left, right = self.ends
        first, self.end = event["first"], event["end"]
        start = self.start() if self.has("x-z5") else self.kernel.given(first + 0.5)
        self.z = exactly(lambda: left.z.exact + (start.exact - left.x.exact) * self.dz.exact)
        self.next_column = first
        return {"left": left.x, "right": right.x} | self.columns_of_area()

    def advance(self):
        self.last_column, self.last_z = self.next_column, self.z
        if self.is_printed:
            self.next_column = self.sum_of(self.next_column, constant(1))
        else:
            self.next_column += 1
        self.z = exactly(lambda: self.z + self.dz.exact)

    def hear_pixel(self, event):
        expect(self.next_column is not None, "a pixel without a line")
        at = event["x"], event["y"]
        x = answers.pixel(self.next_column.used) if self.is_printed else self.next_column
        row = answers.pixel(self.y.used) if self.is_printed else self.row
        expect(at == (x, row) and (self.end is None or x < self.end), "another pixel was expected:", x, row)
        z, against = self.kernel.told(event["z"], self.z), self.stored.get(at, self.first_depth)
        self.expect_told(event, "stored", against)
        if event["shown"]:
            self.stored[at] = z
            self.shown.append((event["x"], event["z"]))
        self.compared = [z, against]
        self.advance()
        return {"z": z, "against": against}

    def hear_fault(self, event):
        if self.is_printed and "x" in event and self.next_column is not None:
            self.advance()

    def hear_span(self, event):
        columns = [x for first, end in event["runs"] for x in range(first, end)]
        is_whole = self.is_printed or self.end is None or self.next_column >= self.end
        expect(is_whole, "the line has a pixel in column", self.next_column)
        expect(columns == [x for x, _ in self.shown], "the pixels give other runs")
        depths = event.get("depths", [])
        expect(depths == [z for _, z in self.shown], "the pixels have other depths")
        self.end = None
