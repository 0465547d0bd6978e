# SPDX-License-Identifier: Apache-2.0
"""Installed by pip, offline and without a compiler: from the folder, and from a wheel that carries
the library."""
import glob
import json
import os
import shutil
import subprocess
import sys
import tempfile
import unittest
import zipfile

PACKAGE = os.environ["AWD_PACKAGE"]
LIBRARY = os.environ["AWD_LIBRARY"]

# With no compiler and no library named; a render, so that bases are found too.
USE = """
import json, sys
import numpy
import awd
with awd.Device(log=lambda severity, text: print(text, file=sys.stderr)) as device:
    scene = awd.Scene(device)
    scene.add_material(0.5)
    scene.add_material(0.0, 4.0)
    scene.add_mesh([[-1, 0, 1], [1, 0, 1], [1, 0, -1], [-1, 0, -1], [-1, 1, -1], [1, 1, -1],
                    [1, 1, 1], [-1, 1, 1]], [[0, 1, 2], [0, 2, 3], [4, 5, 6], [4, 6, 7]],
                   [0, 0, 1, 1])
    scene.commit()
    render = awd.Render(scene, awd.Camera((0, 0.5, 4), width=16, height=8), seed=1)
    render.run(samples=8)
    refit = True
    try:
        awd.Density(device, 1, estimator="refit")
    except awd.Unsupported:
        refit = False
    print(json.dumps({"package": awd.__file__, "library": awd.library_path(),
                      "version": awd.__version__, "mean": float(render.film().mean()),
                      "bases": [basis.file for basis in device.bases()], "refit": refit}))
"""


class Installed(unittest.TestCase):
    def setUp(self):
        self.folder = tempfile.mkdtemp()
        self.addCleanup(shutil.rmtree, self.folder)
        self.clean = {key: value for key, value in os.environ.items()
                      if key not in ("AWD_LIBRARY", "PYTHONPATH", "PYTHONWARNINGS")}

    def run_(self, *command, **environment):
        run = subprocess.run(command, cwd=self.folder, capture_output=True, text=True,
                             env={**self.clean, **environment})
        self.assertEqual(run.returncode, 0, run.stdout + run.stderr)
        return run.stdout

    def venv(self):
        """A virtual environment that sees Debian's numpy, pip and setuptools."""
        folder = os.path.join(self.folder, "venv")
        self.run_(sys.executable, "-m", "venv", "--system-site-packages", "--without-pip", folder)
        return os.path.join(folder, "bin", "python3")

    def install(self, python, what):
        self.run_(python, "-m", "pip", "install", "--no-build-isolation", "--no-index",
                  "--disable-pip-version-check", what, CC="false", CXX="false")

    def use(self, python, **environment):
        told = json.loads(self.run_(python, "-c", USE, **environment))
        self.assertTrue(told["package"].startswith(self.folder), told)
        self.assertGreater(told["mean"], 0)
        self.assertGreater(len(told["bases"]), 5)
        return told

    def test_from_the_folder(self):
        source = os.path.join(self.folder, "source")  # pip leaves files in it
        shutil.copytree(PACKAGE, source, ignore=shutil.ignore_patterns("build", "*.egg-info"))
        python = self.venv()
        self.install(python, source)
        told = self.use(python, AWD_LIBRARY=LIBRARY)
        self.assertEqual(told["library"], LIBRARY)
        package = os.path.dirname(told["package"])
        self.assertTrue(os.path.exists(os.path.join(package, "py.typed")))

    def test_from_a_wheel_with_the_library(self):
        wheels = os.path.join(self.folder, "wheels")
        self.run_(sys.executable, os.path.join(PACKAGE, "make_wheel.py"), LIBRARY, wheels)
        wheel, = glob.glob(os.path.join(wheels, "*.whl"))
        self.assertRegex(os.path.basename(wheel), r"^awd-[\d.]+-py3-none-linux_\w+\.whl$")
        with zipfile.ZipFile(wheel) as content:
            self.assertIn("awd/_lib/libawd.so.1", content.namelist())
        python = self.venv()
        self.install(python, wheel)
        told = self.use(python)
        package = os.path.dirname(told["package"])
        self.assertEqual(told["library"], os.path.join(package, "_lib", "libawd.so.1"))
        for file in told["bases"]:
            self.assertTrue(file.startswith(package), file)
        with_refit = os.path.exists(os.path.join(os.path.dirname(LIBRARY), "awd", "refit-1.so"))
        self.assertEqual(told["refit"], with_refit)


if __name__ == "__main__":
    unittest.main()
