"""A second reader of meshes, which shares no code with the program's. It reads right files only, by the plainest reading of each format:
a wrong one raises an exception. It gives points, faces, and colours and groups by face, as layouts.py has them."""
import array
import math
import re
import struct
import sys


def text_lines(data):
    text = data.decode("utf-8-sig")
    return re.split(r"\r\n|\r|\n", text)


def level(part, most):
    return math.floor(min(max(part / most, 0), 1) * 255 + 0.5)


def face_colors(faces, own, of_points):
    """By face: its own, or the mean of its corners', as parts from 0 to 1."""
    colors = []
    for face, shade in zip(faces, own):
        if shade is None and of_points and all(of_points[corner] for corner in face):
            shade = [sum(of_points[corner][part] for corner in face) / len(face) for part in range(3)]
        colors.append(shade and [level(part, 1) for part in shade])
    return colors


def unit(colors):
    """Parts from 0 to 1, whichever way the file writes them."""
    most = max([part for shade in colors if shade for part in shade] or [0])
    return [shade and [part / (1 if most <= 1 else 255) for part in shade] for shade in colors]


def read_obj(data, library):
    materials = {}
    current = None
    for line in text_lines(library or b""):
        line = line.strip()
        if line.startswith("newmtl "):
            current = line[7:].strip()
        elif line.startswith("Kd ") and current is not None:
            materials[current] = [float(part) for part in line[3:].split("#")[0].split()]
    points, shades, faces, own, groups = [], [], [], [], []
    material = group = None
    lines = text_lines(data)
    while lines:
        line = lines.pop(0).strip(" \t")
        keyword, _, rest = line.partition("#")[0].replace("\t", " ").partition(" ")
        if keyword in ("v", "f"):
            while rest.rstrip().endswith("\\") and "#" not in line:
                line = lines.pop(0) if lines else ""
                rest = rest.rstrip()[:-1] + " " + line.partition("#")[0]
            words = rest.split()
            if keyword == "v":
                points.append([float(word) for word in words[:3]])
                shades.append([float(word) for word in words[3:6]] if len(words) >= 6 else None)
            else:
                indices = [int(word.split("/")[0]) for word in words]
                faces.append([index - 1 if index > 0 else len(points) + index for index in indices])
                own.append(material)
                groups.append(group)
        elif keyword in ("g", "o"):
            group = line[2:].strip()
        elif keyword == "usemtl":
            material = materials[line[7:].strip()]
    return points, faces, face_colors(faces, own, unit(shades)), groups


def read_off(data, _):
    lines = [line.split("#")[0].split() for line in text_lines(data)]
    lines = [line for line in lines if line]
    keyword, counts = re.match(r"([A-Z]*OFF)(\d*)$", lines[0][0]).groups()
    lines[0] = ([counts] if counts else []) + lines[0][1:]
    at = 0 if lines[0] else 1  # the line of the counts
    states_edges = len(lines[at]) != 2 or (len(lines) > at + 1 and len(lines[at + 1]) == 1)
    words = [(word, number) for number, line in enumerate(lines) for word in line]
    counts = [int(words.pop(0)[0]), int(words.pop(0)[0])]
    base = 3 + (3 if "N" in keyword else 0) + (2 if "ST" in keyword else 0)

    def attempt(edges, parts, several):
        rest = words[edges:]
        take = lambda: rest.pop(0)[0]
        points, shades, faces, own = [], [], [], []
        for _ in range(counts[0]):
            numbers = [take() for _ in range(base + parts)]
            points.append([float(word) for word in numbers[:3]])
            at = base - (2 if "ST" in keyword else 0)
            shades.append([float(word) for word in numbers[at:at + 3]] if parts else None)
        for _ in range(counts[1]):
            size = int(take())
            at = 0
            face = []
            for _ in range(size):
                word, at = rest.pop(0)
                face.append(int(word))
            shade = []
            while not several and rest and rest[0][1] == at:
                shade.append(float(take()))
            assert len(shade) in (0, 3, 4)
            faces.append(face)
            own.append(shade[:3] or None)
        assert not rest and all(len(face) >= 3 for face in faces) and all(0 <= corner < counts[0] for face in faces for corner in face)
        return points, faces, face_colors(faces, unit(own), unit(shades)), [None] * len(faces)

    for several in (False, True):
        for parts in (4, 3) if "C" in keyword else (0,):
            try:
                return attempt(1 if states_edges else 0, parts, several)
            except (AssertionError, ValueError, IndexError, ZeroDivisionError):
                pass
    raise ValueError("no layout fits")


CODES = {"char": "b", "int8": "b", "uchar": "B", "uint8": "B", "short": "h", "int16": "h", "ushort": "H", "uint16": "H", "int": "i",
         "int32": "i", "uint": "I", "uint32": "I", "float": "f", "float32": "f", "double": "d", "float64": "d"}


def read_ply(data, _):
    data = data[3:] if data.startswith(b"\xef\xbb\xbf") else data
    end = re.match(rb"ply(\r\n|\r|\n)", data).group(1)
    head, _, body = data.partition(end + b"end_header" + end)
    elements = []
    form = None
    for line in head.decode().split(end.decode())[1:]:
        words = line.split()
        if words[0] == "format":
            form = words[1]
        elif words[0] == "element":
            elements.append((words[1], int(words[2]), []))
        elif words[0] == "property":
            elements[-1][2].append(words[1:])
    if form == "ascii":
        words = body.decode().split()
        take = lambda kind: (float if CODES[kind] in "fd" else int)(words.pop(0))
    else:
        order = ">" if form == "binary_big_endian" else "<"
        place = [0]

        def take(kind):
            value, = struct.unpack_from(order + CODES[kind], body, place[0])
            place[0] += struct.calcsize(CODES[kind])
            return value

    items = {}
    for name, count, properties in elements:
        rows = items.setdefault(name, [])
        for _ in range(count):
            row = {}
            for prop in properties:
                if prop[0] == "list":
                    row["list"] = [take(prop[2]) for _ in range(take(prop[1]))]
                else:
                    row[prop[1]] = take(prop[0])
            rows.append(row)
    points = [[row["x"], row["y"], row["z"]] for row in items["vertex"]]
    tint = lambda row: [row[part] / 255 for part in ("red", "green", "blue")] if "red" in row else None
    faces = [row["list"] for row in items.get("face", [])]
    own = [tint(row) for row in items.get("face", [])]
    for row in items.get("tristrips", []):
        strip = []
        for corner in row["list"]:
            strip = [] if corner < 0 else strip + [corner]
            if len(strip) >= 3:
                a, b, c = strip[-3:]
                faces.append([a, b, c] if len(strip) % 2 == 1 else [b, a, c])
                own.append(None)
    assert all(0 <= corner < len(points) for face in faces for corner in face)
    return points, faces, face_colors(faces, own, [tint(row) for row in items["vertex"]]), [None] * len(faces)


def read_stl(data, _):
    count = struct.unpack_from("<I", data, 80)[0] if len(data) >= 84 else None
    points = []
    if count is not None and len(data) == 84 + 50 * count:
        for i in range(count):
            numbers = array.array("f", data[84 + 50 * i + 12:84 + 50 * i + 48])
            if sys.byteorder == "big":
                numbers.byteswap()
            points += [list(numbers[at:at + 3]) for at in (0, 3, 6)]
    else:
        for line in re.findall(r"vertex\s+(\S+)\s+(\S+)\s+(\S+)", data.decode("utf-8-sig"), re.IGNORECASE):
            points.append([float(word) for word in line])
    faces = [[i, i + 1, i + 2] for i in range(0, len(points), 3)]
    return points, faces, [None] * len(faces), [None] * len(faces)


READERS = {"obj": read_obj, "off": read_off, "ply": read_ply, "stl": read_stl}
