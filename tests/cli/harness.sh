# SPDX-License-Identifier: Apache-2.0
# Shared by the test scripts, which are called with: awd, cli-tool, folder of test scenes.
set -u
awd=$1 tool=$2 scenes=$3
unset AWD_BASIS_PATH
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cd "$work" || exit 1
failures=0

complain() {
  echo "FAILED at line ${BASH_LINENO[1]}: $*"
  sed 's/^/  stdout: /' out
  sed 's/^/  stderr: /' err
  failures=$((failures + 1))
}

# succeeds COMMAND...: exit code 0.
succeeds() {
  "$@" >out 2>err
  local code=$?
  [ $code = 0 ] || complain "exit code $code of: $*"
}

# silent COMMAND...: exit code 0 and not a word.
silent() {
  "$@" >out 2>err
  local code=$?
  [ $code = 0 ] || complain "exit code $code of: $*"
  [ ! -s out ] && [ ! -s err ] || complain "output of: $*"
}

# fails CODE TEXT COMMAND...: that exit code, and one line on stderr, after "awd: ", with that text.
fails() {
  local want=$1 text=$2
  shift 2
  "$@" >out 2>err
  local code=$?
  [ $code = "$want" ] || complain "exit code $code instead of $want of: $*"
  [ ! -s out ] || complain "output on stdout of: $*"
  grep -q '^awd: ' err || complain "no message of: $*"
  grep -qF -- "$text" err || complain "no \"$text\" in the message of: $*"
}

# says TEXT: the last command said that on stderr.
says() { grep -qF -- "$1" err || complain "no \"$1\" on stderr"; }

# near A B TOLERANCE: two numbers differ by no more.
near() {
  awk -v a="$1" -v b="$2" -v t="$3" 'BEGIN { exit !(a != "" && a - b <= t && b - a <= t) }' ||
    complain "$1 is not $2 within $3"
}

absent() { [ ! -e "$1" ] || complain "$1 was written"; }

# No temporary file may stay behind.
clean() {
  local left
  left=$(find . -name '*.exr.??????' -o -name '*.json.??????' -o -name '*.png.??????')
  [ -z "$left" ] || complain "left behind: $left"
}

finish() {
  clean
  [ $failures = 0 ] && echo "all as it should be"
  exit $((failures > 0))
}
