# SPDX-License-Identifier: Apache-2.0
# What pyproject.toml can't say: the version, which is that of the headers, and that a wheel which
# carries the library (wheel.py puts it into awd/_lib) is of one platform.
import os
import re

from setuptools import setup
from setuptools.dist import Distribution

here = os.path.dirname(os.path.abspath(__file__))
with_library = os.path.isdir(os.path.join(here, "awd", "_lib"))


def version():
    with open(os.path.join(here, "awd", "_c", "types.py"), encoding="utf-8") as file:
        text = file.read()
    return ".".join(re.search(rf"^AWD_VERSION_{part} = (\d+)$", text, re.M)[1]
                    for part in ("MAJOR", "MINOR", "PATCH"))


class Package(Distribution):
    def has_ext_modules(self):
        return with_library


options = {}
if with_library:
    from wheel.bdist_wheel import bdist_wheel

    class OfAnyPython(bdist_wheel):
        def get_tag(self):
            return "py3", "none", super().get_tag()[2]

    options["cmdclass"] = {"bdist_wheel": OfAnyPython}

setup(version=version(), distclass=Package, **options)
