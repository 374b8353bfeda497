"""Checks a proof that a picture shows a scene, as trace/PROOF.md explains: python3 verify.py SCENE.json PICTURE.png PROOF.jsonl"""
import fractions, itertools, json, sys
from read_picture import read_picture
def check(is_true, reason): return is_true or sys.exit(reason)
def value(linear, at): return linear[0] * at[0] + linear[1] * at[1] + linear[2]
def contains(a, b): return all(a[i] <= b[i] < b[i] + b[i + 2] <= a[i] + a[i + 2] for i in (0, 1))
class Polygon:
    def __init__(self, given):
        v = [[fractions.Fraction(float(number)) for number in vertex] for vertex in given["vertices"]]  # exactly the double
        pairs = list(zip(v, v[1:] + v[:1]))
        a, b, c = (sum(p[i] * q[k] - p[k] * q[i] for p, q in pairs) for i, k in ((1, 2), (2, 0), (0, 1)))  # Newell's sum
        way = 1 if c > 0 else -1  # with it, the polygon lies where no edge has a negative value
        self.edges = [(way * (p[1] - q[1]), way * (q[0] - p[0]), way * (p[0] * q[1] - p[1] * q[0])) for p, q in pairs]
        check(all(value(edge, vertex) >= 0 for edge in self.edges for vertex in v), "scene: a polygon is not convex")
        self.depth = (-a / c, -b / c, v[0][2] + (a * v[0][0] + b * v[0][1]) / c) if c != 0 else None  # None: edge-on
    def holds(self, places): return self.depth and all(value(edge, at) >= 0 for edge in self.edges for at in places)
def rank(p, at): return value(polygons[p].depth, at), -p  # of the polygons that hold a place, the one of greatest rank shows
scene, proof = json.load(open(sys.argv[1])), map(json.loads, open(sys.argv[3]))
window = left, top, columns, rows = [scene["window"][key] for key in ("x", "y", "width", "height")]
picture = read_picture(sys.argv[2], columns, rows)
check(next(proof) == {"format": "vidno-proof/1"} and "camera" not in scene, "not a scene on the screen and a proof")
polygons = dict(enumerate(map(Polygon, scene["polygons"])))  # a list would also have one at -1
around, proved, half = [(window, set())], {}, fractions.Fraction(1, 2)
for n, line in enumerate(proof, 2):
    x, y, width, height = rectangle = line["rectangle"]
    edge_on, beside, behind = (line.get(reason, []) for reason in ("edge_on", "beside", "behind"))
    corners = [(i + half, j + half) for i in (x, x + width - 1) for j in (y, y + height - 1)]
    around = [each for each in around if contains(each[0], rectangle)] or sys.exit(f"line {n}: the rectangle is not in the window")
    for p in edge_on: check(not polygons[p].depth, f"line {n}: {p} is not edge-on")
    for p, e in beside: check(all(value(polygons[p].edges[e], at) < 0 for at in corners), f"line {n}: {p} is not beside")
    for p, q in behind: check(all(rank(p, at) < rank(q, at) for at in corners), f"line {n}: {p} is not behind {q}")
    for p in {q for _, q in behind} | {line.get("owner")} - {None}: check(polygons[p].holds(corners), f"line {n}: {p} does not hold it")
    around.append((rectangle, around[-1][1] | {*edge_on} | {p for p, _ in beside + behind}))
    if "owner" in line:
        check(around[-1][1] | {line["owner"]} >= {*range(len(polygons))}, f"line {n}: another polygon has no reason")
        color = bytes.fromhex((scene["background"] if line["owner"] is None else scene["polygons"][line["owner"]]["color"])[1:])
        for at in itertools.product(range(x, x + width), range(y, y + height)): proved.setdefault(at, []).append(color)
for i, (y, x) in enumerate(itertools.product(range(top, top + rows), range(left, left + columns))):
    check(proved.get((x, y)) == [picture[3 * i : 3 * i + 3]], f"pixel {x},{y}: not proved once, or not in this colour")
print(f"proved: the picture shows the scene at each of its {columns * rows} pixels")
