#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# Any number of processes writes the image and the checkpoint of one, and another number of them
# goes on where one has died.
#   mpi.sh <mpiexec> <mpi-render> <resume>
set -euo pipefail
mpiexec=$1 render=$2 resume=$3
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cd "$work"
# OpenMPI on one machine, of fewer cores than ranks, perhaps as root in a container.
export OMPI_ALLOW_RUN_AS_ROOT=1 OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1 OMPI_MCA_rmaps_base_oversubscribe=1
export OMPI_MCA_plm=isolated OMPI_MCA_btl=self,vader OMPI_MCA_btl_vader_single_copy_mechanism=none
export OMPI_MCA_mpi_yield_when_idle=1 TMPDIR=$work
die() {
  echo "FAILED: $*"
  exit 1
}

# A process that knows nothing of MPI, by awdRenderPasses.
"$resume" alone alone.exr 40 20
for ranks in 1 2 4; do
  "$mpiexec" -n $ranks "$render" by$ranks by$ranks.exr 40 20 >out 2>err || die "$(cat out err)"
  cmp by$ranks.exr alone.exr || die "the image of $ranks ranks differs from that of one process"
  grep -qE '^pass 7: 4 samples, .* [0-9]+ bytes$' out || die "no figures of a pass: $(cat out)"
done

# The last of four dies in the fifth pass: the job ends, says so, and leaves four passes.
if "$mpiexec" -n 4 "$render" died died.exr 40 20 5 >out 2>err; then die "nobody died"; fi
grep -q 'rank 3 .* signal 9' err || die "who died is not told: $(cat err)"
[[ ! -e died.exr ]] || die "an image of a job that failed"
cp died died.copy
"$mpiexec" -n 2 "$render" died died.exr 40 20 >out 2>err || die "$(cat out err)"
grep -q 'going on after 4 passes' out || die "it doesn't tell that it goes on: $(cat out)"
cmp died.exr alone.exr || die "two ranks don't go on to the same image"
"$resume" died.copy one.exr 40 20 >out
grep -q 'going on after 4 passes' out || die "it doesn't tell that it goes on: $(cat out)"
cmp one.exr alone.exr || die "one process doesn't go on to the same image"

# An error of the library ends the job likewise.
if "$mpiexec" -n 2 "$render" by2 out.exr 41 20 >out 2>err; then die "another size was taken"; fi
grep -q 'mpi-render: rank [01] of 2: .*desc->camera' err || die "no word of the camera: $(cat err)"
echo "all as it should be"
