# SPDX-License-Identifier: Apache-2.0
# A small render in each mode: image, statistics, metadata, and silence.
source "$(dirname "$0")/harness.sh" "$@"

for guide in uniform cosine adaptive; do
  silent "$awd" render "$scenes/box.obj" -o $guide.exr --guide $guide --passes 3 --spp 2,2,4 \
    --seed 7 --threads 2 --json $guide.json
  for layer in R G B variance.R variance.G variance.B samples.Y; do
    "$tool" channels $guide.exr | grep -qx $layer || complain "$guide: no channel $layer"
  done
  [ "$("$tool" metadata $guide.exr scene)" = box.obj ] || complain "$guide: no scene in metadata"
  "$tool" metadata $guide.exr command | grep -q -- "--guide $guide --passes 3" ||
    complain "$guide: no command line in metadata"
  for part in passes/0 passes/1 passes/2 total; do
    for key in cpu_seconds wall_seconds rays shadow_rays samples samples_per_pixel coefficients \
      patches bytes rejected_samples; do
      "$tool" json $guide.json /$part/$key >/dev/null || complain "$guide: no /$part/$key"
    done
  done
  "$tool" json $guide.json /passes/3 >/dev/null && complain "$guide: more than 3 passes"
  [ "$("$tool" json $guide.json /settings/spp)" = "[2,2,4]" ] || complain "$guide: spp"
  [ "$("$tool" json $guide.json /settings/scene)" = '"box.obj"' ] || complain "$guide: scene"
  [ "$("$tool" json $guide.json /settings/guide)" = "\"$guide\"" ] || complain "$guide: guide"
  [ "$("$tool" json $guide.json /settings/preset)" = '"default"' ] || complain "$guide: preset"
  [ "$("$tool" json $guide.json /settings/seed)" = 7 ] || complain "$guide: seed"
  [ "$("$tool" json $guide.json /settings/width)" = 32 ] || complain "$guide: width"
  [ "$("$tool" json $guide.json /settings/height)" = 32 ] || complain "$guide: height"
  "$tool" json $guide.json /version >/dev/null || complain "$guide: version"
  # 32 x 32 pixels of 8 samples.
  [ "$("$tool" json $guide.json /total/samples)" = 8192 ] || complain "$guide: samples"
  [ "$("$tool" json $guide.json /passes/2/samples)" = 4096 ] || complain "$guide: last pass"
  [ "$("$tool" json $guide.json /total/rays)" -gt 8192 ] || complain "$guide: rays"
done
[ "$("$tool" json adaptive.json /settings/basis)" = '"linear-bspline"' ] || complain "basis"
[ "$("$tool" json cosine.json /settings/basis)" = null ] || complain "a basis without need"
[ "$("$tool" json adaptive.json /total/coefficients)" -gt 0 ] || complain "no coefficients"

# The same image is meant by all three. At 8 samples a pixel the mean over 1024 pixels has a
# standard error below 2 %; the seeds are fixed.
for guide in uniform cosine; do
  succeeds "$awd" compare $guide.exr adaptive.exr --json
  cp out compared.json
  for channel in 0 1 2; do
    a=$("$tool" json compared.json /mean_a/$channel)
    near "$a" "$("$tool" json compared.json /mean_ref/$channel)" "$(awk "BEGIN{print 0.1*$a}")"
  done
done

# The same bits for any number of threads; others for another seed, and for more shadow rays.
box() { silent "$awd" render "$scenes/box.obj" -o "$1" --spp 2 --passes 2 "${@:2}"; }
l1() { # A B
  succeeds "$awd" compare "$1" "$2" --json
  cp out compared.json
  "$tool" json compared.json /l1
}
box one.exr --threads 1
box two.exr --threads 2
[ "$(l1 one.exr two.exr)" = 0.0 ] || complain "the number of threads changes the image"
box seed.exr --seed 1
[ "$(l1 one.exr seed.exr)" != 0.0 ] || complain "the seed changes nothing"
box rays.exr --shadow-rays 4
[ "$(l1 one.exr rays.exr)" != 0.0 ] || complain "the number of shadow rays changes nothing"
box light.exr --direct none
[ "$(l1 one.exr light.exr)" != 0.0 ] || complain "the way in which light is found changes nothing"
box power.exr --lights power --max-split 1
fails 2 "--max-split" "$awd" render "$scenes/box.obj" -o s.exr --max-split 65
fails 2 "--lights" "$awd" render "$scenes/box.obj" -o s.exr --lights all

# Schedules: one number for all passes, a total, the paper's own; levels.
passes() { "$tool" json s.json /settings/spp; }
silent "$awd" render "$scenes/box.obj" -o s.exr --width 4 --passes 3 --spp 2 --json s.json
[ "$(passes)" = "[2,2,2]" ] || complain "one number for all: $(passes)"
[ "$("$tool" json s.json /settings/height)" = 4 ] || complain "the aspect ratio was not kept"
silent "$awd" render "$scenes/box.obj" -o s.exr --width 4 --samples 16 --json s.json
total=$(passes | tr -d '[]' | tr , '\n' | awk '{ s += $1 } END { print s }')
[ "$total" = 16 ] || complain "--samples 16 gave $(passes)"
# Time for a pass at most, however slow the machine, or for all that is asked.
silent "$awd" render "$scenes/box.obj" -o s.exr --width 4 --seconds 1e-9 --json s.json
[ "$(passes)" = "[1]" ] || complain "no time gave $(passes)"
silent "$awd" render "$scenes/box.obj" -o s.exr --width 4 --seconds 1e6 --samples 11 --json s.json
[ "$(passes)" = "[1,1,1,2,2,2,2]" ] || complain "--samples 11 and all time gave $(passes)"
silent "$awd" render "$scenes/box.obj" -o s.exr --width 4 --preset paper --json s.json
[ "$(passes)" = "[10,10,10,70]" ] || complain "the paper's schedule: $(passes)"
[ "$("$tool" json s.json /settings/preset)" = '"paper"' ] || complain "preset"
for level in 0 1 3; do
  silent "$awd" render "$scenes/box.obj" -o s.exr --width 4 --spp 4 --passes 5 --level $level \
    --preset paper --json s.json
  patches=$("$tool" json s.json /total/patches)
  [ "$("$tool" json s.json /total/coefficients)" -le $((patches << (2 * level))) ] ||
    complain "--level $level was exceeded"
done
silent "$awd" render "$scenes/box.obj" -o s.exr --width 4 --spp 1 --basis haar

# Other budgets: an error that is reached, and memory that is kept or said to be too little.
silent "$awd" render "$scenes/box.obj" -o s.exr --width 16 --error 0.2 --json s.json
awk "BEGIN{exit !($("$tool" json s.json /error/upper) <= 0.2)}" || complain "--error 0.2 was missed"
silent "$awd" render "$scenes/box.obj" -o s.exr --width 16 --quality draft --json s.json
[ "$("$tool" json s.json /settings/quality)" = '"draft"' ] || complain "quality"
awk "BEGIN{exit !($("$tool" json s.json /error/upper) <= 0.5)}" || complain "a draft was missed"
[ "$("$tool" json s.json /total/samples_per_pixel)" -le 1024 ] || complain "a draft took too much"
# Where there is no time for it, the image is written, and not called better than it is.
succeeds "$awd" render "$scenes/box.obj" -o s.exr --width 16 --quality reference --seconds 1e-6
says "warning: --quality reference is not reached: "
silent "$awd" render "$scenes/box.obj" -o s.exr --width 16 --memory 4 --samples 4 --json s.json
[ "$("$tool" json s.json /total/bytes)" -le 4194304 ] || complain "--memory 4 was exceeded"
fails 1 "bytes by itself" "$awd" render "$scenes/box.obj" -o s.exr --width 16 \
  --memory 0.01 --samples 4

# A field goes on where another render left it; a file that is none is refused.
silent "$awd" render "$scenes/box.obj" -o s.exr --width 16 --samples 16 --save-field f.awd
silent "$awd" render "$scenes/box.obj" -o a.exr --width 32 --samples 4 --field f.awd
silent "$awd" render "$scenes/box.obj" -o b.exr --width 32 --samples 4
[ "$(l1 a.exr b.exr)" != 0.0 ] || complain "what the field had learned changes nothing"
fails 1 "s.json" "$awd" render "$scenes/box.obj" -o s.exr --width 4 --spp 1 --field s.json
finish
