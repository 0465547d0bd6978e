# SPDX-License-Identifier: Apache-2.0
# awd check-basis: every check with its figure, and an exit code. A fourth argument: the folder of
# lying plugins, with one that tells the truth.
source "$(dirname "$0")/harness.sh" "$@"
lying=$4

# The output with single spaces.
table() { sed 's/  */ /g; s/^ //' out; }

succeeds "$awd" check-basis "$lying/none.so"
[ ! -s err ] || complain "words on stderr"
grep -qx 'truthful' out || complain "no name of the family"
table | grep -qx 'check worst limit' || complain "no heading"
table | grep -qE '^partition of unity [0-9.e-]+ 1e-12 ok$' || complain "no partition of unity"
for check in table sizes values polynomial coefficients support weight two-scale samples \
  distribution gram; do
  table | grep -qE "^$check [0-9.e-]+ [0-9.e+-]+ ok$" || complain "no $check"
done
! grep -q FAILED out || complain "something failed"

# A path may be relative, and the name may be taken.
cp "$lying/none.so" truthful.so
succeeds env AWD_BASIS_PATH="$work" "$awd" check-basis truthful.so
succeeds "$awd" check-basis ./truthful.so

# A lie: the whole table, then the first failure as the reason of the exit code.
"$awd" check-basis "$lying/weight.so" >out 2>err
code=$?
[ $code = 1 ] || complain "exit code $code of a lie"
sentence="weight is not the integral: level 1, function 0: got 0.50005, want 0.5"
table | grep -qE '^weight 9.98e-05 1e-11 FAILED$' || complain "no figure of the lie"
table | grep -qxF "$sentence" || complain "no sentence in the table"
table | grep -qE '^gram .* ok$' || complain "checks after the failure are left out"
grep -qxF "awd: awdCheckBasisModule: \"$lying/weight.so\": basis \"liar\": $sentence" err ||
  complain "no sentence on stderr"

echo 'not a module' >text.so
fails 1 "\"$work/text.so\": can't be opened" "$awd" check-basis text.so
fails 1 'No such file' "$awd" check-basis missing.so
fails 1 'has no entry point awdBasisModule_v1' "$awd" check-basis "$lying/no_entry.so"
fails 1 'the module is of basis ABI 7' "$awd" check-basis "$lying/abi.so"
finish
