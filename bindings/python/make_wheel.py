#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Makes a wheel of this package that carries libawd and its modules.

    make_wheel.py LIBRARY FOLDER

LIBRARY: libawd.so as built or installed; what is in awd/ beside it, basis modules and the refit
module, goes along. What these link themselves (Embree, oneTBB, OpenEXR; Ceres for refit) does not:
the wheel wants it on the system. FOLDER: where the wheel goes.
"""
import argparse
import os
import shutil
import subprocess
import sys
import tempfile

SOURCES = ("pyproject.toml", "setup.py", "README.md")
SONAME = "libawd.so.1"


def no_module(folder, names):
    """Those of the names that are neither modules nor folders."""
    return [name for name in names
            if not name.endswith(".so") and not os.path.isdir(os.path.join(folder, name))]


def stage(library, folder):
    """A copy of the package, with the library in it."""
    here = os.path.dirname(os.path.abspath(__file__))
    for name in SOURCES:
        shutil.copy(os.path.join(here, name), folder)
    package = os.path.join(folder, "awd")
    shutil.copytree(os.path.join(here, "awd"), package,
                    ignore=shutil.ignore_patterns("__pycache__", "_lib"))
    inside = os.path.join(package, "_lib")
    os.mkdir(inside)
    shutil.copy(library, os.path.join(inside, SONAME))
    shutil.copytree(os.path.join(os.path.dirname(library), "awd"), os.path.join(inside, "awd"),
                    ignore=no_module)
    strip = shutil.which("strip")
    if strip:  # debug information is most of the size
        for parent, _, names in os.walk(inside):
            for name in names:
                subprocess.run([strip, "--strip-unneeded", os.path.join(parent, name)], check=True)


def main():
    parser = argparse.ArgumentParser(description="Makes a wheel that carries libawd.")
    parser.add_argument("library", help="libawd.so")
    parser.add_argument("folder", help="where the wheel goes")
    arguments = parser.parse_args()
    with tempfile.TemporaryDirectory() as folder:
        stage(os.path.realpath(arguments.library), folder)
        subprocess.run([sys.executable, "-m", "pip", "wheel", "--no-build-isolation", "--no-index",
                        "--no-deps", "--disable-pip-version-check", "--quiet", "-w",
                        arguments.folder, folder], check=True)


if __name__ == "__main__":
    main()
