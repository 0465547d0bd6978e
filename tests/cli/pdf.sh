# SPDX-License-Identifier: Apache-2.0
# --pdf: pictures of patches, by number, by side, by pixel.
source "$(dirname "$0")/harness.sh" "$@"
render() { "$awd" render "$scenes/box.obj" -o out.exr --width 16 --spp 4 --passes 2 "$@"; }
paper() { render --preset paper "$@"; } # with the scene's patches

# A PNG begins with its name, and its size lies at bytes 16 to 23.
is_picture() { # FILE
  [ "$(head -c 4 "$1" | tail -c 3)" = PNG ] || complain "$1 is no PNG"
  [ "$(od -An -tu1 -j16 -N8 "$1" | tr -s ' ')" = " 0 0 1 0 0 0 1 0" ] || complain "$1: not 256 x 256"
}

succeeds paper --pdf 0:number.png --pdf 0b:back.png --pdf 8,12:pixel.png
for name in number back pixel; do is_picture $name.png; done
[ ! -s out ] || complain "output on stdout"
says 'number.png: patch 0, front side'
says 'back.png: patch 0, back side, which has learned nothing'
grep -q 'pixel.png: patch [0-9]*, front side$' err || complain "the floor has learned nothing"
cmp -s back.png pixel.png && complain "what was learned does not show"

# Of patches that the library makes: the one under a pixel, as it is after the last pass.
succeeds render --pdf 8,12:made.png
is_picture made.png
grep -q 'made.png: patch [0-9]*$' err || complain "the floor has learned nothing"
cmp -s made.png back.png && complain "what was learned does not show"

# Pixels that see nothing
sed 's/3.5/-3.5/' "$scenes/box.camera.json" >away.json
fails 2 'nothing is seen in that pixel' "$awd" render "$scenes/box.obj" -o no.exr --spp 1 \
  --camera away.json --pdf 5,5:no.png
absent no.exr
absent no.png

# A screen that is lit and seen from behind alone, by light from the floor: a plain number finds
# the side that has learned.
cp "$scenes/box.mtl" .
cat >screen.obj <<'EOF'
mtllib box.mtl
v -2 -2 0
v 2 -2 0
v 2 2 0
v -2 2 0
v -2 -2 -8
v 2 -2 -8
v -2 4 -6
v 2 4 -6
v 2 4 -2
v -2 4 -2
usemtl white
f 1 2 3 4
f 1 2 6 5
usemtl lamp
f 7 8 9 10
EOF
sed 's/0, 0, 3.5/0, 0, -5/; s/\[0, 0, -1\]/[0, 0, 1]/' "$scenes/box.camera.json" >behind.json
screen() { "$awd" render screen.obj --preset paper -o out.exr --camera behind.json --spp 4 --passes 2 "$@"; }
succeeds screen --pdf 16,16:pixel.png
patch=$(sed -n 's/.*pixel.png: patch \([0-9]*\), back side$/\1/p' err)
[ -n "$patch" ] || complain "the pixel does not show a back side that has learned"
succeeds screen --pdf "$patch:number.png" --pdf "${patch}b:back.png"
says "number.png: patch $patch, back side"
cmp -s number.png pixel.png && cmp -s number.png back.png || complain "not the same picture"
finish
