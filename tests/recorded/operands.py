#!/usr/bin/env python3
"""Checks that the checked traces of two programs differ only in their operands.

usage: operands.py OLD_PROGRAM NEW_PROGRAM SCENE...

Runs each scene by all methods that take it, under float, double, bits:9, filtered and exact, with --check at level signs. Removes the
field `operands` from the lines of the new program; the rest must be the bytes of the old program. The old program did not check
`columns`, so there the field `exact` is removed too, and a `disagree` about first_centre or last_centre may come one event later. Prints
how many traces are the same, and how many are the same except for `columns`.
"""
import json
import subprocess
import sys

METHODS = ["warnock", "zbuffer", "warnock-full", "warnock-angles", "weiler-atherton", "floating-horizon"]
KERNELS = ["float", "double", "bits:9", "filtered", "exact"]


def traced(program, scene, method, kernel):
    command = [program, "trace", scene, "--method", method, "--kernel", kernel, "--check", "--max-events", "20000", "-o", "-"]
    run = subprocess.run(command, capture_output=True, check=False)
    return run.stdout.decode().splitlines() if run.returncode in (0, 1) else None


def without_operands(line):
    at = line.find(',"operands":')
    return line if at < 0 else line[:at] + "}"


def but_for_columns(lines):
    """The lines, with `columns` without `exact`, and separately the `disagree` events about columns."""
    rest, apart = [], []
    for line in lines:
        event = json.loads(line)
        if event.get("e") == "columns":
            event.pop("exact", None)
            line = json.dumps(event)
        if event.get("e") == "disagree" and event["of"] in ("first_centre", "last_centre"):
            event.pop("at")
            apart.append(event)
        elif "end" not in event:
            rest.append(line if event.get("e") != "columns" else json.dumps(event))
    return rest, apart


def main(old_program, new_program, scenes):
    same = columns = 0
    for scene in scenes:
        for method in METHODS:
            for kernel in KERNELS:
                old = traced(old_program, scene, method, kernel)
                new = traced(new_program, scene, method, kernel)
                if old is None or new is None:
                    continue
                new = [without_operands(line) for line in new]
                if old == new:
                    same += 1
                elif but_for_columns(old) == but_for_columns(new):
                    columns += 1
                else:
                    sys.exit(f"{scene}, {method}, {kernel}: another trace")
    print(f"{same} traces are the old bytes without their operands, {columns} but for the truth of columns")


if __name__ == "__main__":
    if len(sys.argv) < 4:
        sys.exit(__doc__)
    main(sys.argv[1], sys.argv[2], sys.argv[3:])
