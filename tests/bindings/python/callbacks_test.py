# SPDX-License-Identifier: Apache-2.0
"""Log and progress, exceptions that come through them, and Ctrl-C."""
import sys
import threading
import unittest

import numpy as np

import awd
from support import CAMERA, INDICES, VERTICES, lamp, python

def dark(device):
    """A scene without light, of which commit warns."""
    scene = awd.Scene(device)
    scene.add_material(0.5)
    scene.add_mesh(VERTICES, INDICES)
    return scene


class Log(unittest.TestCase):
    def test_messages(self):
        told = []
        with awd.Device(log=lambda *message: told.append(message)) as device:
            dark(device).commit()
        self.assertIn(awd.Severity.WARNING, [severity for severity, _ in told])
        self.assertTrue(all(isinstance(text, str) and text for _, text in told))

    def test_an_exception_comes_out_of_the_call(self):
        def fail(severity, text):
            raise LookupError(text)

        with awd.Device(log=fail) as device:
            scene = dark(device)
            self.assertRaises(LookupError, scene.commit)
            # It is told once.
            self.assertEqual(scene.add_material(1), 1)


class Progress(unittest.TestCase):
    def setUp(self):
        self.device = awd.Device()
        self.render = awd.Render(lamp(self.device), CAMERA, seed=3)

    def test_fractions_rise_to_1(self):
        told = []
        self.render.run(passes=[2, 3], progress=told.append)
        self.assertEqual([p.operation for p in told if p.fraction == 1.0],
                         ["pass", "adapt", "pass"])
        fractions = [p.fraction for p in told if p.operation == "adapt"]
        self.assertEqual(fractions, sorted(fractions))

    def test_false_cancels_and_the_film_stays(self):
        self.render.run_pass(2)
        before = self.render.film()
        self.assertRaises(awd.Cancelled, self.render.run_pass, 2, progress=lambda p: False)
        np.testing.assert_array_equal(self.render.film(), before)
        self.assertEqual(self.render.samples_per_pixel, 2)
        self.render.run_pass(2, progress=lambda p: None)  # None is not False
        self.render.run_pass(2, progress=lambda p: 0)
        self.assertEqual(self.render.samples_per_pixel, 6)

    def test_an_exception_cancels_and_comes_out(self):
        calls = []

        def fail(progress):
            calls.append(progress)
            raise ZeroDivisionError("mine")

        with self.assertRaisesRegex(ZeroDivisionError, "mine"):
            self.render.run_pass(1, progress=fail)
        self.assertEqual(len(calls), 1)
        self.assertEqual(self.render.samples_per_pixel, 0)

    def test_any_exception_even_those_that_end_programs(self):
        for kind in (KeyboardInterrupt, SystemExit, GeneratorExit, MemoryError):
            def fail(progress):
                raise kind()

            self.assertRaises(kind, self.render.run_pass, 1, progress=fail)

    def test_from_other_threads_too(self):
        caught = []

        def work():
            try:
                self.render.run_pass(1, progress=lambda p: 1 / 0)
            except ZeroDivisionError as error:
                caught.append(error)

        thread = threading.Thread(target=work)
        thread.start()
        thread.join()
        self.assertEqual(len(caught), 1)

    def test_the_devices_own(self):
        told = []
        with awd.Device(progress=told.append) as device:
            scene = lamp(device)
            self.assertIn("commit", [p.operation for p in told])
            awd.Render(scene, CAMERA).run_pass(1)
            self.assertIn("pass", [p.operation for p in told])
        with awd.Device(progress=lambda p: 1 / 0) as device:
            self.assertRaises(ZeroDivisionError, lamp, device)
        with awd.Device(progress=lambda p: False) as device:
            self.assertRaises(awd.Cancelled, lamp, device)

    def test_refit_can_be_cancelled(self):
        with awd.Device() as device:
            try:
                density = awd.Density(device, 2, estimator="refit")
            except awd.Unsupported:
                self.skipTest("this build has no refit module")
            drawn = density.sample(np.random.default_rng(1).random((2000, 2)))
            density.record(drawn.points, drawn.points.sum(1), drawn.pdfs)
            self.assertRaises(awd.Cancelled, density.adapt, progress=lambda p: False)
            self.assertEqual(density.info().samples, 2000)

    def test_a_wrong_function_is_refused(self):
        for wrong in (1, "yes", [], object()):
            self.assertRaises(TypeError, self.render.run_pass, 1, progress=wrong)
            self.assertRaises(TypeError, awd.Device, progress=wrong)
            self.assertRaises(TypeError, awd.Device, log=wrong)


INTERRUPTED = """
import os, signal, sys, threading
import awd
from support import CAMERA, lamp
camera = awd.Camera(CAMERA.eye, CAMERA.look_dir, width=64, height=64)
render = awd.Render(lamp(awd.Device(threads=int(sys.argv[1]))), camera)
render.run_pass(1)
before = render.film().tobytes()
tiles = []
def press(progress):
    if not tiles:
        os.kill(os.getpid(), signal.SIGINT)
        # Python's main thread must come to see it before the work ends.
        for _ in range(10000):
            if seen.wait(0.001): break
    tiles.append(progress)
seen = threading.Event()
class Told(KeyboardInterrupt): pass
def handler(number, frame):
    seen.set()
    raise Told()
signal.signal(signal.SIGINT, handler)
try:
    render.run_pass(500, progress=press)
    print("went on")
except Told:
    print("interrupted after", len(tiles))
    print(render.film().tobytes() == before, render.samples_per_pixel)
    render.run_pass(1)
    print(render.samples_per_pixel)
"""


class Interrupt(unittest.TestCase):
    def test_ctrl_c_cancels_a_render(self):
        for threads in ("1", "2"):
            run = python(INTERRUPTED, threads, cwd=sys.path[0])
            self.assertEqual(run.stderr, "")
            lines = run.stdout.splitlines()
            self.assertRegex(lines[0], r"^interrupted after [1-9]$")
            self.assertEqual(lines[1:], ["True 1", "2"])


if __name__ == "__main__":
    unittest.main()
