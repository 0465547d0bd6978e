#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# A render in three runs, one of them killed, writes the file of one run.
#   resume.sh <resume>
set -euo pipefail
resume=$1
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cd "$work"
die() {
  echo "FAILED: $*"
  exit 1
}

"$resume" whole whole.exr 24 12
"$resume" parts parts.exr 24 12 2
! cmp -s parts.exr whole.exr || die "two passes are the whole"
"$resume" parts parts.exr 24 12 3 >out
grep -q 'parts: going on after 2 passes' out || die "it doesn't tell that it goes on"
"$resume" parts parts.exr 24 12 >out
grep -q 'going on after 5 passes' out || die "it doesn't tell that it goes on"
cmp parts.exr whole.exr || die "three runs differ from one"
# Nothing is left to do.
"$resume" parts again.exr 24 12
cmp again.exr whole.exr || die "a run without passes changed the film"

# Killed at any moment: the checkpoint is that of the last pass, or there is none yet.
"$resume" killed killed.exr 128 4096 >/dev/null &
sleep 0.5
kill -KILL $!
wait $! && die "it was not killed" || true
[[ ! -e killed ]] || "$resume" killed killed.exr 128 4096 1 | grep -q 'going on after' ||
  die "the checkpoint of a killed run can't be gone on with"

# Neither another image nor another file.
! "$resume" parts out.exr 25 12 2>err || die "another size was taken"
grep -q 'desc->camera' err || die "no word of the camera: $(cat err)"
head -c 1000 whole >damaged
! "$resume" damaged out.exr 24 12 2>err || die "a damaged checkpoint was taken"
grep -q '"damaged"' err || die "no word of the file: $(cat err)"
echo "all as it should be"
