# SPDX-License-Identifier: Apache-2.0
"""What progress=True shows: in a terminal, in a notebook, and where there is neither."""
import os
import pty
import subprocess
import sys
import unittest

from support import python

RENDER = """
import awd
from support import CAMERA, lamp
awd.Render(lamp(awd.Device()), CAMERA).run(passes=[1, 1], progress=True)
"""

NOTEBOOK = """
import sys, types
shown = []
class Handle:
    def update(self, data, raw): shown.append(data["text/plain"])
def display(data, raw, display_id):
    return Handle()
shell, inner = types.ModuleType("IPython"), types.ModuleType("IPython.display")
class Session: kernel = 1
shell.get_ipython = lambda: Session()
inner.display = display
sys.modules.update({"IPython": shell, "IPython.display": inner})
""" + RENDER + "print(shown[-1])"


class Shown(unittest.TestCase):
    def test_a_line_in_a_terminal(self):
        terminal, inside = pty.openpty()
        with subprocess.Popen([sys.executable, "-c", RENDER], cwd=sys.path[0], stderr=inside,
                              stdout=subprocess.PIPE) as process:
            os.close(inside)
            text = b""
            while True:
                try:
                    part = os.read(terminal, 4096)
                except OSError:  # the other end is closed
                    break
                if not part:
                    break
                text += part
            self.assertEqual((process.wait(), process.stdout.read()), (0, b""))
        os.close(terminal)
        lines = text.decode().split("\r")
        self.assertRegex(lines[-2], r"^pass 2   \[#{30}\] 100 %  \d+\.\d s *$")
        self.assertTrue(any(line.startswith("adapt") for line in lines))
        self.assertEqual(lines[-1], "\n")

    def test_a_display_in_a_notebook(self):
        run = python(NOTEBOOK, cwd=sys.path[0])
        self.assertEqual(run.stderr, "")
        self.assertRegex(run.stdout, r"^pass 2   \[#{30}\] 100 %")

    def test_nothing_elsewhere(self):
        run = python(RENDER, cwd=sys.path[0])
        self.assertEqual((run.returncode, run.stdout, run.stderr), (0, "", ""))
        run = python("import sys; sys.stderr = None\n" + RENDER, cwd=sys.path[0])
        self.assertEqual((run.returncode, run.stdout), (0, ""))


if __name__ == "__main__":
    unittest.main()
