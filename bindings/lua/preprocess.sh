#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# The public headers as LuaJIT reads them: awd.i has the declarations, awd.macros the macros.
#   preprocess.sh <C compiler> <include folder> <output folder>
set -euo pipefail
compiler=$1 include=$2 output=$3
mkdir -p "$output"
printf '#include <awd/awd.h>\n#include <awd/basis.h>\n' >"$output/awd.h"
"$compiler" -std=c99 -E -P -I"$include" "$output/awd.h" >"$output/awd.i"
"$compiler" -std=c99 -E -dM -I"$include" "$output/awd.h" >"$output/awd.macros"
