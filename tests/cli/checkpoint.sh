# SPDX-License-Identifier: Apache-2.0
# --checkpoint: a run that was interrupted goes on to the image of one that was not.
set -m # background jobs of a script would ignore SIGINT
source "$(dirname "$0")/harness.sh" "$@"
render="$awd render $scenes/box.obj --width 24 --samples 12"

silent $render -o whole.exr --save-field whole.field
silent $render -o saved.exr --save-field saved.field --checkpoint a
cmp -s saved.field whole.field || complain "another field"
# Through: nothing is left to do.
succeeds $render -o saved.exr --save-field again.field --checkpoint a --json s.json
says 'awd: going on from a, after 7 passes'
cmp -s again.field whole.field || complain "another field"
[ "$("$tool" json s.json /total/samples_per_pixel)" = 12 ] || complain "not 12 samples"
succeeds "$awd" compare saved.exr whole.exr --json
grep -q '"relmse": *0[.,0]*[^.0-9]' out || complain "another image"

# Interrupted by Ctrl-C after a pass or more, then in the schedule's middle.
for wait in 1 4 16 64; do
  rm -f b
  "$awd" render "$scenes/box.obj" --width 24 --spp 1 --passes 100000 -o part.exr --checkpoint b \
    >out 2>err &
  job=$!
  sleep $wait
  kill -INT $job
  wait $job
  [ -e b ] && break
done
says 'interrupted: only finished passes are written'
succeeds "$awd" png part.exr part.png
fails 1 'had 1 samples' "$awd" render "$scenes/box.obj" --width 24 --spp 2 --passes 100000 \
  -o part.exr --checkpoint b

# Other options, another scene, a file that is none.
fails 1 'desc->camera' $render --height 25 -o no.exr --checkpoint a
fails 1 'desc->seed' $render --seed 2 -o no.exr --checkpoint a
fails 1 'its basis' $render --basis haar -o no.exr --checkpoint a
fails 1 'desc->guide' $render --guide cosine -o no.exr --checkpoint a
fails 1 'schedule->resume' "$awd" render "$scenes/box.obj" --width 24 --samples 13 -o no.exr \
  --checkpoint a
head -c 500 a >damaged
fails 1 'can'"'"'t load "damaged"' $render -o no.exr --checkpoint damaged
fails 1 'none/c' $render -o no.exr --checkpoint none/c
absent no.exr
finish
