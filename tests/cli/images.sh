# SPDX-License-Identifier: Apache-2.0
# awd compare and awd png.
source "$(dirname "$0")/harness.sh" "$@"

# Two pixels, as in metrics_test: reference 1 and 3, floor 0.04.
"$tool" make ref.exr 2 1 1 1 1 3 3 3
"$tool" make a.exr 2 1 2 1 1 3 3 1
succeeds "$awd" compare a.exr ref.exr --json
[ ! -s err ] || complain "words on stderr"
cp out c.json
near "$("$tool" json c.json /l1)" 0.5 1e-12
near "$("$tool" json c.json /relmse)" "$(awk 'BEGIN { print (1/3/1.04 + 4/3/9.04) / 2 }')" 1e-6
near "$("$tool" json c.json /relmse_trimmed)" "$("$tool" json c.json /relmse)" 0
[ "$("$tool" json c.json /mean_a)" = "[2.5,2.0,1.0]" ] || complain "mean_a"
[ "$("$tool" json c.json /mean_ref)" = "[2.0,2.0,2.0]" ] || complain "mean_ref"
[ "$(grep -c '^  "' c.json)" = 5 ] || complain "other keys than the five"
succeeds "$awd" compare a.exr ref.exr
grep -q '^L1 *0.5$' out || complain "no L1 in the text"

# Sizes
"$tool" make large.exr 8 4 1 1 1
succeeds "$awd" compare large.exr ref.exr --json
says 'large.exr is averaged over 4 x 4 pixels'
succeeds "$awd" compare ref.exr large.exr --json
says 'large.exr is averaged over 4 x 4 pixels'
cp out c.json
near "$("$tool" json c.json /l1)" 1 1e-12
"$tool" make odd.exr 3 1 1 1 1
fails 1 'odd.exr has 3 x 1 pixels but ref.exr has 2 x 1 pixels' "$awd" compare odd.exr ref.exr

# Pixels and channels that can't be compared
"$tool" make nan.exr 4 4 1 1 1 nan 1 inf
fails 1 'nan.exr: 8 of 16 pixels are NaN or infinite' "$awd" compare nan.exr ref.exr
fails 1 'nan.exr: 8 of 16 pixels' "$awd" compare ref.exr nan.exr
"$tool" make black.exr 2 1 0
succeeds "$awd" compare ref.exr black.exr --json
says 'black.exr is black: there is no relative error'
cp out c.json
[ "$("$tool" json c.json /relmse)" = null ] || complain "relmse against black"
near "$("$tool" json c.json /l1)" 2 1e-12

# Files that are missing, truncated, or something else
fails 1 'none.exr' "$awd" compare none.exr ref.exr
fails 1 'none.exr' "$awd" compare ref.exr none.exr
fails 1 'none.exr' "$awd" png none.exr out.png
size=$(stat -c %s large.exr)
for part in 0 3 100 $((size / 2)) $((size - 1)); do
  head -c "$part" large.exr >cut.exr
  fails 1 'cut.exr' "$awd" compare cut.exr ref.exr
  fails 1 'cut.exr' "$awd" png cut.exr out.png
done
fails 1 'box.obj' "$awd" compare "$scenes/box.obj" ref.exr
absent out.png

# PNG: a stop less is half the value.
fails 1 'none/out.png' "$awd" png ref.exr none/out.png
"$tool" make grey.exr 2 2 0.5
silent "$awd" png grey.exr grey.png
silent "$awd" png grey.exr darker.png --exposure -1
[ "$(head -c 4 grey.png | tail -c 3)" = PNG ] || complain "no PNG"
cmp -s grey.png darker.png && complain "--exposure changes nothing"
"$tool" make quarter.exr 2 2 0.25
silent "$awd" png quarter.exr quarter.png
cmp -s quarter.png darker.png || complain "--exposure -1 is not half as bright"
finish
