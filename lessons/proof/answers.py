"""The answer of a decision from its operands, as trace/FORMAT.md, "To redo a decision", states it.

The formulas are the same for every kind of number. With exact fractions the answer is exact; with rounded numbers it is that of the
run. `number(double)` makes a number of that kind.
"""

import bisect
import math
import operator

# The answer yes or no to a comparison says whether the relation of the line holds, one of these.
RELATIONS = (operator.lt, operator.gt, operator.le, operator.ge, operator.eq)
LEAST_PIXEL, MOST_PIXEL = -(2**30) - 1, 2**30 + 16384 + 1


def sign(value):
    plain = getattr(value, "value", value)
    return int(plain > 0) - int(plain < 0)


def turn(pivot, a, b):
    return (a[0] - pivot[0]) * (b[1] - pivot[1]) - (a[1] - pivot[1]) * (b[0] - pivot[0])


def side(a, b, on, p):
    return a * (p[0] - on[0]) + b * (p[1] - on[1])


def first_centre(x, low, end, number):
    """The first i of low to end - 1 with i + 1/2 >= x; end, if there is none; low, if x is not a number."""
    if not x > number(low + 0.5):
        return low
    return low + bisect.bisect_left(range(low, end), x, key=lambda i: number(i + 0.5))


def last_centre(x, low, end, number):
    """The last i of low to end - 1 with i + 1/2 <= x; low - 1, if there is none or x is not a number."""
    if not x >= number(low + 0.5):
        return low - 1
    return low + bisect.bisect_right(range(low, end), x, key=lambda i: number(i + 0.5)) - 1


def between_centres(left, right, low, end, number):
    return [first_centre(left, low, end, number), last_centre(right, low, end, number) + 1]


def columns(outline, row, low, end, number):
    """Where the outline meets the line of the row's centres, and between which columns."""
    y = number(row + 0.5)
    met = []
    for p, q in zip(outline[-1:] + outline[:-1], outline):
        upper, lower = (p, q) if p[1] < q[1] else (q, p)
        met += [end_point[0] for end_point in (upper, lower) if end_point[1] == y]
        if upper[1] < y < lower[1]:
            met.append(upper[0] + (y - upper[1]) * (lower[0] - upper[0]) / (lower[1] - upper[1]))
    return between_centres(*((min(met), max(met)) if met else (number(1), number(0))), low, end, number)


def is_outside(box, window):
    return box[2] < window[0] or box[3] < window[1] or box[0] > window[2] or box[1] > window[3]


def is_inside(box, window):
    return box[0] > window[0] and box[1] > window[1] and box[2] < window[2] and box[3] < window[3]


def order(p, q):
    return sign(p[0] - q[0]) or sign(p[1] - q[1])


def visibility(y, upper, lower, flag_on_both):
    """Heights grow downward. Without a horizon the point is beyond it."""
    above = upper is None or not y > upper
    below = lower is None or not y < lower
    return flag_on_both if above and below else 1 if above else -1 if below else 0


def same_rounded(v, w, number):
    return math.floor(v + number(0.5)) == math.floor(w + number(0.5))


def pixel(v):
    return max(LEAST_PIXEL, min(MOST_PIXEL, math.floor(v)))


def answer(of, n, number, relation=None, flag_on_both=2):
    """The answer of a decision of the kind `of`; `n` has the operands by name. A division by zero raises ZeroDivisionError."""

    def point(name):
        return n[name + ".x"], n[name + ".y"]

    def box(name):
        return [n[f"{name}.{end}"] for end in ("xmin", "ymin", "xmax", "ymax")]

    def outline():
        return [point(f"v{i}") for i in range(sum(name[0] == "v" for name in n) // 2)]

    def of_line():
        return sign(side(n["line.a"], n["line.b"], point("line"), point("p")))

    def whole(*names):
        return [int(getattr(n[name], "value", n[name])) for name in names]

    if of == "orientation":
        return sign(turn(point("pivot"), point("a"), point("b"))) if "pivot.x" in n else of_line()
    if of == "left_of":
        return of_line() != 0 and of_line() == -sign(n["line.a"])
    if of == "parallel" and "p.c" not in n:
        return sign(n["p.a"] * n["q.b"] - n["p.b"] * n["q.a"]) == 0
    if of == "parallel":
        return all(sign(n["q." + axis] / n["q.c"] - n["p." + axis] / n["p.c"]) == 0 for axis in "ab")
    if of == "nearer":
        return n["z"] > n["against"]
    if of == "comparison":
        if relation:
            return relation(n["a"], n["b"])
        return order(point("p"), point("q")) if "p.x" in n else sign(n["a"] - n["b"])
    if of in ("outside", "inside"):
        return (is_outside if of == "outside" else is_inside)(box("box"), box("window"))
    if of in ("first_centre", "last_centre"):
        return (first_centre if of == "first_centre" else last_centre)(n["x"], *whole("low", "end"), number)
    if of == "rows":
        heights = [y for _, y in outline()]
        return between_centres(min(heights), max(heights), *whole("low", "end"), number)
    if of == "columns":
        if "left" in n:
            return between_centres(n["left"], n["right"], *whole("low", "end"), number)
        return columns(outline(), *whole("row", "low", "end"), number)
    if of == "visibility":
        return visibility(n["y"], n.get("upper"), n.get("lower"), flag_on_both)
    if of == "same_rounded":
        return same_rounded(n["v"], n["w"], number)
    if of == "pixel":
        return pixel(n["v"])
    raise ValueError(f"no rule for a decision of the kind {of}")
