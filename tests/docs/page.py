# SPDX-License-Identifier: Apache-2.0
"""The code fragments of a Markdown page, and what an HTML comment before one says of it:

  <!-- test: in FRAME at PLACE -->  goes to the line /* @PLACE */ (or // @PLACE, as comments of the
                                    language are) of tests/docs/frames/FRAME, with all others of
                                    the page that go there, and is a part of that program
  <!-- test: continues -->          goes on with the last program of its language on the page
  <!-- test: file NAME -->          is that file, for fragments after it
  <!-- test: not run: REASON -->    is not run, but a shell's grammar is checked
"""
import re
from dataclasses import dataclass

OPEN = re.compile(r"^( {0,3})(`{3,})\s*(\S*)\s*$")
DIRECTIVE = re.compile(r"^\s*<!--\s*test:\s*(.*?)\s*-->\s*$")
FORMS = [re.compile(form) for form in (
    r"(in) (\S+) at (\S+)", r"(continues)", r"(file) (\S+)", r"(not run): (\S.*)")]

# Fences of these are no code.
PROSE = {"", "text", "json", "toml"}
CODE = {"c", "cpp", "sh", "cmake", "python", "rust", "lua"}


class PageError(Exception):
    """What a fragment has wrong, with page and line."""


@dataclass
class Fragment:
    page: str
    line: int  # of its first line of code
    language: str
    directive: tuple  # ("in", FRAME, PLACE) and so on; empty: none
    text: str

    def fail(self, message):
        raise PageError(f"{self.page}:{self.line}: {message}")

    @property
    def kind(self):
        return self.directive[0] if self.directive else ""


def directive_of(words, where):
    for form in FORMS:
        match = form.fullmatch(words)
        if match:
            return match.groups()
    raise PageError(f"{where}: no such directive: {words}")


def fragments(page, text):
    """All code of a page, in its order."""
    made, directive, opened = [], (), None
    for number, line in enumerate(text.split("\n"), 1):
        where = f"{page}:{number}"
        if opened:
            if line.strip() != opened["fence"]:
                opened["code"].append(line[len(opened["indent"]):])
                continue
            if opened["language"] in CODE:
                made.append(Fragment(page, opened["line"], opened["language"], directive,
                                     "\n".join(opened["code"]) + "\n"))
            elif opened["language"] not in PROSE:
                raise PageError(f"{page}:{opened['line']}: a fragment in {opened['language']}, "
                                "which no test knows")
            opened, directive = None, ()
            continue
        fence, spoken = OPEN.match(line), DIRECTIVE.match(line)
        if fence:
            opened = {"indent": fence.group(1), "fence": fence.group(2), "code": [],
                      "language": fence.group(3), "line": number + 1}
        elif spoken:
            directive = directive_of(spoken.group(1), where)
        elif line.strip() and directive:
            raise PageError(f"{where}: a directive without a fragment")
    if opened or directive:
        raise PageError(f"{page}: ends within a fragment")
    return made
