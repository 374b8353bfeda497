#!/usr/bin/env python3
"""The Z-buffer, right, in another language: it reads the scene and writes the trace itself, and reports only the pixels of each row."""
import hashlib
import json
import os

with open(os.environ['VIDNO_SCENE'], encoding='utf-8') as file:
    lines = iter(file.read().split('\n'))


def numbers():
    return [float(word) for word in next(lines).split()]


def colour():
    return [int(part) for part in numbers()]


name = next(lines)[1:]
left, top, width, height = map(int, numbers())
background = colour()
polygons = []
for _ in range(int(numbers()[0])):
    identity, paint = next(lines)[1:], colour()
    polygons.append((identity, paint, [numbers() for _ in range(int(numbers()[0]))]))


def hexadecimal(rgb):
    return '#%02x%02x%02x' % tuple(rgb)


def plane(vertices):
    """The coefficients a, b, c, d of the plane, by Newell's sum about the first vertex."""
    o, a, b, c = vertices[0], 0, 0, 0
    for p, q in zip(vertices[1:], vertices[2:]):
        u, v = [[s - t for s, t in zip(r, o)] for r in (p, q)]
        a, b, c = a + u[1] * v[2] - u[2] * v[1], b + u[2] * v[0] - u[0] * v[2], c + u[0] * v[1] - u[1] * v[0]
    return a, b, c, -(a * o[0] + b * o[1] + c * o[2])


def ends(vertices, y):
    """The left and the right end of the outline on a horizontal line; None if the outline misses the line."""
    found = []
    for p, q in zip(vertices, vertices[1:] + vertices[:1]):
        if (p[1] <= y) != (q[1] <= y):
            found.append(p[0] + (y - p[1]) * (q[0] - p[0]) / (q[1] - p[1]))
    return (min(found), max(found)) if found else None


scene = {'format': 'vidno-scene/1', 'name': name, 'window': {'x': left, 'y': top, 'width': width, 'height': height},
         'background': hexadecimal(background),
         'polygons': [{'id': i, 'color': hexadecimal(c), 'vertices': v} for i, c, v in polygons]}
events = [{'e': 'clear', 'at': 'Z1', 'color': hexadecimal(background), 'z': -2}]
picture = [[(background, -2.0)] * width for _ in range(height)]
for identity, paint, vertices in polygons:
    a, b, c, d = plane(vertices)
    if c == 0:
        continue
    events.append({'e': 'polygon', 'at': 'Z2', 'polygon': identity, 'color': hexadecimal(paint)})
    for row in range(height):
        y = top + row + 0.5
        met = ends(vertices, y)
        runs = []
        for column in range(width):
            x = left + column + 0.5
            z = -(a * x + b * y + d) / c
            if met and met[0] <= x < met[1] and z > picture[row][column][1]:
                picture[row][column] = (paint, z)
                runs.append([left + column, left + column + 1])
        if runs:
            events.append({'e': 'span', 'at': 'Z14', 'row': top + row, 'runs': runs})

pixels = bytes(part for row in picture for rgb, _ in row for part in rgb)
header = {'format': 'vidno-trace/1', 'method': 'zbuffer', 'edition': 'corrected', 'kernel': 'double', 'detail': 'windows',
          'scene': scene}
end = {'end': {'events': len(events), 'picture': 'sha256:' + hashlib.sha256(pixels).hexdigest()}}
with open(os.environ['VIDNO_TRACE'], 'w', encoding='utf-8') as file:
    for line in [header, *events, end]:
        print(json.dumps(line, ensure_ascii=False, separators=(',', ':')), file=file)
