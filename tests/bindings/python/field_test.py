# SPDX-License-Identifier: Apache-2.0
"""Fields: what C says, through arrays of every layout."""
import ctypes
import os
import tempfile
import unittest

import numpy as np

import awd
from awd._library import lib
from support import UP, lamp

PATCH = 7


def trained(device, seed=1, **settings):
    """A field whose one patch knows that light comes from +x."""
    field = awd.Field(device, patches="host", **settings)
    random = np.random.default_rng(seed)
    for _ in range(3):
        samples = field.sample(PATCH, UP, random.random((2000, 3)))
        field.record(PATCH, samples, np.maximum(samples["direction"][:, 0], 0) ** 4)
        field.adapt()
    return field


class Fields(unittest.TestCase):
    def setUp(self):
        self.device = awd.Device()
        self.field = trained(self.device)
        self.uniforms = np.random.default_rng(2).random((40, 3))

    def test_many_are_as_one_by_one(self):
        samples = self.field.sample(PATCH, UP, self.uniforms)
        one = np.zeros(1, awd.DIRECTION_SAMPLE)
        normal = (ctypes.c_float * 3)(*UP)
        for u, sample in zip(self.uniforms, samples):
            lib.awdSampleField(self.field._handle, PATCH, normal, (ctypes.c_double * 3)(*u),
                               one.ctypes.data)
            self.assertEqual(one.tobytes(), sample.tobytes())
        pdfs = self.field.pdf([PATCH], UP, samples["direction"])
        np.testing.assert_allclose(pdfs, samples["pdf"], rtol=1e-3)
        for sample, pdf in zip(samples, pdfs):
            mapped = self.field.map_direction(PATCH, UP, sample["direction"])
            self.assertEqual(mapped["pdf"][0], pdf)

    def test_it_has_learned(self):
        towards, away = self.field.pdf(PATCH, UP, [[0.8, 0.6, 0], [-0.8, 0.6, 0]])
        self.assertGreater(towards, 3 * away)
        self.assertGreater(self.field.patch_mean(PATCH), 0)
        self.assertIsNone(self.field.patch_mean(PATCH + 8))
        info = self.field.patch_info(PATCH)
        self.assertEqual(info.basis, "linear-bspline")
        self.assertEqual(self.field.patch_coefficients(PATCH).shape, (info.axis_count,) * 2)
        self.assertEqual(self.field.patches().tolist(), [PATCH])
        self.assertGreater(self.field.continuation(PATCH, 1.0, 0.01), 1)
        self.assertIsNone(self.field.continuation(PATCH + 8, 1.0, 1.0))

    def test_layouts_of_inputs_and_outputs(self):
        samples = self.field.sample(PATCH, UP, self.uniforms)
        want = self.field.pdf(PATCH, UP, samples["direction"])
        wide = np.zeros((40, 5), np.float32)
        wide[:, 1:4] = samples["direction"]
        for directions in (wide[:, 1:4], samples["direction"], wide[:, 1:4].astype(">f8")):
            np.testing.assert_array_equal(self.field.pdf(PATCH, UP, directions), want)
        room = np.full((40, 3), -1, np.float32)
        for out in (room[:, 1], room[::-1, 2], np.empty(40, np.float32)):
            self.assertIs(self.field.pdf(PATCH, UP, wide[:, 1:4], out=out), out)
            np.testing.assert_array_equal(out, want)
        self.assertTrue((room[:, 0] == -1).all())
        numbers = np.full(40, PATCH, np.int64)
        np.testing.assert_array_equal(
            self.field.sample(numbers, np.tile(UP, (40, 1)), self.uniforms), samples)
        self.assertRaises(ValueError, self.field.pdf, [1, 2], UP, wide[:3, 1:4])
        self.assertRaises(ValueError, self.field.sample, PATCH, UP, self.uniforms[:, :2])
        self.assertRaises(awd.InvalidArgument, self.field.sample, PATCH, UP, self.uniforms + 1)
        self.assertRaises(TypeError, self.field.pdf, PATCH, UP, UP, out=[0.0])
        self.assertRaises(ValueError, self.field.record, PATCH, samples, [1.0, 2.0])

    def test_pdf_image_into_strides(self):
        want = self.field.patch_pdf(PATCH, 8)
        self.assertEqual((want.shape, want.dtype), ((8, 8), np.float32))
        self.assertAlmostEqual(self.field.patch_pdf(PATCH, 256).mean(), 1, delta=0.001)
        room = np.full((3, 16, 12), -1, np.float32)
        for out in (room[0, ::2, 2:10], room[1, 15:7:-1, 2:10], room[2, 2:10, :8].T):
            self.assertIs(self.field.patch_pdf(PATCH, 8, out=out), out)
            np.testing.assert_array_equal(out, want)
        self.assertEqual((room == -1).sum(), room.size - 3 * 64)
        row = np.full((8, 20), -1, np.float32)[:1, :1]
        self.field.patch_pdf(PATCH, 1, out=row)
        self.assertGreater(row[0, 0], 0)

    def test_paths(self):
        samples = self.field.sample(PATCH, UP, self.uniforms[:2])
        path = np.zeros(3, awd.PATH_VERTEX)
        path["patch"], path["continuation"][:2] = PATCH, 1
        path["sample"][:2] = samples
        path["scattering"] = 0.3
        path["emitted"][2] = (1, 2, 3)
        radiance = self.field.record_path(path)
        want = np.array([1, 2, 3]) * 0.09 / samples["pdf"].prod()
        np.testing.assert_allclose(radiance, want, rtol=1e-5)
        self.assertEqual(self.field.adapt().samples, 2)
        path["continuation"] = 1
        self.assertGreater(self.field.record_path(path, (9, 9, 9))[0], 0)

    def test_bytes_and_files(self):
        saved = self.field.save()
        for data in (saved, bytearray(saved), memoryview(saved), np.frombuffer(saved, np.uint8)):
            self.assertEqual(awd.Field.load(self.device, data).save(), saved)
        with tempfile.TemporaryDirectory() as folder:
            path = os.path.join(folder, "fïeld")
            self.field.write(path)
            self.assertEqual(awd.Field.read(self.device, path).save(), saved)
        self.assertRaises(awd.FileError, awd.Field.load, self.device, saved[:-1])
        self.assertRaises(OSError, awd.Field.read, self.device, "/nowhere/field")
        self.assertRaises(TypeError, awd.Field.load, self.device, "text")

    def test_merging_parts_of_a_pass(self):
        saved = self.field.save()
        samples = self.field.sample(PATCH, UP, self.uniforms)
        parts = [awd.Field.load(self.device, saved) for _ in range(2)]
        for part, items in zip(parts, (slice(0, 15), slice(15, 40))):
            part.record(PATCH, samples[items], samples["pdf"][items])
        self.field.record(PATCH, samples, samples["pdf"])
        parts[0].merge(parts[1])
        parts[0].adapt(), self.field.adapt()
        self.assertEqual(parts[0].save(), self.field.save())
        self.field.mark()
        before = self.field.save()
        self.field.record(PATCH, samples, samples["pdf"])
        self.field.revert()
        self.assertEqual(self.field.save(), before)

    def test_exchanging_parts_of_a_pass(self):
        samples = self.field.sample(PATCH, UP, self.uniforms)
        saved = self.field.save()
        ranks = [awd.Field.load(self.device, saved) for _ in range(2)]
        for rank in (*ranks, self.field):
            rank.adapt()
        for rank, items in zip(ranks, (slice(0, 15), slice(15, 40))):
            rank.record(PATCH, samples[items], samples["pdf"][items])
        self.field.record(PATCH, samples, samples["pdf"])
        parts = [rank.export_records([PATCH, PATCH + 1]) for rank in ranks]
        sums = parts[0].sums + parts[1].sums
        maxima = np.maximum(parts[0].maxima, parts[1].maxima)
        for rank in ranks:
            rank.import_records(sums, maxima, [PATCH, PATCH + 1])
            rank.adapt()
        self.field.adapt()
        for rank in ranks:
            np.testing.assert_array_equal(rank.patch_coefficients(PATCH),
                                          self.field.patch_coefficients(PATCH))
        one = ranks[0]
        self.assertEqual(parts[0].sums.dtype, np.uint64)
        self.assertRaises(awd.InvalidArgument, one.export_records, [2, 1])
        self.assertRaises(awd.InvalidArgument, one.import_records, sums[:-1], maxima, [PATCH])
        self.assertRaises(TypeError, one.import_records, sums.astype(float), maxima, [PATCH])
        self.assertRaises(ValueError, one.import_records, [-1], maxima, [PATCH])
        spatial = awd.Field(self.device, lower=(0, 0, 0), upper=(1, 1, 1))
        self.assertRaises(awd.InvalidArgument, spatial.export_records, [1])
        spatial.import_records(*spatial.export_records())

    def test_spatial_patches_and_lights(self):
        field = awd.Field(self.device, lower=(-1, -1, -1), upper=(1, 1, 1), light_powers=[1, 3])
        found = field.find_patches([[0, 0, 0], [0.5, 0, 0]], UP)
        self.assertEqual(found.shape, (2,))
        self.assertAlmostEqual(field.light_chance(int(found[0]), 1), 0.75)
        chosen = field.choose_light(int(found[0]), 0.5)
        self.assertEqual((chosen.light, chosen.chance), (1, 0.75))
        self.assertTrue(0 <= chosen.rest < 1)
        for _ in range(100):
            field.record_light(int(found[0]), 0, 2.0)
        field.adapt()
        self.assertGreater(field.patch_light(int(found[0])), 0)
        self.assertGreater(field.light_chance(int(found[0]), 0), 0.5)
        self.assertRaises(ValueError, awd.Field, self.device, light_powers=[1, 2], light_count=3)

    def test_settings(self):
        for basis, level, count in (("haar", 2, 4), ("linear-bspline", 2, 5)):
            field = awd.Field(lamp(self.device), basis=basis, start_level=level, max_level=level,
                              patches="host", preset=awd.Preset.PAPER, map="spherical")
            self.assertEqual(field.patch_info(0).axis_count, count)
        self.assertRaises(awd.Unsupported, awd.Field, self.device, basis="none")
        self.assertRaises(ValueError, awd.Field, self.device, map="flat")
        self.assertRaises(ValueError, awd.Field, self.device, basis="haar\0x")
        self.assertRaises(TypeError, awd.Field, self.device, basis=b"haar")
        self.assertRaises(awd.InvalidArgument, awd.Field, self.device, tau=2.0)
        field = awd.Field(self.device)
        field.set_scale(10)
        self.assertEqual(field.statistics().patches, 0)


if __name__ == "__main__":
    unittest.main()
