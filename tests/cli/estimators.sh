# SPDX-License-Identifier: Apache-2.0
# How adaptive densities learn: each estimator by name, and the refit module if this build has it
# (fourth argument 1).
source "$(dirname "$0")/harness.sh" "$@"
unset AWD_REFIT_PATH
box=$scenes/box.obj
plain="--spp 4 --passes 3 --seed 3"
small="$plain --basis linear-bspline"

setting() { "$tool" json s.json "/settings/$1"; }
for estimator in paper mixture ratio quasi lumped; do
  silent "$awd" render "$box" -o $estimator.exr $small --estimator $estimator --json s.json
  [ "$(setting estimator)" = "\"$estimator\"" ] || complain "$estimator: $(setting estimator)"
  [ "$(setting refit_solver)" = null ] || complain "$estimator: $(setting refit_solver)"
  "$tool" json s.json /refit >/dev/null && complain "$estimator: a refit"
  [ "$("$tool" metadata $estimator.exr awd.estimator)" = $estimator ] || complain "$estimator"
done
silent "$awd" render "$box" -o default.exr $small --json s.json
[ "$(setting estimator)" = '"default"' ] || complain "default: $(setting estimator)"
silent "$awd" render "$box" -o cosine.exr $plain --guide cosine --json s.json
[ "$(setting estimator)" = null ] || complain "cosine: $(setting estimator)"

l1() { # A B
  succeeds "$awd" compare "$1" "$2" --json
  cp out compared.json
  "$tool" json compared.json /l1
}
[ "$(l1 default.exr lumped.exr)" = 0.0 ] || complain "the default is not lumped"
for estimator in mixture ratio quasi lumped; do
  [ "$(l1 $estimator.exr paper.exr)" != 0.0 ] || complain "$estimator is no other than paper"
done

refit="$awd render $box -o refit.exr $small --estimator refit"
if [ "$4" = 1 ]; then
  for solver in descent ceres; do
    silent $refit --refit-solver $solver --json s.json
    [ "$(setting estimator)" = '"refit"' ] || complain "$solver: $(setting estimator)"
    [ "$(setting refit_solver)" = "\"$solver\"" ] || complain "$solver: $(setting refit_solver)"
    [ "$("$tool" json s.json /refit/failed)" = 0 ] || complain "$solver: failed"
    [ "$("$tool" json s.json /refit/limited)" = 0 ] || complain "$solver: limited"
    [ "$("$tool" json s.json /refit/iterations)" -gt 0 ] || complain "$solver: no iterations"
  done
  # The same image is meant: 12 samples a pixel of 1024 leave a standard error below 2 %.
  succeeds "$awd" compare refit.exr paper.exr --json
  cp out compared.json
  a=$("$tool" json compared.json /mean_a/0)
  near "$a" "$("$tool" json compared.json /mean_ref/0)" "$(awk "BEGIN{print 0.1*$a}")"
  silent $refit --threads 1
  mv refit.exr one.exr
  silent $refit --threads 2
  [ "$(l1 one.exr refit.exr)" = 0.0 ] || complain "the number of threads changes the image"
  fails 1 '"simplex"' $refit --refit-solver simplex
else
  fails 1 "the estimator refit wants the refit module" $refit
fi

fails 2 "--estimator" "$awd" render "$box" -o x.exr $small --estimator best
fails 2 "--refit-solver needs --estimator refit" "$awd" render "$box" -o x.exr $small \
  --refit-solver ceres
absent x.exr
finish
