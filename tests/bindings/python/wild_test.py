# SPDX-License-Identifier: Apache-2.0
"""No Python value crashes the process, or comes out as an error that is not documented."""
import os
import re
import subprocess
import sys
import tempfile
import unittest


class Wild(unittest.TestCase):
    def test_values(self):
        program = os.path.join(sys.path[0], "wild.py")
        environment = {key: value for key, value in os.environ.items() if key != "PYTHONWARNINGS"}
        with tempfile.TemporaryDirectory() as folder:  # where it writes files
            run = subprocess.run([sys.executable, program], cwd=folder, env=environment,
                                 capture_output=True, text=True, timeout=1200)
        said = run.stdout + run.stderr
        self.assertEqual(run.returncode, 0, said)
        self.assertEqual(run.stderr, "")
        taken, refused, wrong = map(int, re.findall(r"\d+", said.splitlines()[-1])[:3])
        self.assertGreater(taken, 2000)
        self.assertGreater(refused, 20000)
        self.assertEqual(wrong, 0)


if __name__ == "__main__":
    unittest.main()
