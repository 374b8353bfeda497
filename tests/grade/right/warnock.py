#!/usr/bin/env python3
"""Warnock's algorithm, right, in another language and in exact fractions: it splits all windows down to pixels except empty ones."""
import hashlib
import json
import os
from fractions import Fraction

with open(os.environ['VIDNO_SCENE'], encoding='utf-8') as file:
    lines = iter(file.read().split('\n'))


def words():
    return next(lines).split()


name = next(lines)[1:]
area = [int(word) for word in words()]
left, top, width, height = area
background = [int(word) for word in words()]
polygons = []
for _ in range(int(words()[0])):
    identity, paint = next(lines)[1:], [int(word) for word in words()]
    polygons.append((identity, paint, [[float(word) for word in words()] for _ in range(int(words()[0]))]))


def hexadecimal(rgb):
    return '#%02x%02x%02x' % tuple(rgb)


def cross(o, a, b):
    return (a[0] - o[0]) * (b[1] - o[1]) - (a[1] - o[1]) * (b[0] - o[0])


class Convex:
    """A polygon in fractions. The largest triangle of its fan gives its plane."""

    def __init__(self, colour, vertices):
        self.colour = colour
        self.vertices = [[Fraction(number) for number in v] for v in vertices]
        o = self.vertices[0]
        fans = [(o, p, q) for p, q in zip(self.vertices[1:], self.vertices[2:])]
        self.triangle = max(fans, key=lambda fan: abs(cross(*fan)))
        self.area = cross(*self.triangle)

    def holds(self, point):
        sides = [cross(p, q, point) for p, q in zip(self.vertices, self.vertices[1:] + self.vertices[:1])]
        return all(side >= 0 for side in sides) or all(side <= 0 for side in sides)

    def depth(self, point):
        p, q, r = self.triangle
        return (cross(q, r, point) * p[2] + cross(r, p, point) * q[2] + cross(p, q, point) * r[2]) / self.area

    def meets(self, x, y, side):
        xs, ys = [v[0] for v in self.vertices], [v[1] for v in self.vertices]
        return min(xs) < x + side and max(xs) > x and min(ys) < y + side and max(ys) > y


shapes = [shape for shape in (Convex(c, v) for _, c, v in polygons) if shape.area != 0]
events = []
picture = {}


def fill(line, x, y, side, colour):
    right, bottom = min(x + side, left + width), min(y + side, top + height)
    for row in range(y, bottom):
        for column in range(x, right):
            picture[column, row] = colour
    events.append({'e': 'fill', 'at': line, 'rect': [x, y, right - x, bottom - y], 'color': hexadecimal(colour)})


def draw(x, y, side, candidates):
    if x >= left + width or y >= top + height:
        return
    push = {'e': 'push', 'at': 'W13' if events else 'W3', 'window': [x, y, side, side]}
    if not events:
        push['apl'] = [[identity, False] for identity, _, _ in polygons]
    events.append(push)
    events.append({'e': 'pop', 'at': 'W5', 'window': [x, y, side, side]})
    here = [shape for shape in candidates if shape.meets(x, y, side)]
    if not here:
        events.append({'e': 'decide', 'at': 'W7', 'case': 'empty'})
        fill('W7', x, y, side, background)
    elif side == 1:
        events.append({'e': 'decide', 'at': 'W9', 'case': 'pixel'})
        centre = (x + Fraction(1, 2), y + Fraction(1, 2))
        shown = [shape for shape in here if shape.holds(centre)]
        fill('W9', x, y, 1, max(shown, key=lambda shape: shape.depth(centre)).colour if shown else background)
    else:
        events.append({'e': 'decide', 'at': 'W13', 'case': 'split'})
        for dx in (0, side // 2):
            for dy in (0, side // 2):
                draw(x + dx, y + dy, side // 2, here)


side = 1
while side < max(width, height):
    side *= 2
draw(left, top, side, shapes)

scene = {'format': 'vidno-scene/1', 'name': name, 'window': dict(zip(('x', 'y', 'width', 'height'), area)),
         'background': hexadecimal(background),
         'polygons': [{'id': i, 'color': hexadecimal(c), 'vertices': v} for i, c, v in polygons]}
pixels = bytes(part for row in range(top, top + height) for column in range(left, left + width) for part in picture[column, row])
header = {'format': 'vidno-trace/1', 'method': 'warnock', 'edition': 'corrected', 'kernel': 'double', 'detail': 'windows',
          'scene': scene}
end = {'end': {'events': len(events), 'picture': 'sha256:' + hashlib.sha256(pixels).hexdigest()}}
with open(os.environ['VIDNO_TRACE'], 'w', encoding='utf-8') as file:
    for line in [header, *events, end]:
        print(json.dumps(line, ensure_ascii=False, separators=(',', ':')), file=file)
