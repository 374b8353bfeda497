"""Reads the tables of FORMAT.md, and says whether the events of a trace are as these tables have them."""

import re
from fractions import Fraction

LEVELS = ["windows", "polygons", "signs"]
ROW = re.compile(r"\| `(\w+)` \| ([^|]*) \| ([wps]) \| ([^|]*) \| ([^|]*) \|")
FIELD = re.compile(r"(optionally )?`(\w+)`(?: (?!optionally)(.*?))?(?=, (?:optionally )?`\w+`|$)")
COLOUR = re.compile(r"#[0-9a-f]{6}")
FRACTION = re.compile(r"(-?\d+)/([1-9]\d*)")
INFINITE = ("inf", "-inf", "nan")


class Wrong(Exception):
    """An event that differs from what FORMAT.md says."""


def expect(holds, *what):
    if not holds:
        raise Wrong(": ".join(map(str, what)))


def is_fraction(value):
    """Whether the text is a reduced fraction."""
    match = FRACTION.fullmatch(value) if isinstance(value, str) else None
    return bool(match) and Fraction(value).denominator == int(match[2])


def is_int(value):
    return type(value) is int


def is_list_of(checks):
    return lambda value: isinstance(value, list) and len(value) == len(checks) and all(
        check(each) for check, each in zip(checks, value)
    )


def is_any_number_of(check):
    return lambda value: isinstance(value, list) and all(map(check, value))


class Values:
    """The values of FORMAT.md's second table, as a kernel has them in a scene."""

    def __init__(self, header, words):
        scene = header["scene"]
        exact = header["kernel"] == "exact"
        polygons = {polygon["id"] for polygon in scene.get("polygons", [])}
        area = [scene["window"][side] for side in ("x", "y", "width", "height")]

        def number(value):
            if value in INFINITE:
                return True
            return is_fraction(value) if exact else type(value) in (int, float)

        def double(value):
            return type(value) in (int, float) or number(value)

        def rect(value):
            x, y, width, height = value
            return all(map(is_int, value)) and width >= 0 and height >= 0 and x >= area[0] and y >= area[1] and \
                x + width <= area[0] + area[2] and y + height <= area[1] + area[3]

        def answer(value):
            return isinstance(value, bool) or is_int(value) or is_list_of([is_int] * 2)(value)

        def operand(value):
            name, computed, right = value
            return isinstance(name, str) and (is_fraction(computed) or computed in INFINITE) and (
                right is None or is_fraction(right) or right in INFINITE
            )

        point = is_list_of([double] * 2)
        region = is_any_number_of(is_any_number_of(point))
        run = is_any_number_of(is_int)
        self.named = {
            "N": number,
            "P": lambda value: value in polygons,
            "C": lambda value: bool(COLOUR.fullmatch(value)),
            "bool": lambda value: isinstance(value, bool),
            "int": is_int,
            "text": lambda value: isinstance(value, str),
            "window": is_list_of([double] * 4),
            "point": point,
            "vertex": is_list_of([double] * 3),
            "rect": rect,
            "runs": is_any_number_of(lambda value: run(value) and len(value) in (2, 3)),
            "edge": lambda value: is_int(value) and value >= 0,
            "sample": is_list_of([is_int, double]),
            "answer": answer,
            "operands": is_any_number_of(operand),
            "columns": is_list_of([is_int] * 2),
            "segment": is_list_of([is_int] * 2),
            "heights": is_any_number_of(is_list_of([is_int, number])),
            "region": region,
            "piece": is_list_of([lambda value: value in polygons, region, lambda value: isinstance(value, bool)]),
            "procedure": lambda value: value in words["procedures"],
            "decision": lambda value: value in words["decisions"],
            "corner": lambda value: value in ("lb", "lt", "rb", "rt"),
        }

    def check_of(self, text):
        """The check of a field that a table describes in such words as `[N, N]`, `0..4` or `int >= 1`."""
        if text in self.named:
            return self.named[text]
        if text.startswith('`"'):
            words = re.findall(r'"([^"]+)"', text)
            return lambda value: value in words
        if match := re.fullmatch(r"int >= (\d+)", text):
            return lambda value: is_int(value) and value >= int(match[1])
        if match := re.fullmatch(r"(-?\d+)\.\.(\d+)", text):
            return lambda value: is_int(value) and int(match[1]) <= value <= int(match[2])
        if re.fullmatch(r"-?\d+(, -?\d+)*", text):
            return lambda value: is_int(value) and value in map(int, text.split(", "))
        if match := re.fullmatch(r"\[(.*), \.\.\.\]", text):
            return is_any_number_of(self.check_of(match[1]))
        if match := re.fullmatch(r"\[(.*)\]", text):
            return is_list_of([self.check_of(each) for each in match[1].split(", ")])
        raise Wrong(f"FORMAT.md has a value without a meaning: {text}")


class Tables:
    def __init__(self, text):
        self.events = {}
        for name, lines, level, fields, says in ROW.findall(text):
            decides = re.search(r"decides `(\w+)`", says)
            self.events[name] = {
                "lines": None if lines == "any line" else lines.split(", "),
                "level": "wps".index(level),
                "fields": [(bool(maybe), field, value or field) for maybe, field, value in FIELD.findall(fields)],
                "decides": decides and decides[1],
            }
        procedures = re.findall(r"^\| (\w+) \| [ps] \| `", text, re.MULTILINE)
        decisions = set(re.findall(r"^\| `(\w+)`", text[text.index("## To redo a decision") : text.index("## The list of")],
                                   re.MULTILINE)) | {"first_centre", "last_centre"}
        self.words = {"procedures": procedures, "decisions": decisions}

    def check_events(self, header, events):
        """Throws Wrong at an event whose name, line, level or fields are not those of its table."""
        values = Values(header, self.words)
        checks = {text: values.check_of(text) for each in self.events.values() for _, _, text in each["fields"]}
        level = LEVELS.index(header["detail"])
        for event in events:
            about = self.events.get(event["e"])
            expect(about, "an event that is in no table", event)
            expect(about["level"] <= level, "an event of a higher level", event)
            expect(about["lines"] is None or event["at"] in about["lines"], "an event at another line", event)
            names = list(event)[2:]
            for maybe, field, text in about["fields"]:
                if names and names[0] == field:
                    value = event[names.pop(0)]
                    is_row = field in ("until", "next") and is_int(value)
                    expect(is_row or checks[text](value), f"{field} is no {text}", event)
                else:
                    expect(maybe, f"without {field}", event)
            allowed = ["exact", "operands", "by"] if about["decides"] else []
            expect(set(names) <= set(allowed), "further fields", event)
