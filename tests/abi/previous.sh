#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# What was compiled against former headers runs with this library.
#   previous.sh <source folder> <libawd.so> <work folder> <C compiler> <cmake> host|programs
# host: tests/abi/host.c of the previous commit, and of the last one with other headers, compiled
# against the headers of their time. programs, in ./run soak alone: all test programs of the
# previous commit that see the library from outside, built with the library of their time and run
# with this one. Where a test has changed since, the library may have been meant to: then it must
# run to its end, and what it says is only shown. Skipped (77) where there is no history.
set -euo pipefail
source=$1 library=$2 work=$3 cc=$4 cmake=$5 what=$6
export LC_ALL=C.UTF-8
programs=(density field host input misuse plugins scene-extremes)

skip() {
  echo "skipped: $*"
  exit 77
}
in_history() { git -C "$source" -c safe.directory='*' "$@" 2>/dev/null; }

[[ $what == host || -n ${AWD_SOAK:-} ]] || skip "a part of ./run soak"
command -v git >/dev/null || skip "no git"
[[ $(in_history rev-parse --show-toplevel) -ef $source ]] || skip "the sources are not from a clone"
abi_of() { in_history show "$1:CMakeLists.txt" | grep -oE '^set\(AWD_ABI [0-9]+\)' || true; }

# With changes that are not committed yet HEAD is the previous one.
revisions=()
if in_history diff --quiet HEAD --; then newest=HEAD^; else newest=HEAD; fi
previous=$(in_history rev-parse --verify --quiet "$newest^{commit}" || true)
[[ -z $previous ]] || revisions+=("$previous")
headers=$(in_history rev-list -1 "$newest" -- include || true)
headers=$(in_history rev-parse --verify --quiet "$headers^{commit}^" || true)
[[ -z $headers || $headers == "$previous" || $what != host ]] || revisions+=("$headers")
[[ ${#revisions[@]} -gt 0 ]] || skip "this clone has no history before HEAD"

# judge NAME STATUS FOLDER REVISION OUTPUT: of a program that has ended.
judge() {
  [[ $2 -ne 0 ]] || return 0
  printf '%s of %s, exit code %d:\n%s\n' "$1" "$4" "$2" "$5"
  [[ $2 -eq 1 ]] && ! in_history diff --quiet "$4" -- "$3" && return 0
  failed=1
}

failed=0 ran=0
for revision in "${revisions[@]}"; do
  if [[ $(abi_of "$revision") != "$(grep -oE '^set\(AWD_ABI [0-9]+\)' "$source/CMakeLists.txt")" ]]
  then
    echo "$revision has another AWD_ABI"
    continue
  fi
  old=$work/$what-$revision
  rm -rf "$work/$what"-*
  mkdir -p "$old"
  paths=()
  [[ $what != host ]] || paths=(include tests/abi/host.c)
  in_history archive "$revision" "${paths[@]}" | tar -x -C "$old" ||
    skip "$revision is not in this clone"
  if [[ $what == host ]]; then
    "$cc" -std=c99 -I "$old/include" "$old/tests/abi/host.c" "$library" \
      -Wl,-rpath,"$(dirname "$library")" -o "$old/host" ||
      { echo "the host of $revision can't be linked with this library"; exit 1; }
    status=0
    output=$(env -u AWD_BASIS_PATH "$old/host" 2>&1) || status=$?
    judge host "$status" tests/abi/host.c "$revision" "$output"
    ran=$((ran + 1))
  else
    "$cmake" -S "$old" -B "$old/build" -G Ninja -DCMAKE_BUILD_TYPE=Release -DAWD_TESTS=ON \
      -DAWD_EXAMPLES=OFF -DAWD_REFIT=OFF >"$old/configure.log"
    known=$(ninja -C "$old/build" -t targets all)
    built=()
    for program in "${programs[@]}"; do
      grep -q "^$program: phony" <<<"$known" || continue
      "$cmake" --build "$old/build" --target "$program" >"$old/$program.log"
      built+=("$program")
    done
    # In the place of its own, beside the modules of that time.
    cp "$library" "$old/build/lib/$(basename "$library")"
    for program in "${built[@]}"; do
      status=0
      output=$(cd "$old/build" && env -u AWD_SOAK "bin/$program" --gtest_brief=1 \
        --gtest_filter='-*Slow*' 2>&1) || status=$?
      judge "$program" "$status" "tests/${program//-/_}" "$revision" "$output"
      ran=$((ran + 1))
    done
  fi
  echo "$revision: done"
done
[[ $ran -gt 0 ]] || skip "nothing of the present ABI before HEAD"
exit "$failed"
