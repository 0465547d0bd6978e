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

for words in "bases" "bases --json" "compare ramp.exr ramp.exr" "--help"; do
  "$awd" $words >/dev/full 2>err && complain "$words to a full disk succeeds"
  says "can't write to standard output"
done
finish
