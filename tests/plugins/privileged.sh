#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# privileged.sh PROGRAM MODULE: the environment says where bases lie, unless the program runs with
# more rights than whoever started it has. Wants root, to give it them; else it is skipped (77).
set -euo pipefail
program=$1 module=$2

skip() {
  echo "skipped: $*"
  exit 77
}
[[ $EUID -eq 0 ]] || skip "not root"
command -v setpriv >/dev/null || skip "no setpriv"

folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
mkdir "$folder/bases"
cp "$module" "$folder/bases/"
cp "$program" "$folder/plain"
cp "$program" "$folder/privileged"
chmod -R go+rX "$folder"
chmod u+s "$folder/privileged"
export AWD_BASIS_PATH=$folder/bases

plain=$("$folder/plain")
[[ $plain == "secure 0 "*truthful* ]] || {
  echo "the environment was not followed: $plain"
  exit 1
}
privileged=$(setpriv --reuid=65534 --regid=65534 --clear-groups "$folder/privileged") ||
  skip "no such process can be started here"
[[ $privileged == "secure 1"* ]] || skip "set-user-ID has no effect here"
[[ $privileged == *haar* && $privileged != *truthful* ]] || {
  echo "the environment was followed: $privileged"
  exit 1
}
echo "the environment was ignored: $privileged"
