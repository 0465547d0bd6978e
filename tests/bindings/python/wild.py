# SPDX-License-Identifier: Apache-2.0
"""Throws wild values at every public callable of the package. Prints what is wrong; a crash is for
wild_test.py, which runs this, to see.

Every callable has calls of its own that are right; in each of these one argument after the other is
replaced by every wild value. What comes out must be a result, or one of the errors that are
documented.
"""
import faulthandler
import inspect
import itertools
import resource
import sys
import warnings

import numpy as np

import awd
from awd import plot, progress
from support import CAMERA, INDICES, UP, VERTICES, lamp


class Own(Exception):
    """Raised by wild values themselves."""


ALLOWED = (TypeError, ValueError, MemoryError, ImportError, Own, awd.Error)


class Evil:
    """Fails at whatever it is asked for."""

    def fail(self, *_):
        raise Own()

    __array__ = __index__ = __float__ = __len__ = __getitem__ = __call__ = __fspath__ = fail
    __iter__ = __eq__ = __bool__ = __repr__ = fail
    __hash__ = object.__hash__


class Liar:
    """Answers, and never what was expected."""

    shape, dtype, ndim, strides = (2, 3), "f4", 2, (-1, -1)

    def __len__(self):
        return 2**40

    def __getitem__(self, _):
        return self

    def __float__(self):
        return 1e300

    def __index__(self):
        return 2**31


class Subclass(np.ndarray):
    """An array that claims to be another."""

    shape = (1, 3)
    strides = (0, 0)

    @property
    def __array_interface__(self):
        return {"data": (8, False), "shape": (9, 9), "typestr": "<f4", "version": 3}


def arrays():
    random = np.random.default_rng(1)
    yield from (np.zeros(shape, dtype) for shape in ((), 0, 3, (0, 3), (4, 3), (2, 3, 3))
                for dtype in ("f4", "f8", "i8", "u4"))
    for dtype in (">f4", ">u4", "i1", "f2", "g", "?", "c8", "O", "U3", "S3", "M8[s]", "V4"):
        yield np.zeros((4, 3), dtype)
    yield np.full((4, 3), np.nan)
    yield np.full((4, 3), np.inf, "f4")
    yield np.full((4, 3), 2**32 - 1, "u4")
    yield np.full(4, 2**63, "u8")
    yield np.full(4, -1)
    yield VERTICES[::-1]
    yield VERTICES[:, ::-1]
    yield np.asfortranarray(VERTICES)
    yield np.broadcast_to(np.float32(1), (4, 3))
    yield np.broadcast_to(np.float32(1), (2**45, 3))
    yield np.broadcast_to(np.uint32(1), 2**45)
    yield np.broadcast_to(np.int64(1), 2**45)
    yield np.ma.masked_all((4, 3))
    yield np.matrix(VERTICES)
    yield VERTICES.view(Subclass)
    frozen = np.zeros((CAMERA.height, CAMERA.width, 3), "f4")
    frozen.flags.writeable = False
    yield frozen
    yield np.zeros((CAMERA.height, CAMERA.width, 3), "f4")[::-1]
    for kind in (awd.RAY, awd.HIT, awd.DIRECTION_SAMPLE, awd.PATH_VERTEX):
        yield np.frombuffer(random.bytes(kind.itemsize * 5), kind)
        yield np.zeros(5, kind)[::-2]
        yield np.full(3, 255, "u1").repeat(kind.itemsize).view(kind)
    yield np.zeros(3, awd.RAY.newbyteorder())


def values():
    """Wild ones, made anew, since some change by being used."""
    itself = []
    itself.append(itself)
    device = awd.Device()
    closed = lamp(device)
    closed.close()
    return [
        None, True, -1, 0, 1, 2, 7, 20, 2**31 - 1, 2**31, 2**32 - 1, 2**32, 2**63, 2**64, -2**63,
        10**400, 0.5, -0.0, 1.0, 1e19, 3e38, 1e39, 1e308, 5e-324,
        float("nan"), float("inf"), -float("inf"), 1j,
        "", "x", "\0", "haar", "ceres", "paper", "adaptive", "\ud800", "/dev/null", "x" * 5000, b"",
        b"\0", b"abc", bytes(100), bytearray(10), memoryview(b"abcd")[::2], object(), int, Ellipsis,
        lambda *_: False, lambda *_: 1 / Evil().fail(), [], [[]], [0], [1.0, 2.0, 3.0],
        [float("nan")] * 3, (1, 2, 3), [[1, 2], [3]], itself, [None] * 3, ["a", "b", "c"], {},
        {0: 1, 1: 2, 2: 3}, {1, 2, 3}, range(3), iter([1, 2, 3]), Evil(), Liar(), [Evil()] * 3,
        [Liar()] * 3, awd.Guide.COSINE, awd.Camera(), awd.Camera(eye=None, width="x"),
        awd.Axis("\0"), [awd.Axis("haar", 2**40)], [awd.Axis()] * 2, device, closed,
        awd.Scene.__new__(awd.Scene), lamp(device), awd.Field(device), awd.Density(device, 2),
        awd.Render(lamp(device), CAMERA), awd.Image(device, 3, 2), *arrays()]


def stop():
    """A progress function that lets little work be done."""
    steps = itertools.count()
    return lambda _: next(steps) < 40


class World:
    """Objects to call methods of."""

    def __init__(self):
        self.device = awd.Device(progress=stop(), log=lambda *_: None)
        self.scene = lamp(self.device)
        self.bare = awd.Scene(self.device)
        self.field = awd.Field(self.device, patches="host", light_powers=[1, 2])
        self.spatial = awd.Field(self.scene)
        self.paper = awd.Field(self.device, preset="paper")
        self.samples = self.field.sample(3, UP, np.full((4, 3), 0.5))
        self.field.record(3, self.samples, 1.0)
        self.path = np.zeros(2, awd.PATH_VERTEX)
        self.density = awd.Density(self.device, 2)
        self.tree = awd.Density(self.device, 2, structure="tree")
        self.components = awd.Density(self.device, 2, sampler="component", estimator="paper")
        self.points = np.full((4, 2), 0.25)
        self.render = awd.Render(self.scene, CAMERA, max_bytes=2**28)
        self.render.run_pass(2)
        self.part, self.again = (awd.Render(self.scene, CAMERA) for _ in range(2))
        self.part.run_part(0, 1)
        self.image = awd.Image(self.device, 4, 3)
        self.image.set("Y", np.zeros((3, 4)))

    def calls(self):
        """(name, callable, arguments, named arguments): every public callable, rightly called."""
        w, film = self, np.zeros((CAMERA.height, CAMERA.width, 3), "f4")
        rays = awd.rays(VERTICES, UP)
        yield "Device", awd.Device, (), dict(
            threads=1, ignore_environment=True, log=None, progress=stop(), basis_paths=())
        yield "Device.bases", w.device.bases, (), {}
        yield "Device.load_basis", w.device.load_basis, ("/nowhere",), {}
        yield "check_basis", awd.check_basis, ("/nowhere",), {}
        yield "library_path", awd.library_path, (), {}
        yield "library_version", awd.library_version, (), {}
        yield "result_string", awd.result_string, (0,), {}
        yield "quality_schedule", awd.quality_schedule, (1,), {}
        yield "rays", awd.rays, (VERTICES, UP, 0, 1), {}

        yield "Scene", awd.Scene, (w.device,), {}
        yield "Scene.add_material", w.bare.add_material, (0.5, 0.5), {}
        yield "Scene.add_mesh", w.bare.add_mesh, (VERTICES, INDICES, 0, [1, 2, 3, 4]), dict(
            shared=True)
        yield "Scene.add_mesh", w.bare.add_mesh, (VERTICES, INDICES, [0] * 4), {}
        yield "Scene.commit", w.bare.commit, (), dict(progress=None)
        yield "Scene.info", w.bare.info, (), {}
        yield "Scene.intersect", w.scene.intersect, (rays, np.zeros(8, awd.HIT)), {}
        yield "Scene.occluded", w.scene.occluded, (rays,), {}
        yield "Scene.triangle_patch", w.scene.triangle_patch, (0, 0, False), {}
        yield "Scene.point_patch", w.scene.point_patch, (UP,), {}

        yield "Field", awd.Field, (w.scene,), dict(
            preset=0, map=0, basis=None, start_level=None, max_level=None, tau=0.0, estimator=0,
            refit_solver=None, shrinkage=0.0, patches=0, lower=(0, 0, 0), upper=(1, 1, 1),
            patch_samples=0, alpha=0.0, max_bytes=0, light_count=0, light_powers=[1, 2], target=0)
        yield "Field", awd.Field, (w.device,), dict(estimator="refit", refit_solver="descent",
                                                    max_level=3, shrinkage=1.0)
        yield "Field.load", awd.Field.load, (w.device, w.field.save()), {}
        yield "Field.read", awd.Field.read, (w.device, "/nowhere"), {}
        yield "Field.write", w.field.write, ("field",), {}
        yield "Field.save", w.field.save, (), {}
        yield "Field.merge", w.field.merge, (awd.Field.load(w.device, w.field.save()),), {}
        records = w.field.export_records([3])
        yield "Field.export_records", w.field.export_records, ([3],), {}
        yield "Field.import_records", w.field.import_records, (*records, [3]), {}
        yield "Field.import_records", w.spatial.import_records, w.spatial.export_records(), {}
        yield "Field.find_patches", w.spatial.find_patches, (VERTICES, UP, np.zeros(8, "u4")), {}
        for field in (w.field, w.spatial, w.paper):
            samples = field.sample(3, UP, np.full((4, 3), 0.5))
            yield "Field.sample", field.sample, (3, UP, np.full((4, 3), 0.5), samples.copy()), {}
            yield "Field.pdf", field.pdf, (3, UP, [UP] * 8, np.zeros(8, "f4")), {}
            yield "Field.pdf", field.pdf, ([3, 4], [UP, UP], [UP, UP]), {}
            yield "Field.map_direction", field.map_direction, (3, UP, UP), {}
            yield "Field.record", field.record, (3, samples, [1.0] * 4), {}
            yield "Field.record_path", field.record_path, (w.path, UP), {}
        yield "Field.set_scale", w.field.set_scale, (1.0,), {}
        yield "Field.mark", w.field.mark, (), {}
        yield "Field.revert", w.field.revert, (), {}
        for field in (w.field, w.spatial, w.paper):
            yield "Field.adapt", field.adapt, (), dict(progress=None)
        yield "Field.statistics", w.field.statistics, (), {}
        yield "Field.patches", w.field.patches, (), {}
        for name in ("patch_info", "patch_coefficients", "patch_mean", "patch_light"):
            yield f"Field.{name}", getattr(w.field, name), (3,), {}
        yield "Field.continuation", w.field.continuation, (3, 1.0, 1.0, 8), {}
        yield "Field.patch_pdf", w.field.patch_pdf, (3, 4, np.zeros((4, 4), "f4")), {}
        yield "Field.choose_light", w.field.choose_light, (3, 0.5), {}
        yield "Field.light_chance", w.field.light_chance, (3, 1), {}
        yield "Field.record_light", w.field.record_light, (3, 1, 1.0), {}

        yield "Axis", awd.Axis, ("haar", 1, 2), {}
        yield "Density", awd.Density, (w.device, 2), dict(
            structure=0, axes=[awd.Axis()] * 2, estimator=0, target=0, sampler=0, combination=0,
            tau=0.0, shrinkage=0.0, pass_samples=0, max_coefficients=0, refit_solver=None,
            refit_bytes=0)
        yield "Density.load", awd.Density.load, (w.device, w.tree.save()), {}
        for density in (w.density, w.tree, w.components):
            uniforms = np.full((4, density.uniforms), 0.5)
            numbers = density.sample(uniforms).components
            yield "Density.sample", density.sample, (uniforms,), {}
            yield "Density.pdf", density.pdf, (w.points, np.zeros(4)), {}
            yield "Density.record", density.record, (w.points, [1.0] * 4, [1.0] * 4, numbers), {}
            yield "Density.adapt", density.adapt, (), dict(progress=None)
            yield "Density.set_coefficients", density.set_coefficients, (
                density.coefficients(),), {}
            yield "Density.integral", density.integral, ([0, 0], [1, 1]), {}
            yield "Density.add_statistics", density.add_statistics, (
                density.export_statistics(),), {}
            yield "Density.import_statistics", density.import_statistics, (
                density.export_statistics(),), {}
            yield "Density.coefficients", density.coefficients, ("scaling",), {}
            yield "Density.axis_info", density.axis_info, (0,), {}
            for name in ("save", "fork", "estimate", "info", "leaves", "export_statistics"):
                yield f"Density.{name}", getattr(density, name), (), {}
        yield "Density.detail_energy", w.tree.detail_energy, (), {}
        yield "Density.join", w.density.join, (w.density.fork(),), {}
        yield "Density.refine", awd.Density(w.device, 2, pass_samples=64).refine, (0,), {}

        yield "Camera", awd.Camera, (UP, UP, UP, 0.5, 3, 3), {}
        yield "Render", awd.Render, (w.scene, CAMERA, w.spatial), dict(
            preset=0, guide=0, direct=0, roulette=0, shadow_rays=0, max_lights=0, seed=0,
            combination=0, points=0, max_bytes=0, max_split=0, lights=0)
        yield "Render.run_pass", w.render.run_pass, (1,), dict(progress=stop())
        yield "Render.run", w.render.run, (), dict(samples=2, seconds=0.0, error=0.0, passes=None,
                                                   quality=None, resume=False, max_passes=0,
                                                   progress=stop())
        yield "Render.run", w.render.run, (), dict(passes=[1, 1], progress=stop())
        yield "Render.run_part", w.again.run_part, (0, 1), dict(
            samples=0, error=0.0, passes=[2] * 9, quality=None, progress=stop())
        yield "Render.export_pass", w.part.export_pass, (), {}
        yield "Render.import_pass", w.part.import_pass, w.part.export_pass(), {}
        yield "Render.save", w.render.save, ("checkpoint",), {}
        yield "Render.load", awd.Render.load, (w.scene, "/nowhere", CAMERA, w.spatial), dict(
            preset=0, seed=0)
        yield "Render.film", w.render.film, (1, film), {}
        for name in ("image", "error", "passes", "statistics"):
            yield f"Render.{name}", getattr(w.render, name), (), {}
        yield "Render.pixel_patch", w.render.pixel_patch, (3, 4), {}

        yield "Image", awd.Image, (w.device, 3, 4), {}
        yield "Image.read", awd.Image.read, (w.device, "/nowhere"), {}
        yield "Image.of_patch", awd.Image.of_patch, (w.field, 3, 4), {}
        yield "Image.get", w.image.get, ("Y", np.zeros((3, 4), "f4")), {}
        yield "Image.set", w.image.set, ("Y", np.zeros((3, 4), "f4")), {}
        yield "Image.metadata", w.image.metadata, ("k",), {}
        yield "Image.set_metadata", w.image.set_metadata, ("k", "v"), {}
        yield "Image.write_exr", w.image.write_exr, ("a.exr",), {}
        yield "Image.write_png", w.image.write_png, ("a.png", 0.0), {}

        yield "plot.srgb", plot.srgb, (film, 0.0), {}
        yield "plot.hemisphere", plot.hemisphere, (8,), {}
        yield "plot.pdf_on_hemisphere", plot.pdf_on_hemisphere, (w.field, 3, 8, UP), {}
        yield "progress.Bar", progress.Bar, (), {}


# Draw what the others compute (plot_test.py has them), or are no calls of the library.
LEFT_OUT = {"plot.show_film", "plot.show_pdf", "plot.show_error", "progress.is_terminal",
            "progress.notebook_display"}


def public():
    """The names of all public callables."""
    kinds = (awd.Device.__base__, awd.Camera, awd.Axis)
    for name in awd.__all__:
        kind = getattr(awd, name)
        if inspect.isfunction(kind):
            yield name
        elif inspect.isclass(kind) and issubclass(kind, kinds):
            yield name
            for method, value in inspect.getmembers(kind, callable):
                if not method.startswith("_") and method != "close":
                    yield f"{name}.{method}"
    for module in (plot, progress):
        for name, value in vars(module).items():
            if not name.startswith("_") and getattr(value, "__module__", "") == module.__name__:
                yield f"{module.__name__[4:]}.{name}"


def is_large(value):
    return isinstance(value, Liar) or (isinstance(value, int) and value > 1000)


def attempt(name, function, arguments, named, place, counts):
    try:
        function(*arguments, **named)
        counts["taken"] += 1
    except ALLOWED:
        counts["refused"] += 1
    except BaseException as error:
        # An exception of the wild value's own making, in whatever chain.
        print(f"{name}, {place}: {type(error).__name__}: {error}")
        counts["wrong"] += 1


def main():
    faulthandler.enable()
    warnings.simplefilter("ignore")
    # What asks for more memory than that is out of memory, on any machine.
    resource.setrlimit(resource.RLIMIT_AS, (2**32, 2**32))
    counts = {"taken": 0, "refused": 0, "wrong": 0}
    called = {name for name, *_ in World().calls()}
    missing = set(public()) - called - LEFT_OUT
    if missing:
        print(f"without a call here: {sorted(missing)}")
        counts["wrong"] += 1
    wild = len(values())
    for number, (name, function, arguments, named) in enumerate(World().calls()):
        if name not in MAY_FAIL:
            function(*arguments, **named)
        for place in [*range(len(arguments)), *named]:
            # What went before may have grown the objects: a new world for every argument.
            fresh = next(itertools.islice(World().calls(), number, None))
            for i, value in enumerate(values()):
                if (name, place) == ("Render.run_pass", 0) and is_large(value):
                    continue  # right, and years of work before the first tile is done
                _, function, arguments, named = fresh
                if isinstance(place, int):
                    given = (*arguments[:place], value, *arguments[place + 1:])
                    attempt(name, function, given, named, f"{place} = value {i}", counts)
                else:
                    attempt(name, function, arguments, {**named, place: value},
                            f"{place} = value {i}", counts)
        attempt(name, function, [None] * 9, {}, "too many", counts)
    print(f"{counts['taken']} taken, {counts['refused']} refused, {counts['wrong']} wrong, of "
          f"{wild} values")
    return 1 if counts["wrong"] else 0


# Rightly called they fail, for want of a file, or of light.
MAY_FAIL = {"Device.load_basis", "check_basis", "Field.read", "Image.read", "Render.load",
            "Scene.commit", "Scene.info", "Density.refine"}

if __name__ == "__main__":
    sys.exit(main())
