#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# Builds a project that has a copy of libawd as its folder, on a machine that seems to have neither
# Embree nor OpenEXR nor any other library of others: densities and fields need none. Then the copy
# is deleted, and everything still runs.
# shellcheck source-path=SCRIPTDIR source=support.sh
. "$(dirname "${BASH_SOURCE[0]}")/support.sh"
tree=$work/tree
cp -r "$source/tests/install/embedding" "$tree"
cp "$source/tests/install/consumer/plain.c" "$source/examples/cubic-bspline/cubic.c" "$tree"
mkdir "$tree/libawd"
cp -r "$source"/{CMakeLists.txt,LICENSE,include,lib,bases,examples} "$tree/libawd"

hidden=()
for package in embree OpenEXR Imath PNG TBB Ceres Eigen3 glog; do
  hidden+=("-DCMAKE_DISABLE_FIND_PACKAGE_$package=TRUE")
done
# With all that libawd can have, its folder changes nothing of the project; and they are hidden.
quietly configure whole "$tree" "" -DAWD_RENDER=ON -DAWD_REFIT=ON
refused embree configure whole "$tree" "" -DAWD_RENDER=ON "${hidden[@]}"

start=$SECONDS
quietly configure bare "$tree" "" -DCMAKE_BUILD_TYPE=Debug -DCMAKE_CXX_FLAGS_DEBUG=-O0 \
  -DAWD_RENDER=OFF -DAWD_TBB=OFF -DCMAKE_UNITY_BUILD=ON "${hidden[@]}"
quietly "$cmake" --build "$work/bare" --parallel 2
echo "the build took $((SECONDS - start)) s"
cd "$work/bare"
library=libraries/libawd.so

# No header of others was read, among all that were.
ninja -t deps | sed -n 's/^    //p' | sed 's|^.*/tree/libawd/|libawd/|' | sort -u >headers
for header in '^libawd/include/awd/density\.h' '/c++/.*/vector'; do
  grep -q "$header\$" headers || die "$header was not read: $(wc -l <headers) headers were"
done
! grep -iE '/(embree|openexr|imath|imf|iex|tbb|oneapi|ceres|eigen|glog|png)[^/]*(/|\.h$)' headers ||
  die "headers of others were read"
others=$(needed "$library" |
  grep -vE '^(libc|libm|libgcc_s|libstdc\+\+|ld-linux.*)\.so\.[0-9]+$') || true
[[ -z $others ]] || die "libawd needs $others"
# It has every function all the same.
"$source/tests/abi/exports.sh" "$nm" "$readelf" "$library" "libawd.so.$abi" "AWD_$abi" \
  libraries/awd/bases-1/haar.so "$source"/include/awd/*.h

# Our warnings are not the project's, and it installs nothing of ours unless it wants to.
! grep -E '"command".*/plain\.c' compile_commands.json | grep -e -Wshadow -e -Wconversion ||
  die "our warnings in the project's programs"
quietly "$cmake" --install . --prefix "$work/installed"
[[ ! -e $work/installed ]] || die "installed: $(files "$work/installed")"
quietly "$cmake" . -DAWD_INSTALL=ON
quietly "$cmake" --install . --prefix "$work/installed"
cp -r "$source/tests/install/consumer" "$work"
refused "component render: this libawd was built with AWD_RENDER=OFF" \
  configure lacking "$work/consumer" "$work/installed" -DAWD_COMPONENTS="bases;render"
cp "$tree/cubic.c" "$work/consumer"
project host "$work/consumer" "$work/installed" -DAWD_COMPONENTS=bases
silent "$work/host/plain" shipped none

rm -r "$tree"
silent programs/plain shipped none
for command in "host-tracer --size 16 --samples 8 --reference-samples 16" \
  "awd-integrate ridge --dimensions 3 --evaluations 2e4"; do
  # shellcheck disable=SC2086 # these are words
  quietly programs/$command
  grep -qE '^(gain|value) +[0-9]' "$work/log" || die "$command says nothing"
done
cd "$work"
finish
