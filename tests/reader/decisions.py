"""Repeats the decisions of a checked trace from their operands, as FORMAT.md says in *To redo a decision*."""

import math
from fractions import Fraction

from tables import expect

INFINITE = {"inf": math.inf, "-inf": -math.inf}
HALF = Fraction(1, 2)
# The field of an event that has its answer.
ANSWERS = {"box": "outside", "compare": "nearer", "insider": "inside", "orient": "sign", "clip_sign": "sign",
           "pixel": "shown", "visibility": "flag", "behind": "order", "order": "order"}
RELATIONS = [lambda a, b: a < b, lambda a, b: a <= b, lambda a, b: a > b, lambda a, b: a >= b, lambda a, b: a == b]


def sign(value):
    return (value > 0) - (value < 0)


def first_centre(x, low, end):
    return next((i for i in range(low, end) if i + HALF >= x), end)


def last_centre(x, low, end):
    return next((i for i in reversed(range(low, end)) if i + HALF <= x), low - 1)


def orientation(of):
    if "pivot.x" in of:
        a, b = [[of[f"{p}.x"] - of["pivot.x"], of[f"{p}.y"] - of["pivot.y"]] for p in "ab"]
        return sign(a[0] * b[1] - a[1] * b[0])
    return sign(of["line.a"] * (of["p.x"] - of["line.x"]) + of["line.b"] * (of["p.y"] - of["line.y"]))


def left_of(of):
    return orientation(of) == -sign(of["line.a"]) != 0


def parallel(of):
    if "p.x" in of:
        return of["p.a"] * of["q.b"] == of["p.b"] * of["q.a"]
    return all(of[f"q.{each}"] / of["q.c"] == of[f"p.{each}"] / of["p.c"] for each in "ab")


def comparison(of):
    if "p.x" in of:
        return sign(of["p.x"] - of["q.x"]) or sign(of["p.y"] - of["q.y"])
    return sign(of["a"] - of["b"])


def outside(of):
    return any([of["box.xmax"] < of["window.xmin"], of["box.ymax"] < of["window.ymin"],
                of["box.xmin"] > of["window.xmax"], of["box.ymin"] > of["window.ymax"]])


def inside(of):
    return all(of[f"window.{axis}min"] < of[f"box.{end}"] < of[f"window.{axis}max"] for axis in "xy"
               for end in (f"{axis}min", f"{axis}max"))


def outline(of):
    count = sum(name.endswith(".x") for name in of)
    return [(of[f"v{i}.x"], of[f"v{i}.y"]) for i in range(count)]


def between(ends, of):
    low, end = int(of["low"]), int(of["end"])
    return [first_centre(min(ends), low, end), last_centre(max(ends), low, end) + 1]


def rows(of):
    return between([y for _, y in outline(of)], of)


def columns(of):
    if "left" in of:
        low, end = int(of["low"]), int(of["end"])
        return [first_centre(of["left"], low, end), last_centre(of["right"], low, end) + 1]
    corners, y = outline(of), of["row"] + HALF
    ends = []
    for (px, py), (qx, qy) in zip(corners, corners[1:] + corners[:1]):
        if min(py, qy) <= y <= max(py, qy):
            ends += [px, qx] if py == qy else [px + (y - py) / (qy - py) * (qx - px)]
    return between(ends, of) if ends else [0, 0]


def visibility(of):
    above = "upper" not in of or of["y"] <= of["upper"]
    below = "lower" not in of or of["y"] >= of["lower"]
    return {(True, True): 2, (True, False): 1, (False, True): -1, (False, False): 0}[above, below]


REDONE = {
    "orientation": orientation,
    "left_of": left_of,
    "parallel": parallel,
    "nearer": lambda of: of["z"] > of["against"],
    "comparison": comparison,
    "outside": outside,
    "inside": inside,
    "first_centre": lambda of: first_centre(of["x"], int(of["low"]), int(of["end"])),
    "last_centre": lambda of: last_centre(of["x"], int(of["low"]), int(of["end"])),
    "columns": columns,
    "rows": rows,
    "visibility": visibility,
    "same_rounded": lambda of: math.floor(of["v"] + HALF) == math.floor(of["w"] + HALF),
    "pixel": lambda of: math.floor(of["v"]),
}


def redone(decision, operands, right):
    """The answer by the computed numbers, or by the right ones; None where it is undefined."""
    numbers = {}
    for name, computed, exact in operands:
        value = exact if right else computed
        if value is None or value == "nan":
            return None
        numbers[name] = INFINITE[value] if value in INFINITE else Fraction(value)
    try:
        return REDONE[decision](numbers)
    except ZeroDivisionError:
        return None


def same(decision, answer, told, is_printed=False):
    """Whether the program's answer is the repeated one. Empty ranges are the same, wherever they are."""
    if decision == "visibility" and is_printed and answer == 2:
        return told == 1
    if decision in ("columns", "rows") and isinstance(told, list):
        return answer == told or (answer[0] >= answer[1] and told[0] >= told[1])
    return answer == told


def check_disagreement(event):
    """A wrong answer is right for its operands if these had drifted, and otherwise wrong for them."""
    decision, taken, exact = event["of"], event["taken"], event["exact"]
    expect(taken != exact, "a disagreement of equals", event)
    if "operands" not in event:
        return 0
    by_computed, by_right = [redone(decision, event["operands"], right) for right in (False, True)]
    if decision == "comparison" and isinstance(taken, bool):
        # One relation gives the right answer and, of numbers that drifted, the taken one.
        expect(any(by_right is None or relation(by_right, 0) == exact and (event["cause"] == "rounded") != (
            relation(by_computed, 0) == taken) for relation in RELATIONS), "no relation gives both answers", event)
        return 1
    expect(by_right is None or same(decision, by_right, exact), f"{by_right} is right", event)
    if by_computed is not None:
        cause = "drifted" if same(decision, by_computed, taken) else "rounded"
        expect(event["cause"] == cause, f"the cause is {cause}", event)
    return 1


def check(tables, header, events):
    """Returns how many decisions of the checked events were repeated. Throws Wrong at one whose answer is another."""
    count = 0
    is_printed = header["edition"].startswith("printed")
    for place, event in enumerate(events):
        if event["e"] == "disagree":
            count += check_disagreement(event)
        decision = tables.events[event["e"]]["decides"]
        if not decision or "exact" not in event:
            continue
        name = ANSWERS.get(event["e"])
        taken = event[name] if name else [event["first"], event["end"]]
        is_followed = place + 1 == len(events) or events[place + 1]["e"] == "disagree"
        expect(event["exact"] is None or same(decision, taken, event["exact"]) or is_followed,
               "no disagreement follows a wrong answer", event)
        if "operands" not in event:
            continue
        by_right = redone(decision, event["operands"], True)
        expect(by_right is None or same(decision, by_right, event["exact"], is_printed),
               f"{by_right} is right", event)
        count += 1
    return count
