# SPDX-License-Identifier: Apache-2.0
# shellcheck shell=bash disable=SC2034 # what is set here is used there
# What the scripts of this folder share. Each is called with
#   <work folder> <cmake> <cc> <c++> <readelf> <nm> <build folder> <source folder> <lib folder>
#     <version> <abi> [more]
set -euo pipefail
work=$1 cmake=$2 cc=$3 cxx=$4 readelf=$5 nm=$6 build=$7 source=$8 lib=$9
version=${10} abi=${11}
shift 11
export LC_ALL=C CC=$cc CXX=$cxx
unset AWD_BASIS_PATH AWD_REFIT_PATH LD_LIBRARY_PATH CMAKE_PREFIX_PATH PKG_CONFIG_PATH DESTDIR
flags="-Wall -Wextra -Wpedantic -Werror"
rm -rf "$work"
mkdir -p "$work"
work=$(cd "$work" && pwd -P)

die() {
  echo "FAILED: $*"
  [[ ! -s $work/log ]] || tail -n 40 "$work/log"
  exit 1
}
quietly() { "$@" >"$work/log" 2>&1 || die "$*"; }
# silent COMMAND...: succeeds without a word.
silent() {
  quietly "$@"
  [[ ! -s $work/log ]] || die "output of: $*"
}
# refused PATTERN COMMAND...: fails, and says so.
refused() {
  ! "${@:2}" >"$work/log" 2>&1 || die "succeeded: ${*:2}"
  tr -s ' \n' ' ' <"$work/log" | grep -E "$1" >"$work/word" || die "no word of $1: ${*:2}"
}
# configure, or project which builds too: NAME SOURCE PREFIX OPTION..., knowing that prefix alone.
configure() {
  "$cmake" -G Ninja -S "$2" -B "$work/$1" -DCMAKE_PREFIX_PATH="$3" \
    -DCMAKE_FIND_USE_PACKAGE_REGISTRY=OFF -DCMAKE_C_FLAGS="$flags" -DCMAKE_CXX_FLAGS="$flags" \
    "${@:4}"
}
project() {
  quietly configure "$@"
  quietly "$cmake" --build "$work/$1"
}
needed() { "$readelf" -d "$1" | sed -n 's/.*(NEEDED).*\[\(.*\)\]/\1/p'; }
exported() {
  "$readelf" -W --dyn-syms "$1" | awk '$7 ~ /^[0-9]+$/ && $5 != "LOCAL" { print $8 }' |
    sed 's/@.*//' | grep -v '^AWD_'
}
# files FOLDER: what lies in it, in order.
files() { (cd "$1" && find . ! -type d | sed 's/^..//' | sort); }
finish() {
  rm -rf "$work"
  echo "all as it should be"
}
