# SPDX-License-Identifier: Apache-2.0
"""Scenes, and the ways an array can lie in memory."""
import gc
import unittest

import numpy as np

import awd
from support import INDICES, MATERIALS, VERTICES, lamp

DOWN = awd.rays([[0, 3, 0], [5, 3, 0], [0.9, 0.5, 0.9]], (0, -1, 0))


class Layouts(unittest.TestCase):
    """Every layout gives the same scene; those that C can read are not copied."""

    def setUp(self):
        self.device = awd.Device()
        self.want = lamp(self.device).intersect(DOWN)

    def check(self, vertices, indices=INDICES, in_place=True, **mesh):
        array, stride = awd._arrays.rows(vertices, awd._arrays.FLOAT, 3, "vertices")
        self.assertEqual(np.shares_memory(array, vertices), in_place)
        hits = lamp(self.device, vertices, indices, **mesh).intersect(DOWN)
        np.testing.assert_array_equal(hits, self.want)

    def test_read_in_place(self):
        wide = np.full((len(VERTICES), 8), np.nan, np.float32)
        wide[:, 2:5] = VERTICES
        self.check(wide[:, 2:5])
        spread = np.full((3 * len(VERTICES), 3), np.nan, np.float32)
        spread[::3] = VERTICES
        self.check(spread[::3])
        odd = np.zeros(len(VERTICES) * 17 + 3, np.uint8)  # at no multiple of 4
        there = np.ndarray(VERTICES.shape, np.float32, odd, 1, (17, 4))
        there[...] = VERTICES
        self.check(there)
        frozen = VERTICES.copy()
        frozen.flags.writeable = False
        self.check(frozen)

    def test_converted(self):
        self.check(VERTICES.astype(np.float64), in_place=False)
        self.check(VERTICES.astype(">f4"), in_place=False)
        self.check(np.asfortranarray(VERTICES), in_place=False)
        self.check(VERTICES[::-1].copy()[::-1], in_place=False)
        self.check(VERTICES.tolist(), in_place=False)
        self.check(VERTICES, INDICES.astype(np.int64))
        self.check(VERTICES, INDICES.astype(">u2"))
        self.check(VERTICES, np.repeat(INDICES, 2, 0)[::2])

    def test_shared_arrays_live_until_commit(self):
        scene = awd.Scene(self.device)
        scene.add_material(0.5)
        scene.add_material(0.5, 4)
        scene.add_mesh(VERTICES.copy(), INDICES.copy(), MATERIALS.copy(), shared=True)
        gc.collect()
        scene.commit()
        np.testing.assert_array_equal(scene.intersect(DOWN), self.want)

    def test_refused(self):
        scene = awd.Scene(self.device)
        self.assertRaises(TypeError, scene.add_mesh, VERTICES.astype(complex), INDICES)
        self.assertRaises(TypeError, scene.add_mesh, VERTICES.astype(object), INDICES)
        self.assertRaises(TypeError, scene.add_mesh, VERTICES.astype(str), INDICES)
        self.assertRaises(TypeError, scene.add_mesh, VERTICES > 0, INDICES)
        self.assertRaises(TypeError, scene.add_mesh, VERTICES, INDICES.astype(float))
        self.assertRaises(ValueError, scene.add_mesh, VERTICES, INDICES.astype(int) - 1)
        self.assertRaises(ValueError, scene.add_mesh, VERTICES, INDICES.astype(int) << 32)
        self.assertRaises(ValueError, scene.add_mesh, VERTICES[:, :2], INDICES)
        self.assertRaises(ValueError, scene.add_mesh, VERTICES.ravel(), INDICES)
        self.assertRaises(awd.InvalidArgument, scene.add_mesh, VERTICES, INDICES, MATERIALS[:3])
        huge = np.broadcast_to(np.float32(1), (2**45, 3))
        self.assertRaises(MemoryError, scene.add_mesh, huge, INDICES)


class Scenes(unittest.TestCase):
    def setUp(self):
        self.device = awd.Device()
        self.scene = lamp(self.device, patches=[5, 5, 6, 7])

    def test_numbers_and_figures(self):
        scene = awd.Scene(self.device)
        self.assertEqual([scene.add_material(0), scene.add_material((0, 1, 0), 2)], [0, 1])
        self.assertEqual([scene.add_mesh(VERTICES, INDICES), scene.add_mesh([], [])], [0, 1])
        self.assertRaises(awd.InvalidOperation, scene.info)
        info = self.scene.info()
        self.assertEqual((info.triangles, info.materials, info.meshes), (4, 2, 1))
        self.assertEqual((info.lower, info.upper), ((-1, 0, -1), (1, 1, 1)))

    def test_hits(self):
        hits = self.scene.intersect(DOWN)
        self.assertEqual(hits["t"][0], 2)
        self.assertEqual(hits["mesh"].tolist(), [0, awd.INVALID_ID, 0])
        self.assertEqual(hits["patch"][2], 5)
        self.assertEqual(hits["material"][0], 1)
        self.assertEqual(self.scene.occluded(DOWN).tolist(), [True, False, True])
        self.assertEqual(self.scene.occluded(awd.rays((0, 3, 0), (0, -1, 0), 0, [1, 3])).tolist(),
                         [False, True])
        self.assertEqual(len(self.scene.intersect(DOWN[:0])), 0)

    def test_out(self):
        room = np.zeros((2, 3, 2), awd.HIT)
        for out in (room[0, :, 0], room[1, ::-1, 1], np.zeros(3, awd.HIT)):
            self.assertIs(self.scene.intersect(DOWN, out=out), out)
            np.testing.assert_array_equal(out, self.scene.intersect(DOWN))
        self.assertRaises(ValueError, self.scene.intersect, DOWN, out=np.zeros(2, awd.HIT))
        self.assertRaises(TypeError, self.scene.intersect, DOWN, out=np.zeros(3, awd.RAY))
        frozen = np.zeros(3, awd.HIT)
        frozen.flags.writeable = False
        self.assertRaises(ValueError, self.scene.intersect, DOWN, out=frozen)
        self.assertRaises(TypeError, self.scene.intersect, [(0,) * 8])

    def test_patches(self):
        self.assertEqual(self.scene.triangle_patch(0, 2), 6)
        self.assertEqual(self.scene.triangle_patch(0, 2, back=True), 6 | awd.PATCH_BACK)
        self.assertEqual(self.scene.point_patch((0, 0.1, 0)), 5)
        self.assertRaises(awd.InvalidArgument, self.scene.triangle_patch, 0, 4)

    def test_the_librarys_message(self):
        scene = awd.Scene(self.device)
        scene.add_mesh(VERTICES, INDICES + 8)
        message = "awdCommitScene: mesh 0, triangle 0 .* index 8"
        with self.assertRaisesRegex(awd.InvalidArgument, message) as caught:
            scene.commit()
        self.assertEqual(caught.exception.result, awd.Result.ERROR_INVALID_ARGUMENT)


if __name__ == "__main__":
    unittest.main()
