# SPDX-License-Identifier: Apache-2.0
"""The C interface as it is: a module a header, in the order of the header and with its names.
What the header says of threads and errors holds here, and nothing is checked: the classes of awd
do that."""
from ._declare import Function as Function
from ._declare import functions as functions
from .basis import *
from .density import *
from .device import *
from .field import *
from .image import *
from .light import *
from .render import *
from .scene import *
from .types import *
