#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# Prints every #include that breaks the layers, and fails if there is one.
#   layers.sh <source folder>
# Dependencies run one way: api -> render -> guide -> density -> basis -> util, and image -> util.
# lib/refit stands alone; of it the library knows the table that it exports. Each library of others
# is known to one place. Whatever is not lib or tests/unit sees the public headers alone.
set -euo pipefail
cd "$1"
failed=0
folders=()
for folder in include lib bases bindings tests examples; do
  [[ ! -d $folder ]] || folders+=("$folder")
done

find "${folders[@]}" -type f -regex '.*\.\(h\|hpp\|c\|cpp\|in\)' -exec \
  grep -HnE '^[ \t]*#[ \t]*include' {} + | sort | awk '
  BEGIN {
    # What each folder of lib may include, itself and awd/ apart.
    may["util"] = " "
    may["basis"] = " util "
    may["density"] = " basis util "
    may["guide"] = " density basis util "
    may["render"] = " guide density basis util "
    may["image"] = " util "
    may["refit"] = " "
    may["api"] = " render image guide density basis util "
    # Headers of others, and the one place that may know each.
    known["^(embree[34]?|rtcore)"] = "^lib/render/embree\\.(h|cpp)$"
    known["^(OpenEXR/|Imath/)?(Imf|Imath|Iex|IlmThread)|^png\\.h$"] = "^lib/image/"
    known["^(ceres|glog|Eigen|suitesparse|cholmod)"] = "^lib/refit/"
    known["^(tbb|oneapi)/"] = "^lib/util/parallel\\.cpp$"
  }
  function bad(why) {
    print file ": " line ": " why
    ++count
  }
  {
    split($0, part, ":")
    file = part[1]
    line = $0
    sub(/^[^#]*/, "", line)
    if (!match(line, /["<][^">]*[">]/)) next
    quoted = substr(line, RSTART, 1) == "\""
    name = substr(line, RSTART + 1, RLENGTH - 2)
    split(file, at, "/")
    split(name, in_, "/")
    ++seen

    if (file !~ /^tests\/(unit|bench)\//) {
      for (pattern in known) {
        if (name ~ pattern && file !~ known[pattern]) bad("known to " known[pattern] " alone")
      }
    }
    inside = at[1] == "lib" || (at[1] == "tests" && at[2] == "unit")
    if (name ~ /(^|\/)\.\.\// && (inside || name ~ /(^|\/)(lib|unit)\//)) bad("a way round")
    if (at[1] == "include") {
      if (quoted && name !~ /^awd\//) bad("a public header includes public headers alone")
    } else if (at[1] == "lib" && (at[2] in may) && (in_[1] in may) && name ~ /\//) {
      allowed = in_[1] == at[2] || index(may[at[2]], " " in_[1] " ") ||
                (at[2] == "density" && name == "refit/refit_module.h")
      if (!allowed) bad(at[2] " is below " in_[1])
    } else if (!inside && (in_[1] in may) && name ~ /\//) {
      # A folder of the tests may have the name of one of lib.
      if (at[1] != "tests" || system("test -f \"tests/" name "\"") != 0) bad("not a public header")
    }
  }
  END {
    if (seen < 1) bad("no #include was seen")
    exit count > 0
  }' || failed=1

# Nor is anything else linked with what is hidden in libawd.
others=()
for folder in bases bindings tests examples; do
  [[ ! -d $folder ]] || others+=("$folder")
done
! find "${others[@]}" -path tests/unit -prune -o \( -name CMakeLists.txt -o -name '*.cmake' \) \
  -exec grep -HnE '\<awd-(core|refit-solvers)\>' {} + || failed=1
[[ $failed -eq 0 ]]
