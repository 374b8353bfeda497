#!/usr/bin/env python3
"""Redoes every decision of a checked trace: python3 verify_decisions.py TRACE.jsonl[.gz]

`vidno trace SCENE --check --detail signs -o TRACE.jsonl` writes such a trace. Each answer is computed anew from the operands beside it,
and the operands from the scene and from the decisions before. README.md explains what is printed. The exit status is 0 if nothing
contradicts, 1 with the first contradiction, and 2 if the file cannot be read as a trace.
"""

import collections
import gzip
import json
import sys

from chain import Contradiction, expect
from judge import Judge

COLUMNS = ("all", "proved", "drifted", "not told", "wrong")


def opened(file):
    with open(file, "rb") as given:
        is_packed = given.read(2) == b"\x1f\x8b"
    return gzip.open(file, "rt", encoding="utf-8") if is_packed else open(file, encoding="utf-8")


def verify(lines):
    """The Judge that has heard the lines of a trace. Raises Contradiction, or an error of another kind for something else than a trace."""
    lines = iter(lines)
    header = json.loads(next(lines, "{}"))
    if header.get("format") != "vidno-trace/1" or header.get("detail") != "signs":
        raise ValueError("not a trace of level signs")
    judge, events, last = Judge(header), 0, None
    for number, text in enumerate(lines, 2):
        event = json.loads(text)
        at = f"line {number}: {event.get('e', 'end')} {event.get('at', '')}".rstrip()
        try:
            expect(last is None, "something comes after the last line")
            if "e" in event:
                events += 1
                judge.hear(number, event)
                continue
            last = event["end"]
            expect(last["events"] == events, f"the trace has {events} events, not {last['events']}")
            if "partial" not in last:
                judge.expect_disagree()
        except Contradiction as reason:
            raise Contradiction(f"{at}: {reason}") from None
        except (KeyError, IndexError, AttributeError, TypeError, ValueError) as error:
            raise Contradiction(f"{at}: it cannot follow the events before ({error!r})") from None
    if last is None:
        raise ValueError("the file was cut short")
    return judge


def table(judge):
    total = collections.Counter()
    rows = [("decision", "line", *COLUMNS)]
    for (of, at), counts in sorted(judge.counts.items()):
        total.update(counts)
        rows.append((of, at, *(counts[column] for column in COLUMNS)))
    rows.append(("total", "", *(total[column] for column in COLUMNS)))
    widths = [max(len(str(row[i])) for row in rows) for i in range(len(rows[0]))]
    for row in rows:
        yield "  ".join(str(cell).ljust(width) if i < 2 else str(cell).rjust(width) for i, (cell, width) in enumerate(zip(row, widths)))
    for (of, at), first in sorted(judge.first_drifts.items()):
        yield f"drifted: {of} {at}, first in {first}"
    for (of, at, reason), count in sorted(judge.reasons.items()):
        yield f"not told: {of} {at}, {count} times: {reason}"
    yield f"Nothing contradicts. {total['proved'] + total['drifted']} of {total['all']} decisions follow from the scene."


def main(arguments):
    if len(arguments) != 1:
        print(__doc__, file=sys.stderr)
        return 2
    try:
        with opened(arguments[0]) as lines:
            judge = verify(lines)
    except Contradiction as reason:
        print(reason)
        return 1
    except (OSError, EOFError, ValueError, KeyError, TypeError) as error:
        print(f"{arguments[0]}: {error}", file=sys.stderr)
        return 2
    print(*table(judge), sep="\n")
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
