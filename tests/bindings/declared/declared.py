# SPDX-License-Identifier: Apache-2.0
"""Compares what a binding declares with the C headers.

declared.py INCLUDE_FOLDER C_COMPILER COMMAND...: runs the binding's command, which prints JSON:
  {"functions": {name: number of arguments}, "constants": {name: value},
   "structs": {name: {"size": bytes, "fields": {name: offset}}}}
and, if the binding knows more, "signatures", "kinds" and "defaults" as truth.py has them.
"""

import json
import pathlib
import subprocess
import sys

from compare import NEEDED, differences
from truth import ask_compiler


def main() -> int:
    include, compiler, *command = sys.argv[1:]
    truth = ask_compiler(compiler, pathlib.Path(include))
    output = subprocess.run(command, check=True, stdout=subprocess.PIPE).stdout
    found = differences(truth, json.loads(output))
    for line in found:
        print(line)
    counts = ", ".join(f"{len(truth[name])} {name}" for name in NEEDED)
    print(f"{len(found)} differences; the headers have {counts}")
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main())
