#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Doxygen's input filter: the links of a page that lead to other pages as Doxygen follows them.

  page_filter.py PAGE               the result on standard output
  page_filter.py --check PAGE...    whether links lead to what is there

A folder stands for its README.md, a link into a page for the page, and of one to a source, which
the site does not have, the words are left.
"""
import re
import sys
from pathlib import Path

LINK = re.compile(r"(?<!!)\[([^\]\n]*)\]\(([^)\s]+)\)")
AWAY = re.compile(r"[a-z]+:")


def place(page, target):
    """File and anchor that a link leads to."""
    path, _, anchor = target.partition("#")
    return (Path(page).parent / path if path else Path(page)), anchor


def anchors(page):
    """As GitHub and GitLab make them of headings."""
    headings = re.findall(r"^#+ (.*)$", page.read_text(encoding="utf-8"), re.M)
    return {re.sub(r"[^\w\- ]", "", heading.lower()).replace(" ", "-") for heading in headings}


def filtered(page, text):
    def link(match):
        words, target = match.groups()
        if AWAY.match(target):
            return match.group(0)
        file, _ = place(page, target)
        if (file / "README.md").is_file():
            return f"[{words}]({target.partition('#')[0].rstrip('/')}/README.md)"
        if file.suffix == ".md":
            return f"[{words}]({target.partition('#')[0]})"
        return words
    return LINK.sub(link, text)


def complaints(page):
    for words, target in LINK.findall(Path(page).read_text(encoding="utf-8")):
        if AWAY.match(target):
            continue
        file, anchor = place(page, target)
        if not file.exists():
            yield f"{page}: [{words}] leads to {target}, which is not there"
        elif anchor and anchor not in anchors(file):
            yield f"{page}: [{words}] leads to {target}: there is no such heading"


def main(arguments):
    if arguments[:1] == ["--check"]:
        found = [complaint for page in arguments[1:] for complaint in complaints(page)]
        print("\n".join(found))
        return 1 if found or not arguments[1:] else 0
    with open(arguments[0], encoding="utf-8") as page:
        sys.stdout.write(filtered(arguments[0], page.read()))
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
