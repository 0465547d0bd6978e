#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# Installs by component, moves what was installed, and builds and runs against it what knows libawd
# by find_package alone, copied away from the source tree: the basis of examples/cubic-bspline, and
# hosts.
# shellcheck source-path=SCRIPTDIR source=support.sh
. "$(dirname "${BASH_SOURCE[0]}")/support.sh"
prefix=$work/moved
cp -r "$source/tests/install/consumer" "$source/examples/cubic-bspline" "$work"
cp "$source/examples/cubic-bspline/cubic.c" "$work/consumer"

# into PREFIX COMPONENT...
into() {
  local component
  for component in "${@:2}"; do
    quietly "$cmake" --install "$build" --prefix "$1" --component "$component"
  done
}
quietly "$cmake" --install "$build" --prefix "$work/first"
mv "$work/first" "$prefix"

# --- What is there ----------------------------------------------------------------------------
components=(runtime development bases)
[[ ! -f $build/lib/awd/refit-1.so ]] || components+=(refit)
[[ ! -f $build/bin/awd ]] || components+=(tools)
[[ ! -d $source/bindings/python/awd ]] || components+=(python)
for component in "${components[@]}"; do
  into "$work/parts/$component" "$component"
  files "$work/parts/$component" | grep -v '^share/doc/.*/copyright$' >"$work/$component.list" ||
    die "nothing in the component $component"
done
diff <(for component in "${components[@]}"; do files "$work/parts/$component"; done | sort) \
  <(files "$prefix") || die "the components are not the whole"
diff - "$work/runtime.list" <<<"$lib/libawd.so.$version
$lib/libawd.so.$abi" || die "not the runtime"
diff <({
  (cd "$source" && find include -name '*.h' -o -name '*.hpp')
  printf "$lib/%s\n" libawd.so pkgconfig/awd.pc \
    cmake/awd/{AddBasis,awdConfig,awdConfigVersion,awdTargets}.cmake
} | sort) <(grep -v 'awdTargets-.*\.cmake$' "$work/development.list") || die "not the development"
diff <(cd "$build/lib/awd/bases-1" && printf "$lib/awd/bases-1/%s\n" *) "$work/bases.list" ||
  die "not the bases"
# Versions beside each other share no file that one of them loads.
! find "$work" -maxdepth 1 -regex '.*/\(runtime\|bases\|refit\)\.list' -exec cat {} + | grep -vE \
  "^$lib/(libawd\.so\.[0-9]+|awd/bases-[0-9]+/[a-z-]+\.so$|awd/refit-[0-9]+\.so$)" ||
  die "a name without a number"

# Nothing in it knows where it was made, nor what libawd itself is made with.
cmake_folder=$prefix/$lib/cmake
! grep -rniE 'embree|tbb|openexr|imath|libpng|ceres|glog|awd-core|awd-settings' "$cmake_folder" \
  "$prefix/$lib/pkgconfig" || die "a dependency leaks"
! grep -rlF -e "$work" -e "$build" -e "$source" "$cmake_folder" "$prefix/$lib/pkgconfig" \
  "$prefix/include" || die "a path leaks"
while read -r file; do
  rpath=$("$readelf" -d "$file" | sed -n 's/.*R.*PATH.*\[\(.*\)\]/\1/p')
  [[ -z $rpath || $rpath == "\$ORIGIN"/* ]] || die "$file looks for libraries in $rpath"
done < <(find "$prefix" -type f \( -name '*.so*' -o -path '*/bin/*' \))
! needed "$prefix/$lib/libawd.so" | grep -iE 'ceres|glog' || die "libawd.so needs Ceres"

# Staged and without debug information the same files, and in these no path at all.
quietly env DESTDIR="$work/staged" "$cmake" --install "$build" --prefix /opt/awd --strip
diff <(files "$prefix") <(files "$work/staged/opt/awd") || die "not the same with DESTDIR"
[[ $(ls "$work/staged") == opt ]] || die "more than the prefix: $(ls "$work/staged")"
! grep -rlF -e "$work" -e "$build" -e "$source" "$work/staged" || die "a path leaks"
! "$readelf" -SW "$work/staged/opt/awd/$lib/libawd.so" | grep -F .debug_info || die "not stripped"

# --- A basis and hosts of others --------------------------------------------------------------
project cubic "$work/cubic-bspline" "$prefix"
module=$work/cubic/cubic-bspline.so
[[ -f $module ]] || die "no module"
wanted="bases"
[[ ! -f $build/bin/awd ]] || wanted+=";render"
[[ ! -f $build/lib/awd/refit-1.so ]] || wanted+=";refit"
project host "$work/consumer" "$prefix" -DAWD_WANTED="$version" -DAWD_COMPONENTS="$wanted"
for file in "$module" "$work/host/boxes.so"; do
  [[ $(exported "$file") == awdBasisModule_v1 ]] || die "$file exports: $(exported "$file")"
done
silent env AWD_BASIS_PATH="$work/cubic" "$work/host/host" "$module"
silent "$work/host/plusplus"
[[ $wanted == *render* ]] && renderer=render || renderer=none
silent "$work/host/plain" shipped "$renderer"

# With the refit module, if it was built, and without.
refit=$prefix/$lib/awd/refit-1.so
if [[ -f $refit ]]; then
  [[ $(exported "$refit") == awdRefitModule_v1 ]] || die "$refit exports: $(exported "$refit")"
  silent "$work/host/refit" there
  mkdir "$work/elsewhere"
  mv "$refit" "$work/elsewhere"
  silent env AWD_REFIT_PATH="$work/elsewhere" "$work/host/refit" there
fi
silent "$work/host/refit" "$refit"

if [[ -f $prefix/bin/awd ]]; then
  quietly "$prefix/bin/awd" check-basis "$work/host/boxes.so"
  quietly "$prefix/bin/awd" check-basis "$module"
  [[ $(grep -c ' ok$' "$work/log") -ge 24 ]] || die "too few checks"
  quietly env AWD_BASIS_PATH="$work/cubic" "$prefix/bin/awd" bases
  for line in '^cubic-bspline: ' "^  $module\$" "^  $prefix/$lib/awd/bases-1/haar.so\$"; do
    grep -q "$line" "$work/log" || die "awd bases does not say $line"
  done
fi
if [[ -d $source/bindings/python/awd ]]; then
  quietly env AWD_LIBRARY="$prefix/$lib/libawd.so.$abi" \
    PYTHONPATH="$prefix/lib/python3/dist-packages" PYTHONDONTWRITEBYTECODE=1 \
    /usr/bin/python3 -c 'import awd; awd.Device()'
fi

# --- Without some components ------------------------------------------------------------------
# What is wanted and isn't there is told, with the file or the remedy.
small=$work/small
into "$small" runtime development
for component in bases refit; do
  refused "component $component: there is no .*$small/.*; Debian has it in libawd-$component" \
    configure lacking "$work/consumer" "$small" -DAWD_COMPONENTS="$component"
done
refused "component glossy: there is none of that name, but render, bases and refit" \
  configure lacking "$work/consumer" "$small" -DAWD_COMPONENTS=glossy
refused 'version "99"' configure newer "$work/consumer" "$small" -DAWD_WANTED=99
# A host with a basis of its own, linked in, needs no other.
project small "$work/consumer" "$small" -DAWD_OPTIONAL="bases;refit"
grep -q 'bases: FALSE, refit: FALSE' "$work/small/found" || die "found: $(<"$work/small/found")"
silent "$work/small/plain" own "$renderer"
# Two at once in one process: each has the modules beside itself.
into "$small" bases
rm "$small/$lib/awd/bases-1"/[!h]*.so
silent "$work/host/sides" "$prefix/$lib" "$small/$lib"
finish
