#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# Every public header compiles alone, twice in a row, in one language with one compiler; and so
# does every ..._INIT macro. Those of C++ want C++17, and compile with exceptions and without.
#   headers.sh <compiler> <c99|c++17|...> <include folder>
set -euo pipefail
compiler=$1 standard=$2 include=$3

language=c flags=(-Wstrict-prototypes)
if [[ $standard == c++* ]]; then language=c++ flags=(); fi

# compile FLAG...: what is on stdin.
compile() {
  "$compiler" "-std=$standard" -x "$language" -fsyntax-only -pedantic -Wall -Wextra -Werror \
    "${flags[@]}" "$@" -I "$include" -
}
# alone NAME FLAG...: a header by itself.
alone() {
  printf '#include "%s"\n#include "%s"\nint main(void) { return 0; }\n' "$1" "$1" |
    compile "${@:2}" || { echo "$1 does not compile alone as $standard with $compiler"; exit 1; }
}

headers=0
for header in "$include"/awd/*.h; do
  alone "awd/${header##*/}"
  headers=$((headers + 1))
done
[[ $headers -ge 7 ]] || { echo "only $headers headers in $include/awd"; exit 1; }

if [[ $language == c++ && $standard != c++11 ]]; then
  for mode in -fexceptions -fno-exceptions; do
    alone awd/awd.hpp -Wshadow -Wconversion -Wsign-conversion "$mode"
  done
fi
if [[ $standard == c++17 ]]; then
  headers=0
  for header in "$include"/awd/cpp/*.hpp; do
    alone "awd/cpp/${header##*/}"
    headers=$((headers + 1))
  done
  [[ $headers -ge 7 ]] || { echo "only $headers headers in $include/awd/cpp"; exit 1; }
fi

# A macro's form for C++ begins with the name of its type.
macros=0
program='#include "awd/awd.h"'$'\n''int main(void) {'$'\n'
while read -r macro type; do
  program+="  { $type value = $macro; (void)value; }"$'\n'
  macros=$((macros + 1))
done < <(cat "$include"/awd/*.h | tr -d '\\' | tr '\n' ' ' |
  grep -oE '#define AWD_[A-Z_]+_INIT +AWD[A-Za-z]+ *\{' | awk '{ print $2, $3 }')
[[ $macros -ge 3 ]] || { echo "only $macros ..._INIT macros found"; exit 1; }
compile <<<"$program  return 0; }" || { echo "an ..._INIT macro is wrong in $standard"; exit 1; }
