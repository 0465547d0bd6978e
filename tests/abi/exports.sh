#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# libawd exports exactly what its headers declare with AWD_EXPORT, all of one version, under the
# soname of its ABI; a basis module exports its entry point alone.
#   exports.sh <nm> <readelf> <libawd.so> <soname> <version> <module.so> <header>...
set -euo pipefail
nm=$1 readelf=$2 library=$3 soname=$4 version=$5 module=$6
shift 6

# The sanitizers' runtime leaves symbols of its own.
exported() {
  "$nm" -D --defined-only "$1" | awk '{ print $3 }' | grep -v '^__\(asan\|tsan\|odr\)' | sort
}

declared=$(cat "$@" | tr '\n' ' ' |
  grep -oE 'AWD_EXPORT [^;()]*AWD_CALL +awd[A-Za-z0-9_]+ *\(' |
  sed -E 's/.*AWD_CALL +//; s/ *\(//' | sort)
[[ $(wc -l <<<"$declared") -ge 20 ]] || { echo "too few declarations found: $declared"; exit 1; }

# The version itself is an absolute symbol.
got=$(exported "$library" | grep -vxE "$version(@@$version)?")
want=$(sed "s/\$/@@$version/" <<<"$declared" | sort)
if [[ $got != "$want" ]]; then
  echo "exported (<) is not what is declared (>):"
  diff <(echo "$got") <(echo "$want")
  exit 1
fi

"$readelf" -d "$library" | grep -qF "soname: [$soname]" ||
  { echo "soname is not $soname:"; "$readelf" -d "$library" | grep -i soname; exit 1; }

got=$(exported "$module")
[[ $got == awdBasisModule_v1 ]] || { echo "$module exports: $got"; exit 1; }
