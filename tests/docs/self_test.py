#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""The tests of the documentation find what is wrong. Called with the driver's command line."""
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

import page_filter
from doxygen_filter import filtered
from reference import complaints

DRIVER = []
MAIN = '#include <awd/awd.h>\nint main(void) { return awdGetVersion() == AWD_VERSION ? 0 : 1; }'


def fence(language, code, directive=""):
    said = f"<!-- test: {directive} -->\n" if directive else ""
    return f"\n{said}```{language}\n{code}\n```\n"


class Fragments(unittest.TestCase):
    def run_page(self, text):
        with tempfile.TemporaryDirectory() as folder:
            page = Path(folder) / "page.md"
            page.write_text(text, encoding="utf-8")
            result = subprocess.run(DRIVER + [str(page)], stdout=subprocess.PIPE,
                                    stderr=subprocess.STDOUT, encoding="utf-8")
            return result.returncode, result.stdout

    def fine(self, text):
        code, said = self.run_page(text)
        self.assertEqual(code, 0, said)

    def wrong(self, text, why):
        code, said = self.run_page(text)
        self.assertEqual(code, 1, said)
        self.assertIn(why, said)

    def test_what_is_right(self):
        self.fine(fence("c", MAIN) + fence("cpp", MAIN) + fence("text", "no code") +
                  fence("c", MAIN.replace("awdGetVersion()", "version()")
                        .replace("int main", "uint32_t version(void);\nint main")) +
                  fence("c", "uint32_t version(void) { return AWD_VERSION; }", "continues"))

    def test_shell_sees_files_and_the_installed_tree(self):
        self.fine(fence("c", "int a;", "file here/a.c") +
                  fence("sh", "[[ -s here/a.c && -f README.md ]] # both\n./run help\n"
                              "ls prefix/include/awd/awd.h \\\n  build/release"))

    def test_c_that_does_not_compile(self):
        self.wrong(fence("c", MAIN.replace("AWD_VERSION", "AWD_VERSIONS")), "page.md:3")
        self.wrong(fence("c", MAIN.replace("{ return", "{ int unused; return")), "unused")
        self.wrong(fence("cpp", MAIN.replace("return", "int a = nullptr; return")), "page.md:4")

    def test_programs_that_fail(self):
        self.wrong(fence("c", MAIN.replace("==", "!=")), "exit code 1")
        self.wrong(fence("sh", "false\ntrue"), "exit code 1")

    def test_half_programs(self):
        self.wrong(fence("c", "int a;"), "no main")

    def test_frames(self):
        self.wrong(fence("c", "int a;", "in nowhere.c at functions"), "there is no")
        self.wrong(fence("c", "int a;", "in guide.c at nowhere"), "has no place nowhere")

    def test_run_is_looked_up(self):
        self.wrong(fence("sh", "./run dance"), "does not know dance")
        self.wrong(fence("sh", "./run bench --slow"), "does not know --slow")

    def test_cmake(self):
        self.fine(fence("cmake", "find_package(awd REQUIRED)\n"
                                 "target_link_libraries(host PRIVATE awd::awd)"))
        self.wrong(fence("cmake", "find_package(awd 99 REQUIRED)"), "page.md:3")

    def test_pages_that_are_not_well_formed(self):
        self.wrong(fence("c", MAIN, "is fine"), "no such directive")
        self.wrong("<!-- test: continues -->\nwords\n" + fence("c", MAIN), "without a fragment")
        self.wrong(fence("fortran", "end"), "which no test knows")
        self.wrong("```c\n" + MAIN, "ends within")
        self.wrong("no code", "no fragment")

    def test_what_is_not_run_is_said(self):
        code, said = self.run_page(fence("sh", "false", "not run: takes a year"))
        self.assertEqual(code, 0, said)
        self.assertIn("not run: takes a year", said)
        self.wrong(fence("sh", "if", "not run: takes a year"), "syntax error")


HEADER = """/* SPDX-License-Identifier: Apache-2.0
 *
 * A header:
 *     p = a * b
 */
/* Both of these. Free. */
AWD_EXPORT AWDResult AWD_CALL awdOne(int a,
                                     int b) AWD_NOEXCEPT;
AWD_EXPORT void AWD_CALL awdTwo(void) AWD_NOEXCEPT;

AWD_EXPORT void AWD_CALL awdThree(void) AWD_NOEXCEPT;

/* Names. */
typedef int32_t AWDName;
enum {
  AWD_ONE = 1, /* the first,
                  on two lines */
  /* the second */
  AWD_TWO = 2,
  AWD_THREE = 3
};
"""


class Reference(unittest.TestCase):
    def test_what_is_not_said_is_found(self):
        with tempfile.TemporaryDirectory() as folder:
            header = Path(folder) / "a.h"
            header.write_text(HEADER, encoding="utf-8")
            found = [line.split(": ", 1)[1] for line in complaints(str(header))]
        self.assertEqual(found, ["awdThree says neither Free nor Exclusive",
                                 "AWD_THREE is not documented"])

    def test_comments_become_those_of_doxygen(self):
        made = filtered(HEADER)
        self.assertIn("/** @file\nA header:\n@verbatim\n    p = a * b\n@endverbatim */", made)
        self.assertEqual(made.count("/** Both of these. Free."), 2)
        self.assertEqual(made.count("@return"), 1)
        self.assertIn("/** Values of AWDName. */\nenum {", made)
        self.assertIn("AWD_ONE = 1, /**< the first,\non two lines */", made)
        self.assertIn("/** the second */\n\n  AWD_TWO", made)


class Links(unittest.TestCase):
    def test_links_lead_somewhere(self):
        with tempfile.TemporaryDirectory() as folder:
            (Path(folder) / "there").mkdir()
            (Path(folder) / "there/README.md").write_text("# A heading, of `one`\n")
            page = Path(folder) / "page.md"
            page.write_text("[a](there) [b](there/README.md#a-heading-of-one) [c](https://away)\n"
                            "[d](gone.md) [e](there/README.md#gone) [f](page.md) ![g](gone.png)")
            found = [line.split("[")[1][0] for line in page_filter.complaints(str(page))]
            self.assertEqual(found, ["d", "e"])
            (Path(folder) / "source.c").write_text("")
            self.assertEqual(
                page_filter.filtered(str(page), "[a](there) [b](there/README.md#one) [s](source.c)"),
                "[a](there/README.md) [b](there/README.md) s")


if __name__ == "__main__":
    DRIVER = sys.argv[1:]
    unittest.main(argv=sys.argv[:1])
