# SPDX-License-Identifier: Apache-2.0
"""Renders and their films."""
import os
import tempfile
import unittest

import numpy as np

import awd
from support import CAMERA, lamp

SHAPE = (CAMERA.height, CAMERA.width, 3)


class Renders(unittest.TestCase):
    def setUp(self):
        self.device = awd.Device()
        self.scene = lamp(self.device)
        self.render = awd.Render(self.scene, CAMERA, seed=1)

    def test_the_film_in_any_layout(self):
        self.render.run(samples=8)
        film = self.render.film()
        self.assertEqual((film.shape, film.dtype), (SHAPE, np.float32))
        self.assertGreater(film.mean(), 0)
        height, width, _ = SHAPE
        colours = np.full((height, width, 4), -1, np.float32)
        larger = np.full((height + 4, width + 6, 3), -1, np.float32)
        spread = np.full((2 * height, 3 * width, 5), -1, np.float32)
        flipped = np.full(SHAPE, -1, np.float32)
        planes = np.full((3, height, width), -1, np.float32)
        bytes_ = np.zeros(film.nbytes + 1, np.uint8)[1:].view(np.float32).reshape(SHAPE)
        direct = [colours[..., :3], larger[2:-2, 3:-3], spread[1::2, 2::3, 1:4], bytes_]
        copied = [flipped[::-1], planes.transpose(1, 2, 0), np.full(SHAPE, -1, np.float32)[:, ::-1],
                  np.asfortranarray(flipped)]
        for out in direct + copied:
            strides = awd._arrays.image_strides(out, 12)
            self.assertEqual(strides is not None, any(out is known for known in direct))
            self.assertIs(self.render.film(out=out), out)
            np.testing.assert_array_equal(out, film)
        # Nothing beside the pixels was written.
        self.assertTrue((colours[..., 3] == -1).all())
        self.assertEqual((larger == -1).sum(), larger.size - film.size)
        self.assertEqual((spread == -1).sum(), spread.size - film.size)

    def test_outputs_that_are_refused(self):
        frozen = np.zeros(SHAPE, np.float32)
        frozen.flags.writeable = False
        for error, out in ((ValueError, frozen), (TypeError, np.zeros(SHAPE)),
                           (TypeError, np.zeros(SHAPE, ">f4")),
                           (ValueError, np.zeros(3, np.float32)),
                           (ValueError, np.zeros(SHAPE[:2], np.float32)), (TypeError, [[[0.0]]]),
                           (ValueError, np.broadcast_to(np.float32(0), SHAPE))):
            self.assertRaises(error, self.render.film, out=out)

    def test_one_pixel(self):
        render = awd.Render(self.scene, awd.Camera((0, 3, 0), (0, -1, 0), (1, 0, 0), width=1,
                                                   height=1))
        render.run_pass(4)
        out = np.zeros((4, 4, 3), np.float32)[::3, ::3][:1, :1]
        np.testing.assert_array_equal(render.film(out=out), render.film())

    def test_the_same_bits_for_any_threads(self):
        films = []
        for threads in (1, 2):
            with awd.Device(threads=threads) as device:
                render = awd.Render(lamp(device), CAMERA, seed=4)
                render.run(passes=[1, 2, 4])
                films.append(render.film())
                self.assertEqual([p.samples_per_pixel for p in render.passes()], [1, 2, 4])
        np.testing.assert_array_equal(*films)

    def test_figures(self):
        self.assertRaises(awd.InvalidOperation, self.render.error)
        statistics = self.render.run_pass(3)
        self.assertEqual(statistics.samples, 3 * CAMERA.width * CAMERA.height)
        self.render.field.adapt()
        self.render.run_pass(2)
        self.assertEqual(self.render.samples_per_pixel, 5)
        self.assertEqual(self.render.statistics().samples_per_pixel, 5)
        error = self.render.error()
        self.assertTrue(0 <= error.lower <= error.error <= error.upper)
        self.assertGreater(self.render.film("variance").max(), 0)
        self.assertEqual((self.render.width, self.render.height), (CAMERA.width, CAMERA.height))
        self.assertIsInstance(self.render.pixel_patch(12, 9), int)
        self.assertIsNone(self.render.pixel_patch(0, 0))
        self.assertRaises(awd.InvalidArgument, self.render.pixel_patch, 99, 0)

    def test_image(self):
        self.render.run(samples=6)
        image = self.render.image()
        np.testing.assert_array_equal(image.get("G"), self.render.film()[..., 1])
        self.assertEqual(image.metadata("awd.samples"), "6")

    def test_schedules(self):
        promise = awd.quality_schedule("draft")
        self.assertEqual((promise.error, promise.total_samples), (0.5, 1024))
        self.render.run(quality=awd.Quality.DRAFT)
        self.assertLessEqual(self.render.error().upper, 0.5)
        first = self.render.samples_per_pixel
        self.render.run(quality="reference", samples=first + 8)
        self.assertEqual(self.render.samples_per_pixel, first + first + 8)
        self.assertRaises(ValueError, self.render.run, passes=[])
        self.assertRaises(ValueError, self.render.run, quality="draft", error=0.1)
        self.assertRaises(ValueError, self.render.run, quality="best")
        self.assertRaises(awd.InvalidArgument, self.render.run, passes=[1, 0])
        self.assertRaises(TypeError, self.render.run, passes=[1.5])

    def test_going_on_from_a_checkpoint(self):
        passes = [1, 2, 4, 4]
        self.render.run(passes=passes)
        with tempfile.TemporaryDirectory() as folder:
            path = os.path.join(folder, "chéckpoint")
            render = awd.Render(self.scene, CAMERA, seed=1)
            render.run(passes=passes, resume=True, max_passes=2)
            self.assertEqual(render.samples_per_pixel, 3)
            render.save(path)
            render.close()
            loaded = awd.Render.load(self.scene, path)
            self.assertEqual([p.samples_per_pixel for p in loaded.passes()], [1, 2])
            loaded.run(passes=passes, resume=True)
            np.testing.assert_array_equal(loaded.film(), self.render.film())
            self.assertEqual(loaded.field.save(), self.render.field.save())
            self.assertEqual(loaded.samples_per_pixel, sum(passes))
            loaded.run(passes=passes, resume=True)  # nothing is left
            self.assertEqual(loaded.samples_per_pixel, sum(passes))

            same = awd.Field(self.scene)
            awd.Render.load(self.scene, path, CAMERA, same, seed=1)
            for camera, settings in ((CAMERA, {"seed": 2}), (CAMERA, {"seed": 1, "direct": "area"}),
                                     (awd.Camera(width=24, height=16), {"seed": 1})):
                self.assertRaises(awd.InvalidArgument, awd.Render.load, self.scene, path, camera,
                                  **settings)
            other = awd.Field(self.scene, basis="haar")
            self.assertRaises(awd.InvalidArgument, awd.Render.load, self.scene, path, CAMERA, other,
                              seed=1)
            self.assertRaises(ValueError, awd.Render.load, self.scene, path, seed=1)
            self.assertRaises(TypeError, awd.Render.load, self.scene, path, CAMERA, sed=1)
            with open(path, "r+b") as file:
                file.seek(100)
                file.write(b"damage")
            self.assertRaises(awd.FileError, awd.Render.load, self.scene, path)
        self.assertRaises(OSError, awd.Render.load, self.scene, path)
        self.assertRaises(OSError, self.render.save, "/nowhere/checkpoint")

    def test_parts_of_passes(self):
        schedule = {"passes": [1, 2, 4]}
        self.render.run(**schedule)
        ranks = [awd.Render(self.scene, CAMERA, seed=1) for _ in range(2)]
        self.assertRaises(awd.InvalidOperation, ranks[0].export_pass)
        while all([rank.run_part(i, 2, **schedule) for i, rank in enumerate(ranks)]):
            parts = [rank.export_pass() for rank in ranks]
            sums = parts[0].sums + parts[1].sums
            maxima = np.maximum(parts[0].maxima, parts[1].maxima)
            # A part that is there twice, or not at all.
            self.assertRaises(awd.InvalidArgument, ranks[0].import_pass, *parts[0])
            self.assertRaises(awd.InvalidArgument, ranks[0].import_pass, sums[1:], maxima)
            figures = [rank.import_pass(sums, maxima) for rank in ranks]
            self.assertEqual(figures[0].samples, figures[1].samples)
        for rank in ranks:
            np.testing.assert_array_equal(rank.film(), self.render.film())
            self.assertEqual(rank.field.save(), self.render.field.save())
        self.assertRaises(awd.InvalidArgument, ranks[0].run_part, 2, 2)
        self.assertRaises(ValueError, ranks[0].run_part, -1, 2)

    def test_a_field_that_is_used_before_the_import_is_refused_or_no_harm(self):
        """The header forbids it; from Python it must not crash."""
        for disturb in (awd.Field.adapt, awd.Field.revert, awd.Field.mark,
                        lambda field: self.render.run_pass(1)):
            self.render.run_part(0, 1, passes=[2] * 9)
            disturb(self.render.field)
            try:
                self.render.import_pass(*self.render.export_pass())
            except awd.Error:
                pass
            self.assertTrue(np.isfinite(self.render.film()).all())

    def test_settings(self):
        for settings in ({"guide": "cosine"}, {"guide": awd.Guide.UNIFORM, "direct": "area"},
                         {"preset": "paper"}, {"roulette": "throughput", "points": "random"},
                         {"field": awd.Field(self.scene, basis="haar"), "lights": "power"}):
            render = awd.Render(self.scene, CAMERA, **settings)
            render.run_pass(1)
        self.assertRaises(awd.InvalidArgument, awd.Render, self.scene, awd.Camera(width=0))
        self.assertRaises(ValueError, awd.Render, self.scene, awd.Camera(width=2**32))
        self.assertRaises(ValueError, awd.Render, self.scene, awd.Camera(eye=(0, 1e39, 0)))
        other = awd.Field(awd.Device())
        self.assertRaises(awd.InvalidArgument, awd.Render, self.scene, CAMERA, other)


if __name__ == "__main__":
    unittest.main()
