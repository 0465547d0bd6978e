#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Compiles and runs the code fragments of Markdown pages, as page.py finds them.

  fragments.py --source DIR --build DIR --prefix DIR --work DIR [--TOOL PATH]... PAGE...

C is compiled as C99 and C++ as C++17, against what was installed in the prefix, with warnings as
errors, and run; so are Python and Rust, by the bindings in the source tree. A fragment without a
directive is a whole program. Shell is run by bash -e in a folder that looks like the source tree
with its release build, and has the installed tree as `prefix`; ./run itself takes minutes, so that
it is only looked up in its own help. CMake is configured and built.
"""
import argparse
import os
import re
import subprocess
import sys
from pathlib import Path

from page import PageError, fragments

WARNINGS = ["-Wall", "-Wextra", "-Wpedantic", "-Werror", "-O1"]
STANDARD = {"c": "-std=c99", "cpp": "-std=c++17"}
MARK = re.compile(r"^ *(/\*|//|#|--) @(\w+)( \*/)?\n", re.M)
HERE = Path(__file__).resolve().parent
LIMIT = 300  # seconds


class Driver:
    def __init__(self, options):
        self.options = options
        self.source = Path(options.source).resolve()
        self.build = Path(options.build).resolve()
        self.prefix = Path(options.prefix).resolve()
        self.work = Path(options.work).resolve()
        self.libraries = self.prefix / options.libdir
        self.environment = dict(
            os.environ,
            PATH=f"{self.prefix}/bin:{os.environ['PATH']}",
            PYTHONPATH=str(self.source / "bindings/python"),
            AWD_LIBRARY=str(self.libraries / "libawd.so"),
            AWD_LIB_DIR=str(self.libraries),
            LUA_PATH=f"{self.source}/bindings/lua/?.lua;;",
            CARGO_TARGET_DIR=str(self.work / "target"),
            LD_LIBRARY_PATH=str(self.libraries))
        self.environment.pop("AWD_BASIS_PATH", None)
        self.programs = 0

    # --- one page ----------------------------------------------------------------------------

    def page(self, path):
        name = str(Path(path).resolve().relative_to(self.source)) \
            if self.source in Path(path).resolve().parents else Path(path).name
        found = fragments(name, Path(path).read_text(encoding="utf-8"))
        self.folder = self.work / name.replace("/", "_")
        self.furnish()
        done = set()
        for fragment in found:
            if fragment.kind == "not run":
                self.look(fragment)
            elif fragment.kind == "in":
                if fragment.directive[1] not in done:
                    done.add(fragment.directive[1])
                    self.framed(fragment.directive[1], found)
            elif fragment.kind == "file":
                file = self.folder / fragment.directive[1]
                file.parent.mkdir(parents=True, exist_ok=True)
                file.write_text(fragment.text, encoding="utf-8")
            elif fragment.language == "sh":
                self.shell(fragment)
            elif fragment.language == "cmake":
                self.cmake(fragment)
            elif fragment.kind != "continues":
                self.whole(fragment, found)
        print(f"{name}: {len(found)} fragments")
        return len(found)

    def furnish(self):
        """A folder that looks like the source tree, but can be written to."""
        self.run(["rm", "-rf", str(self.folder)], self.work)
        (self.folder / "build").mkdir(parents=True)
        for entry in self.source.iterdir():
            if not entry.name.startswith(".") and entry.name != "build":
                (self.folder / entry.name).symlink_to(entry)
        (self.folder / "build/release").symlink_to(self.build)
        (self.folder / "prefix").symlink_to(self.prefix)

    # --- programs ----------------------------------------------------------------------------

    def whole(self, fragment, found):
        """It, and what continues it up to the next program of its language."""
        pieces = [fragment]
        for later in found[found.index(fragment) + 1:]:
            if later.language == fragment.language:
                if later.kind == "continues":
                    pieces.append(later)
                elif not later.kind:
                    break
        if fragment.language in STANDARD and not any("main(" in piece.text for piece in pieces):
            fragment.fail("no program: no main, and no directive (tests/docs/page.py has them)")
        self.program(fragment, "".join(self.placed(piece) for piece in pieces))

    def placed(self, fragment):
        if fragment.language not in STANDARD:
            return fragment.text
        return f'#line {fragment.line} "{fragment.page}"\n{fragment.text}'

    def framed(self, frame, found):
        path = HERE / "frames" / frame
        parts = [piece for piece in found if piece.kind == "in" and piece.directive[1] == frame]
        if not path.is_file():
            parts[0].fail(f"there is no tests/docs/frames/{frame}")
        text = path.read_text(encoding="utf-8")
        marks = {mark.group(2): mark.group(0) for mark in MARK.finditer(text)}
        lines = {place: text[:text.index(mark)].count("\n") + 2 for place, mark in marks.items()}
        for piece in parts:
            if piece.directive[2] not in marks:
                piece.fail(f"{frame} has no place {piece.directive[2]}")
        for place, mark in marks.items():
            here = [self.placed(piece) for piece in parts if piece.directive[2] == place]
            if not here:
                parts[0].fail(f"nothing goes to {place} of {frame}")
            if parts[0].language in STANDARD:
                here.append(f'#line {lines[place]} "{frame}"\n')
            text = text.replace(mark, "".join(here))
        extra = re.findall(r"^ \* sources: (.*)$", text, re.M)
        if parts[0].language in STANDARD:
            text = f'#line 1 "{frame}"\n{text}'
        self.program(parts[0], text,
                     [str(self.source / name) for line in extra for name in line.split()])

    def program(self, fragment, text, sources=()):
        self.programs += 1
        language = fragment.language
        stem = self.folder / f"program{self.programs}"
        if language in STANDARD:
            compiler = self.options.cc if language == "c" else self.options.cxx
            stem.with_suffix("." + language).write_text(text, encoding="utf-8")
            folders = {str(Path(name).parent) for name in sources} | {str(self.folder)}
            self.run([compiler, STANDARD[language], *WARNINGS, f"-I{self.prefix}/include",
                      *[f"-I{folder}" for folder in sorted(folders)],
                      str(stem.with_suffix("." + language)), *sources, "-o", str(stem),
                      f"-L{self.libraries}", f"-Wl,-rpath,{self.libraries}", "-lawd", "-lm"],
                     self.folder, fragment)
            self.run([str(stem)], self.folder, fragment)
        elif language == "rust":
            self.rust(fragment, text, stem)
        else:
            tool = self.tool(fragment)
            if tool:
                stem.with_suffix(".txt").write_text(text, encoding="utf-8")
                self.run([tool, str(stem.with_suffix(".txt"))], self.folder, fragment)

    def rust(self, fragment, text, stem):
        cargo = self.tool(fragment)
        if not cargo:
            return
        (stem / "src").mkdir(parents=True)
        (stem / "src/main.rs").write_text(text, encoding="utf-8")
        (stem / "Cargo.toml").write_text(
            '[package]\nname = "fragment"\nversion = "0.1.0"\nedition = "2021"\n\n[dependencies]\n'
            f'awd = {{ path = "{self.source}/bindings/rust/awd" }}\n\n[workspace]\n',
            encoding="utf-8")
        self.run([cargo, "run", "--offline", "--quiet"], stem, fragment)

    def tool(self, fragment):
        """What runs that language; None, which is said, where it is not there."""
        tool = getattr(self.options, fragment.language)
        if not tool:
            if os.environ.get("CI"):
                fragment.fail(f"nothing to run {fragment.language} with")
            print(f"{fragment.page}:{fragment.line}: left out, nothing to run "
                  f"{fragment.language} with")
        return tool

    # --- shell and CMake ---------------------------------------------------------------------

    def shell(self, fragment):
        commands = fragment.text.replace("\\\n", " ").split("\n")
        ours = [command for command in commands if re.match(r"\s*\./run\b", command)]
        for command in ours:
            self.known(fragment, command)
        rest = "\n".join(command for command in commands if command not in ours)
        self.run(["bash", "-euo", "pipefail", "-c", rest], self.folder, fragment)

    def known(self, fragment, command):
        usage = self.run([str(self.source / "run"), "help"], self.source, fragment)
        words = command.split("#")[0].split()[1:]
        for option in words[1:]:
            if option not in usage:
                fragment.fail(f"./run help does not know {option}")
        if words and f"./run {words[0]} " not in usage:
            fragment.fail(f"./run help does not know {words[0]}")

    def look(self, fragment):
        print(f"{fragment.page}:{fragment.line}: not run: {fragment.directive[1]}")
        if fragment.language == "sh":
            self.run(["bash", "-n", "-c", fragment.text], self.folder, fragment)

    def cmake(self, fragment):
        """Targets that are only linked are programs of an empty main."""
        self.programs += 1
        folder = self.folder / f"project{self.programs}"
        folder.mkdir()
        (folder / "main.c").write_text("int main(void) { return 0; }\n", encoding="utf-8")
        text = fragment.text
        if not re.search(r"^project\(", text, re.M):
            made = re.findall(r"^add_(?:executable|library)\((\S+)", text, re.M)
            linked = re.findall(r"^target_link_libraries\((\S+)", text, re.M)
            text = "\n".join(
                ["cmake_minimum_required(VERSION 3.25)", "project(fragment LANGUAGES C CXX)"] +
                [f"add_executable({name} main.c)" for name in linked if name not in made] + [text])
        (folder / "CMakeLists.txt").write_text(text, encoding="utf-8")
        self.run([self.options.cmake, "-G", "Ninja", "-S", ".", "-B", "build",
                  f"-DCMAKE_PREFIX_PATH={self.prefix}",
                  "-DCMAKE_FIND_USE_PACKAGE_REGISTRY=OFF"], folder, fragment)
        self.run([self.options.cmake, "--build", "build"], folder, fragment)

    def run(self, command, folder, fragment=None):
        result = subprocess.run(command, cwd=folder, env=self.environment, timeout=LIMIT,
                                stdin=subprocess.DEVNULL, stdout=subprocess.PIPE,
                                stderr=subprocess.STDOUT, encoding="utf-8", errors="replace")
        if result.returncode != 0 and fragment:
            fragment.fail(f"exit code {result.returncode} of: {' '.join(command)}\n"
                          f"{result.stdout}")
        return result.stdout


def main():
    parser = argparse.ArgumentParser()
    for name in ("source", "build", "prefix", "work"):
        parser.add_argument("--" + name, required=True)
    for name, default in (("libdir", "lib"), ("cc", "cc"), ("cxx", "c++"), ("cmake", "cmake"),
                          ("python", ""), ("rust", ""), ("lua", "")):
        parser.add_argument("--" + name, default=default)
    parser.add_argument("pages", nargs="+")
    options = parser.parse_args()
    Path(options.work).mkdir(parents=True, exist_ok=True)
    driver = Driver(options)
    try:
        count = sum(driver.page(page) for page in options.pages)
    except PageError as error:
        print(error)
        return 1
    if count == 0:
        print("no fragment in", *options.pages)
        return 1
    return 0


if __name__ == "__main__":
    sys.exit(main())
