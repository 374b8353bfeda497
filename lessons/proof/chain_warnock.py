"""The chain of Warnock's algorithm and its family: corner depths, signs at edges and at sides of a window, clipped vertices."""

from chain import Window, constant, exactly, expect, named
from chain_clip import ClipChain
from kernel import FARTHEST

CORNERS = ["lb", "lt", "rb", "rt"]


class WarnockChain(ClipChain):
    def __init__(self, header, kernel):
        super().__init__(header, kernel)
        self.read_polygons()
        self.with_edges = header["method"] == "warnock-edges"
        self.edge_depths, self.signs, self.planes_c = [FARTHEST], [], set()
        self.window = self.alone = self.left = self.boxed = self.pending = None
        self.is_insider = self.has_turned = False
        self.windows, self.to_examine = [], []

    def coordinates(self):
        return [number for polygon in self.polygons for vertex in polygon.vertices for number in vertex]

    def operands_of(self, decision):
        if decision["of"] == "rows":
            return [self.row_operands(self.outline, None)]
        vertices = [vertex for polygon in self.polygons for vertex in polygon.vertices]
        if decision["of"] == "inside":  # VS2: a vertex in the window
            return [self.window.operands([x, y, x, y]) for x, y, _ in vertices]
        if decision["of"] == "first_centre":
            x1, y1, x2, y2 = self.window.sides
            spans = [(v[0], x1, x2) for v in vertices] + [(v[1], y1, y2) for v in vertices]
            return [{"x": number, "low": constant(low), "end": constant(end)} for number, low, end in spans]
        if decision["of"] == "nearer":
            return [{"z": z, "against": against} for z in self.edge_depths for against in self.edge_depths]
        self.pool = {*self.coordinates(), *self.planes_c, constant(0)}
        if self.window:
            self.pool |= {number for place in [*self.window.corners, self.window.centre] for number in place}
        return None

    def hear_plane(self, event):
        polygon = self.polygon(event)
        self.planes_c.add(self.kernel.told(event["plane"][2], polygon.normal[2]))

    # The windows, each with its list of active polygons. In the methods with three lists it is one list that changes.

    def hear_push(self, event):
        if "apl" in event:
            self.windows.append([polygon for polygon, _ in event["apl"]])
        else:
            self.windows.append(self.active if event.get("shared") else list(self.active))

    def hear_pop(self, event):
        self.window, self.active = Window(self.kernel, event["window"]), self.windows.pop()
        self.to_examine = [] if event["at"] == "WF2" else list(self.active)

    def hear_discard(self, event):
        self.active.remove(event["polygon"])

    def hear_decide(self, event):
        expect(not self.to_examine, "no box of polygon", *self.to_examine[:1])

    def hear_call(self, event):
        name, at = event["of"], event["at"]
        expect(self.pending is None, "a decision is missing:", self.pending)
        if name == "SurroundTest":
            self.signs, self.edge_depths = [], [FARTHEST]
            self.place = self.window.centre if at == "PC2" else self.window.corners[self.corner]
        elif name == "PointColor":
            self.nearest_at_point = FARTHEST
        elif name == "TrialFunction":
            self.trials = 0
        elif name == "FillPolygon":
            alone = {"W11": self.alone, "WF7": self.left}.get(at)
            self.begin_fill([vertex[:2] for vertex in alone.vertices] if alone else self.clipped)

    # ProcessWindow, HidingPolygon and PointColor

    def hear_corners(self, event):
        start = self.kernel.given(0) if self.has("x-w2") else FARTHEST
        self.nearest, self.depths, self.compared, self.is_insider = [start] * 4, [], [], False
        self.expect_told(event, "z", start)

    def hear_box(self, event):
        polygon = self.polygon(event)
        for i, number in enumerate(polygon.box):
            self.expect_told(event, ("box", i), number)
        if self.to_examine:
            expect(self.to_examine.pop(0) == polygon.id, "the box of another polygon was expected")
        self.boxed = polygon
        return self.window.operands(polygon.box)

    def hear_insider(self, event):
        self.is_insider = event["inside"]
        return self.window.operands(self.polygon(event).box)

    def hear_count(self, event):
        self.alone, self.corner, self.depths = self.polygon(event), 0, []
        expect(self.boxed is self.alone, "the polygon is counted without its box")
        self.boxed = None

    def hear_summary(self, event):
        expect(event["insider"] == self.is_insider, "insider is", self.is_insider)

    def hear_depth(self, event):
        polygon = self.polygon(event)
        at_corner = event["at"] in ("PW5", "HP3")
        expect(not at_corner or len(self.depths) < 4, "a fifth corner of a window")
        place = self.window.corners[len(self.depths)] if at_corner else self.window.centre
        for i in (0, 1):
            self.expect_told(event, ("point", i), place[i])
        if self.with_edges and polygon.is_edge_on:
            self.depth = max(self.edge_depths, key=lambda depth: depth.used)
            self.expect_told(event, "z", self.depth)
        else:
            self.depth = self.kernel.told(event["z"], polygon.depth([number.exact for number in place]))
        if at_corner:
            self.depths.append(self.depth)
        else:
            expect(self.pending is None, "a decision is missing:", self.pending)
            self.pending = "a comparison of depths"

    def hear_compare(self, event):
        z, against = self.depth, None
        if "corner" in event:
            corner = CORNERS.index(event["corner"])
            expect(len(self.depths) == 4 and corner == len(self.compared), "a comparison at another corner was expected")
            z, against = self.depths[corner], self.nearest[corner]
            self.compared.append(event["nearer"])
            if event["nearer"]:
                self.nearest[corner] = z
        else:
            against, self.pending = self.nearest_at_point, None
            if event["nearer"]:
                self.nearest_at_point = z
        self.expect_told(event, "z", z)
        self.expect_told(event, "against", against)
        return {"z": z, "against": against}

    def hear_nearer(self, event):
        nearer = [corner for corner, is_nearer in zip(CORNERS, self.compared) if is_nearer]
        expect(len(self.compared) == 4 and event["corners"] == nearer, "the comparisons give other corners:", nearer)
        self.depths, self.compared = [], []

    def hear_edge_depth(self, event):
        """The depth of an edge of an edge-on polygon: linear in x or, if the edge is upright, in y; else that of its nearer end."""
        polygon, i = self.polygon(event), event["edge"]
        p, q = polygon.vertex(i), polygon.vertex(i + 1)
        axis = next((axis for axis in (0, 1) if p[axis].used != q[axis].used), None)
        at = self.window.centre
        if axis is None:
            exact = (q if p[2].used < q[2].used else p)[2].exact
        else:
            t = exactly(lambda: (at[axis].exact - p[axis].exact) / (q[axis].exact - p[axis].exact))
            exact = exactly(lambda: p[2].exact + t * (q[2].exact - p[2].exact))
        self.edge_depths.append(self.kernel.told(event["z"], exact))

    # Signs at edges: SurroundTest, TrialFunction, RayCrossings, OctantAngles, EdgeDepth and BackFaces

    def hear_orient(self, event):
        polygon, edge, at = self.polygon(event), event["edge"], event["at"]
        if at in ("S2", "S3", "ED3"):
            follows = len(self.signs) - (at != "ED3")
            expect(edge == follows % len(polygon.vertices), "the signs of the edges are not in order")
            self.signs.append(event["sign"])
            place = self.place
        elif at == "TF2":
            expect(edge == self.trials // 4, "the signs of the edges are not in order")
            place = self.window.corners[self.trials % 4]
            self.trials += 1
        elif at == "CR4":
            self.has_turned = True
            place = self.window.centre
        elif at == "OA4":
            self.has_turned = True
            lb, lt, rb, rt = self.window.corners
            place = [lb, rb, rt, lt][(self.octant(polygon.vertex(edge)) + 2) % 8 // 2]
        else:
            place = polygon.vertex(edge + 2)
        for i in (0, 1):
            self.expect_told(event, ("point", i), place[i])
        return named("pivot", polygon.vertex(edge)) | named("a", polygon.vertex(edge + 1)) | named("b", place)

    def octant(self, vertex):
        """Clockwise around the window, as the run sees it."""
        (x1, y1), (x2, y2) = self.window.corners[0], self.window.corners[3]
        x, y = vertex[0].used, vertex[1].used
        column = 0 if x <= x1.used else 2 if x >= x2.used else 1
        row = 0 if y <= y1.used else 2 if y >= y2.used else 1
        return [[0, 1, 2], [7, 0, 3], [6, 5, 4]][row][column]

    def hear_ray(self, event):
        self.expect_turn(event["at"] == "CR4")

    def hear_octants(self, event):
        self.expect_turn(event["at"] == "OA4")

    def expect_turn(self, is_needed):
        expect(self.has_turned == is_needed, "the edge needs a sign, or has one too many")
        self.has_turned = False

    def hear_color(self, event):
        expect(self.pending is None, "a decision is missing:", self.pending)

    def hear_trial(self, event):
        expect(self.trials == 4 * (event["edge"] + 1), "an edge needs a sign at each corner")

    def hear_surround(self, event):
        polygon, signs = self.polygon(event), self.signs
        if self.with_edges and polygon.is_edge_on:
            is_inside = len(signs) == len(polygon.vertices) and not any(signs)
        else:
            is_strict = self.has("boundary-outside")
            others = [i for i in range(len(signs)) if self.leaves(signs[: i + 1], is_strict)]
            expect(others in ([], [len(signs) - 1]), "the test goes on after a sign that differs")
            expect(others or len(signs) == len(polygon.vertices), "the test ends before the last edge")
            is_inside = not others and any(signs)
        expect(event["inside"] == is_inside, f"inside is {event['inside']}, but the signs are {signs}")
        if event["at"] == "PW8":
            self.corner += 1

    @staticmethod
    def leaves(signs, is_strict):
        """Does the last sign show that the point is outside?"""
        first = signs[0] if is_strict else next((each for each in signs if each), 0)
        return signs[-1] != first and (is_strict or signs[-1] != 0) or (is_strict and signs[-1] == 0)

    # Which polygon FillPolygon draws whole

    def hear_relation(self, event):
        expect(self.boxed is self.polygon(event), "the relation is found without the box")
        self.boxed = None
        if event["relation"] in ("inside", "intersecting"):
            self.left = self.polygon(event)
