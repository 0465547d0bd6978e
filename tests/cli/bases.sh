# SPDX-License-Identifier: Apache-2.0
# awd bases: what can be used, and what was rejected and why.
source "$(dirname "$0")/harness.sh" "$@"

succeeds "$awd" bases --json
[ ! -s err ] || complain "words on stderr"
cp out bases.json
for key in name summary file order min_level max_level orthogonal periodic nested; do
  "$tool" json bases.json /bases/0/$key >/dev/null || complain "no $key"
done
at=$("$tool" json bases.json /bases | tr '{' '\n' | sed 1d | grep -n '"name":"haar"' | cut -d: -f1)
[ -n "$at" ] || complain "haar is not there"
haar=/bases/$((at - 1))
"$tool" json bases.json $haar/file | grep -q '^"/.*haar\.so"$' || complain "no absolute file"
[ "$("$tool" json bases.json $haar/order)" = 1 ] || complain "order of haar"
for flag in orthogonal nested; do
  [ "$("$tool" json bases.json $haar/$flag)" = true ] || complain "haar is $flag"
done
[ "$("$tool" json bases.json $haar/periodic)" = false ] || complain "haar is not periodic"
[ "$("$tool" json bases.json /rejected)" = "[]" ] || complain "something was rejected"

succeeds "$awd" bases
grep -q '^haar: ' out || complain "haar is not in the text"
grep -q '/haar\.so$' out || complain "no file in the text"

# A folder with a file that is no module, and one with a second haar; relative paths are made
# absolute.
mkdir broken second
echo 'not a module' >broken/spiral.so
cp "$(sed -n 's/^  \(\/.*haar\.so\)$/\1/p' out)" second/haar.so
succeeds "$awd" bases --json --basis-path broken --basis-path second
cp out bases.json
rejected=$("$tool" json bases.json /rejected)
for part in "$work/broken/spiral.so" '"result"' '"reason"'; do
  grep -qF "$part" <<<"$rejected" || complain "rejected without $part: $rejected"
done
[ "$("$tool" json bases.json $haar/file)" = "\"$work/second/haar.so\"" ] ||
  complain "--basis-path does not come first"
grep -q '"name":"haar"' <<<"$rejected" || complain "the other haar is not listed as rejected"
succeeds "$awd" bases --basis-path broken
grep -q "broken/spiral.so" out || complain "no rejected file in the text"

# An unknown basis says where it was looked for.
fails 1 "$work/second" "$awd" render "$scenes/box.obj" -o out.exr --basis spiral \
  --basis-path second
says '"spiral"'
succeeds "$awd" render "$scenes/box.obj" -o out.exr --width 4 --spp 1 --basis haar \
  --basis-path second
fails 1 'nowhere' "$awd" render "$scenes/box.obj" -o no.exr --width 4 --spp 1 --basis spiral \
  --basis-path nowhere
absent no.exr
finish
