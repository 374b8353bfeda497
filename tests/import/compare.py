"""Compares the program's readers of meshes with a second reader (reference.py), on files in all layouts (layouts.py).

    python3 tests/import/compare.py build/release/tests/import/vidno_mesh WORK 1000

writes so many files of each format to the folder WORK, reads all of them by both readers, and compares each with the mesh that the file was
made from; or, if the file is faulty, the line that the program names with that of the fault. `./dev test` reads 200 of each format. A further
argument is the first seed.
"""
import json
import pathlib
import shutil
import subprocess
import sys

import layouts
import reference


def agree(expected, told):
    """Whether two colours agree; one that rounding leaves open agrees with any."""
    return all(a == b or a == "any" for a, b in zip(expected["colors"], told["colors"]))


def fault_of(case, told):
    if "line" in case:
        if "refused" not in told:
            return "read, though its line %d is wrong" % case["line"]
        place = "line %d: " % case["line"] if case["line"] else "face "
        return None if told["refused"].startswith(place) else "not %r but %r" % (place, told["refused"])
    if "refused" in told:
        return told["refused"]
    second = dict(zip(["points", "faces", "colors", "groups"], reference.READERS[case["kind"]](case["bytes"], case.get("library"))))
    for reader, result in [("the program", told), ("the reference", second)]:
        for part in ["points", "faces", "groups"]:
            if case[part] != result[part]:
                return "%s has other %s: %r, not %r" % (reader, part, result[part], case[part])
        if not agree(case, result):
            return "%s has other colours: %r, not %r" % (reader, result["colors"], case["colors"])
    told_kinds = [loss.partition(": left out: ")[2].partition(" (")[0] for loss in told["losses"]]
    return None if told_kinds == case["losses"] else "losses: %r, not %r" % (told["losses"], case["losses"])


def main(program, work, count, first=0):
    folder = pathlib.Path(work)
    shutil.rmtree(folder, ignore_errors=True)
    cases = []
    for kind in layouts.FORMATS:
        for seed in range(first, first + count):
            case = dict(layouts.case(seed, kind), kind=kind)
            place = folder / kind / str(seed)
            place.mkdir(parents=True)
            case["file"] = place / case["name"]
            case["file"].write_bytes(case["bytes"])
            if "library" in case:
                (place / "materials.mtl").write_bytes(case["library"])
            cases.append(case)
    names = "".join("%s\n" % case["file"] for case in cases)
    told = subprocess.run([program], input=names, capture_output=True, text=True, check=True).stdout.splitlines()
    assert len(told) == len(cases)
    wrong = 0
    for case, line in zip(cases, told):
        fault = fault_of(case, json.loads(line))
        if fault:
            wrong += 1
            print("%s: %s" % (case["file"], fault))
    faulty = sum("line" in case for case in cases)
    print("%d files, %d of them faulty: %d are not read or refused as they should be" % (len(cases), faulty, wrong))
    return wrong


if __name__ == "__main__":
    sys.exit(main(sys.argv[1], sys.argv[2], *map(int, sys.argv[3:])) > 0)
