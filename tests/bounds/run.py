#!/usr/bin/env python3
"""Lets Gappa prove the bounds of the kernel `filtered`, and refuse them when their constant is divided by four.

    run.py GAPPA ROOT        the program gappa, the folder of the repository

The first line of a script names a header and the code in it whose constant the script has in the line marked "# constant".
"""

import pathlib
import re
import subprocess
import sys


def proves(script):
    return subprocess.run([sys.argv[1], "-Eprecision=200"], input=script, capture_output=True, text=True).returncode == 0


root = pathlib.Path(sys.argv[2])
failures = []
scripts = sorted((root / "tests/bounds").glob("*.g"))
for file in scripts:
    script = file.read_text(encoding="utf-8")
    header, code = re.match(r"# code: (\S+): (.*)\n", script).groups()
    if code not in (root / header).read_text(encoding="utf-8"):
        failures.append(f"{file.name}: {header} has no longer {code}")
    if not proves(script):
        failures.append(f"{file.name}: Gappa does not prove it")
    weaker, changed = re.subn(r"= (\d+)b-(\d+);(?=  # constant)", lambda m: f"= {m[1]}b-{int(m[2]) + 2};", script)
    if changed != 1:
        failures.append(f"{file.name}: it needs one line that is marked as the constant")
    if proves(weaker):
        failures.append(f"{file.name}: a quarter of the constant would do")
if not scripts:
    failures.append("no script was found")
sys.exit("\n".join(failures) or 0)
