#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# Installs, moves what was installed, and builds and runs against it what knows libawd by
# find_package alone: the basis of examples/cubic-bspline, and a host.
#   install.sh <cmake> <readelf> <build folder> <source folder> <work folder> <lib folder>
#     <version> <with the command awd: ON or OFF>
set -euo pipefail
cmake=$1 readelf=$2 build=$3 source=$4 work=$5 lib=$6 version=$7 command=$8
export LC_ALL=C
unset AWD_BASIS_PATH AWD_REFIT_PATH LD_LIBRARY_PATH CMAKE_PREFIX_PATH
prefix=$work/moved flags="-Wall -Wextra -Wpedantic -Werror"

die() {
  echo "FAILED: $*"
  [[ ! -s $work/log ]] || tail -n 40 "$work/log"
  exit 1
}
quietly() { "$@" >"$work/log" 2>&1 || die "$*"; }
# silent COMMAND...: succeeds without a word.
silent() {
  "$@" >"$work/log" 2>&1 || die "$*"
  [[ ! -s $work/log ]] || die "output of: $*"
}
# project NAME SOURCE OPTION...: configures and builds, knowing the moved prefix alone.
project() {
  quietly "$cmake" -G Ninja -S "$2" -B "$work/$1" -DCMAKE_PREFIX_PATH="$prefix" \
    -DCMAKE_FIND_USE_PACKAGE_REGISTRY=OFF -DCMAKE_C_FLAGS="$flags" -DCMAKE_CXX_FLAGS="$flags" \
    "${@:3}"
  quietly "$cmake" --build "$work/$1"
}

rm -rf "$work"
mkdir -p "$work"
quietly "$cmake" --install "$build" --prefix "$work/first"
mv "$work/first" "$prefix"

# What is there.
diff <(cd "$source/include" && ls awd/*.h) <(cd "$prefix/include" && find . -type f | sed 's/..//' |
  sort) || die "not the headers"
for file in awdConfig awdConfigVersion awdTargets AddBasis; do
  [[ -f $prefix/$lib/cmake/awd/$file.cmake ]] || die "no $file.cmake"
done
[[ $(readlink "$prefix/$lib/libawd.so") == libawd.so.* ]] || die "libawd.so is no link"
diff <(cd "$build/lib/awd/bases-1" && ls) <(cd "$prefix/$lib/awd/bases-1" && ls) ||
  die "not the bases"

# Nothing in it knows where it was made, nor what libawd itself is made with.
! grep -rniE 'embree|tbb|openexr|imath|libpng|ceres|glog|awd-core|awd-settings' "$prefix/$lib/cmake" ||
  die "a dependency leaks"
! grep -rlF -e "$work" -e "$build" -e "$source" "$prefix/$lib/cmake" "$prefix/include" ||
  die "a path leaks"
while read -r file; do
  rpath=$("$readelf" -d "$file" | sed -n 's/.*R.*PATH.*\[\(.*\)\]/\1/p')
  [[ -z $rpath || $rpath == "\$ORIGIN"/* ]] || die "$file looks for libraries in $rpath"
done < <(find "$prefix" -type f \( -name '*.so*' -o -path '*/bin/*' \))

# A basis and a host of others.
project cubic "$source/examples/cubic-bspline"
module=$work/cubic/cubic-bspline.so
[[ -f $module ]] || die "no module"
project host "$source/tests/install/consumer" -DAWD_WANTED="$version"
for file in "$module" "$work/host/boxes.so"; do
  exported=$("$readelf" -W --dyn-syms "$file" | awk '$7 ~ /^[0-9]+$/ && $5 != "LOCAL" { print $8 }')
  [[ $exported == awdBasisModule_v1 ]] || die "$file exports: $exported"
done
silent env AWD_BASIS_PATH="$work/cubic" "$work/host/host" "$module"

# With the refit module, if it was built, and without.
refit=$prefix/$lib/awd/refit-1.so
! "$readelf" -d "$prefix/$lib/libawd.so" | grep -iE 'ceres|glog' || die "libawd.so needs Ceres"
if [[ -f $build/lib/awd/refit-1.so ]]; then
  exported=$("$readelf" -W --dyn-syms "$refit" |
    awk '$7 ~ /^[0-9]+$/ && $5 != "LOCAL" { print $8 }' | sed 's/@.*//' | grep -v '^AWD_')
  [[ $exported == awdRefitModule_v1 ]] || die "$refit exports: $exported"
  silent "$work/host/refit" there
  mkdir "$work/elsewhere"
  mv "$refit" "$work/elsewhere"
  silent env AWD_REFIT_PATH="$work/elsewhere" "$work/host/refit" there
fi
silent "$work/host/refit" "$refit"

# A host that wants another major version is told so.
if "$cmake" -G Ninja -S "$source/tests/install/consumer" -B "$work/newer" \
  -DCMAKE_PREFIX_PATH="$prefix" -DAWD_WANTED=99 >"$work/log" 2>&1; then
  die "version 99 was found"
fi
grep -q "version \"99\"" "$work/log" || die "no word about the version"

if [[ $command == ON ]]; then
  quietly "$prefix/bin/awd" check-basis "$work/host/boxes.so"
  quietly "$prefix/bin/awd" check-basis "$module"
  [[ $(grep -c ' ok$' "$work/log") -ge 24 ]] || die "too few checks"
  quietly env AWD_BASIS_PATH="$work/cubic" "$prefix/bin/awd" bases
  for line in '^cubic-bspline: ' "^  $module\$" "^  $prefix/$lib/awd/bases-1/haar.so\$"; do
    grep -q "$line" "$work/log" || die "awd bases does not say $line"
  done
fi
rm -rf "$work"
echo "all as it should be"
