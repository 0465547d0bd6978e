# SPDX-License-Identifier: Apache-2.0
# Help, version, and every error that the command line itself can hold.
source "$(dirname "$0")/harness.sh" "$@"
box=$scenes/box.obj
small="--width 8 --height 8"

succeeds "$awd" --help
for subcommand in render png compare bases check-basis; do
  grep -q "^  $subcommand" out || complain "--help does not list $subcommand"
done
succeeds "$awd" render --help
for option in output camera width height guide basis level estimator refit-solver preset passes \
  spp samples quality seed threads shadow-rays json pdf basis-path; do
  grep -q -- "--$option" out || complain "render --help does not list --$option"
done
succeeds "$awd" --version
grep -qx 'awd [0-9]*\.[0-9]*\.[0-9]*' out || complain "no version"

fails 2 "say what to do" "$awd"
fails 2 "paint" "$awd" paint
fails 2 "SCENE" "$awd" render -o out.exr
fails 2 "--output" "$awd" render "$box"
fails 2 "--frobnicate" "$awd" render "$box" -o out.exr --frobnicate
fails 2 "extra.obj" "$awd" render "$box" extra.obj -o out.exr
fails 2 "OUT" "$awd" png film.exr
fails 2 "REF" "$awd" compare a.exr
fails 2 "nonsense" "$awd" bases nonsense
fails 2 "FILE" "$awd" check-basis
fails 2 "more.so" "$awd" check-basis one.so more.so

render="$awd render $box -o out.exr $small"
fails 2 "--guide" $render --guide bsdf
fails 2 "--preset" $render --preset best
for value in 0 -1 65537 1.5 x; do
  fails 2 "--width" "$awd" render "$box" -o out.exr --width "$value"
  fails 2 "--height" "$awd" render "$box" -o out.exr --height "$value"
done
for value in -1 21 x; do fails 2 "--level" $render --level "$value"; done
for option in memory seconds error; do
  for value in 0 -1 nan inf x; do fails 2 "--$option" $render "--$option" "$value"; done
done
for value in -1 1.5 18446744073709551616 x; do fails 2 "--seed" $render --seed "$value"; done
fails 2 "--basis is of adaptive densities" $render --guide cosine --basis haar
fails 2 "--level is of adaptive densities" $render --guide cosine --level 3
fails 2 "--estimator is of adaptive densities" $render --guide uniform --estimator quasi
for value in 0 -1 x; do fails 2 "--passes" $render --spp 1 --passes "$value"; done
for value in 0 -1 4294967296 x; do fails 2 "--samples" $render --samples "$value"; done
for value in 0 -1 1025 x; do fails 2 "--shadow-rays" $render --shadow-rays "$value"; done
for value in -1 x; do
  fails 2 "--threads" $render --threads "$value"
  fails 2 "--seed" $render --seed "$value"
done
for value in 0 x 4,,4 4, 1.5 4294967296; do fails 2 "--spp" $render --spp "$value"; done

fails 2 "--spp 1,2,3 has 3 numbers for --passes 2" $render --spp 1,2,3 --passes 2
fails 2 "it can't be used with --spp" $render --spp 4 --samples 4
fails 2 "it can't be used with --passes" $render --passes 4 --samples 4
fails 2 "--passes needs --spp" $render --passes 4
fails 2 "it can't be used with --spp" $render --spp 4 --seconds 1
fails 2 "--seconds" $render --seconds 0
fails 2 "it can't be used with --spp" $render --spp 4 --error 0.1
fails 2 "it can't be used with --samples" $render --quality draft --samples 4
fails 2 "it can't be used with --error" $render --quality draft --error 0.1
for value in 1 best Draft; do fails 2 "--quality" $render --quality "$value"; done
for option in --error --memory; do fails 2 "$option" $render $option 0; done
fails 2 "none with --guide cosine" $render --spp 1 --guide cosine --save-field f.awd
fails 2 "it can't be used with --basis" $render --spp 1 --basis haar --field f.awd

fails 2 "--pdf x" $render --spp 1 --pdf x
fails 2 "--pdf 5" $render --spp 1 --pdf 5
fails 2 "none with --guide cosine" $render --spp 1 --guide cosine --pdf 0:p.png
fails 2 "none with --guide uniform" $render --spp 1 --guide uniform --pdf 0:p.png
fails 2 "the image has 8 x 8 pixels" $render --spp 1 --pdf 8,0:p.png
fails 2 "the scene has no such patch" $render --spp 1 --preset paper --pdf 1000000:p.png

fails 1 '"spiral"' $render --spp 1 --basis spiral
for value in 1e5 x nan; do fails 2 "--exposure" "$awd" png a.exr b.png --exposure "$value"; done

absent out.exr
absent p.png
finish
