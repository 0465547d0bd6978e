# SPDX-License-Identifier: Apache-2.0
"""awd.plot: what is drawn, and what is said without matplotlib."""
import os
import tempfile
import unittest

import numpy as np
from matplotlib import pyplot

import awd
from awd import plot
from field_test import PATCH, trained
from support import CAMERA, lamp, python


class Plots(unittest.TestCase):
    def tearDown(self):
        pyplot.close("all")

    def test_films(self):
        with awd.Device() as device:
            render = awd.Render(lamp(device), CAMERA)
            render.run(samples=4)
            shown = plot.show_film(render).images[0].get_array()
            np.testing.assert_array_equal(shown, plot.srgb(render.film()))
        # By the definition of sRGB; 0.002 is in its linear part.
        np.testing.assert_allclose(plot.srgb([[[0, 0.001, 0.25]]], 1.0),
                                   [[[0, 12.92 * 0.002, 1.055 * 0.5 ** (1 / 2.4) - 0.055]]],
                                   rtol=1e-6)
        np.testing.assert_allclose(plot.srgb([[[np.nan, np.inf, -1]]]), [[[0, 1, 0]]])

    def test_a_pdf_over_the_disk_integrates_to_1(self):
        with awd.Device() as device:
            field = trained(device)
            for normal in ((0, 1, 0), (0, 0, 1), (0, 0, -1), (0.6, 0, -0.8)):
                pdfs = plot.pdf_on_hemisphere(field, PATCH, 256, normal)
                inside = ~np.isnan(pdfs)
                self.assertAlmostEqual(inside.mean(), np.pi / 4, delta=0.01)
                # Equal areas are equal solid angles: 2 pi for the whole disk.
                self.assertAlmostEqual(pdfs[inside].mean() * 2 * np.pi, 1, delta=0.01)
            ax = plot.show_pdf(field, PATCH, 32)
            self.assertEqual(ax.images[0].get_array().shape, (32, 32))

    def test_directions(self):
        directions, inside = plot.hemisphere(64)
        np.testing.assert_allclose(np.linalg.norm(directions[inside], axis=-1), 1, atol=1e-6)
        self.assertGreater(directions[0, 32, 1], 0.9)  # up
        self.assertGreater(directions[32, 63, 0], 0.9)  # to the right

    def test_error_curves(self):
        ax = plot.show_error([1, 4, 16], [0.8, 0.4, 0.2], "mine")
        curve, slope = ax.lines
        np.testing.assert_array_equal(curve.get_ydata(), [0.8, 0.4, 0.2])
        np.testing.assert_allclose(slope.get_ydata(), [0.8, 0.2])
        self.assertIs(plot.show_error([1, 2], [0, np.nan], ax=ax), ax)
        with tempfile.TemporaryDirectory() as folder:
            path = os.path.join(folder, "curve.png")
            ax.figure.savefig(path)
            self.assertGreater(os.path.getsize(path), 1000)

    def test_wrong_values(self):
        self.assertRaises(ValueError, plot.show_film, [[1.0]])
        self.assertRaises(TypeError, plot.show_pdf, None, 1)
        self.assertRaises(ValueError, plot.hemisphere, 1)
        self.assertRaises(ValueError, plot.show_error, [1, 2], [1])

    def test_without_matplotlib(self):
        run = python("import sys; sys.modules['matplotlib'] = None\n"
                     "from awd import plot\n"
                     "try: plot.show_error([1], [1])\nexcept ImportError as e: print(e)")
        self.assertIn("apt-get install python3-matplotlib", run.stdout, run.stderr)


if __name__ == "__main__":
    unittest.main()
