"""Repeats the decisions of a checked trace from their operands, by the formulas of lessons/proof/answers.py."""

import math
from fractions import Fraction

import answers
from tables import expect

INFINITE = {"inf": math.inf, "-inf": -math.inf}
# The field of an event that has its answer.
ANSWERS = {"box": "outside", "compare": "nearer", "insider": "inside", "orient": "sign", "clip_sign": "sign",
           "pixel": "shown", "visibility": "flag", "behind": "order", "order": "order"}


def redone(decision, operands, right):
    """The answer by the computed numbers, or by the right ones; None where it is undefined."""
    numbers = {}
    for name, computed, exact in operands:
        value = exact if right else computed
        if value is None or value == "nan":
            return None
        numbers[name] = INFINITE[value] if value in INFINITE else Fraction(value)
    try:
        return answers.answer(decision, numbers, Fraction)
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
            relation(by_computed, 0) == taken) for relation in answers.RELATIONS), "no relation gives both answers", event)
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
