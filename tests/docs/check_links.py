# SPDX-License-Identifier: BSD-3-Clause
"""check_links.py SOURCE: every link of the project's documents leads to a file that is there, and to a heading of it."""
import re
import sys
from pathlib import Path

LINK = re.compile(r"\]\(([^)\s]+)\)")


def prose(text):
    return re.sub(r"^```.*?^```$|`[^`\n]*`", "", text, flags=re.MULTILINE | re.DOTALL)


def anchors(document):
    """As GitHub makes them: lower case, no punctuation, a hyphen for each space."""
    titles = re.findall(r"^#+ (.*)$", re.sub(r"^```.*?^```$", "", document.read_text(), flags=re.MULTILINE | re.DOTALL), re.MULTILINE)
    return {re.sub(r"[^\w\- ]", "", title.lower()).replace(" ", "-") for title in titles}


def faults(document):
    for link in LINK.findall(prose(document.read_text())):
        if re.match(r"[a-z]+:", link):
            continue
        path, _, anchor = link.partition("#")
        target = document.parent / path if path else document
        if not target.exists():
            yield f"{document}: there is no {link}"
        elif anchor and anchor not in anchors(target):
            yield f"{document}: {path or document.name} has no heading #{anchor}"


source = Path(sys.argv[1])
documents = [source / "README.md", *source.glob("docs/*.md"), *source.glob("maps/*/README.md")]
found = [fault for document in documents for fault in faults(document)]
print(*found, sep="\n")
sys.exit(1 if found or len(documents) < 5 else 0)
