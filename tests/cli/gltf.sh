# SPDX-License-Identifier: Apache-2.0
# glTF: camera, and emission with the strength that Assimp drops.
source "$(dirname "$0")/harness.sh" "$@"

# The file's camera sees nothing but the lamp, which is black but for its light.
silent "$awd" render "$scenes/lamp.gltf" -o lamp.exr --width 8 --spp 1
for place in "0 0" "7 0" "0 7" "7 7" "4 4"; do
  [ "$("$tool" pixel lamp.exr $place)" = "16 8 4" ] ||
    complain "pixel $place is $("$tool" pixel lamp.exr $place)"
done

# What the lamp sheds on the floor is in proportion: with the same seed, exactly.
sed 's/"emissiveStrength": 16/"emissiveStrength": 1/' "$scenes/lamp.gltf" >faint.gltf
floor="--camera $scenes/floor.camera.json --spp 4 --guide cosine"
silent "$awd" render "$scenes/lamp.gltf" -o bright.exr $floor
silent "$awd" render faint.gltf -o faint.exr $floor
succeeds "$awd" compare bright.exr faint.exr --json
cp out compared.json
for channel in 0 1 2; do
  faint=$("$tool" json compared.json /mean_ref/$channel)
  [ "$(awk "BEGIN { print ($faint > 0.01) }")" = 1 ] || complain "the floor is dark"
  near "$("$tool" json compared.json /mean_a/$channel)" "$(awk "BEGIN { print 16 * $faint }")" 1e-4
done
finish
