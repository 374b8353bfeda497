#!/usr/bin/env python3
"""Lets Gappa prove the bounds of the kernel `filtered`, and refuse each when a constant of it is weaker by a factor of four.

    run.py GAPPA ROOT        the program gappa, the folder of the repository

A script begins with "# code: HEADER: CODE": code that the header has, and whose constants the script has. It marks a constant "# constant: no
less", so that a quarter of it is weaker, or "no more", so that four times it is. A line of the headers with a constant needs a script, or a
reason in `bounds_nothing`.
"""

import pathlib
import re
import subprocess
import sys

headers = ["filter*.h", "bounded.h", "plane_depth*.h"]
bounds_nothing = {
    "std::array<std::string_view, 4> filter_stage_names": "names",
    "last + 0.5 <= v.low()) && (last == end - 1 || v.high() < last + 1.5)": "centres of pixels, which doubles hold exactly",
    "static constexpr double invisible = 0x1p-20;": "how exact a crossing is shown, whatever its bound; nothing is decided by it",
}


def tried(script):
    return subprocess.run([sys.argv[1], "-Eprecision=200"], input=script, capture_output=True, text=True)


def has_constant(line):
    code = line.split("//")[0]
    numbers = set(re.findall(r"\b(?:0x\w+|\d[\d.]*)", code)) - {"0", "1", "0.5"}
    return not code.startswith("#") and (numbers or re.search(r"\b(unit|underflow)\b", code))


root = pathlib.Path(sys.argv[2])
failures = []
explained = set(bounds_nothing)
for file in sorted((root / "tests/bounds").glob("*.g")):
    script = file.read_text(encoding="utf-8")
    for header, code in re.findall(r"^# code: (\S+): (.*)$", script, re.MULTILINE):
        explained.add(code)
        if code not in (root / header).read_text(encoding="utf-8"):
            failures.append(f"{file.name}: {header} has no longer {code}")
    proof = tried(script)
    if proof.returncode != 0 or proof.stderr:  # a hint of which Gappa is not sure gets a warning
        failures.append(f"{file.name}: Gappa does not prove it: {proof.stderr}")
    constants = list(re.finditer(r"= (.+);(?=  # constant: no (less|more)$)", script, re.MULTILINE))
    if not constants:
        failures.append(f"{file.name}: no line is marked as a constant")
    for constant in constants:
        weaker = f"= ({constant[1]}) {'/' if constant[2] == 'less' else '*'} 4;"
        if tried(script[: constant.start()] + weaker + script[constant.end() :]).returncode == 0:
            failures.append(f"{file.name}: {weaker} would do")
files = [file for pattern in headers for file in (root / "lib/vidno/kernels").glob(pattern)]
lines = [line.strip() for file in files for line in file.read_text(encoding="utf-8").splitlines() if has_constant(line)]
failures += [f"no script has {line}" for line in lines if not any(code in line for code in explained)]
failures += [f"no header has {code}" for code in bounds_nothing if not any(code in line for line in lines)]
sys.exit("\n".join(failures) or 0)
