#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# layers.sh sees each violation that is planted in a copy of the sources, and nothing without one.
#   planted.sh <source folder> <work folder>
set -euo pipefail
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
source=$1 work=$2
rm -rf "$work"
mkdir -p "$work"
(cd "$source" && find include lib bases bindings tests examples -type f \
  \( -name '*.[ch]' -o -name '*.[ch]pp' -o -name CMakeLists.txt -o -name '*.cmake' \) \
  -exec cp --parents -t "$work" {} + 2>/dev/null) || true
"$here/layers.sh" "$work" || { echo "FAILED: a violation in what was copied"; exit 1; }

# plant FILE LINE: with that line at its end the file breaks the layers.
plant() {
  local found
  [[ -f $work/$1 ]] || { echo "FAILED: there is no $1"; exit 1; }
  cp "$work/$1" "$work/kept"
  printf '%s\n' "$2" >>"$work/$1"
  if found=$("$here/layers.sh" "$work") || [[ $found != "$1:"*"$2"* || $found == *$'\n'* ]]; then
    echo "FAILED: $2 at the end of $1: found \"$found\""
    exit 1
  fi
  mv "$work/kept" "$work/$1"
}
plant lib/util/error.h '#include "basis/family.h"'
plant lib/basis/family.cpp '#include "density/grid.h"'
plant lib/density/grid.cpp '#include "guide/field.h"'
plant lib/density/grid.cpp '#include "refit/solver.h"'
plant lib/guide/field.h '#  include "render/film.h"'
plant lib/guide/field.h '#include "api/guard.h"'
plant lib/guide/field.h '#include "../render/film.h"'
plant lib/render/film.cpp '#include "image/image.h"'
plant lib/image/image.cpp '#include "render/film.h"'
plant lib/refit/solver.h '#include "util/error.h"'
plant lib/render/scene.cpp '#include <embree3/rtcore.h>'
plant lib/render/film.cpp '#include <ImfRgba.h>'
plant lib/density/refit.cpp '#include <ceres/ceres.h>'
plant lib/density/refit.cpp '#include <Eigen/Core>'
plant lib/guide/field.cpp '#include <tbb/parallel_for.h>'
plant include/awd/field.h '#include "guide/field.h"'
plant include/awd/scene.h '#include <embree3/rtcore.h>'
plant bases/haar/haar.c '#include "basis/family.h"'
plant examples/awd/main.cpp '#include "util/error.h"'
plant tests/field/path_test.cpp '#include "guide/field.h"'
plant tests/field/path_test.cpp '#include "../../lib/guide/field.h"'
plant tests/CMakeLists.txt 'target_link_libraries(field PRIVATE awd-core)'
rm -rf "$work"
