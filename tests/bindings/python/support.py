# SPDX-License-Identifier: Apache-2.0
"""What the tests of the package share."""
import subprocess
import sys

import numpy as np

import awd

VERTICES = np.array([[-1, 0, 1], [1, 0, 1], [1, 0, -1], [-1, 0, -1],
                     [-0.5, 1, -0.5], [0.5, 1, -0.5], [0.5, 1, 0.5], [-0.5, 1, 0.5]], np.float32)
INDICES = np.array([[0, 1, 2], [0, 2, 3], [4, 5, 6], [4, 6, 7]], np.uint32)
MATERIALS = np.array([0, 0, 1, 1], np.uint32)
CAMERA = awd.Camera(eye=(0, 1.5, 3), look_dir=(0, -0.5, -1), width=24, height=16)
UP = (0.0, 1.0, 0.0)


def lamp(device, vertices=VERTICES, indices=INDICES, **mesh):
    """A grey floor under a lamp that shines down; committed."""
    scene = awd.Scene(device)
    scene.add_material(0.5)
    scene.add_material(0.5, (4, 4, 3))
    scene.add_mesh(vertices, indices, MATERIALS, **mesh)
    scene.commit()
    return scene


def python(code, *arguments, **options):
    """Runs a program in another Python, and returns what became of it."""
    return subprocess.run([sys.executable, "-c", code, *arguments], capture_output=True, text=True,
                          timeout=300, **options)
