#!/usr/bin/env python3
"""Lets lessons/proof/verify_decisions.py judge checked traces, right and changed ones.

    decisions.py VIDNO SCENES ROOT WORK [--runs N] [--changes N] [--events N] [--seed N] [--first N]

SCENES prints random scenes, ROOT is the repository, WORK a folder for files.

1. Scenes of the lessons, of the atlas and random ones are run by methods, kernels and editions in turn, N runs of at most N events.
   Nothing may contradict, and at least the shares below must be derived from the scene.
2. Traces are changed, N times, so that they no longer say what the run did. Each of these must be refused.
3. The program's exit status tells apart a right trace, a changed one, and a file that is no trace.
"""

import argparse
import collections
import copy
import gzip
import itertools
import json
import math
import pathlib
import random
import subprocess
import sys
import time
from fractions import Fraction

METHODS = ["warnock", "zbuffer", "warnock-full", "weiler-atherton", "warnock-simplest", "warnock-angles", "warnock-vertex",
           "warnock-edges", "warnock-bodies"]
KERNELS = ["float", "bits:6", "exact", "double", "filtered", "grid:3", "bits:11", "depth:5"]
EDITIONS = ["printed", "corrected", "y-flipped", "boundary-outside", "one-list", "printed:x-z5", "clip-order-reversed",
            "printed:x-w1+x-w2+x-w6", "depth-sign-reversed", "printed:x-z7", "integer-division", "printed:x-z1+x-z3+x-z6",
            "depths-not-cleared", "surround-kept", "printed:x-w5+x-w7+x-w8", "vertex-counted-twice", "line-for-edge",
            "octants-not-split", "printed:x-z2+x-z4", "printed:x-h1+x-h3+x-h4", "printed:x-h2+x-h5+x-h6"]
# The least share of the decisions of a method that follow from the scene: of Weiler and Atherton's algorithm, a trace does not tell on
# which lines a point lies, so that points that were rounded to one cannot be told apart.
LEAST_SHARE = collections.defaultdict(lambda: 1, {"weiler-atherton": Fraction(9, 10)})

failures = []
counts = collections.Counter()
shares = collections.defaultdict(collections.Counter)


def expect(is_so, *what):
    if not is_so:
        failures.append(" ".join(map(str, what)))


def traced(file, method, kernel, edition):
    """The lines of a checked trace; None if the method, the kernel or the edition does not take the scene."""
    options_of_run = ["--method", method, "--kernel", kernel, "--edition", edition, "--max-events", str(options.events)]
    command = [options.vidno, "trace", str(file), *options_of_run, "--check", "--detail", "signs", "-o", "-"]
    run = subprocess.run(command, capture_output=True, text=True, check=False)
    return run.stdout.splitlines() if run.returncode != 2 and run.stdout else None


def random_files():
    command = [options.scenes_program, str(options.first), str(options.runs)]
    printed = subprocess.run(command, capture_output=True, text=True, check=True)
    for number, line in enumerate(printed.stdout.splitlines(), options.first):
        file = options.work / f"random-{number}.json"
        file.write_text(line)
        yield file


def runs():
    """Files with the method, the kernel and the edition of a run, without end: all kinds of files in turn, the editions seldom."""
    lessons = [file for file in sorted(options.root.glob("lessons/[0-9]*/*.json")) if file.name != "lesson.json"]
    atlas = sorted(options.root.glob("lessons/failures/*.json"))
    randoms = list(random_files())
    draw = random.Random(options.seed)
    for turn in itertools.count():
        file = draw.choice([lessons, atlas, randoms][turn % 3])
        scene = json.loads(file.read_text(encoding="utf-8"))
        scene = scene.get("scene") or scene
        method = METHODS[turn // 3 % len(METHODS)] if "polygons" in scene else "floating-horizon"
        if method == "warnock-bodies":
            file = options.root / "lessons/11-warnock-family/bodies.json"
        edition = EDITIONS[turn // 7 % len(EDITIONS)] if turn % 7 == 0 else "corrected"
        kernels = KERNELS if edition == "corrected" else ["double", "float", "bits:6", "exact"]
        yield file, method, draw.choice(kernels), edition


def judge_runs():
    """Gives the runs whose traces have something to change, with their traces."""
    judged = []
    for file, method, kernel, edition in itertools.islice(runs(), 20 * options.runs):
        if counts["runs"] == options.runs:
            break
        lines = traced(file, method, kernel, edition)
        if lines is None:
            counts["refused by vidno"] += 1
            continue
        counts["runs"] += 1
        name = f"{file.name} {method} {kernel} {edition}"
        try:
            judge = verify(lines)
        except Contradiction as reason:
            expect(False, name, "contradicts:", reason)
            continue
        for each in judge.counts.values():
            shares[method].update(each)
        judged.append((name, method, kernel, [json.loads(line) for line in lines]))
    for method, share in shares.items():
        proved = share["proved"] + share["drifted"]
        expect(proved >= LEAST_SHARE[method] * share["all"], method, "has only", proved, "of", share["all"], "decisions proved")
    return judged


# Changes. Each takes a trace, changes it, and gives what it changed; None if it finds nothing to change.


def answer_fields(event):
    return REPORTED[event["e"]][1:] if event["e"] in REPORTED else ("taken",)


def another(draw, answer):
    if isinstance(answer, bool):
        return not answer
    return answer + draw.choice([-1, 1]) if isinstance(answer, int) else [answer[0], answer[1] + draw.choice([-1, 1])]


def some_event(draw, trace, is_wanted):
    found = [event for event in trace[1:-1] if is_wanted(event)]
    return draw.choice(found) if found else None


def changed_answer(draw, trace, method):
    event = some_event(draw, trace, lambda each: each.get("exact") is not None and "operands" in each)
    if event:
        field = draw.choice(answer_fields(event))
        if event["e"] == "disagree" and event["of"] == "comparison" and isinstance(event["taken"], bool):
            return None  # the relation of the line is not told
        event[field] = another(draw, event[field])
        return f"an answer of {event['e']}"


def changed_exact_answer(draw, trace, method):
    """The exact answer of a right decision, with the `disagree` that would follow."""
    event = some_event(draw, trace, lambda each: each.get("exact") is not None and "operands" in each and each["e"] != "disagree")
    if event:
        of, *fields = REPORTED[event["e"]]
        taken = event[fields[0]] if len(fields) == 1 else [event[field] for field in fields]
        if event["exact"] != taken:
            return None
        event["exact"] = another(draw, taken)
        told = {"e": "disagree", "at": event["at"], "of": of, "taken": taken, "exact": event["exact"], "cause": "drifted"}
        trace.insert(trace.index(event) + 1, told | {"operands": event["operands"]})
        return "an exact answer"


def has_known_operands(method):
    """Finds the events whose operands the verifier derives one by one. In Weiler and Atherton's algorithm these are only those at pixels."""
    return lambda event: "operands" in event and event["e"] in (["order"] if method == "weiler-atherton" else REPORTED)


def changed_operand_in_use(draw, trace, method):
    event = some_event(draw, trace, has_known_operands(method))
    operand = event and draw.choice(event["operands"])
    if not operand or "/" not in operand[1] or (method == "floating-horizon" and trace[0]["kernel"] == "filtered"):
        return None
    value = Fraction(operand[1])
    if draw.randrange(2):
        operand[1] = text_of(value + Fraction(1, 3))
    else:
        operand[1] = text_of(Fraction(math.nextafter(float(value), draw.choice([-math.inf, math.inf]))))
    return "an operand in use" if Fraction(operand[1]) != value else None


def changed_exact_operand(draw, trace, method):
    event = some_event(draw, trace, has_known_operands(method))
    operand = event and draw.choice(event["operands"])
    if not operand or operand[2] is None or "/" not in operand[2]:
        return None
    operand[2] = text_of(Fraction(operand[2]) + draw.choice([Fraction(1, 3), Fraction(-1, 2**60)]))
    return "an exact operand"


def changed_both_operands(draw, trace, method):
    """In use and exactly, so that nothing seems to have drifted."""
    event = some_event(draw, trace, has_known_operands(method))
    operand = event and draw.choice(event["operands"])
    if not operand or operand[2] is None or "/" not in operand[2]:
        return None
    operand[1] = operand[2] = text_of(Fraction(operand[2]) + Fraction(1, 64))
    return "both parts of an operand"


def swapped_cause(draw, trace, method):
    event = some_event(draw, trace, lambda each: each["e"] == "disagree" and "operands" in each)
    if event:
        event["cause"] = "drifted" if event["cause"] == "rounded" else "rounded"
        return "a cause"


# A decision that must come: without it the trace cannot go on as it does.
NEEDED = {"orient": ("S2", "S3", "TF2", "CR4", "OA4"), "box": ("PW3", "RE1", "WS3"), "compare": ("PW6", "PC4", "HP4"),
          "clip_sign": ("PL3", "PL4"), "row": ("F2",), "columns": ("L4",), "pixel": ("L6",), "visibility": ("FH4", "FH5")}  # fmt: skip


def dropped_decision(draw, trace, method):
    """With the `disagree` after it, and with the right number of events. Not the last events of a trace that was stopped."""
    whole = trace[1:-1] if "partial" not in trace[-1]["end"] else trace[1 : max(1, len(trace) - 60)]
    found = [event for event in whole if event["at"] in NEEDED.get(event["e"], ())]
    if not found:
        return None
    event = draw.choice(found)
    at = next(i for i, each in enumerate(trace) if each is event)
    del trace[at]
    while trace[at].get("e") == "disagree":
        del trace[at]
    trace[-1]["end"]["events"] = len(trace) - 2
    return f"{event['e']} dropped"


def dropped_disagree(draw, trace, method):
    """One that repeats the wrong answer of an event."""
    found = [i for i, event in enumerate(trace[:-2]) if event.get("e") in REPORTED and trace[i + 1].get("e") == "disagree"
             and trace[i + 1].get("operands") == event.get("operands") and "operands" in event]  # fmt: skip
    if not found:
        return None
    del trace[draw.choice(found) + 1]
    trace[-1]["end"]["events"] = len(trace) - 2
    return "a disagree dropped"


def changed_scene(draw, trace, method):
    """A coordinate of a vertex, or the height of a sample, that some decision needs."""
    scene = trace[0]["scene"]
    by = draw.choice([0.25, 2.0**-20])
    if method == "floating-horizon":
        event = some_event(draw, trace, lambda each: each["e"] == "visibility" and each["x"] in each["segment"])
        number = event and next(each["curve"] for each in reversed(trace[: trace.index(event)]) if each.get("e") == "curve")
        sample = event and next(each for each in scene["curves"][number] if each[0] == event["x"])
        if sample:
            sample[1] += by
        return "a sample" if sample else None
    polygons = {polygon["id"]: polygon for polygon in scene["polygons"]}
    if method == "zbuffer":
        event = some_event(draw, trace, lambda each: each["e"] == "edge")
        drawn = event and next(each for each in reversed(trace[: trace.index(event)]) if each.get("e") == "polygon")
        polygon = event and polygons[drawn["polygon"]]
    else:
        event = some_event(draw, trace, lambda each: each["e"] == "orient")
        polygon = event and polygons[event["polygon"]]
    if not event:
        return None
    vertex = polygon["vertices"][event["edge"]]
    axis = draw.randrange(2)
    changed = vertex[axis] + by
    rounded = Kernel(trace[0]["kernel"]).rounded
    # A trace has the edges of the Z-buffer in rounded numbers, and an edge may lie beside the area, where no decision needs it.
    is_seen = rounded(changed) != rounded(vertex[axis]) and trace[0]["kernel"] not in ("filtered", "grid:3")
    if changed == vertex[axis] or (method == "zbuffer" and not is_seen):
        return None
    vertex[axis] = changed
    return "a coordinate"


def changed_depths(draw, trace, method):
    """Those of all vertices of a polygon, so that it stays planar."""
    event = some_event(draw, trace, lambda each: each["e"] in ("compare", "pixel", "order") and "operands" in each)
    if not event or event["operands"][0][2] is None:
        return None
    before = reversed(trace[: trace.index(event)])
    polygon = event.get("polygon") or next(each for each in before if each.get("e") == "polygon")["polygon"]
    for vertex in next(each for each in trace[0]["scene"]["polygons"] if each["id"] == polygon)["vertices"]:
        vertex[2] += 0.25
    return "the depths of a polygon"


CHANGES = [changed_answer, changed_exact_answer, changed_operand_in_use, changed_exact_operand, changed_both_operands, swapped_cause,
           dropped_decision, dropped_disagree, changed_scene, changed_depths]


def change_traces(judged):
    draw = random.Random(options.seed)
    for turn in itertools.count():
        if counts["changes"] == options.changes or turn > 20 * options.changes:
            break
        name, method, kernel, trace = draw.choice(judged)
        changed = copy.deepcopy(trace)
        what = CHANGES[turn % len(CHANGES)](draw, changed, method)
        if what is None:
            continue
        counts.update(["changes", "changed: " + what])
        try:
            verify(map(json.dumps, changed))
        except Contradiction:
            continue
        (options.work / "accepted.jsonl").write_text("".join(json.dumps(line) + "\n" for line in changed))
        expect(False, name, "is accepted with", what, "changed")


def run_the_program(judged):
    trace = next(trace for _, method, _, trace in judged if method == "warnock")
    program = options.root / "lessons/proof/verify_decisions.py"
    packed, changed, broken = (options.work / name for name in ("trace.jsonl.gz", "changed.jsonl", "broken.jsonl"))
    with gzip.open(packed, "wt") as file:
        file.writelines(json.dumps(line) + "\n" for line in trace)
    wrong = copy.deepcopy(trace)
    changed_answer(random.Random(0), wrong, "warnock")
    changed.write_text("".join(json.dumps(line) + "\n" for line in wrong))
    broken.write_text(json.dumps(trace[0]) + "\n")
    for file, status in ((packed, 0), (changed, 1), (broken, 2), (options.work / "missing.jsonl", 2)):
        run = subprocess.run([sys.executable, "-B", program, file], capture_output=True, text=True, check=False)
        expect(run.returncode == status, file.name, "has the exit status", run.returncode, run.stdout[-200:], run.stderr[-200:])
        expect((status == 1) == run.stdout.startswith("line "), file.name, "names a contradiction, or none:", run.stdout[:200])


parser = argparse.ArgumentParser()
parser.add_argument("vidno")
parser.add_argument("scenes_program")
parser.add_argument("root", type=pathlib.Path)
parser.add_argument("work", type=pathlib.Path)
parser.add_argument("--runs", type=int, default=600)
parser.add_argument("--changes", type=int, default=2000)
parser.add_argument("--events", type=int, default=1500)
parser.add_argument("--seed", type=int, default=1)
parser.add_argument("--first", type=int, default=0, help="the first random scene")
options = parser.parse_args()
options.work.mkdir(parents=True, exist_ok=True)
sys.path.insert(0, str(options.root / "lessons/proof"))
from chain import Contradiction  # noqa: E402
from judge import REPORTED  # noqa: E402
from kernel import Kernel  # noqa: E402
from verify_decisions import verify  # noqa: E402


def text_of(fraction):
    return f"{fraction.numerator}/{fraction.denominator}"


started = time.monotonic()
judged_traces = judge_runs()
change_traces(judged_traces)
run_the_program(judged_traces)
for key, count in sorted(counts.items()):
    print(f"{count:7} {key}")
for method, share in sorted(shares.items()):
    print(f"{method}: {share['proved']} proved, {share['drifted']} drifted, {share['not told']} not told, {share['wrong']} wrong")
print(f"{time.monotonic() - started:.0f} s")
for failure in failures[:20]:
    print(failure[:600], file=sys.stderr)
sys.exit(1 if failures else 0)
