# SPDX-License-Identifier: Apache-2.0
"""The programs in README.md run as they stand there."""
import os
import re
import tempfile
import unittest

from support import python


class Readme(unittest.TestCase):
    def test_programs(self):
        with open(os.path.join(os.environ["AWD_PACKAGE"], "README.md"), encoding="utf-8") as file:
            programs = re.findall(r"^```python\n(.*?)^```", file.read(), re.S | re.M)
        self.assertEqual(len(programs), 2)
        for program in programs:
            with tempfile.TemporaryDirectory() as folder:
                run = python(program, cwd=folder)
                self.assertEqual((run.returncode, run.stderr), (0, ""))
                self.assertTrue(run.stdout)


if __name__ == "__main__":
    unittest.main()
