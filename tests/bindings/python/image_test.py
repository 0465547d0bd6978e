# SPDX-License-Identifier: Apache-2.0
"""Images and their files."""
import os
import tempfile
import unittest

import numpy as np

import awd

PIXELS = np.arange(15, dtype=np.float32).reshape(3, 5)


class Images(unittest.TestCase):
    def setUp(self):
        self.device = awd.Device()
        self.image = awd.Image(self.device, 5, 3)

    def test_layouts(self):
        room = np.full((6, 20), -1, np.float32)
        room[1::2, 2:12:2] = PIXELS
        for given in (PIXELS, room[1::2, 2:12:2], PIXELS.astype(">f8"), PIXELS.tolist(),
                      np.asfortranarray(PIXELS), PIXELS[::-1].copy()[::-1]):
            self.image.set("Y", given)
            np.testing.assert_array_equal(self.image.get("Y"), PIXELS)
        for out in (room[1::2, 2:12:2], room[2::-1, :5], room[:5, 15:18].T):
            out[...] = -2
            self.assertIs(self.image.get("Y", out=out), out)
            np.testing.assert_array_equal(out, PIXELS)
        self.assertRaises(ValueError, self.image.set, "Y", PIXELS.T)
        self.assertRaises(ValueError, self.image.set, "Y\0", PIXELS)
        self.assertRaises(ValueError, self.image.get, "Y", out=PIXELS.T)
        self.assertRaises(TypeError, self.image.get, "Y", out=PIXELS.astype(float))
        with self.assertRaisesRegex(awd.InvalidArgument, "Y"):
            self.image.get("Z")

    def test_files(self):
        self.image.set("Y", PIXELS)
        self.image.set("depth", PIXELS + 1)
        self.image.set_metadata("mine", "größe")
        self.assertEqual(self.image.channels, ("Y", "depth"))
        with tempfile.TemporaryDirectory() as folder:
            path = os.path.join(folder, "ö.exr")
            self.image.write_exr(path)
            read = awd.Image.read(self.device, os.fsencode(path))
            self.image.write_png(os.path.join(folder, "a.png"), exposure=1)
            with open(os.path.join(folder, "a.png"), "rb") as file:
                self.assertEqual(file.read(4), b"\x89PNG")
            self.assertRaises(awd.FileError, awd.Image.read, self.device,
                              os.path.join(folder, "a.png"))
        self.assertEqual((read.width, read.height), (5, 3))
        np.testing.assert_array_equal(read.get("depth"), PIXELS + 1)
        self.assertEqual(read.metadata("mine"), "größe")
        read.set_metadata("mine", None)
        self.assertIsNone(read.metadata("mine"))

    def test_of_a_patch(self):
        field = awd.Field(self.device, patches="host", basis="haar", start_level=0)
        image = awd.Image.of_patch(field, 3, 4)
        np.testing.assert_array_equal(image.get("Y"), field.patch_pdf(3, 4))
        self.assertEqual(image.metadata("awd.patch"), "3")


if __name__ == "__main__":
    unittest.main()
