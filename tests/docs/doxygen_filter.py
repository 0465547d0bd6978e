#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Doxygen's input filter: the plain comments of a public header as Doxygen reads them.

  doxygen_filter.py HEADER, the result on standard output

A comment on lines of its own documents what follows it: one declaration, or several of functions,
types or macros up to an empty line. One after code documents that code; the first of a file, and
those that begin with dashes, the file. What no header need say again is said here: of structSize, of the ..._INIT macros, of the
values of a named type, and what a result means.
"""
import re
import sys

SIZE = "/**< sizeof of this struct: its ..._INIT macro sets it. */"
INIT = "/** Initialises the struct: its structSize, and the default for all else. */"
RESULT = ("@return AWD_SUCCESS; else what is said here, or what any call may return (types.h): "
          "awdGetLastErrorMessage() tells why.")
SHARING = re.compile(r"AWD_EXPORT|#define|typedef")


def escape(text):
    """Plain text for Doxygen; what stands in backticks is left alone."""
    parts = text.split("`")
    parts[::2] = [re.sub(r"([\\@<>&#%*~])", r"\\\1", part) for part in parts[::2]]
    return "`".join(parts)


def indent(line):
    return len(line) - len(line.lstrip())


def text_of(comment):
    """The words of a comment. Lines that are indented are formulas, but those after a dash."""
    lines = comment.strip("\n").split("\n")
    lines = [re.sub(r"^ ?\*(?= |$)", "", line).rstrip() for line in lines]
    lines = [line for line in lines if "SPDX-License-Identifier" not in line]
    base = min((indent(line) for line in lines[1:] if line.strip()), default=0)
    made, formula, item = [], False, False
    for number, line in enumerate(lines):
        words = line.strip()
        deep = number > 0 and indent(line) >= base + 2
        starts = re.match(r"- (.*)", words)
        item = bool(starts) or (item and (deep or not words))
        wanted = (deep and not item) if words else formula
        if wanted != formula:
            made.append("@verbatim" if wanted else "@endverbatim")
            formula = wanted
        if formula:
            made.append(line[base:])
        elif starts:
            made.append("- " + escape(starts.group(1)))
        else:
            made.append(("  " if item else "") + escape(words))
    if formula:
        while not made[-1]:
            made.pop()
        made.append("@endverbatim")
    return "\n".join(made).strip("\n").strip()


def document(comment, declaration):
    returns = "\n\n" + RESULT if declaration.startswith("AWD_EXPORT AWDResult") else ""
    return f"/** {comment}{returns} */\n"


def filtered(source):
    lines = source.split("\n")
    made = []
    comment = ""  # not yet written
    shared = ""   # of the declarations before the next empty line
    named = ""    # the type named in the line before
    first = True
    inside = ""   # a declaration of several lines: how it begins
    while lines:
        line = lines.pop(0)
        words = line.strip()
        if "/*" in line:
            while "*/" not in line:
                line += "\n" + lines.pop(0)
        code, _, rest = line.partition("/*")
        if "/*" in line and not code.strip():
            body = rest.rsplit("*/", 1)[0]
            if first:
                made.append(f"/** @file\n{text_of(body)} */")
            elif body.startswith(" ---"):
                comment = ""
                title, _, words = body.strip(" -").partition("\n")
                if words:
                    made.append(f"/** @file\n@par {title.strip(' -')}\n{text_of(words)} */")
            else:
                comment = text_of(body)
            first, shared = False, comment
            continue
        if not words:
            comment = shared = ""
        elif not inside:
            if not comment and SHARING.match(words) and "/*" not in line:
                comment = shared
            if words == "size_t structSize;":
                code = line = f"{code} {SIZE}"
            elif re.match(r"#define AWD_\w+_INIT\b", words):
                made.append(INIT)
            elif words.startswith("enum {") and named:
                made.append(f"/** Values of {named}. */")
            elif comment:
                made.append(document(comment, words))
            comment = ""
            start = SHARING.match(words)
            inside = start.group(0) if start and "{" not in words else ""
        if "/*" in line and code is not line:
            body, _, after = rest.rpartition("*/")
            line = f"{code}/**< {text_of(body)} */{after}"
        made.append(line)
        name = re.match(r"typedef int32_t (\w+);", words)
        named = name.group(1) if name else ""
        goes_on = not code.rstrip().endswith(";") if inside != "#define" else code.endswith("\\")
        inside = inside if inside and goes_on else ""
    return "\n".join(made)


if __name__ == "__main__":
    with open(sys.argv[1], encoding="utf-8") as header:
        sys.stdout.write(filtered(header.read()))
