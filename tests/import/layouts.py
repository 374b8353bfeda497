"""Mesh files in the layouts that people bring. A seed makes a mesh, its file, and what a reader must find in it.

A case is a dict: `name` of the file, its `bytes`, perhaps `library` (the bytes of materials.mtl beside it), and either the mesh (`points`,
`faces`, `colors` by face, `groups` by face) with the kinds of its `losses`, or `line`, the line that a refusal must name. `line` is 0 for a binary file.
"""
import random
import struct

FORMATS = ["obj", "off", "ply", "stl"]


class Lines:
    """Text under construction, which knows the line of what is written next."""

    def __init__(self, rng, mark="#"):
        self.rng, self.mark, self.parts, self.line = rng, mark, [], 1
        self.end = rng.choice(["\n", "\n", "\r\n", "\r"])
        self.neat = rng.random() < 0.3  # neither comments nor blank lines

    def add(self, text):
        self.parts.append(text)

    def end_line(self, comment=True):
        if comment and self.mark and not self.neat and self.rng.random() < 0.1:
            self.add(" " + self.mark + " in D:\\models\\")
        self.add(self.rng.choice(["", "", "", " ", "\t"]) + self.end)
        self.line += 1

    def noise(self):
        """Perhaps a blank line or a comment."""
        if self.neat or self.rng.random() > 0.15:
            return
        if self.mark:
            self.add(self.rng.choice(["", self.mark + " saved in D:\\models\\", "  " + self.mark, self.mark + "v 9 9 9"]))
        self.end_line(False)

    def bytes(self, may_have_mark=True):
        text = "".join(self.parts)
        if self.rng.random() < 0.1:
            text = text.rstrip("\r\n \t")
        mark = b"\xef\xbb\xbf" if may_have_mark and self.rng.random() < 0.2 else b""
        return mark + text.encode()


def number(rng, value):
    """One of the ways to write the same number."""
    ways = ["%g" % value, repr(float(value)), "%.6f" % value, "%.10e" % value, "+%g" % value if value >= 0 else "%g" % value]
    if value == int(value):
        ways.append("%d." % value)
    if 0 < value < 1:
        ways.append(("%g" % value)[1:])
    return rng.choice(ways)


def blank(rng):
    return rng.choice([" ", " ", " ", "  ", "\t"])


def random_mesh(rng):
    points = [[rng.randrange(-64, 65) / 8 for _ in range(3)] for _ in range(rng.randrange(4, 10))]
    faces = [rng.sample(range(len(points)), rng.choice([3, 3, 4])) for _ in range(rng.randrange(1, 7))]
    return points, faces


def random_color(rng):
    return [rng.choice([0, 51, 102, 153, 204, 255]) for _ in range(3)]


FAULTS = {
    "obj": ["word", "index", "short", "zero"],
    "off": ["word", "index", "short", "negative"],
    "ply": ["word", "index", "short", "type"],
    "stl": ["word", "keyword"],
}


def case(seed, kind):
    rng = random.Random("%s %d" % (kind, seed))
    while True:
        fault = rng.choice(FAULTS[kind]) if rng.random() < 0.25 else None
        made = globals()["make_" + kind](rng, fault)
        if made is not None:
            made["name"] = "%s-%d.%s" % (kind, seed, rng.choice([kind, kind, kind.upper()]))
            return made


def found(points, faces, colors=None, groups=None, paint=None):
    """What a reader must find. `paint` has the colours of the points; a scene loses their change within a face."""
    if paint:
        colors = [mean([paint[corner] for corner in face]) for face in faces]
    is_mixed = bool(paint) and any(paint[corner] != paint[face[0]] for face in faces for corner in face)
    return {"points": points, "faces": faces, "colors": colors or [None] * len(faces), "groups": groups or [None] * len(faces),
            "losses": ["a change of colour within a face, which has the mean"] if is_mixed else []}


# OBJ

NOISY_OBJ = ["vn 0 0 1", "vt 0.5 0.5", "s off", "s 1", "vp 0.1", "mg 0", "lod 3", "#"]


def make_obj(rng, fault):
    points, faces = random_mesh(rng)
    out = Lines(rng)
    has_library = rng.random() < 0.4
    paint = None if has_library or rng.random() < 0.6 else [random_color(rng) for _ in points]
    materials = {"D:\\paints\\" + name: random_color(rng) for name in ["a", "b c", "d#e"]} if has_library else {}

    def words(parts):
        for i, part in enumerate(parts):
            if i > 0:
                if rng.random() < 0.06 and not out.neat:
                    out.add(rng.choice([" ", ""] if i > 1 else [" "]) + "\\" + out.end)
                    out.line += 1
                out.add(blank(rng))
            line_of.append(out.line)
            out.add(part)

    if has_library:
        out.add("mtllib " + rng.choice(["materials.mtl", "D:\\models\\materials.mtl"]))
        out.end_line(False)
    bad_point = rng.randrange(len(points)) if fault in ("word", "short") else None
    bad_face = rng.randrange(len(faces)) if fault in ("index", "zero") else None
    line = None
    faces_first = rng.random() < 0.1
    colors, groups, group, color = [], [], None, None
    order = ["f", "v"] if faces_first else ["v", "f"]
    for what in order:
        for i in range(len(points) if what == "v" else len(faces)):
            out.noise()
            if not out.neat and rng.random() < 0.1:
                out.add(rng.choice(NOISY_OBJ))
                out.end_line(False)
            line_of = []
            if what == "v":
                parts = [number(rng, value) for value in points[i]]
                if paint:
                    parts += [repr(part / 255) for part in paint[i]]
                elif rng.random() < 0.05:
                    parts.append("1.0")
                if i == bad_point:
                    if fault == "word":
                        parts[rng.randrange(3)] = rng.choice(["1,5", "x", "nan", "1e999", "0x10", "--1"])
                    else:
                        del parts[2:]
                words(["v"] + parts)
                if i == bad_point:
                    wrong = next((k for k, part in enumerate(parts) if part in ["1,5", "x", "nan", "1e999", "0x10", "--1"]), None)
                    line = line_of[1 + wrong] if wrong is not None else out.line
            else:
                if materials and rng.random() < 0.4:
                    name = rng.choice(list(materials))
                    color = materials[name]
                    out.add("usemtl" + blank(rng) + name)
                    out.end_line(False)
                if rng.random() < 0.15:
                    group = rng.choice(["left wing", "C:\\parts\\", "a"])
                    out.add(rng.choice(["g ", "o "]) + group)
                    out.end_line(False)
                at = out.line
                corners = []
                for corner in faces[i]:
                    index = corner - len(points) if not faces_first and rng.random() < 0.2 else corner + 1
                    corners.append(str(index) + rng.choice(["", "", "/1", "/1/1", "//1"]))
                if i == bad_face:
                    k = rng.randrange(len(corners))
                    corners[k] = "0" if fault == "zero" else str(len(points) + 1)
                words(["f"] + corners)
                if i == bad_face:
                    line = line_of[1 + k] if fault == "zero" else at
                colors.append(color)
                groups.append(group)
            out.end_line()
    made = {"bytes": out.bytes()}
    if has_library:
        library = Lines(rng)
        for name, shade in materials.items():
            library.noise()
            library.add("newmtl " + name)
            library.end_line(False)
            library.add("\tKd " + " ".join(repr(part / 255) for part in shade))
            library.end_line()
        made["library"] = library.bytes()
    if fault:
        return dict(made, line=line)
    return dict(made, **found(points, faces, colors, groups, paint))


def mean(shades):
    """The mean of colours, rounded, or None where the last digit of a sum could decide."""
    sums = [sum(part) for part in zip(*shades)]
    count = len(shades)
    if any(2 * total % (2 * count) == count for total in sums):
        return "any"
    return [(2 * total + count) // (2 * count) for total in sums]


# OFF


def make_off(rng, fault):
    points, faces = random_mesh(rng)
    out = Lines(rng)
    prefix = rng.choice(["", "", "", "C", "N", "CN", "ST", "STC", "STCN"])
    layout = "lines" if fault else rng.choice(["lines", "free", "one line"])
    alpha = rng.random() < 0.5
    unit = rng.random() < 0.5

    def color_words(shade, opacity):
        parts = list(shade) + ([255] if opacity else [])
        return [repr(part / 255) for part in parts] if unit else [str(part) for part in parts]

    paint = [random_color(rng) for _ in points] if "C" in prefix else None
    own = None if paint or layout == "one line" or rng.random() < 0.6 else [random_color(rng) for _ in faces]
    if not unit and max([255] if not (paint or own) else [max(shade) for shade in paint or own]) <= 1:
        unit = True  # black alone
    out.noise()
    out.add(prefix + "OFF")
    head = [str(len(points)), str(len(faces))] + ([] if layout == "lines" and rng.random() < 0.1 else ["0"])
    start = rng.choice(["join", "same line", "next line"])
    if layout == "one line":
        start = rng.choice(["join", "same line"])
    if start == "join":
        pass
    elif start == "same line":
        out.add(" ")
    else:
        out.end_line()
        out.noise()
    out.add(" ".join(head))
    items, kinds = [], []
    for i, point in enumerate(points):
        words = [number(rng, value) for value in point]
        if "N" in prefix:
            words += rng.choice([["0", "0", "1"], ["nan", "nan", "nan"]])
        if paint:
            words += color_words(paint[i], alpha)
        if "ST" in prefix:
            words += ["0.5", "0.25"]
        items.append(words)
        kinds.append("v")
    for i, face in enumerate(faces):
        words = [str(len(face))] + [str(corner) for corner in face]
        items.append(words + (["|"] + color_words(own[i], alpha) if own else []))
        kinds.append("f")
    bad = None
    if fault in ("word", "short"):
        bad = rng.randrange(len(points))
        if fault == "word":
            items[bad][rng.randrange(3)] = rng.choice(["1,5", "x", "inf", "1e999"])
        else:
            del items[bad][2:]
    elif fault:
        bad = len(points) + rng.randrange(len(faces))
        items[bad][2] = "-1" if fault == "negative" else str(len(points))
    line, used = None, set()
    if layout != "one line":
        out.end_line()
    for i, words in enumerate(items):
        if layout == "lines":
            out.noise()
        if i == bad:
            line = out.line
        fixed = False  # a colour ends a line
        for k, word in enumerate(words):
            if word == "|":
                fixed = True
                continue
            if k > 0 or layout != "lines":
                # A line that begins inside an item, or goes on with the next one.
                if layout == "free" and not fixed and rng.random() < 0.15 and (k > 0 or i > 0):
                    out.end_line()
                else:
                    out.add(blank(rng))
            used.add(out.line)
            out.add(word)
        if layout == "lines" or (layout == "free" and (kinds[i] == "f" or rng.random() < 0.5)):
            out.end_line()
    if layout == "one line":
        out.end_line()
    if layout == "free" and len(used) == len(items):
        return None  # it could as well be a file with a line for each item, of which some are wrong
    if fault:
        return {"bytes": out.bytes(), "line": line}
    return {"bytes": out.bytes(), **found(points, faces, own, paint=paint)}


# PLY

REAL, NATURAL, INTEGER = ["float", "float32", "double", "float64"], ["uchar", "uint8", "ushort", "uint"], ["char", "int8", "short", "int", "int32"]
CODES = {"char": "b", "int8": "b", "uchar": "B", "uint8": "B", "short": "h", "int16": "h", "ushort": "H", "uint16": "H", "int": "i", "int32": "i",
         "uint": "I", "uint32": "I", "float": "f", "float32": "f", "double": "d", "float64": "d"}


def make_ply(rng, fault):
    points, faces = random_mesh(rng)
    out = Lines(rng, mark="")
    out.neat = True  # a header has no blank lines
    form = "ascii" if fault in ("word", "short", "type") else rng.choice(["ascii", "ascii", "binary_little_endian", "binary_big_endian"])
    layout = "lines" if fault else rng.choice(["lines", "free"])
    strips = not fault and rng.random() < 0.2
    paint = random_color if rng.random() < 0.3 else None
    real = rng.choice(REAL)
    # The properties of a vertex in any order, some of them not read.
    vertex = [(real, "x"), (real, "y"), (real, "z")]
    if rng.random() < 0.4:
        vertex += [("float", "nx"), ("float", "quality")]
    shades = [random_color(rng) for _ in points] if paint and rng.random() < 0.5 else None
    if shades:
        vertex += [("uchar", part) for part in ["red", "green", "blue"]]
    rng.shuffle(vertex)
    own = [random_color(rng) for _ in faces] if paint and not shades and not strips else None
    length_type = rng.choice(["uchar", "int", "ushort"])
    index_type = rng.choice(["int", "short", "int32"] if strips else ["int", "uint", "short", "uchar"])
    list_name = rng.choice(["vertex_indices", "vertex_index", "corners"])
    elements = [("vertex", len(points)), ("tristrips" if strips else "face", 1 if strips else len(faces))]
    if rng.random() < 0.15 and not strips:
        elements.insert(0, ("camera", 1))
    if rng.random() < 0.1 and fault != "index":
        elements.reverse()

    header = [("ply",), ("format", form, "1.0"), ("comment", "made in D:\\models\\")]
    properties = {}
    for name, count in elements:
        header.append(("element", name, str(count)))
        if name == "vertex":
            properties[name] = vertex
        elif name == "camera":
            properties[name] = [("float", "view")]
        else:
            properties[name] = [(length_type, index_type, list_name)]
            if own:
                properties[name] += [("uchar", part) for part in ["red", "green", "blue"]]
            if rng.random() < 0.3:
                properties[name].append(("float", "quality"))
        for prop in properties[name]:
            header.append(("property", "list") + prop if len(prop) == 3 else ("property",) + prop)
    header.append(("end_header",))
    bad_header = None
    if fault == "type":
        bad_header = rng.choice([i for i, line in enumerate(header) if line[0] == "property"])
        header[bad_header] = ("property", "quad", "x")
    line = None
    for i, parts in enumerate(header):
        if i == bad_header:
            line = out.line
        out.add(" ".join(parts))
        out.add(out.end)
        out.line += 1
    if strips:
        faces, corners = random_strips(rng, len(points))

    rows = []  # of (type, value)
    for name, count in elements:
        for i in range(count):
            row = []
            for prop in properties[name]:
                kind, key = prop[0], prop[-1]
                if len(prop) == 3:
                    values = corners if strips else faces[i]
                    row.append((kind, len(values)))
                    row += [(prop[1], value) for value in values]
                elif key in ("x", "y", "z") and name == "vertex":
                    row.append((kind, points[i]["xyz".index(key)]))
                elif key in ("red", "green", "blue"):
                    row.append((kind, (shades or own)[i][["red", "green", "blue"].index(key)]))
                else:
                    row.append((kind, rng.choice([0.5, float("nan"), float("inf"), float("-inf")])))
            rows.append(row)
    bad = None
    place = {name: sum(count for _, count in elements[:k]) for k, (name, _) in enumerate(elements)}
    if fault == "index":
        bad = place["face"] + rng.randrange(len(faces))
        rows[bad][1] = (rows[bad][1][0], len(points))
    elif fault in ("word", "short"):
        bad = place["vertex"] + rng.randrange(len(points))

    used = set()  # lines of the body
    if form != "ascii":
        order = "<" if form.endswith("little_endian") else ">"
        data = b"".join(struct.pack(order + CODES[kind], value) for row in rows for kind, value in row)
        made = "".join(out.parts).encode() + data
        if fault:
            return {"bytes": made, "line": 0}
    else:
        for i, row in enumerate(rows):
            words = [number(rng, value) if kind in REAL and abs(value) < 1e9 else str(value) for kind, value in row]
            if i == bad and fault == "word":
                words[[prop[-1] for prop in vertex].index("y")] = rng.choice(["1,5", "x", "nan"])
            elif i == bad and fault == "short":
                words.pop()
            if i == bad:
                line = out.line
            for k, word in enumerate(words):
                if k > 0:
                    out.add(blank(rng))
                used.add(out.line)
                out.add(word)
                if layout == "free" and rng.random() < 0.1:
                    out.end_line()
            if layout == "lines" or rng.random() < 0.8:
                out.end_line()
            else:
                out.add(" ")
        if layout == "free" and len(used) == len(rows):
            return None  # as for OFF
        made = out.bytes()
        if fault:
            return {"bytes": made, "line": line}
    return {"bytes": made, **found(points, faces, own, paint=shades)}


def random_strips(rng, count):
    """The triangles of some strips, and the strips as a list of corners with -1 between them."""
    faces, corners = [], []
    for _ in range(rng.randrange(1, 4)):
        strip = rng.sample(range(count), rng.randrange(3, count + 1))
        if corners:
            corners.append(-1)
        corners += strip
        for i in range(len(strip) - 2):
            a, b, c = strip[i:i + 3]
            faces.append([a, b, c] if i % 2 == 0 else [b, a, c])
    return faces, corners


# STL


def make_stl(rng, fault):
    points, faces = random_mesh(rng)
    triangles = [[points[corner] for corner in face[:3]] for face in faces]
    corners = [point for triangle in triangles for point in triangle]
    mesh = found(corners, [[3 * i, 3 * i + 1, 3 * i + 2] for i in range(len(triangles))])
    normals = [rng.choice([(0.0, 0.0, 1.0), (float("nan"),) * 3, (float("inf"), 0.0, 0.0)]) for _ in triangles]
    if not fault and rng.random() < 0.4:
        header = rng.choice([b"solid D:\\models\\x.stl", b"binary", b"solid facet normal", b"", b"SOLID\nfacet"])
        data = header.ljust(80, rng.choice([b"\0", b" "])) + struct.pack("<I", len(triangles))
        for normal, triangle in zip(normals, triangles):
            data += struct.pack("<12fH", *normal, *triangle[0], *triangle[1], *triangle[2], 0)
        return {"bytes": data, **mesh}
    out = Lines(rng, mark="")
    upper = rng.random() < 0.2
    end = rng.choice(["end", "end "])
    bad, line = rng.randrange(len(triangles)), None
    layout = "lines" if fault else rng.choice(["lines", "free"])

    def put(*words, fixed=False):
        for k, word in enumerate(words):
            out.add((word.upper() if upper and not fixed else word) + (blank(rng) if k + 1 < len(words) else ""))
        if layout == "lines" or fixed or rng.random() < 0.5:
            out.end_line(False)
            out.noise()
        else:
            out.add(" ")

    several = rng.random() < 0.2
    put("solid", "end of D:\\models\\", fixed=True)
    for i, (normal, triangle) in enumerate(zip(normals, triangles)):
        put("facet", "normal", *[str(value) for value in normal])
        if i == bad and fault == "keyword":
            line = out.line
            put("outer", "loops")
        else:
            put("outer", "loop")
        for k, point in enumerate(triangle):
            words = [number(rng, value) for value in point]
            if i == bad and k == 1 and fault == "word":
                words[1] = rng.choice(["1,5", "x", "nan"])
                line = out.line
            put("vertex", *words)
        put(end + "loop")
        put(end + "facet")
        if several and i + 1 < len(triangles):
            put(end + "solid", "a", fixed=True)
            put("solid", fixed=True)
    put(end + "solid", "of D:\\models\\", fixed=True)
    return {"bytes": out.bytes(), "line": line} if fault else {"bytes": out.bytes(), **mesh}
