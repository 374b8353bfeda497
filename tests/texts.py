#!/usr/bin/env python3
"""Checks lessons/TEXTS.md: each line of the course's four texts has a place in a lesson.

    texts.py ROOT        the folder of the repository

A row names what a text says, the headings that teach it, the lines of a listing or the events that show it, and its
errors. All of them must exist. Each line of the listings that follow a text must be in a row, and so must each error.
A lesson that shows a line of a listing must show it as printed, too, where the two differ. lessons/names.json has each
name of a text once.
"""

import json
import pathlib
import re
import sys

root = pathlib.Path(sys.argv[1])
lessons = root / "lessons"
texts = (lessons / "TEXTS.md").read_text(encoding="utf-8")
listings = json.loads((root / "trace/listings/listings.json").read_text(encoding="utf-8"))
procedures = {each["name"]: each["lines"] for each in listings["procedures"]}
lines = {line["at"]: line for each in procedures.values() for line in each}
events = set(re.findall(r'Kind kind\{"(\w+)"', (root / "trace/format/event.h").read_text(encoding="utf-8")))
deviations = (root / "trace/choice/deviation.h").read_text(encoding="utf-8")
deviating = {defect.upper() for defect in re.findall(r'\.defect = "(x-\w+)"', deviations)}
atlas = {re.match(r"x-[a-z]\d+", file.name).group().upper() for file in (lessons / "failures").glob("x-*.json")}
wrong = []

# How many paragraphs, remarks and lines each text has, counted in the scans.
sizes = {"A": 101, "B": 46, "C": 67, "D": 92}

# The procedures that no text has: it only calls them, or we added them.
ours = {"FillPolygon", "Horizon", "Intersection", "WeilerAtherton", "SplitPiercing", "RegionClip", "RemoveBehind", "PaintRegions"}


def headings(story):
    """The anchors of a story's headings, as GitHub makes them."""
    text = re.sub(r"^ *```.*?^ *```$", "", story.read_text(encoding="utf-8"), flags=re.DOTALL | re.MULTILINE)
    titles = re.findall(r"^#+ (.+)$", text, flags=re.MULTILINE)
    return [re.sub(r"[^\w\- ]", "", title.lower()).replace(" ", "-") for title in titles]


def cells(line):
    return [cell.strip() for cell in line.strip().strip("|").split("|")]


anchors = {}
for folder in sorted(lessons.glob("[0-9][0-9]-*")):
    for language in ["en", "ru"]:
        anchors[f"{folder.name}/story.{language}.md"] = headings(folder / f"story.{language}.md")
    if len(anchors[f"{folder.name}/story.en.md"]) != len(anchors[f"{folder.name}/story.ru.md"]):
        wrong.append(f"{folder.name}: the two languages have different headings")

tables = re.split(r"^## ", texts, flags=re.MULTILINE)[1:]
rows = [cells(line) for table in tables[:4] for line in table.splitlines() if re.match(r"\| [A-D] \d", line)]
without_edition = {id for table in tables[4:] for id in re.findall(r"^\| (X-[A-Z]\d+) \|", table, flags=re.MULTILINE)}

named, errors, numbers = set(), set(), {}
for row in rows:
    if len(row) != 5:
        wrong.append(f"{row[0]}: {len(row)} cells, not 5")
        continue
    id, says, taught, shown, defects = row
    text, number = id.split()
    if int(number) != numbers.get(text, 0) + 1:
        wrong.append(f"{id}: follows {text} {numbers.get(text, 0)}")
    numbers[text] = int(number)
    if not says:
        wrong.append(f"{id}: does not say what the text says")
    places = re.findall(r"\[[^\]]+\]\(([^)#]+)#([^)]+)\)", taught)
    if not places:
        wrong.append(f"{id}: has no place")
    for file, anchor in places:
        if anchor not in anchors.get(file, []):
            wrong.append(f"{id}: {file} has no heading #{anchor}")
    marks = re.findall(r"`([^`]+)`", shown)
    if not marks:
        wrong.append(f"{id}: no line and no event shows it")
    for mark in marks:
        if mark not in lines and mark not in events:
            wrong.append(f"{id}: there is no line and no event {mark}")
    named.update(marks)
    found = re.findall(r"X-[A-Z]\d+", defects)
    if defects and not found:
        wrong.append(f"{id}: {defects} is no error")
    for defect in found:
        if defect not in deviating and defect not in without_edition:
            wrong.append(f"{id}: {defect} is neither a deviation nor listed as an error that no edition has alone")
    errors.update(found)

for name, each in procedures.items():
    if name not in ours:
        wrong += [f"no row has the line {line['at']}" for line in each if line["at"] not in named]
printed = {defect for line in lines.values() for defect in line.get("printed", {}).get("defects", [])}
wrong += [f"no row has the error {defect}" for defect in sorted((deviating | atlas | printed | without_edition) - errors)]
wrong += [f"{defect} is a deviation, yet listed as an error without an edition" for defect in sorted(without_edition & deviating)]


def shown_lines(names):
    return {line["at"] for name in names for line in procedures.get(name, [lines[name]] if name in lines else [])}


for story in anchors:
    text = (lessons / story).read_text(encoding="utf-8")
    shown = {edition: set() for edition in ["", "printed"]}
    for edition, names in re.findall(r"^```listing ?(printed)?\n(.*?)^```$", text, flags=re.DOTALL | re.MULTILINE):
        shown[edition] |= shown_lines(names.split())
    missing = {at for at in shown[""] - shown["printed"] if "printed" in lines[at]}
    wrong += [f"{story}: does not show {at} as printed" for at in sorted(missing)]

names = [(each["text"], each["name"]) for each in json.loads((lessons / "names.json").read_text(encoding="utf-8"))]
wrong += [f"names.json has {name} of {text} twice" for text, name in set(names) if names.count((text, name)) > 1]
wrong += [f"names.json: there is no text {text}" for text, _ in names if text not in sizes]

if numbers != sizes:
    wrong.append(f"the texts have {sizes} paragraphs, remarks and lines, the rows end with {numbers}")
sys.exit("\n".join(wrong) or 0)
