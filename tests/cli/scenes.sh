# SPDX-License-Identifier: Apache-2.0
# Scene and camera files that are missing, malformed or odd: messages and outcomes.
source "$(dirname "$0")/harness.sh" "$@"
cp "$scenes"/box.* .
render() { "$awd" render "$1" -o out.exr --width 8 --height 8 --spp 1 "${@:2}"; }

fails 1 '"none.obj"' render none.obj
fails 1 'box.mtl: scenes are read from' render box.mtl

# OBJ
quad='v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n'
bad() { # TEXT CONTENT
  printf "$2" >bad.obj
  fails 1 "$1" render bad.obj --camera box.camera.json
}
bad 'bad.obj' ''
bad 'bad.obj: has no triangles' 'garbage \001\002\377\nand more of it\n'
bad 'bad.obj: has no triangles' "$quad"
bad 'bad.obj:5: face of 2 vertices' "${quad}f 1 2\n"
bad 'bad.obj:5: face of 1 vertex' "${quad}f 1\n"
bad 'bad.obj:5: face uses vertex 5 of 4' "${quad}f 1 2 5\n"
bad 'bad.obj:5: face uses vertex -5' "${quad}f 1 2 -5\n"
bad 'bad.obj:1: vertex has "nan"' "v nan 0 0\n${quad}f 1 2 3\n"
bad 'bad.obj:1: vertex has "1e39"' "v 1e39 0 0\n${quad}f 1 2 3\n"
for colour in '1.5 0 0' '-0.5 0 0'; do
  printf 'newmtl glow\nKd %s\n' "$colour" >bad.mtl
  bad 'bad.obj: material "glow"' "mtllib bad.mtl\n${quad}usemtl glow\nf 1 2 3\n"
done
printf 'newmtl glow\nKd 0 0 0\nKe -1 0 0\n' >bad.mtl
bad 'bad.obj: material "glow"' "mtllib bad.mtl\n${quad}usemtl glow\nf 1 2 3\n"
printf 'newmtl glow\nKd 0 0 nan\n' >bad.mtl
bad 'bad.mtl:2: Kd of material "glow" has "nan"' "mtllib bad.mtl\n${quad}usemtl glow\nf 1 2 3\n"
absent out.exr

printf "mtllib none.mtl\n${quad}usemtl foo\nf 1 2 3 4\nl 1 2\n" >odd.obj
succeeds render odd.obj
says 'awd: warning: odd.obj: can'\''t read material library "none.mtl"'
says 'awd: warning: odd.obj: material "foo" is not defined'
says 'points and lines are ignored'
says 'a view of the whole scene is taken'
says 'light' # the library's warning that there is none
[ "$("$tool" pixel out.exr 4 4)" = "0 0 0" ] || complain "the image without a light is not black"

# glTF
printf '{"asset": {"version": "2.0"' >broken.gltf
fails 1 'broken.gltf: is no glTF file' render broken.gltf
head -c 10 "$scenes/lamp.gltf" >cut.gltf
fails 1 'cut.gltf: is no glTF file' render cut.gltf
printf 'glTF\002\000\000\000\100' >cut.glb
fails 1 'cut.glb: is truncated' render cut.glb
sed 's|"data:[^"]*"|"none.bin"|' "$scenes/lamp.gltf" >nobuffer.gltf
fails 1 'none.bin' render nobuffer.gltf
says 'nobuffer.gltf'

# Camera files
camera() { # TEXT SED-SCRIPT
  sed "$2" box.camera.json >bad.json
  fails 1 "bad.json: $1" render box.obj --camera bad.json
}
rm -f out.exr
fails 1 '"none.json"' render box.obj --camera none.json
camera 'is no JSON' 's/{//'
camera 'is no JSON' 's/3.5/NaN/'
for key in eye look_dir up tan_half_fov_x width height; do
  camera "\"$key\" is missing" "/\"$key\"/d"
done
camera '"eye" must be an array of 3 numbers' 's/\[0, 0, 3.5\]/"here"/'
camera '"eye" is too large' 's/3.5/1e39/'
camera '"look_dir" is zero' 's/\[0, 0, -1\]/[0, 0, 0]/'
camera '"up" is parallel to look_dir' 's/\[0, 1, 0\]/[0, 0, 1]/'
camera '"tan_half_fov_x" must be above 0' 's/0.4/-0.4/'
camera '"width" must be a whole number' 's/"width": 32/"width": "32"/'
# The file beside the scene is no less checked.
cp bad.json box.camera.json
fails 1 'box.camera.json: "width"' render box.obj
absent out.exr
finish
