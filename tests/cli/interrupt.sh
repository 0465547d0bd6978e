# SPDX-License-Identifier: Apache-2.0
# Ctrl-C: passes that have ended are written, and the exit code tells.
set -m # background jobs of a script would ignore SIGINT
source "$(dirname "$0")/harness.sh" "$@"

# How long until the first pass has ended depends on the machine: wait longer until it has.
for wait in 1 4 16 64; do
  rm -f out.exr
  "$awd" render "$scenes/box.obj" -o out.exr --passes 100000 --spp 1 --json s.json >out 2>err &
  job=$!
  sleep $wait
  kill -INT $job
  wait $job
  code=$?
  [ $code = 130 ] || complain "exit code $code"
  [ -e out.exr ] && break
done
says 'awd: interrupted: only finished passes are written'
[ ! -s out ] || complain "output on stdout"
done=$("$tool" json s.json /passes | tr '}' '\n' | grep -c samples_per_pixel)
[ "$done" -gt 0 ] && [ "$done" -lt 100000 ] || complain "$done passes"
[ "$("$tool" json s.json /total/samples)" = $((done * 1024)) ] || complain "samples of $done passes"
"$tool" pixel out.exr 16 20 >/dev/null || complain "no image"

# In the middle of the first pass there is nothing to write. (Before it, the signal ends the
# program as usual.)
for wait in 1 4 16; do
  "$awd" render "$scenes/box.obj" -o none.exr --width 4096 --spp 200 >out 2>err &
  job=$!
  sleep $wait
  kill -INT $job
  wait $job
  code=$?
  [ $code = 130 ] || complain "exit code $code"
  [ -s err ] && break
done
says 'nothing is written'
absent none.exr
finish
