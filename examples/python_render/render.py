#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Renders a room whose lamp shines at the ceiling, unguided and guided, and tells how both do."""
import argparse
import os

import numpy as np
import numpy.typing as npt

import awd

Floats = npt.NDArray[np.float32]

# Quads by a corner and two edges, seen from the side that the product of the edges points to.
GREY, RED, GREEN, BLACK = 0, 1, 2, 3
QUADS = [
    ((-1, 0, 1), (2, 0, 0), (0, 0, -2), GREY),  # floor
    ((-1, 2, -1), (2, 0, 0), (0, 0, 2), GREY),  # ceiling
    ((-1, 0, -1), (2, 0, 0), (0, 2, 0), GREY),  # behind
    ((1, 0, 1), (-2, 0, 0), (0, 2, 0), GREY),  # in front
    ((-1, 0, 1), (0, 0, -2), (0, 2, 0), RED),  # left
    ((1, 0, -1), (0, 0, 2), (0, 2, 0), GREEN),  # right
    ((-0.3, 1.7, 0.3), (0.6, 0, 0), (0, 0, -0.6), BLACK),  # the lamp, face up
]


def room(device: awd.Device) -> awd.Scene:
    scene = awd.Scene(device)
    scene.add_material(0.7)
    scene.add_material((0.6, 0.1, 0.1))
    scene.add_material((0.1, 0.5, 0.1))
    scene.add_material(0.0, 10.0)
    corners = np.array([[np.add(p, np.multiply(s, a)) + np.multiply(t, b)
                         for s, t in ((0, 0), (1, 0), (1, 1), (0, 1))]
                        for p, a, b, _ in QUADS], np.float32).reshape(-1, 3)
    first = 4 * np.arange(len(QUADS))[:, None, None]
    triangles = (first + [[0, 1, 2], [0, 2, 3]]).reshape(-1, 3)
    scene.add_mesh(corners, triangles, np.repeat([quad[3] for quad in QUADS], 2))
    scene.commit()
    return scene


def errors(render: awd.Render, passes: list[int], progress: bool) -> list[float]:
    """Of the film after each pass, as it knows it itself."""
    found = []
    for samples in passes:
        render.run_pass(samples, progress=progress)
        found.append(render.error().error)
        if render.field is not None:
            render.field.adapt()
    return found


def main() -> None:
    parser = argparse.ArgumentParser(description="Renders a room, unguided and guided.")
    parser.add_argument("--size", type=int, default=96, help="of the images, in pixels")
    parser.add_argument("--passes", type=int, default=6, help="of 2, 2, 4, 8, .. samples")
    parser.add_argument("--out", default=".", help="the folder to write into")
    parser.add_argument("--plot", action="store_true", help="draw curves too (wants matplotlib)")
    options = parser.parse_args()
    passes = [2] + [2 ** (i + 1) for i in range(options.passes - 1)]
    samples = np.cumsum(passes)
    camera = awd.Camera(eye=(0, 1, 0.95), tan_half_fov_x=0.9, width=options.size,
                        height=options.size)

    both: Floats = np.empty((options.size, 2 * options.size, 3), np.float32)
    curves = []
    with awd.Device() as device, room(device) as scene:
        for side, guide in enumerate((awd.Guide.COSINE, awd.Guide.ADAPTIVE)):
            with awd.Render(scene, camera, guide=guide, seed=1) as render:
                curves.append(errors(render, passes, progress=True))
                # Side by side, each written where it belongs.
                render.film(out=both[:, side * options.size:(side + 1) * options.size])
                field = render.field
                patch = render.pixel_patch(options.size // 2, options.size - 1)
            print(f"{guide.name.lower():<8} error {curves[-1][-1]:.4f} of the mean after "
                  f"{samples[-1]} samples a pixel")
        with awd.Image(device, 2 * options.size, options.size) as image:
            for channel, name in enumerate("RGB"):
                image.set(name, both[..., channel])
            image.write_png(os.path.join(options.out, "room.png"))

        if options.plot:
            from awd import plot

            axes = plot.show_error(samples, curves[0], "unguided")
            plot.show_error(samples, curves[1], "guided", axes)
            axes.figure.savefig(os.path.join(options.out, "error.png"))
            if field is not None and patch is not None:
                axes = plot.show_pdf(field, patch, normal=(0, 1, 0))
                axes.figure.savefig(os.path.join(options.out, "pdf.png"))


if __name__ == "__main__":
    main()
