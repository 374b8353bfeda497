"""The chain of the floating horizon: heights of a curve over columns, and the horizons that these have raised."""

from fractions import Fraction

from chain import Chain, expect
from kernel import Number


class FloatingHorizonChain(Chain):
    def __init__(self, header, kernel):
        super().__init__(header, kernel)
        self.curves = self.scene["curves"]
        columns = range(self.area[0], self.area[2])
        start = [kernel.given(self.area[3]), kernel.given(self.area[1])] if self.has("x-h3") else [None, None]
        self.horizons = {name: dict.fromkeys(columns, at) for name, at in zip(("upper", "lower"), start)}
        self.before, self.reached, self.segment = self.horizons, {"FH3": None, "FH10": None}, None
        self.changed, self.in_visibility = {"upper": [], "lower": []}, False

    def number(self, used, exact):
        """Under filtered the trace has a double near the exact height."""
        return Number(None if self.kernel.name == "filtered" else used, exact)

    def sample(self, column):
        y = next((y for x, y in self.curves[self.curve] if x == column), None)
        expect(y is not None, "the curve has no sample at column", column)
        return column, float(y)

    def height(self, segment, column):
        """Over a column of a segment: at its ends a sample's, else on the line between them."""
        (x1, y1), (x2, y2) = segment
        if column in (x1, x2):
            given = self.kernel.given(y1 if column == x1 else y2)
            return self.number(given.used, given.exact)
        exact = Fraction(y1) + (Fraction(y2) - Fraction(y1)) * Fraction(column - x1, x2 - x1)
        of = self.kernel.number
        used = (of(y2) - of(y1)) / of(x2 - x1) * of(column - x1) + of(y1)
        return self.number(getattr(used, "value", used), exact)

    def operands_of(self, decision):
        self.pool = {each for horizon in (*self.horizons.values(), *self.before.values()) for each in horizon.values()}
        if self.segment:
            low, high = sorted(x for x, _ in self.segment)
            self.pool |= {self.height(self.segment, x) for x in range(low, high + 1)}
        self.pool.discard(None)

    def pieces(self):
        pieces = [[]]
        for x, y in self.curves[self.curve]:
            if y is None:
                pieces.append([])
            else:
                pieces[-1].append((x, float(y)))
        return [piece for piece in pieces if len(piece) >= 2]

    def hear_curve(self, event):
        self.curve = event["curve"]
        if not self.pieces():
            self.reached = {"FH3": None, "FH10": None}

    def hear_call(self, event):
        name, at = event["of"], event["at"]
        expect(not self.in_visibility, "the flag of a point is missing")
        self.in_visibility = name == "Visibility"
        if name == "SideEdge":
            pieces = self.pieces()
            end = pieces[0][0] if at == "FH3" else pieces[-1][-1]
            begin, self.reached[at] = self.reached[at], end
            self.segment = (begin, end) if begin else None
        elif name == "Visibility" and at == "FH4" and not self.has("x-h4"):
            self.before = {name: dict(horizon) for name, horizon in self.horizons.items()}
        elif name == "Horizon":
            self.changed = {"upper": [], "lower": []}

    def hear_side_edge(self, event):
        expect(event["sample"] == list(self.reached[event["at"]]), "the edge comes to", self.reached[event["at"]])

    def hear_height(self, event):
        self.told = event

    def hear_visibility(self, event):
        x, self.in_visibility = event["x"], False
        self.segment = tuple(map(self.sample, event["segment"]))
        expect(self.told["x"] == x, "the height over column", x, "was expected")
        numbers = {"y": self.height(self.segment, x)}
        numbers |= {name: horizon[x] for name, horizon in self.before.items() if horizon[x] is not None}
        for name in ("y", "upper", "lower"):
            expect((name in numbers) == (name in self.told), "over column", x, "there is a horizon, or none:", name)
            if name in numbers:
                self.expect_told(self.told, name, numbers[name])
        return numbers

    def hear_draw_line(self, event):
        self.segment = tuple(map(self.sample, event["segment"]))

    def hear_raise(self, event):
        self.change("upper", event)

    def hear_lower(self, event):
        self.change("lower", event)

    def change(self, name, event):
        height = self.height(self.segment, event["x"])
        self.expect_told(event, "y", height)
        self.horizons[name][event["x"]] = height
        self.changed[name].append([event["x"], event["y"]])

    def hear_horizon(self, event):
        for name, changed in self.changed.items():
            expect(event[name] == changed, "the horizon", name, "has changed over other columns")
