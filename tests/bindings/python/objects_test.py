# SPDX-License-Identifier: Apache-2.0
"""The lives of objects: `with`, close, parents, and who may use them at once."""
import copy
import gc
import inspect
import threading
import unittest

import numpy as np

import awd
from awd._library import lib
from support import CAMERA, UP, lamp


class Released:
    """Counts the C references that are given back."""

    def __init__(self, kind):
        self.name, self.count = f"awdRelease{kind}", 0

    def __enter__(self):
        self.release = getattr(lib, self.name)

        def counted(pointer):
            self.count += 1
            self.release(pointer)

        setattr(lib, self.name, counted)
        return self

    def __exit__(self, *_):
        setattr(lib, self.name, self.release)


class Lives(unittest.TestCase):
    def test_with_releases_once(self):
        with Released("Device") as released:
            with awd.Device() as device:
                self.assertFalse(device.closed)
            self.assertTrue(device.closed)
            self.assertEqual(released.count, 1)
            device.close()
            del device
            gc.collect()
            self.assertEqual(released.count, 1)

    def test_forgetting_releases(self):
        with Released("Density") as released, awd.Device() as device:
            awd.Density(device, 1)
            self.assertEqual(released.count, 1)

    def test_a_copy_shares_the_reference(self):
        with Released("Device") as released:
            device = awd.Device()
            other = copy.copy(device)
            device.close()
            self.assertEqual(released.count, 0)
            self.assertTrue(other.bases())
            other.close()
            self.assertEqual(released.count, 1)

    def test_every_use_after_close_is_told(self):
        for kind in (awd.Device, awd.Scene, awd.Field, awd.Density, awd.Render, awd.Image):
            made = kind.__new__(kind)  # never opened, which is as good as closed
            self.assertTrue(made.closed)
            for name, value in inspect.getmembers(kind):
                if isinstance(value, property) and not name.startswith("_"):
                    if name in ("closed", "dimensions", "uniforms"):
                        continue
                    with self.subTest(kind=kind, name=name), \
                            self.assertRaisesRegex(awd.InvalidOperation, "closed"):
                        getattr(made, name)
        with awd.Device() as device:
            density = awd.Density(device, 1)
        density.close()
        for use in (density.info, density.fork, density.estimate, density.save, density.adapt,
                    density.__enter__, lambda: density.sample([[0.5]]),
                    lambda: density.join(density), lambda: awd.Scene(device), device.bases):
            self.assertRaisesRegex(awd.InvalidOperation, "closed", use)

    def test_children_keep_parents_alive(self):
        device = awd.Device(log=lambda severity, text: None)
        scene = lamp(device)
        device.close()
        field = awd.Field(scene)
        render = awd.Render(scene, CAMERA, field)
        scene.close()
        field.close()
        del device, scene, field
        gc.collect()
        render.run(samples=8)
        self.assertGreater(render.film().max(), 0)
        learned = render.field
        render.close()
        self.assertGreater(len(learned.patches()), 0)

    def test_closing_a_renders_field_harms_nothing(self):
        with awd.Device() as device, awd.Render(lamp(device), CAMERA) as render:
            with render.field as field:
                self.assertEqual(len(field.patches()), 0)
            render.run(samples=8)
            self.assertGreater(len(render.field.patches()), 0)
        with awd.Device() as device:
            self.assertIsNone(awd.Render(lamp(device), CAMERA, guide="cosine").field)

    def test_closed_within_a_call_it_lives_until_that_returns(self):
        with awd.Device() as device:
            render = awd.Render(lamp(device), CAMERA)
            with Released("Render") as released:
                render = awd.Render(lamp(device), CAMERA)
                counts = []

                def close(_):
                    render.close()
                    counts.append(released.count)

                render.run_pass(4, progress=close)
                self.assertEqual(set(counts), {0})
                self.assertEqual(released.count, 1)


class AtOnce(unittest.TestCase):
    def test_an_exclusive_object_is_refused_to_callbacks(self):
        with awd.Device() as device:
            scene = lamp(device)
            render = awd.Render(scene, CAMERA)
            field = render.field
            for use in (lambda: render.film(), lambda: render.run_pass(1),
                        lambda: field.patches(), lambda: scene.commit(),
                        lambda: awd.Render(scene, CAMERA, field)):
                with self.assertRaisesRegex(awd.InvalidOperation, "another call"):
                    render.run_pass(1, progress=lambda progress: use())
            # What is free may be used, and afterwards everything.
            render.run_pass(1, progress=lambda progress: scene.info())
            self.assertEqual(render.samples_per_pixel, 1)

    def test_an_exclusive_object_is_refused_to_other_threads(self):
        with awd.Device() as device:
            render = awd.Render(lamp(device), CAMERA)
            begun, refused = threading.Event(), threading.Event()

            def wait(_):
                begun.set()
                self.assertTrue(refused.wait(60))

            runner = threading.Thread(target=lambda: render.run_pass(1, progress=wait))
            runner.start()
            self.assertTrue(begun.wait(60))
            try:
                self.assertRaises(awd.InvalidOperation, render.film)
            finally:
                refused.set()
                runner.join()
            self.assertGreater(render.film().max(), 0)

    def test_free_calls_run_in_many_threads(self):
        with awd.Device() as device, awd.Field(device, patches="host") as field:
            random = np.random.default_rng(1)
            uniforms, errors = random.random((8, 500, 3)), []

            def work(mine):
                try:
                    samples = field.sample(7, UP, mine)
                    field.record(7, samples, samples["direction"][:, 0] ** 2)
                except BaseException as error:
                    errors.append(error)

            threads = [threading.Thread(target=work, args=(part,)) for part in uniforms]
            for thread in threads:
                thread.start()
            for thread in threads:
                thread.join()
            self.assertEqual(errors, [])
            self.assertEqual(field.adapt().samples, 4000)


if __name__ == "__main__":
    unittest.main()
