# SPDX-License-Identifier: Apache-2.0
"""Checks that the C++ wrapper, which includes the C headers, uses every function of theirs.

used.py INCLUDE_FOLDER EXCEPTIONS: the latter are lines `name: reason`, or empty, or comments after
'#'; one for a function that is used or does not exist is an error too.
"""

import pathlib
import re
import sys

from headers import read_headers


def uses(text: str) -> set[str]:
    """Functions that are named outside of comments and texts: called, or handed on."""
    text = re.sub(r"/\*.*?\*/|//[^\n]*|\"(?:\\.|[^\"\\\n])*\"", " ", text, flags=re.DOTALL)
    return set(re.findall(r"\bawd[A-Z]\w*", text))


def read_exceptions(text: str) -> set[str]:
    lines = [line.partition("#")[0].strip() for line in text.splitlines()]
    matches = [re.fullmatch(r"(awd\w+): +\S.*", line) for line in lines if line]
    if not all(matches):
        raise ValueError("an exception is not `name: reason`")
    return {match.group(1) for match in matches}


def main() -> int:
    include, exceptions = map(pathlib.Path, sys.argv[1:])
    functions = set(read_headers(include).functions)
    used = set().union(*(uses(path.read_text()) for path in (include / "awd").rglob("*.hpp")))
    excepted = read_exceptions(exceptions.read_text())
    found = [f"{name} is never used" for name in functions - used - excepted]
    found += [f"{name} is used: it is no exception" for name in excepted & used]
    found += [f"{name} is an exception, but not in the headers" for name in excepted - functions]
    for line in sorted(found):
        print(line)
    print(f"{len(functions)} functions, {len(excepted)} exceptions, {len(found)} errors")
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main())
