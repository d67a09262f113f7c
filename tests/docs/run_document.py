# SPDX-License-Identifier: BSD-3-Clause
"""run_document.py SOURCE PROGRAMS DOCUMENT: runs a document's commands as written, in an empty folder beside which the project lies.

Blocks marked ```sh are run by one bash, one after the other. The lines of a ```text block right after one must be among those that it
printed, but for how they are spaced; an "…" stands for whatever is left out. Other blocks are left alone.
"""
import re
import subprocess
import sys
import tempfile
from pathlib import Path

BLOCK = re.compile(r"^```(\w*)\n(.*?)^```$", re.MULTILINE | re.DOTALL)


def steps(text):
    """Pairs of commands and what they are said to print."""
    found = []
    end = None
    for block in BLOCK.finditer(text):
        kind, body = block.groups()
        if kind == "sh":
            found.append((body, ""))
        elif kind == "text" and found and text[end : block.start()].strip() == "":
            found[-1] = (found[-1][0], body)
        end = block.end()
    return found


def squeezed(line):
    return " ".join(line.split())


def missing(said, printed):
    lines = {squeezed(line) for line in printed.splitlines()}
    return [line for line in said.splitlines() if squeezed(line) not in lines | {"", "…"}]


def main():
    source, programs, document = (Path(argument).resolve() for argument in sys.argv[1:])
    found = steps(document.read_text())
    if not found:
        sys.exit(f"{document.name} has no commands")
    with tempfile.TemporaryDirectory() as folder:
        for name in ["maps", "demos", "cmake"]:
            (Path(folder) / name).symlink_to(source / name)
        script = ["set -euo pipefail", f"PATH={programs}:$PATH"]
        for number, (commands, _) in enumerate(found):
            script += [f"exec > {number}.out", commands]
        run = subprocess.run(["bash", "-c", "\n".join(script)], cwd=folder, stderr=subprocess.PIPE, text=True)
        for number, (commands, said) in enumerate(found):
            output = Path(folder) / f"{number}.out"
            if not output.exists():
                break
            absent = missing(said, output.read_text())
            if absent and run.returncode == 0:
                print(commands, output.read_text(), "these lines were not among them:", *absent, sep="\n")
                sys.exit(1)
            last = commands + output.read_text()
        if run.returncode != 0:
            sys.exit(f"{last}\n{run.stderr}\nended with {run.returncode}")
    print(f"{len(found)} steps")


main()
