#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# Builds the site of a source folder; fails on a warning, on what is not documented, and on a header
# that is missing in it.
#   doxygen.sh <doxygen> <source folder> <work folder>
set -euo pipefail
doxygen=$1 source=$2 work=$3
rm -rf "$work"
mkdir -p "$work"
cd "$source"
(
  cat Doxyfile
  printf 'OUTPUT_DIRECTORY = "%s"\n' "$work"
) >"$work/Doxyfile"
"$doxygen" "$work/Doxyfile"
for header in include/awd/*.h; do
  name=$(basename "$header" .h)
  [[ -s $work/html/${name}_8h.html ]] || {
    echo "$header is not in the reference"
    exit 1
  }
done
[[ -s $work/html/index.html ]]
