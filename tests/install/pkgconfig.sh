#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# A host that knows libawd by awd.pc alone, copied away from the source tree, in C99 and in C++,
# against what was installed and then moved. One more argument: pkg-config.
# shellcheck source-path=SCRIPTDIR source=support.sh
. "$(dirname "${BASH_SOURCE[0]}")/support.sh"
pkgconfig=$1 prefix=$work/moved
for component in runtime development bases; do
  quietly "$cmake" --install "$build" --prefix "$work/first" --component "$component"
done
mv "$work/first" "$prefix"
cp "$source/tests/install/consumer/plain.c" "$source/examples/cubic-bspline/cubic.c" "$work"
export PKG_CONFIG_LIBDIR=$prefix/$lib/pkgconfig
ask() { "$pkgconfig" "$@" awd; }

[[ $(ask --modversion) == "$version" ]] || die "version $(ask --modversion)"
[[ -z $(ask --print-requires)$(ask --print-requires-private) ]] || die "it requires others"
# One folder of headers, and libawd from one of libraries: static linking brings no more.
read -ra found < <(ask --cflags --libs --static)
[[ ${#found[@]} -eq 3 && ${found[0]} == -I* && ${found[1]} == -L* && ${found[2]} == -lawd ]] ||
  die "it gives ${found[*]}"
[[ ${found[0]#-I} -ef $prefix/include && ${found[1]#-L} -ef $prefix/$lib ]] ||
  die "it gives ${found[*]}"

[[ -f $build/bin/awd ]] && renderer=render || renderer=none
read -ra uses < <(ask --cflags --libs)
uses+=("-Wl,-rpath,$(ask --variable=libdir)")
cd "$work"
for compile in "$cc -std=c99 -x c plain.c" "$cxx -std=c++11 -x c++ plain.c"; do
  # shellcheck disable=SC2086 # these are words
  quietly $cc -std=c99 $flags ${found[0]} -c cubic.c
  # shellcheck disable=SC2086
  quietly $compile -x none cubic.o $flags "${uses[@]}" -o plain
  silent ./plain shipped "$renderer"
done
finish
