"""The truth about scenes, pictures, proofs and reasons, pixel by pixel in rationals. It relies on PROOF.md and the picture rule alone.

Where a checker of proofs looks at the corners of a rectangle, this looks at each pixel.
"""

import fractions
import functools

Fraction = fractions.Fraction


class Polygon:
    """A convex polygon as half-planes a x + b y + c >= 0, and its plane z = s x + t y + u."""

    def __init__(self, vertices):
        v = [tuple(Fraction(float(number)) for number in vertex) for vertex in vertices]
        pairs = [(v[i], v[(i + 1) % len(v)]) for i in range(len(v))]
        area = sum((q[0] - p[0]) * (q[1] + p[1]) for p, q in pairs)  # by trapezoids; more than 0 if the outline turns one way
        sign = -1 if area > 0 else 1
        self.edges = []
        for (px, py, _), (qx, qy, _) in pairs:
            a, b = sign * (py - qy), sign * (qx - px)
            self.edges.append((a, b, -a * px - b * py))
        self.convex = all(a * x + b * y + c >= 0 for a, b, c in self.edges for x, y, _ in v)
        self.edge_on = area == 0
        self.plane = None
        self.held, self.depths = {}, {}  # by place: a proof asks for the same places again and again
        if not self.edge_on:
            ox, oy, oz = v[0]
            relative = [(x - ox, y - oy, z - oz) for x, y, z in v]
            n = [Fraction(0)] * 3
            for i, p in enumerate(relative):
                q = relative[(i + 1) % len(v)]
                n[0] += (p[1] - q[1]) * (p[2] + q[2])
                n[1] += (p[2] - q[2]) * (p[0] + q[0])
                n[2] += (p[0] - q[0]) * (p[1] + q[1])
            self.plane = (-n[0] / n[2], -n[1] / n[2], oz + (n[0] * ox + n[1] * oy) / n[2])

    def changed(self, edges=None, rise=0):
        """The same with other half-planes, or raised."""
        made = Polygon.__new__(Polygon)
        made.edges, made.convex, made.edge_on = edges or self.edges, True, self.edge_on
        made.held, made.depths = {}, {}
        made.plane = self.plane and (self.plane[0], self.plane[1], self.plane[2] + rise)
        return made

    def holds(self, x, y):
        if (x, y) not in self.held:
            self.held[x, y] = not self.edge_on and all(self.side(edge, x, y) >= 0 for edge in range(len(self.edges)))
        return self.held[x, y]

    def side(self, edge, x, y):
        """On which side of an edge a place lies: less than 0 if it is outside."""
        a, b, c = self.edges[edge]
        return a * x + b * y + c

    def depth(self, x, y):
        if (x, y) not in self.depths:
            self.depths[x, y] = self.plane[0] * x + self.plane[1] * y + self.plane[2]
        return self.depths[x, y]


@functools.cache
def centre(x, y):
    return x + Fraction(1, 2), y + Fraction(1, 2)


def owner(polygons, x, y):
    """The number of the polygon that shows at a pixel: the nearest, of equally near ones the first; None for the background."""
    at = centre(x, y)
    holding = [(-polygon.depth(*at), number) for number, polygon in enumerate(polygons) if polygon.holds(*at)]
    return min(holding)[1] if holding else None


class Scene:
    def __init__(self, scene):
        self.polygons = [Polygon(polygon["vertices"]) for polygon in scene["polygons"]]
        self.colors = [polygon["color"] for polygon in scene["polygons"]]
        self.background = scene["background"]
        self.window = [scene["window"][key] for key in ("x", "y", "width", "height")]
        self.owners = {}

    def owner(self, x, y):
        if (x, y) not in self.owners:
            self.owners[x, y] = owner(self.polygons, x, y)
        return self.owners[x, y]

    def pixels(self):
        x, y, width, height = self.window
        return [(i, j) for j in range(y, y + height) for i in range(x, x + width)]

    def rgb(self):
        """The right picture's rows."""
        shown = [self.owner(x, y) for x, y in self.pixels()]
        return b"".join(bytes.fromhex((self.background if p is None else self.colors[p])[1:]) for p in shown)


def pairs_of(line):
    return line.get("beside", []) + line.get("behind", [])


def is_true(scene, rgb, lines):
    """Whether each statement of a proof is true of a scene and a picture, and the statements suffice. `scene` is a Scene."""
    count = len(scene.polygons)
    if not all(polygon.convex for polygon in scene.polygons) or not lines or lines[0] != {"format": "vidno-proof/1"}:
        return False
    left_out_in = [(scene.window, set())]
    proved = {}
    for line in lines[1:]:
        x, y, width, height = line["rectangle"]
        if width < 1 or height < 1:
            return False
        pixels = [(i, j) for i in range(x, x + width) for j in range(y, y + height)]

        def contains(outer):
            ox, oy, ow, oh = outer
            return ox <= x and oy <= y and x + width <= ox + ow and y + height <= oy + oh

        left_out_in = [each for each in left_out_in if contains(each[0])]
        if not left_out_in:
            return False
        # In a list of Python's, -1 would be the last.
        if min([0, *line.get("edge_on", []), *(each for pair in pairs_of(line) for each in pair)]) < 0:
            return False
        left_out = set(left_out_in[-1][1])
        for p in line.get("edge_on", []):
            if not scene.polygons[p].edge_on:
                return False
            left_out.add(p)
        for p, edge in line.get("beside", []):
            if edge >= len(scene.polygons[p].edges):
                return False
            if not all(scene.polygons[p].side(edge, *centre(*pixel)) < 0 for pixel in pixels):
                return False
            left_out.add(p)
        for p, front in line.get("behind", []):
            far, near = scene.polygons[p], scene.polygons[front]
            for at in (centre(*pixel) for pixel in pixels):
                if far.edge_on or not near.holds(*at):
                    return False
                gap = near.depth(*at) - far.depth(*at)
                if gap < 0 or (gap == 0 and front >= p):
                    return False
            left_out.add(p)
        left_out_in.append((line["rectangle"], left_out))
        if "owner" not in line:
            continue
        if not left_out | {line["owner"]} >= set(range(count)):
            return False
        for pixel in pixels:
            if pixel in proved or line["owner"] != scene.owner(*pixel):
                return False
            proved[pixel] = line["owner"]
    return set(proved) == set(scene.pixels()) and scene.rgb() == rgb
