#!/usr/bin/env python3
"""Checks that traces of all methods paint what they say, have the events of FORMAT.md, and decide as their operands say, and that this
is noticed after a change.

    run.py VIDNO LESSONS WORK FORMAT        the program, the folder of lessons, a folder for traces, FORMAT.md
"""

import json
import pathlib
import subprocess
import sys

sys.path.append(str(pathlib.Path(__file__).parents[2] / "lessons/proof"))
import decisions  # noqa: E402
import picture
import tables

COURSE = ["warnock", "zbuffer"]
CURVES = ["floating-horizon"]
LEVELS = ["windows", "polygons", "signs"]
EVERY_KERNEL = ["float", "double", "bits:9", "filtered", "exact"]


def runs(choices):
    """Yields scenes of the lessons, each with the options of a run. The choices are those of `vidno methods --json`."""
    methods = choices["methods"]
    family = [method for method in methods if method.startswith("warnock-")]
    others = [method for method in methods if method not in COURSE + family + CURVES]
    of_any_scene = [method for method in family if not methods[method]["domain"].startswith("closed")]
    bodies = "11-warnock-family/bodies.json"  # every method accepts it
    for method in COURSE + family + others:
        kernels = EVERY_KERNEL + (["grid:4"] if "grid" in methods[method]["editions"]["corrected"] else [])
        for place, kernel in enumerate(kernels):
            yield bodies, ["--method", method, "--kernel", kernel, "--detail", LEVELS[place % 3]]
        for level in LEVELS:
            yield bodies, ["--method", method, "--detail", level, "--check"]
        if method not in family or method in of_any_scene:
            for kernel in kernels:
                options = ["--method", method, "--kernel", kernel, "--detail", "signs", "--check"]
                yield "01-four-relations/cycle.json", options + ["--max-events", "1000"]
    for scene in ("09-usual-mistakes/mistakes.json", "01-four-relations/cycle.json"):
        for method in COURSE + of_any_scene + others:
            yield scene, ["--method", method, "--kernel", "float", "--detail", "windows"]
        for method in COURSE:
            for kernel in ("float", "double", "bits:9", "exact"):
                options = ["--method", method, "--kernel", kernel, "--edition", "printed"]
                yield scene, options + ["--detail", "polygons"]
        for method, about in methods.items():
            for edition in about["editions"]:
                if choices["editions"][edition]["isMistake"]:
                    yield scene, ["--method", method, "--edition", edition, "--detail", "windows"]
        yield scene, ["--method", "zbuffer", "--kernel", "depth:6", "--detail", "polygons"]
        yield scene, ["--method", "warnock", "--max-events", "40"]
    for scene in ("scene", "tie", "peak", "edges", "denser"):
        for place, kernel in enumerate(EVERY_KERNEL):
            options = ["--method", *CURVES, "--kernel", kernel, "--detail", LEVELS[place % 3]]
            yield f"15-floating-horizon/{scene}.json", options
            if kernel not in ("filtered", "exact"):
                yield f"15-floating-horizon/{scene}.json", options + ["--edition", "printed", "--check"]


def changed_paint(lines):
    """The lines with another colour, or another end, of what was painted last. None if nothing was."""
    for place in range(len(lines) - 2, 0, -1):
        event = json.loads(lines[place])
        name = event["e"]
        if name == "draw_line":
            event["to"][1] = "1/97" if isinstance(event["to"][1], str) else event["to"][1] + 1
        elif name == "span" and event["runs"]:
            place = max(i for i in range(1, place) if json.loads(lines[i])["e"] == "polygon")
            event = json.loads(lines[place])
            event["color"] = "#010203"
        elif name in ("draw", "paint") and event["runs"] or name == "fill" and 0 not in event["rect"][2:]:
            event["color"] = "#010203"
        else:
            continue
        return [*lines[:place], json.dumps(event), *lines[place + 1 :]]
    return None


def expect_refused(lines, what):
    try:
        picture.check(lines)
    except picture.Wrong:
        return
    raise AssertionError(f"taken: {what}")


def changed_decision(events):
    """The events with another right answer to their last decision. None if there is none."""
    for place in range(len(events) - 1, -1, -1):
        right = events[place].get("exact")
        if events[place].get("operands") and right is not None:
            other = [right[0] + 1, right[1] + 2] if isinstance(right, list) else not right
            return [*events[:place], {**events[place], "exact": other}, *events[place + 1 :]]
    return None


def check_events(format, lines, what):
    """Returns how many decisions were repeated."""
    header, *events = map(json.loads, lines)
    events = [event for event in events if "e" in event]
    try:
        format.check_events(header, events)
        count = decisions.check(format, header, events)
    except tables.Wrong as fault:
        raise AssertionError(what) from fault
    changed = changed_decision(events)
    if changed:
        try:
            decisions.check(format, header, changed)
        except tables.Wrong:
            return count
        raise AssertionError(f"taken: {what} with another right answer")
    return count


def check_trace(lines, what, partial):
    events = picture.check(lines)
    assert events == len(lines) - 2, what
    expect_refused(lines[:-1], f"{what} without its last line")
    expect_refused(lines[:-2] + lines[-1:], f"{what} without its last event")
    changed = None if partial else changed_paint(lines)
    if changed:
        expect_refused(changed, f"{what} with another paint")
    return bool(changed)


def main(vidno, lessons, work, format):
    format = tables.Tables(pathlib.Path(format).read_text(encoding="utf-8"))
    work = pathlib.Path(work)
    work.mkdir(parents=True, exist_ok=True)
    total = complete = changed = repeated = 0
    choices = json.loads(subprocess.run([vidno, "methods", "--json"], stdout=subprocess.PIPE, check=True).stdout)
    for scene, options in runs(choices):
        trace = work / ("trace.jsonl.gz" if total % 10 == 0 else "trace.jsonl")
        what = " ".join(["vidno", "trace", scene, *options])
        told = subprocess.run(
            [vidno, "trace", f"{lessons}/{scene}", *options, "-o", trace], stderr=subprocess.PIPE, text=True
        )
        lines = list(picture.lines_of(str(trace)))
        partial = "--max-events" in options and "partial" in json.loads(lines[-1])["end"]
        losses = ("the run ends here", "a part is left out", "the write is skipped", "leaves the range")
        expected = 1 if partial or any(loss in told.stderr for loss in losses) else 0
        assert told.returncode == expected, f"{what}\n{told.stderr}"
        changed += check_trace(lines, what, partial)
        repeated += check_events(format, lines, what)
        total += 1
        complete += not partial
    assert changed > complete * 9 // 10, "hardly anything was painted"
    assert repeated > 20000, "hardly anything was decided"
    print(f"{total} traces are what they say, {changed} are refused once another thing is painted")
    print(f"{repeated} decisions were repeated from their operands")


if __name__ == "__main__":
    main(*sys.argv[1:])
