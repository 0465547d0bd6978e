# SPDX-License-Identifier: Apache-2.0
"""Densities on the unit cube."""
import unittest

import numpy as np

import awd


def learned(density, passes=3, count=2000, seed=1):
    random = np.random.default_rng(seed)
    for _ in range(passes):
        drawn = density.sample(random.random((count, density.uniforms)))
        f = drawn.points.prod(1) ** 2
        density.record(drawn.points, f, drawn.pdfs)
        density.adapt()
    return density


class Densities(unittest.TestCase):
    def setUp(self):
        self.device = awd.Device()
        self.random = np.random.default_rng(5)

    def test_the_estimate_is_the_integral(self):
        for structure in awd.Structure:
            density = learned(awd.Density(self.device, 2, structure=structure))
            estimate = density.estimate()
            # Seeds are fixed; by chance 1 in 16,000 would lie beyond 4 standard errors.
            self.assertLess(abs(estimate.integral - 1 / 9), 4 * estimate.standard_error)
            self.assertLess(estimate.standard_error, 0.01)
            self.assertEqual((estimate.samples, estimate.passes), (6000, 3))

    def test_points_and_pdfs(self):
        density = learned(awd.Density(self.device, 3))
        drawn = density.sample(self.random.random((50, 3)))
        np.testing.assert_array_equal(density.pdf(drawn.points), drawn.pdfs)
        np.testing.assert_array_equal(density.pdf(np.asfortranarray(drawn.points)), drawn.pdfs)
        room = np.zeros((50, 2))
        density.pdf(drawn.points, out=room[:, 1])
        np.testing.assert_array_equal(room[:, 1], drawn.pdfs)
        self.assertTrue((drawn.components == awd.INVALID_ID).all())
        self.assertAlmostEqual(density.integral(), 1)
        self.assertAlmostEqual(density.integral((0, 0, 0), (1, 1, 0.5))
                               + density.integral((0, 0, 0.5), (1, 1, 1)), 1)
        self.assertRaises(ValueError, density.sample, [[0.5, 0.5]])
        self.assertRaises(awd.InvalidArgument, density.sample, [[0.5, 0.5, 1.0]])

    def test_components(self):
        density = awd.Density(self.device, 1, sampler="component", estimator="paper",
                              axes=[awd.Axis("haar", 2, 2)])
        self.assertEqual((density.dimensions, density.uniforms), (1, 2))
        drawn = density.sample(self.random.random((400, 2)))
        np.testing.assert_array_equal(drawn.components, (drawn.points[:, 0] * 4).astype(np.uint32))
        density.record(drawn.points, drawn.points[:, 0], drawn.pdfs, drawn.components)
        self.assertEqual(density.adapt().estimator, awd.Estimator.PAPER)
        coefficients = density.coefficients()
        self.assertTrue((np.diff(coefficients) > 0).all())
        axis = density.axis_info(0)
        self.assertEqual((axis.basis, axis.level, axis.count), ("haar", 2, 4))
        self.assertIn(awd.BasisFlags.NESTED, axis.flags)

    def test_coefficients(self):
        density = awd.Density(self.device, 1, axes=[awd.Axis("haar", 1, 4)])
        density.set_coefficients([1, 3])
        np.testing.assert_allclose(density.coefficients(), [0.5, 1.5])
        np.testing.assert_allclose(density.coefficients("orthonormal") ** 2, [0.125, 1.125])
        np.testing.assert_allclose(density.detail_energy(), [1, 0.25])
        density.refine()
        density.refine(0)
        self.assertEqual(density.info().coefficients, 8)
        self.assertRaises(awd.InvalidArgument, density.set_coefficients, [1, 2, 3])

    def test_trees(self):
        density = learned(awd.Density(self.device, 2, structure="tree"))
        leaves = density.leaves()
        self.assertEqual(leaves.shape, (density.info().leaves, 2, 2))
        self.assertAlmostEqual((leaves[:, 1] - leaves[:, 0]).prod(1).sum(), 1)

    def test_forks_and_bytes(self):
        density = learned(awd.Density(self.device, 2))
        saved = density.save()
        drawn = density.sample(self.random.random((100, 2)))
        other = awd.Density.load(self.device, saved)
        other.record(drawn.points, drawn.pdfs, drawn.pdfs)
        with density.fork() as fork:
            fork.record(drawn.points[:40], drawn.pdfs[:40], drawn.pdfs[:40])
            density.record(drawn.points[40:], drawn.pdfs[40:], drawn.pdfs[40:])
            density.join(fork)
            self.assertEqual(fork.info().samples, 0)
        self.assertEqual(density.export_statistics(), other.export_statistics())
        again = awd.Density.load(self.device, saved)
        again.import_statistics(other.export_statistics())
        again.add_statistics(other.export_statistics())
        self.assertEqual(again.info().samples, 200)
        density.adapt(), other.adapt()
        self.assertEqual(density.save(), other.save())
        self.assertRaises(awd.FileError, awd.Density.load, self.device, saved[:-5])
        self.assertRaises(awd.InvalidArgument, density.join, density)

    def test_settings(self):
        info = awd.Density(self.device, 2, structure="tree", target="rms", tau=0.1,
                           combination=awd.Combination.CROSS_VARIANCE).info()
        self.assertEqual((info.structure, info.target, info.combination),
                         (awd.Structure.TREE, awd.Target.RMS, awd.Combination.CROSS_VARIANCE))
        self.assertRaises(ValueError, awd.Density, self.device, 7)
        self.assertRaises(ValueError, awd.Density, self.device, 2, axes=[awd.Axis()])
        self.assertRaises(TypeError, awd.Density, self.device, 1, axes=["haar"])
        self.assertRaises(awd.Unsupported, awd.Density, self.device, 1, axes=[awd.Axis("none")])


if __name__ == "__main__":
    unittest.main()
