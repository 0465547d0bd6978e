#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""What the reference must say and Doxygen doesn't ask for: of every function how it may be called
from several threads, and of every value of an enumeration what it means.

  reference.py HEADER...
"""
import re
import sys

from doxygen_filter import filtered

THREADS = re.compile(r"\b(Free|Exclusive)\b")


def functions(text):
    """(name, documentation) of every exported function."""
    pattern = r"(/\*\*(?:(?!\*/).)*\*/\s*)?AWD_EXPORT [^;]*?(?:AWD_CALL|\*)\s+(\w+)\("
    for match in re.finditer(pattern, text, re.S):
        yield match.group(2), match.group(1) or ""


def values(text):
    """(name, whether it is documented) of every value of an enumeration."""
    for body in re.findall(r"\benum \{(.*?)\n?\};", text, re.S):
        bare = re.sub(r"/\*\*.*?\*/", lambda comment: "@" + comment.group(0)[3:4], body, flags=re.S)
        for match in re.finditer(r"(@ )?\s*\b(AWD_\w+) = [^,@}]*,?\s*(@<)?", bare):
            yield match.group(2), bool(match.group(1) or match.group(3))


def complaints(path):
    with open(path, encoding="utf-8") as file:
        text = filtered(file.read())
    for name, documentation in functions(text):
        if not THREADS.search(documentation):
            yield f"{path}: {name} says neither Free nor Exclusive"
    for name, documented in values(text):
        if not documented:
            yield f"{path}: {name} is not documented"


def main(paths):
    found = [complaint for path in paths for complaint in complaints(path)]
    for complaint in found:
        print(complaint)
    return 1 if found or not paths else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
