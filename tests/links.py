#!/usr/bin/env python3
"""Checks that the files exist to which documents link or which CONTRIBUTING.md names in backquotes. There <name> stands for any name.

    links.py ROOT        the folder of the repository
"""

import pathlib
import re
import sys

root = pathlib.Path(sys.argv[1])
documents = [*root.glob("*.md")]
for folder in ["docs", "lessons", "lib", "tests", "trace"]:
    documents += (root / folder).rglob("*.md")
found = {}  # whether the file exists, by document and name

for document in documents:
    text = document.read_text(encoding="utf-8")
    for link in re.findall(r"\]\(([^)#\s]+)", re.sub(r"```.*?```|`[^`]*`", "", text, flags=re.DOTALL)):
        if "://" not in link:
            found[document, link] = (document.parent / link).exists()
    if document.name == "CONTRIBUTING.md":
        for path in re.findall(r"`((?:lessons|lib|tests|trace|viewer_web)/[^`\s]+)`", text):
            found[document, path] = any(root.glob(re.sub(r"<[^>]*>", "*", path)))

missing = [f"{document.relative_to(root)}: {name} does not exist" for (document, name), exists in found.items() if not exists]
if len(found) < 200:
    missing.append(f"only {len(found)} names were found")
sys.exit("\n".join(missing) or 0)
