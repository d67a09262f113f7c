#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Reads what `llvm-cov show` prints; prints a table of the rooms, and writes every line and branch not reached to a file.

A line counts when it holds code, and is reached when any instantiation of it ran. A condition has two branches, true and false; one that is
known when compiling has none. A condition in a header is reached where any program or instantiation reaches it.

    llvm-cov show … | coverage_table.py SOURCES MISSED
"""
import re
import sys
from collections import defaultdict
from pathlib import Path

ROOMS = ["core", "costmap", "lidar", "alignability", "planner", "localization", "pictures", "report", "cli", "python"]
FILE = re.compile(r"^(/.*):$")
LINE = re.compile(r"^ *(\d+)\| *([^| ]*)\|(.*)$")
BRANCH = re.compile(r"^ *\|  Branch \((\d+):(\d+)\): \[(?:True: ([^,]+), False: ([^\]]+)|(Folded).*)\]$")


def reached(count):
    return count != "0"


class Source:
    def __init__(self):
        self.lines = {}
        self.texts = {}
        self.branches = defaultdict(lambda: [False, False])
        self.folded = set()

    def count_line(self, number, count, text):
        self.texts[number] = text
        if count:
            self.lines[number] = self.lines.get(number, False) or reached(count)

    def count_branch(self, place, when_true, when_false):
        sides = self.branches[place]
        sides[0] |= reached(when_true)
        sides[1] |= reached(when_false)

    def conditions(self):
        return {place: sides for place, sides in self.branches.items() if place not in self.folded}

    def missed_sides(self):
        """Of each line, what its conditions never were; of a line that never ran, nothing."""
        missed = defaultdict(list)
        for (line, column), sides in sorted(self.conditions().items()):
            if self.lines.get(line, True) and not all(sides):
                missed[line] += [f"{column} never {name}" for name, side in zip(("true", "false"), sides) if not side]
        return missed


def read_sources(report, root):
    sources = defaultdict(Source)
    source = None
    for row in report:
        row = row.rstrip("\n")
        if match := FILE.match(row):
            source = sources[str(Path(match[1]).relative_to(root))]
        elif source is None:
            continue
        elif match := LINE.match(row):
            source.count_line(int(match[1]), match[2], match[3])
        elif match := BRANCH.match(row):
            place = int(match[1]), int(match[2])
            if match[5]:
                source.folded.add(place)
            else:
                source.count_branch(place, match[3], match[4])
    return sources


def table(sources):
    rows = [("room", "lines", "reached", "", "branches", "reached", "")]
    total = [0, 0, 0, 0]
    for room in ROOMS:
        mine = [source for name, source in sources.items() if name.startswith(room + "/")]
        sides = [side for source in mine for pair in source.conditions().values() for side in pair]
        counts = [sum(len(source.lines) for source in mine), sum(sum(source.lines.values()) for source in mine), len(sides), sum(sides)]
        total = [sum(pair) for pair in zip(total, counts)]
        rows.append(row_of(room, counts))
    rows.append(row_of("all", total))
    widths = [max(len(row[column]) for row in rows) for column in range(len(rows[0]))]
    return "\n".join("  ".join([row[0].ljust(widths[0])] + [cell.rjust(width) for cell, width in zip(row[1:], widths[1:])]) for row in rows)


def row_of(room, counts):
    lines, lines_reached, branches, branches_reached = counts
    share = lambda part, whole: f"{1000 * part // whole / 10:.1f} %" if whole else "-"  # down, so that 100 is all
    return room, str(lines), str(lines_reached), share(lines_reached, lines), str(branches), str(branches_reached), share(branches_reached, branches)


def missed(sources):
    for name, source in sorted(sources.items()):
        sides = source.missed_sides()
        for line in sorted(source.texts):
            if source.lines.get(line) is False:
                yield f"{name}:{line}: never ran: {source.texts[line].strip()}"
            elif line in sides:
                yield f"{name}:{line}: {', '.join(sides[line])}: {source.texts[line].strip()}"


def main():
    root, missed_file = sys.argv[1:]
    sources = read_sources(sys.stdin, root)
    Path(missed_file).write_text("".join(row + "\n" for row in missed(sources)))
    print(table(sources))


main()
