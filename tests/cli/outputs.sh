# SPDX-License-Identifier: Apache-2.0
# Results that can't be written: said before the work, or after it; never half a file.
source "$(dirname "$0")/harness.sh" "$@"
box=$scenes/box.obj
render="$awd render $box --width 8 --spp 1"

fails 1 'none/out.exr' $render -o none/out.exr
fails 1 'none/s.json' $render -o out.exr --json none/s.json
fails 1 'none/p.png' $render -o out.exr --pdf 0:none/p.png
absent out.exr
mkdir folder
fails 1 'not a regular file' $render -o folder
fails 1 'not a regular file' $render -o /dev/null
[ -c /dev/null ] || complain "/dev/null was replaced"
# Before the work: the scene is not even looked for.
fails 1 'none/out.exr' "$awd" render no-scene.obj -o none/out.exr

# A disk that is full, as a limit on the size of files.
full() { (trap '' XFSZ && ulimit -f 1 && "$@"); }
fails 1 'big.exr' full "$awd" render "$box" --width 64 --spp 1 -o big.exr
absent big.exr
fails 1 's.json' full "$awd" render "$box" --width 1 --height 1 --passes 9 --spp 1 -o small.exr \
  --json s.json
absent s.json
"$tool" make ramp.exr 4 4 0.1 0.7 0.3 || complain "no image to test with"
"$awd" render "$box" --width 64 --spp 1 -o noise.exr 2>/dev/null
fails 1 'noise.png' full "$awd" png noise.exr noise.png
absent noise.png

# An older file stays when the new one can't be written.
echo old >old.exr
fails 1 'old.exr' full "$awd" render "$box" --width 64 --spp 1 -o old.exr
[ "$(cat old.exr)" = old ] || complain "the older file is gone"
silent $render -o old.exr
succeeds "$tool" channels old.exr

# Names that are none, and names of one file.
fails 1 'no name of a file' "$awd" render "$box" -o ''
for option in --json --save-field --checkpoint; do
  fails 1 'no name of a file' "$awd" render "$box" -o out2.exr $option ''
done
cp "$box" scene.obj
cp "${box%.obj}.mtl" . 2>/dev/null
fails 2 'one file' "$awd" render scene.obj --width 8 --spp 1 -o scene.obj
cmp -s "$box" scene.obj || complain "the scene was written over"
echo old >there.exr
ln -s there.exr link.exr
fails 2 'one file' $render -o out3.exr --json ./out3.exr
fails 2 'one file' $render -o there.exr --checkpoint link.exr
[ "$(cat there.exr)" = old ] || complain "there.exr was written over"
fails 2 '--save-field and --checkpoint are one file' $render -o out3.exr --save-field c \
  --checkpoint ./c
absent out3.exr
echo old >target.json
ln -s target.json link.json
silent $render -o out4.exr --json link.json
[ -L link.json ] || complain "the link was replaced"
grep -q samples target.json || complain "nothing behind the link"

# One output that fails does not keep the others from being written.
little() { (trap '' XFSZ && ulimit -f 8 && "$@"); }
fails 1 'big2.exr' little "$awd" render "$box" --width 64 --spp 1 -o big2.exr --json big2.json
absent big2.exr
succeeds "$tool" json big2.json /total/samples
# Nor does a checkpoint: the film of the passes before is there.
fails 1 'only finished passes are written' little "$awd" render "$box" --width 8 --passes 200 \
  --spp 1 -o small2.exr --checkpoint c.ck
succeeds "$tool" channels small2.exr

for words in "bases" "bases --json" "compare ramp.exr ramp.exr" "--help"; do
  "$awd" $words >/dev/full 2>err && complain "$words to a full disk succeeds"
  says "can't write to standard output"
done
finish
