# SPDX-License-Identifier: Apache-2.0
"""How libawd is found, and what is said when it is not."""
import os
import unittest

import awd
from support import python


class Library(unittest.TestCase):
    def test_the_one_that_is_named_is_loaded(self):
        self.assertEqual(awd.library_path(), os.environ["AWD_LIBRARY"])
        self.assertEqual(".".join(map(str, awd.library_version())), awd.__version__)

    def test_a_name_that_is_wrong_is_told_and_nothing_else_is_tried(self):
        run = python("import awd\ntry: awd.Device()\nexcept awd.LibraryNotFound as e: print(e)",
                     env={**os.environ, "AWD_LIBRARY": "/nowhere/libawd.so"})
        self.assertEqual(run.stderr, "")
        self.assertIn("/nowhere/libawd.so: ", run.stdout)
        self.assertNotIn("libawd.so.1", run.stdout)

    def test_another_library_is_not_taken_for_it(self):
        run = python("import awd\ntry: awd.Device()\nexcept OSError as e: print(e)",
                     env={**os.environ, "AWD_LIBRARY": "libc.so.6"})
        self.assertIn("awdGetVersion", run.stdout)

    def test_the_system_is_asked_last(self):
        environment = {key: value for key, value in os.environ.items() if key != "AWD_LIBRARY"}
        folder = os.path.dirname(os.environ["AWD_LIBRARY"])
        code = "import awd; print(awd.library_version(), awd.library_path())"
        run = python(code, env={**environment, "LD_LIBRARY_PATH": folder})
        self.assertEqual(run.stdout.split()[-1], "libawd.so.1", run.stderr)

    def test_paths_tried_are_listed(self):
        environment = {key: value for key, value in os.environ.items() if key != "AWD_LIBRARY"}
        run = python("from awd import _library; _library.SONAME = 'libnone.so.1'\n"
                     "import awd\ntry: awd.Device()\nexcept OSError as e: print(e)",
                     env=environment)
        self.assertIn("_lib/libnone.so.1: ", run.stdout)
        self.assertIn("  libnone.so.1: ", run.stdout)

    def test_a_function_that_the_library_lacks_is_unsupported(self):
        run = python("from awd import _c as c, _library\n"
                     "c.function('awdNoSuchThing', None)\nimport awd\n"
                     "try: _library.lib.awdNoSuchThing()\nexcept awd.Unsupported as e: print(e)")
        self.assertIn("has no awdNoSuchThing", run.stdout, run.stderr)

    def test_result_strings(self):
        self.assertEqual(awd.result_string(awd.Result.ERROR_CANCELLED), "cancelled")
        self.assertRaises(ValueError, awd.result_string, 2**31)


if __name__ == "__main__":
    unittest.main()
