# SPDX-License-Identifier: Apache-2.0
"""The comparison finds what is wrong. self_test.py INCLUDE_FOLDER C_COMPILER"""

import copy
import pathlib
import subprocess
import sys
import tempfile
import unittest

from compare import differences
from headers import HeaderError, Interface, add_header
from truth import ask_compiler
from used import read_exceptions, uses

include, compiler = pathlib.Path(sys.argv[1]), sys.argv[2]

HEADER = """/* awdNotThere(void); */
#define AWD_MOST 0x10u /* as 1u << 4 */
#define AWD_SUM (AWD_MOST * 100 + 2)
#define AWD_LEVEL(level) ((level) + 1u)
#define AWD_CALL
enum { AWD_OFF = 0, AWD_ON = 1u };
typedef struct AWDPoint {
  size_t structSize;
  float at[3], u, v; /* of the surface */
  uint32_t(AWD_CALL* count)(uint32_t level);
} AWDPoint;
#define AWD_POINT_INIT \\
  { sizeof(AWDPoint), {0.0f, 0.0f, 0.0f} }
AWD_EXPORT AWDResult AWD_CALL awdMake(const AWDPoint* desc, const float at[3],
                                      AWDThing* thing) AWD_NOEXCEPT;
AWD_EXPORT const char* AWD_CALL awdName(void) AWD_NOEXCEPT;
"""


class Headers(unittest.TestCase):
    def read(self, text: str) -> Interface:
        interface = Interface({}, [], {}, {})
        add_header(interface, text)
        return interface

    def test_all_that_is_declared_is_found(self):
        found = self.read(HEADER)
        self.assertEqual(found.functions, {
            "awdMake": ("AWDResult", ["const AWDPoint*", "const float*", "AWDThing*"]),
            "awdName": ("const char*", []),
        })
        self.assertEqual(found.constants, ["AWD_MOST", "AWD_SUM", "AWD_OFF", "AWD_ON"])
        self.assertEqual(found.structs, {"AWDPoint": ["structSize", "at", "u", "v", "count"]})
        self.assertEqual(found.inits, {"AWDPoint": "AWD_POINT_INIT"})

    def test_what_is_not_understood_is_an_error(self):
        for old, new in (
            ("awdName(void) AWD_NOEXCEPT", "awdName(void)"),
            ("const float at[3]", "void (*at)(int)"),
            ("} AWDPoint;", "} AWDOther;"),
            ("AWD_ON = 1u", "AWD_ON"),
            ("float at[3]", "float (*at)[3]"),
            ("sizeof(AWDPoint)", "0"),
        ):
            with self.subTest(new), self.assertRaises(HeaderError):
                self.read(HEADER.replace(old, new))


class Comparison(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.truth = ask_compiler(compiler, include)

    def test_nothing_differs_from_itself(self):
        self.assertEqual(differences(self.truth, copy.deepcopy(self.truth)), [])
        self.assertGreater(len(self.truth["functions"]), 100)

    def test_every_change_of_a_number_or_word_is_found(self):
        for path in self.leaves(self.truth, ()):
            changed = copy.deepcopy(self.truth)
            owner, name = self.at(changed, path)
            owner[name] = "changed"
            self.assertEqual(len(differences(self.truth, changed)), 1, path)

    def test_every_removal_is_found(self):
        for path in self.leaves(self.truth, ()):
            changed = copy.deepcopy(self.truth)
            owner, name = self.at(changed, path)
            del owner[name]
            line, = differences(self.truth, changed)
            self.assertRegex(line, "is missing$")

    def test_what_the_headers_lack_is_found(self):
        changed = copy.deepcopy(self.truth)
        changed["functions"]["awdOld"] = 1
        self.assertEqual(differences(self.truth, changed),
                         ["functions: awdOld is not in the headers"])

    def test_only_details_may_be_left_out(self):
        few = {name: self.truth[name] for name in ("functions", "constants", "structs")}
        self.assertEqual(differences(self.truth, few), [])
        for name in few:
            fewer = {other: part for other, part in few.items() if other != name}
            self.assertEqual(differences(self.truth, fewer), [f"{name}: not told at all"])

    def test_a_header_without_a_symbol_is_not_like_one_with(self):
        with tempfile.TemporaryDirectory() as folder:
            subprocess.run(["cp", "-r", include / "awd", folder], check=True)
            path = pathlib.Path(folder) / "awd" / "light.h"
            path.write_text(path.read_text().replace("awdRecordLight", "awdRecordNothing"))
            other = ask_compiler(compiler, pathlib.Path(folder))
        self.assertIn("functions: awdRecordLight is missing", differences(self.truth, other))

    @classmethod
    def leaves(cls, tree: dict, path: tuple):
        for name, item in tree.items():
            if isinstance(item, dict):
                yield from cls.leaves(item, (*path, name))
            else:
                yield *path, name

    @staticmethod
    def at(tree: dict, path: tuple):
        for name in path[:-1]:
            tree = tree[name]
        return tree, path[-1]


class Use(unittest.TestCase):
    def test_comments_and_texts_are_no_use(self):
        text = """// awdInComment();
        /* awdInComment() */ Owner<awdHandedOn> f; check(awdCalled(x), "awdInText()"); """
        self.assertEqual(uses(text), {"awdHandedOn", "awdCalled"})

    def test_exceptions_want_a_reason(self):
        self.assertEqual(read_exceptions("# none\n\nawdOld: for C alone\n"), {"awdOld"})
        with self.assertRaises(ValueError):
            read_exceptions("awdOld:\n")


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
