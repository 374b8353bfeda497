#!/usr/bin/env python3
"""Proves pictures, and lets the three checkers of lessons/proof judge proofs, right and changed ones.

    run.py VIDNO SCENES VERIFY ROOT WORK [--scenes N] [--changes N] [--pixels N] [--seed N] [--first N]

SCENES prints random scenes, VERIFY is the compiled verify.cpp, ROOT the repository, WORK a folder for files.

0. The proof by hand of lesson 16 is accepted, in each language. With the lesson's wrong picture it is not.
1. Scenes of the lessons, of the atlas, of meshes and random ones, N of these, are drawn by methods and kernels in turn. A picture gets a
   proof, which all checkers accept, if and only if it is right; of a wrong one each wrong pixel is named.
2. Proofs, pictures and scenes are changed, N times. Each checker accepts what truth.py says is still true, and nothing else.
3. At N pixels, the changes that `vidno why` names are made a little smaller and a little larger: the smaller ones change nothing there,
   and the larger ones do what it says.
"""

import argparse
import collections
import copy
import json
import math
import pathlib
import random
import re
import struct
import subprocess
import sys
import time
import zlib

from checkers import Checkers
from truth import Fraction, Polygon, Scene, centre, is_true, owner

METHODS = ["warnock", "zbuffer", "warnock-simplest", "warnock-full", "warnock-angles", "warnock-vertex", "warnock-edges",
           "weiler-atherton"]
KERNELS = ["double", "float", "bits:9", "filtered", "exact", "grid:4"]

failures = []
counts = collections.Counter()


def expect(is_so, *what):
    if not is_so:
        failures.append(" ".join(str(each) for each in what))


def vidno(*arguments):
    return subprocess.run([options.vidno, *map(str, arguments)], capture_output=True, text=True)


def lines_of(proof):
    return [json.loads(line) for line in proof.splitlines()]


def header(scene):
    return b"P6\n%d %d\n255\n" % (scene["window"]["width"], scene["window"]["height"])


def png(scene, rgb):
    """The picture as a PNG whose rows are of all kinds in turn."""
    width, height = scene["window"]["width"], scene["window"]["height"]
    above, packed = bytes(3 * width), b""
    for row in range(height):
        line = rgb[3 * width * row : 3 * width * (row + 1)]
        left, corner = bytes(3) + line[:-3], bytes(3) + above[:-3]
        nearest = [min(at, key=lambda each: abs(at[0] + at[1] - at[2] - each)) for at in zip(left, above, corner)]
        means = [(a + b) // 2 for a, b in zip(left, above)]
        kind = row % 5
        predicted = [bytes(3 * width), left, above, means, nearest][kind]
        packed += bytes([kind, *((each - guess) % 256 for each, guess in zip(line, predicted))])
        above = line
    image = struct.pack(">II5B", width, height, 8, 2, 0, 0, 0)
    parts = [b"IHDR" + image, b"IDAT" + zlib.compress(packed), b"IEND"]
    written = [struct.pack(">I", len(part) - 4) + part + struct.pack(">I", zlib.crc32(part)) for part in parts]
    return b"\x89PNG\r\n\x1a\n" + b"".join(written)


def check_proof(name, scene_file, picture_file, proof_file):
    for checker, (accepts, said) in checkers.verdicts(scene_file, picture_file, proof_file).items():
        expect(accepts, name, "verify." + checker, "refuses a proof:", said)


def prove_run(name, file, method, kernel, right):
    """Proves the picture of a run. `right` has the rows of the right picture; None if the reference would take too long."""
    plain, picture, proof = work / "plain.json", work / "run.ppm", work / "proof.jsonl"
    run = ["--method", method, "--kernel", kernel, "--edition", "corrected"]
    drawn = vidno("render", file, *run, "-o", picture)
    if drawn.returncode == 2:
        return counts.update(["refused"])
    shown = picture.read_bytes()[-len(right) :] if right else None
    is_right = shown == right
    proof.unlink(missing_ok=True)
    # By the run itself or by its picture, PPM or PNG, in turn.
    if counts["pictures"] % 4 < 2:
        picture = work / "run.png"
        vidno("render", file, *run, "-o", picture)
    way = run if counts["pictures"] % 2 else ["--picture", picture]
    made = vidno("prove", file, *way, "--scene", plain, "-o", proof)
    counts.update(["pictures", "right" if is_right else "wrong"])
    expect(made.returncode == (0 if is_right else 1), name, method, kernel, "exit", made.returncode, made.stderr)
    expect(proof.exists() == is_right, name, method, kernel, "a proof of a wrong picture, or none of a right one")
    if is_right and proof.exists():
        check_proof(f"{name} {method} {kernel}", plain, picture, proof)
    else:
        wrong = sum(shown[i : i + 3] != right[i : i + 3] for i in range(0, len(right), 3))
        named = sum(line.startswith("pixel ") for line in made.stdout.splitlines())
        expect(named == wrong, name, method, kernel, "names", named, "wrong pixels, not", wrong)


def right_picture(file):
    """By the reference, of the scene as the checkers read it; None if that would take too long."""
    plain, proof = work / "plain.json", work / "proof.jsonl"
    vidno("prove", file, "--kernel", "exact", "--edition", "corrected", "--scene", plain, "-o", proof)
    scene = json.loads(plain.read_text())
    if len(scene["polygons"]) * scene["window"]["width"] * scene["window"]["height"] > options.most_work:
        return None
    return Scene(scene).rgb()


def runs_in_turn(count):
    """The next runs of all pairs of a method and a kernel."""
    for _ in range(count):
        turn = counts["turns"]
        counts["turns"] += 1
        yield METHODS[turn % len(METHODS)], KERNELS[turn // len(METHODS) % len(KERNELS)]


def prove_by_hand():
    lesson = options.root / "lessons/16-proof"
    scene, right, wrong, proof = lesson / "scene.json", work / "right.ppm", work / "wrong.ppm", work / "by-hand.jsonl"
    truth = json.loads(scene.read_text(encoding="utf-8"))
    right.write_bytes(header(truth) + Scene(truth).rgb())
    vidno("render", scene, "--method", "zbuffer", "--kernel", "bits:4", "-o", wrong)
    for story in sorted(lesson.glob("story.*.md")):
        (lines,) = re.findall(r'^```\n(\{"format":"vidno-proof/1"\}\n.*?)^```$', story.read_text(encoding="utf-8"), re.S | re.M)
        proof.write_text(lines)
        counts["proofs by hand"] += 1
        check_proof(story.name, scene, right, proof)
        for checker, (accepts, _) in checkers.verdicts(scene, wrong, proof).items():
            expect(not accepts, story.name, "verify." + checker, "accepts the wrong picture")


def prove_files():
    lessons = [file for file in sorted(options.root.glob("lessons/[0-9]*/*.json")) if file.name != "lesson.json"]
    atlas = sorted(options.root.glob("lessons/failures/*.json"))
    for file in options.some(lessons + atlas):
        text = json.loads(file.read_text(encoding="utf-8"))
        scene = text.get("scene", text)
        if "polygons" not in scene:
            continue
        counts["files"] += 1
        right = right_picture(file)
        for method, kernel in runs_in_turn(2):
            prove_run(file.name, file, method, kernel if right else "exact", right)


def prove_meshes(sizes):
    mesh = options.root / "lessons/meshes/teapot.obj"
    for size in sizes:
        for eye in ((3, 4, 6), (-5, 1, 3), (0, 7, 0.1)):
            scene = work / "mesh.json"
            vidno("import", mesh, "--width", size, "--height", size, "--eye", *eye, "--fov", "60", "-o", scene)
            counts["meshes"] += 1
            prove_run(f"teapot {size} {eye}", scene, "zbuffer", "exact", None)


def random_scenes(first, count):
    printed = subprocess.run([options.scenes_program, str(first), str(count)], capture_output=True, text=True, check=True)
    return [json.loads(line) for line in printed.stdout.splitlines()]


def prove_random_scenes():
    for number, scene in enumerate(random_scenes(options.first, options.scenes), options.first):
        counts["random scenes"] += 1
        file = work / "scene.json"
        file.write_text(json.dumps(scene))
        right = Scene(scene).rgb()
        for method, kernel in runs_in_turn(2):
            prove_run(f"random scene {number}", file, method, kernel, right)


def moved_by_an_ulp(draw, scene):
    polygon = draw.choice(scene["polygons"])
    vertex = draw.choice(polygon["vertices"])
    axis = draw.randrange(3)
    vertex[axis] = math.nextafter(vertex[axis], draw.choice([-math.inf, math.inf]))
    return "a coordinate by one ulp"


def changed_scene(draw, scene):
    if draw.randrange(4):
        return moved_by_an_ulp(draw, scene)
    polygons = scene["polygons"]
    i, k = draw.randrange(len(polygons)), draw.randrange(len(polygons))
    polygons[i], polygons[k] = polygons[k], polygons[i]
    return "two polygons in another order"


def changed_picture(draw, scene, rgb):
    pixel = draw.randrange(len(rgb) // 3)
    colors = [scene["background"], *(polygon["color"] for polygon in scene["polygons"])]
    rgb[3 * pixel : 3 * pixel + 3] = bytes.fromhex(draw.choice(colors)[1:])
    return "a pixel"


def changed_proof(draw, scene, lines):
    count = len(scene["polygons"])
    number = draw.randrange(1, len(lines))
    line = lines[number]
    kinds = ["rectangle", "rectangle", "negative", "dropped", "doubled", "swapped"]
    kinds += [kind for kind in ("owner", "edge_on", "beside", "behind") if kind in line and line[kind] != []]
    kind = draw.choice(kinds)
    if kind == "rectangle":
        place = draw.randrange(4)
        line["rectangle"][place] += draw.choice([-1, 1])
        return "a rectangle"
    if kind == "negative":
        # Its sides have another sign, so their product stays as it is.
        x, y, width, height = line["rectangle"]
        line["rectangle"] = [x + width, y + height, -width, -height]
        return "a rectangle of negative sides"
    if kind == "dropped":
        del lines[number]
        return "a line dropped"
    if kind == "doubled":
        lines.insert(number, copy.deepcopy(line))
        return "a line doubled"
    if kind == "swapped":
        other = draw.randrange(1, len(lines))
        lines[number], lines[other] = lines[other], line
        return "two lines in another order"
    if kind == "owner":
        line["owner"] = draw.choice([None, *range(-1, count)])
        return "an owner"
    reason = draw.randrange(len(line[kind]))
    if draw.randrange(4) == 0:
        del line[kind][reason]
        return "a reason dropped"
    if kind == "edge_on":
        line[kind][reason] = draw.randrange(-1, count)
        return "the polygon of a reason"
    place = draw.randrange(2)
    if kind == "beside" and place == 1:
        line[kind][reason][1] = draw.randrange(len(scene["polygons"][line[kind][reason][0]]["vertices"]) + 1)
        return "an edge"
    line[kind][reason][place] = draw.randrange(-1, count)
    return "the polygon in front" if place else "the polygon of a reason"


def change_proofs():
    draw = random.Random(options.seed)
    files = work / "changed.json", work / "changed.picture", work / "changed.jsonl"
    each = 25
    made = 0
    for first, scene in enumerate(random_scenes(100000, 2 * options.changes // each + 1), 100000):
        if made == options.changes:
            break
        files[0].write_text(json.dumps(scene))
        truth = Scene(scene)
        rgb = truth.rgb()
        first_picture = work / "changed.ppm"
        first_picture.write_bytes(header(scene) + rgb)
        if not scene["polygons"] or vidno("prove", files[0], "--picture", first_picture, "-o", files[2]).returncode != 0:
            expect(not scene["polygons"], "no proof of scene", first)
            continue
        lines = lines_of(files[2].read_text())
        expect(is_true(truth, rgb, lines), "truth.py refuses the proof of scene", first)
        for _ in range(min(each, options.changes - made)):
            made += 1
            changed, pixels, proof = copy.deepcopy(scene), bytearray(rgb), copy.deepcopy(lines)
            what = draw.choice([lambda: changed_scene(draw, changed), lambda: changed_picture(draw, scene, pixels),
                                *[lambda: changed_proof(draw, scene, proof)] * 4])()
            files[0].write_text(json.dumps(changed))
            files[1].write_bytes(png(scene, pixels) if draw.randrange(2) else header(scene) + bytes(pixels))
            files[2].write_text("".join(json.dumps(line) + "\n" for line in proof))
            still_true = is_true(truth if changed == scene else Scene(changed), bytes(pixels), proof)
            counts.update(["changes", f"changes that are {'still true' if still_true else 'false'}", "changed: " + what])
            for checker, (accepts, said) in checkers.verdicts(*files).items():
                expect(accepts == still_true, "verify." + checker, "accepts" if accepts else "refuses", what, "of scene",
                       first, "which is", "true" if still_true else "false", said)


LESS, MORE = 1 - Fraction(1, 2**40), 1 + Fraction(1, 2**40)


def moved_inward(polygon, passing, by):
    """The half-plane of an edge that passes beside the centre is moved over it, or back from it, by so much."""
    a, b, c = polygon.edges[passing["edge"]]
    dx, dy = {"left": (by, 0), "right": (-by, 0), "above": (0, by), "below": (0, -by)}[passing["passes"]]
    return a, b, c - a * dx - b * dy


def with_edges(polygon, passings, factor):
    edges = list(polygon.edges)
    for passing in passings:
        edges[passing["edge"]] = moved_inward(polygon, passing, factor * Fraction(passing["away"]))
    return edges


def check_reasons(name, scene, pixel, told):
    truth = Scene(scene)
    place = {polygon["id"]: number for number, polygon in enumerate(scene["polygons"])}
    at = truth.owner(*pixel)
    expect((told["owner"] is None) == (at is None) and (at is None or place[told["owner"]] == at), name, "another owner")

    def owner_with(number, **changes):
        polygons = list(truth.polygons)
        polygons[number] = polygons[number].changed(**changes)
        return owner(polygons, *pixel)

    for reason in told["polygons"]:
        number = place[reason["polygon"]]
        polygon = truth.polygons[number]
        gap = Fraction(reason["gap"]) if "gap" in reason else 0
        any_rise = Fraction(1, 2**200) if "gap" in reason and gap == 0 else 0
        counts["reasons: " + reason["standing"]] += 1
        if reason["standing"] == "edge_on":
            expect(polygon.edge_on, name, reason)
            continue
        expect(Fraction(reason["depth"]) == polygon.depth(*centre(*pixel)), name, "another depth", reason)
        if reason["standing"] == "behind":
            if gap > 0:
                expect(owner_with(number, rise=gap * LESS) == at, name, "a smaller rise suffices", reason)
            expect(owner_with(number, rise=gap * MORE + any_rise) == number, name, "the rise does not suffice", reason)
            expect((owner_with(number, rise=gap) == number) == reason["wins_ties"], name, "ties", reason)
        if reason["standing"] == "beside":
            less = owner_with(number, edges=with_edges(polygon, reason["edges"], LESS), rise=gap * MORE + any_rise)
            expect(less == at, name, "less suffices", reason)
            more = owner_with(number, edges=with_edges(polygon, reason["edges"], MORE), rise=gap * MORE + any_rise)
            expect(more == number, name, "more does not suffice", reason)
            if gap > 0:
                lower = owner_with(number, edges=with_edges(polygon, reason["edges"], MORE), rise=gap * LESS)
                expect(lower == at, name, "a smaller rise suffices", reason)
        if reason["standing"] == "shows":
            if "next" in reason:
                if gap > 0:
                    expect(owner_with(number, rise=-gap * LESS) == at, name, "sinking less suffices", reason)
                expect(owner_with(number, rise=-gap * MORE - any_rise) == place[reason["next"]], name, "sinking", reason)
            (passing,) = reason["edges"]
            if passing["passes"] != "through":
                expect(owner_with(number, edges=with_edges(polygon, [passing], LESS)) == at, name, "a smaller move", reason)
                expect(owner_with(number, edges=with_edges(polygon, [passing], MORE)) != at, name, "a larger move", reason)


def check_pixels():
    draw = random.Random(options.seed + 1)
    file = work / "why.json"
    for number, scene in enumerate(random_scenes(200000, options.pixels), 200000):
        file.write_text(json.dumps(scene))
        x, y, width, height = (scene["window"][key] for key in ("x", "y", "width", "height"))
        pixel = draw.randrange(x, x + width), draw.randrange(y, y + height)
        told = vidno("why", file, f"--pixel={pixel[0]},{pixel[1]}", "--json")
        expect(told.returncode == 0, "why", number, told.stderr)
        counts["pixels"] += 1
        if told.returncode == 0:
            check_reasons(f"scene {number} pixel {pixel}:", scene, pixel, json.loads(told.stdout))


parser = argparse.ArgumentParser()
parser.add_argument("vidno", type=pathlib.Path)
parser.add_argument("scenes_program", type=pathlib.Path)
parser.add_argument("compiled", type=pathlib.Path)
parser.add_argument("root", type=pathlib.Path)
parser.add_argument("work", type=pathlib.Path)
parser.add_argument("--scenes", type=int, default=2000)
parser.add_argument("--changes", type=int, default=10000)
parser.add_argument("--pixels", type=int, default=1000)
parser.add_argument("--seed", type=int, default=1)
parser.add_argument("--first", type=int, default=0, help="the first of the random scenes; with another, no files are read")
options = parser.parse_args()
options.vidno = options.vidno.resolve()
is_whole = options.scenes >= 1000
options.some = lambda files: files if is_whole else files[::8]
options.most_work = 2_000_000 if is_whole else 20_000
work = options.work
work.mkdir(parents=True, exist_ok=True)
checkers = Checkers(options.root / "lessons/proof", options.compiled)
started = time.time()
if options.scenes > 0:
    if options.first == 0:
        prove_by_hand()
        prove_files()
        prove_meshes([64, 128] if is_whole else [24])
    prove_random_scenes()
change_proofs()
check_pixels()
checkers.close()
for what, count in sorted(counts.items()):
    print(f"{count:8} {what}")
print(f"{time.time() - started:.0f} s")
print(*failures[:20], sep="\n")
sys.exit(f"{len(failures)} failures" if failures else 0)
